// Zones: from the algebra as written to zone expressions with exact points. Validity of rings is
// left to geometry, which says more about them.
#pragma once

#include <optional>

#include "compiler/sema/context.h"
#include "compiler/sema/heights.h"

namespace rtac::sema {

// Fills spec.zones from the declarations and reports cycles among them.
void check_zones(Context& context);

// Finds the points and robots that zones move with. Needs the types of inputs and the kinds of
// robots.
void check_carriers(Context& context);

// Is it an input that is a zone?
bool is_received_zone(const Context& context, const Symbol& symbol);

// A point of the plane; both coordinates are lengths.
std::optional<Point> check_point(Context& context, const syntax::Expr& expr,
                                 const std::string& what);

// A point of space; all of its coordinates are lengths.
std::optional<std::vector<Rational>> check_corner(Context& context, const syntax::Expr& expr,
                                                  const std::string& what);

// Functions whose value is a zone: `shrink`, `grow`, `complement`.
bool is_zone_function(const std::string& name);

// The zone that a zone is the complement of, itself and not by way of other operations.
std::optional<ZoneId> complemented(const Spec& spec, ZoneId zone);

// Whether a zone may be one that changes with time.
// `timed`: it may be one that is there at certain times. `looked_ahead`: or one that is received,
// which robots of the plane look ahead at, too. `apart`: as `timed`, from another zone.
enum class Change { refused, timed, looked_ahead, apart, allowed };

// The complement of a zone, without a name: one for all that ask.
ZoneId complement_of(Context& context, ZoneId zone, const SourceRange& range);

// The zone that an expression inside a property stands for: a declared one, or a new one without
// a name at the end of spec.zones; all of it in `frame`. Robots are in `map`.
std::optional<ZoneId> zone_in_property(Context& context, const syntax::Expr& expr,
                                       FrameId frame = map_frame, Change change = Change::refused,
                                       Height height = Height::refused);

// The frame of the first zone that is named in an expression; `map` when none is.
FrameId frame_of_zone(const Context& context, const syntax::Expr& expr);

// The declared zone of this name, which must be in this frame.
std::optional<ZoneId> zone_in_frame(Context& context, const syntax::Name& name,
                                    FrameId frame = map_frame, Change change = Change::refused,
                                    Height height = Height::refused);

}  // namespace rtac::sema
