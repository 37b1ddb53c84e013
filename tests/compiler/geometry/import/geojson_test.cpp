// GeoJSON: what RFC 7946 allows is read as it stands; what it leaves out or forbids is told with
// its place.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

const std::string square = "[[[11,48],[12,48],[12,49],[11,49],[11,48]]]";

std::string polygon_text(const std::string& coordinates, const std::string& more = "") {
  return R"({"type":"Polygon","coordinates":)" + coordinates + more + "}";
}
std::string feature_text(const std::string& geometry, const std::string& more = "") {
  return R"({"type":"Feature","properties":null,"geometry":)" + geometry + more + "}";
}
std::string collection_text(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}
std::string failure(const std::string& text, const Limits& limits = {}) {
  return failure_of(Format::geojson, text, limits);
}

TEST(GeoJson, PolygonKeepsItsPositionsWithoutTheClosingOne) {
  const Areas areas = areas_of(Format::geojson, polygon_text(square));
  ASSERT_EQ(areas.areas.size(), 1U);
  EXPECT_EQ(areas.unit, Unit::degrees);
  EXPECT_EQ(areas.axes, Axes::longitude_first);
  const Ring& outer = polygon_of(areas.areas[0]).outer;
  EXPECT_TRUE(outer.closed);
  EXPECT_EQ(outer.where, "coordinates[0]");
  ASSERT_EQ(outer.positions.size(), 4U);
  EXPECT_EQ(outer.positions[1], (Position{12, 48}));
  EXPECT_EQ(areas.areas[0].role, Role::unstated);
}

TEST(GeoJson, HolesAreKept) {
  const Area area = only_area(
      Format::geojson,
      polygon_text(
          "[[[0,0],[9,0],[9,9],[0,0]],[[1,1],[2,1],[2,2],[1,1]],[[5,1],[6,1],[6,2],[5,1]]]"));
  EXPECT_EQ(polygon_of(area).holes.size(), 2U);
}

TEST(GeoJson, PartsOfMultiPolygonsAndNestedCollectionsBelongToOneArea) {
  const std::string multi =
      R"({"type":"MultiPolygon","coordinates":[)" + square + "," + square + "]}";
  const std::string nested = R"({"type":"GeometryCollection","geometries":[)" + multi +
                             R"(,{"type":"GeometryCollection","geometries":[)" +
                             polygon_text(square) + "]}]}";
  const Area area = only_area(Format::geojson, feature_text(nested));
  ASSERT_EQ(area.parts.size(), 3U);
  EXPECT_EQ(polygon_of(area, 2).outer.where, "geometry.geometries[1].geometries[0].coordinates[0]");
}

// Foreign members (RFC 7946, 6.1) are left out, those that may cut the area down are not.
TEST(GeoJson, ForeignMembersThatSoundLikeLimitsAreRefused) {
  EXPECT_TRUE(
      contains(failure(feature_text(polygon_text(square, R"(,"Holes":[])"))),
               "geometry.Holes: is no member that the format has, and sounds like a limit"));
  EXPECT_TRUE(contains(failure(feature_text(polygon_text(square), R"(,"lowerLimit":0)")),
                       "lowerLimit: is no member"));
  const std::string marked = feature_text(polygon_text(square), R"(,"style":{})");
  const Areas areas = areas_of(Format::geojson, collection_text(marked + "," + marked));
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].where, "features[0].style");
}

