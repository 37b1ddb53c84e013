// How much of a zone a monitor leaves to the advanced controller.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// Of the cells of a zone of the plane in which the body fits, in percent, rounded down.
struct Share {
  int any_speed = 0;  // from where full speed in any direction fails no look-ahead
  int returns = 0;    // where a recovery at rest gives control back
};
// none: no body fits, or the zone has height.
std::optional<Share> share_of(const ir::ZoneTable& zone, std::int64_t body_mm,
                              std::int64_t any_speed_mm, std::int64_t return_mm);

}  // namespace rtac::analysis
