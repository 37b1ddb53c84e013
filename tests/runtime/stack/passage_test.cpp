// Robots that meet: who makes room for whom, and what a robot does while another one goes first.
#include <gtest/gtest.h>

#include "tests/runtime/stack/test_system.h"

namespace rtac {
namespace {

using test::Bench;

// Robot 0 is HELD at `place`, found no way and asks for passage to `goal`. Its own machines are
// not run: only robot 1 is watched, and robot 0 keeps saying this.
Announcement asks_for_passage(Vec2 place, Vec2 goal) {
  Announcement said;
  said.position = {place, 0};
  said.velocity = {{0, 0}, 0};
  said.lease_end_us = INT64_MAX;
  said.claims = said.blocked = true;
  (void)said.plan.points.push(goal);
  return said;
}

// Holds robot 0 still and mute, so that what it says stays as the test wants it.
void mute(Bench& bench, const Announcement& said) {
  bench.decision[0].script = [&bench, said](const Observation&, DecisionRecord& record) {
    record.mode = 2;  // its errand: nothing the stack announces for it matters
    bench.go_charge[0].on_errand = bench.go_charge[0].is_blocked = true;
    bench.go_charge[0].way = said.plan;
    record.lease_end_us = INT64_MAX;
  };
  bench.fleet.points[0].p = said.position.value;
}

// A robot that comes first asks for passage through this one: the advanced controller gives up
// control, so that the recovery can make room.
TEST(Passage, SurrendersWhenARobotThatComesFirstAsks) {
  Bench bench(2);
  mute(bench, asks_for_passage({0, 0}, {3, 0}));
  bench.fleet.points[1].p = {1, 0};
  bench.tasks.waiting[1] = {{1, 3}};
  ASSERT_EQ(bench.run(2), Status::ok);
  EXPECT_TRUE(bench.fleet.points[0].said.blocked);
  EXPECT_TRUE(bench.decision[1].last_surrender);
  EXPECT_GE(bench.give_way[1].engaged, 1);
}

// Far from its way there is no reason to.
TEST(Passage, GoesOnFarFromTheWayOfTheOther) {
  Bench bench(2);
  mute(bench, asks_for_passage({0, 0}, {3, 0}));
  bench.fleet.points[1].p = {1, 4};
  bench.tasks.waiting[1] = {{3, 4}};
  ASSERT_EQ(bench.run(2), Status::ok);
  EXPECT_FALSE(bench.decision[1].last_surrender);
  EXPECT_EQ(bench.give_way[1].engaged, 0);
  ASSERT_EQ(bench.run(8), Status::ok);
  EXPECT_EQ(bench.log.delivered, 1);
}

// It stays aside for a while after the last word, because the other may stop asking as it moves.
TEST(Passage, StaysAsideAfterTheLastRequest) {
  Bench bench(2);
  mute(bench, asks_for_passage({0, 0}, {3, 0}));
  bench.fleet.points[1].p = {1, 0};
  bench.tasks.waiting[1] = {{1, 3}};
  ASSERT_EQ(bench.run(2), Status::ok);
  ASSERT_TRUE(bench.decision[1].last_surrender);
  bench.decision[0].script = [](const Observation&, DecisionRecord&) {};  // robot 0 asks no more
  const double aside_s = static_cast<double>(bench.options.aside_us) * 1e-6;
  ASSERT_EQ(bench.run(aside_s - 0.5), Status::ok);
  EXPECT_TRUE(bench.decision[1].last_surrender);
  ASSERT_EQ(bench.run(1.0), Status::ok);
  EXPECT_FALSE(bench.decision[1].last_surrender);
}

// Beside a robot that must charge, one that only delivers makes no claim.
TEST(Passage, ErrandsComeBeforeDeliveries) {
  Bench bench(2);
  mute(bench, asks_for_passage({0, 0}, {3, 0}));
  bench.fleet.points[1].p = {1.2, 0.8};
  bench.tasks.waiting[1] = {{1.2, 3}};
  ASSERT_EQ(bench.run(0.5), Status::ok);
  EXPECT_TRUE(bench.fleet.points[0].said.errand);
  EXPECT_FALSE(bench.fleet.points[1].said.claims);
}

// A way around the others that is much longer than the direct one is not driven.
TEST(Passage, WaitsRatherThanTakingALongWayAround) {
  for (const bool is_long : {false, true}) {
    Bench bench(2);
    bench.tasks.waiting[0] = {{3, 0}};
    bench.fleet.points[1].p = {1.5, 1.2};  // in nobody's way, but it makes plans go around
    bench.fleet.points[1].said.position = {{1.5, 1.2}, 0};
    bench.options.near_gaps = 10;
    // by two sides of a triangle: 0.2 m longer, or 3 m
    bench.planner[0].around_m = is_long ? 2.6 : 0.55;
    ASSERT_EQ(bench.run(1), Status::ok);
    EXPECT_EQ(bench.log.plans, is_long ? 0 : 1);
    EXPECT_EQ(bench.fleet.points[0].said.blocked, is_long);
  }
}

// A leg that fails because of another robot is no fault of the plan: it waits and tries again.
TEST(Passage, WaitingForARobotIsNoRejection) {
  Bench bench(2);
  bench.tasks.waiting[0] = {{3, 0}};
  bench.fleet.points[1].p = {0, 9};
  bench.decision[0].script = [](const Observation& seen, DecisionRecord& record) {
    if (seen.now_us > 6'000'000 || seen.plan.points.empty()) return;
    record.mode = 1, record.reason = Reason::leg, record.reason_other = 1;
  };
  ASSERT_EQ(bench.run(20), Status::ok);
  EXPECT_EQ(bench.log.skip_count, 0u);
  EXPECT_EQ(bench.log.delivered, 1);
  EXPECT_LE(bench.planner[0].calls, 10);  // not one a tick while it waits
}

}  // namespace
}  // namespace rtac