TEST(GeoJson, NamesComeFromTheIdThenTheProperties) {
  const Areas areas = areas_of(
      Format::geojson,
      collection_text(
          R"({"type":"Feature","id":17,"properties":{"title":"b","name":"a","identifier":"17"},"geometry":)" +
          polygon_text(square) + "}," + feature_text(polygon_text(square))));
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(areas.areas[0].name, "17");
  EXPECT_EQ(areas.areas[0].other_names, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(areas.areas[1].name, "");
  EXPECT_EQ(areas.areas[1].where, "features[1]");
}

// RFC 7946, 3.2: a text or a number. Programs write `null` for none.
TEST(GeoJson, IdsOfOtherKindsAreRefused) {
  const auto with = [](const std::string& id) {
    return failure(feature_text(polygon_text(square), ",\"id\":" + id));
  };
  EXPECT_TRUE(contains(with("{}"), "id: is an object (write a text or a number here)"));
  EXPECT_TRUE(contains(with("[1]"), "id: is an array of numbers"));
  EXPECT_TRUE(contains(with("true"), "id: is `true`"));
  for (const std::string id : {"7", "\"a\"", "null"}) EXPECT_EQ(with(id), "") << id;
}

// RFC 7946, 7.1: a polygon in the wrong object would be lost.
TEST(GeoJson, MembersOfOtherObjectsAreRefused) {
  const std::string polygon = polygon_text(square);
  for (const std::string name : {"coordinates", "geometries", "features"}) {
    const std::string feature = feature_text(polygon, ",\"" + name + "\":" + square);
    EXPECT_TRUE(contains(failure(collection_text(feature)),
                         "features[0]." + name + ": is no member of a Feature (`coordinates` are"));
  }
  for (const std::string name : {"geometry", "geometries", "coordinates", "properties"}) {
    EXPECT_TRUE(contains(failure(R"({"type":"FeatureCollection","features":[)" +
                                 feature_text(polygon) + "],\"" + name + "\":" + polygon + "}"),
                         name + ": is no member of a FeatureCollection"));
  }
  for (const std::string name : {"geometry", "features", "properties"}) {
    EXPECT_TRUE(contains(
        failure(feature_text(polygon_text(square, ",\"" + name + "\":" + polygon))),
        "geometry." + name + ": is no member of a geometry (`coordinates` are of a geometry"));
  }
}

TEST(GeoJson, CollectionsOfGeometriesAndGeometriesHaveOneOfTheirMembers) {
  EXPECT_TRUE(contains(failure(R"({"type":"GeometryCollection","geometries":[)" +
                               polygon_text(square) + "],\"coordinates\":" + square + "}"),
                       "coordinates: is no member of a GeometryCollection"));
  EXPECT_TRUE(contains(failure(polygon_text(square, R"(,"geometries":[])")),
                       "geometries: is no member of a Polygon"));
}

// Maps have labels and routes among the zones; whoever selects one of them is told.
TEST(GeoJson, LinesAndPointsAreAreasThatRefuseToBeUsed) {
  const Areas areas = areas_of(
      Format::geojson,
      collection_text(feature_text(R"({"type":"LineString","coordinates":[[1,2],[3,4]]})") + "," +
                      feature_text(R"({"type":"GeometryCollection","geometries":[)" +
                                   polygon_text(square) +
                                   R"(,{"type":"Point","coordinates":[1,2]}]})") +
                      "," + feature_text("null") + "," + feature_text(polygon_text("[]"))));
  ASSERT_EQ(areas.areas.size(), 4U);
  EXPECT_TRUE(contains(refusal_of(areas.areas[0]), "features[0].geometry: a LineString encloses"));
  EXPECT_TRUE(contains(refusal_of(areas.areas[1]), "geometries[1]: a Point encloses nothing"));
  EXPECT_TRUE(contains(refusal_of(areas.areas[2]), "no geometry"));
  EXPECT_TRUE(contains(refusal_of(areas.areas[3]), "empty"));
}

TEST(GeoJson, HeightsOfPositionsAreNotedOnce) {
  const Areas areas =
      areas_of(Format::geojson, polygon_text("[[[0,0,5],[9,0,5],[9,9,5],[0,0,5]]]"));
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].where, "coordinates[0][0]");
  EXPECT_EQ(polygon_of(areas.areas.at(0)).outer.positions.size(), 3U);
}

