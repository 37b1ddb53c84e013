// A zone that arrives at run time goes through the checks of a zone of a specification: what is
// refused, with which place and reason, before how much work.
#include "compiler/geometry/receive/receive_zone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtac::geometry {
namespace {

import::Polygon polygon(std::vector<import::Position> outer,
                        std::vector<std::vector<import::Position>> holes = {}){import::Polygon to;
to.outer.positions = std::move(outer);
for (auto& hole : holes) to.holes.emplace_back().positions = std::move(hole);
return to;
}  // namespace
const std::vector<import::Position> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::string refused(const std::vector<import::Polygon>& polygons, std::size_t edges_most = 64) {
  const auto received = receive_zone(polygons, edges_most);
  const auto* why = std::get_if<RefusedZone>(&received);
  if (why == nullptr) return "taken";
  EXPECT_NE(why->help, "");
  return why->where + ": " + why->message;
}
std::string refused(const std::string& wkt, std::size_t edges_most = 64) {
  const auto received = receive_wkt(wkt, edges_most);
  const auto* why = std::get_if<RefusedZone>(&received);
  return why == nullptr ? "taken" : why->where + ": " + why->message;
}

TEST(ReceiveZone, NamesTheVertexAndTheReason) {
  EXPECT_EQ(refused({polygon(square)}), "taken");
  EXPECT_EQ(refused(std::vector<import::Polygon>{}), "the zone: has no polygon");
  EXPECT_EQ(refused({polygon({{0, 0}, {1, 0}})}),
            "the outer ring: has fewer than three different vertices");
  EXPECT_EQ(refused({polygon({{0, 0}, {2, 0}, {2, 0}, {0, 2}})}),
            "the outer ring, vertex 3: repeats vertex 2");
  EXPECT_EQ(refused({polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}})}),
            "the outer ring, vertex 1: starts an edge that meets the one from vertex 3 at (1 m, 1 "
            "m)");
  EXPECT_EQ(refused({polygon({{0, 0}, {1, 0}, {2, 0}})}).substr(0, 15), "the outer ring:");
  EXPECT_EQ(refused({polygon(square, {{{8, 8}, {12, 8}, {9, 9}}})}),
            "hole 1: does not lie inside the outer ring, see its vertex 2");
  EXPECT_EQ(refused({polygon(square, {{{1, 1}, {3, 1}, {2, 3}}, {{2, 1}, {4, 1}, {3, 3}}})})
                .substr(0, 22),
            "hole 1: overlaps hole ");
  EXPECT_EQ(refused({polygon(square, {{{0, 5}, {5, 4}, {10, 5}, {5, 6}}})}),
            "hole 1: touches the outer ring at (10 m, 5 m), on its edge from vertex 2, and cuts "
            "the area in two");
}

// At compile time a note says that heights are left out; here nobody would read it.
TEST(ReceiveZone, RefusesTextsWithHeights) {
  EXPECT_EQ(refused("POLYGON ((0 0, 9 0, 9 9, 0 0))"), "taken");
  for (const std::string text :
       {"POLYGON Z ((0 0 1, 9 0 1, 9 9 1, 0 0 1))", "POLYGON ((0 0 1, 9 0 1, 9 9 1, 0 0 1))"}) {
    EXPECT_NE(refused(text).find("has heights or measures"), std::string::npos) << refused(text);
  }
}

TEST(ReceiveZone, RefusesWhatIsNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused({polygon({{0, 0}, {nan, 0}, {0, 2}})}),
            "the outer ring, vertex 2: has a coordinate that is not finite");
  EXPECT_EQ(refused({polygon(square), polygon({{0, 0}, {5, 0}, {1e308, 3}})}),
            "the outer ring of polygon 2, vertex 3: lies too far away, or nowhere");
}

// Bounds come before anything is computed.
TEST(ReceiveZone, RefusesTooManyVertices) {
  EXPECT_EQ(refused({polygon(square)}, 4), "taken");
  EXPECT_EQ(refused({polygon(square)}, 3), "the zone: has 4 vertices, 3 are the most");
  EXPECT_NE(refused(std::string(5000, '('), 4), "taken");
  EXPECT_NE(refused("POLYGON ((" + std::string(10000, ' ') + "0 0, 1 0, 0 1, 0 0))", 4), "taken");
  std::string many = "POLYGON ((0 0";
  for (int i = 1; i < 40; ++i) many += ", " + std::to_string(i) + " " + std::to_string(i * i);
  EXPECT_NE(refused(many + ", 0 0))", 4), "taken");
}

