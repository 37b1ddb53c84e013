// Zones that arrive while generated monitors run: what is taken, what is refused, and that the one
// before stays.
#include "rtac/geometry/zone_maker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "received.h"

namespace rtac {
namespace {

using ::received::Monitors;

std::unique_ptr<HeldZone> good(MadeZone made) {
  auto* zone = std::get_if<std::unique_ptr<HeldZone>>(&made);
  if (zone == nullptr) {
    ADD_FAILURE() << std::get<ZoneRefusal>(made).message;
    return nullptr;
  }
  return std::move(*zone);
}
std::unique_ptr<HeldZone> square(double side, std::size_t edges_most = 8) {
  return good(make_zone({{{{0, 0}, {side, 0}, {side, side}, {0, side}}, {}}}, edges_most));
}
std::string refused(const MadeZone& made) {
  const auto* why = std::get_if<ZoneRefusal>(&made);
  return why == nullptr ? "taken" : why->where + ": " + why->message;
}

class ReceivedZones : public ::testing::Test {
 protected:
  Verdict stays(double x, double y, TimeUs now_us) {
    monitors_.p({Length(x), Length(y)}, now_us);
    return monitors_.step(now_us)[Monitors::stays_index].verdict;
  }
  Monitors monitors_;
};

TEST_F(ReceivedZones, AreUnknownBeforeTheFirstAndWhenTooOld) {
  const auto zone = square(10);
  EXPECT_EQ(stays(5, 5, 0), Verdict::is_unknown);
  EXPECT_STREQ(monitors_.step(100'000)[Monitors::stays_index].input, "fence");
  ASSERT_TRUE(monitors_.fence(zone->table(), 150'000));
  EXPECT_EQ(stays(5, 5, 200'000), Verdict::is_true);
  EXPECT_EQ(stays(12, 5, 300'000), Verdict::is_false);
  EXPECT_EQ(stays(5, 5, 1'100'000), Verdict::is_true);
  EXPECT_EQ(stays(5, 5, 1'200'000), Verdict::is_unknown);
  ASSERT_TRUE(monitors_.fence(zone->table(), 1'200'000));  // it still counts
  EXPECT_EQ(stays(5, 5, 1'300'000), Verdict::is_true);
}

TEST_F(ReceivedZones, AreReplacedBetweenTicks) {
  const auto small = square(10), large = square(20);
  ASSERT_TRUE(monitors_.fence(small->table(), 0));
  EXPECT_EQ(stays(15, 5, 0), Verdict::is_false);
  ASSERT_TRUE(monitors_.fence(large->table(), 50'000));
  EXPECT_EQ(stays(15, 5, 100'000), Verdict::is_true);
}

TEST_F(ReceivedZones, InvalidOnesAreRefusedWithTheVertexAndTheOldOneStays) {
  const auto zone = square(10);
  ASSERT_TRUE(monitors_.fence(zone->table(), 0));
  EXPECT_EQ(refused(make_zone({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}, 8)),
            "the outer ring, vertex 1: starts an edge that meets the one from vertex 3 at (1 m, 1 "
            "m)");
  EXPECT_EQ(refused(make_zone({{{{0, 0}, {1e9, 0}, {0, 1}}, {}}}, 8)),
            "the outer ring, vertex 2: lies too far away, or nowhere");
  EXPECT_NE(refused(make_zone_of_wkt("POLYGON ((0 0, 1 0", 8)), "taken");
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused(make_zone({{{{0, 0}, {inf, 0}, {0, 1}}, {}}}, 8)),
            "the outer ring, vertex 2: has a coordinate that is not finite");
  EXPECT_EQ(stays(5, 5, 0), Verdict::is_true);
}

// What the setter checks by itself, whoever made the table.
TEST_F(ReceivedZones, TablesThatDoNotFitAreRefusedAndTheOldOneStays) {
  const auto zone = square(10), other = square(20);
  ASSERT_TRUE(monitors_.fence(zone->table(), 0));
  ZoneTable table = other->table();
  table.version += 1;
  EXPECT_FALSE(monitors_.fence(table, 0));
  table = other->table();
  table.checksum ^= 1;
  EXPECT_FALSE(monitors_.fence(table, 0));
  std::vector<std::int32_t> edges(table.within.edges,
                                  table.within.edges + 6 * table.within.edge_count);
  edges[3] += 1;  // a bit that has flipped
  table = other->table();
  table.within.edges = edges.data();
  EXPECT_FALSE(monitors_.fence(table, 0));
  std::vector<std::uint32_t> cells(table.within.cells,
                                   table.within.cells + table.within.cell_count);
  table = other->table();
  table.within.cells = cells.data();
  for (std::uint32_t& word : cells) {
    if (word >> 30 == 1 || word >> 28 == 1) word |= 0xffffff;  // leads beyond the edges
  }
  table.checksum = zone_checksum(table);
  EXPECT_FALSE(monitors_.fence(table, 0));
  std::vector<Vec2> many;
  for (int k = 0; k < 9; ++k)
    many.push_back(
        {std::round(1e4 * std::cos(0.6 * k)) / 1e3, std::round(1e4 * std::sin(0.6 * k)) / 1e3});
  const auto nine = good(make_zone({{many, {}}}, 9));
  EXPECT_FALSE(monitors_.fence(nine->table(), 0));
  EXPECT_FALSE(monitors_.fence(ZoneTable{}, 0));
  EXPECT_FALSE(monitors_.fence(other->table(), never_us));
  EXPECT_EQ(stays(15, 5, 0), Verdict::is_false);
  EXPECT_EQ(stays(5, 5, 100'000), Verdict::is_true);
}

TEST(ZoneMaker, ClosingVerticesAndDirectionsDoNotMatter) {
  const auto one = square(10);
  const auto two = good(make_zone({{{{0, 0}, {0, 10}, {10, 10}, {10, 0}, {0, 0}}, {}}}, 8));
  const auto three = good(make_zone_of_wkt("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))", 8));
  EXPECT_EQ(one->table().checksum, two->table().checksum);
  EXPECT_EQ(one->table().checksum, three->table().checksum);
  EXPECT_LE(one->bytes(), 64U * 8 + 65536);
}

// Of about 83 m by 50 m from the origin on; the text of a file, with its axes.
std::string fence_of(ZoneFormat format) {
  if (format == ZoneFormat::geojson) {
    return R"({"type":"Polygon","coordinates":[[[8.5456,47.3977],[8.5467,47.3977],)"
           R"([8.5467,47.39815],[8.5456,47.39815],[8.5456,47.3977]]]})";
  }
  return R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"circles":[],"polygons":[)"
         R"({"polygon":[[47.3977,8.5456],[47.3977,8.5467],[47.39815,8.5467],[47.39815,8.5456]],)"
         R"("inclusion":true,"version":1}]},"mission":{"items":[],"version":2}})";
}
ZoneFile file_of(ZoneFormat format) {
  return {format, 47.3977, 8.5456, ZoneAreas::unstated};
}

// An uploaded file is judged in metres of the map; a wrong one is refused, and the old one stays.
TEST_F(ReceivedZones, FilesAreProjectedAndWrongOnesRefused) {
  TimeUs now_us = 0;
  for (const ZoneFormat format : {ZoneFormat::geojson, ZoneFormat::qgc_plan}) {
    const auto zone = good(make_zone_of_file(fence_of(format), file_of(format), 8));
    ASSERT_NE(zone, nullptr);
    ASSERT_TRUE(monitors_.fence(zone->table(), now_us));
    EXPECT_EQ(stays(80, 45, now_us), Verdict::is_true);
    EXPECT_EQ(stays(84, 45, now_us += 100'000), Verdict::is_false);
    EXPECT_EQ(stays(80, 51, now_us += 100'000), Verdict::is_false);
    ZoneFile other = file_of(format);
    other.format = ZoneFormat::kml;
    EXPECT_NE(refused(make_zone_of_file(fence_of(format), other, 8)), "taken");
    other = file_of(format);
    other.areas = ZoneAreas::exclusions;
    EXPECT_NE(refused(make_zone_of_file(fence_of(format), other, 8)), "taken");
    EXPECT_NE(refused(make_zone_of_file("{", file_of(format), 8)), "taken");
    EXPECT_EQ(stays(80, 45, now_us += 100'000), Verdict::is_true);
    now_us += 100'000;
  }
}

TEST(ZoneMaker, WhatAFileSaysBesidesIsNoted) {
  std::string plan = fence_of(ZoneFormat::qgc_plan);
  const std::string version = R"("version":2,)";
  plan.insert(plan.find(version), R"("breachReturn":[47.398,8.546,60],)");
  std::vector<ZoneNote> notes;
  const ZoneFile as = file_of(ZoneFormat::qgc_plan);
  EXPECT_NE(good(make_zone_of_file(plan, as, 8, &notes)), nullptr);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].where, "geoFence.breachReturn");
  EXPECT_EQ(notes[0].message, "the breach return point is no area and is left out");
  EXPECT_NE(good(make_zone_of_file(plan, as, 8)), nullptr);
  EXPECT_NE(good(make_zone_of_file(fence_of(ZoneFormat::qgc_plan), as, 8, &notes)), nullptr);
  EXPECT_TRUE(notes.empty());
}

TEST(ZoneMaker, BothSidesOfAZoneThatIsNotOnTheGridAreKept) {
  const auto zone = good(make_zone({{{{0, 0}, {10.0004, 0}, {5, 7}}, {}}}, 8));
  EXPECT_NE(zone->table().within.edges, zone->table().around.edges);
  const auto even = square(10);
  EXPECT_EQ(even->table().within.edges, even->table().around.edges);
}

}  // namespace
}  // namespace rtac
