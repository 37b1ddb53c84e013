// The safe-controller templates: a manoeuvre that decides where to go and a pilot that moves.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rtac/controller.h"
#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/pilot.h"

namespace rtac::safe {

// Brakes first, whatever it was doing; moves only as the gate allows; brakes blind when it cannot
// see. Bounded time, no allocation after construction.
template <class Output, class Plan>
class Driven : public SafeController<Output> {
 public:
  template <class... Extra>
  explicit Driven(const Setting& setting, Extra... extra)
      : plan_(setting, extra...), pilot_(setting) {}

  void engage(const Observation& observation) override {
    pilot_.engage(observation);
    plan_.engage(observation);
  }
  void go_on(const Halt& halt) override { pilot_.go_on(halt); }
  [[nodiscard]] std::optional<Halt> halt() const override { return pilot_.halting(); }
  Output command(const Observation& observation, Gate gate) override {
    if (!pilot_.can_steer(observation)) return pilot_.brake_blind(observation);
    const Vec2 at = Plan::looks_from_hold ? pilot_.on_way(observation) : observation.position.value;
    plan_.update(observation, at, gate, pilot_.at_rest(observation));
    if (!plan_.wants_motion() || !allowed(observation, at, gate)) return pilot_.halt(observation);
    return pilot_.drive(observation, at, plan_.way());
  }
  [[nodiscard]] bool holding() const override { return pilot_.latched() && !plan_.wants_motion(); }
  [[nodiscard]] bool blocked() const override { return plan_.blocked(); }
  [[nodiscard]] bool parked() const override { return plan_.parked(); }
  [[nodiscard]] bool errand() const override { return plan_.errand(); }
  [[nodiscard]] bool stands() const override { return Plan::stands; }
  [[nodiscard]] bool leads_in(const Observation& observation) const override {
    if constexpr (Plan::leads_in) {
      return pilot_.can_steer(observation) && plan_.is_outside(observation.position.value);
    }
    return false;
  }
  [[nodiscard]] const Path* path() const override {
    return plan_.shown_way().finished() ? nullptr : &plan_.shown_way();
  }

 private:
  [[nodiscard]] bool allowed(const Observation& observation, Vec2 at, Gate gate) {
    if (gate == Gate::free) return true;
    if (gate == Gate::hold) return false;
    const Vec2 target = plan_.way().points[plan_.way().index];
    for (int j = 0; j < observation.robots; ++j) {
      const Announcement& other = observation.others[static_cast<std::size_t>(j)];
      if (j == observation.self || !is_held(other, observation.now_us)) continue;
      const Vec2 there = seen_at(other, observation.now_us);
      if (!pilot_.recedes(observation, at, target, there)) return false;
    }
    return true;
  }

  Plan plan_;
  Pilot<Output> pilot_;
};

// Brake, and hold the place. P2b: control returns only where the robot happens to stop with enough
// clearance.
template <class Output>
class BrakeAndHold : public Driven<Output, BrakeManoeuvre> {
 public:
  explicit BrakeAndHold(const Setting& setting) : Driven<Output, BrakeManoeuvre>(setting) {}
};

// Brake; then to the nearest place from which control can be given back, never closer to the
// boundary than now; from outside straight back in. P2b: control returns where the zone has such a
// place; where it has none it holds.
template <class Output>
class Retreat : public Driven<Output, RetreatManoeuvre> {
 public:
  explicit Retreat(const Setting& setting) : Driven<Output, RetreatManoeuvre>(setting) {}
};

// Brake; then along the shortest way with enough clearance to the site, around HELD robots.
template <class Output>
class Route : public Driven<Output, RouteManoeuvre> {
 public:
  Route(const Setting& setting, Vec2 site) : Driven<Output, RouteManoeuvre>(setting, site) {}
};

// Brake and hold; then make room where the order of the robots asks for it.
template <class Output>
class Yield : public Driven<Output, YieldManoeuvre> {
 public:
  explicit Yield(const Setting& setting) : Driven<Output, YieldManoeuvre>(setting) {}
};

// As retreat; then, for as long as control is not given back, laps around the place of rest, with a
// stop after each.
template <class Output>
class Loiter : public Driven<Output, LoiterManoeuvre> {
 public:
  explicit Loiter(const Setting& setting) : Driven<Output, LoiterManoeuvre>(setting) {}
};

template <class Output>
struct Step {  // of a sequence
  std::unique_ptr<SafeController<Output>> controller;
  TimeUs lasts_us;  // not of the last step
};
// `Controller`: a template of this file, with the arguments of its constructor.
template <template <class> class Controller, class Output, class... Arguments>
Step<Output> step(TimeUs lasts_us, Arguments&&... arguments) {
  return {std::make_unique<Controller<Output>>(std::forward<Arguments>(arguments)...), lasts_us};
}

// One after the other: each lasts its time from when it took over, the last one until control is
// given back. Every step brakes first. A robot that is outside of where it is led does not stand
// there first (language rule 11).
template <class Output>
class Sequence : public SafeController<Output> {
 public:
  template <class... Steps>
  explicit Sequence(Step<Output> first, Steps... rest) {
    steps_.push_back(std::move(first));
    (steps_.push_back(std::move(rest)), ...);
  }

  // At least one step.
  explicit Sequence(std::vector<Step<Output>> steps) : steps_(std::move(steps)) {}

  void engage(const Observation& observation) override {
    at_ = 0;
    std::size_t moves = 0;
    while (moves + 1 < steps_.size() && steps_[moves].controller->stands()) ++moves;
    if (steps_[moves].controller->leads_in(observation)) at_ = moves;
    begin(observation);
  }
  void go_on(const Halt& halt) override { now().go_on(halt); }
  [[nodiscard]] std::optional<Halt> halt() const override { return now().halt(); }
  Output command(const Observation& observation, Gate gate) override {
    if (at_ + 1 < steps_.size() && observation.now_us - since_us_ >= steps_[at_].lasts_us) {
      const std::optional<Halt> before = now().halt();
      ++at_;
      begin(observation);
      if (before) now().go_on(*before);
    }
    return now().command(observation, gate);
  }
  [[nodiscard]] bool holding() const override { return now().holding(); }
  [[nodiscard]] bool blocked() const override { return now().blocked(); }
  [[nodiscard]] bool parked() const override { return now().parked(); }
  [[nodiscard]] bool errand() const override { return now().errand(); }
  [[nodiscard]] const Path* path() const override { return now().path(); }

 private:
  [[nodiscard]] SafeController<Output>& now() const { return *steps_[at_].controller; }
  void begin(const Observation& observation) {
    since_us_ = observation.now_us;
    now().engage(observation);
  }

  std::vector<Step<Output>> steps_;
  std::size_t at_ = 0;
  TimeUs since_us_ = 0;
};

}  // namespace rtac::safe
