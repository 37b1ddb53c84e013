// Comparisons once more as sums of what is measured, exactly. SI units.
#pragma once

#include <compare>
#include <map>
#include <optional>

#include "compiler/sema/spec.h"

namespace rtac::recheck {

struct Measured {
  enum class Kind { battery, clearance, energy_to, speed, altitude, distance };
  Kind kind;
  std::uint32_t index;  // of the zone or site; else 0
  auto operator<=>(const Measured&) const = default;
};
// What is measured, each times its number, and the least that the rest of it is, whatever its
// parameters become.
struct Sum {
  std::map<Measured, Rational> terms;
  Rational least;
  bool params = false;
};

// `large` - `small`; nullopt: it is no such sum.
std::optional<Sum> difference(const sema::Spec& spec, const sema::Expr& large,
                              const sema::Expr& small);

// What a comparison asks to be 0 or more, or above it; nullopt: it is no such sum.
std::optional<Sum> excess(const sema::Spec& spec, const sema::Expr& comparison);
// What a comparison that has to be true, or false, asks of one thing that is measured: at least so
// much, or at most, whatever its parameters become. none: it asks for something else.
struct LimitOfOne {
  Measured of;
  bool at_least;
  Rational bound;
  bool strict;
};
std::optional<LimitOfOne> limit_of_one(const sema::Spec& spec, const sema::Expr& comparison,
                                       bool value = true);
// The distance to another robot that a comparison which has to be true, or false, asks for at
// least, whatever its parameters become; none: it asks for something else.
std::optional<Rational> least_distance(const sema::Spec& spec, const sema::Expr& comparison,
                                       bool value = true);

// What a comparison that has to be true, or false, asks of the clearance of one zone, from below:
// the most that its parameters may make of that, and the least. none: it asks for something else.
struct Floor {
  sema::ZoneId zone;
  Rational strictest, laxest;
};
std::optional<Floor> floor_of(const sema::Spec& spec, const sema::Expr& comparison,
                              bool value = true);

}  // namespace rtac::recheck
