// Trees of cells, against all edges: the nearest edge of a place is one of its cell's, the corner
// of a cell is inside as even-odd says, distant cells are as far away as they claim, and a tree
// keeps to 16 edges a cell and to its bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compiler/geometry/cell_tree.h"

namespace rtac::geometry {
namespace {

struct Place {
  double x, y;
};

std::vector<EdgeRow> edges_of(const SnappedZone& zone) {
  return edge_rows(zone);
}
double distance(const Place& p, const EdgeRow& e) {
  const double dx = e.b.x_mm - double(e.a.x_mm), dy = e.b.y_mm - double(e.a.y_mm);
  const double t = ((p.x - e.a.x_mm) * dx + (p.y - e.a.y_mm) * dy) / (dx * dx + dy * dy);
  const double at = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - e.a.x_mm - at * dx, p.y - e.a.y_mm - at * dy);
}
// Rays to the west; of places off the boundary.
bool is_inside(const Place& p, const std::vector<EdgeRow>& edges) {
  bool inside = false;
  for (const EdgeRow& e : edges) {
    if ((e.a.y_mm > p.y) == (e.b.y_mm > p.y)) continue;
    const double x =
        e.a.x_mm + (p.y - e.a.y_mm) / (double(e.b.y_mm) - e.a.y_mm) * (double(e.b.x_mm) - e.a.x_mm);
    if (x < p.x) inside = !inside;
  }
  return inside;
}

struct Cell {
  std::uint32_t word;
  double x, y, width;
};
Cell cell_at(const CellTree& tree, const Place& p) {
  const auto x = static_cast<std::int64_t>(std::floor(p.x)) - tree.x_mm;
  const auto y = static_cast<std::int64_t>(std::floor(p.y)) - tree.y_mm;
  int shift = tree.shift;
  const std::int64_t column = (x >> shift) - tree.column, row = (y >> shift) - tree.row;
  auto at = static_cast<std::size_t>(row * tree.columns + column);
  if (column < 0 || row < 0 || column >= tree.columns || row >= tree.rows) {
    shift = 32;
    at = static_cast<std::size_t>(tree.columns) * static_cast<std::size_t>(tree.rows);
  }
  int steps = 0;
  while (tree.words[at] >> 30 == 3) {
    shift -= 2;
    at = (tree.words[at] & 0x3fffffff) +
         static_cast<std::size_t>((y >> shift & 3) * 4 + (x >> shift & 3));
    EXPECT_LE(++steps, tree.depth);
  }
  return {tree.words[at], double((x >> shift << shift) + tree.x_mm),
          double((y >> shift << shift) + tree.y_mm), std::ldexp(1.0, shift)};
}
bool is_met(std::uint32_t word) {
  return (word >> 28 & 1) != 0;
}
bool is_far(std::uint32_t word) {
  return word >> 30 == 0 && !is_met(word);
}
bool tells_by_sides(std::uint32_t word) {
  return word >> 30 == 0 && is_met(word);
}
std::vector<std::uint32_t> edges_in(const CellTree& tree, std::uint32_t word) {
  std::vector<std::uint32_t> edges;
  if (is_far(word)) return edges;
  const std::uint32_t most = tells_by_sides(word) ? 4 : 16, place = tells_by_sides(word) ? 23 : 24;
  for (std::uint32_t i = 0; i <= (word >> 24 & (most - 1)); ++i) {
    const std::uint32_t at = (word & ((1U << place) - 1)) + i;
    edges.push_back(word >> 30 == 2 ? tree.lists[at] : at);
  }
  return edges;
}

class Trees {
 public:
  explicit Trees(SnappedZone zone, std::int64_t wanted_mm = 50'000) : edges_(edges_of(zone)) {
    auto grown = grow_cell_tree(zone, wanted_mm);
    EXPECT_TRUE(std::holds_alternative<CellTree>(grown));
    if (auto* tree = std::get_if<CellTree>(&grown)) tree_ = *tree;
  }
  [[nodiscard]] const CellTree& tree() const { return tree_; }
  [[nodiscard]] const std::vector<EdgeRow>& edges() const { return edges_; }

