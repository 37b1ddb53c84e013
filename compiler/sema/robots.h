// Kinds of robots: body, motion, senses, inputs, outputs, energy.
#pragma once

#include "compiler/sema/context.h"

namespace rtac::sema {

// Largest capacity of an input `path[n]`: the runtime's paths have this many way-points.
inline constexpr int max_path = 64;

// Needs the sites to be known (`charge >= 1 %/s at dock`).
void check_kinds(Context& context);

}  // namespace rtac::sema
