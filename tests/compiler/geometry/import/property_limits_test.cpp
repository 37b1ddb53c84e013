// Properties of plain GeoJSON that limit an area for the program that wrote them: in height, in
// time.
#include "tests/compiler/geometry/import/testing.h"

namespace rtac::geometry::import {
namespace {

std::string feature(const std::string& properties) {
  return R"({"type":"Feature","properties":{)" + properties +
         R"(},"geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,0]]]}})";
}
std::string unread_height(const std::string& properties) {
  const Area area = only_area(Format::geojson, feature(properties));
  return area.unread_height ? area.unread_height->where + " " + area.unread_height->message : "";
}
std::string unread_time(const std::string& properties) {
  const Area area = only_area(Format::geojson, feature(properties));
  return area.unread_time ? area.unread_time->where + " " + area.unread_time->message : "";
}

TEST(PropertyLimits, HeightIsToldWithItsPlace) {
  EXPECT_EQ(unread_height(R"("a":1,"upperLimit":120)"),
            "properties.upperLimit sounds like a limit of height");
}

TEST(PropertyLimits, NamesOfHeightsAreFoundInEverySpelling) {
  for (const std::string name :
       {"UPPER_VAL",   "LOWER_VAL", "UPPER_DESC", "upper",    "lower",      "alt",   "alt_max",
        "altMax",      "ALTMAX",    "floor",      "floor_ft", "top",        "base",  "bottom",
        "height",      "maxheight", "elevation",  "elev",     "ele",        "h_max", "z_max",
        "zmin",        "agl",       "max_agl",    "maxAGL",   "msl",        "amsl",  "altitude",
        "flightLevel", "FL",        "ceiling",    "upper2",   "lower-limit"}) {
    EXPECT_NE(unread_height("\"" + name + "\":120"), "") << name;
  }
}

// A word of a name counts, not a part of a word; what numbers or measures other things does not.
TEST(PropertyLimits, NamesOfOtherThingsAreNoHeights) {
  for (const std::string name :
       {"population", "default", "alternative_id", "stop", "basement_id", "width", "base_id",
        "floorCount", "topology", "flow", "database", "slower", "saltmine", "h", "max"}) {
    EXPECT_EQ(unread_height("\"" + name + "\":120"), "") << name;
  }
}

TEST(PropertyLimits, TextsThatSayANumberAreHeights) {
  for (const std::string text :
       {"120", "-5", "400 ft", "400ft AGL", "FL95", "FL 95", "up to 400 ft", "max. 120.5 m"}) {
    EXPECT_NE(unread_height(R"("floor":")" + text + "\""), "") << text;
  }
  EXPECT_NE(unread_height(R"("MAX_ALTITUDE":"A450")"), "");
}

TEST(PropertyLimits, TextsAboutOtherThingsAreNoHeights) {
  EXPECT_EQ(unread_height(R"("floor":"second floor lobby","name":"Top Hill 3","base":"Edwards")"),
            "");
  for (const std::string text : {"Building 12", "Camp 5 Main", ""}) {
    EXPECT_EQ(unread_height(R"("base":")" + text + "\""), "") << text;
  }
  EXPECT_EQ(unread_height(R"("height":"low","altitudeMode":"clampToGround","UPPER_UOM":"FT")"), "");
}

TEST(PropertyLimits, ValuesOfOtherKindsCountWhenAHeightIsInThem) {
  EXPECT_NE(unread_height(R"("upper":{"value":120,"unit":"m"})"), "");
  EXPECT_NE(unread_height(R"("lowerCeiling":{"value":0})"), "");
  EXPECT_NE(unread_height(R"("floor":[0,120])"), "");
  EXPECT_EQ(unread_height(R"("base":["Edwards"],"top":{},"floor":true,"altitude":null)"), "");
}

// Of a huge text only the beginning is looked at.
TEST(PropertyLimits, HugeTextsTakeNoMemory) {
  const std::string huge = std::string(1'000, 'a') + " 400 ft";
  EXPECT_EQ(unread_height(R"("floor":")" + huge + "\""), "");
}

TEST(PropertyLimits, TimeIsToldWithItsPlace) {
  EXPECT_EQ(unread_time(R"("a":1,"valid_until":"2024-05-01")"),
            "properties.valid_until sounds like a limit of time");
}

TEST(PropertyLimits, NamesOfTimesAreFoundInEverySpelling) {
  for (const std::string name :
       {"valid_from", "validUntil", "startTime", "end_time", "schedule", "EFFECTIVE",
        "effectiveDate", "expires", "DATE_EXPIRE", "TIMESOFUSE", "start", "until"}) {
    EXPECT_NE(unread_time("\"" + name + R"(":"2024-05-01T08:00:00Z")"), "") << name;
    EXPECT_NE(unread_time("\"" + name + "\":1714550400"), "") << name;
  }
  EXPECT_NE(unread_time(R"("schedule":[{"days":"Mon"}])"), "");
  for (const std::string name :
       {"time_start", "from_date", "valid_till", "notam_start", "applicability", "timePeriod",
        "valid", "active", "when", "hours"}) {
    EXPECT_NE(unread_time("\"" + name + R"(":"2024-05-01T08:00:00Z")"), "") << name;
    EXPECT_NE(unread_time("\"" + name + R"(":{"startDateTime":"2024-05-01"})"), "") << name;
  }
}

TEST(PropertyLimits, TimesAreTextsInEveryForm) {
  for (const std::string text :
       {"Mon-Fri", "8:00", "8 am", "1.5.24", "05/01/2024", "2024-05", "20240501", "May 1", "2024",
        "weekdays", "2024-01-01/2024-02-01"}) {
    EXPECT_NE(unread_time(R"("start":")" + text + "\""), "") << text;
  }
  for (const std::string text : {"Route 1234", "swisstopo 2023", "25000 m2", "3", "dam 7-12", ""}) {
    EXPECT_EQ(unread_time(R"("start":")" + text + "\""), "") << text;
  }
}

TEST(PropertyLimits, OtherDatesAndOtherValuesAreNoLimitsOfTime) {
  for (const std::string property :
       {R"("created":"2024-05-01")", R"("last_edited_date":"2024-05-01")", R"("effective":"yes")",
        R"("schedule":null)", R"("expires":"never")", R"("schedule_id":"S-1234")",
        R"("effective_area":"2024-05-01")", R"("active":true)", R"("valid":"yes")",
        R"("weekend":1714550400)", R"("start":3)"}) {
    EXPECT_EQ(unread_time(property), "") << property;
  }
}

}  // namespace
}  // namespace rtac::geometry::import
