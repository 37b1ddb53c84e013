// What a kernel may leave open of a choice: a side beside the one that is taken, where the
// condition is too near to its limit for the integers of the kernel, and nowhere else.
#include "tests/differential/choices.h"

#include <gtest/gtest.h>

namespace rtac::differential {
namespace {

driver::Observed observed(const char* decimal) {
  driver::Observed o{{}, 0, true};
  if (*decimal == 0) return o;
  o.reading = {interp::Reading::Kind::number, *interp::Decimal::parse(decimal)};
  return o;
}

// The verdict of the monitor at a step where z is missing; -: it has no such choice.
char opened(const std::string& monitor, const char* x, const char* y) {
  const OpenedChoices choices(
      "spec s;\nperiod 1 s;\ninput x, y : real in -9 .. 9 error 0.1;\ninput z : real in -9 .. 9;\n"
      "monitor m { \"R1: chosen\" always " +
      monitor + "; }\n");
  const Findings found = choices.find({{0, {observed(x), observed(y), observed("")}}});
  return found.front().empty() ? '-' : found.front().front().verdict;
}

TEST(OpenedChoices, HaveOneSideWhereTheConditionIsFarFromItsLimit) {
  EXPECT_EQ(opened("(if x / 3 >= 0.7 then y else z) >= 1", "6", "5"), '1');
  EXPECT_EQ(opened("(if x / 3 < 0.7 then z else y) >= 1", "6", "5"), '1');
}

TEST(OpenedChoices, HaveBothWhereAKernelMayNotDecideTheCondition) {
  EXPECT_EQ(opened("(if x / 3 >= 0.7 then y else z) >= 1", "2.2000001", "5"), '?');
}

TEST(OpenedChoices, MayStandInConditionsOfOthers) {
  const char* const nested = "(if (if x / 3 >= 0.7 then y else z) / 3 >= 1 then y else z) >= 1";
  EXPECT_EQ(opened(nested, "6", "5"), '1');
  EXPECT_EQ(opened(nested, "2.2000001", "5"), '?');
}

// A condition that kernels decide as exact numbers do is no excuse.
TEST(OpenedChoices, AreNoneWhereTheConditionIsExact) {
  EXPECT_EQ(opened("(if z >= 0 then x else y) >= 1", "6", "5"), '-');
}

}  // namespace
}  // namespace rtac::differential
