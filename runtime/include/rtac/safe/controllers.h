// The safe-controller templates: a manoeuvre that decides where to go and a pilot that moves.
#pragma once

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
  Output command(const Observation& observation, Gate gate) override {
    if (!pilot_.can_steer(observation)) return pilot_.brake_blind(observation);
    plan_.update(observation, gate, pilot_.latched());
    if (!plan_.wants_motion() || !allowed(observation, gate)) return pilot_.halt(observation);
    return pilot_.drive(observation, plan_.way());
  }
  [[nodiscard]] bool holding() const override { return pilot_.latched() && !plan_.wants_motion(); }
  [[nodiscard]] bool blocked() const override { return plan_.blocked(); }
  [[nodiscard]] bool parked() const override { return plan_.parked(); }
  [[nodiscard]] bool errand() const override { return plan_.errand(); }
  [[nodiscard]] const Path* path() const override {
    return plan_.shown_way().finished() ? nullptr : &plan_.shown_way();
  }

 private:
  [[nodiscard]] bool allowed(const Observation& observation, Gate gate) {
    if (gate == Gate::free) return true;
    if (gate == Gate::hold) return false;
    const Vec2 target = plan_.way().points[plan_.way().index];
    for (int j = 0; j < observation.robots; ++j) {
      const Announcement& other = observation.others[static_cast<std::size_t>(j)];
      if (j == observation.self || !is_held(other, observation.now_us)) continue;
      if (!pilot_.recedes(observation, target, other.position.value)) return false;
    }
    return true;
  }

  Plan plan_;
  Pilot<Output> pilot_;
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

}  // namespace rtac::safe
