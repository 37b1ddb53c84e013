// The look-ahead under commands is sound: whatever pushes the robot, whenever within the latency a
// command begins to act, and whenever the recovery takes over, the true centre stays near the
// course that the kernel says. And it is tighter than any control. Source: theory, look-ahead under
// the commanded input.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/kernel/plants.h"

namespace rtac::kernel_test {
namespace {

constexpr double rounding_mm = 0.05;  // of the simulation
constexpr double step_s = 0.0005;

struct Sent {
  std::int64_t time_us;     // of the step
  std::int64_t act_us;      // when it begins to act
  Real acceleration_mmps2;  // on the grid
};

// One flight of a robot that is told what to do every period, from rest at any speed.
class Flight {
 public:
  Flight(Random& random, const probe_robot& robot, std::int64_t error_mmps2,
         std::int64_t latency_us, std::int64_t period_us)
      : random_(random),
        robot_(robot),
        error_(static_cast<double>(error_mmps2)),
        latency_us_(latency_us),
        period_us_(period_us),
        cap_(static_cast<double>(robot.body.speed_mmps)),
        brake_(static_cast<double>(robot.body.brake_mmps2)) {
    p_ = somewhere(random, 1000);
    const double speed = random.one_in(3) ? cap_ : random.real(0, cap_);
    v_ = speed * heading(random.real(-3.2, 3.2));
    style_ = static_cast<int>(random.in(0, 3));
  }

  // Returns how much of the allowed room was used at most, legs and stops.
  void fly(double& legs, double& stops);

 private:
  Real next_command() {
    const auto most = static_cast<double>(robot_.motion.accel_mmps2);
    if (style_ == 0) return most * heading(random_.real(-3.2, 3.2));        // bang-bang
    if (style_ == 1) return most * heading(std::atan2(v_.y, v_.x));         // faster
    if (style_ == 2) return most * heading(std::atan2(v_.y, v_.x) + 1.57);  // turns
    return random_.real(0, 1) * most * heading(random_.real(-3.2, 3.2));
  }
  static Real on_grid(Real a) { return {std::floor(0.999 * a.x), std::floor(0.999 * a.y)}; }
  void send(std::int64_t time_us) {
    const std::int64_t delay_us =
        random_.one_in(3) ? latency_us_ : (random_.one_in(2) ? 0 : random_.in(0, latency_us_));
    const std::int64_t after_us = sent_.empty() ? 0 : sent_.back().act_us;
    sent_.push_back({time_us, std::max(after_us, time_us + delay_us), on_grid(next_command())});
  }
  [[nodiscard]] Real acting(std::int64_t t_us) const {
    Real a = sent_.front().acceleration_mmps2;
    for (const Sent& s : sent_) {
      if (s.act_us <= t_us) a = s.acceleration_mmps2;
    }
    return a;
  }
  // What nobody commands: across or along the way, and what the robot does not follow.
  Real push() {
    if (t_us_ >= gust_until_us_) {
      gust_until_us_ = t_us_ + random_.in(5'000, 400'000);
      gust_ = random_.one_in(3) ? 0 : random_.real(-3.2, 3.2);
    }
    return error_ * heading(std::atan2(v_.y, v_.x) + gust_);
  }
  // The speed saturates: a projection.
  void advance() {
    const Real a = acting(t_us_) + push();
    const Real before = v_;
    v_ = v_ + step_s * a;
    if (const double speed = norm(v_); speed > cap_) v_ = (cap_ / speed) * v_;
    p_ = p_ + (0.5 * step_s) * (before + v_);
    t_us_ += static_cast<std::int64_t>(1e6 * step_s);
  }
  void stop() {
    const double speed = norm(v_);
    const Real before = v_;
    v_ = speed <= brake_ * step_s ? Real{} : (1 - brake_ * step_s / speed) * v_;
    p_ = p_ + (0.5 * step_s) * (before + v_);
  }

