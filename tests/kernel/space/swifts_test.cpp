// Commands in space: who passes the look-ahead under its command stays in the hall, whenever within
// the latency that command begins to act, whatever pushes the robot and whenever the recovery takes
// over; and many pass that any control would fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "swifts.h"
#include "swifts_probe.h"

namespace swifts {
namespace {

using rtac::TimeUs;
using rtac::Vec3;
using rtac::Verdict;

constexpr double dt_s = 0.001, radius_m = 0.1, speed_mps = 3, accel_mps2 = 4, brake_mps2 = 2;
constexpr double error_mps2 = 0.1, p_error_m = 0.02, v_error_mps = 0.02;
constexpr TimeUs step_us = 1'000, period_us = 50'000, latency_us = 20'000, age_us_max = 50'000;

// Distance to the boundary of the hall, negative outside: it is one outline, extruded along y.
double clearance_m(Vec3 p) {
  static const std::array<std::array<double, 2>, 6> corners = {
      {{0, 0}, {20, 0}, {20, 8}, {12, 8}, {12, 16}, {0, 16}}};
  double nearest = std::min(p.y, 20 - p.y);
  const bool inside = p.x >= 0 && p.z >= 0 && p.z <= 16 && (p.z <= 8 ? p.x <= 20 : p.x <= 12);
  if (!inside) return -1;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b[0] - a[0], dz = b[1] - a[1];
    const double t =
        std::clamp(((p.x - a[0]) * dx + (p.z - a[1]) * dz) / (dx * dx + dz * dz), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(p.x - a[0] - t * dx, p.z - a[1] - t * dz));
  }
  return nearest;
}

struct Plant {
  Vec3 p, v;
  void advance(Vec3 a) {
    const Vec3 before = v;
    v = v + dt_s * a;
    if (norm(v) > speed_mps) v = (speed_mps / norm(v)) * v;  // a projection
    p = p + (0.5 * dt_s) * (before + v);
  }
  void brake() {
    const double speed = norm(v);
    const Vec3 before = v;
    v = speed <= brake_mps2 * dt_s ? Vec3{} : (1 - brake_mps2 * dt_s / speed) * v;
    p = p + (0.5 * dt_s) * (before + v);
  }
};
struct Sent {
  TimeUs act_us;
  Vec3 mps2;
};

class Flight {
 public:
  explicit Flight(std::mt19937_64& random) : random_(random) {
    do {
      plant_.p = {real(2, 18), real(2, 18), real(2, 14)};
    } while (clearance_m(plant_.p) < 2);
    past_.assign(1 + age_us_max / step_us, plant_);
    sent_ = {{0, {}}};
    aim_ = way();
  }
  int passed = 0, passed_alone = 0;

  // Until the look-ahead fails, or for four seconds.
  void fly() {
    rtac::Observation seen;
    seen.robots = 1;
    for (now_us_ = 10'000'000; now_us_ < 14'000'000;) {
      const Vec3 next = command();
      observe(seen, next);
      const rtac::DecisionRecord& found = decision_.step(seen, false, false);
      const bool any = any_.step(seen, false, false).monitors[0].ahead == Verdict::is_true;
      if (found.mode != 0 || found.monitors[0].ahead != Verdict::is_true) return;
      if (found.previous_mode == 0) {
        ++passed;
        passed_alone += any ? 0 : 1;
        ASSERT_NO_FATAL_FAILURE(take_over(next));
      }
      send(next);
      seen.sent = {{next.x, next.y}, now_us_};
      seen.sent_up_mps2 = next.z;
      for (TimeUs until = now_us_ + period_us; now_us_ < until;) advance(plant_, sent_, true);
    }
  }

