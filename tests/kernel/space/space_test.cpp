// Robots in space: what passes the look-ahead stays in the hall, whatever it does until its
// recovery acts and while it brakes; and what may leave it hardly goes farther than the bound says.
// The hall is a hall with a gallery, extruded along y, which is how these tests know it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "sky.h"

namespace sky {
namespace {

using rtac::Vec3;
using rtac::Verdict;

constexpr double dt_s = 0.001, depth_m = 20, t0_s = 10;

double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Distance in the (x, z) plane to the outline, negative outside.
double outline_m(double x, double z) {
  static const std::array<std::array<double, 2>, 6> corners = {
      {{0, 0}, {20, 0}, {20, 8}, {12, 8}, {12, 16}, {0, 16}}};
  double nearest = 1e9;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b[0] - a[0], dz = b[1] - a[1];
    const double t =
        std::clamp(((x - a[0]) * dx + (z - a[1]) * dz) / (dx * dx + dz * dz), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(x - a[0] - t * dx, z - a[1] - t * dz));
  }
  const bool inside = x >= 0 && z >= 0 && z <= 16 && (z <= 8 ? x <= 20 : x <= 12);
  return inside ? nearest : -nearest;
}
double clearance_m(Vec3 p) {
  const double sides = std::min(p.y, depth_m - p.y);
  return std::min(sides, outline_m(p.x, p.z));
}

struct Limits {
  double speed, accel, brake, radius, p_error, v_error, p_age_s, v_age_s, horizon_s;
};
const Limits kite{3, 2, 1.5, 0.25, 0.03, 0.04, 0.06, 0.04, 0.23};
const Limits wren{3, 2, 1.5, 0.2, 0, 0, 0, 0, 0.2};

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

template <class Decision>
const rtac::DecisionRecord& asked(Decision& decision, Vec3 p, Vec3 v, double p_age_s = 0,
                                  double v_age_s = 0) {
  const auto us = [](double s) { return static_cast<rtac::TimeUs>(std::llround(1e6 * s)); };
  rtac::Observation seen;
  seen.now_us = us(t0_s);
  seen.robots = 1;
  seen.position = {{p.x, p.y}, seen.now_us - us(p_age_s)};
  seen.velocity = {{v.x, v.y}, seen.now_us - us(v_age_s)};
  seen.height_m = p.z;
  seen.climb_mps = v.z;
  return decision.step(seen, false, false);
}

class Space : public ::testing::Test {
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
  // Mostly straight at something: a wall, a floor, a step.
  Vec3 bold_way() {
    static const std::array<Vec3, 7> at = {
        {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0.6, 0, 0.8}, {0.8, 0, -0.6}}};
    return real(0, 1) < 0.3 ? way() : at[static_cast<std::size_t>(real(0, 6.999))];
  }
  std::mt19937_64 random_{20};
};

TEST_F(Space, WhatPassesStaysInside) {
  int passed = 0, at_risk = 0;
  for (int n = 0; n < 20'000; ++n) {
    Plant plant{{real(0.2, 19.8), real(0.2, 19.8), real(0.2, 15.8)}, real(0, 3) * bold_way()};
    if (clearance_m(plant.p) < kite.radius) continue;
    // whoever drives has done so since the older sample was taken
    const double p_age_s = real(0, 1) < 0.5 ? kite.p_age_s : real(0, kite.p_age_s);
    const double v_age_s = real(0, 1) < 0.5 ? kite.v_age_s : real(0, kite.v_age_s);
    const Vec3 push = kite.accel * bold_way();
    Vec3 p{}, v{};
    const double first_s = -std::max(p_age_s, v_age_s);
    double deepest = 1e9;
    bool p_seen = false, v_seen = false;
    for (double t_s = first_s; t_s < kite.horizon_s; t_s += dt_s) {
      if (!p_seen && t_s >= -p_age_s) p = plant.p + kite.p_error * way(), p_seen = true;
      if (!v_seen && t_s >= -v_age_s) v = plant.v + kite.v_error * way(), v_seen = true;
      if (t_s >= 0 || p_seen) deepest = std::min(deepest, clearance_m(plant.p));
      plant.push(push, kite);
    }
    while (norm(plant.v) > 0) {
      deepest = std::min(deepest, clearance_m(plant.p));
      plant.brake(kite);
    }
    Fly decision(0);
    const rtac::DecisionRecord& found = asked(decision, p, v, p_age_s, v_age_s);
    at_risk += deepest < kite.radius ? 1 : 0;
    if (found.monitors[0].ahead != Verdict::is_true) continue;
    ++passed;
    ASSERT_GE(deepest, kite.radius - 1e-3) << n;
  }
  EXPECT_GT(passed, 1000);
  EXPECT_GT(at_risk, 1500);
}

