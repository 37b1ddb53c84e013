// KML: Placemarks with polygons; heights make a solid only where the format says so.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

std::string kml(const std::string& content) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Folder>" +
         content + "</Folder></Document></kml>";
}
std::string ring(const std::string& coordinates) {
  return "<LinearRing><coordinates>" + coordinates + "</coordinates></LinearRing>";
}
std::string polygon(const std::string& coordinates, const std::string& more = "") {
  return "<Polygon>" + more + "<outerBoundaryIs>" + ring(coordinates) +
         "</outerBoundaryIs></Polygon>";
}
std::string placemark(const std::string& geometry) {
  return "<Placemark id=\"p1\"><name> field </name>" + geometry + "</Placemark>";
}
std::string failure(const std::string& text, const Limits& limits = {}) {
  return failure_of(Format::kml, text, limits);
}

const std::string triangle = "8.5,47.1\n 8.6,47.1,0 8.6,47.2 8.5,47.1";
const std::string high = "8.5,47.1,120 8.6,47.1,120 8.6,47.2,120 8.5,47.1,120";

TEST(Kml, PlacemarkIsAnArea) {
  const Area area = only_area(Format::kml, kml(placemark(polygon(triangle))));
  EXPECT_EQ(area.name, "field");
  EXPECT_EQ(area.other_names, std::vector<std::string>{"p1"});
  const Ring& outer = polygon_of(area).outer;
  EXPECT_EQ(outer.positions.size(), 3U);
  EXPECT_EQ(outer.positions.at(1), (Position{8.6, 47.1}));
  EXPECT_TRUE(contains(outer.where, "line 2, column "));
  EXPECT_FALSE(area.parts[0].band.floor || area.parts[0].band.ceiling);
}

TEST(Kml, InnerBoundariesAreHoles) {
  const std::string hole = "<innerBoundaryIs>" + ring("1,1 2,1 2,2 1,1") + "</innerBoundaryIs>";
  const Area area = only_area(Format::kml, kml(placemark(polygon("0,0 9,0 9,9 0,0", hole + hole))));
  EXPECT_EQ(polygon_of(area).holes.size(), 2U);
}

TEST(Kml, PrefixesAreNoMatter) {
  EXPECT_EQ(failure("<k:kml xmlns:k=\"x\"><k:Placemark><k:Polygon><k:outerBoundaryIs><k:LinearRing>"
                    "<k:coordinates>0,0 9,0 9,9 0,0</k:coordinates></k:LinearRing>"
                    "</k:outerBoundaryIs></k:Polygon></k:Placemark></k:kml>"),
            "");
}

TEST(Kml, CommentsDoNotCutCoordinates) {
  const Area area = only_area(
      Format::kml, kml(placemark(polygon("0,0 9,0 <!-- corner --> 9,9 <![CDATA[0,9 ]]>0,0"))));
  EXPECT_EQ(polygon_of(area).outer.positions.size(), 4U);
}

TEST(Kml, MultiGeometryHasSeveralParts) {
  EXPECT_EQ(only_area(Format::kml,
                      kml(placemark("<MultiGeometry>" + polygon(triangle) + "<MultiGeometry>" +
                                    polygon(triangle) + "</MultiGeometry></MultiGeometry>")))
                .parts.size(),
            2U);
}

TEST(Kml, ExtrudedPolygonReachesFromTheGroundToItsHeight) {
  const auto band = [](const std::string& mode) {
    return only_area(Format::kml, kml(placemark(polygon(high, "<extrude>1</extrude><altitudeMode>" +
                                                                  mode + "</altitudeMode>"))))
        .parts.at(0)
        .band;
  };
  const Band above_ground = band("relativeToGround");
  EXPECT_EQ(above_ground.ceiling->value_m, 120);
  EXPECT_EQ(above_ground.ceiling->reference, AltitudeReference::ground);
  EXPECT_EQ(above_ground.floor->value_m, 0);
  EXPECT_EQ(above_ground.floor->reference, AltitudeReference::ground);
  EXPECT_EQ(band("absolute").ceiling->reference, AltitudeReference::mean_sea_level);
  EXPECT_FALSE(band("clampToGround").ceiling);
}

TEST(Kml, SheetsInTheAirRefuseToBeUsed) {
  const auto refusal = [](const std::string& coordinates, const std::string& more) {
    return refusal_of(only_area(Format::kml, kml(placemark(polygon(coordinates, more)))));
  };
  const std::string absolute = "<altitudeMode>absolute</altitudeMode>";
  EXPECT_TRUE(contains(refusal(high, absolute), "a sheet at a height of 120 m"));
  EXPECT_TRUE(contains(refusal("0,0,1 9,0,2 9,9,1 0,0,1", "<extrude>1</extrude>" + absolute),
                       "heights from 1 to 2 m"));
  EXPECT_TRUE(contains(refusal(high, "<gx:altitudeMode>relativeToSeaFloor</gx:altitudeMode>"),
                       "the altitude mode is `relativeToSeaFloor`"));
}

