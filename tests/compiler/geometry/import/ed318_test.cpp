// ED-318: GeoJSON with layers, circles and times.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

const std::string layer =
    R"("layer":{"upper":150,"upperReference":"AGL","lower":50,"lowerReference":"AMSL","uom":"ft"})";
const std::string triangle =
    R"("type":"Polygon","coordinates":[[[6.1,49.5],[6.2,49.5],[6.2,49.6],[6.1,49.5]]])";
const std::string point = R"("type":"Point","coordinates":[6.1,49.5])";

std::string file(const std::string& geometry, const std::string& properties = "",
                 const std::string& type = "PROHIBITED") {
  return R"({"type":"FeatureCollection","metadata":{"validFrom":"2026-01-01T00:00:00Z"},"features":[)"
         R"({"type":"Feature","geometry":{)" +
         geometry +
         R"(},"properties":{"identifier":"NFZ1","country":"LUX","variant":"COMMON","type":")" +
         type +
         R"(","zoneAuthority":[],"name":[{"text":"Port","lang":"en-GB"},{"text":"Hafen","lang":"de"}])" +
         properties + "}}]}";
}
Area area_of(const std::string& text) {
  return only_area(Format::ed318, text);
}
std::string failure(const std::string& text) {
  return failure_of(Format::ed318, text);
}

TEST(Ed318, FileIsRecognisedAndRead) {
  const std::string text = file(triangle + "," + layer);
  EXPECT_EQ(format_of("zones.json", text), Format::ed318);
  const Area area = area_of(text);
  EXPECT_EQ(area.name, "NFZ1");
  EXPECT_EQ(area.other_names, (std::vector<std::string>{"Port", "Hafen"}));
  EXPECT_EQ(area.role, Role::keep_out);
  EXPECT_DOUBLE_EQ(area.parts.at(0).band.ceiling->value_m, 45.72);
  EXPECT_EQ(area.parts[0].band.ceiling->reference, AltitudeReference::ground);
  EXPECT_EQ(area.parts[0].band.floor->reference, AltitudeReference::mean_sea_level);
}

TEST(Ed318, LayersOfACollectionAreTheirOwn) {
  const Area area = area_of(file(R"("type":"GeometryCollection","geometries":[{)" + triangle + "," +
                                 layer + "},{" + triangle + "}]"));
  ASSERT_EQ(area.parts.size(), 2U);
  EXPECT_TRUE(area.parts[0].band.ceiling);
  EXPECT_FALSE(area.parts[1].band.ceiling);
}

TEST(Ed318, PointWithAnExtentIsACircle) {
  const Area area =
      area_of(file(point + R"(,"extent":{"subType":"Circle","radius":3500},)" + layer));
  EXPECT_EQ(circle_of(area).radius_m, 3500);
  EXPECT_EQ(circle_of(area).centre, (Position{6.1, 49.5}));
  EXPECT_TRUE(area.parts[0].band.floor);
  EXPECT_TRUE(contains(refusal_of(area_of(file(point))), "a Point encloses nothing"));
}

TEST(Ed318, MetadataIsNoted) {
  const Areas areas = areas_of(Format::ed318, file(triangle));
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].where, "metadata.validFrom");
}

TEST(Ed318, LimitsInAnotherSpellingAreRefused) {
  const std::string text = "is no member that the format has, and sounds like a limit";
  EXPECT_TRUE(contains(failure(file(triangle, R"(,"upperLimit":120)")), "properties.upperLimit"));
  EXPECT_TRUE(contains(failure(file(triangle + R"(,"verticalLimits":{})")), text));
  EXPECT_TRUE(contains(failure(file(triangle + R"(,"layer":{"uom":"m","ceiling":120})")), text));
  EXPECT_TRUE(contains(
      failure(file(point + R"(,"extent":{"subType":"Circle","radius":9,"unit":"ft"})")), text));
}

TEST(Ed318, ApplicabilityIsASchedule) {
  const Area area = area_of(file(
      triangle,
      R"(,"limitedApplicability":[{"startDateTime":"2026-01-01T00:00:00Z","schedule":[{"day":["ANY"],"startTime":"16:00:00Z","endTime":"17:00:00Z"},{"day":["SUN"],"startTime":"10:00:00Z","endTime":"12:00:00Z"}]}])"));
  ASSERT_EQ(area.schedule.size(), 2U);
  EXPECT_EQ(area.schedule[0].weekdays, 0x7f);
  EXPECT_EQ(area.schedule[1].weekdays, 0x40);
  EXPECT_TRUE(area.schedule[1].from_us);
}

TEST(Ed318, SchedulesThatFollowTheSunRefuseTheArea) {
  const Area area = area_of(file(
      triangle,
      R"(,"limitedApplicability":[{"schedule":[{"day":["ANY"],"startEvent":"SR","endTime":"17:00:00Z"}]}])"));
  EXPECT_TRUE(contains(refusal_of(area), "startEvent: follows the sun: the text `SR`"));
}

TEST(Ed318, FaultsAreTold) {
  const auto with_layer = [](const std::string& members) {
    return failure(file(triangle + R"(,"layer":{)" + members + "}"));
  };
  EXPECT_TRUE(
      contains(with_layer(R"("upper":1,"upperReference":"AGL")"), "lacks the member `uom`"));
  EXPECT_TRUE(contains(
      with_layer(R"("upper":1,"upperReference":"AGL","lower":2,"lowerReference":"AGL","uom":"m")"),
      "features[0].geometry.layer: the band of altitude is upside down"));
  EXPECT_TRUE(contains(failure(file(point + R"(,"extent":{"subType":"Ellipse","radius":1})")),
                       "is `Ellipse`"));
  EXPECT_TRUE(contains(failure(file(point + R"(,"extent":{"subType":"Circle","radius":0})")),
                       "a radius of 0 m"));
  EXPECT_TRUE(contains(failure(file(triangle + R"(,"extent":{})")), "only points have an extent"));
  EXPECT_TRUE(contains(failure(file(R"("type":"GeometryCollection","geometries":[],)" + layer)),
                       "has no heights of its own"));
  EXPECT_TRUE(
      contains(failure(file(triangle, "", "FORBIDDEN")), "properties.type: is `FORBIDDEN`"));
  EXPECT_TRUE(contains(failure(R"({"type":"Feature","geometry":null,"properties":null})"),
                       "properties: is `null`"));
}

}  // namespace
}  // namespace rtac::geometry::import
