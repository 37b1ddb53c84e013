// A zone that is received becomes the tables, number for number, that the same zone of a
// specification has.
#include <gtest/gtest.h>

#include "compiler/analysis/zones.h"
#include "tests/differential/engines.h"

namespace rtac::geometry {
namespace {

ZoneTables tables(const std::string& wkt, std::size_t edges_most) {
  auto received = receive_wkt(wkt, edges_most);
  auto made = make_zone_tables(std::get<ReceivedRegions>(received), edges_most);
  return std::get<ZoneTables>(std::move(made));
}
void expect_same(const std::vector<EdgeRow>& a, const CellTree& tree_a,
                 const std::vector<EdgeRow>& b, const CellTree& tree_b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].a == b[i].a && a[i].b == b[i].b && a[i].ux_q30 == b[i].ux_q30 &&
                a[i].uy_q30 == b[i].uy_q30);
  }
  EXPECT_EQ(tree_a.words, tree_b.words);
  EXPECT_EQ(tree_a.lists, tree_b.lists);
  EXPECT_EQ(tree_a.shift, tree_b.shift);
  EXPECT_EQ(tree_a.leaves, tree_b.leaves);
}

// On the grid and off it, with a hole, with a coordinate that is a whole number of no unit at all.
TEST(ReceiveZone, BecomesTheTablesOfTheSameZoneOfASpecification) {
  struct Case {
    const char *literal, *wkt;
  };
  for (const Case& c : {Case{"polygon [(0 m, 0 m), (10 m, 0 m), (10 m, 7.25 m), (1.1 m, 9 m)] hole "
                             "[(2 m, 2 m), (4 m, 2 m), (3 m, 4 m)]",
                             "POLYGON ((0 0, 10 0, 10 7.25, 1.1 9, 0 0), (2 2, 4 2, 3 4, 2 2))"},
                        Case{"polygon [(0.0004 m, 0 m), (4.0003 m, 1.0007 m), (1 m, 3.0005 m)]",
                             "POLYGON ((0.0004 0, 4.0003 1.0007, 1 3.0005, 0.0004 0))"}}) {
    const auto checked =
        differential::check(std::string("spec s;\nperiod 1 s;\nzone z = ") + c.literal +
                                ";\ninput p : point;\nmonitor m { \"R\" always p inside z; }\n",
                            differential::Until::checked);
    ASSERT_EQ(checked->problem, "");
    diag::Engine diagnostics;
    const auto zones =
        analysis::evaluate_zones(*checked->compilation.spec,
                                 std::vector<analysis::ZoneUse>(1, {false, true}), diagnostics)
            .zones;
    const ZoneTables made = tables(c.wkt, 64);
    ASSERT_TRUE(zones[0]);
    expect_same(made.within.edges, made.within.tree, zones[0]->baked.edges, zones[0]->tree);
    const OutlineTable& around = made.around ? *made.around : made.within;
    expect_same(around.edges, around.tree, zones[0]->around, zones[0]->around_tree);
  }
}

}  // namespace
}  // namespace rtac::geometry
