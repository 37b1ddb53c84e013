// One run: the robots of a decision under one attack.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "blame.h"
#include "case.h"
#include "inputs.h"
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
  Told told;  // of inputs
  std::uint64_t seed = 1;
  TimeUs duration_us = 0;
  TimeUs begins_us = 0;  // what clocks show at time 0: UTC, where zones have times
  const Adversary* adversary = nullptr;
  std::vector<const Adversary*> of_robot;  // who drives them
  sim::Hostility hostility;
  std::vector<RobotStart> starts;
  int about = -1;               // the only monitor whose violation counts; -1: all
  TimeUs return_within_us = 0;  // how long a recovery may keep a robot; 0: for ever
  Asked asked;                  // who drives into the violation that counts
  bool undecided = false;       // looks for commands that act longer than is looked ahead
};
// A time in which something should have happened: control given back, or a decision.
struct Kept {
  int robot = -1;  // -1: nobody was kept too long
  int mode = 0;    // of the last decision
  TimeUs from_us = 0, until_us = 0;
};
struct Outcome {
  sim::Violation violation;
  std::vector<Drove> drove;             // into it
  std::vector<sim::LeastMargin> least;  // by monitor
  std::vector<std::int64_t> ticks;      // by mode, over all robots
  std::int64_t engagements = 0;         // a recovery takes over from the advanced controller
  TimeUs duration_us = 0;               // it ends soon after what was looked for
  Kept kept;
  bool cut = false;  // the time was up before its end
};

// Places of robots that the scenario does not name are drawn by the seed, where every property
// holds.
Problem make_setup(const DecisionCase& decision, const Scenario& scenario, std::uint64_t seed,
                   Setup& to);

// The same decision whose zones with times are there, or not, whatever is worse, where that changes
// within the run.
DecisionCase at_its_worst(const DecisionCase& decision, const Setup& setup);

// Somewhere in the zones that the properties speak of, where those of the robot hold; where it is,
// when no such place is found.
Vec2 draw_place(const DecisionCase& decision, const std::vector<sim::TruthState>& truths, int robot,
                sim::Random& random);

// It is about how long something lasts, and violations of properties do not end it.
inline bool lasts(const Setup& setup) {
  return setup.return_within_us > 0 || setup.undecided;
}
// What a run is to show: such a time, or else that a property is violated.
inline bool shown(const Setup& setup, const Outcome& outcome) {
  return lasts(setup) ? outcome.kept.robot >= 0 : outcome.violation.time_us != never_us;
}

// `until_s`: in core seconds of this process; a run that is not at its end by then is cut.
Problem run(const DecisionCase& decision, const Kernel::Functions& kernel, const Setup& setup,
            sim::Tape& tape, Outcome& to, double until_s = std::numeric_limits<double>::infinity());

// Of this process.
double core_seconds();

}  // namespace rtac::simulate
