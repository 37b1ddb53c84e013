// Robot delivery (paper, section 4.2): two robots, three monitors, a planner that is an RTA module
// too. 20 seeds of twelve minutes; noise on its declared bound, latency and ages as declared.
#include "study.h"

namespace {

using nlohmann::json;

constexpr int seeds = 20;

class Delivery : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::string flags = "--seeds " + std::to_string(seeds);
    protected_ = study::run(flags, "protected");
    unprotected_ = study::run(flags + " --unprotected", "unprotected");
  }
  static void TearDownTestSuite() { protected_ = unprotected_ = json(); }

  // Calls `check` with every robot of every protected shift.
  template <class Check>
  static void for_robots(const Check& check) {
    ASSERT_EQ(protected_.size(), static_cast<std::size_t>(seeds));
    for (const json& shift : protected_) {
      for (const json& robot : shift["robots"]) {
        SCOPED_TRACE("seed " + shift["seed"].dump() + ": " + robot.dump());
        check(robot);
      }
    }
  }
  static int sum(const char* field, std::size_t monitor) {
    int total = 0;
    for_robots([&](const json& robot) { total += robot[field][monitor].get<int>(); });
    return total;
  }

  static json protected_, unprotected_;
};
json Delivery::protected_, Delivery::unprotected_;

// SR-1, SR-2, SR-3 on the true state, at every step of 1 ms or less.
TEST_F(Delivery, ViolatesNothing) {
  for_robots([](const json& robot) {
    EXPECT_GE(robot["clearance_m"].get<double>(), 0.0);
    EXPECT_GE(robot["gap_m"].get<double>(), 0.08);
    EXPECT_GE(robot["battery_margin"].get<double>(), 0.0);
  });
  for (const json& shift : protected_) EXPECT_FALSE(shift["violated"].get<bool>()) << shift["seed"];
}

// The same controllers and seeds without the decision modules do.
TEST_F(Delivery, UnprotectedViolatesInEverySeed) {
  ASSERT_EQ(unprotected_.size(), static_cast<std::size_t>(seeds));
  for (const json& shift : unprotected_)
    EXPECT_TRUE(shift["violated"].get<bool>()) << shift["seed"];
}

// Nobody obeys the decisions there: the advanced controller drives all the time.
TEST_F(Delivery, UnprotectedLeavesTheAdvancedControllerAlone) {
  for (const json& shift : unprotected_) {
    for (const json& robot : shift["robots"]) EXPECT_EQ(robot["advanced_share"].get<double>(), 1.0);
  }
}

TEST_F(Delivery, DeliversTenParcelsPerRobot) {
  for_robots([](const json& robot) { EXPECT_GE(robot["deliveries"].get<int>(), 10); });
}

// No period above a minute without progress; charging at the dock is progress.
TEST_F(Delivery, NeverStandsStillForAMinute) {
  for_robots([](const json& robot) { EXPECT_LE(robot["longest_idle_s"].get<double>(), 60.0); });
}

TEST_F(Delivery, AdvancedControllerDrivesAtLeastThirtyPercent) {
  for_robots([](const json& robot) { EXPECT_GE(robot["advanced_share"].get<double>(), 0.30); });
}

// Collision, geofence, battery: each engages in every shift, and over all shifts each of them also
// engages while another one is engaged.
TEST_F(Delivery, EachMonitorActs) {
  for (const json& shift : protected_) {
    for (std::size_t monitor = 0; monitor < 3; ++monitor) {
      int engaged = 0;
      for (const json& robot : shift["robots"]) engaged += robot["engaged"][monitor].get<int>();
      EXPECT_GT(engaged, 0) << "seed " << shift["seed"] << ", monitor " << monitor;
    }
  }
  for (std::size_t monitor = 0; monitor < 3; ++monitor) {
    EXPECT_GT(sum("engaged_meanwhile", monitor), 0) << "monitor " << monitor;
  }
}

// The motion planner's own decision module refuses plans that cut corners.
TEST_F(Delivery, PlannerIsSupervisedToo) {
  for_robots([](const json& robot) { EXPECT_GT(robot["plans_rejected"].get<int>(), 0); });
}

// The same seed gives the same results, to the last digit that is reported.
TEST_F(Delivery, IsReproducible) {
  const json again = study::run("--seeds 2", "again");
  ASSERT_EQ(again.size(), 2u);
  EXPECT_EQ(again[0], protected_[0]);
  EXPECT_EQ(again[1], protected_[1]);
}

}  // namespace
