#include "compiler/geometry/connectors.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/looks.h"

namespace rtac::geometry {
namespace {

// A cell is cut into four, its quarters again, at most so often: to 3.1 mm of a cell of 100 mm.
constexpr int halvings_max = 5;
// Errors of doubles, over coordinates of at most 2^29 mm.
constexpr double slack_mm = 1e-3;

struct Vec {
  double x, y;
};
Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y};
}
double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y;
}
double cross(Vec a, Vec b) {
  return a.x * b.y - a.y * b.x;
}
double length(Vec a) {
  return std::sqrt(dot(a, a));  // of what is below 2^30: faster than hypot
}
Vec start_of(const EdgeRow& e) {
  return {static_cast<double>(e.a.x_mm), static_cast<double>(e.a.y_mm)};
}
Vec end_of(const EdgeRow& e) {
  return {static_cast<double>(e.b.x_mm), static_cast<double>(e.b.y_mm)};
}

Vec nearest_on(Vec a, Vec b, Vec p) {
  const Vec d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  return {a.x + t * d.x, a.y + t * d.y};
}
double distance(Vec a, Vec b, Vec p) {
  return length(p - nearest_on(a, b, p));
}
// Of two segments; 0 when they cross.
double distance(Vec a, Vec b, Vec c, Vec d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  if (c_side * d_side < 0 && a_side * b_side < 0) return 0;
  return std::min({distance(a, b, c), distance(a, b, d), distance(c, d, a), distance(c, d, b)});
}

// Whether two segments are so far from each other, as one axis alone tells.
bool apart_by_axis(Vec a, Vec b, Vec c, Vec d, double far) {
  return std::max(std::min(a.x, b.x) - std::max(c.x, d.x),
                  std::min(c.x, d.x) - std::max(a.x, b.x)) >= far ||
         std::max(std::min(a.y, b.y) - std::max(c.y, d.y),
                  std::min(c.y, d.y) - std::max(a.y, b.y)) >= far;
}

}  // namespace

Connectors::Connectors(const std::vector<EdgeRow>& edges, std::int32_t clearance_mm,
                       std::int32_t body_mm, double forgiven_mm)
    : edges_(edges), clearance_mm_(clearance_mm), body_mm_(body_mm), forgiven_mm_(forgiven_mm) {
  // long edges are in all of them, so there are not too many
  constexpr std::size_t of_strip = 8, strips_max = 256;
  strips_.resize(std::clamp<std::size_t>(edges.size() / of_strip, 1, strips_max));
  if (edges.empty()) return;
  double east = west_ = edges.front().a.x_mm;
  for (const EdgeRow& e : edges) {
    west_ = std::min<double>(west_, std::min(e.a.x_mm, e.b.x_mm));
    east = std::max<double>(east, std::max(e.a.x_mm, e.b.x_mm));
  }
  strip_mm_ = std::max(1.0, (east - west_) / static_cast<double>(strips_.size()));
  for (std::uint32_t i = 0; i < edges.size(); ++i) {
    const auto [first, last] = std::minmax(edges[i].a.x_mm, edges[i].b.x_mm);
    for (std::size_t at = strip_of(first); at <= strip_of(last); ++at) strips_[at].push_back(i);
  }
}

std::size_t Connectors::strip_of(double x_mm) const {
  const double last = static_cast<double>(strips_.size() - 1);
  return static_cast<std::size_t>(std::clamp(std::floor((x_mm - west_) / strip_mm_), 0.0, last));
}

double Connectors::Spot::radius_mm() const {
  return side_mm / std::sqrt(2.0);
}

Connectors::Spot Connectors::look_around(double x_mm, double y_mm, double size_mm,
                                         double reach_mm) {
  const Vec middle{x_mm + size_mm / 2, y_mm + size_mm / 2};
  const double limit = size_mm * std::sqrt(2.0) + reach_mm + std::max(clearance_mm_, body_mm_) + 1;
  corner_x_mm_ = x_mm, corner_y_mm_ = y_mm, size_mm_ = size_mm, limit_mm_ = limit;
  near_.clear();
  for (std::size_t at = strip_of(middle.x - limit); at <= strip_of(middle.x + limit); ++at) {
    near_.insert(near_.end(), strips_[at].begin(), strips_[at].end());
  }
  std::ranges::sort(near_);
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  looked_at_ = static_cast<std::int64_t>(near_.size());
  looks() += looked_at_;
  refused_last_ = nobody;
  std::erase_if(near_, [&](std::uint32_t i) {
    const Vec a = start_of(edges_[i]), b = end_of(edges_[i]);
    return apart_by_axis(a, b, middle, middle, limit + slack_mm) || distance(a, b, middle) > limit;
  });
  return spot_at(middle.x, middle.y, size_mm);
}