// How far the worst of them goes towards `way`, as a share of the room that it asks for.
double tightness(Vec3 from, Vec3 way, double speed_mps) {
  double near_m = 0, far_m = 8;  // room between the body and what is ahead
  const auto at = [&](double room_m) { return from - (room_m + wren.radius) * way; };
  for (int k = 0; k < 40; ++k) {
    const double middle = (near_m + far_m) / 2;
    Hop decision(0);
    const bool passes =
        asked(decision, at(middle), speed_mps * way).monitors[0].ahead == Verdict::is_true;
    (passes ? far_m : near_m) = middle;
  }
  Plant plant{at(far_m), speed_mps * way};
  for (double t_s = 0; t_s < wren.horizon_s - dt_s / 2; t_s += dt_s) {
    plant.push(wren.accel * way, wren);
  }
  while (norm(plant.v) > 0) plant.brake(wren);
  const double gone_m = dot(plant.p - at(far_m), way);
  EXPECT_LE(gone_m, far_m);
  return gone_m / far_m;
}

TEST_F(Space, TheBoundIsTight) {
  for (const double speed_mps : {0.5, 1.0, 2.0, 2.5}) {
    EXPECT_GE(tightness({6, 10, 16}, {0, 0, 1}, speed_mps), 0.95) << "ceiling " << speed_mps;
    EXPECT_GE(tightness({6, 10, 0}, {0, 0, -1}, speed_mps), 0.95) << "floor " << speed_mps;
    EXPECT_GE(tightness({16, 10, 8}, {0, 0, 1}, speed_mps), 0.95)
        << "under the gallery " << speed_mps;
    EXPECT_GE(tightness({0, 10, 8}, {-1, 0, 0}, speed_mps), 0.95) << "wall " << speed_mps;
    EXPECT_GE(tightness({12, 10, 14}, {1, 0, 0}, speed_mps), 0.95) << "upper wall " << speed_mps;
  }
}

// Beyond the step there is room at other heights only: a tube that touches both slabs has to fit
// into what they have in common.
TEST_F(Space, EverySlabThatTheTubeTouchesCounts) {
  Hop decision(0), other(0), third(0);
  EXPECT_EQ(asked(decision, {15, 10, 5}, {0, 0, 1}).monitors[0].ahead, Verdict::is_true);
  EXPECT_NE(asked(other, {15, 10, 7.3}, {0, 0, 1}).monitors[0].ahead, Verdict::is_true);
  // straight up past the edge of the gallery, well inside
  EXPECT_EQ(asked(third, {8, 10, 7.3}, {0, 0, 2.5}).monitors[0].ahead, Verdict::is_true);
}

// Near to a floor and on the way up: where it is counts, too.
TEST_F(Space, TheTubeBeginsWhereTheRobotIs) {
  Fly decision(0), higher(0);
  EXPECT_NE(asked(decision, {6, 10, 0.3}, {0, 0, 2}).monitors[0].ahead, Verdict::is_true);
  EXPECT_EQ(asked(higher, {6, 10, 2.5}, {0, 0, 2}).monitors[0].ahead, Verdict::is_true);
}

TEST_F(Space, AltitudesAreLookedAhead) {
  const auto ahead = [&](double z, double climb) {
    Fly decision(0);
    return asked(decision, {6, 10, z}, {0, 0, climb}).monitors[1].ahead;
  };
  const auto now = [&](double z) {
    Fly decision(0);
    return asked(decision, {6, 10, z}, {}).monitors[1].now;
  };
  EXPECT_EQ(ahead(6, 0), Verdict::is_true);
  EXPECT_NE(ahead(11.8, 0), Verdict::is_true);
  EXPECT_NE(ahead(9, 3), Verdict::is_true);
  EXPECT_EQ(ahead(9, -3), Verdict::is_true);
  EXPECT_NE(ahead(3, -3), Verdict::is_true);
  EXPECT_EQ(ahead(3, 3), Verdict::is_true);
  EXPECT_NE(ahead(0.55, 2), Verdict::is_true);  // where it is counts, too
  EXPECT_EQ(now(11.96), Verdict::is_true);
  EXPECT_EQ(now(11.98), Verdict::is_unknown);
  EXPECT_EQ(now(12.04), Verdict::is_false);
  EXPECT_EQ(now(0.46), Verdict::is_false);
}

TEST_F(Space, WithoutAHeightNothingIsKnown) {
  Fly decision(0);
  const rtac::DecisionRecord& found = asked(decision, {6, 10, std::nan("")}, {});
  EXPECT_EQ(found.monitors[0].now, Verdict::is_unknown);
  EXPECT_EQ(found.monitors[1].ahead, Verdict::is_unknown);
  EXPECT_NE(found.mode, 0);
}

}  // namespace
}  // namespace sky
