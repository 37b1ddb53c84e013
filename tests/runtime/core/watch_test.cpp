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

std::int64_t param(double si, bool up, double per_unit = 1000, std::int64_t step = 1) {
  std::int64_t to = -1;
  EXPECT_TRUE(bridge::grid_param(si, per_unit, step, up, to)) << si;
  return to;
}

// The farthest step of any grid (10^15) is a step; what is beyond it has none.
TEST(Watch, TheLastStepOfAnyGridIsOne) {
  for (const double sign : {1.0, -1.0}) {
    Signal last, beyond;
    bridge::put_number(last, sign * 1e15, 1, 1, 7);
    EXPECT_EQ(last.lo, sign * 1'000'000'000'000'000);
    EXPECT_EQ(last.hi, last.lo);
    bridge::put_number(beyond, sign * std::nextafter(1e15, 2e15), 1, 1, 7);
    EXPECT_GT(beyond.lo, beyond.hi);
  }
}

// 0.29 is no double, and its nearest one times 1000 is less than 290.
TEST(Watch, AParameterIsTheStepThatItsDecimalMeans) {
  for (int steps = -3000; steps <= 3000; ++steps) {
    for (const bool up : {false, true}) {
      EXPECT_EQ(param(steps / 1000.0, up), steps);
      EXPECT_EQ(param(steps * 0.001, up), steps);
      EXPECT_EQ(param(steps * 7 / 1e6, up, 1e6, 7), steps);
    }
  }
  EXPECT_EQ(param(0.1 + 0.2, true), 300);
}

// Rule 13.3: a value between two steps counts as the stricter one, however near it is to the other.
TEST(Watch, AParameterBesideAStepIsTheStricterOne) {
  EXPECT_EQ(param(0.3 + 1e-12, true), 301);
  EXPECT_EQ(param(0.3 - 1e-12, true), 300);
  EXPECT_EQ(param(0.3 + 1e-12, false), 300);
  EXPECT_EQ(param(0.3 - 1e-12, false), 299);
  EXPECT_EQ(param(1e-12, true), 1);
  EXPECT_EQ(param(-1e-12, false), -1);
}

}  // namespace
}  // namespace rtac
