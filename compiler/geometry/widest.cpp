// Branch and bound over squares of the grid, the most promising square first. Doubles order the
// search; the result is evaluated exactly.
#include "compiler/geometry/widest.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <queue>

namespace rtac::geometry {
namespace {

// A square that promises less than this above the best place is not looked at. The grid point next
// to the true place has at most 1/sqrt(2) mm less, so the two losses stay below 1 mm together.
constexpr double kGoodEnoughMm = 0.25;
constexpr int kMostSquares = 400'000;

struct Node {
  double bound_mm;
  std::int64_t order;  // of creation: makes ties repeatable
  Square square;
  std::shared_ptr<const std::vector<std::uint32_t>> candidates;

  bool operator<(const Node& other) const {
    return bound_mm != other.bound_mm ? bound_mm < other.bound_mm : order > other.order;
  }
};

// What one edge says about the side on which a point lies that it is nearest to.
bool says_inside(const Square& point, const PreparedEdge& e) {
  const std::int64_t px = point.x_mm - e.ax;
  const std::int64_t py = point.y_mm - e.ay;
  const std::int64_t along = px * e.dx + py * e.dy;
  // A vertex can only be nearest where the side's angle exceeds 180 degrees.
  if (along < 0) return e.reflex_at_a;
  if (along > e.squared_length) return e.reflex_at_b;
  return e.dx * py - e.dy * px > 0;
}

// Clearance of a grid point; negative when it is not inside. A point is inside when all its
// nearest edges say so; counting nearly nearest ones as well can only lose a place.
double clearance(const Square& point, const std::vector<PreparedEdge>& edges,
                 const std::vector<std::uint32_t>& candidates) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t e : candidates) least = std::min(least, nearest(point, edges[e]));
  const double limit = least * (1 + 1e-12);
  const bool inside = std::all_of(candidates.begin(), candidates.end(), [&](std::uint32_t e) {
    return nearest(point, edges[e]) > limit || says_inside(point, edges[e]);
  });
  return inside ? least : -1;
}

class Search {
 public:
  explicit Search(const std::vector<PreparedEdge>& edges) : edges_(edges) {}

  Square run() {
    std::vector<std::uint32_t> all(edges_.size());
    std::iota(all.begin(), all.end(), 0U);
    add(root(), all);
    while (!queue_.empty() && squares_ < kMostSquares) {
      const Node node = queue_.top();
      queue_.pop();
      if (node.bound_mm <= best_mm_ + kGoodEnoughMm) break;
      const std::int64_t half = node.square.side_mm / 2;
      if (half == 0) continue;
      for (const std::int64_t dy : {std::int64_t{0}, half}) {
        for (const std::int64_t dx : {std::int64_t{0}, half}) {
          add({node.square.x_mm + dx, node.square.y_mm + dy, half}, *node.candidates);
        }
      }
    }
    return best_;
  }

 private:
  [[nodiscard]] Square root() const {
    std::int64_t x_lo = edges_[0].ax, y_lo = edges_[0].ay, x_hi = x_lo, y_hi = y_lo;
    for (const PreparedEdge& e : edges_) {
      x_lo = std::min(x_lo, e.ax);
      x_hi = std::max(x_hi, e.ax);
      y_lo = std::min(y_lo, e.ay);
      y_hi = std::max(y_hi, e.ay);
    }
    std::int64_t side = 1;
    while (side < std::max(x_hi - x_lo, y_hi - y_lo)) side *= 2;
    return {x_lo, y_lo, side};
  }

  // Tries the middle of the square (the south-west corner of the smallest) and queues it.
  void add(const Square& square, const std::vector<std::uint32_t>& candidates) {
    ++squares_;
    Candidates near = narrow(square, edges_, candidates);
    if (near.least_farthest <= best_mm_ + kGoodEnoughMm) return;
    const std::int64_t half = square.side_mm / 2;
    const Square middle{square.x_mm + half, square.y_mm + half, 0};
    const double middle_mm = clearance(middle, edges_, near.edges);
    if (middle_mm > best_mm_) {
      best_mm_ = middle_mm;
      best_ = middle;
    }
    if (!near.meets_boundary() && middle_mm < 0) return;
    queue_.push({near.least_farthest, squares_, square,
                 std::make_shared<const std::vector<std::uint32_t>>(std::move(near.edges))});
  }

  const std::vector<PreparedEdge>& edges_;
  std::priority_queue<Node> queue_;
  std::int64_t squares_ = 0;
  double best_mm_ = 0;
  Square best_{edges_[0].ax, edges_[0].ay, 0};  // a vertex: clearance 0
};

}  // namespace

Widest find_widest(const std::vector<PreparedEdge>& edges) {
  const Square best = Search(edges).run();
  std::int64_t clearance_mm = std::numeric_limits<std::int32_t>::max();
  for (const PreparedEdge& e : edges) clearance_mm = std::min(clearance_mm, nearest_floor(best, e));
  return {{static_cast<std::int32_t>(best.x_mm), static_cast<std::int32_t>(best.y_mm)},
          static_cast<std::int32_t>(clearance_mm)};
}

}  // namespace rtac::geometry
