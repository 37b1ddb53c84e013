// Where robots have to start so that a run shows how they wait for each other. Nothing is claimed
// of these places: what is refuted is what a run shows.
#include <algorithm>
#include <cmath>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/verify/centres.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

using analysis::outline::norm;
using analysis::outline::Outline;
using analysis::outline::P;

// Of each kind: attempts to show it are few.
constexpr std::size_t lock_ups_most = 2;
// A body is on the boundary of where it may start.
constexpr double on_boundary_mm = 0.5;

std::int64_t body_of(const Subject& s) {
  return s.decision.body.radius_mm + start_spare_mm;
}

// Where robots in space start, mostly at one height: where a zone with height is tallest, else in
// the middle of what their properties allow, else at 1 m.
class Level {
 public:
  explicit Level(const Subject& s) : s_(s) {
    if (!s.decision.body.in_space) return;
    const JointNeeds needs = joint_needs_of(s);
    low_mm_ = needs.low_mm, high_mm_ = needs.high_mm;
    constexpr std::int64_t unlimited_mm = 1'000'000, low_mm = 1000;
    const bool bounded = needs.low_mm > -unlimited_mm && needs.high_mm < unlimited_mm;
    z_mm_ = bounded ? (needs.low_mm + needs.high_mm) / 2
                    : std::clamp(low_mm, needs.low_mm, needs.high_mm);
    for (const ir::ZoneIndex fence : fences_with_height()) {
      const auto& slabs = s.solid(fence).slabs();
      if (slabs.empty()) continue;
      const geometry::Slab& tallest = *std::ranges::max_element(
          slabs, {},
          [](const geometry::Slab& slab) { return Rational(slab.ceiling - slab.floor); });
      z_mm_ = std::llround(500 * Rational(tallest.floor + tallest.ceiling).get_d());
      const std::int64_t body_mm = body_of(s);
      low_mm_ = std::max(low_mm_, std::lround(1000 * tallest.floor.get_d()) + body_mm);
      high_mm_ = std::min(high_mm_, std::lround(1000 * tallest.ceiling.get_d()) - body_mm);
    }
  }
  // Where the zones with height leave room for a body, as far as it has a height.
  [[nodiscard]] geometry::Region room(std::int64_t body_mm) const {
    geometry::Region all = geometry::Region::everywhere();
    if (!z_mm_) return all;
    const Rational z(static_cast<long>(*z_mm_), 1000);
    for (const ir::ZoneIndex fence : fences_with_height()) {
      for (const geometry::Slab& slab : s_.solid(fence).slabs()) {
        if (z < slab.floor || z >= slab.ceiling) continue;
        all = all.intersect(analysis::within(slab.region, body_mm).value_or(slab.region));
      }
    }
    return all;
  }
  [[nodiscard]] std::vector<std::int64_t> mm_of(P p) const {
    std::vector<std::int64_t> place = {std::llround(p.x), std::llround(p.y)};
    if (z_mm_) place.push_back(*z_mm_);
    return place;
  }
  // One there, and another one so far above it; none: there is no room for both.
  [[nodiscard]] std::optional<Start> stacked(P p, std::int64_t gap_mm) const {
    if (!z_mm_ || high_mm_ - low_mm_ < gap_mm) return std::nullopt;
    Start start{mm_of(p), {mm_of(p)}};
    start.place_mm.back() = std::clamp(*z_mm_, low_mm_, high_mm_ - gap_mm);
    start.others_mm.front().back() = start.place_mm.back() + gap_mm;
    return start;
  }

 private:
  [[nodiscard]] std::vector<ir::ZoneIndex> fences_with_height() const {
    std::vector<ir::ZoneIndex> all;
    for (const ir::Monitor& m : s_.decision.monitors) {
      for (const ir::ZoneIndex fence : analysis::fences_of(m.property, s_.decision.facts.params)) {
        if (s_.module[fence].has_height()) all.push_back(fence);
      }
    }
    return all;
  }

  const Subject& s_;
  std::optional<std::int64_t> z_mm_;
  std::int64_t low_mm_ = 0, high_mm_ = 0;  // of middles, in space
};

