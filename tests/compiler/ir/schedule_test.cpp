// Tables of when zones are there: in order, and without overlaps.
#include "compiler/ir/schedule.h"

#include "tests/compiler/ir/watch_testing.h"

namespace rtac::ir::test {
namespace {

// Of the zone of a specification that is there at these times.
std::string schedule(const std::string& during) {
  const Built b = built(
      "clock utc;\nzone z = circle (0 m, 0 m) radius 1 m during " + during + ";\ninput p : point;",
      "p.x >= 0 m");
  if (!b.spec) return b.report();
  const Schedule s = schedule_of(b.spec->zones.front());
  std::string text;
  for (const auto* list : {&s.once, &s.weekly}) {
    for (const Opening& o : *list) {
      text += std::to_string(o.from_us / 1'000'000) + "-" + std::to_string(o.until_us / 1'000'000) +
              " ";
    }
    text += "| ";
  }
  return text;
}

TEST(Schedule, CountsWeeksFromMonday) {
  EXPECT_EQ(schedule("monday 00:00 .. 00:01 or sunday 23:59 .. 24:00"), "| 0-60 604740-604800 | ");
  EXPECT_EQ(schedule("1970-01-01T00:00Z .. 1970-01-01T00:00:07Z"), "0-7 | | ");
}
// Whatever the order in which they are written, and however they overlap.
TEST(Schedule, JoinsWhatOverlapsOrTouches) {
  EXPECT_EQ(schedule("monday 02:00 .. 03:00 or monday 00:00 .. 01:00 or monday 01:00 .. 01:30"),
            "| 0-5400 7200-10800 | ");
  EXPECT_EQ(schedule("monday 00:00 .. 12:00 or monday 01:00 .. 02:00"), "| 0-43200 | ");
  EXPECT_EQ(schedule("00:00 .. 24:00"), "| 0-604800 | ");
}

// What looks them up relies on the order.
TEST(Verifier, OpeningsAreInOrder) {
  Built b = built("input open : bool;", "open");
  b.module.watch->schedules.push_back({"z", {{5, 7}, {8, 9}}, {}});
  EXPECT_EQ(verify(b.module), std::nullopt);
  b.module.watch->schedules.front().once = {{5, 7}, {7, 9}};
  EXPECT_NE(verify(b.module).value_or("").find("out of order"), std::string::npos);
  b.module.watch->schedules.front().once = {{-9, -5}, {-4, 9}};  // before 1970
  EXPECT_EQ(verify(b.module), std::nullopt);
  b.module.watch->schedules.front() = {"z", {}, {{-1, 5}}};
  EXPECT_NE(verify(b.module).value_or("").find("out of order"), std::string::npos);
  b.module.watch->schedules.front() = {"z", {}, {{0, us_per_week + 1}}};
  EXPECT_NE(verify(b.module).value_or("").find("out of order"), std::string::npos);
}
TEST(Verifier, AScheduleIsThere) {
  Built b = built("input open : bool;", "open");
  b.module.watch->monitors.front().property.values.front().op = Open{ScheduleIndex{0}};
  EXPECT_NE(verify(b.module).value_or("").find("no such schedule"), std::string::npos);
}

}  // namespace
}  // namespace rtac::ir::test
