#include "tests/bench/shift.h"

#include <array>
#include <memory>
#include <vector>

#include "robot_delivery_system.h"
#include "rtac/planning/certified_planner.h"
#include "rtac/planning/ompl_planner.h"
#include "rtac/sim/adversary.h"
#include "rtac/sim/controllers.h"
#include "rtac/sim/random.h"
#include "rtac/sim/world.h"

namespace rtac::bench {
namespace {

namespace rta = robot_delivery;

constexpr int robots = robot_count;
static_assert(robots == rta::System::robots);
constexpr double arena_m = 5;
constexpr TimeUs period_us = 100'000;
constexpr double charge_at_start[robots] = {0.55, 0.65};  // both have to recharge

// Random places of the arena outside the boxes.
class Parcels final : public TaskSource {
 public:
  explicit Parcels(std::uint64_t seed) : random_(sim::Random::stream(seed, 100, 0)) {}
  bool next(int, Vec2& destination) override {
    do {
      destination = {random_.uniform(0, arena_m), random_.uniform(0, arena_m)};
    } while (signed_clearance(rta::free_zone(), destination) <= 0);
    return true;
  }
  void completed(int, Vec2, TimeUs) override {}
  void skipped(int, Vec2, TimeUs) override {}

 private:
  sim::Random random_;
};

// The generated module, and beside it its kernel with a state that the listener may see.
class HeardDecision final : public DecisionModule {
 public:
  HeardDecision(int self, Listener& listener) : listener_(listener), module_(self) {
    robot_delivery_plan_executor_init(&state_);
  }
  [[nodiscard]] const DecisionInfo& info() const override { return module_.info(); }
  const DecisionRecord& step(const Observation& observation, bool holding,
                             bool surrender) override {
    fill(in_, observation, holding, surrender);
    listener_.on_decision({observation, holding, surrender, in_, state_, module_});
    KernelOut out;
    robot_delivery_plan_executor_step(&state_, &in_, observation.now_us, &out);
    const DecisionRecord& record = module_.step(observation, holding, surrender);
    agrees_ = agrees_ && record.mode == out.mode;
    return record;
  }
  void reset() override {
    module_.reset();
    robot_delivery_plan_executor_init(&state_);
  }
  [[nodiscard]] bool agrees() const { return agrees_; }

 private:
  Listener& listener_;
  rta::PlanExecutor module_;
  KernelState state_{};
  KernelIn in_{};
  bool agrees_ = true;
};

// What the same robots are without decision modules: nobody takes over, and every plan will do.
class Unasked final : public DecisionModule, public PlanDecision {
 public:
  explicit Unasked(const DecisionInfo& info) { record_.info = &info; }
  [[nodiscard]] const DecisionInfo& info() const override { return *record_.info; }
  const DecisionRecord& step(const Observation& observation, bool, bool) override {
    return at(observation.now_us);
  }
  const DecisionRecord& judge(const Path&, TimeUs now_us) override { return at(now_us); }
  void reset() override {}

