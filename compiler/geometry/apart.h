// How far two zones are apart, exactly.
#pragma once

#include "compiler/geometry/solid.h"

namespace rtac::geometry {

// The square, in m^2, of the least distance between places of both, neither empty; 0 where they
// meet, be it in a point.
Rational square_apart(const Region& a, const Region& b);
Rational square_apart(const Solid& a, const Solid& b);

}  // namespace rtac::geometry
