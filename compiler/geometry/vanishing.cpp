#include "compiler/geometry/vanishing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace rtac::geometry {

std::optional<Vector> meeting_after(const MovingEdge& first, const MovingEdge& second,
                                    double distance_m) {
  constexpr double parallel = 1e-9;
  const Vector &n = first.normal, &m = second.normal;
  const double turn = cross(n, m);
  if (std::abs(turn) < parallel) return std::nullopt;
  // n * x = far, m * x = near, x from the start of `second`
  const double far = dot(n, first.from.b - second.from.a) + distance_m, near = distance_m;
  const Vector x{(far * m.y - near * n.y) / turn, (near * n.x - far * m.x) / turn};
  return second.from.a + x;
}

Vanishing::Vanishing(const std::vector<MovingEdge>& ring, double distance_m, double least_m,
                     double part_rad_max)
    : ring_(ring), distance_m_(distance_m), least_m_(least_m), part_rad_max_(part_rad_max) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    before_.push_back((i + ring.size() - 1) % ring.size());
    after_.push_back((i + 1) % ring.size());
  }
}

bool Vanishing::is_point(std::size_t first, std::size_t second) const {
  const MovingEdge &e = ring_[first], &f = ring_[second];
  const double turn = std::atan2(cross(e.normal, f.normal), dot(e.normal, f.normal));
  const bool to_left = cross(e.from.b - e.from.a, e.normal) > 0;
  return (to_left ? turn : -turn) > -part_rad_max_;
}

std::optional<double> Vanishing::length_after(std::size_t edge, double distance_m) const {
  const MovingEdge& e = ring_[edge];
  const auto begin = meeting_after(ring_[before_[edge]], e, distance_m);
  const auto end = meeting_after(e, ring_[after_[edge]], distance_m);
  if (!begin || !end) return std::nullopt;
  const Vector along = e.from.b - e.from.a;
  return dot(*end - *begin, along) / std::hypot(along.x, along.y);
}

// How far all have moved by then; its length changes evenly.
std::optional<double> Vanishing::vanishes_after(std::size_t edge) const {
  if (!is_point(before_[edge], edge) || !is_point(edge, after_[edge])) return std::nullopt;
  const auto now = length_after(edge, 0), then = length_after(edge, distance_m_);
  if (!now || !then || *then > least_m_) return std::nullopt;
  return *now > *then ? distance_m_ * std::max(*now, 0.0) / (*now - *then) : 0;
}

std::optional<Vanishing::Result> Vanishing::run() {
  using Due = std::pair<double, std::size_t>;
  std::priority_queue<Due, std::vector<Due>, std::greater<>> due;
  const auto look_at = [&](std::size_t edge) {
    if (const auto when = vanishes_after(edge)) due.emplace(*when, edge);
  };
  for (std::size_t i = 0; i < ring_.size(); ++i) look_at(i);
  Result result;
  std::vector<bool> gone(ring_.size(), false);
  while (!due.empty()) {
    const auto [when, edge] = due.top();
    due.pop();
    // its neighbours may be others by now
    if (gone[edge] || vanishes_after(edge) != when) continue;
    gone[edge] = true;
    const std::size_t before = before_[edge], after = after_[edge];
    const auto at = meeting_after(ring_[before], ring_[after], when);
    if (!at || result.events.size() + 4 > ring_.size()) return std::nullopt;
    result.events.push_back({before, edge, after, *at});
    after_[before] = after;
    before_[after] = before;
    look_at(before);
    look_at(after);
  }
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    if (!gone[i]) result.remaining.push_back(i);
  }
  return result;
}

}  // namespace rtac::geometry
