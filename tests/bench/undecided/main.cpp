// Stands in for `rtac-sim` ($RTAC_SIM): the same robots, senses and attacks, and a decision that
// looks at nothing and lets every command pass. What runs cost beyond these is the decision and
// what it engages. Violations do not end a run, so that each takes its whole duration.
#include <fstream>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <string>

#include "run.h"

namespace {

using namespace rtac::simulate;

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

Problem play(std::map<std::string, std::string>& flags) {
  Case all;
  if (Problem p = read_manifest(text_of(flags["--manifest"]), all)) return p;
  Kernel kernel;
  if (Problem p = kernel.load(flags["--kernel"])) return p;
  Scenario scenario;
  if (Problem p = read_scenario(text_of(flags["--scenario"]), scenario)) return p;
  for (const DecisionCase& decision : all.decisions) {
    Kernel::Functions functions;
    if (Problem p = kernel.find(decision, functions)) return p;
    functions.step = [](void*, const std::int64_t*, std::int64_t, std::int64_t*) {};
    for (std::uint64_t runs = std::stoull(flags["--runs"]), k = 0; k < runs; ++k) {
      Setup setup;
      if (Problem p = make_setup(decision, scenario, scenario.seed + k, setup)) return p;
      setup.return_within_us = std::numeric_limits<rtac::TimeUs>::max();
      rtac::sim::Tape none;
      Outcome outcome;
      if (Problem p = run(decision, functions, setup, none, outcome)) return p;
      if (outcome.duration_us < setup.duration_us || outcome.engagements > 0) {
        return {"run " + std::to_string(k) + " ended early, or something took over", ""};
      }
    }
  }
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  std::map<std::string, std::string> flags;
  for (int k = 1; k + 1 < argc; k += 2) flags[argv[k]] = argv[k + 1];
  const Problem problem = play(flags);
  if (problem) std::cerr << problem.message << "\n";
  return problem ? 2 : 0;
}
