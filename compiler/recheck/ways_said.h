// What a claim says of the ways of a recovery in the plane, and whether that is so. In m.
#pragma once

#include <optional>
#include <vector>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

struct Said {
  sema::ZoneId zone;
  Cells cells;
  Rational starts, route, back, aim;
  std::optional<Rational> exact;  // none: the tables are exact all over
};
std::optional<Said> said_of(Claims& claims, const Values& v);

// How much more than its body takes a robot has of the boundary of a zone wherever the recovery of
// `driving` takes over: as all that it drives for ask for, or one that is relied on.
Rational starts_off(const sema::Spec& spec, const sema::Decision& d, const sema::Monitor& driving,
                    sema::ZoneId zone);
// Where a route leads, each robot to its own.
std::vector<geometry::Point> sites_of(const sema::Spec& spec, const sema::Template& last);
// The longest way over cells. nullopt: nothing bounds it.
std::optional<Rational> longest(const geometry::Region& zone, const Said& said,
                                const std::vector<geometry::Point>& sites,
                                const sema::Template& last);
// From everywhere it takes a leg that is no longer, and searches for no way: one in sight to where
// it aims at first, no longer than twice that clearance (which it takes to the millimetre).
bool takes_legs(const geometry::Region& zone, const Said& said, const sema::RobotKind& kind,
                const sema::Template& last, const Rational& leg);
// What one aims at, from where control is given back on.
std::vector<Rational> aims_of(const Said& said, const sema::Template& last);

// Who may be seen with less than its body takes, as its property keeps no more than `keeps` beyond
// that, is led in first: at most so far to where ways begin, or else all the way. Both 0: nobody
// may; nullopt: it may be seen off the zone, from where nothing bounds a leg.
struct Led {
  Rational first, all;
  std::vector<double> from{};  // by cell: the longer one; empty: nobody may
};
std::optional<Led> led_in(const geometry::Region& zone, const Said& said,
                          const sema::RobotKind& kind, const sema::Template& last,
                          const Rational& keeps);

}  // namespace rtac::recheck
