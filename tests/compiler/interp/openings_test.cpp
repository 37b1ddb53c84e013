// When zones are there, on a calendar of its own (rule 7.4).
#include "compiler/interp/openings.h"

#include "tests/compiler/interp/testing.h"

namespace rtac::interp::test {
namespace {

using Lines = std::vector<std::string>;

constexpr std::int64_t second_us = 1'000'000, hour_us = 3600 * second_us, day_us = 24 * hour_us;

// Of a zone that is there at these times.
bool open(const std::string& during, std::int64_t now_us) {
  const auto c = monitor(
      "clock utc;\nzone z = circle (0 m, 0 m) radius 1 m during " + during + ";\ninput p : point;",
      "p inside z");
  return is_open(c->spec->zones.front().openings, now_us);
}

// The first instant belongs to a window, the last does not.
TEST(Openings, BeginAtTheirFirstInstantAndEndBeforeTheirLast) {
  const std::string noon = "1970-01-02T12:00Z .. 1970-01-02T12:00:01Z";
  const std::int64_t from_us = day_us + 12 * hour_us;
  EXPECT_FALSE(open(noon, from_us - 1));
  EXPECT_TRUE(open(noon, from_us));
  EXPECT_TRUE(open(noon, from_us + second_us - 1));
  EXPECT_FALSE(open(noon, from_us + second_us));
}
// 1970-01-01 was a Thursday; 2000-02-29 a Tuesday.
TEST(Openings, KnowTheDaysOfTheWeek) {
  EXPECT_TRUE(open("thursday 00:00 .. 24:00", 0));
  EXPECT_FALSE(open("thursday 00:00 .. 24:00", -1));
  EXPECT_TRUE(open("wednesday 23:00 .. 24:00", -1));
  EXPECT_TRUE(open("friday 00:00 .. 24:00", day_us));
  const std::int64_t leap_day_us = 951782400 * second_us;
  EXPECT_TRUE(open("tuesday 00:00 .. 00:01", leap_day_us));
  EXPECT_TRUE(open("2000-02-29T00:00Z .. 2000-02-29T00:01Z", leap_day_us));
  EXPECT_FALSE(open("monday, wednesday 00:00 .. 24:00", leap_day_us));
}
TEST(Openings, WithoutDaysAreThoseOfEveryDay) {
  for (int day = 0; day < 7; ++day) {
    EXPECT_TRUE(open("07:30 .. 16:00", day * day_us + 8 * hour_us));
    EXPECT_FALSE(open("07:30 .. 16:00", day * day_us + 16 * hour_us));
  }
}
// The clock may say anything.
TEST(Openings, AreKnownAtBothEndsOfTime) {
  for (const std::int64_t now_us :
       {std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_TRUE(open("00:00 .. 24:00", now_us));
    EXPECT_FALSE(open("1970-01-01T00:00Z .. 9999-12-31T23:59Z", now_us));
  }
}

// One point a second, from 1970-01-01T00:00:00Z on; the zone is there in the seconds 1 and 2.
Lines found(const std::string& condition) {
  const auto c = monitor(
      "clock utc;\nzone z = rectangle (0 m, 0 m) to (4 m, 4 m) during 00:00:01 .. 00:00:03;\n"
      "input p : point in -20 .. 20 m;",
      condition);
  return judge(*c, "time,p.x,p.y\n0,1,1\n1,1,1\n2,6,1\n3,1,1\n4,nan,1\n");
}
TEST(Openings, OutsideOfThemAZoneIsEmpty) {
  EXPECT_EQ(found("p inside z"), (Lines{"false [-inf, -inf]", "true [1, 1] m", "false [-2, -2] m",
                                        "false [-inf, -inf]", "false [-inf, -inf]"}));
}
TEST(Openings, OutsideOfThemAZoneIsFarAway) {
  EXPECT_EQ(found("distance(p, z) >= 1 m"),
            (Lines{"true [inf, inf]", "false [-1, -1] m", "true [1, 1] m", "true [inf, inf]",
                   "true [inf, inf]"}));
  EXPECT_EQ(found("distance(p, z) <= 1 m").front(), "false [-inf, -inf]");
  EXPECT_EQ(found("3 m - 2 * distance(p, z) >= 1 m").front(), "false [-inf, -inf]");
}
TEST(Openings, OutsideOfThemThereIsNoClearance) {
  EXPECT_EQ(found("clearance(p, z) >= 0.5 m"),
            (Lines{"false [-inf, -inf]", "true [0.5, 0.5] m", "false [-2.5, -2.5] m",
                   "false [-inf, -inf]", "false [-inf, -inf]"}));
  EXPECT_EQ(found("clearance(p, z) <= 0.5 m").front(), "true [inf, inf]");
}

}  // namespace
}  // namespace rtac::interp::test
