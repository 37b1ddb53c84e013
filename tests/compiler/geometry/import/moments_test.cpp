// Dates and times: only those that exist and name their zone; days of UTC whatever the zone.
#include "compiler/geometry/import/moments.h"

#include <gtest/gtest.h>

#include <random>

namespace rtac::geometry::import {
namespace {

constexpr std::int64_t second_us = 1'000'000;
constexpr std::int32_t hour_s = 3600, day_s = 86'400;

TEST(Moments, AreMicrosecondsSince1970) {
  EXPECT_EQ(parse_moment_us("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(parse_moment_us("1970-01-02T00:00Z"), day_s * second_us);
  EXPECT_EQ(parse_moment_us("2018-12-31T15:59:59Z"), 1'546'271'999 * second_us);
  EXPECT_EQ(parse_moment_us("1969-12-31T23:59:59.25Z"), -second_us + 250'000);
  EXPECT_EQ(parse_moment_us("1970-01-01T02:00:00+02:00"), 0);
  EXPECT_EQ(parse_moment_us("1969-12-31T22:30:00-0130"), 0);
  EXPECT_EQ(parse_moment_us("2024-02-29T00:00:00.1234567Z").has_value(), true);
}

TEST(Moments, OthersAreNone) {
  for (const char* text :
       {"", "2024", "2024-02-30T00:00:00Z", "2023-02-29T00:00:00Z", "2024-13-01T00:00:00Z",
        "2024-01-01", "2024-01-01T00:00:00", "2024-01-01T24:00:00Z", "2024-01-01T00:60:00Z",
        "2024-01-01T00:00:60Z", "2024-01-01T00:00:00.Z", "2024-01-01 00:00:00Z",
        "2024-01-01T00:00:00Zx", "2024-01-01T00:00:00+2:00", "24-01-01T00:00:00Z"}) {
    EXPECT_EQ(parse_moment_us(text), std::nullopt) << text;
  }
}

TEST(Moments, TimesOfDayKeepWholeSecondsAroundAFraction) {
  const auto time = parse_time_of_day("17:30:00.5+02:00");
  ASSERT_TRUE(time);
  EXPECT_EQ(time->earliest_s, 17 * hour_s + 1800);
  EXPECT_EQ(time->latest_s, 17 * hour_s + 1801);
  EXPECT_EQ(time->offset_s, 2 * hour_s);
  EXPECT_EQ(parse_time_of_day("17:30"), std::nullopt);
  EXPECT_EQ(parse_time_of_day("24:00Z"), std::nullopt);
}

bool is_covered(const std::vector<Period>& periods, std::int64_t utc_s) {
  const std::int64_t days = utc_s / day_s, of_day_s = utc_s % day_s;
  const auto weekday = (days + 3) % 7;  // 1970-01-01 was a Thursday
  for (const Period& period : periods) {
    if ((period.weekdays >> weekday & 1) != 0 && of_day_s >= period.from_s &&
        of_day_s < period.until_s) {
      return true;
    }
  }
  return false;
}

// Random windows against a walk over the local clock of two weeks.
TEST(Moments, DailyPeriodsCoverTheWindowOfTheLocalDays) {
  std::mt19937 random(20);
  const auto below = [&](int end) {
    return static_cast<std::int32_t>(random() % static_cast<unsigned>(end));
  };
  for (int round = 0; round < 2000; ++round) {
    const std::int32_t offset_s = (below(48) - 23) * hour_s / 2;
    const TimeOfDay from{900 * below(96), 0, offset_s};
    const std::int32_t end_s = 900 * below(96);
    if (end_s == from.earliest_s) continue;
    Period base;
    base.weekdays = static_cast<std::uint8_t>(1 + below(127));
    const auto periods = daily_periods(base, from, {end_s, end_s, offset_s});
    for (std::int64_t utc_s = 7 * day_s; utc_s < 14 * day_s; utc_s += 900) {
      const std::int64_t local_s = utc_s + offset_s;
      const std::int64_t of_day_s = local_s % day_s, weekday = (local_s / day_s + 3) % 7;
      const bool is_past_midnight = end_s < from.earliest_s && of_day_s < end_s;
      const std::int64_t began = is_past_midnight ? (weekday + 6) % 7 : weekday;
      const bool is_within = is_past_midnight || (of_day_s >= from.earliest_s &&
                                                  (end_s < from.earliest_s || of_day_s < end_s));
      const bool is_on = (base.weekdays >> began & 1) != 0;
      ASSERT_EQ(is_covered(periods, utc_s), is_within && is_on)
          << from.earliest_s << ' ' << end_s << ' ' << offset_s << ' ' << utc_s;
    }
  }
}

}  // namespace
}  // namespace rtac::geometry::import
