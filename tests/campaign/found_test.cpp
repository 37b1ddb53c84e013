// What attacks once broke, or kept from ending: each holds now, under every adversary.
#include <gtest/gtest.h>

#include "kills.h"

namespace rtac::campaign {
namespace {

class Found : public ::testing::TestWithParam<const char*> {};

TEST_P(Found, HoldsNow) {
  const std::string spec = std::string("found/") + GetParam();
  const Attack a = attack({"found", spec.c_str(), "", 0}, "", 60);
  EXPECT_EQ(a.status, 0) << a.said;
}
INSTANTIATE_TEST_SUITE_P(All, Found,
                         ::testing::Values("weak_steering", "noisy_hold", "mixed_pair",
                                           "poor_actuator", "two_recoveries"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace rtac::campaign