TEST(Kml, HeightsOfNoneAboveGroundAreNoSheet) {
  EXPECT_FALSE(
      only_area(Format::kml,
                kml(placemark(polygon(triangle, "<altitudeMode>relativeToGround</altitudeMode>"))))
          .refusal);
}

TEST(Kml, ExtrudingBelowTheGroundIsUpsideDown) {
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0,-5 9,0,-5 9,9,-5 0,0,-5",
                                                     "<extrude>1</extrude><altitudeMode>"
                                                     "relativeToGround</altitudeMode>")))),
                       "upside down: from 0 m up to -5 m"));
}

TEST(Kml, WhatEnclosesNothingRefusesToBeUsed) {
  const auto refusal = [](const std::string& content) {
    return refusal_of(only_area(Format::kml, kml(content)));
  };
  EXPECT_TRUE(contains(refusal(placemark("<Point/>")), "a Point encloses nothing"));
  EXPECT_TRUE(contains(refusal(placemark(ring(triangle))), "<outerBoundaryIs>"));
  EXPECT_TRUE(contains(refusal(placemark("")), "has no Polygon"));
  EXPECT_TRUE(
      contains(refusal(placemark("<TimeSpan/>" + polygon(triangle))), "a TimeSpan tells when"));
  const std::string timed = "<Folder>" + placemark(polygon(triangle)) + "<TimeStamp/></Folder>";
  EXPECT_TRUE(contains(refusal(timed), "a TimeStamp tells when"));
  EXPECT_TRUE(contains(refusal("<Document><TimeSpan/><Folder>" + placemark(polygon(triangle)) +
                               "</Folder></Document>"),
                       "a TimeSpan tells when"));
  EXPECT_TRUE(contains(refusal("<NetworkLink><name>n</name></NetworkLink>"), "is not followed"));
}

TEST(Kml, PositionsAreToldWithTheirText) {
  EXPECT_TRUE(
      contains(failure(kml(placemark(polygon("0,0 9, 0 9,9 0,0")))), "position 2: is `9,`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,0,1,2 9,9 0,0")))), "is `9,0,1,2`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,nan 9,9 0,0")))), "is `9,nan`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9 9,9 0,0")))), "is `9`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,1e400 9,9 0,0")))), "is `9,1e400`"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,0 9,9")))), "the ring is open"));
  EXPECT_TRUE(contains(failure(kml(placemark(polygon("0,0 9,95 9,9 0,0")))), "off the globe"));
}

TEST(Kml, WhatIsMissingOrTwiceIsTold) {
  EXPECT_TRUE(contains(failure(kml(placemark("<Polygon/>"))), "without <outerBoundaryIs>"));
  EXPECT_TRUE(contains(failure(kml(placemark("<Polygon><outerBoundaryIs/></Polygon>"))),
                       "without a LinearRing"));
  EXPECT_TRUE(
      contains(failure(kml(placemark(polygon(
                   triangle, "<outerBoundaryIs>" + ring(triangle) + "</outerBoundaryIs>")))),
               "a second outline"));
  EXPECT_TRUE(contains(failure(kml(placemark(
                           "<Polygon><outerBoundaryIs><LinearRing/></outerBoundaryIs></Polygon>"))),
                       "without <coordinates>"));
  EXPECT_TRUE(contains(failure("<gpx/>"), "the outermost element is `gpx`"));
  EXPECT_TRUE(contains(failure(kml("")), "has no areas"));
}

// A document type could define entities that grow without end.
TEST(Kml, DocumentTypesAreRefused) {
  EXPECT_TRUE(
      contains(failure("<!DOCTYPE kml [<!ENTITY a \"aaaa\">]>" + kml("")), "document type"));
}

TEST(Kml, FaultsOfXmlHaveLineAndColumn) {
  const std::string whole = kml(placemark(polygon(triangle)));
  EXPECT_TRUE(contains(failure(whole.substr(0, whole.size() - 3)), "this is no XML"));
  EXPECT_TRUE(contains(failure("<kml>\n<a></b></kml>"), "line 2, column "));
}

TEST(Kml, LimitsEndInAFailure) {
  std::string deep = "<kml>";
  for (int i = 0; i < 1000; ++i) deep += "<Folder>";
  for (int i = 0; i < 1000; ++i) deep += "</Folder>";
  EXPECT_TRUE(contains(failure(deep + "</kml>"), "nested too deeply"));
  EXPECT_TRUE(contains(failure(kml(""), {.values_max = 3}), "more than 3 elements"));
  EXPECT_TRUE(
      contains(failure(kml(placemark(polygon(triangle))), {.positions_max = 3}), "more than 3"));
}

}  // namespace
}  // namespace rtac::geometry::import
