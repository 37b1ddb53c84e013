// A baked zone as controllers see it.
#pragma once

#include <vector>

#include "compiler/geometry/bake.h"
#include "rtac/zone.h"

namespace rtac::geometry {

// The view that generated code gives the controllers.
class View {
 public:
  explicit View(const BakedZone& zone) {
    for (const EdgeRow& e : zone.edges) {
      edges_.insert(edges_.end(), {e.a.x_mm, e.a.y_mm, e.b.x_mm, e.b.y_mm});
    }
    view_.edges_mm = edges_.data();
    view_.edge_count = zone.edges.size();
    view_.origin_x_mm = zone.cells.origin.x_mm;
    view_.origin_y_mm = zone.cells.origin.y_mm;
    view_.cell_mm = zone.cells.cell_mm;
    view_.columns = zone.cells.columns;
    view_.rows = zone.cells.rows;
    view_.clearance_mm_lo = zone.cells.clearance_mm_lo.data();
  }
  [[nodiscard]] const ZoneView& operator*() const { return view_; }

 private:
  std::vector<std::int32_t> edges_;
  ZoneView view_;
};

}  // namespace rtac::geometry
