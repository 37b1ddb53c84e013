// ED-269: stacks of volumes with heights of their own, circles, and times at which a zone applies.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

const std::string heights =
    R"("uomDimensions":"M","lowerLimit":0,"lowerVerticalReference":"AGL","upperLimit":120,"upperVerticalReference":"AGL")";
const std::string triangle =
    R"("horizontalProjection":{"type":"Polygon","coordinates":[[[6.1,49.5],[6.2,49.5],[6.2,49.6],[6.1,49.5]]]})";
const std::string circle =
    R"("horizontalProjection":{"type":"Circle","center":[6.1,49.5],"radius":500})";
const std::string always = R"({"permanent":"YES"})";

std::string zone(const std::string& volumes, const std::string& periods = always,
                 const std::string& restriction = "PROHIBITED") {
  return R"({"identifier":"LUX0001","country":"LUX","name":"Airport","type":"COMMON","restriction":")" +
         restriction + R"(","applicability":[)" + periods + R"(],"zoneAuthority":[],"geometry":[)" +
         volumes + "]}";
}
std::string file(const std::string& zones) {
  return R"({"title":"zones","features":[)" + zones + "]}";
}
std::string volume(const std::string& limits = heights, const std::string& shape = triangle) {
  return "{" + limits + "," + shape + "}";
}
Area area_of(const std::string& zones) {
  return only_area(Format::ed269, file(zones));
}
std::string failure(const std::string& zones) {
  return failure_of(Format::ed269, file(zones));
}
std::vector<Period> schedule_of(const std::string& periods) {
  return area_of(zone(volume(), periods)).schedule;
}
std::string refusal(const std::string& periods) {
  return refusal_of(area_of(zone(volume(), periods)));
}

TEST(Ed269, ZoneHasNamesRestrictionAndRole) {
  const Area area = area_of(zone(volume()));
  EXPECT_EQ(area.name, "LUX0001");
  EXPECT_EQ(area.other_names, std::vector<std::string>{"Airport"});
  EXPECT_EQ(area.restriction, "PROHIBITED");
  EXPECT_EQ(area.role, Role::keep_out);
  EXPECT_TRUE(area.schedule.empty());
  EXPECT_EQ(polygon_of(area).outer.positions.at(1), (Position{6.2, 49.5}));
}

// Who may enter depends on permissions that the file does not know.
TEST(Ed269, OtherRestrictionsLeaveTheRoleOpen) {
  for (const char* name : {"REQ_AUTHORISATION", "CONDITIONAL", "NO_RESTRICTION"}) {
    const Area area = area_of(zone(volume(), always, name));
    EXPECT_EQ(area.role, Role::unstated);
    EXPECT_EQ(area.restriction, name);
  }
  EXPECT_TRUE(
      contains(failure(zone(volume(), always, "FORBIDDEN")), "restriction: is `FORBIDDEN`"));
}

TEST(Ed269, StackedVolumesArePartsWithTheirOwnHeightsInMetres) {
  const Area area = area_of(zone(
      volume(
          R"("uomDimensions":"FT","lowerLimit":1000,"lowerVerticalReference":"AMSL","upperLimit":2000,"upperVerticalReference":"WGS84")") +
      "," + volume(R"("uomDimensions":"M")")));
  ASSERT_EQ(area.parts.size(), 2U);
  const Band& band = area.parts[0].band;
  EXPECT_DOUBLE_EQ(band.floor->value_m, 304.8);
  EXPECT_EQ(band.floor->reference, AltitudeReference::mean_sea_level);
  EXPECT_DOUBLE_EQ(band.ceiling->value_m, 609.6);
  EXPECT_EQ(band.ceiling->reference, AltitudeReference::ellipsoid);
  EXPECT_FALSE(area.parts[1].band.floor || area.parts[1].band.ceiling);
}

