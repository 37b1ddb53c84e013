#include "rtac/sim/statistics.h"

#include <gtest/gtest.h>

#include "rtac/sim/random.h"

namespace rtac::sim {
namespace {

TEST(Statistics, MeanAndQuantilesOfHandCases) {
  EXPECT_EQ(mean({}), 0);
  EXPECT_DOUBLE_EQ(mean({1, 2, 6}), 3);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0), 1);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(quantile({10, 20}, 0.25), 12.5);
}

TEST(Bootstrap, OfAConstantDifferenceIsThatDifference) {
  // Pairing matters: the values spread widely, their difference not at all.
  const Interval interval = paired_bootstrap({1, 100, 1000}, {1.5, 100.5, 1000.5});
  EXPECT_DOUBLE_EQ(interval.lo, 0.5);
  EXPECT_DOUBLE_EQ(interval.centre, 0.5);
  EXPECT_DOUBLE_EQ(interval.hi, 0.5);
}

TEST(Bootstrap, HasAboutTheWidthOfTheNormalInterval) {
  // 100 uniform differences in [-1, 1]: standard error sqrt(1/3)/10 = 0.0577.
  Random random(5);
  std::vector<double> before(100, 0.0);
  std::vector<double> after(100);
  for (double& value : after) value = random.uniform(-1, 1);
  const Interval interval = paired_bootstrap(before, after);
  EXPECT_NEAR(interval.hi - interval.lo, 2 * 1.96 * 0.0577, 0.03);
  EXPECT_LT(interval.lo, interval.centre);
  EXPECT_LT(interval.centre, interval.hi);
}

TEST(Bootstrap, IsSeeded) {
  const std::vector<double> before{1, 2, 3, 4};
  const std::vector<double> after{2, 1, 5, 9};
  BootstrapOptions other;
  other.seed = 2;
  other.resamples = 999;
  EXPECT_EQ(paired_bootstrap(before, after).lo, paired_bootstrap(before, after).lo);
  EXPECT_EQ(paired_bootstrap({}, {}).hi, 0);
  EXPECT_LE(paired_bootstrap(before, after, other).lo, 1.75);
}

}  // namespace
}  // namespace rtac::sim