// A decimal comma makes two numbers of one, of which the second would count as a height.
TEST(GeoJson, PositionsOfARingHaveTheSameNumberOfCoordinates) {
  const std::string mixed = failure(polygon_text("[[[8.5,47],[8.6,47,3986],[8.6,48],[8.5,47]]]"));
  EXPECT_TRUE(
      contains(mixed, "coordinates[0][1]: a position of 3 numbers, among those of 2 (two numbers"));
  EXPECT_TRUE(contains(mixed, "a decimal comma makes two numbers of `47,3986`: write `47.3986`"));
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0,1],[9,0,1],[9,9,1],[0,0]]]")),
                       "coordinates[0][3]: a position of 2 numbers, among those of 3"));
}

// Programs that clip an outline write its holes in their own way.
TEST(GeoJson, HolesMayHaveHeightsThatTheOutlineHasNot) {
  EXPECT_EQ(failure(polygon_text("[[[0,0],[9,0],[9,9],[0,0]],[[1,1,5],[2,1,5],[2,2,5],[1,1,5]]]")),
            "");
}

TEST(GeoJson, OpenRingIsToldWithItsLastPosition) {
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0],[9,0],[9,9]]]")),
                       "coordinates[0], position 3: the ring is open: it starts at (0, 0) and "
                       "ends at (9, 9)"));
}

TEST(GeoJson, RingOfTwoPositionsEnclosesNothing) {
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0],[9,0],[0,0]]]")), "has 2 positions"));
}

TEST(GeoJson, ShortRingsAreCountedAsTheyAre) {
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0],[1,0],[0,0]]]")),
                       "the ring has 2 positions besides the one that closes it; it encloses"));
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0],[1,0]]]")),
                       "the ring has 2 positions; it encloses nothing"));
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0]]]")), "the ring has 1 position; it"));
  EXPECT_TRUE(contains(failure(polygon_text("[[]]")), "the ring has 0 positions; it"));
}

TEST(GeoJson, PositionOffTheGlobeIsTold) {
  EXPECT_TRUE(contains(failure(polygon_text("[[[0,0],[181,0],[9,9],[0,0]]]")),
                       "coordinates[0], position 2: the position with longitude 181 and latitude "
                       "0 is off the globe (longitudes are within"));
}

TEST(GeoJson, SwappedAxesAreSuspectedWhenSwappingMendsAllPositions) {
  EXPECT_TRUE(contains(failure(polygon_text("[[[48,111],[49,111],[49,112],[48,111]]]")),
                       "the axes look swapped"));
}

TEST(GeoJson, EdgeAcrossTheAntimeridianIsRefused) {
  EXPECT_TRUE(contains(failure(polygon_text("[[[179,0],[-179,0],[-179,9],[179,9],[179,0]]]")),
                       "position 1: the longitude steps from 179 to -179"));
}

TEST(GeoJson, OnlyCrs84IsAccepted) {
  const auto crs = [](const std::string& name) {
    return R"(,"crs":{"type":"name","properties":{"name":")" + name + "\"}}";
  };
  EXPECT_EQ(failure(polygon_text(square, crs("urn:ogc:def:crs:OGC:1.3:CRS84"))), "");
  EXPECT_TRUE(
      contains(failure(polygon_text(square, crs("EPSG:3857"))), "crs: the reference system"));
  EXPECT_TRUE(contains(failure(polygon_text(square, R"(,"crs":null)")), "`null`"));
  EXPECT_TRUE(contains(failure(feature_text(polygon_text(square), crs("x"))), "`x`"));
}

// Nothing of a broken part is dropped.
TEST(GeoJson, NumbersAreNoGeometriesAndTextsNoProperties) {
  EXPECT_TRUE(contains(failure(R"({"type":"GeometryCollection","geometries":[8.5,47.3]})"),
                       "geometries: is an array of numbers (write an array of geometries here"));
  for (const char* properties : {R"([{"upperLimit":120}])", R"("upperLimit 120")"}) {
    EXPECT_TRUE(contains(failure(R"({"type":"Feature","geometry":null,"properties":)" +
                                 std::string(properties) + "}"),
                         "properties: is "))
        << properties;
  }
}

