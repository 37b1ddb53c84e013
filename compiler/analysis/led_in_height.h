// Between which heights a recovery in space leads (runtime: RetreatInSpace, LoiterInSpace).
#pragma once

#include <cstdint>
#include <utility>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// The lowest and the highest place, in mm, that a step leads to from anywhere below, or above, it:
// the ends of its zone, which has height. But who goes back in a single prism keeps its height
// where that has the clearance that it looks for, and is led off either end by no more than that
// and as far as it strays. What asks for more before it gives back may lead elsewhere.
std::pair<std::int64_t, std::int64_t> led_between_mm(const ir::Decision& decision,
                                                     const ir::Recovery& step,
                                                     const ir::ZoneTable& zone);

}  // namespace rtac::analysis
