// Two robots in space: who passes the look-ahead stays apart from the other one, whatever both do
// until their recoveries act and while they brake; and the bound hardly asks for more than that.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "pairs.h"

namespace pairs {
namespace {

using rtac::Vec3;
using rtac::Verdict;

constexpr double dt_s = 0.001, t0_s = 10, least_m = 0.5;

struct Limits {
  double speed, accel, brake, radius, p_error, v_error, p_age_s, v_age_s, hears_s, horizon_s;
};
const Limits swallow{3, 2, 1.5, 0.25, 0.03, 0.04, 0.06, 0.04, 0.1, 0.23};
const Limits wren{3, 2, 1.5, 0.2, 0, 0, 0, 0, 0, 0.2};

struct Plant {
  Vec3 p, v;
  void push(Vec3 a, const Limits& l) {
    const Vec3 before = v;
    v = v + dt_s * a;
    if (norm(v) > l.speed) v = (l.speed / norm(v)) * v;
    p = p + (0.5 * dt_s) * (before + v);
  }
  void brake(const Limits& l) {
    const double speed = norm(v), least = std::min(speed, l.brake * dt_s);
    const Vec3 before = v;
    v = speed > 0 ? (1 - least / speed) * v : Vec3{};
    p = p + (0.5 * dt_s) * (before + v);
  }
};

rtac::TimeUs us(double s) {
  return static_cast<rtac::TimeUs>(std::llround(1e6 * s));
}
// What robot 0 sees of itself and hears of robot 1.
struct Seen {
  Vec3 p, v, other_p, other_v;
  double p_age_s = 0, v_age_s = 0, other_p_age_s = 0, other_v_age_s = 0;
  rtac::TimeUs held_us = 0;  // how long the other one promises to stay; 0: it does not
};
template <class Decision>
const rtac::DecisionRecord& asked(Decision& decision, const Seen& s) {
  rtac::Observation seen;
  seen.now_us = us(t0_s);
  seen.robots = 2;
  seen.position = {{s.p.x, s.p.y}, seen.now_us - us(s.p_age_s)};
  seen.velocity = {{s.v.x, s.v.y}, seen.now_us - us(s.v_age_s)};
  seen.height_m = s.p.z;
  seen.climb_mps = s.v.z;
  rtac::Announcement& heard = seen.others[1];
  heard.position = {{s.other_p.x, s.other_p.y}, seen.now_us - us(s.other_p_age_s)};
  heard.velocity = {{s.other_v.x, s.other_v.y}, seen.now_us - us(s.other_v_age_s)};
  heard.height_m = s.other_p.z;
  heard.climb_mps = s.other_v.z;
  if (s.held_us > 0) heard.lease_end_us = seen.now_us + s.held_us;
  return decision.step(seen, false, false);
}
Verdict wrens_ahead(Vec3 p, Vec3 v, Vec3 other_p, Vec3 other_v) {
  Hop decision(0);
  return asked(decision, {p, v, other_p, other_v}).monitors[0].ahead;
}

class SpacePairs : public ::testing::Test {
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
  // Often straight at the other one, or level past it.
  Vec3 bold_way(Vec3 at) {
    const double draw = real(0, 1);
    if (draw < 0.4) return (1 / norm(at)) * at;
    const Vec3 level{at.x, at.y, 0};
    if (draw < 0.55 && norm(level) > 0.01) return (1 / norm(level)) * level;
    return way();
  }
  double age(double most_s) { return real(0, 1) < 0.5 ? most_s : real(0, most_s); }
  std::mt19937_64 random_{21};
};

TEST_F(SpacePairs, WhatPassesStaysApart) {
  int passed = 0, at_risk = 0, within_discs = 0;
  for (int n = 0; n < 6'000; ++n) {
    const Vec3 between = real(1, 9) * way();
    std::array<Plant, 2> plants = {{{{0, 0, 0}, real(0, 3) * bold_way(between)},
                                    {between, real(0, 3) * bold_way(-1.0 * between)}}};
    const std::array<Vec3, 2> push = {swallow.accel * bold_way(between),
                                      swallow.accel * bold_way(-1.0 * between)};
    // whoever drives has done so since the oldest sample was taken
    const std::array<double, 2> p_age_s = {age(swallow.p_age_s), age(swallow.hears_s)};
    const std::array<double, 2> v_age_s = {age(swallow.v_age_s), age(swallow.hears_s)};
    std::array<Vec3, 2> p{}, v{};
    std::array<bool, 2> p_seen{}, v_seen{};
    double nearest_m = 1e9;
    const auto measure = [&] {
      nearest_m = std::min(nearest_m, norm(plants[0].p - plants[1].p) - 2 * swallow.radius);
    };
    for (double t_s = -swallow.hears_s; t_s < swallow.horizon_s; t_s += dt_s) {
      for (std::size_t i = 0; i < 2; ++i) {
        if (!p_seen[i] && t_s >= -p_age_s[i]) {
          p[i] = plants[i].p + swallow.p_error * way(), p_seen[i] = true;
        }
        if (!v_seen[i] && t_s >= -v_age_s[i]) {
          v[i] = plants[i].v + swallow.v_error * way(), v_seen[i] = true;
        }
      }
      if (t_s >= 0) measure();
      for (std::size_t i = 0; i < 2; ++i) plants[i].push(push[i], swallow);
    }
    while (norm(plants[0].v) > 0 || norm(plants[1].v) > 0) {
      measure();
      for (Plant& plant : plants) plant.brake(swallow);
    }
    Fly decision(0);
    const rtac::DecisionRecord& found =
        asked(decision, {p[0], v[0], p[1], v[1], p_age_s[0], v_age_s[0], p_age_s[1], v_age_s[1]});
    at_risk += nearest_m < least_m ? 1 : 0;
    if (found.monitors[0].ahead != Verdict::is_true) continue;
    ++passed;
    within_discs += norm(p[0] - p[1]) < 7 ? 1 : 0;
    ASSERT_GE(nearest_m, least_m - 1e-3) << n;
  }
  EXPECT_GT(passed, 1500);
  EXPECT_GT(within_discs, 1000);
  EXPECT_GT(at_risk, 1000);
}

// Head on, both to the last: how near they come, as a share of the room that is asked for.
TEST_F(SpacePairs, TheBoundIsTight) {
  const Vec3 ways[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0.6, 0, 0.8}, {0.48, -0.64, 0.6}};
  for (const Vec3& way : ways) {
    for (const double speed_mps : {0.5, 1.5, 2.5}) {
      double near_m = 0, far_m = 20;
      const auto other = [&](double room_m) { return (room_m + least_m + 2 * wren.radius) * way; };
      for (int k = 0; k < 40; ++k) {
        const double middle = (near_m + far_m) / 2;
        const Verdict ahead = wrens_ahead({}, speed_mps * way, other(middle), -speed_mps * way);
        (ahead == Verdict::is_true ? far_m : near_m) = middle;
      }
      Plant plant{{}, speed_mps * way};
      for (double t_s = 0; t_s < wren.horizon_s - dt_s / 2; t_s += dt_s) {
        plant.push(wren.accel * way, wren);
      }
      while (norm(plant.v) > 0) plant.brake(wren);
      EXPECT_LE(2 * norm(plant.p), far_m) << way.x << " " << way.z << " " << speed_mps;
      EXPECT_GE(2 * norm(plant.p) / far_m, 0.93) << way.x << " " << way.z << " " << speed_mps;
    }
  }
}

// Level flight one above the other is no conflict, whatever a map shows, but for what they may
// climb.
TEST_F(SpacePairs, HeightKeepsThemApart) {
  const Vec3 east{2.5, 0, 0}, west{-2.5, 0, 0};
  EXPECT_EQ(wrens_ahead({}, east, {0, 0, 5}, west), Verdict::is_true);
  EXPECT_EQ(wrens_ahead({}, east, {1, 0, 5}, west), Verdict::is_true);
  EXPECT_EQ(wrens_ahead({}, east, {0, 0, -5}, east), Verdict::is_true);
  EXPECT_NE(wrens_ahead({}, east, {0, 0, 1.2}, west), Verdict::is_true);
  // climbing into each other
  EXPECT_NE(wrens_ahead({}, {0, 0, 2.5}, {0, 0, 5}, {0, 0, -2.5}), Verdict::is_true);
  EXPECT_NE(wrens_ahead({}, {0, 0, 2.9}, {0, 0, 4.4}, {}), Verdict::is_true);
  EXPECT_EQ(wrens_ahead({}, {0, 0, -2.9}, {0, 0, 5}, {0, 0, 2.9}), Verdict::is_true);
}

// At full speed the ball is what is left of the tube along the way, and the tube is narrow across
// it.
TEST_F(SpacePairs, EitherBoundOfEitherOneSuffices) {
  const Vec3 level{2.5, 0, 0}, down{0, 0, -3}, above{0, 0, 5.6};
  EXPECT_EQ(wrens_ahead({}, level, above, down), Verdict::is_true);
  EXPECT_EQ(wrens_ahead(above, down, {}, level), Verdict::is_true);
  EXPECT_NE(wrens_ahead({}, level, {0, 0, 5}, down), Verdict::is_true);
  EXPECT_NE(wrens_ahead({0, 0, 5}, down, {}, level), Verdict::is_true);
}

// Whose ways cross on a map, one climbing over the other.
TEST_F(SpacePairs, WaysThatPassAreNoConflict) {
  EXPECT_EQ(wrens_ahead({}, {2, 0, 0}, {2, -2, 5}, {0, 2, 0.5}), Verdict::is_true);
  EXPECT_NE(wrens_ahead({}, {2, 0, 0}, {2, -2, 3}, {0, 2, -2}), Verdict::is_true);
}

TEST_F(SpacePairs, APromiseToStayIsRelievingInSpaceToo) {
  const Seen near{{}, {}, {0, 0, 1.05}, {}};
  Seen held = near;
  held.held_us = 900'000;
  Hop free(0), relieved(0), too_near(0);
  EXPECT_NE(asked(free, near).monitors[0].ahead, Verdict::is_true);
  EXPECT_EQ(asked(relieved, held).monitors[0].ahead, Verdict::is_true);
  held.other_p.z = 0.95;
  EXPECT_NE(asked(too_near, held).monitors[0].ahead, Verdict::is_true);
}

TEST_F(SpacePairs, DistancesNowAreThoseOfSpace) {
  const auto now = [](Vec3 other) {
    Hop decision(0);
    return asked(decision, {{}, {}, other, {}}).monitors[0].now;
  };
  EXPECT_EQ(now({0, 0, 0.903}), Verdict::is_true);
  EXPECT_EQ(now({0, 0, 0.896}), Verdict::is_false);
  EXPECT_EQ(now({0.6, 0, 0.683}), Verdict::is_true);
  EXPECT_EQ(now({0.5, 0.5, 0.5}), Verdict::is_false);
  EXPECT_EQ(now({0.53, 0.53, 0.53}), Verdict::is_true);
}

TEST_F(SpacePairs, WithoutAHeightNothingIsKnown) {
  Seen seen{{}, {}, {0, 0, 9}, {}};
  seen.other_p.z = std::nan("");
  Fly blind(0), still(0);
  EXPECT_EQ(asked(blind, seen).monitors[0].now, Verdict::is_unknown);
  EXPECT_NE(asked(blind, seen).monitors[0].ahead, Verdict::is_true);
  seen.other_p.z = 9;
  seen.other_v.z = std::nan("");
  EXPECT_EQ(asked(still, seen).monitors[0].now, Verdict::is_true);
  EXPECT_NE(asked(still, seen).monitors[0].ahead, Verdict::is_true);
}

}  // namespace
}  // namespace pairs
