// Zones of a specification become tables on the safe side.
#include "compiler/analysis/zones.h"

#include <cmath>

#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

const ir::ZoneTable& room_of(const driver::Compilation& c) {
  return c.module->zones[0];
}

// Distance from the centre of a hole that is a circle, as far as its edges go.
std::int64_t nearest_edge_squared(const ir::ZoneTable& zone, std::int64_t x, std::int64_t y) {
  std::int64_t best = std::int64_t{1} << 60;
  for (const ir::Edge& e : zone.edges) {
    for (int step = 0; step <= 16; ++step) {
      const std::int64_t px = e.ax + (e.bx - e.ax) * step / 16;
      const std::int64_t py = e.ay + (e.by - e.ay) * step / 16;
      best = std::min(best, (px - x) * (px - x) + (py - y) * (py - y));
    }
  }
  return best;
}

TEST(Zones, ACircleThatIsTakenAwayIsNotCutShort) {
  const auto c = compiled(
      edited(drone_spec(), "to (5 m, 5 m);", "to (5 m, 5 m) - circle (2.5 m, 2.5 m) radius 1 m;"));
  ASSERT_TRUE(c->module) << reports(*c);
  // 1 mm: the points between vertices are rounded above
  EXPECT_GE(nearest_edge_squared(room_of(*c), 2500, 2500), 999 * 999);
}

TEST(Zones, ACircleThatIsKeptIsNotExceeded) {
  const auto c = compiled(
      edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)", "circle (0 m, 0 m) radius 3 m"));
  ASSERT_TRUE(c->module) << reports(*c);
  for (const ir::Edge& e : room_of(*c).edges) {
    EXPECT_LE(std::int64_t{e.ax} * e.ax + std::int64_t{e.ay} * e.ay, 3000 * 3000);
  }
}

TEST(Zones, ASideTakenAwayTwiceIsKept) {
  // a - (b - circle): the circle counts as kept again
  const auto c = compiled(edited(
      drone_spec(), "to (5 m, 5 m);",
      "to (9 m, 5 m) - (rectangle (4 m, -1 m) to (10 m, 6 m) - circle (6 m, 2.5 m) radius 1 m);"));
  ASSERT_TRUE(c->module) << reports(*c);
  for (const ir::Edge& e : room_of(*c).edges) {
    if (e.ax <= 4000) continue;
    const std::int64_t dx = e.ax - 6000, dy = e.ay - 2500;
    EXPECT_LE(dx * dx + dy * dy, 1000 * 1000);
  }
}

TEST(Zones, OffsetsErrToTheSafeSideOnBothSides) {
  // round corners: grown zones are kept from within, shrunk ones taken away from without
  const auto grown = compiled(edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)",
                                     "grow(rectangle (1 m, 1 m) to (4 m, 4 m), 1 m)"));
  ASSERT_TRUE(grown->module) << reports(*grown);
  for (const ir::Edge& e : room_of(*grown).edges) {
    const std::int64_t dx = std::max({1000 - e.ax, e.ax - 4000, 0});
    const std::int64_t dy = std::max({1000 - e.ay, e.ay - 4000, 0});
    EXPECT_LE(dx * dx + dy * dy, 1000 * 1000) << e.ax << ", " << e.ay;
  }
}

TEST(Zones, TwoZonesWrittenOnOneLineHaveTablesOfTheirOwn) {
  const auto c = compiled(edited(drone_spec(), "clearance(d, room) >= 10 cm",
                                 "d inside grow(room, 20 cm) and d inside grow(room, 10 cm)"));
  ASSERT_TRUE(c->module) << reports(*c);
  ASSERT_EQ(c->module->zones.size(), 3u);
  EXPECT_NE(c->module->zones[1].name, c->module->zones[2].name);
  EXPECT_EQ(c->module->decisions[0].monitors[0].property.values.size(), 6u);  // not merged
}

TEST(Zones, BeyondTheGridIsNotTheSameAsTooThin) {
  EXPECT_TRUE(has(*without_offers(edited(drone_spec(), "to (5 m, 5 m)", "to (600 km, 5 m)")),
                  diag::Code::zone_too_large));
  EXPECT_TRUE(has(*without_offers(edited(drone_spec(), "to (5 m, 5 m)", "to (5 m, 0.5 mm)")),
                  diag::Code::zone_vanishes_on_grid));
  const auto widest = compiled(edited(drone_spec(), "to (5 m, 5 m)", "to (536.8 km, 536.8 km)"));
  EXPECT_TRUE(widest->module) << reports(*widest);
}

