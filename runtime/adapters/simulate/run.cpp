#include "run.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <memory>
#include <utility>
#include <variant>

#include "oracle.h"
#include "recoveries.h"
#include "rtac/sim/arena.h"
#include "rtac/sim/attacker.h"
#include "rtac/sim/controllers.h"
#include "rtac/sim/hostile.h"
#include "rtac/stack/plan_executor.h"

namespace rtac::simulate {
namespace {

using sim::Arena;
using sim::Tape;

// How long a run goes on after a violation, to see how deep it gets.
constexpr TimeUs after_violation_us = 2'000'000;
constexpr int steps_between_looks = 512;  // at the clock
constexpr std::uint64_t drive_stream = 3002, plan_stream = 3003;

// Stands where the layer above a plan executor would: a robot without errands would surrender
// control, and an attack never does. Whoever drives by plans gets one whenever there is none: by
// way of some places where the properties hold to another one, whatever lies between.
class Errands final : public stack::RobotMachine {
 public:
  Errands(const DecisionCase& decision, const Setup& setup, const Arena& arena, int robot)
      : decision_(decision),
        plans_(setup.of_robot[static_cast<std::size_t>(robot)]->drive == Drive::plans),
        arena_(arena),
        robot_(robot),
        random_(sim::Random::stream(setup.seed, plan_stream, static_cast<std::uint64_t>(robot))) {}
  void connect(stack::ExecutorMachine& executor) { executor_ = &executor; }

 private:
  void handle(const stack::RobotEvent& event) override {
    const auto* const report = std::get_if<stack::Report>(&event);
    if (!plans_ || report == nullptr || report->mode != 0 || report->has_plan) return;
    stack::Situation situation;
    situation.has_destination = true;
    stack::NewPlan plan;
    const auto most =
        std::clamp<std::int64_t>(static_cast<std::int64_t>(decision_.plan_capacity), 1, 4);
    for (std::int64_t legs = 1 + random_.below(most); legs > 0; --legs) {
      situation.destination = draw_place(decision_, arena_.truths(), robot_, random_);
      (void)plan.path.points.push(situation.destination);
    }
    executor_->post(situation);
    plan.path.stamp_us = report->now_us;
    executor_->post(plan);
  }

  const DecisionCase& decision_;
  bool plans_;
  const Arena& arena_;
  int robot_;
  sim::Random random_;
  stack::ExecutorMachine* executor_ = nullptr;
};

class Watcher final : public SystemObserver {
 public:
  // `standing`: by robot, who is told to stand from now on.
  Watcher(const DecisionCase& decision, const Setup& setup, TimeUs jitter_us, Arena& arena,
          Tape& tape, Outcome& outcome, std::vector<bool>& standing, Blame& blame)
      : decision_(decision),
        setup_(setup),
        jitter_us_(jitter_us),
        arena_(arena),
        tape_(tape),
        outcome_(outcome),
        standing_(standing),
        blame_(blame),
        kept_from_us_(decision.robots.size(), never_us) {
    outcome_.ticks.assign(decision.monitors.size() + 1, 0);
  }
  void on_decision(const DecisionRecord& record) override {
    arena_.found(record);
    blame_.decided(record);
    standing_[static_cast<std::size_t>(record.robot)] =
        record.mode != 0 &&
        (record.gate == Gate::hold ||
         decision_.monitors[static_cast<std::size_t>(record.mode - 1)].recovery.kind ==
             "brake_and_hold");
    ++outcome_.ticks[static_cast<std::size_t>(record.mode)];
    if (record.mode != 0 && record.previous_mode == 0) ++outcome_.engagements;
    if (setup_.return_within_us > 0) keep(record);
    if (setup_.undecided) miss(record);
    if (!tape_.recording()) return;
    const sim::TruthState& truth = arena_.truth(record.robot);
    tape_.write("decide",
                {record.robot, record.mode, record.deciding_monitor,
                 static_cast<std::int64_t>(record.reason), static_cast<std::int64_t>(record.gate)},
                {});
    tape_.write("truth", {record.robot},
                {truth.position.x, truth.position.y, truth.velocity.x, truth.velocity.y,
                 truth.heading_rad, truth.battery, truth.height_m, truth.climb_mps});
  }

