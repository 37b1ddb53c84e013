// Random specifications: a fixed page of inputs of every kind, and monitors whose formulas use all
// of the language.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::differential {

// In millionths of the SI unit, so that everything is written exactly.
using Micro = std::int64_t;
std::string decimal(Micro value);

struct Signal {
  enum class Kind { truth, choice, whole, quantity };
  std::string name;
  std::string type;
  Kind kind;
  std::size_t components;
  Micro least, most;  // `has_range`; else what traces use
  bool has_range;
  std::string unit;
  Micro resolution, error;
  std::string age;           // the clause, or nothing
  std::string turning = {};  // of a pose: the unit of its heading, which has the same limits
};
// Those that are declared.
const std::vector<Signal>& signals();
// All inputs of a specification of these declarations, with what its monitors say of robots.
std::vector<Signal> signals_of(const sema::Spec& spec);

// `variant`: of the scales and grids.
std::string declarations(std::uint32_t variant = 0);
inline constexpr std::int64_t period_us = 1000000;

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {}
  // One line: the monitor `mK`, and a parameter of its own if it has one.
  std::string monitor(std::size_t k);

 private:
  enum class Sort { number, whole, length, heat, share, speed, time };
  std::size_t below(std::size_t count) { return random_() % count; }
  template <class List>
  std::string one_of(const List& list) {
    return list[below(list.size())];
  }
  std::string window(bool may_be_endless);
  std::string duration();
  std::string constant(Sort sort);
  std::string condition(int depth);
  std::string atom();
  std::string comparison(int depth);
  std::string quantity(Sort sort, int depth);
  std::string leaf(Sort sort);
  std::string number(int depth);
  std::string length(int depth);
  std::string place();  // what is said of points, vectors and poses
  std::string robot();
  // Binds a robot in what `body` gives; `head` ends before its name.
  template <class Body>
  std::string over_fleet(const std::string& head, const std::string& separator, const Body& body);
  std::string common(Sort sort, int depth);

  std::mt19937 random_;
  std::size_t k_ = 0;
  bool has_param_ = false;
  std::size_t names_ = 0;  // of `let`, and of bound robots
  std::string bound_;      // the robot of the quantifier around; empty: none
};

}  // namespace rtac::differential
