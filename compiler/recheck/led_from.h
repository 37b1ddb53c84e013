// How far a retreat of the plane leads from where it sets out, once more. In m.
#pragma once

#include <variant>
#include <vector>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/grid.h"

namespace rtac::recheck {

struct LedFrom {
  const sema::Monitor* driving;
  sema::ZoneId zone;
  const geometry::Region* region;
  Grid grid;
  std::vector<double> from;  // by cell: from any place of it no way is longer; negative: it stays
  double aims;               // how clear its ways lead to
  Rational strays;           // how much farther than the places of its way the robot may be
};
// What a claim says of the recovery of its `monitor`, which is a retreat of a robot that is alone,
// and keeps `standoff` from the boundary of its zone on its ways. Otherwise why that is not so.
std::variant<LedFrom, Doubt> led_from(const sema::Spec& spec, const sema::Decision& decision,
                                      Claims& claims, const Values& v, const Rational& standoff);

}  // namespace rtac::recheck
