// Rule 2: aggregates range over the ticks that exist; unknown ticks widen them.
#include "tests/compiler/interp/testing.h"

namespace rtac::interp::test {
namespace {

const std::string x = "input x : real in 0 .. 10;";
const std::string trace = "time,x\n0,4\n1,1\n2,nan\n3,7\n4,2\n";

TEST(Aggregates, MinimumAndMaximumOfTheWindow) {
  EXPECT_EQ(judge(*monitor(x, "min[0 s, 1 s](x) >= 0"), trace),
            (Lines{"true [4, 4]", "true [1, 1]", "true [0, 1]", "true [0, 7]", "true [2, 2]"}));
  EXPECT_EQ(judge(*monitor(x, "max[0 s, 1 s](x) >= 0"), trace),
            (Lines{"true [4, 4]", "true [4, 4]", "true [1, 10]", "true [7, 10]", "true [7, 7]"}));
}

TEST(Aggregates, SumAndMeanOfTheTicksThatExist) {
  EXPECT_EQ(judge(*monitor(x, "sum[0 s, 1 s](x) >= 0"), trace),
            (Lines{"true [4, 4]", "true [5, 5]", "true [1, 11]", "true [7, 17]", "true [9, 9]"}));
  EXPECT_EQ(judge(*monitor(x, "mean[0 s, 1 s](x) >= 0"), trace),
            (Lines{"true [4, 4]", "true [2.5, 2.5]", "true [0.5, 5.5]", "true [3.5, 8.5]",
                   "true [4.5, 4.5]"}));
}

TEST(Aggregates, CountIsOfTicksThatAreSurelyAndPossiblyTrue) {
  EXPECT_EQ(judge(*monitor(x, "count[0 s, 2 s](x >= 4) >= 0"), trace),
            (Lines{"true [1, 1]", "true [1, 1]", "true [1, 2]", "true [1, 2]", "true [1, 2]"}));
}

TEST(Aggregates, RateIsUnknownBeforeTheWindowFits) {
  EXPECT_EQ(
      judge(*monitor("input x : real [m] in 0 m .. 10 m;", "rate[0 s, 2 s](x) >= 0 m/s"), trace),
      (Lines{"unknown [-inf, inf]", "unknown [-inf, inf]", "unknown [-2, 3] m/s", "true [3, 3] m/s",
             "unknown [-4, 1] m/s"}));
}

// No tick lies in the window: sums and counts are 0, the others have no value.
TEST(Aggregates, AnEmptyWindow) {
  const std::string first = "time,x\n0,4\n";
  EXPECT_EQ(judge(*monitor(x, "sum[1 s, 2 s](x) >= 0"), first), Lines{"true [0, 0]"});
  EXPECT_EQ(judge(*monitor(x, "count[1 s, 2 s](x >= 0) >= 0"), first), Lines{"true [0, 0]"});
  EXPECT_EQ(judge(*monitor(x, "mean[1 s, 2 s](x) >= 0"), first), Lines{"unknown [-inf, inf]"});
  EXPECT_EQ(judge(*monitor(x, "min[1 s, 2 s](x) >= 0"), first), Lines{"unknown [-inf, inf]"});
}

// What was forgotten has been somewhere in the declared range.
TEST(Aggregates, AfterALongGapTheWindowIsTheWholeRange) {
  const std::string gap = "time,x\n0,4\n9,3\n10,3\n11,3\n";
  EXPECT_EQ(judge(*monitor(x, "sum[0 s, 2 s](x) >= 0"), gap),
            (Lines{"true [4, 4]", "true [3, 23]", "true [6, 16]", "true [9, 9]"}));
  EXPECT_EQ(judge(*monitor(x, "max[0 s, 1 s](x) >= 0"), gap),
            (Lines{"true [4, 4]", "true [3, 10]", "true [3, 3]", "true [3, 3]"}));
}

}  // namespace
}  // namespace rtac::interp::test