 private:
  // How long a robot has not been given back; by the monitor that the run is about, if it is about
  // one.
  void keep(const DecisionRecord& record) {
    TimeUs& from_us = kept_from_us_[static_cast<std::size_t>(record.robot)];
    const bool kept = setup_.about < 0 ? record.mode != 0 : keeps(record);
    if (!kept) from_us = never_us;
    if (kept && from_us == never_us) from_us = record.time_us;
    if (!kept || outcome_.kept.robot >= 0) return;
    if (record.time_us - from_us < setup_.return_within_us) return;
    outcome_.kept = {record.robot, record.mode, from_us, record.time_us};
  }

  // While another recovery drives, or another robot is in the way of one that leads somewhere, it
  // is not that monitor which keeps the robot.
  [[nodiscard]] bool keeps(const DecisionRecord& record) const {
    const auto about = static_cast<std::size_t>(setup_.about);
    if (!record.monitors[about].engaged || record.mode == 0) return false;
    const auto& own = decision_.monitors[about].recovery;
    const auto drives = static_cast<std::size_t>(record.mode - 1);
    if (decision_.monitors[drives].recovery.name != own.name) return false;
    return record.gate == Gate::free || own.kind == "brake_and_hold" || own.kind == "yield";
  }

  // A command of the advanced controller that acts for longer than the decision behind it has
  // looked ahead: until the next one is made, or until that one acts at all.
  void miss(const DecisionRecord& record) {
    TimeUs& from_us = kept_from_us_[static_cast<std::size_t>(record.robot)];
    const TimeUs before_us = std::exchange(from_us, record.mode == 0 ? record.time_us : never_us);
    if (before_us == never_us || outcome_.kept.robot >= 0) return;
    const MonitorCase& m = decision_.monitors[static_cast<std::size_t>(std::max(0, setup_.about))];
    const TimeUs latency_us = decision_.limits.latency_us;
    const TimeUs ahead_us = m.horizon_us - latency_us - jitter_us_;
    const TimeUs until_us = before_us + std::max(record.time_us - before_us, latency_us);
    if (m.horizon_us == 0 || until_us <= before_us + ahead_us) return;
    outcome_.kept = {record.robot, 0, before_us + ahead_us, until_us};
  }

  const DecisionCase& decision_;
  const Setup& setup_;
  TimeUs jitter_us_;
  Arena& arena_;
  Tape& tape_;
  Outcome& outcome_;
  std::vector<bool>& standing_;
  Blame& blame_;
  std::vector<TimeUs> kept_from_us_;  // by robot
};

template <class Output>
class Fleet {
 public:
  Fleet(const DecisionCase& decision, const Kernel::Functions& kernel, const Setup& setup,
        const Arena& arena, sim::Crowd& crowd, Tape& tape)
      : decision_(decision),
        setup_(setup),
        arena_(arena),
        makes_(decision, setup, kernel.jitter_us, arena, tape) {
    for (int i = 0; i < static_cast<int>(decision.robots.size()); ++i) {
      decisions_.push_back(std::make_unique<KernelDecision>(
          kernel, decision, i,
          [&crowd](int robot, int agent, TimeUs now_us) {
            return now_us < 0 ? Sample<Vec3>{far_away, now_us} : crowd.see(robot, agent, now_us);
          },
          setup.begins_us));
      remember_starts(i);
      attacks_.push_back(
          std::make_unique<Taped<Output>>(attack(setup, i, arena), "command", i, tape));
      parts_.push_back(parts(i));
    }
  }
  // Wires the plan executors of all robots. False: a recovery is none that is known here.
  bool start(sim::HostileFleet<Output>& world, SystemObserver& observer) {
    SystemOptions options;
    options.pass_gap_m = decision_.monitors.front().recovery.pass_gap_m;
    const int robots = static_cast<int>(parts_.size());
    for (int i = 0; i < robots; ++i) {
      const RobotParts<Output>& p = parts_[static_cast<std::size_t>(i)];
      for (const SafeController<Output>* each : p.recoveries) {
        if (each == nullptr) return false;
      }
      errands_.push_back(std::make_unique<Errands>(decision_, setup_, arena_, i));
      executors_.push_back(
          std::make_unique<stack::PlanExecutor<Output>>(i, robots, p, options, observer));
      executors_.back()->connect(*errands_.back());
      errands_.back()->connect(*executors_.back());
      executors_.back()->attach(world.robot(i));
    }
    return true;
  }
  // The decisions of all robots, every period, until the world stops.
  void run(sim::HostileFleet<Output>& world, TimeUs until_us) {
    for (TimeUs due_us = 0; due_us < until_us; due_us += decision_.period_us) {
      if (!world.wait_until(due_us)) return;
      for (auto& executor : executors_) {
        executor->post(stack::Tick{world.now_us()});
        while (executor->step()) continue;
      }
      for (auto& errands : errands_) {
        while (errands->step()) continue;
      }
    }
    (void)world.wait_until(until_us);
  }

