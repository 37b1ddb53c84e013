// Well-known text: strict about its grammar, silent about axes and unit.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

std::string failure(const std::string& text, const Limits& limits = {}) {
  return failure_of(Format::wkt, text, limits);
}

TEST(Wkt, PolygonWithAHole) {
  const Areas areas =
      areas_of(Format::wkt, "POLYGON ((0 0, 9.5 0, 9 9e0, 0 0), (1 1, 2 1, 2 +2, 1 1))\n");
  EXPECT_EQ(areas.unit, Unit::unstated);
  EXPECT_EQ(areas.axes, Axes::unstated);
  const Polygon& polygon = polygon_of(areas.areas.at(0));
  EXPECT_EQ(polygon.outer.positions.at(1), (Position{9.5, 0}));
  EXPECT_TRUE(polygon.outer.closed);
  EXPECT_EQ(polygon.outer.where, "line 1, column 10");
  EXPECT_EQ(polygon.holes.size(), 1U);
}

TEST(Wkt, SpacesAndCaseAreNoMatter) {
  EXPECT_EQ(only_area(Format::wkt, " multipolygon(((0 0,9 0,9 9,0 0)),(\n(0 0,9 0,9 9,0 0)))")
                .parts.size(),
            2U);
}

TEST(Wkt, SridOfDegreesLeavesTheOrderOfAxesOpen) {
  const Areas areas = areas_of(Format::wkt, "SRID=4326;POLYGON((0 0,9 0,9 9,0 0))");
  EXPECT_EQ(areas.unit, Unit::degrees);
  EXPECT_EQ(areas.axes, Axes::unstated);
  EXPECT_TRUE(contains(failure("SRID=3857;POLYGON((0 0,9 0,9 9,0 0))"), "SRID `3857`"));
  EXPECT_TRUE(contains(failure("SRID=4326;POLYGON((0 0,9 0,9 9,0 0))\nPOLYGON((0 0,9 0,9 9,0 0))"),
                       "line 2, column 1: an area with an SRID beside one without"));
}

TEST(Wkt, DegreesMustFitTheGlobeInOneOrder) {
  EXPECT_EQ(failure("SRID=4326;POLYGON((0 0,100 0,100 9,0 0))"), "");
  EXPECT_EQ(failure("SRID=4326;POLYGON((0 0,0 100,9 100,0 0))"), "");
  EXPECT_TRUE(contains(failure("SRID=4326;POLYGON((0 0,100 0,9 100,0 0))"),
                       "write all positions in one order"));
  EXPECT_TRUE(contains(failure("SRID=4326;POLYGON((0 0,100 100,9 9,0 0))"),
                       "line 1, column 19, position 2: the position (100, 100) is off the globe"));
}

TEST(Wkt, SeveralTextsAreSeveralAreas) {
  const Areas areas = areas_of(
      Format::wkt, "POLYGON((0 0,9 0,9 9,0 0))\nPOLYGON((0 0,9 0,9 9,0 0));\n\nPOLYGON EMPTY");
  ASSERT_EQ(areas.areas.size(), 3U);
  EXPECT_EQ(areas.areas[1].where, "line 2, column 1");
  EXPECT_TRUE(contains(refusal_of(areas.areas[2]), "line 4, column 1: the geometry is empty"));
}

TEST(Wkt, MembersOfACollectionBelongToOneArea) {
  const std::string polygon = "POLYGON((0 0,9 0,9 9,0 0))";
  EXPECT_EQ(only_area(Format::wkt,
                      "GEOMETRYCOLLECTION(" + polygon + ", GEOMETRYCOLLECTION(" + polygon + "))")
                .parts.size(),
            2U);
  const Area area = only_area(Format::wkt, "GEOMETRYCOLLECTION(" + polygon + ",POINT(1 2))");
  EXPECT_TRUE(contains(refusal_of(area), "a POINT encloses nothing"));
}

TEST(Wkt, CurvesRefuseToBeUsed) {
  const Area area = only_area(Format::wkt, "CURVEPOLYGON(CIRCULARSTRING(0 0,4 0,4 4,0 4,0 0))");
  EXPECT_TRUE(contains(refusal_of(area), "no outline of straight edges"));
}

TEST(Wkt, HeightsAndMeasuresAreNoted) {
  for (const char* text :
       {"POLYGON Z ((0 0 1,9 0 1,9 9 1,0 0 1))", "POLYGONZ((0 0 1,9 0 1,9 9 1,0 0 1))",
        "POLYGON ZM((0 0 1 2,9 0 1 2,9 9 1 2,0 0 1 2))", "POLYGON((0 0 1,9 0 1,9 9 1,0 0 1))"}) {
    const Areas areas = areas_of(Format::wkt, text);
    ASSERT_EQ(areas.notes.size(), 1U) << text;
    EXPECT_EQ(polygon_of(areas.areas.at(0)).outer.positions.size(), 3U);
  }
}

TEST(Wkt, DimensionsMustAgree) {
  EXPECT_TRUE(contains(failure("POLYGON((0 0,9 0 1,9 9,0 0))"),
                       "line 1, column 14: a position of 3 numbers, among those of 2"));
  EXPECT_TRUE(contains(failure("POLYGON Z((0 0,9 0,9 9,0 0))"), "of 2 numbers, among those of 3"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0 0 0,9 0 0 0,9 9 0 0,0 0 0 0))"), "of 4 numbers"));
}

TEST(Wkt, OpenRingIsTold) {
  EXPECT_TRUE(contains(failure("POLYGON((0 0,9 0,9 9))"),
                       "line 1, column 9, position 3: the ring is open"));
}

TEST(Wkt, FaultsOfGrammarHaveLineAndColumn) {
  EXPECT_TRUE(contains(failure("POLYGON(\n(0 0,9 x))"), "line 2, column 8: unexpected `x))`"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,9 0"), "the text ends before it is complete"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,9 0,9 9,0 0)))"), "column 27: unexpected `)`"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,9 0,9 9,0 0)) x"), "no geometry of the type `X`"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,nan 0,9 9,0 0))"), "unexpected `nan"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,1e999 0,9 9,0 0))"), "`1e999` is no number"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,1-2 0,9 9,0 0))"), "`1-2` is no number"));
  EXPECT_TRUE(contains(failure("POINT x (1 2)"), "unexpected `x (1 2)`"));
  EXPECT_TRUE(contains(failure("POINT((1 2)"), "the text ends"));
  EXPECT_TRUE(contains(failure("SRID4326;"), "`=`"));
}

TEST(Wkt, LargestDoubleIsNotOnEarth) {
  EXPECT_TRUE(contains(failure("POLYGON((0 0,1e308 0,9 9,0 0))"), "not on earth in any unit"));
}

TEST(Wkt, LimitsEndInAFailure) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "GEOMETRYCOLLECTION(";
  EXPECT_TRUE(contains(failure(deep), "nested deeper than 64 levels"));
  EXPECT_TRUE(contains(failure("POINT" + std::string(100'000, '(')), "the text ends"));
  EXPECT_TRUE(contains(failure("POLYGON((0 0,9 0,9 9,0 0))", {.positions_max = 3}),
                       "more than 3 positions"));
}

}  // namespace
}  // namespace rtac::geometry::import
