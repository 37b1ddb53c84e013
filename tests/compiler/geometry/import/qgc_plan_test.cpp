// The fence of a QGroundControl plan: keep-in and keep-out, latitude first, rings without end.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

const std::string triangle = R"("polygon":[[47.1,8.5],[47.2,8.5],[47.2,8.6]])";

std::string plan(const std::string& polygons, const std::string& circles = "",
                 const std::string& more = "") {
  return R"({"fileType":"Plan","groundStation":"QGroundControl","version":1,"mission":{"items":[]},)"
         R"("geoFence":{"version":2,"polygons":[)" +
         polygons + R"(],"circles":[)" + circles + "]" + more + "}}";
}
std::string item(const std::string& members, const std::string& version = "1") {
  return "{" + members + R"(,"inclusion":true,"version":)" + version + "}";
}
std::string failure(const std::string& text) {
  return failure_of(Format::qgc_plan, text);
}

TEST(QgcPlan, InclusionsKeepInAndExclusionsKeepOut) {
  const Areas areas = areas_of(Format::qgc_plan, plan(item(triangle) + ",{" + triangle +
                                                      R"(,"inclusion":false,"version":1})"));
  ASSERT_EQ(areas.areas.size(), 2U);
  EXPECT_EQ(areas.areas[0].role, Role::keep_in);
  EXPECT_EQ(areas.areas[1].role, Role::keep_out);
  EXPECT_EQ(areas.areas[0].group, std::nullopt);  // plans know no groups
}

TEST(QgcPlan, PositionsAreTurnedToLongitudeFirst) {
  const Ring outer = polygon_of(only_area(Format::qgc_plan, plan(item(triangle)))).outer;
  ASSERT_EQ(outer.positions.size(), 3U);
  EXPECT_EQ(outer.positions[0], (Position{8.5, 47.1}));
  EXPECT_FALSE(outer.closed);
  EXPECT_EQ(outer.where, "geoFence.polygons[0].polygon");
}

TEST(QgcPlan, CirclesHaveTheirRadiusInMetres) {
  const Area area = only_area(Format::qgc_plan,
                              plan("", item(R"("circle":{"center":[47.1,8.5],"radius":319.85})")));
  EXPECT_EQ(circle_of(area).centre, (Position{8.5, 47.1}));
  EXPECT_EQ(circle_of(area).radius_m, 319.85);
}

TEST(QgcPlan, ReturnPointIsNoted) {
  const Areas areas =
      areas_of(Format::qgc_plan, plan(item(triangle), "", R"(,"breachReturn":[47.1,8.5,60])"));
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].where, "geoFence.breachReturn");
}

TEST(QgcPlan, OtherVersionsAreRefused) {
  EXPECT_TRUE(
      contains(failure(plan(item(triangle, "2"))), "geoFence.polygons[0]: is of version 2"));
  EXPECT_TRUE(
      contains(failure(R"({"fileType":"Plan","version":1,"geoFence":{"version":1,"polygon":[]}})"),
               "geoFence: is of version 1"));
  EXPECT_TRUE(contains(failure(R"({"fileType":"Plan","version":3})"), "is of version 3"));
}

// Programs that build on QGroundControl write such members.
TEST(QgcPlan, AreasWithUnknownMembersRefuseToBeUsed) {
  const Area area = only_area(Format::qgc_plan, plan(item(triangle + R"(,"maxAltitude":120)")));
  EXPECT_TRUE(
      contains(refusal_of(area), "geoFence.polygons[0].maxAltitude: QGroundControl has no"));
}

TEST(QgcPlan, CirclesWithUnknownMembersRefuseToBeUsed) {
  const Area area =
      only_area(Format::qgc_plan,
                plan("", item(R"("circle":{"center":[47.1,8.5],"radius":300,"unit":"ft"})")));
  EXPECT_TRUE(contains(refusal_of(area), "geoFence.circles[0].circle.unit: QGroundControl has no"));
}

// A list of areas, a limit of height or a switch that is not known would be lost.
TEST(QgcPlan, FencesWithUnknownMembersAreRefused) {
  for (const std::string name :
       {"exclusionPolygons", "rectangles", "maxAltitude", "params", "enabled", "Circles"}) {
    EXPECT_TRUE(contains(failure(plan(item(triangle), "", ",\"" + name + "\":[]")),
                         "geoFence." + name + ": QGroundControl has no member `" + name + "` here"))
        << name;
  }
}

TEST(QgcPlan, OtherMembersOfThePlanAreNotedUnlessTheySoundLikeAFence) {
  const auto with = [](const std::string& members) {
    return R"({"fileType":"Plan","version":1,"geoFence":{"version":2,"polygons":[)" +
           item(triangle) + R"(],"circles":[]},)" + members + "}";
  };
  const Areas areas = areas_of(
      Format::qgc_plan, with(R"("groundStation":"x","mission":{},"rallyPoints":{},"airframe":1)"));
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].where, "airframe");
  EXPECT_TRUE(contains(failure(with(R"("GeoFence":{})")),
                       "GeoFence: QGroundControl has no member `GeoFence` here (the fence"));
}

TEST(QgcPlan, WhatIsMissingOrOfTheWrongKindIsTold) {
  EXPECT_TRUE(
      contains(failure(R"({"fileType":"Plan","version":1})"), "lacks the member `geoFence`"));
  EXPECT_TRUE(contains(failure(R"({"fileType":"Mission"})"), "fileType: is `Mission`"));
  EXPECT_TRUE(
      contains(failure(plan("{" + triangle + R"(,"version":1})")), "lacks the member `inclusion`"));
  EXPECT_TRUE(contains(failure(plan("{" + triangle + R"(,"version":1,"inclusion":1})")),
                       "inclusion: is the number 1"));
  EXPECT_TRUE(contains(failure(plan(item(R"("polygon":[[47.1,8.5],[47.2,null]])"))),
                       "polygon[1]: is an array"));
  EXPECT_TRUE(
      contains(failure(plan(item(R"("polygon":[[47.1,8.5],[47.2,8]])"))), "has 2 positions"));
  EXPECT_TRUE(contains(failure(plan("", item(R"("circle":{"center":[47.1,8.5],"radius":-1})"))),
                       "a radius of -1 m"));
  EXPECT_TRUE(contains(failure(plan("")), "has no areas"));
}

TEST(QgcPlan, SwappedAxesAreSuspected) {
  EXPECT_TRUE(contains(failure(plan(item(R"("polygon":[[138.1,-35],[138.2,-35],[138.2,-34]])"))),
                       "the axes look swapped"));
}

}  // namespace
}  // namespace rtac::geometry::import
