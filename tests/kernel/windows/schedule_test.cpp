// All of a span of time, against what the schedule says at every moment when something changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/kernel/windows/windows_probe.h"

namespace {

constexpr std::int64_t minute_us = 60'000'000, week_us = 7 * 24 * 60 * minute_us;
// Thursday 1970-01-01, since the Monday before
constexpr std::int64_t epoch_us = 3 * 24 * 60 * minute_us;

struct Openings {
  std::vector<std::int64_t> ends_us;  // of once, then of every week
  std::int32_t once = 0, weekly = 0;

  [[nodiscard]] bool open(std::int64_t at_us) const {
    return probe_open(ends_us.data(), once, weekly, at_us) != 0;
  }
  // The first and last microsecond of all that lasts, within the span.
  [[nodiscard]] std::vector<std::int64_t> moments(std::int64_t from_us, std::int64_t to_us) const {
    std::vector<std::int64_t> all = {from_us, to_us};
    const auto add = [&](std::int64_t at_us) {
      for (const std::int64_t t : {at_us - 1, at_us}) {
        if (t > from_us && t < to_us) all.push_back(t);
      }
    };
    for (std::size_t k = 0; k < ends_us.size(); ++k) {
      if (k < 2 * std::size_t(once)) {
        add(ends_us[k]);
        continue;
      }
      for (std::int64_t week = from_us / week_us - 2; week <= to_us / week_us + 1; ++week) {
        add(week * week_us + ends_us[k] - epoch_us);
      }
    }
    return all;
  }
};

// `count` of them, apart, from `from` minutes on; times in whole minutes, so that ends meet often.
void add_openings(std::vector<std::int64_t>& to, int count, std::int64_t from, std::int64_t end,
                  std::mt19937_64& random) {
  std::vector<std::int64_t> ends;
  while (ends.size() < 2 * std::size_t(count)) {
    const auto at = std::uniform_int_distribution<std::int64_t>(from, end)(random);
    if (std::find(ends.begin(), ends.end(), at) == ends.end()) ends.push_back(at);
  }
  std::sort(ends.begin(), ends.end());
  for (const std::int64_t at : ends) to.push_back(at * minute_us);
}

Openings openings(std::mt19937_64& random) {
  Openings o;
  o.once = std::uniform_int_distribution<int>(0, 2)(random);
  o.weekly = std::uniform_int_distribution<int>(0, 2)(random);
  // around the end of the week after the epoch, minutes since then
  const std::int64_t sunday = (week_us - epoch_us) / minute_us;
  add_openings(o.ends_us, o.once, sunday - 30, sunday + 30, random);
  return o;
}

// Half an hour before the end of a week until half an hour behind it, as two openings when one
// lasts over it.
Openings over_the_end(std::mt19937_64& random) {
  Openings o = openings(random);
  std::vector<std::pair<std::int64_t, std::int64_t>> weekly;
  const std::int64_t week = week_us / minute_us;
  for (int k = 0; k < o.weekly; ++k) {
    auto from = std::uniform_int_distribution<std::int64_t>(week - 30, week + 29)(random);
    const auto until = std::uniform_int_distribution<std::int64_t>(from + 1, week + 30)(random);
    if (until <= week) {
      weekly.emplace_back(from, until);
    } else {
      if (from < week) weekly.emplace_back(from, week);
      weekly.emplace_back(std::max(from, week) - week, until - week);
    }
  }
  std::sort(weekly.begin(), weekly.end());
  o.ends_us.resize(2 * std::size_t(o.once));
  std::int64_t last = -1;
  o.weekly = 0;
  for (const auto& [from, until] : weekly) {
    if (from <= last) continue;
    o.ends_us.push_back(from * minute_us);
    o.ends_us.push_back(until * minute_us);
    last = until;
    ++o.weekly;
  }
  return o;
}

// Spans end on moments when something changes, or a microsecond off.
std::int64_t moment(std::mt19937_64& random) {
  const auto minutes = std::uniform_int_distribution<std::int64_t>(-35, 35)(random);
  const auto off_us = std::uniform_int_distribution<std::int64_t>(-1, 1)(random);
  return week_us - epoch_us + minutes * minute_us + off_us;
}

TEST(Windows, HoldFromTheFirstMomentToTheLast) {
  std::mt19937_64 random(1);
  int there = 0, gone = 0, mixed = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Openings o = over_the_end(random);
    std::int64_t from_us = moment(random), to_us = moment(random);
    if (from_us > to_us) std::swap(from_us, to_us);
    const auto moments = o.moments(from_us, to_us);
    const auto open = [&](std::int64_t at_us) { return o.open(at_us); };
    const bool always = std::all_of(moments.begin(), moments.end(), open);
    const bool never = std::none_of(moments.begin(), moments.end(), open);
    const auto ask = [&](auto f) {
      return f(o.ends_us.data(), o.once, o.weekly, from_us, to_us) != 0;
    };
    ASSERT_EQ(ask(probe_there), always) << i;
    ASSERT_EQ(ask(probe_gone), never) << i;
    there += always ? 1 : 0, gone += never ? 1 : 0, mixed += !always && !never ? 1 : 0;
  }
  EXPECT_GT(there, 2'000);
  EXPECT_GT(gone, 10'000);
  EXPECT_GT(mixed, 10'000);
}

// A span of a week meets whatever is there every week.
TEST(Windows, OfAWeekMeetAllOfIt) {
  const std::int64_t monday[] = {8 * 60 * minute_us, 9 * 60 * minute_us};
  for (std::int64_t from_us = 0; from_us < week_us; from_us += 7 * minute_us) {
    EXPECT_EQ(probe_gone(monday, 0, 1, from_us, from_us + week_us), 0) << from_us;
    EXPECT_EQ(probe_gone(monday, 0, 1, from_us, from_us + 30 * week_us), 0) << from_us;
  }
  EXPECT_EQ(probe_gone(monday, 0, 0, 0, INT64_MAX), 1);
}

// A moment is a span, before 1970 as well.
TEST(Windows, OfAMomentAreTheScheduleItself) {
  // once, and on Saturdays
  const std::int64_t all[] = {-minute_us, minute_us, 128 * 60 * minute_us, 129 * 60 * minute_us};
  for (std::int64_t at_us = -3 * week_us; at_us < week_us; at_us += 7 * minute_us) {
    const std::int32_t open = probe_open(all, 1, 1, at_us);
    EXPECT_EQ(probe_there(all, 1, 1, at_us, at_us), open) << at_us;
    EXPECT_EQ(probe_gone(all, 1, 1, at_us, at_us), open == 0 ? 1 : 0) << at_us;
  }
}

// Who is open every hour of the week is open for ever, as far as spans are asked for.
TEST(Windows, ThatJoinAreOne) {
  const std::int64_t always[] = {0, week_us};
  EXPECT_EQ(probe_there(always, 0, 1, -week_us, 3 * week_us), 1);
  EXPECT_EQ(probe_there(always, 0, 1, 5, 5), 1);
  // more than eight openings in a row are not relied upon
  EXPECT_EQ(probe_there(always, 0, 1, 0, 30 * week_us), 0);
}

// At the ends of time nothing overflows, and nothing is relied upon.
TEST(Windows, AtTheEndOfTime) {
  const std::int64_t ever[] = {INT64_MIN + 1, INT64_MAX};
  EXPECT_EQ(probe_there(ever, 1, 0, INT64_MIN + 1, INT64_MAX - 1), 1);
  EXPECT_EQ(probe_there(ever, 1, 0, 0, INT64_MAX), 0);
  EXPECT_EQ(probe_gone(ever, 1, 0, INT64_MAX - 1, INT64_MAX), 0);
}

}  // namespace