// At once, however large they are: their round corners would have any number of edges.
TEST(Zones, DistancesBeyondTheGridAreRefused) {
  for (const char* far : {"grow(room, 537 km)", "grow(room, 1e60 m)",
                          "shrink(rectangle (0 m, 0 m) to (1e60 m, 1e60 m), 1e59 m)"}) {
    const auto c = compiled(edited(drone_spec(), "clearance(d, room) >= 10 cm",
                                   "d inside " + std::string(far) + " and d inside room"));
    EXPECT_TRUE(has(*c, diag::Code::zone_too_large)) << far << reports(*c);
  }
  const auto none = compiled(
      edited(drone_spec(), "clearance(d, room) >= 10 cm", "d inside shrink(room, 1e60 m)"));
  EXPECT_TRUE(has(*none, diag::Code::empty_zone)) << reports(*none);
}

TEST(Zones, ASiteBeyondTheGridDoesNotWrapAround) {
  // 2^32 mm and 1 m: the same int32 as 1 m
  const auto c = compiled(edited(rover_spec(), "(6.5 m, 1 m)", "(4294968.296 m, 1 m)"));
  EXPECT_TRUE(has(*c, diag::Code::site_outside_zone)) << reports(*c);
}

TEST(Zones, CellsAreAsWideAsALargeZoneNeedsAndNoWider) {
  // 40,000 cells are 20 m x 20 m of 10 cm; steps of 1 cm
  EXPECT_EQ(cell_mm_for(20'000, 20'000), 100);
  EXPECT_EQ(cell_mm_for(20'001, 20'000), 110);
  EXPECT_EQ(cell_mm_for(50, 50), 100);
  EXPECT_EQ(cell_mm_for(100'000, 50'000), 360);  // 278 x 139; of 350 mm there are 286 x 143
  for (const std::int64_t width : {4'000'001, 12'345'678, 1'073'741'822}) {
    const std::int64_t cell = cell_mm_for(width, 10), narrower = cell - 10;
    EXPECT_LE((width + cell - 1) / cell, cells_most);
    EXPECT_GT((width + narrower - 1) / narrower, cells_most);
  }
}

TEST(Zones, ALargeZoneHasCellsThatRecoveriesSearch) {
  const auto c = compiled(edited(drone_spec(), "to (5 m, 5 m)", "to (60 m, 40 m)"));
  ASSERT_TRUE(c->module) << reports(*c);
  const ir::Cells& cells = room_of(*c).cells;
  EXPECT_EQ(cells.cell_mm, 250);
  EXPECT_LE(std::int64_t{cells.columns} * cells.rows, cells_most);
}

// Tables of 64 bytes an edge hold the distances of a few hundred metres; a fast robot needs more.
TEST(Zones, DistancesThatARobotNeedsAreExactOrItIsAnError) {
  std::string lake = "polygon [";
  for (int i = 0; i < 4000; ++i) {
    const double angle = 2 * M_PI * i / 4000;
    lake += (i > 0 ? ", (" : "(") + std::to_string(3000 * std::cos(angle)) + " m, " +
            std::to_string(3000 * std::sin(angle)) + " m)";
  }
  const std::string slow = edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)", lake + "]");
  const auto good = compiled(slow);
  EXPECT_FALSE(has(*good, diag::Code::too_many_edges)) << reports(*good);
  const auto fast = without_offers(edited(slow, "speed <= 1 m/s", "speed <= 80 m/s"));
  EXPECT_TRUE(has(*fast, diag::Code::too_many_edges)) << reports(*fast);
}

// As far as a property of points asks, and half as far again: with height as in the plane.
TEST(Zones, DistancesThatAPropertyOfPointsNamesAreExact) {
  const auto exact_mm = [](const std::string& point, const std::string& zone,
                           const std::string& clearance) {
    const auto c = compiled(
        "spec lake;\nperiod 1 s;\ninput p : " + point +
        ";\nzone shore = circle (0 m, 0 m) radius 3 km;\nzone lake = " + zone +
        ";\nmonitor m { \"R1: off the shore\" always clearance(p, lake) >= " + clearance + "; }\n");
    EXPECT_TRUE(c->module) << reports(*c);
    std::int32_t least = INT32_MAX;
    for (const ir::Region& r : c->module->watch->regions) {
      least = std::min(least, r.tree.exact_mm.value_or(INT32_MAX));
    }
    return least;
  };
  const auto flat = [&](const char* clearance) { return exact_mm("point", "shore", clearance); };
  const auto high = [&](const char* clearance) {
    return exact_mm("point3", "prism (shore) from 0 m to 1 km", clearance);
  };
  EXPECT_LT(flat("20 m"), 12'000'000);
  EXPECT_EQ(high("20 m"), flat("20 m"));
  EXPECT_GE(flat("8 km"), 12'000'000);
  EXPECT_EQ(high("8 km"), flat("8 km"));
}