// 200 m above the sea may well be below 120 m above the ground.
TEST(Ed269, HeightsOfDifferentReferencesAreNotCompared) {
  const Area area =
      area_of(zone(volume(R"("uomDimensions":"M","lowerLimit":200,"lowerVerticalReference":"AMSL",)"
                          R"("upperLimit":120,"upperVerticalReference":"AGL")")));
  EXPECT_TRUE(area.parts.at(0).band.floor && area.parts[0].band.ceiling);
}

TEST(Ed269, CirclesAreInMetres) {
  EXPECT_EQ(circle_of(area_of(zone(volume(heights, circle)))).radius_m, 500);
  EXPECT_EQ(circle_of(area_of(zone(volume(heights, circle)))).centre, (Position{6.1, 49.5}));
  EXPECT_TRUE(contains(refusal_of(area_of(zone(volume(R"("uomDimensions":"FT")", circle)))),
                       "disagree on the unit of its radius"));
}

TEST(Ed269, PeriodsAreMomentsAndDays) {
  const auto schedule = schedule_of(
      R"({"permanent":"NO","startDateTime":"2026-01-01T00:00:00Z","endDateTime":"2026-02-01T00:00:00Z",)"
      R"("schedule":[{"day":["MON","SUN"],"startTime":"08:00:00.00Z","endTime":"17:30Z"}]})");
  ASSERT_EQ(schedule.size(), 1U);
  EXPECT_EQ(*schedule[0].until_us - *schedule[0].from_us, 31LL * 86'400 * 1'000'000);
  EXPECT_EQ(schedule[0].weekdays, 0x41);
  EXPECT_EQ(schedule[0].from_s, 28'800);
  EXPECT_EQ(schedule[0].until_s, 63'000);
}

TEST(Ed269, NightsAreTwoPeriods) {
  const auto schedule = schedule_of(
      R"({"permanent":"NO","schedule":[{"day":["SUN"],"startTime":"22:00Z","endTime":"06:00Z"}]})");
  ASSERT_EQ(schedule.size(), 2U);
  EXPECT_EQ(schedule[0].weekdays, 0x40);
  EXPECT_EQ(schedule[0].until_s, 86'400);
  EXPECT_EQ(schedule[1].weekdays, 0x01);
  EXPECT_EQ(schedule[1].until_s, 21'600);
}

// Otherwise the zone would be open for a minute every night.
TEST(Ed269, LastMinuteOfADayIsItsEnd) {
  for (const char* end : {"23:59Z", "23:59:59Z", "23:59:59.99Z"}) {
    EXPECT_TRUE(
        schedule_of(
            std::string(
                R"({"permanent":"NO","schedule":[{"day":["ANY"],"startTime":"00:00Z","endTime":")") +
            end + "\"}]}")
            .empty())
        << end;
  }
  const auto local = schedule_of(
      R"({"permanent":"NO","schedule":[{"day":["MON"],"startTime":"12:00+02:00","endTime":"23:59+02:00"}]})");
  EXPECT_EQ(local.at(0).until_s, 22 * 3600);
}

// An end that is not later than the beginning is on the next day, whatever minute it is in.
TEST(Ed269, WhatBeginsInTheLastMinuteOfADayGoesOnForADay) {
  const auto until = [](const std::string& end) {
    return schedule_of(
        R"({"permanent":"NO","schedule":[{"day":["ANY"],"startTime":"23:59:30Z","endTime":")" +
        end + "\"}]}");
  };
  EXPECT_TRUE(until("23:59:00Z").empty());  // with the minute that ends the day all of it
  std::int32_t open_s = 0;
  for (const Period& period : until("23:59:10Z")) open_s += period.until_s - period.from_s;
  EXPECT_EQ(open_s, 86'400 - 20);
}

TEST(Ed269, HeightsBeyondWhatFliesAreTold) {
  for (const char* height : {"1e300", "-1e14", "1000001"}) {
    const std::string text = zone(volume(), always);
    const std::size_t at = text.find("\"upperLimit\":") + 13;
    const std::string with = text.substr(0, at) + height + text.substr(text.find(',', at));
    EXPECT_TRUE(contains(failure(with), "a limit of height of ")) << with;
  }
}

TEST(Ed269, PartsOfADayThatMeetAreNoLimit) {
  EXPECT_TRUE(
      schedule_of(
          R"({"permanent":"NO","schedule":[{"day":["ANY"],"startTime":"12:00Z","endTime":"23:59Z"},)"
          R"({"day":["ANY"],"startTime":"00:00Z","endTime":"12:00Z"}]})")
          .empty());
}

TEST(Ed269, OnePermanentPeriodIsEnough) {
  EXPECT_TRUE(
      schedule_of(R"({"permanent":"NO","endDateTime":"2026-02-01T00:00:00Z"},)" + always).empty());
}

TEST(Ed269, ContradictoryTimesRefuseTheArea) {
  EXPECT_TRUE(contains(refusal(R"({"permanent":"YES","startDateTime":"2026-02-01T00:00:00Z"})"),
                       "is permanent, and limited in time"));
  EXPECT_TRUE(contains(refusal(R"({"permanent":"NO","schedule":[]})"), "says no time"));
  EXPECT_TRUE(contains(
      refusal(
          R"({"permanent":"NO","startDateTime":"2026-02-01T00:00:00Z","endDateTime":"2026-01-01T00:00:00Z"})"),
      "ends before it starts"));
  EXPECT_TRUE(contains(
      refusal(
          R"({"permanent":"NO","schedule":[{"day":["ANY"],"startTime":"08:00Z","endTime":"08:00Z"}]})"),
      "schedule[0]: ends when it starts"));
}

TEST(Ed269, TimesWithoutAZoneAreToldWithTheirValue) {
  EXPECT_TRUE(contains(
      failure(zone(volume(), R"({"permanent":"NO","startDateTime":"2026-02-01T00:00:00"})")),
      "features[0].applicability[0].startDateTime: is the text `2026-02-01T00:00:00`"));
  EXPECT_TRUE(contains(
      failure(zone(
          volume(),
          R"({"permanent":"NO","schedule":[{"day":["ANY"],"startTime":"8:00Z","endTime":"09:00Z"}]})")),
      "startTime: is the text `8:00Z`"));
  EXPECT_TRUE(contains(
      failure(zone(
          volume(),
          R"({"permanent":"NO","schedule":[{"day":["ANY"],"startTime":"08:00Z","endTime":"24:00:00Z"}]})")),
      "endTime: is the text `24:00:00Z` (a time of day up to 23:59:59 with its zone"));
  EXPECT_TRUE(contains(
      failure(zone(
          volume(),
          R"({"permanent":"NO","schedule":[{"day":["Monday"],"startTime":"08:00Z","endTime":"09:00Z"}]})")),
      "day[0]: is the text `Monday`"));
  EXPECT_TRUE(contains(failure(zone(volume(), R"({"permanent":true})")), "permanent: is `true`"));
}

TEST(Ed269, FaultsOfVolumesAreTold) {
  EXPECT_TRUE(contains(
      failure(zone(volume(
          R"("uomDimensions":"M","lowerLimit":200,"lowerVerticalReference":"AGL","upperLimit":120,"upperVerticalReference":"AGL")"))),
      "features[0].geometry[0]: the band of altitude is upside down: from 200 m up to 120 m"));
  EXPECT_TRUE(contains(failure(zone(volume(R"("uomDimensions":"KM")"))), "uomDimensions: is `KM`"));
  EXPECT_TRUE(
      contains(failure(zone(volume(R"("lowerLimit":0)"))), "lacks the member `uomDimensions`"));
  EXPECT_TRUE(contains(failure(zone(volume(R"("uomDimensions":"M","upperLimit":"120")"))),
                       "upperLimit: is the text `120`"));
  EXPECT_TRUE(contains(failure(zone(volume(R"("uomDimensions":"M","upperLimit":120)"))),
                       "lacks the member `upperVerticalReference`"));
  EXPECT_TRUE(contains(
      failure(
          zone(volume(R"("uomDimensions":"M","upperLimit":120,"upperVerticalReference":"STD")"))),
      "is `STD`"));
  EXPECT_TRUE(
      contains(failure(zone(volume(heights, R"("horizontalProjection":{"type":"Ellipse"})"))),
               "is `Ellipse`"));
  EXPECT_TRUE(contains(failure(zone("")), "geometry: is an empty array"));
  EXPECT_TRUE(contains(failure(zone(volume(), "")), "applicability: is an empty array"));
  EXPECT_TRUE(contains(failure("{}"), "features[0]: lacks the member `identifier`"));
}

TEST(Ed269, SwissListIsRead) {
  EXPECT_EQ(areas_of(Format::ed269, R"({"UASZoneList":[)" + zone(volume()) + "]}").areas.size(),
            1U);
}

// `upperlimit` would be no limit.
TEST(Ed269, LimitsInOtherLettersAreRefused) {
  EXPECT_TRUE(contains(
      failure(zone(volume(R"("uomDimensions":"M","upperlimit":9,"upperVerticalReference":"AGL")"))),
      "features[0].geometry[0].upperlimit: is no member that the format has (write "
      "it as `upperLimit`"));
  EXPECT_TRUE(contains(
      failure(zone(volume(), R"({"permanent":"YES","StartDateTime":"2026-02-01T00:00:00Z"})")),
      "applicability[0].StartDateTime: is no member"));
  EXPECT_TRUE(contains(
      failure(zone(
          volume(),
          R"({"permanent":"NO","schedule":[{"day":["MON"],"starttime":"08:00Z","endTime":"9:00Z"}]})")),
      "schedule[0].starttime: is no member"));
}

// Nor would one in another spelling. What limits nothing is left out, and noted once.
TEST(Ed269, MembersThatTheFormatDoesNotHaveAreToldOrNoted) {
  for (const std::string member : {R"("verticalLimits":[0,9])", R"("maxAltitude":9)",
                                   R"("upper_limit":9)", R"("Holes":[])", R"("uom":"M")"}) {
    EXPECT_TRUE(contains(failure(zone(volume(R"("uomDimensions":"M",)" + member))),
                         "is no member that the format has, and sounds like a limit"))
        << member;
  }
  EXPECT_TRUE(
      contains(failure(zone(volume(), R"({"permanent":"YES","until":"2026-02-01T00:00:00Z"})")),
               "applicability[0].until: is no member that a period has"));
  const std::string marked = volume(R"("uomDimensions":"M","colour":"red")");
  const Areas areas = areas_of(Format::ed269, file(zone(marked + "," + marked)));
  ASSERT_EQ(areas.notes.size(), 1U);
  EXPECT_EQ(areas.notes[0].where, "features[0].geometry[0].colour");
  EXPECT_EQ(areas.notes[0].message, "is no member that the format has, and is left out");
}

TEST(Ed269, PolygonsWithARadiusRefuseToBeUsed) {
  EXPECT_TRUE(contains(
      refusal_of(area_of(zone(volume(
          heights,
          R"("horizontalProjection":{"type":"Polygon","radius":50,"coordinates":[[[6.1,49.5],[6.2,49.5],[6.2,49.6],[6.1,49.5]]]})")))),
      "radius: a polygon has no radius"));
}

TEST(Ed269, TwoListsOfZonesAreRefused) {
  EXPECT_TRUE(contains(failure_of(Format::ed269, R"({"UASZoneList":[)" + zone(volume()) +
                                                     R"(],"features":[)" + zone(volume()) + "]}"),
                       "features: stands beside `UASZoneList`"));
}

}  // namespace
}  // namespace rtac::geometry::import