// What lies farther from the middle of the cell than the limit tells nothing of it. Let p be the
// middle of a part of the cell, r the radius of that and m the middle of the cell, so that |m - p|
// + r is at most the size of the cell by sqrt(2). The gap of p is looked at up to the larger one of
// both clearances. A leg from p to c is tested against the edges with a place e nearer to it than
// the clearance and r, and against the place q of them that is nearest to p: |p - q| <= |p - e| <
// |c - p| + clearance + r, and |c - p| <= reach + |m - p|, so that |m - q| is less than the reach,
// the clearance and twice |m - p| + r: the limit. And whether p is in the zone is told by the
// nearest edge, which has that on its left, if there is one within the limit.
std::vector<std::int32_t> Connectors::edges_off_corner() const {
  const double far = std::ceil(limit_mm_);
  // an edge along an axis is cut where it leaves a square around the circle of the limit
  const auto off = [&](std::int32_t at, double corner, bool is_cut) {
    const double off_mm = at - corner;
    return static_cast<std::int32_t>(is_cut ? std::clamp(off_mm, -far, far + size_mm_) : off_mm);
  };
  std::vector<std::array<std::int32_t, 4>> edges;
  for (const std::uint32_t i : near_) {
    const auto& [a, b] = std::pair{edges_[i].a, edges_[i].b};
    const bool is_cut = a.x_mm == b.x_mm || a.y_mm == b.y_mm;
    edges.push_back({off(a.x_mm, corner_x_mm_, is_cut), off(a.y_mm, corner_y_mm_, is_cut),
                     off(b.x_mm, corner_x_mm_, is_cut), off(b.y_mm, corner_y_mm_, is_cut)});
  }
  std::ranges::sort(edges);
  std::vector<std::int32_t> all;
  for (const auto& ends : edges) all.insert(all.end(), ends.begin(), ends.end());
  return all;
}

Connectors::Spot Connectors::spot_at(double x_mm, double y_mm, double side_mm) const {
  double gap_mm = std::max(clearance_mm_, body_mm_);  // more does not matter
  for (const std::uint32_t i : near_) {
    gap_mm = std::min(gap_mm, distance(start_of(edges_[i]), end_of(edges_[i]), {x_mm, y_mm}));
  }
  looks() += static_cast<std::int64_t>(near_.size());
  return {x_mm, y_mm, side_mm, gap_mm};
}

std::array<Connectors::Spot, 4> Connectors::quarters(const Spot& spot) const {
  const double off = spot.side_mm / 4, half = spot.side_mm / 2;
  return {spot_at(spot.x_mm - off, spot.y_mm - off, half),
          spot_at(spot.x_mm + off, spot.y_mm - off, half),
          spot_at(spot.x_mm - off, spot.y_mm + off, half),
          spot_at(spot.x_mm + off, spot.y_mm + off, half)};
}

double Connectors::longest_mm(double x_mm, double y_mm, double size_mm,
                              const std::vector<Landing>& landings, double reach_mm) {
  return longest_in(look_around(x_mm, y_mm, size_mm, reach_mm), halvings_max, landings);
}

double Connectors::longest_in(const Spot& spot, int halvings,
                              const std::vector<Landing>& landings) const {
  if (holds_nobody(spot)) return 0;
  for (const Landing& to : landings) {
    if (!is_sound(spot, to)) continue;
    return to.rest_mm + std::hypot(to.x_mm - spot.x_mm, to.y_mm - spot.y_mm) + spot.radius_mm();
  }
  if (halvings == 0) return -1;
  double longest = 0;
  for (const Spot& part : quarters(spot)) {
    const double of_part = longest_in(part, halvings - 1, landings);
    if (of_part < 0) return -1;
    longest = std::max(longest, of_part);
  }
  return longest;
}

