// What a property allows with every zone that comes or goes as it is at its worst.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "compiler/analysis/recovery_places.h"
#include "compiler/geometry/region.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// Whether a robot may stay at a place, `clearance_mm` beyond what the property of the monitor asks
// for; what does not depend on the place is taken to hold, but for a side of an `or`, unless that
// is a limit of speed which allows to set out from rest.
bool allowed_at_worst(const ir::Module& module, const ir::Decision& decision,
                      const ir::Monitor& monitor, std::int64_t clearance_mm, std::int64_t x_mm,
                      std::int64_t y_mm);
// Where the property holds, whatever the standoffs.
geometry::Region region_at_worst(const ir::Decision& decision, const ir::Block& property,
                                 const ExactZone& exact);

// One rectangle along the axes.
bool is_rectangle(const geometry::Region& region);
// The middle of an edge of what is left of the convex zone `own`, to the line of which `from` is no
// nearer than `room_m` on the side that is left: who sets out beside it, with so much room, for
// `from` may come nearer to what ends there. None: whoever has so much room keeps it.
std::optional<geometry::Point> hidden_from(const geometry::Region& left,
                                           const geometry::Point& from, const geometry::Region& own,
                                           const Rational& room_m);

}  // namespace rtac::analysis
