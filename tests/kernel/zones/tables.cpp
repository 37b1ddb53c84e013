#include "tests/kernel/zones/tables.h"

#include <limits>

namespace rtac::kernel_test {
namespace {

constexpr std::int64_t unlimited_mm = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t wanted_mm = 10'000;  // as the compiler wants it

geometry::SnappedZone snapped(const Zone& zone) {
  geometry::SnappedZone to;
  for (const Ring& ring : zone.rings) {
    std::vector<geometry::GridPoint>& points = to.rings.emplace_back();
    for (const Place& p : ring) {
      points.push_back({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)});
    }
  }
  return to;
}
std::vector<probe_edge> edges_in(const geometry::SnappedZone& zone) {
  std::vector<probe_edge> edges;
  for (const geometry::EdgeRow& row : geometry::edge_rows(zone)) {
    edges.push_back({row.a.x_mm, row.a.y_mm, row.b.x_mm, row.b.y_mm, row.ux_q30, row.uy_q30});
  }
  return edges;
}

}  // namespace

Tabled table(const Zone& zone) {
  const geometry::SnappedZone grid = snapped(zone);
  const std::vector<probe_edge> edges = edges_in(grid);
  const auto count = static_cast<std::int32_t>(edges.size());
  Tabled to{nullptr, unlimited_mm, edges.size() * sizeof(probe_edge), count, {}};
  if (probe_has_trees() == 0) {
    to.tables = Tables(probe_tables_new(edges.data(), count, nullptr));
    return to;
  }
  const auto grown = geometry::grow_cell_tree(grid, wanted_mm);
  if (const auto* dense = std::get_if<geometry::TooDense>(&grown)) {
    to.dense = *dense;
    return to;
  }
  const auto& t = std::get<geometry::CellTree>(grown);
  const probe_tree tree{t.words.data(),
                        t.lists.data(),
                        static_cast<std::int32_t>(t.words.size()),
                        static_cast<std::int32_t>(t.lists.size()),
                        t.x_mm,
                        t.y_mm,
                        t.shift,
                        t.column,
                        t.row,
                        t.columns,
                        t.rows,
                        t.depth,
                        t.leaves};
  to.tables = Tables(probe_tables_new(edges.data(), count, &tree));
  if (t.exact_mm) to.horizon_mm = *t.exact_mm;
  to.bytes += t.bytes();
  to.edges_most = t.edges_most;
  return to;
}

Tables tables_of(const Zone& zone) {
  return table(zone).tables;
}

}  // namespace rtac::kernel_test
