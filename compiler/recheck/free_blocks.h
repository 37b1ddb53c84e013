// Blocks that stand on the ground with nothing near them, which a retreat in space leads away from
// or up along (docs/templates.md, in space), once more.
#pragma once

#include "compiler/geometry/solid.h"

namespace rtac::recheck {

// Of a body, in m: what the fence asks for beyond it, and how clear the places are, at most, that
// the recovery looks for first.
struct FreeRoom {
  Rational radius, asked, clearance;
};
// Whether each of the starts lies beside or over such a block of the fence, or beside what the zone
// leaves out where the fence has none, and the ways from there keep what is asked of the fence.
bool beside_free_blocks(const geometry::Solid& zone, const geometry::Solid& fence,
                        const FreeRoom& room, const geometry::Solid& starts);

}  // namespace rtac::recheck