  void check_bounds() const {
    EXPECT_LE(tree_.edges_most, 16);
    EXPECT_LE(tree_.bytes() + 24 * edges_.size(), 64 * edges_.size() + 65536);
  }
  void check(const Place& p) const {
    const Cell cell = cell_at(tree_, p);
    double nearest = INFINITY, in_cell = INFINITY;
    for (const EdgeRow& e : edges_) nearest = std::min(nearest, distance(p, e));
    for (const std::uint32_t e : edges_in(tree_, cell.word)) {
      in_cell = std::min(in_cell, distance(p, edges_[e]));
    }
    if (is_far(cell.word)) {
      EXPECT_LE(cell.word & 0xfffffff, nearest + 1e-6) << p.x << ", " << p.y;
      if (cell.width > 1) {
        EXPECT_GE(nearest + 1, tree_.exact_mm.value_or(INT32_MAX));
      }
    } else {
      EXPECT_NEAR(in_cell, nearest, 1e-6 * (1 + nearest)) << p.x << ", " << p.y;
    }
    // where no edge passes, the corner speaks for the whole cell
    if ((cell.word >> 28 & 1) == 0 && nearest > 1e-3) {
      EXPECT_EQ(cell.word >> 29 & 1, is_inside(p, edges_) ? 1U : 0U) << p.x << ", " << p.y;
    }
    if (tells_by_sides(cell.word) && nearest > 1e-3) {
      EXPECT_EQ(inside_by_sides(p, cell.word), is_inside(p, edges_)) << p.x << ", " << p.y;
    }
    const bool in_grid = cell.width <= std::ldexp(1.0, tree_.shift);
    const Place corner{cell.x + 1e-7, cell.y + 1e-5};
    double from_corner = INFINITY;
    for (const EdgeRow& e : edges_) from_corner = std::min(from_corner, distance(corner, e));
    if (in_grid && from_corner > 1e-3 && !tells_by_sides(cell.word)) {
      EXPECT_EQ(cell.word >> 29 & 1, is_inside(corner, edges_) ? 1U : 0U)
          << cell.x << ", " << cell.y;
    }
  }
  [[nodiscard]] bool inside_by_sides(const Place& p, std::uint32_t word) const {
    const auto left = [&](const EdgeRow& e) {
      return double(e.b.x_mm - e.a.x_mm) * (p.y - e.a.y_mm) >
             double(e.b.y_mm - e.a.y_mm) * (p.x - e.a.x_mm);
    };
    const std::size_t at = (word & 0x7fffff) + (word >> 26 & 3);
    const bool first = left(edges_[at]), second = left(edges_[at + (word >> 23 & 1)]);
    return (word >> 29 & 1) != 0 ? first || second : first && second;
  }
  void check_places(int count) const {
    std::mt19937 random(3);
    const auto below = [&](double most) {
      return std::uniform_real_distribution<>(0, most)(random);
    };
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    for (const EdgeRow& e : edges_) {
      x0 = std::min<double>(x0, e.a.x_mm);
      x1 = std::max<double>(x1, e.a.x_mm);
      y0 = std::min<double>(y0, e.a.y_mm);
      y1 = std::max<double>(y1, e.a.y_mm);
    }
    for (int i = 0; i < count; ++i) {
      const EdgeRow& e = edges_[random() % edges_.size()];
      check({x0 - 50 + below(x1 - x0 + 100), y0 - 50 + below(y1 - y0 + 100)});
      check({e.a.x_mm + below(20) - 10, e.a.y_mm + below(20) - 10});
      check({double(e.a.x_mm), double(e.a.y_mm)});
      check({below(1.3e9) - 6.5e8, below(1.3e9) - 6.5e8});
    }
  }