 private:
  double real(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random_);
  }
  Vec3 way() {
    for (;;) {
      const Vec3 v{real(-1, 1), real(-1, 1), real(-1, 1)};
      if (norm(v) > 0.1 && norm(v) < 1) return (1 / norm(v)) * v;
    }
  }
  // On the grid, and within what is followed.
  static Vec3 on_grid(Vec3 a) {
    const auto cut = [](double x) { return std::floor(999 * x) / 1000; };
    return {cut(a.x), cut(a.y), cut(a.z)};
  }
  // Straight on at full effort, and back when a wall is near; or anything.
  Vec3 command() {
    if (real(0, 1) < 0.05) aim_ = way();
    if (real(0, 1) < 0.1) return on_grid(accel_mps2 * way());
    const bool near = clearance_m(plant_.p + (norm(plant_.v) / (2 * brake_mps2) + 0.1) * plant_.v) <
                      radius_m + turns_at_m_;
    if (near && norm(plant_.v) > 0) return on_grid((-accel_mps2 / norm(plant_.v)) * plant_.v);
    return on_grid(accel_mps2 * aim_);
  }
  TimeUs some(TimeUs most) {
    return real(0, 1) < 0.4 ? most : TimeUs(real(0, double(most))) / step_us * step_us;
  }
  void observe(rtac::Observation& seen, Vec3 next) {
    seen.now_us = now_us_;
    const auto before = [&](TimeUs age) {
      return past_[past_.size() - 1 - static_cast<std::size_t>(age / step_us)];
    };
    // stamps do not go backwards
    const TimeUs p_age = some(age_us_max), v_age = some(age_us_max);
    const Vec3 p = before(p_age).p + p_error_m * way();
    const Vec3 v = before(v_age).v + v_error_mps * way();
    seen.position = {{p.x, p.y}, now_us_ - p_age};
    seen.velocity = {{v.x, v.y}, now_us_ - v_age};
    seen.height_m = p.z;
    seen.climb_mps = v.z;
    seen.proposed = {{next.x, next.y}, now_us_};
    seen.proposed_up_mps2 = next.z;
  }
  void send(Vec3 next) {
    sent_.push_back({std::max(sent_.back().act_us, now_us_ + some(latency_us)), next});
  }
  static Vec3 acting(const std::vector<Sent>& sent, TimeUs at_us) {
    Vec3 a{};
    for (const Sent& s : sent) {
      if (s.act_us <= at_us) a = s.mps2;
    }
    return a;
  }
  void advance(Plant& plant, const std::vector<Sent>& sent, bool really) {
    if (real(0, 1) < 0.02) push_ = error_mps2 * way();
    plant.advance(acting(sent, now_us_) + push_);
    now_us_ += step_us;
    if (!really) return;
    past_.erase(past_.begin());
    past_.push_back(plant);
  }
  // What would follow if the recovery acted at some time until the horizon is over.
  void take_over(Vec3 next) {
    Plant plant = plant_;
    std::vector<Sent> sent = sent_;
    const TimeUs begin_us = now_us_;
    sent.push_back({std::max(sent.back().act_us, now_us_ + some(latency_us)), next});
    const TimeUs until_us = now_us_ + some(period_us + latency_us);
    double least_m = clearance_m(plant.p);
    while (now_us_ < until_us) {
      advance(plant, sent, false);
      least_m = std::min(least_m, clearance_m(plant.p));
    }
    now_us_ = begin_us;
    while (norm(plant.v) > 0) {
      plant.brake();
      least_m = std::min(least_m, clearance_m(plant.p));
    }
    ASSERT_GE(least_m, radius_m - 1e-3);
  }

  std::mt19937_64& random_;
  Fly decision_{0};
  Hoist any_{0};
  Plant plant_;
  std::vector<Plant> past_;  // by step, until now
  std::vector<Sent> sent_;
  Vec3 aim_, push_;
  double turns_at_m_ = std::uniform_real_distribution<double>(0, 0.5)(random_);
  TimeUs now_us_ = 0;
};

