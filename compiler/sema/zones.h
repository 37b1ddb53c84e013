// Zones: from the algebra as written to zone expressions with exact points. Validity of rings is
// left to geometry, which says more about them.
#pragma once

#include <optional>

#include "compiler/sema/context.h"

namespace rtac::sema {

// Fills spec.zones from the declarations and reports cycles among them.
void check_zones(Context& context);

// A point of the plane; both coordinates are lengths.
std::optional<Point> check_point(Context& context, const syntax::Expr& expr,
                                 const std::string& what);

// The zone that an expression inside a property stands for: a declared one, or a new one without
// a name at the end of spec.zones.
std::optional<ZoneId> zone_in_property(Context& context, const syntax::Expr& expr);

}  // namespace rtac::sema
