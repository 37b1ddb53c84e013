// The time of day of runs: when zones come and go, and what of them is taken to be worst.
#include "calendar.h"

#include <gtest/gtest.h>

#include <set>

namespace rtac::simulate {
namespace {

using sim::Property;
using sim::PropertyOp;

constexpr TimeUs second_us = 1'000'000, hour_us = 3600 * second_us, day_us = 24 * hour_us;

TimeUs at(const std::string& text) {
  return utc_of(text).value_or(-1);
}

// Fridays from 07:30 to 16:00, over the midnight before Sunday, and once on a day in May.
Openings school() {
  Openings zone{"school", {}, {}, 10 * second_us};
  zone.once = {{at("2026-05-01T18:00:00Z"), at("2026-05-01T19:00:00Z")}};
  zone.weekly = {{4 * day_us + 15 * hour_us / 2, 4 * day_us + 16 * hour_us},
                 {5 * day_us + 23 * hour_us, 6 * day_us},
                 {6 * day_us, 6 * day_us + hour_us}};
  return zone;
}
bool open(const std::string& text) {
  return open_at({school()}, at(text)).front();
}

TEST(Calendar, MomentsAreThoseOfTheGregorianCalendar) {
  EXPECT_EQ(at("1970-01-01T00:00:00Z"), 0);
  EXPECT_EQ(at("1970-01-02T00:00:01Z"), day_us + second_us);
  EXPECT_EQ(at("2000-03-01T00:00:00Z") - at("2000-02-28T00:00:00Z"), 2 * day_us);
  EXPECT_EQ(at("2100-03-01T00:00:00Z") - at("2100-02-28T00:00:00Z"), day_us);
  EXPECT_EQ(at("2026-05-01T08:00:00Z"), 1'777'622'400 * second_us);
  for (const std::string text : {"1970-01-01T00:00:00Z", "2024-02-29T23:59:59Z",
                                 "2026-12-31T12:34:56Z", "9999-12-31T00:00:00Z"}) {
    EXPECT_EQ(utc_text(at(text)), text);
  }
  for (const std::string text :
       {"", "noon", "2026-02-30T00:00:00Z", "2026-05-01T24:00:00Z", "2026-05-01T08:00:00",
        "2026-05-01T08:00:00Z.", "2026-05-01", "1969-12-31T00:00:00Z", "2026-5-1T08:00:00Z"}) {
    EXPECT_FALSE(utc_of(text)) << text;
  }
}

// The first moment belongs to a window, the last one does not.
TEST(Calendar, ZonesAreThereWithinTheirWindows) {
  EXPECT_FALSE(open("2026-01-09T07:29:59Z"));
  EXPECT_TRUE(open("2026-01-09T07:30:00Z"));
  EXPECT_TRUE(open("2026-01-09T15:59:59Z"));
  EXPECT_FALSE(open("2026-01-09T16:00:00Z"));
  EXPECT_FALSE(open("2026-01-08T12:00:00Z"));
  EXPECT_TRUE(open("2026-05-01T18:00:00Z"));
  EXPECT_TRUE(open("2026-05-01T08:00:00Z"));  // a Friday
  EXPECT_TRUE(open("2026-01-10T23:30:00Z"));
  EXPECT_TRUE(open("2026-01-11T00:30:00Z"));
  EXPECT_FALSE(open("2026-01-11T01:00:00Z"));
  EXPECT_TRUE(open("1970-01-02T12:00:00Z"));
}

// Where two windows touch nothing changes.
TEST(Calendar, ChangesAreWhereAZoneComesOrGoes) {
  const auto changes = [](const std::string& from, const std::string& until) {
    std::vector<std::string> texts;
    for (const TimeUs us : changes_between({school()}, at(from), at(until))) {
      texts.push_back(utc_text(us));
    }
    return texts;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(changes("2026-01-09T07:30:00Z", "2026-01-09T16:00:00Z"), Texts{"2026-01-09T16:00:00Z"});
  EXPECT_EQ(changes("2026-01-10T22:00:00Z", "2026-01-11T02:00:00Z"),
            (Texts{"2026-01-10T23:00:00Z", "2026-01-11T01:00:00Z"}));
  EXPECT_EQ(changes("2026-04-30T00:00:00Z", "2026-05-02T00:00:00Z"),
            (Texts{"2026-05-01T07:30:00Z", "2026-05-01T16:00:00Z", "2026-05-01T18:00:00Z",
                   "2026-05-01T19:00:00Z"}));
  EXPECT_EQ(changes("2026-01-05T00:00:00Z", "2026-01-08T00:00:00Z"), Texts{});
}

Property open_zone() {
  Property p;
  p.op = PropertyOp::open;
  return p;
}
Property with(PropertyOp op, std::vector<Property> of) {
  Property p;
  p.op = op;
  p.of = std::move(of);
  return p;
}

// What has to be there is not, and what must not be there is, where that changes; and is as it is
// where it does not.
TEST(Calendar, TheWorstIsTakenOfWhatChanges) {
  const std::vector<Openings> all{school()};
  const auto worst = [&](const Property& p, const std::string& from, const std::string& until) {
    const Property found = at_its_worst(p, all, at(from), at(until));
    EXPECT_FALSE(speaks_of(found, PropertyOp::open));
    const Property* leaf = &found;
    while (!leaf->of.empty()) leaf = &leaf->of.front();
    return leaf->value != 0;
  };
  const Property there = open_zone(), gone = with(PropertyOp::logical_not, {open_zone()});
  const Property twice = with(PropertyOp::logical_not, {with(PropertyOp::logical_or, {gone})});
  const std::string before = "2026-01-09T07:00:00Z", within = "2026-01-09T08:00:00Z",
                    later = "2026-01-09T09:00:00Z";
  EXPECT_FALSE(worst(there, before, within));
  EXPECT_TRUE(worst(gone, before, within));
  EXPECT_FALSE(worst(twice, before, within));
  EXPECT_TRUE(worst(there, within, later));
  EXPECT_TRUE(worst(gone, within, later));
  EXPECT_FALSE(worst(there, "2026-01-09T06:00:00Z", before));
  EXPECT_FALSE(worst(gone, "2026-01-09T06:00:00Z", before));
}

// Runs meet some change, after all that is looked ahead at it; all of them come up.
TEST(Calendar, RunsBeginAroundAChange) {
  const std::vector<Openings> all{school()};
  constexpr TimeUs span_us = 30 * second_us;
  std::set<std::string> met;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    sim::Random random = sim::Random::stream(seed, 1, 0);
    const TimeUs begin_us = draw_begin(all, span_us, random);
    const auto changes =
        changes_between(all, begin_us + all[0].lead_us - 1, begin_us + all[0].lead_us + span_us);
    ASSERT_EQ(changes.size(), 1U) << utc_text(begin_us);
    met.insert(utc_text(changes.front()));
  }
  EXPECT_EQ(met.size(), 6U);
  sim::Random random = sim::Random::stream(1, 1, 0);
  Openings always{"always", {}, {{0, 7 * day_us}}, 0};
  EXPECT_GT(draw_begin({always}, span_us, random), 0);  // nothing ever changes
}

}  // namespace
}  // namespace rtac::simulate
