// How doubles of an application come into a kernel of monitors without a robot.
#include "rtac/watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtac {
namespace {

struct Signal {
  std::int64_t lo = 0, hi = 0;
  TimeUs stamp_us = 0;
  std::int32_t valid = 0;
};

Signal put(double si, TimeUs stamp_us = 7) {
  Signal to;
  bridge::put_number(to, si, 1000, 1, stamp_us);
  return to;
}

TEST(Watch, ANumberBecomesTheStepsAroundIt) {
  const Signal exact = put(0.25), between = put(0.0005);
  EXPECT_EQ(exact.lo, 250);
  EXPECT_EQ(exact.hi, 250);
  EXPECT_EQ(between.lo, 0);
  EXPECT_EQ(between.hi, 1);
  EXPECT_EQ(exact.valid, 1);
}

// It has arrived, so that it has an age (rule 6.3), but no value on any grid.
TEST(Watch, ANumberBeyondEveryGridHasAnAgeAndNoSteps) {
  for (const double far : {1e30, -1e30, std::numeric_limits<double>::max()}) {
    const Signal s = put(far);
    EXPECT_EQ(s.valid, 1) << far;
    EXPECT_EQ(s.stamp_us, 7);
    EXPECT_GT(s.lo, s.hi) << far;
  }
}

TEST(Watch, WhatIsNoNumberOrNeverArrivedIsNotValid) {
  EXPECT_EQ(put(std::nan("")).valid, 0);
  EXPECT_EQ(put(std::numeric_limits<double>::infinity()).valid, 0);
  EXPECT_EQ(put(1, never_us).valid, 0);
}

}  // namespace
}  // namespace rtac