TEST(ReceiveZone, ReadsTextInMetres) {
  EXPECT_EQ(refused("POLYGON ((0 0, 5 0, 5 4, 0 0))"), "taken");
  EXPECT_EQ(refused("MULTIPOLYGON (((0 0, 5 0, 5 4, 0 0)), ((9 0, 12 0, 9 4, 9 0)))"), "taken");
  EXPECT_NE(refused("SRID=4326;POLYGON ((0 0, 5 0, 5 4, 0 0))"), "taken");
  EXPECT_NE(refused("POINT (1 2)"), "taken");
  EXPECT_NE(refused("POLYGON ((0 0, 5 0, 5 4))"), "taken");
  EXPECT_NE(refused(""), "taken");
}

ZoneTables tables(const std::string& wkt, std::size_t edges_most) {
  auto received = receive_wkt(wkt, edges_most);
  auto made = make_zone_tables(std::get<ReceivedRegions>(received), edges_most);
  return std::get<ZoneTables>(std::move(made));
}
TEST(ReceiveZone, KeepsWithinItsBytes) {
  std::string wkt = "POLYGON ((";
  std::string first;
  for (int i = 0; i < 500; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 500;
    const std::string at =
        std::to_string(300 * std::cos(angle)) + " " + std::to_string(300 * std::sin(angle));
    if (i == 0) first = at;
    wkt += at + ", ";
  }
  const ZoneTables made = tables(wkt + first + "))", 600);
  const auto bytes = [](const OutlineTable& t) { return 24 * t.edges.size() + t.tree.bytes(); };
  EXPECT_LE(bytes(made.within) + (made.around ? bytes(*made.around) : 0),
            zone_table_bytes_most(600));
  EXPECT_LE(made.within.tree.edges_most, 16);
}

// Off the grid one outline is within the zone and the other one around it, and both count.
TEST(ReceiveZone, HasTwoSidesOffTheGrid) {
  EXPECT_FALSE(tables("POLYGON ((0 0, 5 0, 5 4, 0 0))", 3).around);
  const std::string off = "POLYGON ((0 0, 5.0004 0, 5 4, 0 0))";
  ASSERT_TRUE(tables(off, 64).around);
  const auto received = receive_wkt(off, 64);
  const auto& regions = std::get<ReceivedRegions>(received);
  const ZoneTables made = tables(off, 64);
  const auto region = [](const OutlineTable& t) {
    Ring ring;
    for (const EdgeRow& e : t.edges) {
      ring.push_back({Rational(e.a.x_mm, 1000), Rational(e.a.y_mm, 1000)});
    }
    return Region::of_rings({ring});
  };
  EXPECT_TRUE(regions.within.contains(region(made.within)));
  EXPECT_TRUE(region(*made.around).contains(regions.around));
}

// A coordinate between two micrometres is known within 1 um.
TEST(ReceiveZone, KnowsHowExactItsCoordinatesAre) {
  const auto exact = receive_wkt("POLYGON ((0 0, 5 0, 5 4, 0 0))", 8);
  const auto& same = std::get<ReceivedRegions>(exact);
  EXPECT_TRUE(same.within.contains(same.around));
  const auto rounded = receive_wkt("POLYGON ((0 0, 5.0000004 0, 5 4, 0 0))", 8);
  const auto& apart = std::get<ReceivedRegions>(rounded);
  EXPECT_TRUE(apart.around.contains(apart.within));
  EXPECT_FALSE(apart.within.contains(apart.around));
}

// Two triangles make a star of twelve edges.
TEST(ReceiveZone, RefusesTooManyEdgesOfAUnion) {
  const std::vector<import::Polygon> triangles = {polygon({{0, 0}, {6, 0}, {3, 6}}),
                                                  polygon({{0, 4}, {6, 4}, {3, -2}})};
  const auto received = receive_zone(triangles, 6);
  const auto& regions = std::get<ReceivedRegions>(received);
  const auto made = make_zone_tables(regions, 6);
  ASSERT_TRUE(std::holds_alternative<RefusedZone>(made));
  EXPECT_NE(std::get<RefusedZone>(made).message.find("6 are the most"), std::string::npos);
  EXPECT_TRUE(std::holds_alternative<ZoneTables>(make_zone_tables(regions, 64)));
}

TEST(ReceiveZone, RefusesWhatTheGridCannotHold) {
  const auto thin = receive_wkt("POLYGON ((0 0, 0.0004 0, 0 0.0004, 0 0))", 8);
  const auto made = make_zone_tables(std::get<ReceivedRegions>(thin), 8);
  ASSERT_TRUE(std::holds_alternative<RefusedZone>(made));
  EXPECT_EQ(std::get<RefusedZone>(made).message, "has nothing left on the grid of 1 mm");
}

}  // namespace rtac::geometry
}  // namespace rtac::geometry
