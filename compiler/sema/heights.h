// Zones with height: prisms over zones of the plane, rectangles between points of space, and what
// is made of them.
#pragma once

#include <optional>

#include "compiler/sema/context.h"

namespace rtac::sema {

// Whether the zone that is written has height; names are followed, whether they were checked or
// not.
bool has_height(const Context& context, const syntax::Expr& expr);
// A box in it has a corner in the plane and one in space, which is told there: nothing else is said
// about its height.
bool height_is_open(const Context& context, const syntax::Expr& expr);

// Whether a zone may be one with height.
enum class Height { refused, allowed };

// A zone with height where one of the plane is due; false: reported.
bool lies_in_plane(Context& context, const syntax::Expr& expr, const std::string& due);

void report_height(Context& context, const SourceRange& range, const std::string& zone,
                   const std::string& due);

// Both have height, or neither; false: reported.
struct ZonePair {
  const syntax::Expr &left, &right;
  SourceRange where;
  std::string verb;  // what one is to the other: "joined to"
};
bool heights_agree(Context& context, const ZonePair& pair);

// From the floor to the ceiling, in m.
struct Band {
  Rational floor, ceiling;
};
std::optional<Band> check_band(Context& context, const syntax::Expr& expr,
                               const syntax::PrismLit& prism);

// A box: its base and its heights. nullopt: reported.
struct CheckedBox {
  ZonePolygon base;
  Band band;
};
std::optional<CheckedBox> check_box(Context& context, const syntax::Expr& expr,
                                    const syntax::RectangleLit& box);

}  // namespace rtac::sema