bool Connectors::holds_nobody(const Spot& spot) const {
  if (spot.gap_mm + spot.radius_mm() < body_mm_ - slack_mm) return true;
  return spot.gap_mm > spot.radius_mm() + slack_mm && !contains(spot.x_mm, spot.y_mm);
}

// Even-odd rule, of the edges above, which all reach into the strip; the boundary is farther away
// than any error.
bool Connectors::contains(double x, double y) const {
  bool inside = false;
  for (const std::uint32_t i : strips_[strip_of(x)]) {
    const Vec a = start_of(edges_[i]), b = end_of(edges_[i]);
    if ((a.x > x) == (b.x > x)) continue;
    if (y < a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y)) inside = !inside;
  }
  return inside;
}

// From every point p of the square, the leg to c keeps to each edge the smaller of `clearance_mm`
// and the distance that p has. Either the whole leg is that far away, p's distance being at most
// the gap of the middle and the radius; or the leg recedes from the edge: an edge is convex, so the
// distance along a line is convex too, and what does not fall at p never falls behind it. It does
// not fall at p when (c - p) . (p - q) >= 0, q being the point of the edge nearest to p. That
// product changes by at most |p - q| + |c - p| per mm of p, because projection is a contraction.
// So it does for other ends: by |p - q| per mm of that.
//
// From a part of the square it is looked at in the same way, from its middle p', which is within
// the radius of p. Where the leg from p comes nearer to an edge than `near`, that from p' comes
// nearer than what is asked of it; and where (c - p) . (p - q) is less than minus what it may
// change by, it is negative at p'. So that edge refuses the leg from every part.
struct Connectors::Leg {
  Vec from, to;
  double radius, off;  // around them
  double way;          // from one to the other
  double near;         // no part of the spot asks for less, or is nearer to an edge
  double far;          // none asks for more, or is farther off
};

Connectors::Leg Connectors::leg_from(const Spot& spot, const Landing& to, double off_mm) const {
  const Vec p{spot.x_mm, spot.y_mm}, c{to.x_mm, to.y_mm};
  const double radius = spot.radius_mm(), asked = clearance_mm_;
  return {.from = p,
          .to = c,
          .radius = radius,
          .off = off_mm,
          .way = length(c - p),
          .near = std::min(asked, spot.gap_mm - radius) - forgiven_mm_ - radius,
          .far = std::min(asked, spot.gap_mm + radius) - forgiven_mm_ + std::max(radius, off_mm)};
}

Connectors::Sight Connectors::past(const EdgeRow& edge, const Leg& leg) const {
  const Vec a = start_of(edge), b = end_of(edge);
  if (apart_by_axis(a, b, leg.from, leg.to, leg.far)) return Sight::from_all;  // mostly
  const double gap = distance(a, b, leg.from, leg.to);
  if (gap >= leg.far) return Sight::from_all;
  const Vec off = leg.from - nearest_on(a, b, leg.from);
  const double change =
      leg.radius * (length(off) + leg.way + 2 * leg.radius) + leg.off * (length(off) + leg.radius);
  const double recedes = dot(leg.to - leg.from, off);
  if (recedes >= change) return Sight::from_all;
  return gap < leg.near && recedes < -change ? Sight::from_none : Sight::unknown;
}

bool Connectors::is_sound(const Spot& spot, const Landing& to, double off_mm) const {
  const Leg leg = leg_from(spot, to, off_mm);
  return asked(leg, refused_last_) == Sight::from_all;
}

Connectors::Sight Connectors::sight(const Spot& spot, const Landing& to, std::uint32_t& by) const {
  return asked(leg_from(spot, to, 0), by);
}

Connectors::Sight Connectors::asked(const Leg& leg, std::uint32_t& by) const {
  std::int64_t looked = 0;
  Sight seen = Sight::from_all;
  const auto look = [&](std::uint32_t i) {
    ++looked;
    seen = past(edges_[i], leg);
    return seen != Sight::from_all;
  };
  if (by == nobody || !look(by)) {
    const auto refused = std::ranges::find_if(near_, look);
    if (refused != near_.end()) by = *refused;
  }
  looks() += looked;
  return seen;
}

}  // namespace rtac::geometry
