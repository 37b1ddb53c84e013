// One run: the robots of a decision under one attack.
#pragma once

#include <string>
#include <vector>

#include "case.h"
#include "kernel.h"
#include "rtac/sim/random.h"
#include "rtac/sim/referee.h"
#include "rtac/sim/tape.h"
#include "scenario.h"

namespace rtac::simulate {

struct RobotStart {
  Vec2 place;
  double heading_rad = 0, battery = 1;
  double height_m = 0;  // in space
};
// Everything that a run depends on, apart from the kernel.
struct Setup {
  std::uint64_t seed = 1;
  TimeUs duration_us = 0;
  const Adversary* adversary = nullptr;
  std::vector<const Adversary*> of_robot;  // who drives them
  sim::Hostility hostility;
  std::vector<RobotStart> starts;
};
struct Outcome {
  sim::Violation violation;
  std::vector<sim::LeastMargin> least;  // by monitor
  std::vector<std::int64_t> ticks;      // by mode, over all robots
  std::int64_t engagements = 0;         // a recovery takes over from the advanced controller
  TimeUs duration_us = 0;               // it ends soon after a violation
};

// Places of robots that the scenario does not name are drawn by the seed, where every property
// holds.
Problem make_setup(const DecisionCase& decision, const Scenario& scenario, std::uint64_t seed,
                   Setup& to);

// Somewhere in the zones that the properties speak of, where those of the robot hold; where it is,
// when no such place is found.
Vec2 draw_place(const DecisionCase& decision, const std::vector<sim::TruthState>& truths, int robot,
                sim::Random& random);

Problem run(const DecisionCase& decision, const Kernel::Functions& kernel, const Setup& setup,
            sim::Tape& tape, Outcome& to);

}  // namespace rtac::simulate
