#include "rtac/sim/world.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "gusts.h"
#include "motion.h"
#include "radio.h"
#include "sensor.h"

namespace rtac::sim {
namespace {

constexpr double us_to_s = 1e-6;

Vec2 level(Vec3 v) {
  return {v.x, v.y};
}
Vec2 to_vec2(const Eigen::Vector3d& v) {
  return {v.x(), v.y()};
}

// Commands on their way to the actuators, oldest first.
template <class Output>
class CommandQueue {
 public:
  explicit CommandQueue(std::size_t most) : most_(most) {}
  bool push(const Output& command, TimeUs due_us) {
    if (queue_.size() >= most_) return false;
    queue_.emplace_back(command, due_us);
    return true;
  }
  [[nodiscard]] TimeUs next_us() const {
    return queue_.empty() ? INT64_MAX : queue_.front().second;
  }
  Output pop() {
    const Output command = queue_.front().first;
    queue_.pop_front();
    return command;
  }

 private:
  std::deque<std::pair<Output, TimeUs>> queue_;
  std::size_t most_;
};

ValueRange space_of(const RobotSetup& setup) {
  return setup.limits.in_space ? ValueRange::open : ValueRange::level;
}

struct Senses {
  Senses(const RobotSetup& setup, const TruthState& truth, const WorldOptions& options,
         std::uint64_t robot)
      : position(setup.limits.position_age_us, setup.limits.position_error_m, options.noise,
                 space_of(setup), Random::stream(options.seed, robot, 0), position_of(truth)),
        velocity(setup.limits.velocity_age_us, setup.limits.velocity_error_mps, options.noise,
                 space_of(setup), Random::stream(options.seed, robot, 1), velocity_of(truth)),
        heading(setup.limits.heading_age_us, setup.limits.heading_error_rad, options.noise,
                ValueRange::angle, Random::stream(options.seed, robot, 2), truth.heading_rad),
        battery(setup.limits.battery_age_us, setup.limits.battery_error, options.noise,
                ValueRange::ratio, Random::stream(options.seed, robot, 3), truth.battery),
        odometry(Random::stream(options.seed, robot, 4)) {}

  [[nodiscard]] TimeUs next_us() const {
    return std::min(std::min(position.next_us(), velocity.next_us()),
                    std::min(heading.next_us(), battery.next_us()));
  }
  void take_due(TimeUs now_us, const TruthState& truth) {
    if (position.next_us() <= now_us) position.take(now_us, position_of(truth));
    if (velocity.next_us() <= now_us) velocity.take(now_us, velocity_of(truth));
    if (heading.next_us() <= now_us) heading.take(now_us, truth.heading_rad);
    if (battery.next_us() <= now_us) battery.take(now_us, truth.battery);
  }

  Sensor<Vec3> position, velocity;
  Sensor<double> heading, battery;
  Random odometry;  // of announcements
};

std::function<Vec3()> wind_at(const WorldOptions& options, int robot) {
  if (!options.wind) return nullptr;
  return [wind = options.wind, robot] { return wind(robot); };
}

template <class Output>
struct Agent {
  Agent(const RobotSetup& given, const TruthState& truth, const WorldOptions& options,
        std::uint64_t robot)
      : setup(given),
        commands(options.commands_max),
        senses(given, truth, options, robot),
        gusts(Random::stream(options.seed, robot, 6), options.lasting_gusts,
              wind_at(options, static_cast<int>(robot))) {
    body.position = {truth.position.x, truth.position.y, truth.height_m};
    body.heading_rad = truth.heading_rad;
  }
  [[nodiscard]] TimeUs next_us() const { return std::min(commands.next_us(), senses.next_us()); }

  RobotSetup setup;
  Body body;
  Output acting{};  // the command that the actuators follow now
  CommandQueue<Output> commands;
  Senses senses;
  Gusts gusts;
};

double next_battery(const RobotSetup& setup, const TruthState& before, Vec2 position,
                    double driven_m, double speed_mps, double dt_s, bool& charging) {
  const RobotLimits& limits = setup.limits;
  const bool docked = setup.has_dock && length(position - setup.dock) <= dock_reach_m &&
                      speed_mps <= setup.dock_speed_mps;
  // No motion takes more than `drain`, however far it leads. The dock supplies what the robot needs
  // to hold its place; a full battery stays full.
  const double taken = docked ? 0
                              : std::min(limits.idle_per_s * dt_s + limits.drive_per_m * driven_m,
                                         limits.drain_per_s * dt_s);
  const double gained = docked ? limits.charge_per_s * dt_s : 0;
  const double battery = clamp(before.battery + gained - taken, 0.0, 1.0);
  charging = docked && battery < 1.0;
  return battery;
}

}  // namespace

template <class Output>
class World<Output>::Robot final : public RobotSdk<Output> {
 public:
  Robot(Impl& world, int index) : world_(world), index_(index) {}
  void sense(Observation& observation) override { world_.sense(index_, observation); }
  void actuate(const Output& output) override { world_.actuate(index_, output); }
  void announce(const Announcement& announcement) override {
    world_.announce(index_, announcement);
  }