 private:
  // Before it begins robots have stood where they start.
  void remember_starts(int robot) {
    std::vector<Moving> standing;
    for (const RobotStart& s : setup_.starts) {
      standing.push_back({{s.place.x, s.place.y, s.height_m}, {}, s.heading_rad, s.battery});
    }
    remember(*decisions_.back(), decision_, robot, standing, 0);
  }
  std::unique_ptr<Controller<Output>> attack(const Setup& setup, int robot, const Arena& arena) {
    const Adversary& adversary = *setup.of_robot[static_cast<std::size_t>(robot)];
    const std::uint64_t seed =
        sim::Random::stream(setup.seed, drive_stream, static_cast<std::uint64_t>(robot)).next();
    if (adversary.drive == Drive::bang_bang) {
      return std::make_unique<sim::BangBang<Output>>(arena.limits(), seed);
    }
    if (adversary.drive == Drive::plans) {
      return std::make_unique<sim::FollowPlan<Output>>(arena.limits());
    }
    const auto manner =
        adversary.drive == Drive::push ? sim::Manner::only_pushes : sim::Manner::in_phases;
    return std::make_unique<sim::Chase<Output>>(arena, robot, adversary.aim, seed, manner);
  }
  RobotParts<Output> parts(int robot) {
    RobotParts<Output> p;
    p.name = decision_.robots[static_cast<std::size_t>(robot)].c_str();
    p.decision = decisions_.back().get();
    const std::size_t first = recoveries_.size();
    std::vector<std::string> names;
    for (const MonitorCase& m : decision_.monitors) {
      std::size_t k = 0;
      while (k < names.size() && names[k] != m.recovery.name) ++k;
      if (k == names.size()) {
        names.push_back(m.recovery.name);
        recoveries_.push_back(makes_.make(m.recovery, robot));
      }
      (void)p.recoveries.push(recoveries_[first + k].get());
    }
    p.advanced = attacks_.back().get();
    p.period_us = decision_.period_us;
    p.limits = decision_.limits;
    return p;
  }

