// The plan executor: who drives, what happens to the plan, and how control comes back.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/runtime/stack/test_system.h"

namespace rtac {
namespace {

using test::Bench;

// Between 1 s and 2 s the record gives control to a recovery, for `reason`.
void take_over(Bench& bench, int mode, Reason reason, Gate gate = Gate::free) {
  bench.decision[0].script = [=](const Observation& seen, DecisionRecord& record) {
    if (seen.now_us < 1'000'000 || seen.now_us >= 2'000'000) return;
    record.mode = mode, record.reason = reason, record.gate = gate;
  };
}

// Undisturbed, the destinations are reached in their order.
TEST(PlanExecutor, DeliversInOrder) {
  Bench bench;
  bench.tasks.waiting[0] = {{1, 0}, {1, 1}, {0, 0}};
  ASSERT_EQ(bench.run(30), Status::ok);
  ASSERT_EQ(bench.tasks.completed_[0].size(), 3u);
  EXPECT_EQ(bench.tasks.completed_[0][1].y, 1);
  EXPECT_EQ(bench.log.plans, 3);
  EXPECT_EQ(bench.log.skip_count, 0u);
}

// A hand-over engages the recovery once, and it then drives every tick with the record's gate.
TEST(PlanExecutor, EngagesOnce) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  take_over(bench, 2, Reason::margin, Gate::away_only);
  ASSERT_EQ(bench.run(3), Status::ok);
  EXPECT_EQ(bench.go_charge[0].engaged, 1);
  EXPECT_EQ(bench.go_charge[0].commands, 10);
  EXPECT_EQ(bench.go_charge[0].last_gate, Gate::away_only);
  EXPECT_EQ(bench.give_way[0].engaged, 0);
}

// A recovery is engaged with the last velocity that was a number, and sees the broken one
// afterwards.
TEST(PlanExecutor, HandsOverTheLastVelocityThatWasANumber) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  bench.fleet.points[0].no_velocity_from_us = 1'000'000;
  bench.decision[0].script = [](const Observation& seen, DecisionRecord& record) {
    if (seen.now_us >= 1'000'000) record.mode = 1;
  };
  ASSERT_EQ(bench.run(1.05), Status::ok);
  ASSERT_EQ(bench.give_way[0].engaged, 1);
  EXPECT_EQ(bench.give_way[0].velocity_at_engagement.stamp_us, 900'000);
  EXPECT_GT(bench.give_way[0].velocity_at_engagement.value.x, 0.1);
  EXPECT_TRUE(std::isnan(bench.give_way[0].last_velocity.value.x));
}

// From one recovery to the other: each is engaged when its turn comes.
TEST(PlanExecutor, SwitchesBetweenRecoveries) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  bench.decision[0].script = [](const Observation& seen, DecisionRecord& record) {
    if (seen.now_us >= 1'000'000) record.mode = seen.now_us < 1'500'000 ? 1 : 2;
  };
  ASSERT_EQ(bench.run(2), Status::ok);
  EXPECT_EQ(bench.give_way[0].commands, 5);
  EXPECT_EQ(bench.go_charge[0].engaged, 1);
  EXPECT_EQ(bench.go_charge[0].commands, 5);
}

// The plan is dropped with control and made anew when control returns; the destination stays.
TEST(PlanExecutor, DropsThePlanAndPlansAnew) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  take_over(bench, 1, Reason::margin);
  ASSERT_EQ(bench.run(1.5), Status::ok);
  EXPECT_EQ(bench.decision[0].last_plan_size, 0u);
  EXPECT_TRUE(bench.fleet.points[0].said.plan.finished());
  EXPECT_TRUE(bench.fleet.points[0].said.claims);
  ASSERT_EQ(bench.run(20), Status::ok);
  EXPECT_EQ(bench.planner[0].calls, 2);
  EXPECT_EQ(bench.tasks.completed_[0].size(), 1u);
  EXPECT_EQ(bench.log.skip_count, 0u);
}

// The recovery's hold reaches the decision module, and the lease of the record is announced.
TEST(PlanExecutor, AnnouncesTheLease) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  take_over(bench, 1, Reason::margin);
  ASSERT_EQ(bench.run(1.5), Status::ok);
  EXPECT_TRUE(bench.decision[0].last_holding);
  EXPECT_EQ(bench.fleet.points[0].said.lease_end_us, 1'400'000 + 500'000);
  bench.give_way[0].is_holding = false;
  ASSERT_EQ(bench.run(0.2), Status::ok);
  EXPECT_EQ(bench.fleet.points[0].said.lease_end_us, never_us);
}

// With the place that is held, once it is.
TEST(PlanExecutor, AnnouncesTheHold) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  take_over(bench, 1, Reason::margin);
  const std::optional<Vec3>& hold = bench.fleet.points[0].said.hold;
  ASSERT_EQ(bench.run(1.5), Status::ok);
  EXPECT_FALSE(hold);
  Halt halt;
  halt.place = {1, 2, 3};
  bench.give_way[0].halts = halt;
  ASSERT_EQ(bench.run(0.2), Status::ok);
  EXPECT_FALSE(hold);
  bench.give_way[0].halts->latched = true;
  ASSERT_EQ(bench.run(0.2), Status::ok);
  ASSERT_TRUE(hold);
  EXPECT_EQ(hold->x, 1);
  EXPECT_EQ(hold->z, 3);
}

