#include "compiler/geometry/runs.h"

#include <algorithm>

namespace rtac::geometry {
namespace {

constexpr std::size_t run_size = 64;

Bounds around(const Bounds& a, const Bounds& b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

}  // namespace

Runs::Runs(const Edges& edges, std::size_t from, std::size_t to) : edges_(edges) {
  for (std::size_t start = from; start < to; start += run_size) {
    Run run{start, std::min(start + run_size, to), edges[start].x, edges[start].y};
    for (std::size_t i = start; i < run.to; ++i) {
      run.x = around(run.x, edges[i].x);
      run.y = around(run.y, edges[i].y);
    }
    runs_.push_back(run);
    x_ = runs_.size() == 1 ? run.x : around(x_, run.x);
    y_ = runs_.size() == 1 ? run.y : around(y_, run.y);
  }
}

bool Runs::enclose(const Edge& v) const {
  bool inside = false;
  for (const Run& run : runs_) {
    if (disjoint(v.y, run.y) || run.x.hi < v.x.lo) continue;
    for (std::size_t i = run.from; i < run.to; ++i) inside ^= is_crossed(edges_[i], v);
  }
  return inside;
}

// By the ray from the start of `v` to the right. An edge owns its lower end only.
bool Runs::is_crossed(const Edge& e, const Edge& v) const {
  const bool a_below = e.a->y <= v.a->y;
  return a_below != (e.b->y <= v.a->y) && edges_.side(e, v, false) == (a_below ? 1 : -1);
}

}  // namespace rtac::geometry
