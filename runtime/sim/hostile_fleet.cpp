#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "hostile_senses.h"
#include "rtac/sim/hostile.h"

namespace rtac::sim {
namespace {

constexpr std::uint64_t fleet_stream = 2002;

struct Message {
  TimeUs sent_us = never_us;
  Announcement content;
  [[nodiscard]] TimeUs oldest_us() const {
    return std::min(content.position.stamp_us, content.velocity.stamp_us);
  }
};

TimeUs longest_age(const RobotLimits& l) {
  return std::max(
      {l.position_age_us, l.velocity_age_us, l.heading_age_us, l.battery_age_us, l.hears_age_us});
}

}  // namespace

template <class Output>
class HostileFleet<Output>::Impl {
 public:
  Impl(World<Output>& world, const Arena& arena, const Hostility& hostility, Tape& tape,
       std::function<void(TimeUs)> on_step)
      : world_(world),
        arena_(arena),
        hostility_(hostility),
        tape_(tape),
        random_(Random::stream(hostility.seed, fleet_stream, 0)),
        log_(longest_age(arena.limits())),
        on_step_(std::move(on_step)) {
    const auto robots = static_cast<std::size_t>(arena.robots());
    for (int i = 0; i < arena.robots(); ++i) {
      senses_.emplace_back(arena, hostility, i);
      handles_.emplace_back(*this, i);
    }
    sent_.resize(robots);
    heard_.assign(robots, std::vector<Message>(robots));
    stepped(world.now_us());
    world.on_step([this](TimeUs now_us) { stepped(now_us); });
  }

  class Handle final : public RobotSdk<Output> {
   public:
    Handle(Impl& fleet, int robot) : fleet_(fleet), robot_(robot) {}
    void sense(Observation& observation) override { fleet_.sense(robot_, observation); }
    void actuate(const Output& output) override { fleet_.world_.robot(robot_).actuate(output); }
    void announce(const Announcement& announcement) override {
      fleet_.announce(robot_, announcement);
    }

   private:
    Impl& fleet_;
    int robot_;
  };
  RobotSdk<Output>& handle(int robot) { return handles_[static_cast<std::size_t>(robot)]; }
  [[nodiscard]] TimeUs now_us() const { return world_.now_us(); }
  bool wait_until(TimeUs time_us) {
    TimeUs late_us = hostility_.jitter_us > 0 ? random_.below(hostility_.jitter_us + 1) : 0;
    std::vector<std::int64_t> whole{time_us + late_us};
    std::vector<double> real;
    if (tape_.playing() && !next_wait(time_us, whole)) return false;
    tape_.write("wait", whole, real);
    return world_.wait_until(whole[0]);
  }

