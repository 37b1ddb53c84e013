#include "compiler/recheck/legs.h"

#include <algorithm>

namespace rtac::recheck {

std::array<Place, 4> corners(const Box& b) {
  return {Place{b.x, b.y}, Place{b.right, b.y}, Place{b.x, b.top}, Place{b.right, b.top}};
}
Place middle(const Box& b) {
  return {(b.x + b.right) / 2, (b.y + b.top) / 2};
}
double radius(const Box& b) {
  return length(b.right - b.x, b.top - b.y) / 2;
}
std::array<Box, 4> quarters(const Box& b) {
  const Place m = middle(b);
  return {Box{b.x, b.y, m.x, m.y},
          {m.x, b.y, b.right, m.y},
          {b.x, m.y, m.x, b.top},
          {m.x, m.y, b.right, b.top}};
}

namespace {

double to_segment(const Segment& s, Place p) {
  return std::sqrt(square_to(s, p.x, p.y));
}
double between(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& of, double x, double y) {
    return (of.bx - of.ax) * (y - of.ay) - (of.by - of.ay) * (x - of.ax);
  };
  const bool cross = side(s, t.ax, t.ay) * side(s, t.bx, t.by) < 0 &&
                     side(t, s.ax, s.ay) * side(t, s.bx, s.by) < 0;
  if (cross) return 0;
  return std::min({to_segment(s, {t.ax, t.ay}), to_segment(s, {t.bx, t.by}),
                   to_segment(t, {s.ax, s.ay}), to_segment(t, {s.bx, s.by})});
}
// From all of the square the way to c leads away from what is nearest of the segment, its ends or
// its line. The distance along a line is convex: what does not fall at first never does.
bool leads_off(const Segment& s, const Box& from, Place c) {
  const Place a{s.ax, s.ay}, b{s.bx, s.by}, d = b - a;
  bool beyond_a = false, beyond_b = false, between_ends = false;
  int left = 0, right = 0;
  for (const Place p : corners(from)) {
    const double along = inner(p - a, d) / inner(d, d);
    beyond_a = beyond_a || along <= 0;
    beyond_b = beyond_b || along >= 1;
    const double side = d.x * (p.y - a.y) - d.y * (p.x - a.x);
    left += side > 0 ? 1 : 0;
    right += side < 0 ? 1 : 0;
  }
  for (const Place p : corners(from)) {
    const double along = inner(p - a, d) / inner(d, d);
    between_ends = between_ends || (along > 0 && along < 1);
  }
  between_ends = between_ends || (beyond_a && beyond_b);
  if (between_ends && left != 0 && right != 0) return false;
  const Place off = left != 0 ? Place{-d.y, d.x} : Place{d.y, -d.x};
  return std::ranges::all_of(corners(from), [&](Place p) {
    return (!beyond_a || inner(c - p, p - a) >= 0) && (!beyond_b || inner(c - p, p - b) >= 0) &&
           (!between_ends || inner(c - p, off) >= 0);
  });
}

}  // namespace

Boundary::Boundary(const std::vector<Segment>& all, Place around, double within)
    : all_(all), around_(around), within_(within) {
  for (const Segment& s : all) {
    if (to_segment(s, around) <= within) near_.push_back(s);
  }
}

std::vector<std::array<std::int64_t, 4>> Boundary::outline() const {
  constexpr double per_nm = 1e-9;
  std::vector<std::array<std::int64_t, 4>> ends;
  for (const Segment& s : near_) {
    const bool along_axis = s.ax == s.bx || s.ay == s.by;
    const auto off = [&](double at, double from) {
      const double by = at - from;
      return std::llround((along_axis ? std::clamp(by, -within_, within_) : by) / per_nm);
    };
    ends.push_back(
        {off(s.ax, around_.x), off(s.ay, around_.y), off(s.bx, around_.x), off(s.by, around_.y)});
  }
  std::ranges::sort(ends);
  return ends;
}

double Boundary::gap(Place p) const {
  double least = 1e300;
  for (const Segment& s : near_) least = std::min(least, to_segment(s, p));
  return least;
}

bool Boundary::inside(Place p) const {
  bool in = false;
  for (const Segment& s : all_) {
    const bool spans = (s.ay > p.y) != (s.by > p.y);
    if (spans && p.x < s.ax + (p.y - s.ay) / (s.by - s.ay) * (s.bx - s.ax)) in = !in;
  }
  return in;
}

bool Boundary::holds_nobody(const Box& square, double body) const {
  const double free = gap(middle(square)), round = radius(square);
  if (free + round < body - slack_m) return true;
  return free > round + slack_m && !inside(middle(square));
}

double Boundary::asked_from(const Box& square, double clearance, double forgiven) const {
  return std::min(clearance, gap(middle(square)) + radius(square)) - forgiven;
}

// Either the legs to all ends are far enough, and what lies between those is not far from one of
// them, or all lead off, which is linear in the end.
bool Boundary::keeps_to(const Box& from, const std::vector<Place>& ends, double asked) const {
  const Place m = middle(from);
  double widest = 0;
  Box legs{m.x, m.y, m.x, m.y};
  for (const Place a : ends) {
    legs = {std::min(legs.x, a.x), std::min(legs.y, a.y), std::max(legs.right, a.x),
            std::max(legs.top, a.y)};
    for (const Place b : ends) widest = std::max(widest, length(a.x - b.x, a.y - b.y));
  }
  // between two no farther than half of that; between more ones less than two thirds
  const double spread = ends.size() > 2 ? widest * 2 / 3 : widest / 2;
  const double far = asked + std::max(radius(from), spread);
  return std::ranges::all_of(near_, [&](const Segment& s) {
    const bool beside =
        std::min(s.ax, s.bx) - legs.right >= far || legs.x - std::max(s.ax, s.bx) >= far ||
        std::min(s.ay, s.by) - legs.top >= far || legs.y - std::max(s.ay, s.by) >= far;
    if (beside) return true;  // mostly
    const auto is_far = [&](Place to) { return between(s, {m.x, m.y, to.x, to.y}) >= far; };
    return std::ranges::all_of(ends, is_far) ||
           std::ranges::all_of(ends, [&](Place to) { return leads_off(s, from, to); });
  });
}

}  // namespace rtac::recheck
