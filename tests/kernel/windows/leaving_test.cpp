// An adversary drives into a place that will be forbidden, and into a hall whose gate will close:
// when that happens the robot has left, by the true state, at every millisecond of three hours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "rtac/sim/world.h"
#include "windows_system.h"

namespace {

using rtac::TimeUs;
using rtac::Vec2;

constexpr TimeUs minute_us = 60'000'000, end_us = 190 * minute_us;
constexpr double radius_m = 0.2, standoff_m = 0.5;

bool within(TimeUs at, TimeUs from_minute, TimeUs until_minute) {
  return from_minute * minute_us <= at && at < until_minute * minute_us;
}
bool lessons(TimeUs at) {
  return within(at, 60, 90) || within(at, 120, 140);
}
bool gate(TimeUs at) {
  return within(at, 10, 80) || within(at, 110, 180);
}

// Of a place from a rectangle, negative inside.
double gap(Vec2 p, Vec2 low, Vec2 high) {
  const double dx = std::max({low.x - p.x, p.x - high.x}),
               dy = std::max({low.y - p.y, p.y - high.y});
  return dx > 0 && dy > 0 ? std::hypot(dx, dy) : std::max(dx, dy);
}
double to_lessons(Vec2 p) {
  return gap(p, {2, 3}, {4, 5});
}
double out_of_yard(Vec2 p) {
  return gap(p, {0, 0}, {12, 8});
}
double out_of_hall(Vec2 p) {
  return gap(p, {9, 1}, {18, 7});
}

// Stays in the lessons or far in the hall, as long as it is let.
class Stubborn final : public rtac::Controller<rtac::Acceleration> {
 public:
  explicit Stubborn(Vec2 goal) : goal_(goal) {}
  rtac::Acceleration command(const rtac::Observation& seen) override {
    const Vec2 to = goal_ - seen.position.value;
    const Vec2 wanted = std::min(1.0, 0.9 / std::max(0.01, norm(to))) * to;
    const Vec2 a = 4.0 * (wanted - seen.velocity.value);
    return {std::min(1.0, 2.0 / std::max(0.01, norm(a))) * a};
  }

 private:
  Vec2 goal_;
};

class Straight final : public rtac::Planner {
 public:
  bool plan(const rtac::PlanRequest& request, rtac::Path& plan) override {
    plan.points.clear();
    return plan.points.push(request.goal);
  }
};
class Again final : public rtac::TaskSource {
 public:
  explicit Again(Vec2 goal) : goal_(goal) {}
  bool next(int, Vec2& destination) override {
    destination = goal_;
    return true;
  }
  void completed(int, Vec2, TimeUs) override {}
  void skipped(int, Vec2, TimeUs) override {}

 private:
  Vec2 goal_;
};

struct Seen {
  double least_to_lessons_m = 99, least_in_yard_m = 99;  // while they matter
  TimeUs in_lessons_us = 0, in_hall_us = 0;              // while they do not
};

Seen drive(Vec2 goal, std::uint64_t seed) {
  rtac::sim::RobotSetup setup;
  setup.limits = windows::Rover_limits();
  setup.start = {8, 4};
  rtac::sim::WorldOptions options;
  options.seed = seed;
  options.noise = rtac::sim::NoiseModel::extreme;
  rtac::sim::World<rtac::Acceleration> world({setup}, options);
  Seen run;
  world.on_step([&](TimeUs now) {
    const Vec2 p = world.truth(0).position;
    if (lessons(now)) {
      run.least_to_lessons_m = std::min(run.least_to_lessons_m, to_lessons(p) - radius_m);
    } else if (to_lessons(p) < standoff_m + radius_m) {
      run.in_lessons_us += 1000;
    }
    const double in_yard_m = -out_of_yard(p) - radius_m, in_hall_m = -out_of_hall(p) - radius_m;
    if (!gate(now)) {
      run.least_in_yard_m = std::min(run.least_in_yard_m, in_yard_m);
    } else {
      run.least_in_yard_m = std::min(run.least_in_yard_m, std::max(in_yard_m, in_hall_m));
      if (in_yard_m < 0) run.in_hall_us += 1000;
    }
  });
  Stubborn pilot(goal);
  Straight planner;
  Again tasks(goal);
  auto system =
      std::make_unique<windows::System>(windows::System::Controllers{{pilot, planner}, tasks});
  EXPECT_EQ(system->run(world, end_us), rtac::Status::ok);
  return run;
}

TEST(Windows, WhatWillBeForbiddenIsLeftInTime) {
  for (const std::uint64_t seed : {1, 2}) {
    const Seen run = drive({3, 4}, seed);
    EXPECT_GE(run.least_to_lessons_m, standoff_m) << seed;
    EXPECT_GE(run.least_in_yard_m, 0) << seed;
    // Look-ahead, a way of all cells and its legs cost minutes, not all of the time between.
    EXPECT_GT(run.in_lessons_us, 60 * minute_us) << seed;
  }
}

TEST(Windows, AHallIsLeftBeforeItsGateCloses) {
  for (const std::uint64_t seed : {1, 2}) {
    const Seen run = drive({15, 4}, seed);
    EXPECT_GE(run.least_in_yard_m, 0) << seed;
    EXPECT_GT(run.in_hall_us, 60 * minute_us) << seed;
  }
}

// At a wall of the hall no way is known that keeps the clearance of the route.
TEST(Windows, AreOfNoUseWhereNoWayOutIsKnown) {
  const auto ahead = [](Vec2 at) {
    windows::Drive decision(0);
    rtac::Observation seen;
    seen.now_us = 12 * minute_us;
    seen.robots = 1;
    seen.position = {at, seen.now_us};
    seen.velocity = {{0, 0}, seen.now_us};
    return decision.step(seen, false, false).monitors[1].ahead;
  };
  EXPECT_EQ(ahead({15, 4}), rtac::Verdict::is_true);
  EXPECT_EQ(ahead({17.3, 4}), rtac::Verdict::is_false);
}

}  // namespace