 private:
  const DecisionRecord& at(TimeUs now_us) {
    record_.time_us = now_us;
    return record_;
  }
  DecisionRecord record_;
};

OmplOptions advanced_planner(std::uint64_t seed) {
  OmplOptions options;
  options.lower = {0, 0};
  options.upper = {arena_m, arena_m};
  options.zone = &rta::free_zone();
  options.clearance_m = rta::TurtleBot3_limits().radius_m;
  options.seed = seed;
  options.iterations = 600;
  return options;
}
CertifiedOptions certified_planner(std::uint64_t seed) {
  CertifiedOptions options;
  options.lower = {0, 0};
  options.upper = {arena_m, arena_m};
  options.zone = &rta::free_zone();
  options.clearance_m = rta::System::cruise_clearance_m;
  options.seed = seed;
  return options;
}
// Honest most of the time; now and then it pushes at the nearest wall or robot.
sim::LapseOptions lapses(std::uint64_t seed) {
  sim::LapseOptions options;
  options.seed = seed;
  options.mean_interval_us = 60'000'000;
  options.mean_duration_us = 6'000'000;
  return options;
}
safe::Setting setting(double speed_mps) {
  safe::Setting s;
  s.limits = rta::TurtleBot3_limits();
  s.period_us = period_us;
  s.speed_mps = speed_mps;
  s.zone = &rta::free_zone();
  s.route_clearance_m = rta::System::cruise_clearance_m;
  s.return_clearance_m = rta::System::return_clearance_m;
  s.pass_gap_m = rta::System::pass_gap_m;
  return s;
}

// Everything of one robot, as the generated system has it, with a decision that can be heard.
struct Robot {
  Robot(std::uint64_t seed, int self, Listener* listener, bool decides = true)
      : decision(self),
        plan_decision(self),
        unasked(decision.info()),
        unasked_plan(plan_decision.info()),
        give_way(setting(0.1)),
        turn_back(setting(0.1)),
        go_charge(setting(0.15), rta::System::dock(self)),
        follow_plan(std::make_unique<sim::FollowPlan<Twist>>(rta::TurtleBot3_limits()),
                    std::make_unique<sim::PushAtNearest<Twist>>(rta::TurtleBot3_limits(),
                                                                &rta::free_zone()),
                    lapses(1000 * seed + static_cast<std::uint64_t>(self))),
        rrt_star(advanced_planner(2000 * seed + static_cast<std::uint64_t>(self))),
        certified(certified_planner(3000 * seed + static_cast<std::uint64_t>(self))) {
    if (listener != nullptr) heard = std::make_unique<HeardDecision>(self, *listener);
    parts.name = rta::System::robot_name(self);
    parts.decision = heard ? static_cast<DecisionModule*>(heard.get()) : &decision;
    parts.plan_decision = &plan_decision;
    if (!decides) parts.decision = &unasked, parts.plan_decision = &unasked_plan;
    (void)parts.recoveries.push(&give_way);
    (void)parts.recoveries.push(&turn_back);
    (void)parts.recoveries.push(&go_charge);
    parts.advanced = &follow_plan;
    parts.advanced_planner = &rrt_star;
    parts.safe_planner = &certified;
    parts.period_us = period_us;
    parts.limits = rta::TurtleBot3_limits();
  }
  rta::PlanExecutor decision;
  std::unique_ptr<HeardDecision> heard;
  rta::MotionPlanner plan_decision;
  Unasked unasked, unasked_plan;
  safe::Yield<Twist> give_way;
  safe::Retreat<Twist> turn_back;
  safe::Route<Twist> go_charge;
  sim::Lapses<Twist> follow_plan;
  OmplPlanner rrt_star;
  CertifiedPlanner certified;
  RobotParts<Twist> parts;
};

sim::World<Twist> world_of(std::uint64_t seed) {
  std::vector<sim::RobotSetup> setups;
  for (int r = 0; r < robots; ++r) {
    sim::RobotSetup setup;
    setup.limits = rta::TurtleBot3_limits();
    setup.start = rta::System::dock(r);
    setup.battery = charge_at_start[r];
    setup.has_dock = true;
    setup.dock = rta::System::dock(r);
    setups.push_back(setup);
  }
  sim::WorldOptions options;
  options.seed = seed;
  options.noise = sim::NoiseModel::extreme;
  return {setups, options};
}

TimeUs us_of(double minutes) {
  return static_cast<TimeUs>(minutes * 60e6);
}

}  // namespace

bool run_shift(std::uint64_t seed, double minutes, Listener* listener) {
  sim::World<Twist> world = world_of(seed);
  Parcels parcels(seed);
  Robot first(seed, 0, listener), second(seed, 1, listener);
  const std::array<RobotParts<Twist>, robots> parts{first.parts, second.parts};
  System<Twist> system(parcels, parts.data(), robots, rta::System::default_options());
  const bool ran = system.run(world, us_of(minutes)) == Status::ok;
  return ran && (listener == nullptr || (first.heard->agrees() && second.heard->agrees()));
}

bool run_undecided(std::uint64_t seed, double minutes) {
  sim::World<Twist> world = world_of(seed);
  Parcels parcels(seed);
  Robot first(seed, 0, nullptr, false), second(seed, 1, nullptr, false);
  const std::array<RobotParts<Twist>, robots> parts{first.parts, second.parts};
  SystemOptions options = rta::System::default_options();
  options.protect = false;
  System<Twist> system(parcels, parts.data(), robots, options);
  return system.run(world, us_of(minutes)) == Status::ok;
}

bool run_bare(std::uint64_t seed, double minutes) {
  sim::World<Twist> world = world_of(seed);
  std::array<Observation, robots> seen{};
  for (TimeUs next_us = period_us; next_us <= us_of(minutes); next_us += period_us) {
    for (int r = 0; r < robots; ++r) {
      Observation& observation = seen[static_cast<std::size_t>(r)];
      world.robot(r).sense(observation);
      world.robot(r).actuate({0.2, 0.5});
      Announcement announcement;
      announcement.position = observation.position;
      announcement.velocity = observation.velocity;
      world.robot(r).announce(announcement);
    }
    if (!world.wait_until(next_us)) return false;
  }
  return true;
}

}  // namespace rtac::bench
