// Zones without an end, such as all that is outside of an outline: the coordinates of the kernel
// end them, far from where anybody drives, and a grid over all of that says nothing of what is
// near.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// Of a zone of the plane: whether nothing that is written bounds it.
bool is_boundless(const ir::ZoneTable& zone);

// "hall & rectangle (-12 m, -12 m) to (15 m, 16 m)": what of it lies within a box around all that
// bounds it from inside, so much wider.
std::string bounded(const ir::ZoneTable& zone, std::int64_t wider_mm);

}  // namespace rtac::analysis
