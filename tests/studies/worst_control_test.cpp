// Ipopt searches the worst admissible control for the drone's fence: from states that the decision
// module just admits, no control for the whole horizon, followed by the brake, reaches the
// standoff.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "drone_surveillance_system.h"
#include "rtac/optimize/worst_case.h"

namespace {

namespace drone = drone_surveillance;
using rtac::Vec2;

constexpr double room_m = 5, standoff_m = 0.12;
constexpr rtac::TimeUs lookahead_us = 100'000;  // as in the specification

// Whether the module lets the advanced controller go on with samples that are as old as allowed.
// A fresh module starts with a recovery, so the state is first shown to be a good one.
bool admits(Vec2 position, Vec2 velocity) {
  drone::PlanExecutor decision;
  decision.plan({});  // none to follow: the duration check alone decides
  const rtac::TimeUs age_us = drone::Quadrotor_limits().position_age_us;
  rtac::TimeUs now_us = 1'000'000;
  const auto feed = [&](Vec2 p, Vec2 v) -> const rtac::DecisionRecord& {
    decision.position({rtac::Length(p.x), rtac::Length(p.y)}, now_us - age_us);
    decision.velocity({rtac::Speed(v.x), rtac::Speed(v.y)}, now_us - age_us);
    return decision.step(now_us);
  };
  EXPECT_TRUE(feed({room_m / 2, room_m / 2}, {0, 0}).advanced());
  now_us += 50'000;
  return feed(position, velocity).advanced();
}

rtac::ReachProblem problem_of(Vec2 position, Vec2 velocity) {
  const rtac::RobotLimits& limits = drone::Quadrotor_limits();
  rtac::ReachProblem problem;
  problem.position = position;
  problem.velocity = velocity;
  problem.position_error_m = limits.position_error_m;
  problem.velocity_error_mps = limits.velocity_error_mps;
  problem.accel_mps2 = limits.accel_mps2;
  problem.brake_mps2 = limits.brake_mps2;
  problem.speed_mps = limits.speed_mps;
  problem.horizon_s =
      1e-6 * static_cast<double>(limits.position_age_us + lookahead_us + limits.latency_us);
  return problem;
}

// Closest place to the wall x = room that is admitted with this velocity.
double last_admitted_x(double y, Vec2 velocity) {
  double good = room_m / 2, bad = room_m;
  while (bad - good > 1e-4) {
    const double middle = 0.5 * (good + bad);
    (admits({middle, y}, velocity) ? good : bad) = middle;
  }
  return good;
}

TEST(WorstControl, IsCoveredByTheLookAhead) {
  const double body_m = drone::Quadrotor_limits().radius_m;
  double tightest = 0;
  for (const double speed : {0.0, 0.2, 0.5, 0.8, 0.97}) {
    for (const double angle : {0.0, 0.6, 1.3}) {
      const Vec2 velocity{speed * std::cos(angle), speed * std::sin(angle)};
      const double x = last_admitted_x(room_m / 2, velocity);
      const auto worst =
          rtac::worst_case_in_room(problem_of({x, room_m / 2}, velocity), drone::room_zone());
      ASSERT_EQ(worst.status, rtac::SearchStatus::converged);
      const double excursion = worst.edges[worst.worst_edge].excursion_m;
      // the centre keeps the body and the standoff to the wall
      EXPECT_LE(excursion, -(body_m + standoff_m)) << "speed " << speed << ", angle " << angle;
      const double allowed = room_m - x - body_m - standoff_m;
      const double used = allowed - (-excursion - body_m - standoff_m);
      tightest = std::max(tightest, used / allowed);
    }
  }
  RecordProperty("tightness", std::to_string(tightest));
  std::cout << "worst control found uses up to " << 100 * tightest << " % of the bound\n";
  // An empty search would also be covered: the adversary must come close.
  EXPECT_GT(tightest, 0.6);
}

// The search is no accident of the states near the boundary: beyond them it does find violations.
TEST(WorstControl, FindsAViolationWhereTheModuleWouldNotAdmit) {
  const Vec2 velocity{0.8, 0};
  const Vec2 place{room_m - 0.55, room_m / 2};
  ASSERT_FALSE(admits(place, velocity));
  const auto worst = rtac::worst_case_in_room(problem_of(place, velocity), drone::room_zone());
  const double body_m = drone::Quadrotor_limits().radius_m;
  EXPECT_GT(worst.edges[worst.worst_edge].excursion_m, -(body_m + standoff_m));
}

}  // namespace
