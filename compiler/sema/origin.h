// Where the map lies on the globe.
#pragma once

#include "compiler/geometry/place/placer.h"
#include "compiler/sema/context.h"

namespace rtac::sema {

// Fills spec.origin.
void check_origin(Context& context, const syntax::Program& program);

// In degrees as written, to the nearest double.
geometry::Origin in_degrees(const Origin& origin);

}  // namespace rtac::sema
