#include "compiler/geometry/clear_cells.h"

#include <algorithm>

#include "compiler/geometry/numbers.h"

namespace rtac::geometry {
namespace {

// Where along a line, by the steps from one of its places, the value becomes another one, and which
// one; 0 off its ends, and taken to be so before the window.
template <class Value>
std::vector<std::int32_t> changes(int place, int count, int window, const Value& value) {
  std::vector<std::int32_t> all;
  std::int32_t last = 0;
  for (int at = std::max(place - window, 0); at <= std::min(place + window, count); ++at) {
    const std::int32_t here = at < count ? value(at) : 0;
    if (here != last) all.insert(all.end(), {at - place, here});
    last = here;
  }
  return all;
}

}  // namespace

ClearCells::ClearCells(const CellGrid& cells, std::int32_t clearance_mm)
    : columns_(cells.columns),
      rows_(cells.rows),
      not_clear_(static_cast<std::size_t>((columns_ + 1) * (rows_ + 1)), 0) {
  for (const std::int32_t mm : cells.clearance_mm_lo) {
    clear_.push_back(mm >= 0 && mm >= clearance_mm);
  }
  for (int r = 0; r < rows_; ++r) {
    std::int32_t of_row = 0;
    for (int c = 0; c < columns_; ++c) {
      of_row += at(c, r) ? 0 : 1;
      sum(c + 1, r + 1) = sum(c + 1, r) + of_row;
    }
  }
}

bool ClearCells::all(int west, int south, int east, int north) const {
  if (west < 0 || south < 0 || east >= columns_ || north >= rows_) return false;
  return sum(east + 1, north + 1) - sum(west, north + 1) - sum(east + 1, south) +
             sum(west, south) ==
         0;
}

// The windows of a row are numbered first, and then the columns of these numbers.
std::vector<int> ClearCells::numbers_around(int window) const {
  const auto number_all = [&](const auto& key) {
    Numbers numbers;
    numbers.of({});  // 0: nothing is clear
    std::vector<int> all;
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c) all.push_back(numbers.of(key(c, r)));
    }
    return all;
  };
  const std::vector<int> of_rows = number_all([&](int column, int row) {
    return changes(column, columns_, window, [&](int c) { return at(c, row) ? 1 : 0; });
  });
  return number_all([&](int column, int row) {
    return changes(row, rows_, window,
                   [&](int r) { return of_rows[static_cast<std::size_t>(r * columns_ + column)]; });
  });
}

}  // namespace rtac::geometry
