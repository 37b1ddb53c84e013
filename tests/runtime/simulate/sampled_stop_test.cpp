// The stop by the pilot of the recoveries: that of the theory where nothing misleads it, and
// farther where samples do.
#include "sampled_stop.h"

#include <gtest/gtest.h>

namespace rtac::simulate {
namespace {

constexpr double speed_mps = 1.5, brake_s = 0.2;
constexpr double stop_m = speed_mps * speed_mps / 2;  // at 1 m/s^2
const Vec3 along{1, 0, 0};

RobotLimits limits_of(double error_m, double error_mps) {
  RobotLimits l;
  l.speed_mps = speed_mps;
  l.accel_mps2 = l.brake_mps2 = 1;
  l.position_error_m = error_m;
  l.velocity_error_mps = error_mps;
  return l;
}

// Straight on at full speed, through the origin when the brake acts.
double reach_m(const RobotLimits& limits, TimeUs period_us) {
  const FreeMotion free{[](double time_s) { return (time_s - brake_s) * speed_mps * along; },
                        [](double) { return speed_mps * along; }, brake_s};
  const WorstPath path = sampled_stop(limits, period_us, free, along, "test");
  EXPECT_NEAR(path.at(0).x, -brake_s * speed_mps, 1e-9);
  EXPECT_GE(path.still_s, brake_s);
  EXPECT_LE(path.still_s, path.end_s);
  return path.at(path.end_s).x;
}

TEST(SampledStop, IsThatOfTheTheoryWhereNothingMisleads) {
  EXPECT_NEAR(reach_m(limits_of(0, 0), 5'000), stop_m, 0.005);
}

TEST(SampledStop, IsFartherByErrorsAgesAndPushes) {
  double before_m = reach_m(limits_of(0, 0), 50'000);
  RobotLimits l = limits_of(0.02, 0);
  for (int more = 0; more < 4; ++more) {
    if (more == 1) l.velocity_error_mps = 0.05;
    if (more == 2) l.position_age_us = l.velocity_age_us = 100'000;
    if (more == 3) l.disturbance_mps2 = 0.1;
    const double now_m = reach_m(l, 50'000);
    EXPECT_GT(now_m, before_m + 0.005) << more;
    before_m = now_m;
  }
}

}  // namespace
}  // namespace rtac::simulate
