// Recoveries in space that move, in whole systems under noise on its bounds: they keep the zone,
// give control back or hold, do not creep, and come back from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "loft_system.h"
#include "rtac/sim/random.h"
#include "rtac/sim/world.h"

namespace {

using rtac::Acceleration;
using rtac::Vec2;
using rtac::Vec3;

constexpr double radius_m = 0.15, error_m = 0.02, accel_mps2 = 1.5;

// Pushes in one direction, as hard as it can.
class Push final : public rtac::Controller<Acceleration> {
 public:
  explicit Push(Vec3 way) : way_(way) {}
  Acceleration command(const rtac::Observation&) override {
    return {{accel_mps2 * way_.x, accel_mps2 * way_.y}, accel_mps2 * way_.z};
  }

 private:
  Vec3 way_;
};
class Nowhere final : public rtac::Planner {
 public:
  bool plan(const rtac::PlanRequest& request, rtac::Path& plan) override {
    plan.points.clear();
    return plan.points.push(request.goal);
  }
};
class Again final : public rtac::TaskSource {
 public:
  bool next(int, Vec2& destination) override {
    destination = {3, 3};
    return true;
  }
  void completed(int, Vec2, rtac::TimeUs) override {}
  void skipped(int, Vec2, rtac::TimeUs) override {}
};
// Counts how often control goes either way.
class Counter final : public rtac::SystemObserver {
 public:
  void on_decision(const rtac::DecisionRecord& record) override {
    advanced_ticks += record.mode == 0 ? 1 : 0;
    engaged += record.mode != 0 && record.previous_mode == 0 ? 1 : 0;
    if (record.mode != 0 && record.previous_mode == 0) engaged_us = record.time_us;
    mode = record.mode;
  }
  int advanced_ticks = 0, engaged = 0, mode = 0;
  rtac::TimeUs engaged_us = 0;
};

template <class System, class Step>
void fly(const rtac::RobotLimits& limits, Vec3 start, Vec3 way, std::uint64_t seed, double until_s,
         Counter& counter, const Step& on_step) {
  rtac::sim::RobotSetup setup;
  setup.limits = limits;
  setup.start = {start.x, start.y};
  setup.height_m = start.z;
  rtac::sim::WorldOptions options;
  options.seed = seed;
  options.noise = rtac::sim::NoiseModel::extreme;
  rtac::sim::World<Acceleration> world({setup}, options);
  world.on_step([&](rtac::TimeUs now_us) {
    on_step(1e-6 * double(now_us), position_of(world.truth(0)), velocity_of(world.truth(0)));
  });
  Push pilot(way);
  Nowhere planner;
  Again tasks;
  auto system = std::make_unique<System>(typename System::Controllers{{pilot, planner}, tasks},
                                         System::default_options(), &counter);
  EXPECT_EQ(system->run(world, rtac::TimeUs(1e6 * until_s)), rtac::Status::ok);
}

const Vec3 ways[] = {{0, 0, 1},      {0, 0, -1},    {1, 0, 0},
                     {-0.6, 0, 0.8}, {0.6, 0, 0.8}, {0, 0.8, -0.6}};

TEST(SpaceRecoveries, ARetreatKeepsTheZoneAndGivesControlBack) {
  for (const Vec3& way : ways) {
    Counter counter;
    double least_m = 1e9;
    fly<loft::OwlSystem>(loft::Owl_limits(), {3, 5, 3}, way, 7, 60, counter,
                         [&](double, Vec3 p, Vec3) {
                           least_m = std::min(least_m, signed_clearance(loft::barn_zone(), p));
                         });
    EXPECT_GE(least_m, radius_m);
    EXPECT_GT(counter.engaged, 2) << way.x << " " << way.z;
  }
}

// Over the narrower hall above: down into the wider one, or level, never through the roof of it.
TEST(SpaceRecoveries, ARetreatComesBackFromOutside) {
  const Vec3 starts[] = {{3, 5, 12.5}, {3, 5, -0.6}, {-0.7, 5, 3}, {10.6, 4, 2}, {6.6, 5, 9}};
  for (const Vec3& start : starts) {
    Counter counter;
    const double before_m = signed_clearance(loft::barn_zone(), start);
    double deepest_m = before_m, last_m = before_m;
    fly<loft::OwlSystem>(loft::Owl_limits(), start, {0, 0, 0}, 9, 40, counter,
                         [&](double, Vec3 p, Vec3) {
                           last_m = signed_clearance(loft::barn_zone(), p);
                           deepest_m = std::min(deepest_m, last_m);
                         });
    EXPECT_GE(deepest_m, before_m - 2 * error_m) << start.x << " " << start.z;
    EXPECT_GE(last_m, radius_m) << start.x << " " << start.z;
    EXPECT_EQ(counter.mode, 0) << start.x << " " << start.z;
  }
}

// Control comes back when it has been down for four seconds, and then it is driven off again.
TEST(SpaceRecoveries, ALandingGoesStraightDownAndStays) {
  for (const Vec3& way : {ways[0], ways[2], ways[4]}) {
    Counter counter;
    double least_m = 1e9, lowest_m = 1e9, fastest_mps = 0, aside_m = 0, last_m = 0;
    Vec3 stopped{};
    fly<loft::SwiftSystem>(
        loft::Swift_limits(), {5, 5, 7.2}, way, 5, 90, counter, [&](double t_s, Vec3 p, Vec3 v) {
          least_m = std::min(least_m, signed_clearance(loft::tower_zone(), p));
          lowest_m = std::min(lowest_m, p.z);
          if (counter.mode == 0) return;
          const double since_s = t_s - 1e-6 * double(counter.engaged_us);
          if (since_s < 3) stopped = p;  // by then it has braked
          if (since_s < 3) return;
          fastest_mps = std::max(fastest_mps, norm(v));
          aside_m = std::max(aside_m, std::hypot(p.x - stopped.x, p.y - stopped.y));
          if (since_s > 30) last_m = std::max(last_m, std::abs(p.z - 1));
        });
    EXPECT_GE(least_m, radius_m);
    EXPECT_GE(lowest_m, 1 - 0.06);  // no farther than a hold may be from its place
    EXPECT_GE(counter.engaged, 2);
    EXPECT_LE(fastest_mps, 0.3 + 0.05);
    EXPECT_LE(aside_m, 0.06);
    EXPECT_LE(last_m, 0.06);
  }
}

}  // namespace
