#include "compiler/geometry/alike.h"

#include <algorithm>
#include <utility>

#include "compiler/geometry/numbers.h"

namespace rtac::geometry {

namespace {

// Numbers of pairs of numbers.
std::vector<int> pairs_of(const std::vector<int>& some, const std::vector<int>& others) {
  Numbers numbers;
  std::vector<int> all;
  for (std::size_t i = 0; i < some.size(); ++i) all.push_back(numbers.of({some[i], others[i]}));
  return all;
}

}  // namespace

Alike::Alike(const CellGrid& cells, const ClearCells& clear, const ClearCells& may_be_clear,
             Connectors connectors, int around_cells, double legs_mm)
    : surroundings_(
          pairs_of(clear.numbers_around(around_cells), may_be_clear.numbers_around(around_cells))),
      looked_at_(
          static_cast<std::int64_t>(surroundings_.size()) *
          (std::min(2 * around_cells, cells.columns) + std::min(2 * around_cells, cells.rows))) {
  const int legs = static_cast<int>(legs_mm / cells.cell_mm) + 1;
  Numbers numbers;
  for (int r = 0; r < cells.rows; ++r) {
    for (int c = 0; c < cells.columns; ++c) {
      const auto cell = static_cast<std::size_t>(r * cells.columns + c);
      kinds_.push_back(-1);
      if (cells.clearance_mm_lo[cell] < 0) continue;
      std::vector<std::int32_t> key{surroundings_[cell]};
      if (!clear.all(c - legs, r - legs, c + legs, r + legs)) {
        const double size_mm = cells.cell_mm;
        (void)connectors.look_around(cells.origin.x_mm + c * size_mm,
                                     cells.origin.y_mm + r * size_mm, size_mm, legs_mm);
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