  Random& random_;
  probe_robot robot_;
  double error_;
  std::int64_t latency_us_, period_us_;
  double cap_, brake_;
  Real p_, v_;
  std::int64_t t_us_ = 0, gust_until_us_ = 0;
  double gust_ = 0;
  int style_ = 0;
  std::vector<Sent> sent_;
};

double off_legs(Real p, const probe_course& c) {
  double least = norm(p - real(c.at[0]));
  for (int i = 1; i < c.count; ++i) {
    least = std::min(least, distance(p, real(c.at[i - 1]), real(c.at[i])));
  }
  return least;
}
double off_stops(Real p, const probe_course& c) {
  double least = 1e9;
  for (int i = c.first; i < c.count; ++i) {
    least = std::min(least, distance(p, real(c.at[i]), real(c.stop[i])));
    if (i > c.first) least = std::min(least, distance(p, real(c.stop[i - 1]), real(c.stop[i])));
  }
  return least;
}

void Flight::fly(double& legs, double& stops) {
  const std::int64_t end_us = period_us_ * random_.in(4, 8);
  const auto age = [&](std::int64_t most) {
    return random_.one_in(2) ? most : random_.in(0, most);
  };
  const std::int64_t p_us = end_us - age(robot_.body.position_age_us) / 500 * 500;
  const std::int64_t v_us = end_us - age(robot_.body.velocity_age_us) / 500 * 500;
  std::vector<Real> path;
  for (std::int64_t step_us = 0; t_us_ < end_us;) {
    if (t_us_ >= step_us) {
      send(step_us);
      step_us += period_us_;
    }
    if (t_us_ == p_us) {
      robot_.position =
          measured(p_ + noise(random_, static_cast<double>(robot_.body.position_error_mm)), p_us);
    }
    if (t_us_ == v_us) {
      robot_.velocity =
          measured(v_ + noise(random_, static_cast<double>(robot_.body.velocity_error_mmps)), v_us);
    }
    if (t_us_ >= p_us) path.push_back(p_);
    advance();
  }
  if (p_us == end_us) {
    robot_.position =
        measured(p_ + noise(random_, static_cast<double>(robot_.body.position_error_mm)), p_us);
  }
  if (v_us == end_us) {
    robot_.velocity =
        measured(v_ + noise(random_, static_cast<double>(robot_.body.velocity_error_mmps)), v_us);
  }
  // the decision: what was sent, the newest first, and what is proposed now
  std::array<probe_command, PROBE_COMMANDS> kept{};
  for (std::size_t i = 0; i < kept.size() && i < sent_.size(); ++i) {
    const Sent& s = sent_[sent_.size() - 1 - i];
    kept[i] = {s.time_us, static_cast<std::int64_t>(s.acceleration_mmps2.x),
               static_cast<std::int64_t>(s.acceleration_mmps2.y), 1};
  }
  send(end_us);
  probe_point proposed = measured(sent_.back().acceleration_mmps2, end_us);
  const std::int64_t horizon_us = period_us_ + latency_us_ + 500 * random_.in(0, 40);
  const probe_course c = probe_course_of(&robot_, kept.data(), &proposed, end_us, horizon_us,
                                         static_cast<std::int64_t>(error_) + 2, latency_us_);
  ASSERT_EQ(c.usable, 1);
  const std::int64_t takeover_us =
      end_us + (random_.one_in(2) ? horizon_us : random_.in(0, horizon_us));
  path.push_back(p_);
  while (t_us_ < takeover_us) {
    advance();
    path.push_back(p_);
  }
  const auto room = static_cast<double>(c.leg_mm - robot_.body.radius_mm);
  for (const Real& p : path) {
    const double off = off_legs(p, c);
    ASSERT_LE(off, room + rounding_mm);
    legs = std::max(legs, off / room);
  }
  const auto stop_room = static_cast<double>(c.stop_mm - robot_.body.radius_mm);
  for (int left = 20'000; left > 0 && norm(v_) > 0; --left) {
    stop();
    const double off = off_stops(p_, c);
    ASSERT_LE(off, stop_room + rounding_mm);
    stops = std::max(stops, off / stop_room);
  }
}

// The brake is ideal, so that its tube hides nothing.
probe_robot swift() {
  probe_robot robot = probe_swift();
  robot.body.brake_lag_ms = robot.body.brake_lag_permille = 0;
  robot.body.hold_mm = robot.body.sway_permille = 0;
  robot.motion.accel_mmps2 = 1'500;
  return robot;
}

TEST(Course, HoldsARobotThatIsToldWhatToDo) {
  Random random(31);
  double legs = 0, stops = 0;
  for (int i = 0; i < 2'000 && !HasFatalFailure(); ++i) {
    Flight(random, swift(), 150, 20'000, 50'000).fly(legs, stops);
  }
  RecordProperty("legs", std::to_string(legs));
  RecordProperty("stops", std::to_string(stops));
  EXPECT_GT(legs, 0.75);
  EXPECT_GT(stops, 0.82);
}

TEST(Course, HoldsRobotsOfEverySort) {
  // Bounds of every size, so that no term hides behind another.
  Random random(32);
  double legs = 0, stops = 0;
  for (int i = 0; i < 5'000 && !HasFatalFailure(); ++i) {
    probe_robot robot = swift();
    robot.body.position_error_mm = random.one_in(2) ? 0 : random.in(0, 30);
    robot.body.velocity_error_mmps = random.one_in(2) ? 0 : random.in(0, 50);
    robot.body.brake_mmps2 = random.in(500, 4'000);
    robot.motion.accel_mmps2 = random.in(100, 4'000);
    const std::int64_t error = random.one_in(2) ? 0 : random.in(0, 300);
    robot.body.accel_mmps2 = std::max(robot.motion.accel_mmps2, robot.body.brake_mmps2) + error;
    robot.body.speed_mmps = robot.motion.speed_mmps = random.in(200, 3'000);
    robot.body.position_age_us = random.one_in(2) ? 0 : 500 * random.in(0, 100);
    robot.body.velocity_age_us = random.one_in(2) ? 0 : 500 * random.in(0, 100);
    const std::int64_t latency_us = random.one_in(3) ? 0 : 500 * random.in(0, 80);
    Flight(random, robot, error, latency_us, 50'000).fly(legs, stops);
  }
  RecordProperty("legs", std::to_string(legs));
  RecordProperty("stops", std::to_string(stops));
  EXPECT_GT(legs, 0.75);
  EXPECT_GT(stops, 0.85);
}

TEST(Course, IsMuchTighterThanAnyControl) {
  // told to go on as it does, at full speed and at half of it
  for (const std::int64_t speed : {750, 1'500}) {
    probe_robot robot = probe_swift();
    robot.position = measured({0, 0}, 1'000'000);
    robot.velocity = measured({static_cast<double>(speed), 0}, 1'000'000);
    std::array<probe_command, PROBE_COMMANDS> kept{};
    for (std::size_t i = 0; i < kept.size(); ++i) {
      kept[i] = {950'000 - 50'000 * static_cast<std::int64_t>(i), 0, 0, 1};
    }
    const probe_point proposed = measured({0, 0}, 1'000'000);
    const probe_course c =
        probe_course_of(&robot, kept.data(), &proposed, 1'000'000, 75'000, 150, 20'000);
    const probe_reach any = probe_reach_of(&robot, 1'000'000, 75'000);
    ASSERT_EQ(c.usable, 1);
    EXPECT_LT(c.stop_mm, any.capsule_mm - 100) << speed;
  }
}

TEST(Course, WhatIsNotKnownIsNotUsed) {
  probe_robot robot = probe_swift();
  robot.position = measured({0, 0}, 1'000'000);
  robot.velocity = measured({0, 0}, 1'000'000);
  std::array<probe_command, PROBE_COMMANDS> kept{};
  for (std::size_t i = 0; i < kept.size(); ++i) {
    kept[i] = {950'000 - 50'000 * static_cast<std::int64_t>(i), 0, 0, 1};
  }
  const auto usable = [&](const probe_point& proposed) {
    return probe_course_of(&robot, kept.data(), &proposed, 1'000'000, 75'000, 150, 20'000).usable;
  };
  const probe_point rest = measured({0, 0}, 1'000'000);
  EXPECT_EQ(usable(rest), 1);
  probe_point missing = rest;
  missing.valid = 0;
  EXPECT_EQ(usable(missing), 0);
  EXPECT_EQ(usable(measured({static_cast<double>(robot.motion.accel_mmps2) + 10, 0}, 1'000'000)),
            0);
  kept[0].known = 0;
  EXPECT_EQ(usable(rest), 0);
  kept[0].known = 1;
  kept[1].known = 0;  // surely over when the sample was taken
  EXPECT_EQ(usable(rest), 1);
  kept[0].time_us = 990'000;  // may not act yet
  EXPECT_EQ(usable(rest), 0);
}

}  // namespace
}  // namespace rtac::kernel_test
