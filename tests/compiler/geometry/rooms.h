// Random rooms for tests of searches: halls with wings, pillars and slanting corners.
#pragma once

#include <cstdlib>
#include <random>

#include "testing.h"

namespace rtac::geometry {

// RTAC_ROOMS, for long runs.
inline int rooms_count() {
  const char* const asked = std::getenv("RTAC_ROOMS");
  return asked != nullptr ? std::atoi(asked) : 24;
}

inline Region random_room(std::mt19937& random) {
  const auto upto = [&](long most) {
    return static_cast<long>(random() % static_cast<unsigned>(most));
  };
  const long width = 3000 + upto(5000), depth = 3000 + upto(4000);
  Region room = box(0, 0, width, depth);
  if (upto(2) == 0) {
    const long low = upto(depth / 2), high = low + 700 + upto(depth / 2);
    room = room.unite(box(width - 100, low, width + 500 + upto(3000), high));
  }
  for (long pillars = upto(3); pillars > 0; --pillars) {
    const long x = upto(width), y = upto(depth), side = 20 + upto(900);
    room = room.subtract(box(x, y, x + side, y + 20 + upto(900)));
  }
  if (upto(2) == 0) {
    const long cut = 500 + upto(1500);
    room = room.subtract(polygon({mm(-10, -10), mm(cut, -10), mm(-10, 300 + upto(1500))}));
  }
  return room;
}

}  // namespace rtac::geometry