TEST(SpaceCommands, WhatPassesStaysInside) {
  std::mt19937_64 random(5);
  int passed = 0, alone = 0;
  for (int n = 0; n < 400 && !::testing::Test::HasFatalFailure(); ++n) {
    Flight flight(random);
    flight.fly();
    passed += flight.passed;
    alone += flight.passed_alone;
  }
  EXPECT_GT(passed, 4'000);
  EXPECT_GT(alone, 400);
}

// How high it may be, on the way up at 2 m/s, with that command.
double highest_m(Vec3 proposed) {
  double passes_m = 9, fails_m = 16;
  for (int n = 0; n < 14; ++n) {
    const double height_m = (passes_m + fails_m) / 2;
    Fly decision(0);
    rtac::Observation seen;
    seen.robots = 1;
    Verdict found = Verdict::is_unknown;
    for (int k = 0; k < 20; ++k) {
      const bool last = k == 19;
      seen.now_us = 10'000'000 + k * period_us;
      seen.position = {{6, 10}, seen.now_us};
      seen.velocity = {{0, 0}, seen.now_us};
      seen.height_m = last ? height_m : 8;
      seen.climb_mps = last ? 2 : 0;
      seen.sent = {{0, 0}, seen.now_us - period_us};
      seen.proposed = {{last ? proposed.x : 0, last ? proposed.y : 0}, seen.now_us};
      seen.proposed_up_mps2 = last ? proposed.z : 0;
      found = decision.step(seen, false, false).monitors[0].ahead;
    }
    (found == Verdict::is_true ? passes_m : fails_m) = height_m;
  }
  return passes_m;
}

// A command that is missing an axis, or is too large by one, is no command: any control is left.
TEST(SpaceCommands, AreKnownInAllAxesOrNotAtAll) {
  const double any_m = highest_m({0, 0, std::nan("")});
  EXPECT_GT(any_m, 12);
  EXPECT_GT(highest_m({0, 0, -4}), any_m + 0.05);
  EXPECT_GT(highest_m({0, 0, -4}), highest_m({0, 0, 0}) + 0.01);
  EXPECT_GT(highest_m({0, 0, -4}), highest_m({-4, 0, 0}) + 0.01);
  EXPECT_EQ(highest_m({0, 0, -4.1}), any_m);
  EXPECT_EQ(highest_m({2.9, 0, -2.9}), any_m);
  EXPECT_GE(highest_m({0, 0, 4}), any_m);
}

// The axes are alike: the same flight along others has the same course.
TEST(SpaceCommands, CoursesAreAlikeAlongAllAxes) {
  std::mt19937_64 random(6);
  const auto whole = [&](std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(-most, most)(random);
  };
  int saturated = 0;
  for (int n = 0; n < 2'000; ++n) {
    std::array<std::int64_t, 3> v{}, sent{}, proposed{};
    for (auto* const u : {&sent, &proposed}) *u = {whole(2'300), whole(2'300), whole(2'300)};
    v = {whole(1'732), whole(1'732), whole(1'732)};
    // at the cap, and on
    if (n % 3 == 0) {
      v = {v[0] < 0 ? -2'440 : 2'440, 0, v[2] < 0 ? -1'730 : 1'730};
      if (n % 2 == 0) v = {v[0] < 0 ? -2'995 : 2'995, 0, 0};
      sent = proposed = v;
    } else if (n % 2 == 0) {
      v[1] = sent[1] = proposed[1] = 0;
    }
    const probe_way one = probe_way_of(v.data(), sent.data(), proposed.data());
    for (auto* const u : {&v, &sent, &proposed}) std::rotate(u->begin(), u->begin() + 1, u->end());
    const probe_way other = probe_way_of(v.data(), sent.data(), proposed.data());
    ASSERT_EQ(one.usable, 1);
    ASSERT_EQ(other.usable, 1);
    ASSERT_EQ(one.count, other.count);
    ASSERT_EQ(one.leg_mm, other.leg_mm) << n;
    ASSERT_EQ(one.stop_mm, other.stop_mm) << n;
    for (std::size_t i = 0; i < std::size_t(one.count); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_EQ(one.at[i][(k + 1) % 3], other.at[i][k]) << n;
        ASSERT_EQ(one.stop[i][(k + 1) % 3], other.stop[i][k]) << n;
      }
    }
    saturated += std::hypot(double(v[0]), double(v[1]), double(v[2])) > 2'990 ? 1 : 0;
  }
  EXPECT_GT(saturated, 100);
}

}  // namespace
}  // namespace swifts
