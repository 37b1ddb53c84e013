// An answer is found once for a question that is asked again, and anew for every other one.
#include "compiler/geometry/kept.h"

#include <gtest/gtest.h>

namespace rtac::geometry::test {
namespace {

TEST(Kept, FindsEachAnswerOnceAmongTheLastOnes) {
  Kept<int, int> kept;
  int found = 0;
  const auto ask = [&](int question) {
    return kept.find(question, [&] { return ++found, 2 * question; });
  };
  for (int round = 0; round < 3; ++round) {
    for (int question = 0; question < 12; ++question) EXPECT_EQ(ask(question), 2 * question);
  }
  EXPECT_EQ(found, 12);
  EXPECT_EQ(ask(12), 24);  // the oldest one is forgotten
  EXPECT_EQ(ask(0), 0);
  EXPECT_EQ(found, 14);
  // but not what has been asked again since
  EXPECT_EQ(ask(2), 4);
  EXPECT_EQ(ask(20), 40);
  EXPECT_EQ(ask(2), 4);
  EXPECT_EQ(found, 15);
}

// So that what is tried hangs on nothing that was asked before.
TEST(Kept, TakesAsMuchForAnAnswerThatItKnows) {
  Kept<int, int> kept;
  const auto taken = [&] {
    const std::int64_t before = looks();
    kept.find(1, [] { return looks() += 70, 2; });
    return looks() - before;
  };
  EXPECT_EQ(taken(), 70);
  EXPECT_EQ(taken(), 70);
}

// Whatever the search looks at tells questions apart.
TEST(Kept, TellsZonesApart) {
  const std::vector<EdgeRow> edges{{{0, 0}, {1000, 0}}, {{1000, 0}, {0, 1000}}};
  CellGrid cells;
  cells.columns = cells.rows = 2;
  cells.clearance_mm_lo = {0, 1, 2, 3};
  const Drawn drawn(edges, cells);
  EXPECT_EQ(drawn, Drawn(edges, cells));
  std::vector<EdgeRow> moved = edges;
  moved[1].b.y_mm = 999;
  EXPECT_NE(drawn, Drawn(moved, cells));
  CellGrid nearer = cells, wider = cells;
  nearer.clearance_mm_lo[3] = 2;
  wider.cell_mm = 200;
  EXPECT_NE(drawn, Drawn(edges, nearer));
  EXPECT_NE(drawn, Drawn(edges, wider));
}

}  // namespace
}  // namespace rtac::geometry::test
