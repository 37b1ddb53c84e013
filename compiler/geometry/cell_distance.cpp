#include "compiler/geometry/cell_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rtac::geometry {
namespace {

__extension__ using Wide = unsigned __int128;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Corner {
  std::int64_t x, y;
};

std::array<Corner, 4> corners(const Square& s) {
  return {{{s.x_mm, s.y_mm},
           {s.x_mm + s.side_mm, s.y_mm},
           {s.x_mm + s.side_mm, s.y_mm + s.side_mm},
           {s.x_mm, s.y_mm + s.side_mm}}};
}

std::int64_t cross(const PreparedEdge& e, const Corner& p) {
  return e.dx * (p.y - e.ay) - e.dy * (p.x - e.ax);
}

// A squared distance as an exact fraction.
struct Squared {
  Wide numerator;
  std::uint64_t denominator;
};

Wide squared_norm(std::int64_t x, std::int64_t y) {
  const auto square = [](std::int64_t v) {
    const auto size = static_cast<Wide>(v < 0 ? -v : v);
    return size * size;
  };
  return square(x) + square(y);
}

// -1: nearest to a, 0: between, +1: nearest to b.
int end_of(const PreparedEdge& e, const Corner& p) {
  const std::int64_t along = (p.x - e.ax) * e.dx + (p.y - e.ay) * e.dy;
  return along <= 0 ? -1 : along >= e.squared_length ? 1 : 0;
}

Squared squared_distance(const PreparedEdge& e, const Corner& p) {
  const int end = end_of(e, p);
  if (end < 0) return {squared_norm(p.x - e.ax, p.y - e.ay), 1};
  if (end > 0) return {squared_norm(p.x - e.bx, p.y - e.by), 1};
  return {squared_norm(cross(e, p), 0), static_cast<std::uint64_t>(e.squared_length)};
}

double squared(std::int64_t x, std::int64_t y) {
  const auto dx = static_cast<double>(x);
  const auto dy = static_cast<double>(y);
  return dx * dx + dy * dy;
}

double squared_from_line(const PreparedEdge& e, const Corner& p) {
  const auto area = static_cast<double>(cross(e, p));
  return area * area / static_cast<double>(e.squared_length);
}

double approximate_squared(const PreparedEdge& e, const Corner& p) {
  const int end = end_of(e, p);
  if (end == 0) return squared_from_line(e, p);
  return end < 0 ? squared(p.x - e.ax, p.y - e.ay) : squared(p.x - e.bx, p.y - e.by);
}

std::int64_t gap(std::int64_t value, std::int64_t lo, std::int64_t hi) {
  return value < lo ? lo - value : value > hi ? value - hi : 0;
}

// Offset from the closed square to a point.
Corner offset_from(const Square& s, std::int64_t x, std::int64_t y) {
  return {gap(x, s.x_mm, s.x_mm + s.side_mm), gap(y, s.y_mm, s.y_mm + s.side_mm)};
}

struct Place {
  double x, y;
};
Place nearest_point(const PreparedEdge& e, const Corner& p) {
  const int end = end_of(e, p);
  if (end < 0) return {static_cast<double>(e.ax), static_cast<double>(e.ay)};
  if (end > 0) return {static_cast<double>(e.bx), static_cast<double>(e.by)};
  const std::int64_t along = (p.x - e.ax) * e.dx + (p.y - e.ay) * e.dy;
  const double part = static_cast<double>(along) / static_cast<double>(e.squared_length);
  return {static_cast<double>(e.ax) + part * static_cast<double>(e.dx),
          static_cast<double>(e.ay) + part * static_cast<double>(e.dy)};
}
std::array<double, 4> squared_from(const Place& b, const std::array<Corner, 4>& ends) {
  std::array<double, 4> d{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double dx = static_cast<double>(ends[i].x) - b.x,
                 dy = static_cast<double>(ends[i].y) - b.y;
    d[i] = dx * dx + dy * dy;
  }
  return d;
}

// May stop at a corner that is no nearer than `bound_squared`.
double farthest_squared(const std::array<Corner, 4>& ends, const PreparedEdge& e,
                        double bound_squared) {
  double most = 0;
  for (const Corner& corner : ends) {
    most = std::max(most, approximate_squared(e, corner));
    if (most >= bound_squared) break;
  }
  return most;
}

// All corners lie on one side of the edge's line; `or_touch` counts corners on the line as well.
bool separated_by_line(const Square& square, const PreparedEdge& edge, bool or_touch) {
  bool left = true;
  bool right = true;
  for (const Corner& corner : corners(square)) {
    const std::int64_t side = cross(edge, corner);
    left = left && (or_touch ? side >= 0 : side > 0);
    right = right && (or_touch ? side <= 0 : side < 0);
  }
  return left || right;
}

// floor(sqrt(value)); values stay below 2^66 here.
std::int64_t floor_sqrt_wide(Wide value) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<long double>(value)));
  while (root > 0 && static_cast<Wide>(root) * static_cast<Wide>(root) > value) --root;
  while (static_cast<Wide>(root + 1) * static_cast<Wide>(root + 1) <= value) ++root;
  return root;
}

