#include "compiler/geometry/nearby.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace rtac::geometry {
namespace {

constexpr std::size_t leaf = 8;

std::size_t middle(std::size_t from, std::size_t to) {
  return from + (to - from) / 2;
}

}  // namespace

double distance(const Vector& p, const Segment& s) {
  const Vector d = s.b - s.a, q = p - s.a;
  const double square = dot(d, d);
  const double share = square > 0 ? std::clamp(dot(q, d) / square, 0.0, 1.0) : 0;
  return std::hypot(q.x - share * d.x, q.y - share * d.y);
}
double distance(const Segment& s, const Segment& t) {
  return std::min({distance(s.a, t), distance(s.b, t), distance(t.a, s), distance(t.b, s)});
}

Nearby::Nearby(const std::vector<Segment>& segments) : segments_(segments) {
  order_.resize(segments.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  boxes_.resize(segments.size() * 2);
  if (!segments.empty()) build(0, segments.size(), 0, 0);
}

Nearby::Box Nearby::box(const Segment& s) {
  return {std::min(s.a.x, s.b.x), std::min(s.a.y, s.b.y), std::max(s.a.x, s.b.x),
          std::max(s.a.y, s.b.y)};
}

Nearby::Box Nearby::build(std::size_t from, std::size_t to, std::size_t node, int axis) {
  if (node >= boxes_.size()) boxes_.resize(node + 1);
  Box all = box(segments_[order_[from]]);
  for (std::size_t i = from + 1; i < to; ++i) {
    const Box one = box(segments_[order_[i]]);
    all = {std::min(all.x0, one.x0), std::min(all.y0, one.y0), std::max(all.x1, one.x1),
           std::max(all.y1, one.y1)};
  }
  boxes_[node] = all;
  if (to - from <= leaf) return all;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t half = middle(from, to);
  std::nth_element(at(from), at(half), at(to), [&](std::size_t i, std::size_t j) {
    const Segment &s = segments_[i], &t = segments_[j];
    return axis == 0 ? s.a.x + s.b.x < t.a.x + t.b.x : s.a.y + s.b.y < t.a.y + t.b.y;
  });
  build(from, half, 2 * node + 1, 1 - axis);
  build(half, to, 2 * node + 2, 1 - axis);
  return all;
}

bool Nearby::keeps(std::size_t from, std::size_t to, std::size_t node, const Segment& s,
                   double distance_m) const {
  const Box &one = boxes_[node], other = box(s);
  const double dx = std::max({0.0, one.x0 - other.x1, other.x0 - one.x1});
  const double dy = std::max({0.0, one.y0 - other.y1, other.y0 - one.y1});
  // corner to corner where they lie diagonally: of many edges that are all about so far away, as of
  // an arc that its centre is moved from, only few are looked at
  if (std::hypot(dx, dy) > distance_m) return true;
  if (to - from <= leaf) {
    for (std::size_t i = from; i < to; ++i) {
      if (distance(segments_[order_[i]], s) < distance_m) return false;
    }
    return true;
  }
  const std::size_t half = middle(from, to);
  return keeps(from, half, 2 * node + 1, s, distance_m) &&
         keeps(half, to, 2 * node + 2, s, distance_m);
}

double Nearby::to_box(const Vector& p, const Part& part) const {
  const Box& box = boxes_[part.node];
  return std::hypot(std::max({0.0, box.x0 - p.x, p.x - box.x1}),
                    std::max({0.0, box.y0 - p.y, p.y - box.y1}));
}

double Nearby::nearest(const Vector& p, double most_m) const {
  if (!segments_.empty()) shorten(all(), p, most_m);
  return most_m;
}

// The nearer half first: then the other one is seldom looked at.
void Nearby::shorten(const Part& part, const Vector& p, double& least) const {
  if (to_box(p, part) >= least) return;
  if (part.to - part.from <= leaf) {
    for (std::size_t i = part.from; i < part.to; ++i) {
      least = std::min(least, distance(p, segments_[order_[i]]));
    }
    return;
  }
  const std::size_t half = middle(part.from, part.to);
  Part near{part.from, half, 2 * part.node + 1}, far{half, part.to, 2 * part.node + 2};
  if (to_box(p, far) < to_box(p, near)) std::swap(near, far);
  shorten(near, p, least);
  shorten(far, p, least);
}

void Nearby::each_within(const Vector& p, double distance_m,
                         const std::function<void(std::size_t)>& visit) const {
  if (!segments_.empty()) this->visit(all(), p, distance_m, visit);
}

void Nearby::visit(const Part& part, const Vector& p, double distance_m,
                   const std::function<void(std::size_t)>& each) const {
  if (to_box(p, part) > distance_m) return;
  if (part.to - part.from <= leaf) {
    for (std::size_t i = part.from; i < part.to; ++i) {
      if (distance(p, segments_[order_[i]]) <= distance_m) each(order_[i]);
    }
    return;
  }
  const std::size_t half = middle(part.from, part.to);
  visit({part.from, half, 2 * part.node + 1}, p, distance_m, each);
  visit({half, part.to, 2 * part.node + 2}, p, distance_m, each);
}

}  // namespace rtac::geometry