// Monitors look at 16 edges around a place: those of 8 holes that meet in it.
TEST(Zones, EightHolesMayMeetInAPointOfAZoneThatIsAskedAbout) {
  const auto hall = [](int holes) {
    std::string text = "polygon [(-40 m, -40 m), (40 m, -40 m), (40 m, 40 m), (-40 m, 40 m)]";
    for (int i = 0; i < holes; ++i) {
      const std::string y = std::to_string(4 * i), end = std::to_string(4 * i + 2);
      text += " hole [(0 m, 0 m), (30 m, " + y + " m), (30 m, " + end + " m)]";
    }
    return edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)", text);
  };
  const auto eight = compiled(hall(8));
  EXPECT_TRUE(eight->module) << reports(*eight);
  const auto nine = compiled(hall(9));
  EXPECT_TRUE(has(*nine, diag::Code::too_many_edges)) << reports(*nine);
  EXPECT_FALSE(has(*nine, diag::Code::holes_overlap)) << reports(*nine);
}

// The zone that the help speaks of compiles.
TEST(Zones, CellsThatHideEveryPlaceAreRefusedWithTheWidthThatWorks) {
  const auto corridors = [](const std::string& side) {
    return edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)",
                  "rectangle (0 m, 0 m) to (" + side + " m, 2 m) | rectangle (0 m, 0 m) to (2 m, " +
                      side + " m)");
  };
  const auto c = compiled(corridors("400"));
  ASSERT_TRUE(has(*c, diag::Code::cells_too_coarse)) << reports(*c);
  const auto side = number_in_help(*c, diag::Code::cells_too_coarse, "as a zone within ", "m x");
  const auto smaller = compiled(corridors(side));
  EXPECT_TRUE(smaller->module) << side << "\n" << reports(*smaller);
}

// Halves of a union are united first, whatever the brackets.
TEST(Zones, AUnionIsTheSameInAnyOrder) {
  const auto tables = [](const std::string& zone) {
    const auto c = compiled(edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)", zone));
    EXPECT_TRUE(c->module) << reports(*c);
    std::vector<std::int64_t> all;
    if (!c->module) return all;
    for (const ir::Edge& e : room_of(*c).edges) {
      all.insert(all.end(), {e.ax, e.ay, e.bx, e.by});
    }
    return all;
  };
  const std::string a = "rectangle (0 m, 0 m) to (5 m, 5 m)", b = "circle (5 m, 2 m) radius 1 m",
                    c = "rectangle (4 m, 1 m) to (8 m, 3 m)", d = "circle (8 m, 2 m) radius 1.5 m",
                    e = "rectangle (8 m, 2 m) to (9 m, 9 m)";
  const auto one_by_one = tables(a + " | " + b + " | " + c + " | " + d + " | " + e);
  EXPECT_GT(one_by_one.size(), 100U);
  EXPECT_EQ(tables("(" + a + " | (" + b + " | " + c + ")) | (" + d + " | " + e + ")"), one_by_one);
  EXPECT_EQ(tables(e + " | (" + d + " | (" + c + " | (" + b + " | " + a + ")))"), one_by_one);
}

// 100 steps of a stair: told before their slabs are snapped to the grid and get tables.
TEST(Zones, SlabsAreCountedBeforeTheyAreBaked) {
  std::string stair;
  for (int i = 0; i < 100; ++i) {
    const std::string from = std::to_string(i);
    stair += std::string(i == 0 ? "" : " | ") + "prism (rectangle (" + from + " m, 0 m) to (" +
             std::to_string(i + 2) + " m, 1 m)) from " + from + " m to " + std::to_string(i + 2) +
             " m";
  }
  const auto c = compiled("spec s;\nperiod 100 ms;\nzone z = " + stair +
                          ";\ninput p : point3 in -900 .. 900 m max_age 1 s;\n"
                          "monitor m { \"R1: in\" always p inside z; }\n");
  EXPECT_TRUE(has(*c, diag::Code::too_many_edges)) << reports(*c);
  EXPECT_NE(reports(*c).find("the zone has 101 slabs, a decision checks at most 64"),
            std::string::npos)
      << reports(*c);
}

}  // namespace
}  // namespace rtac::analysis::test
