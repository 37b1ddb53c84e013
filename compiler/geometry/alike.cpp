#include "compiler/geometry/alike.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/numbers.h"

namespace rtac::geometry {

Alike::Alike(const CellGrid& cells, const ClearCells& clear, Connectors connectors,
             int around_cells, double legs_mm)
    : surroundings_(clear.numbers_around(around_cells)),
      looked_at_(
          static_cast<std::int64_t>(surroundings_.size()) *
          (std::min(2 * around_cells, cells.columns) + std::min(2 * around_cells, cells.rows))) {
  Numbers numbers;
  for (int r = 0; r < cells.rows; ++r) {
    for (int c = 0; c < cells.columns; ++c) {
      const auto cell = static_cast<std::size_t>(r * cells.columns + c);
      kinds_.push_back(-1);
      if (cells.clearance_mm_lo[cell] < 0) continue;
      std::vector<std::int32_t> key{surroundings_[cell]};
      if (!clear.at(c, r)) {
        const double size_mm = cells.cell_mm;
        connectors.look_around(cells.origin.x_mm + c * size_mm, cells.origin.y_mm + r * size_mm,
                               size_mm, legs_mm);
        looked_at_ += connectors.looked_at();
        const std::vector<std::int32_t> edges = connectors.edges_off_corner();
        key.insert(key.end(), edges.begin(), edges.end());
      }
      const int kind = kinds_.back() = numbers.of(std::move(key));
      of_kind_.resize(std::max(of_kind_.size(), static_cast<std::size_t>(kind) + 1));
      ++of_kind_[static_cast<std::size_t>(kind)];
    }
  }
}

}  // namespace rtac::geometry