class LockUps {
 public:
  LockUps(const Subject& s, const ir::Recovery& yield)
      : level_(s),
        begins_(Outline::of(begins(s, yield))),
        others_(static_cast<std::size_t>(s.decision.robots - 1)),
        gap_mm_(double(analysis::standoffs_of(s.decision).separation_mm +
                       2 * s.decision.body.radius_mm + start_spare_mm)) {}

  // The first one in a corner, where it finds no way out, and the others in rows before it along
  // both walls: so near to each other that none is let go while another one may move. The nearest
  // to right angles first.
  [[nodiscard]] std::vector<Start> in_corners() const {
    constexpr double off_square_most = 0.5;  // of 60 degrees: else rows are nearer to each other
    std::vector<std::pair<double, Start>> found;
    for (const auto& [a, corner] : begins_.edges()) {
      for (const auto& [c, d] : begins_.edges()) {
        if (c.x != corner.x || c.y != corner.y) continue;
        const P u = step_along(corner, a), v = step_along(corner, d);
        const double off_square = std::abs(u.x * v.x + u.y * v.y) / (gap_mm_ * gap_mm_);
        if (off_square > off_square_most || !begins_.contains(corner + 0.5 * (u + v))) continue;
        Start start = in_rows(corner, {u, v});
        if (start.others_mm.size() > 1) found.emplace_back(off_square, std::move(start));
      }
    }
    return best(std::move(found));
  }
  // One over the other in a corner. Errors that last put each of them beside where it holds, and
  // ways lead from there away from where the other one is measured: both may see the other one on
  // the side of the room. The sharpest corners first.
  [[nodiscard]] std::vector<Start> stacked_in_corners() const {
    constexpr std::size_t corners_most = 4;  // which errors do it depends on the corner
    std::vector<std::pair<double, Start>> found;
    for (const auto& [a, corner] : begins_.edges()) {
      for (const auto& [c, d] : begins_.edges()) {
        if (c.x != corner.x || c.y != corner.y) continue;
        const P u = step_along(corner, a), v = step_along(corner, d);
        if (!begins_.contains(corner + 0.1 * (u + v))) continue;
        const auto start = level_.stacked(corner, std::llround(gap_mm_));
        if (start) found.emplace_back(-(u.x * v.x + u.y * v.y), *start);
      }
    }
    return best(std::move(found), corners_most);
  }
  // The first one at a wall, and the others in two rows before it, square to each other: along the
  // wall it comes nearer to one of them.
  [[nodiscard]] std::vector<Start> before_walls() const {
    std::vector<std::pair<double, Start>> found;
    for (const auto& [a, b] : begins_.edges()) {
      const P along = std::sqrt(0.5) * step_along(a, b);
      for (const P across : {P{along.y, -along.x}, P{-along.y, along.x}}) {
        Start start = in_rows(0.5 * (a + b), {across + along, across - along});
        if (start.others_mm.size() > 1) found.emplace_back(-norm(b - a), std::move(start));
      }
    }
    return best(std::move(found));
  }
  // Two beside a wall, the first one at its end: either one is between the other one and its way
  // out. Somewhat off the wall: from right beside it no run has shown it. As near to each other as
  // is asked, and a little more; or both at ends, unless they are given back there; or nearer, at a
  // wall that is too short for what is asked. The shortest walls first.
  [[nodiscard]] std::vector<Start> beside_walls(double kept_mm, double bodies_mm) const {
    constexpr double beside_mm = 35, spare_mm = 20;
    constexpr std::size_t found_most = 4;
    std::vector<std::pair<double, Start>> found;
    for (const auto& [a, b] : begins_.edges()) {
      const double length_mm = norm(b - a), farthest_mm = length_mm - 2 * beside_mm;
      if (farthest_mm < bodies_mm + spare_mm) continue;
      const P along = (1 / length_mm) * (b - a);
      for (const P inwards : {P{along.y, -along.x}, P{-along.y, along.x}}) {
        const P first = a + beside_mm * (along + inwards), last = b + beside_mm * (inwards - along);
        const P step = (gap_mm_ + spare_mm) * along;
        if (farthest_mm >= norm(step)) {
          add_two(first, first + step, length_mm, found);
          add_two(last, last - step, length_mm, found);
        }
        if (farthest_mm < kept_mm - spare_mm) add_two(first, last, length_mm, found);
      }
    }
    return best(std::move(found), found_most);
  }
  // The first one at the middle of a wall, which it is led away from, and the others in a row
  // before it. The longest walls first.
  [[nodiscard]] std::vector<Start> at_walls() const {
    std::vector<std::pair<double, Start>> found;
    for (const auto& [a, b] : begins_.edges()) {
      const P middle = 0.5 * (a + b), along = step_along(a, b);
      for (const P across : {P{along.y, -along.x}, P{-along.y, along.x}}) {
        if (!begins_.contains(middle + 0.5 * across)) continue;
        Start start = in_rows(middle, {across});
        if (!start.others_mm.empty()) found.emplace_back(-norm(b - a), std::move(start));
      }
    }
    return best(std::move(found));
  }

