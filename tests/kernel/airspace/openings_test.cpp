// Zones at times in the kernel, against the calendar of the system: at every moment when one opens
// or closes, a step before and behind it, this year and far from it.
#include <gtest/gtest.h>

#include <ctime>
#include <vector>

#include "airspace.h"

namespace airspace {
namespace {

constexpr rtac::TimeUs second_us = 1'000'000, minute_us = 60 * second_us;

rtac::TimeUs moment_us(int year, int month, int day, int hour = 0, int minute = 0, int second = 0) {
  std::tm date{};
  date.tm_year = year - 1900;
  date.tm_mon = month - 1;
  date.tm_mday = day;
  date.tm_hour = hour;
  date.tm_min = minute;
  date.tm_sec = second;
  return static_cast<rtac::TimeUs>(timegm(&date)) * second_us;
}

// What `during` of the fair says.
bool is_due(rtac::TimeUs at_us) {
  std::time_t seconds = at_us / second_us - (at_us % second_us < 0 ? 1 : 0);
  std::tm date{};
  gmtime_r(&seconds, &date);
  const auto of_day_us = at_us - moment_us(date.tm_year + 1900, date.tm_mon + 1, date.tm_mday);
  const auto between = [](rtac::TimeUs from_us, rtac::TimeUs t_us, rtac::TimeUs until_us) {
    return from_us <= t_us && t_us < until_us;
  };
  const bool works = date.tm_wday == 1 || date.tm_wday == 5;
  return between(moment_us(2026, 5, 5, 8), at_us, moment_us(2026, 5, 5, 18)) ||
         between(moment_us(2026, 5, 6, 8), at_us, moment_us(2026, 5, 6, 12, 0, 30)) ||
         (works && between(450 * minute_us, of_day_us, 960 * minute_us)) ||
         (date.tm_wday == 0 && of_day_us >= 1320 * minute_us);
}

// Found for a mark on the ground of the fair, by monitors that start then.
void expect_found(rtac::TimeUs at_us) {
  Monitors fresh, alone;
  const bool due = is_due(at_us);
  const auto& found = fresh.mark({5, 5, 0}, at_us).step(at_us);
  EXPECT_EQ(found[Monitors::attends_index].verdict,
            due ? rtac::Verdict::is_true : rtac::Verdict::is_false)
      << at_us;
  EXPECT_EQ(found[Monitors::away_index].verdict,
            due ? rtac::Verdict::is_false : rtac::Verdict::is_true)
      << at_us;
  const auto& verdicts = alone.mark({5, 5, 0}, at_us).verdicts(at_us);
  EXPECT_EQ(verdicts[Monitors::attends_index], found[Monitors::attends_index].verdict) << at_us;
  EXPECT_EQ(verdicts[Monitors::away_index], found[Monitors::away_index].verdict) << at_us;
}

// Every half hour of these days is one when something opens or closes, or next to one.
TEST(Openings, FollowTheCalendar) {
  const std::vector<rtac::TimeUs> days = {moment_us(2026, 5, 1),  moment_us(2026, 5, 8),
                                          moment_us(1970, 1, 1),  moment_us(1969, 12, 20),
                                          moment_us(1903, 1, 17), moment_us(2400, 2, 26)};
  for (const rtac::TimeUs from_us : days) {
    for (int half_hour = 0; half_hour <= 9 * 48; ++half_hour) {
      const rtac::TimeUs at_us = from_us + half_hour * 30 * minute_us;
      for (const rtac::TimeUs off_us : {-second_us, rtac::TimeUs{-1}, rtac::TimeUs{0},
                                        rtac::TimeUs{1}, 30 * second_us - 1, 30 * second_us}) {
        expect_found(at_us + off_us);
      }
    }
  }
}

// The clock is asked at every tick.
TEST(Openings, ComeWhileMonitorsRun) {
  Monitors monitors;
  const rtac::TimeUs opens_us = moment_us(2026, 5, 6, 8), period_us = 100'000;
  for (rtac::TimeUs at_us = opens_us - 20 * period_us; at_us < opens_us + 20 * period_us;
       at_us += period_us) {
    const auto& found = monitors.mark({5, 5, 0}, at_us).step(at_us);
    EXPECT_EQ(found[Monitors::attends_index].verdict,
              at_us < opens_us ? rtac::Verdict::is_false : rtac::Verdict::is_true);
  }
}

}  // namespace
}  // namespace airspace
