// Legs and paths in exact numbers: places one after the other, and the straight ways between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/interp/outline.h"
#include "compiler/interp/span.h"

namespace rtac::interp {

struct Waypoint {
  std::int64_t x_mm, y_mm;  // to the nearest; far away they are cut off
};

struct Trail {
  std::vector<Place> places;
  Rational room = 0;  // m: the true places are that near to these
  Missing missing;    // the places say nothing then
  [[nodiscard]] bool is_unknown() const { return missing.missing || places.empty(); }
  // The ways between its places one by one; of one place that from there to itself.
  template <class Visit>
  void for_each_leg(const Visit& visit) const {
    for (std::size_t i = 0; i + 1 < places.size(); ++i) visit(places[i], places[i + 1]);
    if (places.size() == 1) visit(places[0], places[0]);
  }
};
// A place anywhere in this box comes next: its middle.
void lead_on(Trail& trail, const Span& x, const Span& y);
// A way-point comes next.
void lead_on(Trail& trail, const Waypoint& place);

// The least distance between places of both.
Span distance_of(const Trail& a, const Trail& b);
// The least signed distance of its places from the boundary, negative outside, or the greatest: in
// a zone that contains `within` and lies in `around`.
Span clearance_of(const Outline& within, const Outline& around, const Trail& trail, bool greatest);
// Whether a place of it lies outside of the zone for sure; `outside`: within.
bool surely_leaves(const Outline& within, const Outline& around, const Trail& trail, bool outside);

}  // namespace rtac::interp