// floor(sqrt(n / d)) = floor(sqrt(floor(n / d))), because squares of integers are integers.
std::int64_t floor_distance(const Squared& s) {
  return floor_sqrt_wide(s.numerator / s.denominator);
}

std::int64_t ceil_distance(const Squared& s) {
  const std::int64_t root = floor_distance(s);
  const Wide square = static_cast<Wide>(root) * static_cast<Wide>(root);
  return square * s.denominator < s.numerator ? root + 1 : root;
}

}  // namespace

std::uint64_t floor_sqrt(std::uint64_t value) {
  return static_cast<std::uint64_t>(floor_sqrt_wide(value));
}

std::vector<PreparedEdge> prepare_edges(const SnappedZone& zone) {
  std::vector<PreparedEdge> edges;
  for (const auto& ring : zone.rings) {
    const std::size_t n = ring.size();
    const std::size_t first = edges.size();
    for (std::size_t i = 0; i < n; ++i) {
      PreparedEdge e{};
      e.ax = ring[i].x_mm;
      e.ay = ring[i].y_mm;
      e.bx = ring[(i + 1) % n].x_mm;
      e.by = ring[(i + 1) % n].y_mm;
      e.dx = e.bx - e.ax;
      e.dy = e.by - e.ay;
      e.squared_length = e.dx * e.dx + e.dy * e.dy;
      edges.push_back(e);
    }
    for (std::size_t i = 0; i < n; ++i) {
      PreparedEdge& e = edges[first + i];
      PreparedEdge& next = edges[first + (i + 1) % n];
      e.reflex_at_b = next.reflex_at_a = e.dx * next.dy - e.dy * next.dx < 0;
    }
  }
  return edges;
}

bool meets_closed(const Square& s, const PreparedEdge& e) {
  return std::max(e.ax, e.bx) >= s.x_mm && std::min(e.ax, e.bx) <= s.x_mm + s.side_mm &&
         std::max(e.ay, e.by) >= s.y_mm && std::min(e.ay, e.by) <= s.y_mm + s.side_mm &&
         !separated_by_line(s, e, false);
}

bool meets_interior(const Square& s, const PreparedEdge& e) {
  return std::max(e.ax, e.bx) > s.x_mm && std::min(e.ax, e.bx) < s.x_mm + s.side_mm &&
         std::max(e.ay, e.by) > s.y_mm && std::min(e.ay, e.by) < s.y_mm + s.side_mm &&
         !separated_by_line(s, e, true);
}

namespace {

double nearest_squared(const Square& square, const PreparedEdge& edge) {
  if (meets_closed(square, edge)) return 0;
  const Corner to_a = offset_from(square, edge.ax, edge.ay);
  const Corner to_b = offset_from(square, edge.bx, edge.by);
  double least = std::min(squared(to_a.x, to_a.y), squared(to_b.x, to_b.y));
  for (const Corner& corner : corners(square)) {
    if (end_of(edge, corner) == 0) least = std::min(least, squared_from_line(edge, corner));
  }
  return least;
}

}  // namespace

double nearest(const Square& square, const PreparedEdge& edge) {
  return std::sqrt(nearest_squared(square, edge));
}

double farthest(const Square& square, const PreparedEdge& edge) {
  return std::sqrt(farthest_squared(corners(square), edge, infinite));
}

