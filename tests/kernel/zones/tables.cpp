#include "tests/kernel/zones/tables.h"

#include <limits>

#include "compiler/geometry/bake.h"

namespace rtac::kernel_test {

Tables tables_of(const Zone& zone) {
  geometry::SnappedZone snapped;
  for (const Ring& ring : zone.rings) {
    std::vector<geometry::GridPoint>& to = snapped.rings.emplace_back();
    for (const Place& p : ring) {
      to.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
    }
  }
  std::vector<probe_edge> edges;
  for (const geometry::EdgeRow& row : geometry::edge_rows(snapped)) {
    edges.push_back({row.a.x_mm, row.a.y_mm, row.b.x_mm, row.b.y_mm, row.ux_q30, row.uy_q30});
  }
  return Tables(probe_tables_new(edges.data(), static_cast<std::int32_t>(edges.size())));
}

// All edges are looked at.
std::int64_t horizon_mm(const Tables&) {
  return std::numeric_limits<std::int64_t>::max();
}

}  // namespace rtac::kernel_test
