// The look-ahead is sound: whatever the controller does within the bounds until the recovery acts,
// and while it brakes, the true centre stays within capsule and disc. And it is tight: the worst
// that an adversary reaches is close to the bound. Source: theory, look-ahead against any control.
#include <gtest/gtest.h>

#include <algorithm>

#include "rtac/safe/pilot.h"
#include "tests/kernel/plants.h"

namespace rtac::kernel_test {
namespace {

constexpr double rounding_mm = 0.01;  // of the simulation

struct Tightness {
  double disc = 0, capsule = 0;
};

// Distance from the tubes, as a share of what the tubes allow.
void watch(Real p, const probe_reach& r, const probe_body& b, Tightness& worst) {
  const double off_disc = norm(p - real(r.p)), off_axis = distance(p, real(r.p), real(r.e));
  const auto capsule = static_cast<double>(r.capsule_mm - b.radius_mm);
  const auto disc = static_cast<double>(r.centre_mm);
  ASSERT_LE(off_disc, disc + rounding_mm);
  ASSERT_LE(off_axis, capsule + rounding_mm);
  worst.disc = std::max(worst.disc, off_disc / disc);
  worst.capsule = std::max(worst.capsule, off_axis / capsule);
}

// Runs until both samples are taken, gets the tubes from the kernel, then watches until rest.
template <class Plant>
void chase(Random& random, probe_robot robot, Plant plant, const Timing& timing, Tightness& worst) {
  Whim whim(random);
  if (whim.bold() && random.one_in(2)) {
    whim.settle(1, std::atan2(plant.velocity().y, plant.velocity().x));
  }
  bool seen_p = false, seen_v = false;
  std::vector<Real> path;
  const auto sample = [&](double t_s) {
    const auto t_us = static_cast<std::int64_t>(std::llround(1e6 * t_s));
    if (!seen_p && t_us >= timing.position_us) {
      robot.position = measured(
          plant.p + noise(random, static_cast<double>(robot.body.position_error_mm)), t_us);
      seen_p = true;
    }
    if (!seen_v && t_us >= timing.velocity_us) {
      robot.velocity = measured(
          plant.velocity() + noise(random, static_cast<double>(robot.body.velocity_error_mmps)),
          t_us);
      seen_v = true;
    }
    if (seen_p) path.push_back(plant.p);
  };
  int step = 0;
  for (; step * dt_s < timing.end_s() - dt_s / 2; ++step) {
    sample(step * dt_s);
    plant.free(whim, step * dt_s);
  }
  sample(step * dt_s);
  for (int left = 5'000; left > 0 && !plant.rests(); --left) {
    plant.stop();
    path.push_back(plant.p);
  }
  const std::int64_t now_us =
      std::max({timing.now_us, robot.position.stamp_us, robot.velocity.stamp_us});
  const probe_reach r = probe_reach_of(&robot, now_us, timing.horizon_us);
  ASSERT_EQ(r.input, 0);
  for (const Real& p : path) watch(p, r, robot.body, worst);
}

PointPlant point_plant(Random& random, const probe_robot& robot) {
  PointPlant plant{somewhere(random, 1000),
                   {},
                   static_cast<double>(robot.motion.accel_mmps2),
                   static_cast<double>(robot.body.brake_mmps2),
                   static_cast<double>(robot.motion.speed_mmps)};
  plant.v = random.real(0, 1) * plant.cap * heading(random.real(-3.2, 3.2));
  return plant;
}
CartPlant cart_plant(Random& random, const probe_robot& robot) {
  // speed, turn and turn acceleration of `Cart` in probe.rta
  CartPlant plant{somewhere(random, 1000),
                  random.real(-3.2, 3.2),
                  0,
                  0,
                  1'000,
                  static_cast<double>(robot.body.brake_mmps2),
                  static_cast<double>(robot.motion.speed_mmps),
                  2,
                  20};
  plant.speed = random.real(-1, 1) * plant.cap;
  return plant;
}

TEST(Reach, HoldsAPointMassWithIdealBrake) {
  Random random(21);
  Tightness worst;
  for (int i = 0; i < 20'000 && !HasFatalFailure(); ++i) {
    const probe_robot robot = probe_drone();
    const Timing timing = random_timing(random, robot.body, 120'000);
    chase(random, robot, point_plant(random, robot), timing, worst);
  }
  RecordProperty("disc_share", std::to_string(worst.disc));
  RecordProperty("capsule_share", std::to_string(worst.capsule));
  // the ideal brake leaves the tube for the sampled one, sample age included, unused
  EXPECT_GT(worst.disc, 0.75);
}

TEST(Reach, HoldsRandomPointMasses) {
  // Bounds of every size, so that no term of the formulas hides behind another.
  Random random(22);
  Tightness worst;
  for (int i = 0; i < 20'000 && !HasFatalFailure(); ++i) {
    probe_robot robot = probe_drone();
    robot.body.position_error_mm = random.in(0, 50);
    robot.body.velocity_error_mmps = random.in(0, 200);
    robot.body.accel_mmps2 = robot.motion.accel_mmps2 = random.in(100, 5'000);
    robot.body.brake_mmps2 = random.in(300, 3'000);
    robot.body.brake_lag_ms = robot.body.brake_lag_permille = robot.body.hold_mm = 0;
    robot.body.position_age_us = random.in(0, 400'000);
    robot.body.velocity_age_us = random.in(0, 400'000);
    robot.body.speed_mmps = robot.motion.speed_mmps = random.in(50, 3'000);
    const Timing timing = random_timing(random, robot.body, 2'000 * random.in(0, 300));
    chase(random, robot, point_plant(random, robot), timing, worst);
  }
  RecordProperty("disc_share", std::to_string(worst.disc));
  RecordProperty("capsule_share", std::to_string(worst.capsule));
  // with an ideal brake nothing is left over: theory says 1.00
  EXPECT_GT(worst.disc, 0.98);
  EXPECT_GT(worst.capsule, 0.9);
}

TEST(Reach, HoldsPointMassesThatArePushed) {
  // theory, the brake: pushed with d, it stops within d v^2 / (2 b (b - d)) of the path of a free
  // one.
  Random random(27);
  Tightness worst;
  for (int i = 0; i < 20'000 && !HasFatalFailure(); ++i) {
    probe_robot robot = probe_leaf();
    const std::int64_t brake = random.in(300, 3'000), push = random.in(0, 3 * brake / 4);
    robot.body.position_error_mm = random.in(0, 50);
    robot.body.velocity_error_mmps = random.in(0, 100);
    robot.body.accel_mmps2 = robot.motion.accel_mmps2 = random.in(100, 2'000) + push;
    robot.body.brake_mmps2 = brake;
    robot.body.sway_permille = (1'000 * push + brake - push - 1) / (brake - push);
    robot.body.brake_lag_ms = robot.body.hold_mm = 0;
    robot.body.speed_mmps = robot.motion.speed_mmps = random.in(50, 3'000);
    const Timing timing = random_timing(random, robot.body, 2'000 * random.in(0, 150));
    PushedPlant plant{point_plant(random, robot), static_cast<double>(push)};
    chase(random, robot, plant, timing, worst);
  }
  RecordProperty("disc_share", std::to_string(worst.disc));
  RecordProperty("capsule_share", std::to_string(worst.capsule));
  EXPECT_GT(worst.disc, 0.95);
}

TEST(Reach, HoldsAUnicycleThatTurnsReversesAndStopsWithALag) {
  Random random(23);
  Tightness worst;
  for (int i = 0; i < 20'000 && !HasFatalFailure(); ++i) {
    const probe_robot robot = probe_cart();
    const Timing timing = random_timing(random, robot.body, 250'000);
    chase(random, robot, cart_plant(random, robot), timing, worst);
  }
  RecordProperty("disc_share", std::to_string(worst.disc));
  RecordProperty("capsule_share", std::to_string(worst.capsule));
  EXPECT_GT(worst.disc, 0.7);
}

TEST(Reach, HoldsARecoveryThatStartsFasterThanItMayDrive) {
  // A recovery never speeds up beyond its limit, and never beyond the speed that it found.
  Random random(24);
  Tightness worst;
  for (int i = 0; i < 10'000 && !HasFatalFailure(); ++i) {
    probe_robot robot = probe_drone();
    robot.motion.recovery = 1;
    robot.motion.speed_mmps = random.in(0, 600);
    PointPlant plant = point_plant(random, robot);
    plant.v = random.real(0, 1'500) * heading(random.real(-3.2, 3.2));
    plant.cap = std::max(static_cast<double>(robot.motion.speed_mmps), norm(plant.v));
    Timing timing = random_timing(random, robot.body, 120'000);
    timing.velocity_us = timing.position_us = 0;  // the speed that was measured is the one found
    timing.now_us = std::min(timing.now_us, robot.body.position_age_us);
    chase(random, robot, plant, timing, worst);
  }
}

// The pilot of the safe controllers, on samples of some age, with latency, pushed about.
class SampledBrake {
 public:
  SampledBrake(Random& random, const probe_robot& robot, double push_mmps2 = 0)
      : random_(random), body_(robot.body), push_(push_mmps2) {
    limits_.speed_mps = 1e-3 * static_cast<double>(robot.motion.speed_mmps);
    limits_.accel_mps2 = 1e-3 * static_cast<double>(robot.motion.accel_mmps2);
    limits_.brake_mps2 = 1e-3 * static_cast<double>(robot.body.brake_mmps2);
    limits_.position_error_m = 1e-3 * static_cast<double>(robot.body.position_error_mm);
    limits_.velocity_error_mps = 1e-3 * static_cast<double>(robot.body.velocity_error_mmps);
    limits_.position_age_us = robot.body.position_age_us;
    limits_.velocity_age_us = robot.body.velocity_age_us;
    limits_.latency_us = latency_us;
    limits_.disturbance_mps2 = 1e-3 * push_mmps2;
  }
  // From the tick at which the recovery takes over; until then the last command of the adversary
  // acts. Returns the path.
  std::vector<Real> run(PointPlant plant, double seconds, bool delayed);

  static constexpr std::int64_t period_us = 50'000, latency_us = 20'000;

 private:
  // Steady, turning with the motion, or against what brings it back to where it was.
  Real wind(double t_s, Real away) {
    if (t_s >= until_s_) {
      style_ = static_cast<int>(random_.in(0, 2));
      angle_ = random_.real(-3.2, 3.2);
      until_s_ = t_s + random_.real(0.5, 5);
    }
    if (style_ == 0 || norm(away) == 0) return push_ * heading(angle_);
    return push_ * heading(std::atan2(away.y, away.x) + (style_ == 1 ? 0.0 : 1.6));
  }

  Random& random_;
  probe_body body_;
  double push_;
  RobotLimits limits_;
  int style_ = 0;
  double angle_ = 0, until_s_ = -1;
};

std::vector<Real> SampledBrake::run(PointPlant plant, double seconds, bool delayed) {
  safe::Setting setting;
  setting.limits = limits_;
  setting.period_us = period_us;
  setting.speed_mps = 0.3;
  safe::Pilot<Acceleration> pilot(setting);
  std::vector<Real> path;
  std::vector<PointPlant> history{plant};
  Observation seen;
  Real acting = plant.accel * heading(random_.real(-3.2, 3.2)), coming;
  constexpr int period = period_us / 2'000, latency = latency_us / 2'000;
  for (int step = 0; step * dt_s < seconds; ++step) {
    if (step % period == 0) {
      const int age = delayed ? static_cast<int>(random_.in(0, body_.position_age_us / 2'000)) : 0;
      const int then = std::max(0, step - age);
      const PointPlant& was = history[static_cast<std::size_t>(then)];
      const Real p = was.p + noise(random_, static_cast<double>(body_.position_error_mm));
      const Real v = was.v + noise(random_, static_cast<double>(body_.velocity_error_mmps));
      seen.now_us = step * 2'000;
      seen.position = {{1e-3 * p.x, 1e-3 * p.y}, then * 2'000};
      seen.velocity = {{1e-3 * v.x, 1e-3 * v.y}, then * 2'000};
      if (step == 0) pilot.engage(seen);
      const Acceleration a = pilot.halt(seen);
      coming = {1e3 * a.value_mps2.x, 1e3 * a.value_mps2.y};
    }
    if (step % period == latency) acting = coming;
    plant.move(acting + wind(step * dt_s, plant.v));
    history.push_back(plant);
    path.push_back(plant.p);
  }
  return path;
}

void sampled(std::uint64_t seed, const probe_robot& robot, double push_mmps2, bool delayed,
             Tightness& worst) {
  Random random(seed);
  const int runs = push_mmps2 > 0 ? 500 : 2'000;  // the pushed ones last longer
  for (int i = 0; i < runs && !::testing::Test::HasFatalFailure(); ++i) {
    SampledBrake brake(random, robot, push_mmps2);
    PointPlant plant = point_plant(random, robot);
    probe_robot seen = robot;
    seen.position = measured(plant.p, 0);
    seen.velocity = measured(plant.v, 0);
    // the decision has just been made: what remains is the latency, the brake and its hold
    const probe_reach r = probe_reach_of(&seen, 0, SampledBrake::latency_us);
    for (const Real& p : brake.run(plant, push_mmps2 > 0 ? 12 : 6, delayed))
      watch(p, r, robot.body, worst);
  }
}

TEST(Reach, HoldsTheSampledBrakeAndItsPositionHold) {
  // theory, sampled brake: rho_sc = eta s / b + eta^2 / b + rho_h around the ideal stopping path.
  Tightness worst;
  sampled(25, probe_drone(), 0, false, worst);
  RecordProperty("capsule_share", std::to_string(worst.capsule));
}

TEST(Reach, HoldsTheSampledBrakeOnSamplesAsOldAsAllowed) {
  Tightness worst;
  sampled(26, probe_drone(), 0, true, worst);
  RecordProperty("capsule_share", std::to_string(worst.capsule));
}

TEST(Reach, HoldsTheSampledBrakeOfARobotThatIsPushed) {
  // the disturbance of `Leaf`, against the brake and against the hold that follows
  for (const bool delayed : {false, true}) {
    Tightness worst;
    sampled(28, probe_leaf(), 300, delayed, worst);
    RecordProperty(delayed ? "capsule_share_delayed" : "capsule_share",
                   std::to_string(worst.capsule));
  }
}

}  // namespace
}  // namespace rtac::kernel_test
