// What attacks once broke, or kept from ending: each holds now, under every adversary.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "kills.h"

namespace rtac::campaign {
namespace {

// The scenario of a specification lies beside it, if it needs one.
class Found : public ::testing::TestWithParam<const char*> {};

TEST_P(Found, HoldsNow) {
  const std::string spec = std::string("found/") + GetParam();
  std::string scenario = spec + ".json";
  if (!std::filesystem::exists(std::string(RTAC_CAMPAIGN_SPECS) + "/" + scenario)) scenario = "";
  const Attack a = attack({"found", spec.c_str(), "", 0, scenario.c_str()}, "", 60);
  EXPECT_EQ(a.status, 0) << a.said;
}
INSTANTIATE_TEST_SUITE_P(All, Found,
                         ::testing::Values("weak_steering", "noisy_hold", "mixed_pair",
                                           "poor_actuator", "two_recoveries", "stopped_climb",
                                           "stopped_pair", "hard_brake", "short_of_room",
                                           "sways_at_dock", "tries_to_pass", "moved_on",
                                           "unequal_return"),
                         [](const auto& each) { return each.param; });

}  // namespace
}  // namespace rtac::campaign
