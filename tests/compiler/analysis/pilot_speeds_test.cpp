// How fast a recovery is truly, while errors and pushes turn around, is within what limits of speed
// are held against: it overshoots what it measures, and in space its hold swings.
#include <algorithm>
#include <cmath>
#include <deque>

#include "compiler/analysis/speed_limits.h"
#include "rtac/safe/pilot.h"
#include "rtac/safe/space.h"
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

constexpr double meant_mps = 1, position_error_m = 0.05;

struct Loop {
  double push, velocity_error;
  std::int64_t period_ms, latency_ms, age_ms;
};

std::string thousandths(double value) {
  return std::to_string(std::lround(1000 * value)) + "e-3";
}
// A robot that drives along a line: in the plane, or down in space.
std::string line_text(const Loop& loop, bool in_space) {
  const std::string ages = " max_age " + std::to_string(loop.age_ms) + " ms;\n";
  const std::string zone = "rectangle (0 m, 0 m) to (400 m, 400 m)";
  return "spec line;\nzone room = " + (in_space ? "prism (" + zone + ") from 0 m to 400 m" : zone) +
         ";\nrobot Bot { body radius 10 cm;\n  motion point { speed <= 4 m/s; accel <= 3 m/s^2; "
         "brake >= 3 m/s^2; disturbance <= " +
         thousandths(loop.push) +
         " m/s^2; }\n  sense position : " + (in_space ? "point3" : "point") + " error 5 cm" + ages +
         "  sense velocity : " + (in_space ? "vector3" : "vector") + " error " +
         thousandths(loop.velocity_error) + " m/s" + ages +
         "  output thrust : acceleration; latency " + std::to_string(loop.latency_ms) +
         " ms; }\nfleet bot : Bot;\ncontroller any : advanced for Bot extern;\n"
         "controller way : safe for Bot = " +
         (in_space ? "land to 2 m" : "retreat within room") +
         " speed 1 m/s;\nmonitor fence for r : Bot { \"F\" always " +
         (in_space ? "r.position.z <= 300 m" : "r inside room") + "; ahead " +
         std::to_string(std::max(loop.latency_ms, loop.period_ms)) +
         " ms; recover way; }\ndecision drive for Bot { advanced any; period " +
         std::to_string(loop.period_ms) + " ms; priority fence; }\n";
}
double reckoned_mps(const Loop& loop, bool in_space) {
  const auto c = compiled(line_text(loop, in_space));
  EXPECT_TRUE(c->module) << reports(*c);
  if (!c->module) return 0;
  return 1e-3 * static_cast<double>(fastest_while_driving(c->module->decisions[0], 0));
}

safe::Setting setting_of(const Loop& loop) {
  safe::Setting s;
  s.limits.speed_mps = 4, s.limits.accel_mps2 = s.limits.brake_mps2 = 3;
  s.limits.disturbance_mps2 = loop.push, s.limits.velocity_error_mps = loop.velocity_error;
  s.limits.position_error_m = position_error_m;
  s.limits.position_age_us = s.limits.velocity_age_us = 1000 * loop.age_ms;
  s.limits.latency_us = 1000 * loop.latency_ms, s.period_us = 1000 * loop.period_ms;
  s.speed_mps = meant_mps, s.land_at_m = 2;
  return s;
}
// Along the line, upwards in space, what errs and pushes turning around every `turns_ms`.
// `command`: along it.
template <class Command>
double fastest_mps(const Loop& loop, double from_m, std::int64_t turns_ms, const Command& command) {
  double x = from_m, v = 0, acting = 0, fastest = 0;
  std::deque<std::pair<double, double>> past;  // the newest first
  std::deque<std::pair<std::int64_t, double>> coming;
  for (std::int64_t ms = 0; ms < 60'000; ++ms) {
    past.emplace_front(x, v);
    if (past.size() > static_cast<std::size_t>(loop.age_ms) + 1) past.pop_back();
    const double towards = ms / turns_ms % 2 == 0 ? 1 : -1;
    if (ms % loop.period_ms == 0) {
      const auto [then_m, then_mps] = past.back();
      const std::int64_t stamp_us = std::max<std::int64_t>(0, 1000 * (ms - loop.age_ms));
      coming.emplace_back(ms + loop.latency_ms,
                          command(1000 * ms, stamp_us, then_m - towards * position_error_m,
                                  then_mps - towards * loop.velocity_error));
    }
    while (!coming.empty() && coming.front().first <= ms) {
      acting = coming.front().second;
      coming.pop_front();
    }
    const double a = acting + towards * loop.push;
    x += 1e-3 * v + 0.5e-6 * a;
    v += 1e-3 * a;
    fastest = std::max(fastest, std::abs(v));
  }
  return fastest;
}
double driven_mps(const Loop& loop, std::int64_t turns_ms) {
  safe::Pilot<Acceleration> pilot(setting_of(loop));
  Path way;
  (void)way.points.push({300, 0});
  return fastest_mps(loop, 0, turns_ms,
                     [&](TimeUs now_us, TimeUs stamp_us, double at_m, double at_mps) {
                       Observation seen;
                       seen.now_us = now_us;
                       seen.position = {{at_m, 0}, stamp_us};
                       seen.velocity = {{at_mps, 0}, stamp_us};
                       if (now_us == 0) pilot.engage(seen);
                       return pilot.drive(seen, seen.position.value, way).value_mps2.x;
                     });
}
double landing_mps(const Loop& loop, std::int64_t turns_ms) {
  safe::Land land(setting_of(loop));
  return fastest_mps(loop, 70, turns_ms,
                     [&](TimeUs now_us, TimeUs stamp_us, double at_m, double at_mps) {
                       Observation seen;
                       seen.now_us = now_us;
                       seen.position = {{0, 0}, stamp_us};
                       seen.velocity = {{0, 0}, stamp_us};
                       seen.height_m = at_m, seen.climb_mps = at_mps;
                       if (now_us == 0) land.engage(seen);
                       return land.command(seen, Gate::free).up_mps2;
                     });
}

const Loop quick{0, 0.02, 20, 10, 20}, slow{0, 0.1, 20, 300, 300}, windy{0.3, 0.08, 50, 40, 100};

// The fastest of many times between two turns.
template <class Fastest>
double worst_mps(const Loop& loop, const Fastest& fastest) {
  double worst = 0;
  for (std::int64_t turns_ms = 400; turns_ms < 20'000; turns_ms = turns_ms * 6 / 5) {
    worst = std::max(worst, fastest(loop, turns_ms));
  }
  return worst;
}

TEST(PilotSpeeds, AreReckonedWithInThePlane) {
  for (const Loop& loop : {quick, slow, windy, Loop{0, 0, 100, 100, 300}}) {
    EXPECT_LE(worst_mps(loop, driven_mps), reckoned_mps(loop, false)) << loop.age_ms << " ms";
  }
  // by more than the error of its velocity
  EXPECT_GT(worst_mps(slow, driven_mps), meant_mps + slow.velocity_error + 0.03);
}

TEST(PilotSpeeds, AreReckonedWithInSpace) {
  for (const Loop& loop : {quick, slow, windy, Loop{0.5, 0.02, 50, 20, 50}}) {
    EXPECT_LE(worst_mps(loop, landing_mps), reckoned_mps(loop, true)) << loop.age_ms << " ms";
  }
  // in the plane its velocity would settle within 0.38 s
  EXPECT_GT(worst_mps(windy, landing_mps),
            meant_mps + windy.velocity_error + 2 * 0.38 * windy.push);
}

}  // namespace
}  // namespace rtac::analysis::test
