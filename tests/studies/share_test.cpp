// How much of the time the advanced controller drives, when it pushes at the nearest wall as hard
// as it can: theory, the reference experiment. Under any control over one period, and under what it
// is told to do. Nobody gets through the wall, and nobody flaps. What it adds to the speed towards
// the wall, the recovery has to take away: more than b / (A + b) of the time nobody can have who
// pushes at one wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "rtac/safe/controllers.h"
#include "rtac/sim/adversary.h"
#include "rtac/sim/judge.h"
#include "rtac/sim/world.h"
#include "share_any_100_system.h"
#include "share_any_200_system.h"
#include "share_any_400_system.h"
#include "share_any_50_system.h"
#include "share_command_100_system.h"
#include "share_command_200_system.h"
#include "share_command_400_system.h"
#include "share_command_50_system.h"

namespace {

constexpr int seeds = 4;
constexpr rtac::TimeUs run_us = 150'000'000;

struct Flight {
  double share = 0, engagements_a_minute = 0, clearance_m = 1e9;
  bool violated = false;
};

// The loop of an executor: propose, decide, command, remember what was sent.
template <class System, class Decision>
void fly(const rtac::RobotLimits& limits, const rtac::ZoneView& room, std::uint64_t seed,
         Flight& all) {
  using namespace rtac;
  sim::RobotSetup robot;
  robot.limits = limits;
  robot.start = {2.5, 2.5};
  sim::WorldOptions options;
  options.seed = seed;
  options.noise = sim::NoiseModel::extreme;
  sim::World<Acceleration> world({robot}, options);
  sim::SafetyJudge judge({limits.radius_m}, {0, 0, 0});
  judge.watch_zone(room);
  world.on_step([&](TimeUs now_us) { judge.observe(now_us, world.truths()); });
  sim::PushAtNearest<Acceleration> pilot(limits, &room);
  Decision decision(0);
  safe::Setting setting;
  setting.limits = limits;
  setting.period_us = decision.info().period_us;
  setting.speed_mps = 0.5;
  setting.zone = &room;
  setting.route_clearance_m = setting.return_clearance_m = System::return_clearance_m;
  safe::Retreat<Acceleration> recovery(setting);
  Observation seen;
  int mode = 0;
  double steps = 0, advanced = 0, engagements = 0;
  for (TimeUs now_us = 0; now_us < run_us; now_us += setting.period_us) {
    if (!world.wait_until(now_us)) break;
    world.robot(0).sense(seen);
    seen.now_us = now_us;
    const Acceleration wanted = pilot.command(seen);
    seen.proposed = {wanted.value_mps2, now_us};
    const DecisionRecord& record = decision.step(seen, mode != 0 && recovery.holding(), false);
    if (mode == 0 && record.mode != 0) {
      recovery.engage(seen);
      engagements += 1;
    }
    mode = record.mode;
    const Acceleration sent = mode == 0 ? wanted : recovery.command(seen, record.gate);
    world.robot(0).actuate(sent);
    seen.sent = {sent.value_mps2, now_us};
    steps += 1;
    advanced += mode == 0 ? 1 : 0;
  }
  all.share += advanced / steps / seeds;
  all.engagements_a_minute += 60e6 * engagements / static_cast<double>(run_us) / seeds;
  all.clearance_m = std::min(all.clearance_m, judge.clearance(0).smallest);
  all.violated = all.violated || judge.violated();
}

template <class System, class Decision>
Flight flights(const rtac::RobotLimits& limits, const rtac::ZoneView& room) {
  Flight all;
  for (int seed = 1; seed <= seeds; ++seed) {
    fly<System, Decision>(limits, room, static_cast<std::uint64_t>(seed), all);
  }
  return all;
}

void row(const char* name, int period_ms, const Flight& f) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << std::setw(4) << period_ms << " ms  " << std::setw(8)
       << name << std::setw(7) << 100 * f.share << " %" << std::setw(8) << f.engagements_a_minute
       << " engagements a minute, least clearance " << std::setprecision(3) << f.clearance_m
       << " m\n";
  std::cout << text.str();
  EXPECT_FALSE(f.violated);
}

#define FLIGHTS(module) \
  flights<module::System, module::Fly>(module::Drone_limits(), module::room_zone())

TEST(Share, OfAnAdvancedControllerThatPushesAtTheWall) {
  const int periods_ms[] = {50, 100, 200, 400};
  constexpr double most = 0.5, first_push = 0.01;  // A = b; from the middle to the wall
  const double least_any[] = {0.44, 0.40, 0.32, 0.17};
  const double least_command[] = {0.46, 0.45, 0.39, 0.28};
  const Flight any[] = {FLIGHTS(share_any_50), FLIGHTS(share_any_100), FLIGHTS(share_any_200),
                        FLIGHTS(share_any_400)};
  const Flight command[] = {FLIGHTS(share_command_50), FLIGHTS(share_command_100),
                            FLIGHTS(share_command_200), FLIGHTS(share_command_400)};
  for (int i = 0; i < 4; ++i) {
    row("any", periods_ms[i], any[i]);
    row("command", periods_ms[i], command[i]);
    EXPECT_GT(any[i].share, least_any[i]);
    EXPECT_GT(command[i].share, least_command[i]);
    // a tenth of all that there is more, or nine tenths of it
    EXPECT_GT(command[i].share, std::min(any[i].share + 0.1 * most, 0.9 * most));
    EXPECT_LT(command[i].share, most + first_push);
    EXPECT_LT(any[i].share, most + first_push);
  }
}

}  // namespace
