// What an application tells a robot's decision of its plain inputs is what its monitors judge. The
// system is that of a golden case, compiled as it is kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "spec_system.h"
#include "tests/runtime/stack/test_system.h"

namespace rtac {
namespace {

constexpr TimeUs permit_until_us = 3'000'000;
constexpr std::size_t allowed = 1;  // in the order of priority

// A robot at rest in the middle of its room; the permit comes with what it senses, for a while.
class Parked : public FleetSdk<Acceleration>, public RobotSdk<Acceleration> {
 public:
  facts::System* system = nullptr;
  void sense(Observation& out) override {
    out.position = {{2.5, 2.5}, clock_us_};
    out.velocity = {{0, 0}, clock_us_};
    facts::Fly& decision = system->decision_of(0);
    decision.heat(300, clock_us_).gear(facts::Gear::parked, clock_us_);
    decision.permit(clock_us_ < permit_until_us, clock_us_);
  }
  void actuate(const Acceleration&) override {}
  void announce(const Announcement&) override {}
  RobotSdk<Acceleration>& robot(int) override { return *this; }
  [[nodiscard]] TimeUs now_us() const override { return clock_us_; }
  bool wait_until(TimeUs time_us) override {
    clock_us_ = std::max(clock_us_, time_us);
    return true;
  }

 private:
  TimeUs clock_us_ = 0;
};

class Newest : public SystemObserver {
 public:
  DecisionRecord record;
  void on_decision(const DecisionRecord& taken) override { record = taken; }
};

TEST(Signals, OfADecisionAreGivenByItsRobot) {
  test::Chase pilot;
  test::StraightPlanner planner;
  test::ListTasks tasks;
  Newest newest;
  facts::System system({{pilot, planner}, tasks}, facts::System::default_options(), &newest);
  Parked robot;
  robot.system = &system;
  ASSERT_EQ(system.run(robot, permit_until_us), Status::ok);
  EXPECT_EQ(newest.record.monitors[allowed].now, Verdict::is_true);
  EXPECT_EQ(newest.record.reason, Reason::surrendered) << "nobody has a task for it";
  ASSERT_EQ(system.run(robot, permit_until_us + 1'000'000), Status::ok);
  EXPECT_EQ(newest.record.monitors[allowed].now, Verdict::is_false);
  EXPECT_EQ(newest.record.reason, Reason::violated);
  EXPECT_EQ(newest.record.deciding_monitor, static_cast<int>(allowed));
}

}  // namespace
}  // namespace rtac
