// What holds for every format: which one a file is in, and texts that are none.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

TEST(FormatOf, ExtensionsThatNameAFormatDecide) {
  EXPECT_EQ(format_of("a/b.wkt", ""), Format::wkt);
  EXPECT_EQ(format_of("b.KML", ""), Format::kml);
  EXPECT_EQ(format_of("b.kmz", "PK"), Format::kml);
  EXPECT_EQ(format_of("b.plan", "{"), Format::qgc_plan);
  EXPECT_EQ(format_of("b.waypoints", ""), Format::waypoints);
  EXPECT_EQ(format_of("b.geojson", "{}"), Format::geojson);
}

TEST(FormatOf, ContentDecidesWhereTheExtensionDoesNot) {
  EXPECT_EQ(format_of("b.json", R"({"type": "Polygon"})"), Format::geojson);
  EXPECT_EQ(format_of("b.json", R"({"fileType": "Plan"})"), Format::qgc_plan);
  EXPECT_EQ(format_of("b.json", R"({"features":[{"geometry":[{"horizontalProjection":{}}]}]})"),
            Format::ed269);
  EXPECT_EQ(format_of("b.txt", "QGC WPL 110\n"), Format::waypoints);
  EXPECT_EQ(format_of("b", " \nPolygon ((0 0"), Format::wkt);
  EXPECT_EQ(format_of("b.xml", "\xef\xbb\xbf<?xml version=\"1.0\"?>\n<kml xmlns=\"x\">"),
            Format::kml);
}

// A zone without a volume has no `horizontalProjection`, and has `type` and `zoneAuthority` as
// others.
TEST(FormatOf, Ed269IsRecognisedWithoutAVolume) {
  EXPECT_EQ(format_of("b.json", R"({"UASZoneList":[]})"), Format::ed269);
  const std::string text =
      R"({"features":[{"identifier":"A","country":"CHE","name":"A","type":"COMMON",)"
      R"("restriction":"PROHIBITED","applicability":[{"permanent":"YES"}],"zoneAuthority":[],)"
      R"("geometry":[]}]})";
  EXPECT_EQ(format_of("b.json", text), Format::ed269);
  EXPECT_TRUE(contains(failure_of(Format::ed269, text), "features[0].geometry"));
  EXPECT_TRUE(contains(failure_of(Format::ed269, text), "at least one volume"));
}

// Plain GeoJSON would lose the heights and times of such a file.
TEST(FormatOf, Ed318IsRecognisedUnderTheExtensionOfGeoJson) {
  EXPECT_EQ(format_of("b.geojson", R"({"type":"FeatureCollection","zoneAuthority":[]})"),
            Format::ed318);
  for (const char* member : {"limitedApplicability", "lowerReference", "upperReference"}) {
    EXPECT_EQ(format_of("b.json", "{\"type\":1,\"" + std::string(member) + "\":0}"), Format::ed318);
  }
}

// Names and data may be called like members of another format.
TEST(FormatOf, WordsOfAnotherFormatDoNotHideLimits) {
  const std::string both = R"({"type":"FeatureCollection","features":[{"type":"Feature",)"
                           R"("properties":{"zoneAuthority":[],"limitedApplicability":[],)"
                           R"("restriction":"x","extendedProperties":{"applicability":1}}}]})";
  for (const char* path : {"b.json", "b.geojson", "b"}) {
    EXPECT_EQ(format_of(path, both), Format::ed318) << path;
  }
  EXPECT_EQ(format_of("b.geojson", R"({"features":[{"horizontalProjection":1}]})"), Format::ed269);
  const std::string pond = R"({"type":"Feature","properties":{"subType":"lake"}})";
  EXPECT_EQ(format_of("b.json", pond), Format::geojson);
  EXPECT_EQ(format_of("b.geojson", R"({"restriction":1,"applicability":2})"), Format::geojson);
}

TEST(FormatOf, NothingIsGuessed) {
  EXPECT_EQ(format_of("b.json", "{}"), std::nullopt);
  EXPECT_EQ(format_of("b.txt", "hello"), std::nullopt);
  EXPECT_EQ(format_of("b", ""), std::nullopt);
}

