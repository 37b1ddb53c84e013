// Agents beside a robot in space: who passes the look-ahead keeps its distance from them until it
// stands, wherever they go meanwhile; those in space to all sides, the others on the map.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gulls.h"

namespace gulls {
namespace {

using rtac::Vec3;
using rtac::Verdict;

constexpr double dt_s = 0.001, t0_s = 10, horizon_s = 0.23, least_m = 0.5;
constexpr double speed_mps = 3, accel_mps2 = 2, brake_mps2 = 1.5, bodies_m = 0.55;
constexpr double p_error_m = 0.03, v_error_mps = 0.04, gull_mps = 2, gull_error_m = 0.5;
constexpr double p_age_s_max = 0.06, v_age_s_max = 0.04, gull_age_s_max = 0.2;
const Vec3 far{500, 0, 0};

rtac::TimeUs us(double s) {
  return static_cast<rtac::TimeUs>(std::llround(1e6 * s));
}
struct Seen {
  Vec3 p, v, gull = far, walker = far, drone = far;
  double p_age_s = 0, v_age_s = 0, gull_age_s = 0;
};
const rtac::DecisionRecord& asked(Fly& decision, const Seen& s) {
  using Metres = rtac::Length;
  rtac::Observation seen;
  seen.now_us = us(t0_s);
  seen.position = {{s.p.x, s.p.y}, seen.now_us - us(s.p_age_s)};
  seen.velocity = {{s.v.x, s.v.y}, seen.now_us - us(s.v_age_s)};
  seen.height_m = s.p.z;
  seen.climb_mps = s.v.z;
  decision.gull_position({s.gull.x, s.gull.y, s.gull.z}, seen.now_us - us(s.gull_age_s));
  decision.drone_position({s.drone.x, s.drone.y, s.drone.z}, seen.now_us);
  decision.walker_position({Metres(s.walker.x), Metres(s.walker.y)}, seen.now_us);
  return decision.step(seen, false, false);
}
Verdict ahead(const Seen& s, std::size_t monitor) {
  Fly decision(0);
  return asked(decision, s).monitors[monitor].ahead;
}
Verdict now(const Seen& s, std::size_t monitor) {
  Fly decision(0);
  return asked(decision, s).monitors[monitor].now;
}

class SpaceAgents : public ::testing::Test {
 protected:
  double real(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random_);
  }
  Vec3 way() {
    for (;;) {
      const Vec3 v{real(-1, 1), real(-1, 1), real(-1, 1)};
      if (norm(v) > 0.1 && norm(v) < 1) return (1 / norm(v)) * v;
    }
  }
  Vec3 bold_way(Vec3 at) { return real(0, 1) < 0.5 ? (1 / norm(at)) * at : way(); }
  double age(double most_s) { return real(0, 1) < 0.5 ? most_s : real(0, most_s); }
  std::mt19937_64 random_{22};
};

TEST_F(SpaceAgents, WhatPassesKeepsClearUntilItStands) {
  int passed = 0, at_risk = 0;
  for (int n = 0; n < 4'000; ++n) {
    Vec3 p{}, gull = real(1, 9) * way();
    Vec3 v = real(0, speed_mps) * bold_way(gull);
    const Vec3 push = accel_mps2 * bold_way(gull);
    Seen seen;
    seen.p_age_s = age(p_age_s_max);
    seen.v_age_s = age(v_age_s_max);
    seen.gull_age_s = age(gull_age_s_max);
    bool p_seen = false, v_seen = false, gull_seen = false;
    double nearest_m = 1e9;
    const auto move = [&](Vec3 a) {
      const Vec3 before = v;
      v = v + dt_s * a;
      if (norm(v) > speed_mps) v = (speed_mps / norm(v)) * v;
      p = p + (0.5 * dt_s) * (before + v);
      const Vec3 towards = p - gull;
      if (norm(towards) > 0.01) gull = gull + (gull_mps * dt_s / norm(towards)) * towards;
    };
    for (double t_s = -gull_age_s_max; t_s < horizon_s; t_s += dt_s) {
      if (!p_seen && t_s >= -seen.p_age_s) seen.p = p + p_error_m * way(), p_seen = true;
      if (!v_seen && t_s >= -seen.v_age_s) seen.v = v + v_error_mps * way(), v_seen = true;
      if (!gull_seen && t_s >= -seen.gull_age_s) {
        // often seen farther away than it is
        seen.gull = gull + gull_error_m * bold_way(gull - p), gull_seen = true;
      }
      if (t_s >= 0) nearest_m = std::min(nearest_m, norm(p - gull) - bodies_m);
      move(push);
    }
    while (norm(v) > 0) {
      nearest_m = std::min(nearest_m, norm(p - gull) - bodies_m);
      const double speed = norm(v);
      move((-std::min(brake_mps2, speed / dt_s) / speed) * v);
      if (norm(v) < 1e-9) v = {};
    }
    at_risk += nearest_m < least_m ? 1 : 0;
    if (ahead(seen, 0) != Verdict::is_true) continue;
    ++passed;
    ASSERT_GE(nearest_m, least_m - 1e-3) << n;
  }
  EXPECT_GT(passed, 100);
  EXPECT_GT(at_risk, 1000);
}

// At rest it asks for the same in every direction; moving off, for less.
TEST_F(SpaceAgents, ItIsABallAroundARobotAtRest) {
  const auto needed_m = [](Vec3 way, Vec3 v, double age_s = 0) {
    double near_m = 0, far_m = 30;
    for (int k = 0; k < 30; ++k) {
      const double middle = (near_m + far_m) / 2;
      Seen s;
      s.v = v;
      s.gull_age_s = age_s;
      s.gull = middle * way;
      (ahead(s, 0) == Verdict::is_true ? far_m : near_m) = middle;
    }
    return far_m;
  };
  const double level_m = needed_m({1, 0, 0}, {});
  EXPECT_NEAR(needed_m({0, 0, 1}, {}), level_m, 0.005);
  EXPECT_NEAR(needed_m({0.48, -0.64, 0.6}, {}), level_m, 0.005);
  EXPECT_NEAR(needed_m({0, 0, -1}, {2, 0, 0}), needed_m({0, 1, 0}, {2, 0, 0}), 0.005);
  EXPECT_NEAR(needed_m({0, 0, 1}, {0, 0, 2}), needed_m({1, 0, 0}, {2, 0, 0}), 0.005);
  EXPECT_NEAR(needed_m({0, 0, 1}, {0, 0, 3}), needed_m({1, 0, 0}, {3, 0, 0}), 0.005);
  EXPECT_NEAR(needed_m({0, 0, 1}, {}, 0.2), level_m + 0.2 * gull_mps, 0.005);
  EXPECT_GT(needed_m({0, 0, 1}, {0, 0, 2}), needed_m({0, 0, -1}, {0, 0, 2}) + 1);
  EXPECT_GT(needed_m({0, 0, 1}, {0, 0, 2}), needed_m({1, 0, 0}, {0, 0, 2}) + 1);
}

// How wrong it is seen is all that the gull and the drone differ by.
TEST_F(SpaceAgents, TheErrorOfWhatIsSeenCounts) {
  const auto margin = [](const Seen& s, std::size_t monitor) {
    Fly decision(0);
    return asked(decision, s).monitors[monitor].margin;
  };
  Seen s;
  s.gull = s.drone = {3, 4, 5};
  EXPECT_NEAR(margin(s, 2) - margin(s, 0), gull_error_m - 0.05, 1e-9);
}

TEST_F(SpaceAgents, OfWhoIsInThePlaneTheHeightDoesNotCount) {
  Seen s;
  for (const double z : {-80.0, 0.0, 80.0}) {
    s.p = {0, 0, z};
    s.walker = {1.2, 0, 0};
    EXPECT_EQ(now(s, 1), Verdict::is_true) << z;
    EXPECT_NE(ahead(s, 1), Verdict::is_true) << z;
    s.walker = {0.9, 0, 0};
    EXPECT_EQ(now(s, 1), Verdict::is_false) << z;
    s.walker = {0, 9, 0};
    EXPECT_EQ(ahead(s, 1), Verdict::is_true) << z;
  }
  s.p = {};
  s.gull = {0, 0, 1.7};
  EXPECT_EQ(now(s, 0), Verdict::is_true);
  s.gull = {0.2, 0.2, 0.3};
  EXPECT_EQ(now(s, 0), Verdict::is_false);
}

TEST_F(SpaceAgents, WithoutAHeightNothingIsKnown) {
  Seen s;
  s.gull = {9, 9, std::nan("")};
  EXPECT_EQ(now(s, 0), Verdict::is_unknown);
  EXPECT_NE(ahead(s, 0), Verdict::is_true);
  s.gull = {9, 9, 100'001};
  EXPECT_EQ(now(s, 0), Verdict::is_unknown);
  EXPECT_NE(ahead(s, 0), Verdict::is_true);
  s.gull = {9, 9, 9};
  EXPECT_EQ(ahead(s, 0), Verdict::is_true);
}

}  // namespace
}  // namespace gulls
