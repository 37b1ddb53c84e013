#include "compiler/geometry/touches.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "compiler/geometry/ring.h"

namespace rtac::geometry {
namespace {

// A ring at a point of it: where it comes from and where it goes, with its inside on the left.
struct Corner {
  const Point *back, *ahead;
};

Corner corner(const Edges& edges, const Edge& e, const Point& at) {
  const std::size_t size = edges.size(e.ring);
  const auto edge = [&](std::size_t index) -> const Edge& {
    return edges[edges.first(e.ring) + index % size];
  };
  if (same(at, *e.a)) return {edge(e.index + size - 1).a, e.b};
  if (same(at, *e.b)) return {e.a, edge(e.index + 1).b};
  return {e.a, e.b};
}

bool same_direction(const Point& at, const Point& p, const Point& q) {
  return orientation(at, p, q) == 0 &&
         (p.x - at.x) * (q.x - at.x) + (p.y - at.y) * (q.y - at.y) > 0;
}

// The way from `at` to `p` starts inside the corner; it runs along neither of its edges.
bool starts_inside(const Point& at, const Corner& corner, const Point& p) {
  const int turn = orientation(at, *corner.ahead, *corner.back);
  const bool left_of_ahead = orientation(at, *corner.ahead, p) > 0;
  const bool right_of_back = orientation(at, p, *corner.back) > 0;
  if (turn > 0) return left_of_ahead && right_of_back;
  if (turn < 0) return left_of_ahead || right_of_back;
  return left_of_ahead;
}

}  // namespace

Leaves leaves(const Edges& edges, const Edge& leaving, const Edge& of, bool counter_clockwise,
              const Point& at) {
  Corner around = corner(edges, of, at);
  if (!counter_clockwise) std::swap(around.back, around.ahead);
  const Corner own = corner(edges, leaving, at);
  bool inside[2];
  const Point* const ways[2] = {own.back, own.ahead};
  for (int i = 0; i < 2; ++i) {
    if (same_direction(at, *ways[i], *around.back) || same_direction(at, *ways[i], *around.ahead)) {
      return Leaves::otherwise;
    }
    inside[i] = starts_inside(at, around, *ways[i]);
  }
  if (inside[0] != inside[1]) return Leaves::otherwise;
  return inside[0] ? Leaves::inwards : Leaves::outwards;
}

// Rings and the points where they touch are a graph: a cycle in it encloses a piece of the area.
const Touch* first_cut(std::size_t rings, std::vector<Touch>& touches) {
  std::map<Point, std::size_t, decltype(&lower_left)> nodes(&lower_left);
  for (const Touch& touch : touches) nodes.try_emplace(touch.at, rings + nodes.size());
  std::vector<std::size_t> parents(rings + nodes.size());
  std::iota(parents.begin(), parents.end(), std::size_t{0});
  const auto root = [&](std::size_t node) {
    while (parents[node] != node) node = parents[node] = parents[parents[node]];
    return node;
  };
  std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
    return std::tie(a.other, a.edge, a.ring) < std::tie(b.other, b.edge, b.ring);
  });
  std::set<std::pair<std::size_t, std::size_t>> joined;  // ring and point
  for (const Touch& touch : touches) {
    const std::size_t point = nodes.at(touch.at);
    for (const std::size_t ring : {touch.ring, touch.other}) {
      if (!joined.emplace(ring, point).second) continue;
      if (root(ring) == root(point)) return &touch;
      parents[root(ring)] = root(point);
    }
  }
  return nullptr;
}

}  // namespace rtac::geometry
