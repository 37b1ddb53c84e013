// What moves by itself: the bound that the generated kernel uses is the published closed form, with
// the age of what is seen in its horizon; recoveries obey it; what is not known is unsafe.
// Source: Mitsch, Ghorbal, Vogelbach, Platzer: Formal verification of obstacle avoidance and
// navigation of ground robots, IJRR 2017, theorems 1 and 2.
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "strollers.h"

namespace {

using rtac::TimeUs;
using rtac::Verdict;

constexpr double accel = 2, brake = 3;  // m/s^2
constexpr double cart_radius_m = 0.2, walker_radius_m = 0.3, truck_radius_m = 1;
constexpr double walker_mps = 1.5, truck_mps = 4, truck_error_m = 0.2;
constexpr TimeUs now_us = 10'000'000;
constexpr double s_per_us = 1e-6;
// The hold of a base whose speed is commanded is within 1 cm; a turn of 10 mrad/s bends the stop by
// a permille at most; each of about ten terms is rounded up to 1 mm.
constexpr double hold_m = 0.01, rounding_m = 0.02;

struct Scene {
  double speed_mps = 0;  // along x, towards the agents
  TimeUs position_age_us = 0, walker_age_us = 0, truck_age_us = 0;
  double walker_x_m = 400, truck_x_m = 450, other_truck_x_m = 460;
  double x_m = 0;
};

class Agents : public ::testing::Test {
 protected:
  static void see(strollers::Drive& d, const Scene& s, TimeUs at_us = now_us, bool there = true) {
    using Metres = rtac::Length;
    d.position({Metres(s.x_m), Metres(0)}, at_us - s.position_age_us);
    d.velocity({rtac::Speed(s.speed_mps), rtac::Speed(0)}, at_us - s.position_age_us);
    d.heading(rtac::Angle(0), at_us);
    d.walker_position({Metres(s.walker_x_m), Metres(0)}, at_us - s.walker_age_us);
    d.trucks_0_position({Metres(s.truck_x_m), Metres(0)}, at_us - s.truck_age_us);
    d.trucks_1_position({Metres(s.other_truck_x_m), Metres(0)}, at_us - s.truck_age_us);
    if (!there) return;
    d.trucks_0_present(true, at_us);
    d.trucks_1_present(true, at_us);
  }
  static rtac::DecisionRecord judged(const Scene& s) {
    strollers::Drive d(0);
    see(d, s);
    return d.step(now_us);
  }
  // Theorem 2; theorem 1 without the agent.
  static double closed_form(double v, double t, double agent_mps) {
    return v * v / (2 * brake) + agent_mps * v / brake +
           (accel / brake + 1) * (accel * t * t / 2 + t * (v + agent_mps));
  }
  static double bend(double v, double t) {
    const double s1 = v + accel * t;
    return s1 * s1 / (2 * brake) / 1000;
  }
};

TEST_F(Agents, TheBoundIsTheoremTwo) {
  for (const double v : {0.0, 0.5, 2.0, 7.3}) {
    for (const TimeUs age_us : {0, 37'000, 300'000}) {
      Scene s;
      s.speed_mps = v;
      s.position_age_us = s.walker_age_us = age_us;
      const double t = 0.15 + s_per_us * double(age_us);  // ahead and latency
      const double gap = s.walker_x_m - cart_radius_m - walker_radius_m;
      const double threshold = gap - 0.5 - judged(s).monitors[0].margin;
      const double least = closed_form(v, t, walker_mps);
      EXPECT_GE(threshold, least + hold_m) << v << " " << age_us;
      EXPECT_LE(threshold, least + hold_m + bend(v, t) + rounding_m) << v << " " << age_us;
    }
  }
}

TEST_F(Agents, FencesHaveTheBoundOfTheoremOne) {
  for (const double v : {0.0, 0.5, 2.0, 7.3}) {
    for (const TimeUs age_us : {0, 300'000}) {
      Scene s;
      s.speed_mps = v;
      s.position_age_us = age_us;
      const double t = 0.15 + s_per_us * double(age_us);
      const double threshold = 500 - cart_radius_m - judged(s).monitors[2].margin;
      const double least = closed_form(v, t, 0);
      EXPECT_GE(threshold, least + hold_m) << v << " " << age_us;
      EXPECT_LE(threshold, least + hold_m + bend(v, t) + rounding_m) << v << " " << age_us;
    }
  }
}

// Seen later than the robot: the agent has moved since, the robot has not.
TEST_F(Agents, TheAgeOfWhatIsSeenCounts) {
  Scene s;
  s.speed_mps = 2;
  const double fresh = judged(s).monitors[0].margin;
  s.walker_age_us = 400'000;
  EXPECT_NEAR(fresh - judged(s).monitors[0].margin, walker_mps * 0.4, 0.002);
  const double now = judged(s).monitors[0].now == Verdict::is_true ? 1 : 0;
  EXPECT_EQ(now, 1);
}

// Its radius and how wrong it is seen are added, and the nearest one decides.
TEST_F(Agents, TheNearestOfSeveralDecides) {
  Scene s;
  s.speed_mps = 2;
  s.other_truck_x_m = 300;
  const double t = 0.25;
  const double gap = s.other_truck_x_m - cart_radius_m - truck_radius_m - truck_error_m;
  const double threshold = gap - 2 - judged(s).monitors[1].margin;
  EXPECT_GE(threshold, closed_form(2, t, truck_mps) + hold_m);
  EXPECT_LE(threshold, closed_form(2, t, truck_mps) + hold_m + bend(2, t) + rounding_m);
}

// The gap between the bodies, as wrong as what is seen, and as far as the agent may have come.
TEST_F(Agents, NowTheGapIsBetweenTheBodies) {
  const auto now = [](double walker_x_m, TimeUs age_us) {
    Scene s;
    s.walker_x_m = walker_x_m;
    s.walker_age_us = age_us;
    return judged(s).monitors[0].now;
  };
  const double touching = cart_radius_m + walker_radius_m + 0.5;
  EXPECT_EQ(now(touching + 0.01, 0), Verdict::is_true);
  EXPECT_EQ(now(touching - 0.01, 0), Verdict::is_false);
  EXPECT_EQ(now(touching + 0.29, 200'000), Verdict::is_unknown);
  EXPECT_EQ(now(touching - 0.29, 200'000), Verdict::is_unknown);
  EXPECT_EQ(now(touching + 0.31, 200'000), Verdict::is_true);
  EXPECT_EQ(now(touching - 0.31, 200'000), Verdict::is_false);
}

TEST_F(Agents, WhatIsNotSeenIsUnknown) {
  const auto ahead = [](auto change) {
    strollers::Drive d(0);
    see(d, {});
    change(d);
    return d.step(now_us).monitors[0].ahead;
  };
  const auto at = [](double x, TimeUs stamp_us) {
    return [=](strollers::Drive& d) {
      d.walker_position({rtac::Length(x), rtac::Length(0)}, stamp_us);
    };
  };
  EXPECT_EQ(ahead([](strollers::Drive&) {}), Verdict::is_true);
  EXPECT_EQ(ahead(at(400, now_us - 400'000)), Verdict::is_true);
  EXPECT_EQ(ahead(at(400, now_us - 400'001)), Verdict::is_unknown);
  EXPECT_EQ(ahead(at(400, now_us + 1)), Verdict::is_unknown);
  EXPECT_EQ(ahead(at(std::numeric_limits<double>::quiet_NaN(), now_us)), Verdict::is_unknown);
  EXPECT_EQ(ahead(at(99'999, now_us)), Verdict::is_true);
  EXPECT_EQ(ahead(at(100'001, now_us)), Verdict::is_unknown);
  EXPECT_EQ(ahead(at(-100'001, now_us)), Verdict::is_unknown);
}

// A stamp that goes backwards is one of something else.
TEST_F(Agents, StampsDoNotGoBackwards) {
  strollers::Drive d(0);
  see(d, {});
  EXPECT_EQ(d.step(now_us).monitors[0].ahead, Verdict::is_true);
  const TimeUs next_us = now_us + 100'000;
  see(d, {}, next_us);
  d.walker_position({rtac::Length(400), rtac::Length(0)}, now_us - 1);
  EXPECT_EQ(d.step(next_us).monitors[0].ahead, Verdict::is_unknown);
}

// Absence is asserted, and counts for as long as the sample may be old; then the agent is unknown.
TEST_F(Agents, AnAgentThatIsAbsentIsFarAway) {
  strollers::Drive d(0);
  Scene s;
  s.truck_x_m = 1;
  s.other_truck_x_m = 1;
  see(d, s);
  d.trucks_0_present(false, now_us).trucks_1_present(false, now_us);
  const auto away = d.step(now_us);
  EXPECT_EQ(away.monitors[1].now, Verdict::is_true);
  EXPECT_EQ(away.monitors[1].ahead, Verdict::is_true);
  // nothing new is said of whether it is there
  for (const TimeUs later_us : {now_us + 400'000, now_us + 400'001}) {
    see(d, s, later_us, false);
    EXPECT_EQ(d.step(later_us).monitors[1].now,
              later_us == now_us + 400'000 ? Verdict::is_true : Verdict::is_false);
  }
}

// A recovery that moves is held by the same test, with its own speed, and under its own horizon.
TEST_F(Agents, ARecoveryThatMovesIsGated) {
  const auto gate = [](const Scene& s) {
    strollers::Drive d(0);
    see(d, s);
    const auto& found = d.step(now_us);
    EXPECT_NE(found.mode, 0);
    return found.gate;
  };
  Scene s;
  s.x_m = 499.75;  // at the fence: it starts with a recovery
  s.walker_x_m = 400;
  s.truck_x_m = s.other_truck_x_m = 300;
  EXPECT_EQ(gate(s), rtac::Gate::free);
  s.walker_x_m = 497.9;
  EXPECT_EQ(gate(s), rtac::Gate::free);
  s.walker_x_m = 498.4;
  EXPECT_EQ(gate(s), rtac::Gate::hold);
  s.walker_x_m = 400;
  s.truck_x_m = 494;
  EXPECT_EQ(gate(s), rtac::Gate::free);
  s.truck_x_m = 494.9;
  EXPECT_EQ(gate(s), rtac::Gate::hold);
  s.truck_x_m = 300;
  s.walker_age_us = 400'001;
  EXPECT_EQ(gate(s), rtac::Gate::hold);
}

// The past of a gap, in a return condition.
TEST_F(Agents, ReturnConditionsRememberGaps) {
  strollers::Drive d(0);
  Scene s;
  s.truck_x_m = 4.3;
  see(d, s);
  EXPECT_NE(d.step(now_us).mode, 0);
  s.truck_x_m = 450;
  for (int k = 1; k < 40; ++k) {
    const TimeUs at_us = now_us + 100'000 * k;
    see(d, s, at_us);
    d.step(at_us);
  }
  EXPECT_EQ(d.step(now_us + 4'000'000).mode, 0);
}

}  // namespace