 private:
  Impl& world_;
  int index_;
};

template <class Output>
class World<Output>::Impl {
 public:
  Impl(const std::vector<RobotSetup>& robots, const WorldOptions& options);

  void sense(int robot, Observation& observation);
  void actuate(int robot, const Output& output);
  void announce(int robot, const Announcement& announcement);
  bool run_until(TimeUs time_us);
  void inject(const Fault& fault);

  WorldOptions options;
  TimeUs now_us = 0;
  bool stopped = false;
  std::int64_t lost = 0;
  std::vector<TruthState> truths;
  std::vector<Robot> handles;
  std::function<void(TimeUs)> on_step;

 private:
  void step(TimeUs until_us);
  void move(Agent<Output>& agent, TruthState& truth, double dt_s);
  void handle_events();
  void find_next_event();

  std::vector<Agent<Output>> agents_;
  Radio radio_;
  TimeUs next_event_us_ = 0;
};

template <class Output>
World<Output>::Impl::Impl(const std::vector<RobotSetup>& robots, const WorldOptions& given)
    : options(given), radio_(robots, given.seed) {
  options.step_us = std::clamp<TimeUs>(options.step_us, 1, 1000);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    TruthState truth;
    truth.position = robots[i].start;
    truth.height_m = robots[i].height_m;
    truth.heading_rad = wrap_angle(robots[i].heading_rad);
    truth.battery = clamp(robots[i].battery, 0, 1);
    agents_.emplace_back(robots[i], truth, options, i);
    truths.push_back(truth);
    handles.emplace_back(*this, static_cast<int>(i));
  }
  find_next_event();
}

template <class Output>
void World<Output>::Impl::sense(int robot, Observation& observation) {
  const auto i = static_cast<std::size_t>(robot);
  Senses& senses = agents_[i].senses;
  const TruthState& truth = truths[i];
  observation.now_us = now_us;
  const Sample<Vec3>& position = senses.position.read(now_us, position_of(truth));
  const Sample<Vec3>& velocity = senses.velocity.read(now_us, velocity_of(truth));
  observation.position = {level(position.value), position.stamp_us};
  observation.velocity = {level(velocity.value), velocity.stamp_us};
  observation.height_m = position.value.z;
  observation.climb_mps = velocity.value.z;
  observation.heading = senses.heading.read(now_us, truth.heading_rad);
  observation.battery = senses.battery.read(now_us, truth.battery);
  radio_.receive(robot, now_us, observation);
}

template <class Output>
void World<Output>::Impl::actuate(int robot, const Output& output) {
  Agent<Output>& agent = agents_[static_cast<std::size_t>(robot)];
  const TimeUs due_us = now_us + std::max<TimeUs>(0, agent.setup.limits.latency_us);
  if (due_us <= now_us) {
    agent.acting = accepted(output);
  } else if (agent.commands.push(accepted(output), due_us)) {
    next_event_us_ = std::min(next_event_us_, due_us);
  } else {
    ++lost;
  }
}

template <class Output>
void World<Output>::Impl::announce(int robot, const Announcement& announcement) {
  const auto i = static_cast<std::size_t>(robot);
  Senses& senses = agents_[i].senses;
  Announcement sent = announcement;
  const Vec3 at = senses.position.measure(position_of(truths[i]), senses.odometry);
  const Vec3 moves = senses.velocity.measure(velocity_of(truths[i]), senses.odometry);
  sent.position = {level(at), now_us};
  sent.velocity = {level(moves), now_us};
  sent.height_m = at.z;
  sent.climb_mps = moves.z;
  if (!radio_.send(robot, sent, now_us)) ++lost;
}

