// The list of adversaries is the one that is documented, and each has something to aim at.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "scenario.h"

namespace rtac::simulate {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(std::string(RTAC_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Adversaries, AreAllDocumented) {
  const std::string page = text_of("compiler/docs/simulation.md");
  const std::string help = text_of("compiler/driver/help.cpp");
  for (const Adversary& a : adversaries()) {
    EXPECT_NE(page.find("| `" + std::string(a.name) + "` |"), std::string::npos) << a.name;
    EXPECT_NE(help.find("`" + std::string(a.name) + "`"), std::string::npos) << a.name;
  }
}

TEST(Adversaries, AimAtWhatPropertiesSay) {
  DecisionCase fence;
  sim::Property inside;
  inside.op = sim::PropertyOp::inside;
  fence.properties.push_back(inside);
  std::set<std::string> names;
  for (const Adversary* a : applicable(fence, Scenario())) names.insert(a->name);
  EXPECT_EQ(names.count("chase-fence"), 1u);
  EXPECT_EQ(names.count("push-at-fence"), 0u);  // it takes no turn
  EXPECT_NE(find_adversary("push-at-fence"), nullptr);
  EXPECT_EQ(names.count("chase-robot"), 0u);
  EXPECT_EQ(names.count("drain"), 0u);
}

// Nobody is pushed who has declared no disturbance.
TEST(Adversaries, PushRobotsThatAreDisturbedAlone) {
  const auto pushes = [](double disturbance_mps2) {
    DecisionCase decision;
    decision.limits.disturbance_mps2 = disturbance_mps2;
    const auto all = applicable(decision, {});
    return std::any_of(all.begin(), all.end(), [](const Adversary* a) { return a->aims_wind; });
  };
  EXPECT_TRUE(pushes(0.1));
  EXPECT_FALSE(pushes(0));
}

// Nothing stops a robot that coasts and does not see it: such samples have to be asked for.
TEST(Adversaries, LoseSamplesOfRobotsThatStopBlindAlone) {
  const auto loses = [](bool twist, const Scenario& scenario) {
    DecisionCase decision;
    decision.twist = twist;
    const auto all = applicable(decision, scenario);
    return std::any_of(all.begin(), all.end(),
                       [](const Adversary* a) { return a->fault_every_us > 0; });
  };
  Scenario says;
  says.fault_us_max = 150'000;
  EXPECT_TRUE(loses(true, {}));
  EXPECT_FALSE(loses(false, {}));
  EXPECT_TRUE(loses(false, says));
}

}  // namespace
}  // namespace rtac::simulate