TEST(Read, TextsThatAreNoUtf8AreToldWithThePlace) {
  EXPECT_TRUE(
      contains(failure_of(Format::geojson, "{\n\"\xff\":1}"), "line 2, column 2: this byte"));
  // a zero is UTF-8, and no text
  EXPECT_TRUE(contains(failure_of(Format::geojson, std::string("{\0}", 3)),
                       "line 1, column 2: this byte is zero"));
  EXPECT_TRUE(contains(failure_of(Format::wkt, std::string("POINT EMPTY\n\0", 13)),
                       "line 2, column 1: this byte is zero"));
  EXPECT_TRUE(contains(failure_of(Format::geojson, "\xed\xa0\x80"), "no UTF-8"));  // a surrogate
  EXPECT_TRUE(contains(failure_of(Format::geojson, "\xc0\x80"), "no UTF-8"));  // longer than needed
  EXPECT_TRUE(contains(failure_of(Format::geojson, "\xf0\x9f\x98"), "no UTF-8"));  // cut off
}

TEST(Read, WhatIsNoTextIsOfNoFormat) {
  const std::string utf16("\xff\xfe{\0", 4);
  ASSERT_TRUE(no_text(utf16, {}));
  EXPECT_EQ(no_text(utf16, {})->message, "is UTF-16");
  EXPECT_EQ(no_text("hello", {}), std::nullopt);
}

TEST(Read, EmptyTextsAndArchivesAreTold) {
  EXPECT_TRUE(contains(failure_of(Format::geojson, " \r\n"), "is empty"));
  EXPECT_TRUE(contains(failure_of(Format::kml, "PK\x03\x04..."), "doc.kml"));
}

TEST(Read, ByteOrderMarkAndCarriageReturnsAreNoMatter) {
  EXPECT_EQ(failure_of(Format::geojson,
                       "\xef\xbb\xbf{\"type\":\r\n\"Polygon\",\"coordinates\":"
                       "[[[0,0],[9,0],[9,9],[0,0]]]}\r\n"),
            "");
}

TEST(Read, AreasAreLimitedInEveryFormat) {
  const std::string feature = R"({"type":"Feature","geometry":null,"properties":)"
                              R"({"identifier":"A","type":"CONDITIONAL"}})";
  const std::string features =
      R"({"type":"FeatureCollection","features":[)" + feature + "," + feature + "]}";
  const std::string zone =
      R"({"identifier":"A","restriction":"CONDITIONAL","applicability":[{"permanent":"YES"}],)"
      R"("geometry":[{"uomDimensions":"M","horizontalProjection":)"
      R"({"type":"Circle","center":[1,2],"radius":3}}]})";
  const std::string circle =
      R"({"circle":{"center":[1,2],"radius":3},"inclusion":true,"version":1})";
  const std::string item = " 0 0 5003 9 0 0 0 1 2 0 1\n";
  const std::vector<std::pair<Format, std::string>> texts{
      {Format::geojson, features},
      {Format::ed318, features},
      {Format::ed269, R"({"features":[)" + zone + "," + zone + "]}"},
      {Format::qgc_plan, R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"polygons":[],)"
                         R"("circles":[)" +
                             circle + "," + circle + "]}}"},
      {Format::waypoints, "QGC WPL 110\n0" + item + "1" + item},
      {Format::wkt, "POINT EMPTY POINT EMPTY"},
      {Format::kml, "<kml><Placemark/><Placemark/></kml>"},
      {Format::kml, "<kml><NetworkLink/><NetworkLink/></kml>"}};
  for (const auto& [format, text] : texts) {
    EXPECT_EQ(failure_of(format, text, {.areas_max = 2}), "") << text;
    EXPECT_TRUE(contains(failure_of(format, text, {.areas_max = 1}), "more than 1 areas")) << text;
  }
}

// Names of a file end up in messages: cut, on one line, and whole characters only.
TEST(Read, MessagesQuoteShortly) {
  const std::string name = std::string(59, 'a') + "\xc3\xa4" + std::string(100'000, 'b');
  const std::string message = failure_of(Format::geojson, R"({"type":")" + name + "\"}");
  EXPECT_LT(message.size(), 300U);
  EXPECT_TRUE(contains(message, "`" + std::string(59, 'a') + "...`"));
  EXPECT_TRUE(contains(failure_of(Format::geojson, R"({"type":"a\nb`c"})"), "`a b c`"));
}

}  // namespace
}  // namespace rtac::geometry::import
