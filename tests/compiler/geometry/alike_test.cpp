// What cells of one kind have in common, and what robots leave over, found once more step by step.
#include "compiler/geometry/alike.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "compiler/geometry/clearings.h"
#include "rooms.h"
#include "testing.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t clearance_mm = 200, body_mm = 100;
constexpr int around_cells = 9;
constexpr double legs_mm = 700;

struct Sorted {
  BakedZone zone;
  ClearCells clear;
  Alike alike;
  explicit Sorted(const Region& region)
      : zone(bake(*snap_inside(region), 100)),
        clear(zone.cells, clearance_mm),
        alike(zone.cells, clear, clear, Connectors(zone.edges, clearance_mm, body_mm), around_cells,
              legs_mm) {}
  [[nodiscard]] int count() const { return zone.cells.columns * zone.cells.rows; }
  [[nodiscard]] int column(int cell) const { return cell % zone.cells.columns; }
  [[nodiscard]] int row(int cell) const { return cell / zone.cells.columns; }
  // Of a place off the middle of a cell, as far as it is asked for.
  [[nodiscard]] double gap(int cell, double x, double y) const {
    const double px = zone.cells.origin.x_mm + 100 * column(cell) + 50 + x;
    const double py = zone.cells.origin.y_mm + 100 * row(cell) + 50 + y;
    double least = clearance_mm;
    for (const EdgeRow& e : zone.edges) {
      const double dx = e.b.x_mm - e.a.x_mm, dy = e.b.y_mm - e.a.y_mm;
      const double along =
          std::clamp(((px - e.a.x_mm) * dx + (py - e.a.y_mm) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
      least = std::min(least, std::hypot(e.a.x_mm + along * dx - px, e.a.y_mm + along * dy - py));
    }
    return least;
  }
};

void expect_alike(const Sorted& s, int a, int b) {
  for (int r = -around_cells; r <= around_cells; ++r) {
    for (int c = -around_cells; c <= around_cells; ++c) {
      ASSERT_EQ(s.clear.at(s.column(a) + c, s.row(a) + r),
                s.clear.at(s.column(b) + c, s.row(b) + r));
    }
  }
  constexpr int legs = static_cast<int>(legs_mm) / 100 + 1;
  const int c = s.column(a), r = s.row(a);
  if (s.clear.all(c - legs, r - legs, c + legs, r + legs)) return;
  for (double y = -legs_mm; y <= legs_mm; y += 70) {
    for (double x = -legs_mm; x <= legs_mm; x += 70) {
      if (std::hypot(x, y) > legs_mm) continue;
      ASSERT_NEAR(s.gap(a, x, y), s.gap(b, x, y), 1e-6) << x << ", " << y;
    }
  }
}

TEST(Alike, CellsOfOneKindHaveTheSameAround) {
  std::mt19937 random(31);
  int pairs = 0;
  for (int i = 0; i < rooms_count() / 2; ++i) {
    const Sorted s(random_room(random));
    std::vector<int> of_kind(s.alike.kinds(), -1);
    for (int cell = 0; cell < s.count(); ++cell) {
      if (s.alike.kind(cell) < 0) continue;
      int& first = of_kind[static_cast<std::size_t>(s.alike.kind(cell))];
      if (first >= 0 && ++pairs % 7 == 0) expect_alike(s, first, cell);
      if (HasFatalFailure()) FAIL() << "room " << i << ", cells " << first << " and " << cell;
      EXPECT_TRUE(first < 0 || !s.alike.is_single(cell));
      first = cell;
    }
  }
  EXPECT_GT(pairs, 1000);
}
// Along walls of a hall all cells look alike, and of its middle all do.
TEST(Alike, OfALongHallFewCellsDiffer) {
  const auto kinds = [](const Region& hall) {
    const Sorted s(hall);
    std::set<int> all;
    for (int cell = 0; cell < s.count(); ++cell) all.insert(s.alike.kind(cell));
    return all.size();
  };
  const std::size_t most = kinds(box(0, 0, 6000, 6000));
  EXPECT_EQ(kinds(box(0, 0, 18'000, 12'000)), most);
  // but for those around a notch
  const Region notch = polygon({mm(9200, 11'990), mm(9300, 11'990), mm(9260, 12'030)});
  EXPECT_GT(kinds(box(0, 0, 18'000, 12'000).unite(notch)), most + 20);
}

// A robot in a cell of a block of clear ones leaves another one: from some cell near it a way of
// steps recedes to where it ends.
class Block {
 public:
  Block(int columns, int rows) : columns_(columns), rows_(rows) {
    cells_.columns = columns, cells_.rows = rows;
    cells_.clearance_mm_lo.assign(static_cast<std::size_t>(columns * rows), clearance_mm);
  }
  [[nodiscard]] ClearCells clear() const { return {cells_, clearance_mm}; }
  [[nodiscard]] bool leaves(Step one, Step other) const {
    const Box here{middle(one), half}, there{middle(other), half};
    if (!leads(one, there) && !comes_nearer(middle(one), here, there)) return false;
    for (int r = 0; r < rows_; ++r) {
      for (int c = 0; c < columns_; ++c) {
        const Vec to = middle({c, r});
        if (std::hypot(to.x - here.middle.x, to.y - here.middle.y) > reach_mm) continue;
        if (recedes(to, here, there) && leads({c, r}, there)) return true;
      }
    }
    return false;
  }
  static constexpr double half = 50, reach_mm = 400, goal_mm = 900;

 private:
  static Vec middle(Step s) { return {100.0 * s.columns, 100.0 * s.rows}; }
  [[nodiscard]] bool leads(Step from, const Box& other) const {
    if (is_beyond(middle(from), other, goal_mm)) return true;
    return std::any_of(steps.begin(), steps.end(), [&](Step s) {
      const Step to{from.columns + s.columns, from.rows + s.rows};
      return to.columns >= 0 && to.rows >= 0 && to.columns < columns_ && to.rows < rows_ &&
             recedes(middle(to), {middle(from), 0}, other) && leads(to, other);
    });
  }
  int columns_, rows_;
  CellGrid cells_;
};
TEST(Clearings, AreOnlyThoseThatWaysLeadOver) {
  const Clearings clearings(100, Block::goal_mm, Block::reach_mm);
  int found = 0;
  for (const auto& [columns, rows] : {std::pair{14, 1}, {1, 14}, {12, 12}, {11, 7}, {9, 9}}) {
    const Block block(columns, rows);
    const ClearCells clear = block.clear();
    for (int cell = 0; cell < columns * rows; ++cell) {
      const Step one{cell % columns, cell / columns};
      const auto open = clearings.clear_from(clear, one.columns, one.rows);
      for (int r = -7; r <= 7 && open != 0; ++r) {
        for (int c = -7; c <= 7; ++c) {
          if ((open & clearings.that_do({c, r})) == 0) continue;
          ++found;
          EXPECT_TRUE(block.leaves(one, {one.columns + c, one.rows + r}))
              << columns << " x " << rows << ": " << one.columns << ", " << one.rows << " from "
              << c << ", " << r;
        }
      }
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace rtac::geometry
