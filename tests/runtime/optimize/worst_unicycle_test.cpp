#include "rtac/optimize/worst_unicycle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/runtime/optimize/reach.h"

namespace rtac {
namespace {

constexpr double pi = 3.14159265358979323846;

// `angle`: between its way and the normal, which is x.
UnicycleProblem cart(double speed_mps, double angle_rad) {
  UnicycleProblem q;
  q.position = {1, 2};
  q.velocity = speed_mps * Vec2{std::cos(angle_rad), std::sin(angle_rad)};
  q.heading_rad = angle_rad;
  q.accel_mps2 = 1;
  q.brake_mps2 = 1.2;
  q.speed_mps = 1.5;
  q.turn_radps = 2;
  q.turn_accel_radps2 = 20;
  q.horizon_s = 0.5;
  q.normal = {1, 0};
  return q;
}

// From its places alone: nothing is faster, sharper or farther than it may be.
void expect_admissible(const UnicycleProblem& q, const UnicycleMotion& m) {
  constexpr double rounding = 1 + 1e-6;
  ASSERT_NE(m.status, SearchStatus::invalid_problem);
  ASSERT_GT(m.places_m.size(), 1U);
  EXPECT_LE(norm(m.places_m[0] - q.position), q.position_error_m * rounding);
  const Vec2 way{std::cos(m.headings_rad[0]), std::sin(m.headings_rad[0])};
  EXPECT_LE(norm(m.speeds_mps[0] * way - q.velocity), q.velocity_error_mps * rounding + 1e-9);
  EXPECT_LE(std::abs(m.headings_rad[0] - q.heading_rad), q.heading_error_rad * rounding + 1e-12);
  double farthest = -HUGE_VAL;
  for (std::size_t k = 0; k < m.places_m.size(); ++k) {
    farthest = std::max(farthest, dot(q.normal, m.places_m[k] - q.position));
    EXPECT_GE(m.speeds_mps[k], 0);
    EXPECT_LE(m.speeds_mps[k], q.speed_mps * rounding);
    EXPECT_LE(std::abs(m.turns_radps[k]), q.turn_radps * rounding);
    if (k == 0) continue;
    const double faster = m.speeds_mps[k] - m.speeds_mps[k - 1];
    EXPECT_LE(faster, q.accel_mps2 * m.step_s * rounding);
    EXPECT_GE(faster, -q.brake_mps2 * m.step_s * rounding);
    EXPECT_LE(std::abs(m.turns_radps[k] - m.turns_radps[k - 1]),
              q.turn_accel_radps2 * m.step_s * rounding);
    // a chord is no longer than the way, and lies between both headings
    const Vec2 moved = m.places_m[k] - m.places_m[k - 1];
    EXPECT_LE(norm(moved), m.step_s * (m.speeds_mps[k] + m.speeds_mps[k - 1]) / 2 * rounding);
    if (norm(moved) < 1e-9) continue;
    const double off = std::remainder(
        std::atan2(moved.y, moved.x) - (m.headings_rad[k] + m.headings_rad[k - 1]) / 2, 2 * pi);
    EXPECT_NEAR(off, 0, 1e-6);
  }
  EXPECT_NEAR(farthest, m.reach_m, 1e-12);
  EXPECT_EQ(m.speeds_mps.back(), 0);
}

// Straight at the wall nothing is better than to speed up: the closed form of a point.
TEST(WorstUnicycleTest, MeetsTheClosedFormStraightAhead) {
  for (const double speed : {0.0, 0.4, 1.0}) {
    const UnicycleProblem q = cart(speed, 0);
    const UnicycleMotion m = worst_motion(q);
    expect_admissible(q, m);
    EXPECT_EQ(m.status, SearchStatus::converged);
    const double bound = test::mitsch_bound_m(speed, q.accel_mps2, q.brake_mps2, q.horizon_s);
    EXPECT_LE(m.reach_m, bound + 1e-6);
    EXPECT_GE(m.reach_m, 0.97 * bound);
  }
}

// The cap: 1.5 m/s all the way, and the stop from there.
TEST(WorstUnicycleTest, KeepsTheCap) {
  const UnicycleProblem q = cart(1.5, 0);
  const UnicycleMotion m = worst_motion(q);
  expect_admissible(q, m);
  const double bound = 1.5 * q.horizon_s + 1.5 * 1.5 / (2 * q.brake_mps2);
  EXPECT_LE(m.reach_m, bound + 1e-6);
  EXPECT_GE(m.reach_m, 0.99 * bound);
}

// Errors are used up: farther on from the start, faster, and turned as far as it may be.
TEST(WorstUnicycleTest, UsesTheErrors) {
  UnicycleProblem q = cart(0.6, 0.5);
  const double exact = worst_motion(q).reach_m;
  q.position_error_m = 0.1;
  EXPECT_NEAR(worst_motion(q).reach_m, exact + 0.1, 1e-3);
  q.velocity_error_mps = 0.1;
  const UnicycleMotion faster = worst_motion(q);
  expect_admissible(q, faster);
  EXPECT_GT(faster.reach_m, exact + 0.1 + 0.05);
  // speed and heading share the error of the velocity: most of it goes into the heading here
  q.velocity = 0.6 * Vec2{std::cos(1.5), std::sin(1.5)};
  q.heading_rad = 1.5;
  const double ahead = worst_motion(q).reach_m;
  q.heading_error_rad = 0.15;
  const UnicycleMotion turned = worst_motion(q);
  expect_admissible(q, turned);
  EXPECT_GT(turned.reach_m, ahead + 0.02);
  EXPECT_LT(turned.headings_rad[0], q.heading_rad - 0.08);
}

// Past the wall: it pays to turn towards it, and no motion does better than straight at it.
TEST(WorstUnicycleTest, TurnsToTheWall) {
  for (const double angle : {-pi / 3, pi / 2, 1.8}) {
    UnicycleProblem q = cart(0.8, angle);
    const UnicycleMotion m = worst_motion(q);
    expect_admissible(q, m);
    q.turn_radps = 0.01;
    const UnicycleMotion straight = worst_motion(q);
    expect_admissible(q, straight);
    EXPECT_GT(m.reach_m, straight.reach_m + 0.05) << angle;
    q.turn_radps = 2;
    q.turn_accel_radps2 = 4;
    expect_admissible(q, worst_motion(q));
    EXPECT_LE(m.reach_m, test::mitsch_bound_m(0.8, 1, 1.2, 0.5)) << angle;
  }
}

// A turn that ends slowly goes on while the brake acts: that carries it farther.
TEST(WorstUnicycleTest, GoesOnTurningWhileItStops) {
  UnicycleProblem q = cart(0.8, pi / 2);
  const double sharp = worst_motion(q).reach_m;
  q.turn_accel_radps2 = 4;
  EXPECT_GT(worst_motion(q).reach_m, sharp + 0.02);
}

// Two searches that share how a motion is driven, and nothing else: none is far behind.
TEST(WorstUnicycleTest, BothSearchesFindAboutTheSame) {
  for (const double angle : {0.0, 0.7, 1.5}) {
    UnicycleProblem q = cart(0.5, angle);
    q.position_error_m = 0.02;
    q.velocity_error_mps = 0.05;
    q.heading_error_rad = 0.03;
    const UnicycleMotion searched = worst_motion(q), drawn = worst_motion_by_restarts(q, 200);
    expect_admissible(q, drawn);
    EXPECT_EQ(drawn.status, SearchStatus::stopped_early);
    EXPECT_LE(drawn.reach_m, searched.reach_m + 1e-3) << angle;
    EXPECT_GE(drawn.reach_m, 0.8 * searched.reach_m) << angle;
  }
}

TEST(WorstUnicycleTest, RefusesWhatIsNoProblem) {
  const auto status = [](auto change) {
    UnicycleProblem q = cart(0.5, 0);
    change(q);
    return worst_motion(q).status;
  };
  const auto invalid = SearchStatus::invalid_problem;
  EXPECT_EQ(status([](UnicycleProblem& q) { q.accel_mps2 = 0; }), invalid);
  EXPECT_EQ(status([](UnicycleProblem& q) { q.turn_radps = 0; }), invalid);
  EXPECT_EQ(status([](UnicycleProblem& q) { q.normal = {1, 1}; }), invalid);
  EXPECT_EQ(status([](UnicycleProblem& q) { q.horizon_s = std::nan(""); }), invalid);
  // it does not drive where it points, by more than any error
  EXPECT_EQ(status([](UnicycleProblem& q) { q.heading_rad = 1; }), invalid);
  EXPECT_EQ(worst_motion_by_restarts(UnicycleProblem{}, 10).status, invalid);
}

}  // namespace
}  // namespace rtac
