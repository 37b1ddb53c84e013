#include "compiler/recheck/starts.h"

#include <algorithm>

#include "compiler/recheck/squares.h"

namespace rtac::recheck {

Starts::Starts(const std::vector<geometry::Region>& regions, double off) : off_(off) {
  for (const geometry::Region& region : regions) outlines_.push_back(segments_of(region));
}

bool Starts::may_be_in(const Box& square) const {
  const double within = radius(square) + off_;
  const Place m = middle(square);
  return std::ranges::any_of(outlines_, [&](const std::vector<Segment>& edges) {
    return holds(edges, m) || std::ranges::any_of(edges, [&](const Segment& s) {
             return square_to(s, m.x, m.y) <= within * within;
           });
  });
}

bool holds(const std::vector<Segment>& outline, Place p) {
  bool in = false;
  for (const Segment& s : outline) {
    if ((s.ay > p.y) == (s.by > p.y)) continue;
    if (p.x < s.ax + (p.y - s.ay) / (s.by - s.ay) * (s.bx - s.ax)) in = !in;
  }
  return in;
}

}  // namespace rtac::recheck
