// How doubles of an application come into a kernel of monitors without a robot.
#include "rtac/watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtac {
namespace {

struct Number {
  std::int64_t at = 0;
  std::uint32_t between = 0;
};

Number put(double si, double per_unit = 1000, std::int64_t step = 1) {
  Number to;
  to.between = bridge::put_number(to.at, si, per_unit, step);
  return to;
}

TEST(Watch, ANumberBecomesTheLastStepThatIsNotAboveIt) {
  const Number exact = put(0.25), between = put(0.0005), below = put(-0.0005);
  EXPECT_EQ(exact.at, 250);
  EXPECT_EQ(exact.between, 0U);
  EXPECT_EQ(between.at, 0);
  EXPECT_EQ(between.between, 1U);
  EXPECT_EQ(below.at, -1);
  EXPECT_EQ(below.between, 1U);
  const Number coarse = put(-0.025, 1000, 10);
  EXPECT_EQ(coarse.at, -3);
  EXPECT_EQ(coarse.between, 1U);
}

// It has arrived, so that it has an age (rule 6.3), but no value on any grid.
TEST(Watch, ANumberBeyondEveryGridHasNoStep) {
  for (const double far : {1e30, -1e30, std::numeric_limits<double>::max()}) {
    const Number number = put(far);
    EXPECT_EQ(number.at, bridge::off_grid) << far;
    EXPECT_EQ(number.between, 0U) << far;
  }
}

TEST(Watch, WhatIsNotFiniteIsNoNumber) {
  EXPECT_EQ(put(std::nan("")).at, bridge::no_number);
  EXPECT_EQ(put(std::numeric_limits<double>::infinity()).at, bridge::no_number);
  EXPECT_EQ(put(-std::numeric_limits<double>::infinity()).at, bridge::no_number);
}

// What lay between two steps in the last sample is forgotten.
TEST(Watch, ASampleStartsAnew) {
  struct {
    TimeUs stamp_us;
    std::int32_t valid;
    std::uint32_t between;
    std::int64_t value;
  } sample{1, 0, 1, 5};
  bridge::start_sample(sample, 7);
  EXPECT_EQ(sample.stamp_us, 7);
  EXPECT_EQ(sample.valid, 1);
  EXPECT_EQ(sample.between, 0U);
  bridge::start_sample(sample, never_us);
  EXPECT_EQ(sample.valid, 0);
}

std::int64_t param(double si, bool up, double per_unit = 1000, std::int64_t step = 1) {
  std::int64_t to = -1;
  EXPECT_TRUE(bridge::grid_param(si, per_unit, step, up, to)) << si;
  return to;
}

// The farthest step of any grid (10^15) is a step; what is beyond it has none.
TEST(Watch, TheLastStepOfAnyGridIsOne) {
  for (const double sign : {1.0, -1.0}) {
    const Number last = put(sign * 1e15, 1), beyond = put(sign * std::nextafter(1e15, 2e15), 1);
    EXPECT_EQ(last.at, sign * 1'000'000'000'000'000);
    EXPECT_EQ(last.between, 0U);
    EXPECT_EQ(beyond.at, bridge::off_grid);
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
