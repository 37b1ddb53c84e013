// What the reference finds of formulas before they are compared: whether they are true, false and
// unknown at times, and of quantities, the limits with which they are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/differential/operators.h"

namespace rtac::differential {

struct Formula {
  std::string text;
  Type type;
};
// Something of it that is true or false, or can be compared with a limit.
Formula measured(const Formula& f);

struct Probed {
  std::string condition;   // the formula, compared with a limit if it is a quantity
  std::size_t rarest = 0;  // how often the rarest verdict occurs
};

// The random runs that everything is found on.
struct Scope {
  std::uint32_t seed;
  std::size_t runs, steps;
};
std::string monitor_line(std::size_t k, const std::string& condition);
// Speaks of every signal of every robot, so that specifications that begin with it have the same
// inputs, and the same runs.
std::string monitor_of_robots();
// `problem` says why the compiler refuses one of them.
std::vector<Probed> probe(const std::vector<Formula>& formulas, const Scope& scope,
                          std::string& problem);

}  // namespace rtac::differential