std::int64_t nearest_floor(const Square& square, const PreparedEdge& edge) {
  if (meets_closed(square, edge)) return 0;
  const auto to_end = [&](std::int64_t x, std::int64_t y) {
    const Corner offset = offset_from(square, x, y);
    return floor_sqrt_wide(squared_norm(offset.x, offset.y));
  };
  std::int64_t least = std::min(to_end(edge.ax, edge.ay), to_end(edge.bx, edge.by));
  for (const Corner& corner : corners(square)) {
    least = std::min(least, floor_distance(squared_distance(edge, corner)));
  }
  return least;
}

std::int64_t farthest_ceil(const Square& square, const PreparedEdge& edge) {
  std::int64_t most = 0;
  for (const Corner& corner : corners(square)) {
    most = std::max(most, ceil_distance(squared_distance(edge, corner)));
  }
  return most;
}

Candidates narrow(const Square& square, const std::vector<PreparedEdge>& edges,
                  const std::vector<std::uint32_t>& candidates) {
  // Why nothing is lost for any smaller square inside this one: an edge that is nearest to one of
  // its points p is at most as far from p as the edge with the least `farthest`, so its `nearest`
  // is at most that; the same holds for the edge with the least `farthest` of the smaller square.
  const std::array<Corner, 4> ends = corners(square);
  std::vector<double> squares;  // of the distances, until it is known which ones matter
  squares.reserve(candidates.size());
  double least_squared = infinite;  // of the farthest
  for (const std::uint32_t index : candidates) {
    squares.push_back(nearest_squared(square, edges[index]));
    if (squares.back() > least_squared) continue;
    least_squared = std::min(least_squared, farthest_squared(ends, edges[index], least_squared));
  }
  Candidates result;
  result.least_nearest = infinite;
  result.least_farthest = std::sqrt(least_squared);
  const double limit = result.least_farthest * (1 + 1e-9) + 1e-3;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (squares[i] > limit * limit) continue;
    result.edges.push_back(candidates[i]);
    result.nearest.push_back(std::sqrt(squares[i]));
    result.least_nearest = std::min(result.least_nearest, result.nearest.back());
  }
  return result;
}

Candidates sharpen(const Square& square, const std::vector<PreparedEdge>& edges,
                   const Candidates& near) {
  const std::array<Corner, 4> ends = corners(square);
  std::vector<std::array<double, 4>> squares;  // of the distances of each edge from the corners
  squares.reserve(near.edges.size());
  for (const std::uint32_t e : near.edges) {
    std::array<double, 4> d{};
    for (std::size_t i = 0; i < 4; ++i) d[i] = approximate_squared(edges[e], ends[i]);
    squares.push_back(d);
  }
  std::vector<double> to_middle;
  const Corner middle{square.x_mm + square.side_mm / 2, square.y_mm + square.side_mm / 2};
  to_middle.reserve(near.edges.size());
  for (const std::uint32_t e : near.edges) {
    to_middle.push_back(approximate_squared(edges[e], middle));
  }
  std::vector<std::array<double, 4>> points;  // the same as `squares`, of the points b
  const auto add = [&](auto at, const Corner& place) {
    const PreparedEdge& edge = edges[near.edges[static_cast<std::size_t>(at)]];
    points.push_back(squared_from(nearest_point(edge, place), ends));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = std::min_element(squares.begin(), squares.end(),
                                     [&](auto& a, auto& b) { return a[i] < b[i]; });
    add(at - squares.begin(), ends[i]);
  }
  add(std::min_element(to_middle.begin(), to_middle.end()) - to_middle.begin(), middle);
  Candidates result{{}, {}, near.least_nearest, near.least_farthest};
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const bool is_beaten = std::any_of(points.begin(), points.end(), [&](const auto& b) {
      for (std::size_t k = 0; k < 4; ++k) {
        // doubles: a relative error of 1e-14 here, and b lies within 1e-6 mm of the boundary
        if (squares[i][k] <= b[k] * (1 + 1e-11) + 0.1) return false;
      }
      return true;
    });
    if (is_beaten) continue;
    result.edges.push_back(near.edges[i]);
    result.nearest.push_back(near.nearest[i]);
  }
  return result;
}

}  // namespace rtac::geometry
