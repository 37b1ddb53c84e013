// Whether zones with windows of time are ever gone at once.
#include "compiler/sema/openings.h"

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

// Of two zones, with these windows, that one property speaks of; for a minute.
bool ever_gone(const std::string& one, const std::string& two) {
  const auto checked = check_text(
      "spec yard;\nclock utc;\nperiod 1 s;\n"
      "zone a = rectangle (0 m, 0 m) to (4 m, 3 m)" +
      one + ";\nzone b = rectangle (0 m, 0 m) to (4 m, 3 m)" + two +
      ";\ninput p : point;\n"
      "monitor m { \"R1\" always not (p inside a) and not (p inside b); }\n");
  EXPECT_TRUE(checked->spec) << checked->reports();
  return checked->spec &&
         are_ever_gone(*checked->spec, {checked->spec->watches[0].always.get()}, 60);
}
std::string daily(const std::string& from, const std::string& until) {
  return " during monday, tuesday, wednesday, thursday, friday, saturday, sunday " + from + " .. " +
         until;
}

TEST(Openings, ZonesAreGoneBetweenTheirWindows) {
  EXPECT_TRUE(ever_gone(daily("00:00", "11:00"), daily("12:00", "24:00")));
  EXPECT_TRUE(ever_gone(daily("00:00", "11:59"), daily("12:00", "24:00")));
  EXPECT_FALSE(ever_gone(daily("00:00", "12:00"), daily("12:00", "24:00")));
  EXPECT_FALSE(ever_gone(daily("00:00", "13:00"), daily("12:00", "24:00")));
  // from Sunday night to Monday morning, and no longer
  EXPECT_TRUE(ever_gone(" during monday 00:05 .. 24:00",
                        " during tuesday, wednesday, thursday, friday, saturday, sunday "
                        "00:00 .. 24:00"));
  EXPECT_FALSE(ever_gone(" during monday 00:00 .. 24:00",
                         " during tuesday, wednesday, thursday, friday, saturday, sunday "
                         "00:00 .. 24:00"));
}
// Files of zones have windows without an end as well.
TEST(Openings, ZonesAreGoneBeforeAndAfterDates) {
  constexpr std::int64_t eight = 1'777'622'400, nineteen = eight + 11 * 3600;  // 2026-05-01, UTC
  const auto checked = check_text(
      "spec yard;\nclock utc;\nperiod 1 s;\n"
      "zone a = rectangle (0 m, 0 m) to (4 m, 3 m) during monday 08:00 .. 09:00;\n"
      "zone b = rectangle (0 m, 0 m) to (4 m, 3 m) during monday 08:00 .. 09:00;\n"
      "input p : point;\n"
      "monitor m { \"R1\" always not (p inside a) and not (p inside b); }\n");
  ASSERT_TRUE(checked->spec) << checked->reports();
  const auto gone = [&](const Opening& one, const Opening& two) {
    checked->spec->zones[0].openings = {one};
    checked->spec->zones[1].openings = {two};
    return are_ever_gone(*checked->spec, {checked->spec->watches[0].always.get()}, 60);
  };
  const Opening day{0, eight, nineteen}, before{0, since_ever_s, nineteen},
      after{0, eight, for_ever_s}, weekend{0b1100000, 0, 86'400}, week{0b1111111, 0, 86'400};
  EXPECT_TRUE(gone(day, day));
  EXPECT_TRUE(gone(before, day));
  EXPECT_TRUE(gone(after, day));
  EXPECT_FALSE(gone(before, after));
  EXPECT_TRUE(gone({0, since_ever_s, eight}, {0, nineteen, for_ever_s}));
  EXPECT_FALSE(gone({0, since_ever_s, eight}, {0, eight + 59, for_ever_s}));
  EXPECT_TRUE(gone(before, weekend));
  EXPECT_FALSE(gone(day, week));
}
TEST(Openings, WhatHasNoneCountsForNothing) {
  EXPECT_TRUE(ever_gone("", ""));
  EXPECT_TRUE(ever_gone("", daily("08:00", "16:00")));
}

}  // namespace
}  // namespace rtac::sema::test