template <class Output>
void World<Output>::Impl::inject(const Fault& fault) {
  if (fault.robot < 0 || static_cast<std::size_t>(fault.robot) >= agents_.size()) return;
  Senses& senses = agents_[static_cast<std::size_t>(fault.robot)].senses;
  switch (fault.sense) {
    case Sense::position:
      senses.position.inject(fault);
      break;
    case Sense::velocity:
      senses.velocity.inject(fault);
      break;
    case Sense::heading:
      senses.heading.inject(fault);
      break;
    case Sense::battery:
      senses.battery.inject(fault);
      break;
    case Sense::announcements:
      radio_.inject(fault);
      break;
  }
}

template <class Output>
void World<Output>::Impl::find_next_event() {
  next_event_us_ = INT64_MAX;
  for (const Agent<Output>& agent : agents_) {
    next_event_us_ = std::min(next_event_us_, agent.next_us());
  }
}

template <class Output>
void World<Output>::Impl::handle_events() {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    Agent<Output>& agent = agents_[i];
    if (agent.next_us() > now_us) continue;
    while (agent.commands.next_us() <= now_us) agent.acting = agent.commands.pop();
    agent.senses.take_due(now_us, truths[i]);
  }
  find_next_event();
}

template <class Output>
void World<Output>::Impl::move(Agent<Output>& agent, TruthState& truth, double dt_s) {
  const double driven_m = advance(agent.body, agent.acting, agent.setup.limits, dt_s);
  if (agent.setup.limits.disturbance_mps2 > 0) {
    agent.gusts.blow(agent.body, agent.setup.limits, now_us, dt_s);
  }
  const Body& body = agent.body;
  truth.position = to_vec2(body.position);
  truth.velocity = to_vec2(body.velocity);
  truth.height_m = body.position.z();
  truth.climb_mps = body.velocity.z();
  truth.heading_rad = body.heading_rad;
  truth.speed_mps = body.speed_mps;
  truth.turn_radps = body.turn_radps;
  truth.battery = next_battery(agent.setup, truth, truth.position, driven_m,
                               std::abs(body.speed_mps), dt_s, truth.charging);
}

template <class Output>
void World<Output>::Impl::step(TimeUs until_us) {
  const TimeUs grid_us = (now_us / options.step_us + 1) * options.step_us;
  const TimeUs next_us = std::min(std::min(until_us, grid_us), next_event_us_);
  const double dt_s = static_cast<double>(next_us - now_us) * us_to_s;
  for (std::size_t i = 0; i < agents_.size(); ++i) move(agents_[i], truths[i], dt_s);
  now_us = next_us;
  if (next_event_us_ <= now_us) handle_events();
  if (on_step) on_step(now_us);
}

template <class Output>
bool World<Output>::Impl::run_until(TimeUs time_us) {
  const TimeUs until_us = std::min(time_us, options.end_us);
  while (now_us < until_us && !stopped) step(until_us);
  return !stopped && time_us <= options.end_us;
}

template <class Output>
World<Output>::World(const std::vector<RobotSetup>& robots, const WorldOptions& options) {
  const std::size_t count = std::min(robots.size(), max_robots);
  impl_ = std::make_unique<Impl>(
      std::vector<RobotSetup>(robots.begin(), robots.begin() + static_cast<std::ptrdiff_t>(count)),
      options);
}

template <class Output>
World<Output>::~World() = default;

template <class Output>
RobotSdk<Output>& World<Output>::robot(int index) {
  return impl_->handles[static_cast<std::size_t>(index)];
}

template <class Output>
TimeUs World<Output>::now_us() const {
  return impl_->now_us;
}

template <class Output>
bool World<Output>::wait_until(TimeUs time_us) {
  return impl_->run_until(time_us);
}

template <class Output>
void World<Output>::stop() {
  impl_->stopped = true;
}

template <class Output>
void World<Output>::inject(const Fault& fault) {
  impl_->inject(fault);
}

template <class Output>
void World<Output>::on_step(std::function<void(TimeUs)> callback) {
  impl_->on_step.swap(callback);
}

template <class Output>
const TruthState& World<Output>::truth(int robot) const {
  return impl_->truths[static_cast<std::size_t>(robot)];
}

template <class Output>
const std::vector<TruthState>& World<Output>::truths() const {
  return impl_->truths;
}

template <class Output>
std::int64_t World<Output>::lost() const {
  return impl_->lost;
}

template class World<Acceleration>;
template class World<Twist>;

}  // namespace rtac::sim