 private:
  std::vector<EdgeRow> edges_;
  CellTree tree_;
};

GridPoint at(double x, double y) {
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}
// Between the two radii, seen from the centre in every direction once.
std::vector<GridPoint> star(int corners, double from, double to, double x = 0, double y = 0) {
  std::mt19937 random(11);
  std::vector<GridPoint> ring;
  for (int i = 0; i < corners; ++i) {
    const double r = std::uniform_real_distribution<>(from, to)(random);
    const double angle = 2 * M_PI * i / corners;
    ring.push_back(at(x + r * std::cos(angle), y + r * std::sin(angle)));
  }
  return ring;
}
std::vector<GridPoint> reversed(std::vector<GridPoint> ring) {
  return {ring.rbegin(), ring.rend()};
}

TEST(CellTree, OfAFewEdgesIsOneCellAndItsSurroundings) {
  const Trees t({{{{0, 0}, {5000, 0}, {5000, 4000}, {0, 4000}}}});
  EXPECT_EQ(t.tree().edges_most, 4);
  EXPECT_LE(t.tree().words.size(), 5U);
  EXPECT_FALSE(t.tree().exact_mm);
  t.check_places(200);
}
TEST(CellTree, HoldsTheNearestEdgeOfEveryPlace) {
  for (const auto& zone :
       {SnappedZone{{star(60, 3000, 8000)}}, SnappedZone{{star(300, 90'000, 95'000)}},
        SnappedZone{{star(200, 50'000, 60'000), reversed(star(100, 9000, 20'000))}}}) {
    const Trees t(zone);
    t.check_bounds();
    t.check_places(1500);
  }
}
TEST(CellTree, OfTinyAndHugeZones) {
  const Trees tiny({{star(40, 15, 40)}});
  tiny.check_bounds();
  tiny.check_places(1500);
  const Trees huge({{star(500, 4.5e8, 5.36e8)}});
  huge.check_bounds();
  huge.check_places(1500);
  const Trees aside({{star(50, 1000, 3000, 5.3e8, -5.3e8)}});
  aside.check_places(1500);
}
TEST(CellTree, OfARoundZoneIsExactUpToADistance) {
  const Trees t({{star(2000, 500'000, 500'000.4)}});
  t.check_bounds();
  ASSERT_TRUE(t.tree().exact_mm);
  EXPECT_GE(*t.tree().exact_mm, 50'000);
  t.check_places(300);
}
TEST(CellTree, CellsHoldFewerEdgesWhereBytesAreLeft) {
  const Trees t({{star(300, 90'000, 95'000)}}, 1000);
  std::size_t cells = 0, few = 0;
  for (const std::uint32_t word : t.tree().words) {
    if (word >> 30 == 3 || is_far(word)) continue;
    ++cells;
    few += edges_in(t.tree(), word).size() <= 4 ? 1 : 0;
  }
  EXPECT_GE(few, cells * 2 / 3) << few << " of " << cells;
}
TEST(CellTree, CellsThatTheBoundaryMeetsHoldThreeEdgesWhereBytesAreLeft) {
  const Trees t({{star(300, 90'000, 95'000)}}, 1000);
  std::size_t met = 0, few = 0;
  for (const std::uint32_t word : t.tree().words) {
    if (word >> 30 == 3 || !is_met(word)) continue;
    ++met;
    few += edges_in(t.tree(), word).size() <= 3 ? 1 : 0;
  }
  EXPECT_GT(met, 300U);
  EXPECT_GE(few, met * 4 / 5) << few << " of " << met;
}
// Convex corners and reflex ones.
TEST(CellTree, SidesOfOneOrTwoEdgesTellMostCellsThatTheBoundaryMeets) {
  const Trees t({{star(300, 60'000, 95'000)}}, 1000);
  std::size_t met = 0, both = 0, either = 0;
  for (const std::uint32_t word : t.tree().words) {
    met += word >> 30 != 3 && is_met(word) ? 1 : 0;
    both += word >> 28 == 1 ? 1 : 0;
    either += word >> 28 == 3 ? 1 : 0;
  }
  EXPECT_GT(both + either, met * 4 / 5) << both << " and " << either << " of " << met;
  EXPECT_GT(either, 100U);
  t.check_places(3000);
}
// Teeth of 1 mm side by side over 5 m.
TEST(CellTree, RefusesWhatNeedsTooManyCellsAndSaysWhere) {
  std::vector<GridPoint> comb;
  for (int i = 0; i < 100; ++i) {
    comb.push_back({2 * i, 5000});
    comb.push_back({2 * i, 0});
    comb.push_back({2 * i + 1, 0});
    comb.push_back({2 * i + 1, 5000});
  }
  comb.push_back({200, 6000});
  comb.push_back({0, 6000});
  const auto grown = grow_cell_tree({{comb}}, 1000);
  ASSERT_TRUE(std::holds_alternative<TooDense>(grown));
  const TooDense& dense = std::get<TooDense>(grown);
  EXPECT_GT(dense.edges, cell_edges_max);
  EXPECT_LE(std::abs(dense.at.x_mm - 100), 200);
}

TooDense refused(const SnappedZone& zone) {
  const auto grown = grow_cell_tree(zone, 50'000);
  EXPECT_TRUE(std::holds_alternative<TooDense>(grown));
  const auto* dense = std::get_if<TooDense>(&grown);
  return dense != nullptr ? *dense : TooDense{};
}
// 800 m long and 1 mm wide, 2 mm apart. Before cells were counted ahead, 1,000 of them took 12 s.
SnappedZone slivers(int count) {
  SnappedZone zone;
  for (int i = 0; i < count; ++i) {
    zone.rings.push_back({{0, 2 * i}, {800'000, 2 * i}, {800'000, 2 * i + 1}});
  }
  return zone;
}
TEST(CellTree, RefusesLongEdgesSideBySideBeforeItDividesCells) {
  for (const int count : {100, 1000, 10'000}) {
    const TooDense dense = refused(slivers(count));
    EXPECT_LE(dense.divided, 100U) << count;
    EXPECT_GT(dense.edges, cell_edges_max);
    EXPECT_LE(dense.within_mm, 100);  // where an outline is to be mended
    EXPECT_GE(dense.at.y_mm, -100);
    EXPECT_LE(dense.at.y_mm, 2 * count + 100);
  }
}
// Their tips meet in one point, which no cell divides: the rest is not divided any further.
SnappedZone needles(int count, int length_mm) {
  SnappedZone zone;
  for (int i = 0; i < count; ++i) {
    const double a = 2 * M_PI * i / count, b = 2 * M_PI * (i + 0.5) / count;
    zone.rings.push_back({{0, 0},
                          at(length_mm * std::cos(a), length_mm * std::sin(a)),
                          at(length_mm * std::cos(b), length_mm * std::sin(b))});
  }
  return zone;
}
TEST(CellTree, EightNeedlesMeetInAPointAndNineDoNot) {
  const Trees eight(needles(8, 1000), 100);
  eight.check_bounds();
  eight.check_places(300);
  const TooDense nine = refused(needles(9, 1000));
  EXPECT_EQ(nine.edges, 18U);
  EXPECT_LE(std::abs(nine.at.x_mm) + std::abs(nine.at.y_mm), 2);
  EXPECT_LE(nine.within_mm, 4);
}
TEST(CellTree, TheWorkOfARefusalGrowsLikeTheOutline) {
  const auto divided = [](int corners) {
    return refused({{star(corners, 500'000, 1'000'000)}}).divided;
  };
  const std::size_t few = divided(4000), many = divided(16'000);
  EXPECT_LE(many, 6 * few) << few;
  EXPECT_LE(many, 16'000U);
}

}  // namespace
}  // namespace rtac::geometry