// What a recovery says about itself is announced while it drives.
TEST(PlanExecutor, AnnouncesTheRecovery) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  take_over(bench, 2, Reason::margin);
  bench.go_charge[0].is_blocked = true;
  (void)bench.go_charge[0].way.points.push({4, 4});
  ASSERT_EQ(bench.run(1.5), Status::ok);
  EXPECT_TRUE(bench.fleet.points[0].said.blocked);
  ASSERT_EQ(bench.fleet.points[0].said.plan.points.size(), 1u);
  bench.go_charge[0].is_blocked = false;
  bench.go_charge[0].is_parked = true;
  ASSERT_EQ(bench.run(0.2), Status::ok);
  EXPECT_FALSE(bench.fleet.points[0].said.blocked);
  EXPECT_FALSE(bench.fleet.points[0].said.claims);
}

// Without protection the record is still computed, but the advanced controller always drives, and
// no hold is promised that nobody keeps.
TEST(PlanExecutor, WithoutProtectionTheAdvancedControllerDrives) {
  Bench bench;
  bench.options.protect = false;
  bench.tasks.waiting[0] = {{3, 0}};
  bench.decision[0].script = [](const Observation& seen, DecisionRecord& record) {
    record.mode = 1, record.reason = Reason::leg, record.lease_end_us = seen.now_us + 1;
  };
  ASSERT_EQ(bench.run(10), Status::ok);
  EXPECT_EQ(bench.give_way[0].commands, 0);
  EXPECT_EQ(bench.advanced[0].calls, 100);
  EXPECT_EQ(bench.tasks.completed_[0].size(), 1u);
  EXPECT_EQ(bench.fleet.points[0].said.lease_end_us, never_us);
}

// A platform that froze for longer than the watchdog allows costs one tick of braking.
TEST(PlanExecutor, BrakesWhenTheDecisionWasLate) {
  Bench bench;
  bench.tasks.waiting[0] = {{5, 0}};
  bench.fleet.jump_at_us = 1'000'000, bench.fleet.jump_us = 450'000;
  ASSERT_EQ(bench.run(3), Status::ok);
  EXPECT_EQ(bench.log.late, 1);
  EXPECT_EQ(bench.give_way[0].commands, 1);
  EXPECT_EQ(bench.give_way[0].last_gate, Gate::hold);
  // 11 ticks before the freeze end, the late one, then on the period's grid again.
  EXPECT_EQ(bench.decision[0].steps_us[10], 1'450'000);
  EXPECT_EQ(bench.decision[0].steps_us[11], 1'500'000);
}

// Robots tick in the order of the fleet, each with its own period, first at the start.
TEST(System, TicksEachRobotAtItsPeriod) {
  Bench bench(2);
  bench.parts[1].period_us = 250'000;
  ASSERT_EQ(bench.run(1), Status::ok);
  EXPECT_EQ(bench.decision[0].steps_us.size(), 10u);
  EXPECT_EQ(bench.decision[1].steps_us, (std::vector<TimeUs>{0, 250'000, 500'000, 750'000}));
  EXPECT_EQ(bench.fleet.clock_us, 1'000'000);
}

// Stopping and going on is the same as not having stopped.
TEST(System, RunsInPieces) {
  Bench whole, pieces;
  whole.tasks.waiting[0] = pieces.tasks.waiting[0] = {{2, 1}, {0, 0}};
  ASSERT_EQ(whole.run(5), Status::ok);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(pieces.run(0.5), Status::ok);
  EXPECT_EQ(whole.decision[0].steps_us, pieces.decision[0].steps_us);
  EXPECT_EQ(whole.fleet.points[0].p.x, pieces.fleet.points[0].p.x);
  EXPECT_EQ(whole.fleet.points[0].p.y, pieces.fleet.points[0].p.y);
}

// A missing part is found before anything moves.
TEST(System, RefusesMissingParts) {
  test::ListTasks tasks;
  test::PointFleet fleet;
  RobotParts<Acceleration> parts;
  System<Acceleration> system(tasks, &parts, 1);
  EXPECT_EQ(system.run(fleet, 1'000'000), Status::bad_argument);
  EXPECT_EQ(fleet.clock_us, 0);
}

// A way-point in between counts as passed within the declared tracking, so that the leg behind it
// is followed as declared; the destination, within the reach of a destination.
TEST(PlanExecutor, PassesWayPointsWithinTheTracking) {
  Bench bench;
  bench.parts[0].limits.tracking_m = 0.03;
  bench.planner[0].detour_m = 0.5;
  bench.tasks.waiting[0] = {{2, 0}};
  double nearest_m = 1e9, passed_at_m = -1;
  bench.decision[0].script = [&](const Observation& seen, DecisionRecord&) {
    if (seen.plan.points.size() < 2) return;
    if (passed_at_m >= 0) return;
    const double distance_m = norm(seen.plan.points[0] - seen.position.value);
    nearest_m = std::min(nearest_m, distance_m);
    if (seen.plan.index > 0) passed_at_m = distance_m;
  };
  ASSERT_EQ(bench.run(15), Status::ok);
  EXPECT_EQ(bench.log.delivered, 1);
  EXPECT_GE(passed_at_m, 0);
  EXPECT_LE(passed_at_m, 0.03);
}

}  // namespace
}  // namespace rtac