  const DecisionCase& decision_;
  const Setup& setup_;
  const Arena& arena_;
  Recoveries<Output> makes_;
  std::vector<std::unique_ptr<KernelDecision>> decisions_;
  std::vector<std::unique_ptr<Taped<Output>>> attacks_;
  std::vector<std::unique_ptr<SafeController<Output>>> recoveries_;
  std::vector<RobotParts<Output>> parts_;
  std::vector<std::unique_ptr<Errands>> errands_;
  std::vector<std::unique_ptr<stack::PlanExecutor<Output>>> executors_;
};

std::vector<sim::RobotSetup> bodies(const DecisionCase& decision, const Setup& setup) {
  std::vector<sim::RobotSetup> all;
  for (std::size_t i = 0; i < setup.starts.size(); ++i) {
    const RobotStart& start = setup.starts[i];
    sim::RobotSetup body;
    body.limits = decision.limits;
    body.start = start.place;
    body.height_m = start.height_m;
    body.heading_rad = start.heading_rad;
    body.battery = start.battery;
    body.has_dock = i < decision.docks.size();
    if (body.has_dock) {
      body.dock = decision.docks[i];
      body.dock_speed_mps = decision.dock_mps;
    }
    all.push_back(body);
  }
  return all;
}

// A tick is late by its jitter at most, and each sends one command.
std::size_t commands_under_way(const DecisionCase& decision, const Setup& setup) {
  const TimeUs span_us = decision.limits.latency_us + setup.hostility.jitter_us;
  return static_cast<std::size_t>(span_us / std::max<TimeUs>(1, decision.period_us)) + 2;
}

template <class Output>
Problem run_as(const DecisionCase& decision, const Kernel::Functions& kernel, const Setup& setup,
               Tape& tape, Outcome& to, double until_s) {
  const int robots = static_cast<int>(decision.robots.size());
  sim::WorldOptions options;
  options.seed = setup.seed;
  options.noise = sim::NoiseModel::none;
  options.lasting_gusts = setup.hostility.noise == sim::Noise::lasting;
  options.commands_max = commands_under_way(decision, setup);
  const DecisionCase at_worst = at_its_worst(decision, setup);  // attacks know what is to come
  sim::Surroundings surroundings = decision.surroundings;
  surroundings.open = open_at(decision.calendar, setup.begins_us);
  const std::vector<TimeUs> changes =
      changes_between(decision.calendar, setup.begins_us, setup.begins_us + setup.duration_us);
  auto next = changes.begin();
  std::vector<bool> standing(decision.robots.size(), false);
  surroundings.told_to_stand = &standing;
  Arena arena(surroundings, at_worst.properties, decision.limits, robots);
  if (setup.adversary != nullptr && setup.adversary->aims_wind) {
    options.wind = [&](int robot) { return arena.threat(robot, setup.adversary->aim).direction; };
  }
  sim::World<Output> world(bodies(decision, setup), options);
  sim::Crowd crowd(decision.agents, at_worst.properties, surroundings, world.truths(),
                   setup.hostility, setup.seed, tape);
  arena.watch(world.truths());
  sim::Referee referee(surroundings, decision.properties, robots, setup.about);
  Blame blame(decision.robots.size(), decision.monitors.size());
  int steps = 0;
  sim::HostileFleet<Output> hostile(world, arena, setup.hostility, tape, [&](TimeUs now_us) {
    crowd.move(now_us);
    for (; next != changes.end() && *next <= setup.begins_us + now_us; ++next) {
      surroundings.open = open_at(decision.calendar, *next);
      referee.look_anew();
    }
    if (now_us == 0 || blame.everybody_has_decided()) referee.observe(now_us, world.truths());
    const sim::Violation& violation = referee.first_violation();
    if (referee.violated() && to.drove.empty()) {
      to.drove = blame.who(violation.monitor, violation.robot);
    }
    const bool returns = lasts(setup);
    if (!returns && referee.violated() && now_us >= violation.time_us + after_violation_us) {
      world.stop();
    }
    if (returns && to.kept.robot >= 0) world.stop();
    if (++steps % steps_between_looks == 0 && core_seconds() > until_s) {
      to.cut = true;
      world.stop();
    }
  });
  Fleet<Output> fleet(at_worst, kernel, setup, arena, crowd, tape);
  Watcher watcher(decision, setup, kernel.jitter_us, arena, tape, to, standing, blame);
  if (!fleet.start(hostile, watcher)) {
    return {"decision `" + decision.name + "` has a recovery that `rtac-sim` does not know",
            "install `rtac` and `rtac-sim` of the same version", true};
  }
  fleet.run(hostile, setup.duration_us);
  to.violation = referee.first_violation();
  for (int m = 0; m < static_cast<int>(decision.monitors.size()); ++m) {
    to.least.push_back(referee.least(m));
  }
  to.duration_us = world.now_us();
  if (world.lost() > 0) {
    return {"the simulator has lost " + std::to_string(world.lost()) + " commands of decision `" +
                decision.name + "`",
            "the latency is too many periods long", true};
  }
  return {};
}

}  // namespace

Problem run(const DecisionCase& decision, const Kernel::Functions& kernel, const Setup& setup,
            Tape& tape, Outcome& to, double until_s) {
  return decision.twist ? run_as<Twist>(decision, kernel, setup, tape, to, until_s)
                        : run_as<Acceleration>(decision, kernel, setup, tape, to, until_s);
}

double core_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace rtac::simulate