// What limits in a place that the format does not know limits all the same.
TEST(GeoJson, LimitsBesideThePropertiesAreTold) {
  for (const char* member : {R"("endTime":"2024-05-01")", R"("expires":"2024-05-01")",
                             R"("when":{"end":"2024-05-01"})", R"("agl":50)"}) {
    EXPECT_TRUE(contains(failure(R"({"type":"Feature","geometry":null,"properties":{},)" +
                                 std::string(member) + "}"),
                         "sounds like a limit"))
        << member;
  }
}

TEST(GeoJson, MembersOfEd318AreNotDropped) {
  EXPECT_TRUE(contains(failure(polygon_text(square, R"(,"layer":{"upper":120})")), "ED-318"));
}

TEST(GeoJson, WrongKindsAreToldWithValueAndPlace) {
  EXPECT_TRUE(contains(failure(polygon_text(R"([[["1",2],[3,4],[5,6],["1",2]]])")),
                       "coordinates[0][0]: is an array, and its element 1 is the text `1`"));
  EXPECT_TRUE(contains(failure(polygon_text("[[[1,null],[3,4],[5,6],[1,2]]]")),
                       "coordinates[0][0]: is an array, and its element 2 is `null`"));
  EXPECT_TRUE(
      contains(failure(polygon_text("[[1,2],[3,4]]")), "coordinates[0]: is an array of numbers"));
  EXPECT_TRUE(contains(failure(polygon_text("[[[1,2,3,4]]]")), "has 4 numbers"));
  EXPECT_TRUE(contains(failure(polygon_text("5")), "coordinates: is the number 5"));
  EXPECT_TRUE(contains(failure("[]"), "the whole text: is an empty array"));
  EXPECT_TRUE(contains(failure(R"({"type":"polygon"})"), "no geometry of the type `polygon`"));
  EXPECT_EQ(failure(R"({"type":"polygon"})").rfind("type: ", 0), 0U);
  EXPECT_TRUE(
      contains(failure(R"({"type":"Feature","properties":{}})"), "lacks the member `geometry`"));
  EXPECT_TRUE(contains(failure(R"({"a":1})"), "lacks the member `type`"));
  EXPECT_TRUE(contains(failure(R"({"type":"FeatureCollection","features":[{"type":"Polygon"}]})"),
                       "features[0].type: is `Polygon`"));
}

TEST(GeoJson, CollectionWithoutFeaturesHasNoAreas) {
  EXPECT_TRUE(contains(failure(collection_text("")), "has no areas"));
}

TEST(GeoJson, MemberGivenTwiceIsRefused) {
  EXPECT_TRUE(contains(failure(polygon_text(square, R"(,"coordinates":[])")),
                       "has the member `coordinates` twice"));
}

TEST(GeoJson, FaultsOfJsonHaveLineAndColumn) {
  EXPECT_TRUE(
      contains(failure("{\n \"type\": NaN}"),
               "line 2, column 10, within the whole text: this is no JSON: unexpected `NaN}`"));
  EXPECT_TRUE(contains(failure(polygon_text("[[[1e999,0]]]")), "beyond any double"));
  const std::string whole = polygon_text(square);
  EXPECT_TRUE(contains(failure(whole.substr(0, whole.size() - 4)), "the text ends before"));
  EXPECT_TRUE(contains(failure(whole + "x"), "unexpected `x`"));
}

TEST(GeoJson, LargestDoubleIsOffTheGlobe) {
  EXPECT_TRUE(
      contains(failure(polygon_text("[[[1e308,0],[9,0],[9,9],[1e308,0]]]")), "off the globe"));
}

TEST(GeoJson, LimitsEndInAFailure) {
  EXPECT_TRUE(contains(failure(std::string(100'000, '[')), "nested deeper than 64 levels"));
  EXPECT_TRUE(
      contains(failure(polygon_text(square), {.positions_max = 4}), "more than 4 positions"));
  EXPECT_EQ(failure(polygon_text(square), {.positions_max = 5}), "");
  EXPECT_TRUE(contains(failure(polygon_text(square), {.values_max = 4}), "more than 4 values"));
  EXPECT_TRUE(contains(failure(polygon_text(square), {.bytes_max = 20}), "at most 20 are read"));
}

}  // namespace
}  // namespace rtac::geometry::import
