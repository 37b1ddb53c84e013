// What the recheck takes for the same at several places of a zone, and over what it lets robots
// leave, found once more step by step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "compiler/recheck/legs.h"
#include "compiler/recheck/open_sides.h"
#include "compiler/recheck/squares.h"
#include "tests/compiler/geometry/rooms.h"

namespace rtac::recheck {
namespace {

TEST(Squares, HaveOneNumberWhereTheyAreTheSame) {
  constexpr int columns = 37, rows = 29;
  std::vector<bool> clear(std::size_t{columns} * rows, true);
  for (const std::size_t hole : {150U, 158U, 700U, 708U, 1000U}) clear[hole] = false;
  for (const int off : {0, 1, 2, 3, 5, 8}) {
    const auto around = [&](int cell) {
      std::vector<bool> all;
      for (int r = cell / columns - off; r <= cell / columns + off; ++r) {
        for (int c = cell % columns - off; c <= cell % columns + off; ++c) {
          const bool in = c >= 0 && r >= 0 && c < columns && r < rows;
          all.push_back(in && clear[static_cast<std::size_t>(r * columns + c)]);
        }
      }
      return all;
    };
    const std::vector<int> numbers = number_squares(clear, columns, rows, off);
    std::map<std::vector<bool>, int> known;
    std::map<int, std::vector<bool>> squares;
    for (int cell = 0; cell < columns * rows; ++cell) {
      const int number = numbers[static_cast<std::size_t>(cell)];
      EXPECT_EQ(known.try_emplace(around(cell), number).first->second, number) << off;
      EXPECT_EQ(squares.try_emplace(number, around(cell)).first->second, around(cell)) << off;
    }
  }
}

double gap(const std::vector<Segment>& all, Place p) {
  double least = 1e300;
  for (const Segment& s : all) least = std::min(least, std::sqrt(square_to(s, p.x, p.y)));
  return least;
}
TEST(Outlines, AreTheSameWhereAllIsAsFar) {
  constexpr double within = 1.2, looked_at = 0.8, most = within - looked_at;
  std::mt19937 random(37);
  int pairs = 0;
  for (int i = 0; i < geometry::rooms_count() / 2; ++i) {
    const std::vector<Segment> all = segments_of(geometry::random_room(random));
    std::map<std::vector<std::array<std::int64_t, 4>>, Place> known;
    for (double y = 0.05; y < 7; y += 0.1) {
      for (double x = 0.05; x < 8; x += 0.1) {
        const auto [same, is_new] =
            known.try_emplace(Boundary(all, {x, y}, within).outline(), Place{x, y});
        if (is_new || ++pairs % 5 != 0) continue;
        for (double a = 0; a < 6; a += 0.5) {
          for (const double r : {0.3, looked_at}) {
            const Place off{r * std::cos(a), r * std::sin(a)};
            const Place p{x + off.x, y + off.y};
            const Place q{same->second.x + off.x, same->second.y + off.y};
            ASSERT_NEAR(std::min(gap(all, p), most), std::min(gap(all, q), most), 1e-6)
                << "room " << i << ": " << x << ", " << y;
          }
        }
        same->second = {x, y};
      }
    }
  }
  EXPECT_GT(pairs, 1000);
}

// Of a block of clear cells, with one robot in one of them: steps from one near it recede to where
// a way ends.
struct Clear {
  int columns, rows;
  static constexpr double cell = 0.1, joins = 0.4 + slack_m, goal = 0.9;

  static Place middle(int c, int r) { return {(c + 0.5) * cell, (r + 0.5) * cell}; }
  static Box box(int c, int r) { return {c * cell, r * cell, (c + 1) * cell, (r + 1) * cell}; }
  static Box at(Place p) { return {p.x, p.y, p.x, p.y}; }
  [[nodiscard]] bool has(int c, int r) const { return c >= 0 && r >= 0 && c < columns && r < rows; }
  [[nodiscard]] bool leads(int c, int r, const Box& other) const {
    if (nearest(at(middle(c, r)), other) >= goal) return true;
    for (int i = 0; i < 9; ++i) {
      const int x = c + i % 3 - 1, y = r + i / 3 - 1;
      if (i == 4 || !has(x, y) || !recedes(middle(x, y), at(middle(c, r)), other)) continue;
      if (leads(x, y, other)) return true;
    }
    return false;
  }
  [[nodiscard]] bool leaves(int c, int r, const Box& other) const {
    const Place own = middle(c, r);
    if (!leads(c, r, other) && !comes_nearer(own, box(c, r), other)) return false;
    for (int i = 0; i < columns * rows; ++i) {
      const Place to = middle(i % columns, i / columns);
      if (length(to.x - own.x, to.y - own.y) > joins || !recedes(to, box(c, r), other)) continue;
      if (leads(i % columns, i / columns, other)) return true;
    }
    return false;
  }
  [[nodiscard]] OpenSides::Set open(const OpenSides& sides, int c, int r) const {
    OpenSides::Set all;
    for (std::size_t i = 0; i < OpenSides::count; ++i) {
      const Block& b = sides.blocks()[i];
      all[i] = has(c + b.west, r + b.south) && has(c + b.east, r + b.north);
    }
    return all;
  }
};
TEST(OpenSides, AreOnlyThoseThatWaysLeadOver) {
  const OpenSides sides(Clear::cell, Clear::goal, Clear::joins);
  int found = 0;
  for (const Clear& clear : {Clear{14, 1}, {1, 14}, {12, 12}, {13, 7}}) {
    for (int i = 0; i < clear.columns * clear.rows; ++i) {
      const int c = i % clear.columns, r = i / clear.columns;
      const OpenSides::Set open = clear.open(sides, c, r);
      for (int off = 0; off < 225 && open.any(); ++off) {
        const int x = off % 15 - 7, y = off / 15 - 7;
        if ((open & sides.against(x, y)).none()) continue;
        ++found;
        EXPECT_TRUE(clear.leaves(c, r, Clear::box(c + x, r + y)))
            << clear.columns << " x " << clear.rows << ": " << c << ", " << r << " from " << x
            << ", " << y;
      }
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace rtac::recheck
