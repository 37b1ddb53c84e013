// Two engines of one specification, text to verdicts: the reference interpreter and the generated
// kernel, which share nothing behind the checked specification.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "compiler/driver/compile.h"
#include "compiler/driver/engine.h"
#include "compiler/driver/replay.h"

namespace rtac::differential {

struct Checked {
  driver::Compilation compilation;
  std::string problem;            // every diagnostic; empty: none
  std::set<std::uint32_t> lines;  // of the text, that errors are about; 1-based
};
enum class Until { checked, kernel };
std::unique_ptr<Checked> check(const std::string& text, Until until);

// Alters the text of the generated kernel before it is compiled.
using Edit = std::function<std::string(const std::string&)>;
// A kernel that takes few steps is not worth optimising: compiling it takes most of the time.
enum class Speed { of_steps, of_building };
driver::LoadedKernel load(const driver::KernelCode& code, const Edit& edit = {},
                          Speed speed = Speed::of_steps);
// The verdicts of the step are replaced by those of the entry that tells nothing else.
driver::LoadedKernel load_verdicts(const driver::KernelCode& code, const Edit& edit = {},
                                   Speed speed = Speed::of_steps);

// One call of `step`, and what the application sets before it.
struct ParamChange {
  std::size_t param;
  Rational value;  // SI
};
struct Step {
  std::int64_t now_us = 0;
  std::vector<driver::Observed> inputs;
  std::vector<ParamChange> params{};
  bool is_restart = false;  // a new run begins
};
using Steps = std::vector<Step>;
// A second step within a tick judges nothing.
bool is_repeated(const Steps& run, std::size_t step);

// Per monitor one character a step: 1, 0, or ?.
std::vector<std::string> judge(driver::Engine& engine, const Steps& run);

// The same with margins, in millionths of the scale of the atom that decides: what margins of
// different atoms are compared in.
struct Finding {
  char verdict;
  interp::Extended lo, hi;
  std::string unit;
};
using Findings = std::vector<std::vector<Finding>>;  // by monitor and step
Findings find(driver::Engine& engine, const driver::KernelInterface& kernel, const Steps& run);

}  // namespace rtac::differential
