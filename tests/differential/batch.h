// Many monitors in one specification, on one run: what the reference finds, and whether a kernel
// finds no more than that, and no less than the bound that the compiler derives for its rounding.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "compiler/ir/rounding.h"
#include "tests/differential/choices.h"
#include "tests/differential/engines.h"
#include "tests/differential/generator.h"
#include "tests/differential/traces.h"

namespace rtac::differential {

class Batch {
 public:
  // `count` random monitors and the given ones, each a line, on `runs` runs of `steps` each. A
  // monitor that the compiler refuses is left out.
  Batch(std::uint32_t seed, std::size_t count, std::size_t steps,
        const std::vector<std::string>& given = {}, std::size_t runs = 1);
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] const std::string& refused() const { return refused_; }
  [[nodiscard]] std::size_t size() const { return monitors_.size(); }
  // Those that the compiler takes, each a line.
  [[nodiscard]] const std::vector<std::string>& monitors() const { return monitors_; }
  // What the reference finds, one character a step.
  [[nodiscard]] std::string verdicts(std::size_t monitor) const;
  [[nodiscard]] const Troubles& troubles() const { return troubles_; }
  [[nodiscard]] const driver::KernelCode& code() const { return code_; }

  struct Result {
    std::size_t different = 0;                 // monitors
    std::string first;                         // of them, with everything to repeat it
    std::size_t yes = 0, no = 0, unknown = 0;  // verdicts that were compared
    std::size_t margins = 0;                   // finite ends that were compared
    std::size_t rounded = 0;                   // of them, those that differ
    // Monitors whose bound was reached by half at least: it is no more than twice what it has to
    // be.
    std::size_t sharp = 0;
  };
  [[nodiscard]] Result compare(driver::Engine& kernel) const;
  // Where two kernels first differ; empty: nowhere.
  [[nodiscard]] std::string disagreement(driver::Engine& one, driver::Engine& other) const;

 private:
  [[nodiscard]] std::string specification() const;
  void remove_refused();
  // What is wrong with a finding; empty: nothing.
  [[nodiscard]] std::string fault(std::size_t k, std::size_t step, const Finding& found) const;
  [[nodiscard]] std::string looseness(std::size_t k, std::size_t step, const Finding& found) const;
  void count(std::size_t k, const Finding& exact, const Finding& found, Result& result,
             bool& is_sharp) const;
  [[nodiscard]] std::string described(std::size_t k, std::size_t step, const std::string& fault,
                                      const std::vector<Finding>& found) const;

  std::uint32_t variant_;  // of the declarations
  std::vector<std::string> monitors_;
  std::vector<ir::Rounding> bounds_;  // by monitor
  Findings reference_;
  std::unique_ptr<OpenedChoices> choices_;
  Findings opened_;  // with choices that the kernel may leave open
  std::vector<Signal> signals_;
  std::string refused_, problem_;
  driver::KernelCode code_;
  Steps run_;
  Troubles troubles_;
};

}  // namespace rtac::differential
