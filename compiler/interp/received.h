// A zone that a trace says was received: what it is, and the tables that it becomes.
#pragma once

#include <string>
#include <utility>
#include <variant>

#include "compiler/geometry/receive/receive_zone.h"

namespace rtac::interp {

struct ReceivedZone {
  geometry::ReceivedRegions regions;
  geometry::ZoneTables tables;  // for generated kernels
};

}  // namespace rtac::interp
