// The grid that a quantity is computed on, and how much one step of it weighs in a margin.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"

namespace rtac::ir {

struct Unit {
  sema::Dimension dimension;
  Rational step;   // SI units in one step of the grid
  Rational scale;  // SI units that margins of this dimension are compared in

  Unit() = default;
  Unit(const sema::Dimension& d, Rational step_si, Rational scale_si)
      : dimension(d), step(std::move(step_si)), scale(std::move(scale_si)) {}
  Unit(const Unit&) = default;
  Unit& operator=(const Unit&) = default;
  // values are moved when a list grows: they cannot be copied
  Unit(Unit&&) noexcept = default;
  Unit& operator=(Unit&&) noexcept = default;
  ~Unit() = default;

  // Millionths of the scale in one step: what a step weighs in a margin.
  [[nodiscard]] Rational weight() const { return step / scale * 1'000'000; }
  // Margins count millionths of the scale: a finer grid would be lost in them.
  [[nodiscard]] bool is_fine_enough() const { return weight() >= 1; }
  friend bool operator==(const Unit&, const Unit&) = default;

  // of decisions: lengths, charge, numbers of robots, speeds
  static const Unit mm, ppm, robots, mmps;
};

// "mm", "ppm", "1/1000 m/s", "1".
std::string name(const Unit& unit);

// Largest step that divides both: what lies on either grid lies on it. Both are positive.
Rational common_step(const Rational& a, const Rational& b);

// The scale of a dimension when the specification states none: 1 SI unit, 1 % of ratios.
Rational default_scale(const sema::Dimension& dimension);

}  // namespace rtac::ir