 private:
  // Where every property holds, and the recovery finds its way.
  [[nodiscard]] geometry::Region begins(const Subject& s, const ir::Recovery& yield) const {
    const std::int64_t body_mm = body_of(s);
    const geometry::Region& zone = s.exact(yield.zone);
    geometry::Region all = analysis::within(zone, body_mm).value_or(zone);
    for (const ir::Monitor& m : s.decision.monitors) {
      all = all.intersect(centres_of(s, m, start_spare_mm));
    }
    return all.intersect(level_.room(body_mm));
  }
  // From one place to another one, as far as two robots have to be from each other.
  [[nodiscard]] P step_along(P from, P to) const {
    return (gap_mm_ / norm(to - from)) * (to - from);
  }
  // If both places are within where they may begin.
  void add_two(P first, P other, double rank, std::vector<std::pair<double, Start>>& to) const {
    if (!begins_.contains(first) || !begins_.contains(other)) return;
    to.emplace_back(rank, Start{level_.mm_of(first), {level_.mm_of(other)}});
  }
  // As many of the others as there is room for, by turns in each row.
  [[nodiscard]] Start in_rows(P first, const std::vector<P>& rows) const {
    Start start{level_.mm_of(first)};
    while (start.others_mm.size() < others_) {
      const std::size_t n = start.others_mm.size();
      const std::size_t steps = 1 + n / rows.size();
      const P next = first + double(steps) * rows[n % rows.size()];
      if (begins_.clearance(next) < -on_boundary_mm) break;
      start.others_mm.push_back(level_.mm_of(next));
    }
    return start;
  }
  static std::vector<Start> best(std::vector<std::pair<double, Start>> found,
                                 std::size_t most = lock_ups_most) {
    std::ranges::stable_sort(found, {}, &std::pair<double, Start>::first);
    std::vector<Start> all;
    for (auto& [rank, start] : found) {
      if (all.size() < most) all.push_back(std::move(start));
    }
    return all;
  }

  const Level level_;
  const Outline begins_;
  const std::size_t others_;
  const double gap_mm_;  // between middles
};

}  // namespace

std::vector<Start> lock_ups(const Subject& s, const ir::Recovery& yield,
                            const ir::Monitor* instead) {
  std::vector<Start> all;
  if (s.decision.robots < 2) return all;
  const LockUps found(s, yield);
  // what is external is an attack in a run
  if (instead != nullptr && instead->recovery.kind != ir::RecoveryKind::external) {
    all = found.at_walls();
  }
  if (s.decision.robots == 2 && s.decision.body.in_space && instead == nullptr) {
    all = found.stacked_in_corners();
  }
  if (s.decision.robots > 2) {
    for (const auto& starts : {found.in_corners(), found.before_walls()}) {
      all.insert(all.end(), starts.begin(), starts.end());
    }
  }
  return all;
}

std::vector<Start> lock_ups_beside_walls(const Subject& s, const ir::Recovery& yield,
                                         std::int64_t kept_mm) {
  return LockUps(s, yield).beside_walls(double(kept_mm), double(2 * s.decision.body.radius_mm));
}

}  // namespace rtac::verify
