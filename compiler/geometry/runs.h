// Edges that follow each other in runs, so that edges of other rings are compared with the few near
// them alone. Internal to this folder.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/geometry/sweep.h"

namespace rtac::geometry {

class Runs {
 public:
  // Of the edges [from, to), which must outlive it.
  Runs(const Edges& edges, std::size_t from, std::size_t to);

  // The boxes around all edges are.
  [[nodiscard]] bool apart(const Runs& other) const {
    return disjoint(x_, other.x_) || disjoint(y_, other.y_);
  }
  [[nodiscard]] bool apart(const Edge& e) const { return disjoint(x_, e.x) || disjoint(y_, e.y); }

  // Calls `visit` with the edges that meet `e`, and where, until it returns false.
  template <typename Visit>
  bool for_each_meeting(const Edge& e, Visit visit) const {
    for (const Run& run : runs_) {
      if (disjoint(e.x, run.x) || disjoint(e.y, run.y)) continue;
      for (std::size_t i = run.from; i < run.to; ++i) {
        const auto where = edges_.meeting(e, edges_[i]);
        if (where && !visit(edges_[i], *where)) return false;
      }
    }
    return true;
  }

  // The start of `v` lies inside the rings; not on them. The edges are those of whole rings.
  [[nodiscard]] bool enclose(const Edge& v) const;

 private:
  struct Run {
    std::size_t from, to;
    Bounds x, y;
  };
  [[nodiscard]] bool is_crossed(const Edge& e, const Edge& v) const;

  const Edges& edges_;
  std::vector<Run> runs_;
  Bounds x_{0, 0}, y_{0, 0};
};

}  // namespace rtac::geometry