 private:
  // Of a tape: not before it is due, and no world has to run for ever.
  bool next_wait(TimeUs due_us, std::vector<std::int64_t>& whole) {
    constexpr TimeUs late_us_max = 86'400'000'000;
    std::vector<double> real;
    return tape_.read("wait", whole, real, 0) && whole[0] >= due_us &&
           whole[0] <= due_us + late_us_max;
  }
  void stepped(TimeUs now_us) {
    log_.push(now_us, world_.truths());
    if (on_step_) on_step_(now_us);
  }
  void sense(int robot, Observation& observation) {
    const TimeUs now = now_us();
    senses_[static_cast<std::size_t>(robot)].measure(now, log_, observation);
    std::vector<std::int64_t> whole{robot, observation.position.stamp_us,
                                    observation.velocity.stamp_us, observation.heading.stamp_us,
                                    observation.battery.stamp_us};
    std::vector<double> real{observation.position.value.x, observation.position.value.y,
                             observation.velocity.value.x, observation.velocity.value.y,
                             observation.heading.value,    observation.battery.value};
    const bool in_space = arena_.limits().in_space;
    if (in_space) real.insert(real.end(), {observation.height_m, observation.climb_mps});
    if (tape_.playing() && tape_.read("sense", whole, real, 1)) {
      if (in_space) {
        observation.height_m = real[6];
        observation.climb_mps = real[7];
      }
      observation.position = {{real[0], real[1]}, whole[1]};
      observation.velocity = {{real[2], real[3]}, whole[2]};
      observation.heading = {real[4], whole[3]};
      observation.battery = {real[5], whole[4]};
    }
    tape_.write("sense", whole, real);
    for (int j = 0; j < arena_.robots(); ++j) {
      if (j != robot) hear(robot, j, now, observation);
    }
  }
  void hear(int to, int from, TimeUs now, Observation& observation) {
    Message& heard = heard_[static_cast<std::size_t>(to)][static_cast<std::size_t>(from)];
    const std::deque<Message>& sent = sent_[static_cast<std::size_t>(from)];
    std::vector<std::int64_t> whole{to, from, choose(to, sent, heard, now)};
    std::vector<double> real;
    if (tape_.playing()) (void)tape_.read("hear", whole, real, 2);
    tape_.write("hear", whole, real);
    for (const Message& message : sent) {
      if (message.sent_us == whole[2] && message.sent_us > heard.sent_us) heard = message;
    }
    observation.others[static_cast<std::size_t>(from)] = heard.content;
  }
  // Which message is the newest that has arrived; never_us: none.
  TimeUs choose(int to, const std::deque<Message>& sent, const Message& heard, TimeUs now) {
    std::size_t first = 0;
    const TimeUs oldest_us = now - arena_.limits().hears_age_us;
    while (first < sent.size() &&
           (sent[first].sent_us < heard.sent_us || sent[first].oldest_us() < oldest_us)) {
      ++first;
    }
    if (first == sent.size() || senses_[static_cast<std::size_t>(to)].deaf(now)) {
      return heard.sent_us;
    }
    const auto count = static_cast<std::int64_t>(sent.size() - first);
    switch (hostility_.ages) {
      case Ages::fresh:
        return sent.back().sent_us;
      case Ages::oldest:
      case Ages::unequal:
        return sent[first].sent_us;
      case Ages::wandering:
        return sent[first + static_cast<std::size_t>(random_.below(count))].sent_us;
    }
    return heard.sent_us;
  }
  void announce(int robot, const Announcement& announcement) {
    Message message{now_us(), announcement};
    Announcement& a = message.content;
    const TimeUs max_age_us = arena_.limits().hears_age_us;
    senses_[static_cast<std::size_t>(robot)].announce(now_us(), log_, a);
    std::vector<std::int64_t> whole{robot, a.position.stamp_us, a.velocity.stamp_us};
    std::vector<double> real{a.position.value.x, a.position.value.y, a.velocity.value.x,
                             a.velocity.value.y};
    const bool in_space = arena_.limits().in_space;
    if (in_space) real.insert(real.end(), {a.height_m, a.climb_mps});
    if (tape_.playing() && tape_.read("announce", whole, real, 1)) {
      if (in_space) {
        a.height_m = real[4];
        a.climb_mps = real[5];
      }
      a.position = {{real[0], real[1]}, whole[1]};
      a.velocity = {{real[2], real[3]}, whole[2]};
    }
    tape_.write("announce", whole, real);
    std::deque<Message>& sent = sent_[static_cast<std::size_t>(robot)];
    while (sent.size() > 1 && sent[1].oldest_us() < now_us() - max_age_us) sent.pop_front();
    sent.push_back(message);
  }

  World<Output>& world_;
  const Arena& arena_;
  Hostility hostility_;
  Tape& tape_;
  Random random_;
  TruthLog log_;
  std::function<void(TimeUs)> on_step_;
  std::vector<HostileSenses> senses_;
  std::vector<Handle> handles_;
  std::vector<std::deque<Message>> sent_;
  std::vector<std::vector<Message>> heard_;  // by receiver, then sender
};

template <class Output>
HostileFleet<Output>::HostileFleet(World<Output>& world, const Arena& arena,
                                   const Hostility& hostility, Tape& tape,
                                   std::function<void(TimeUs)> on_step)
    : impl_(std::make_unique<Impl>(world, arena, hostility, tape, std::move(on_step))) {}

template <class Output>
HostileFleet<Output>::~HostileFleet() = default;

template <class Output>
RobotSdk<Output>& HostileFleet<Output>::robot(int index) {
  return impl_->handle(index);
}

template <class Output>
TimeUs HostileFleet<Output>::now_us() const {
  return impl_->now_us();
}

template <class Output>
bool HostileFleet<Output>::wait_until(TimeUs time_us) {
  return impl_->wait_until(time_us);
}

template class HostileFleet<Acceleration>;
template class HostileFleet<Twist>;

}  // namespace rtac::sim
