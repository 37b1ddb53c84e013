// Why zones are refused that both ways of sending one have. Internal to this folder.
#pragma once

#include "compiler/geometry/receive/receive_zone.h"
#include "compiler/support/rational.h"

namespace rtac::geometry {

// Its boundary goes back and forth within what its places may be off by, and too often to be moved.
inline RefusedZone too_sharp(const Rational& error) {
  return {
      "the zone",
      "has corners so sharp, or edges so near to others, that they cannot all be moved by the " +
          to_decimal(Rational(error * 1000)) + " mm that its places may be off",
      "up to " + std::to_string(offset_vertices_max) +
          " vertices work then: simplify the outline in the program that drew it"};
}

}  // namespace rtac::geometry
