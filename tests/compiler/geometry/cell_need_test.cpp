// What a tree of cells needs at least is never more than what it takes, or an outline would be
// refused that has one; and not much less where long edges lie side by side.
#include "compiler/geometry/cell_need.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace rtac::geometry {
namespace {

using Edges = std::vector<PreparedEdge>;

PreparedEdge edge(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
  const std::int64_t dx = bx - ax, dy = by - ay;
  return {ax, ay, bx, by, dx, dy, dx * dx + dy * dy, false, false};
}
std::vector<std::uint32_t> all_of(const Edges& edges) {
  std::vector<std::uint32_t> all(edges.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

struct Divided {
  std::size_t cells = 0, divisions = 0;
  bool overfull = false;  // cells of 1 mm still have too many
};
// As long as a cell has more than `edges_max` edges and is wider than 1 mm.
void divide(const Square& square, const Edges& edges, const std::vector<std::uint32_t>& near,
            std::size_t edges_max, Divided& to) {
  std::vector<std::uint32_t> met;
  std::ranges::copy_if(near, std::back_inserter(met),
                       [&](std::uint32_t e) { return meets_closed(square, edges[e]); });
  if (met.size() <= edges_max || square.side_mm < 4) {
    ++to.cells;
    to.overfull = to.overfull || met.size() > edges_max;
    return;
  }
  ++to.divisions;
  const std::int64_t part_mm = square.side_mm / 4;
  for (std::int64_t i = 0; i < 16; ++i) {
    const Square part{square.x_mm + i % 4 * part_mm, square.y_mm + i / 4 * part_mm, part_mm};
    divide(part, edges, met, edges_max, to);
  }
}

TEST(CellNeed, IsNeverMoreThanDividingTakes) {
  std::mt19937 random(5);
  const auto in = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  int compared = 0;
  for (int round = 0; round < 300; ++round) {
    const Square square{in(-500, 500), in(-500, 500), std::int64_t{1} << 2 * in(2, 5)};
    const auto side = static_cast<int>(square.side_mm);
    Edges edges;
    for (int n = in(1, 150); n > 0; --n) {
      const auto x = square.x_mm + in(-side, 2 * side), y = square.y_mm + in(-side, 2 * side);
      const PreparedEdge e = edge(x, y, x + in(-side, side), y + in(-side / 8, side / 8));
      if (e.squared_length > 0) edges.push_back(e);
    }
    for (const std::size_t edges_max : {3U, 8U, 16U}) {
      Divided taken;
      divide(square, edges, all_of(edges), edges_max, taken);
      if (taken.overfull) continue;
      ++compared;
      const Met met = met_by(square, edges, all_of(edges));
      const double due = cells_due(square, met, edges_max);
      EXPECT_LE(due, static_cast<double>(taken.cells)) << round;
      EXPECT_LE(divisions_due(due, 1), taken.divisions) << round;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(CellNeed, GrowsWithTheSquareOfTheLengthInASquare) {
  const Square square{0, 0, 1024};
  Edges edges;
  for (int y = 0; y < 1024; y += 2) edges.push_back(edge(-100, y, 2000, y));
  const Met met = met_by(square, edges, all_of(edges));
  EXPECT_EQ(met.edges, 512U);
  EXPECT_NEAR(met.length_mm, 512 * 1024, 1);
  const double due = cells_due(square, met, 9);  // (512 / (9 sqrt(2)))^2
  EXPECT_NEAR(due, 1618, 1);
  Divided taken;  // cells of 16 mm meet nine
  divide(square, edges, all_of(edges), 9, taken);
  EXPECT_EQ(taken.cells, 64U * 64U);
}

TEST(CellNeed, CountsShortEdges) {
  Edges edges;
  for (int i = 0; i < 100; ++i) edges.push_back(edge(i, 5, i, 6));
  const Met met = met_by({0, 0, 1024}, edges, all_of(edges));
  EXPECT_NEAR(cells_due({0, 0, 1024}, met, 16), 100.0 / 16, 0.01);
  EXPECT_EQ(divisions_due(100.0 / 16, 1), 1U);
  EXPECT_EQ(divisions_due(1, 1), 0U);
  EXPECT_EQ(divisions_due(18, 2), 2U);
}

}  // namespace
}  // namespace rtac::geometry
