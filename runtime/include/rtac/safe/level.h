// Recoveries of robots in space that drive ways of the plane: after the brake they keep their
// height, and carry their hold along the ways that a manoeuvre finds over the cells of a zone of
// the plane, `Setting::zone`.
#pragma once

#include "rtac/safe/manoeuvre.h"
#include "rtac/safe/space.h"

namespace rtac::safe {

template <class Plan>
class Level final : public Carried {
 public:
  template <class... Extra>
  explicit Level(const Setting& setting, Extra... extra)
      : Carried(setting), plan_(setting, extra...) {}

  void engage(const Observation& observation) override {
    Carried::engage(observation);
    plan_.engage(observation);
  }
  // It looks anew, from the leg that it was stopped on: its manoeuvre has forgotten its way.
  void go_on(const Halt& halt) override {
    Carried::go_on(halt);
    drop_legs();
  }
  [[nodiscard]] bool holding() const override {
    return Carried::holding() && !plan_.wants_motion();
  }
  [[nodiscard]] bool blocked() const override { return plan_.blocked(); }
  [[nodiscard]] bool parked() const override { return plan_.parked(); }
  [[nodiscard]] bool errand() const override { return plan_.errand(); }
  [[nodiscard]] bool leads_in(const Observation& observation) const override {
    if constexpr (Plan::leads_in) {
      return can_steer(observation) && plan_.is_outside(observation.position.value);
    }
    return false;
  }
  [[nodiscard]] const Path* path() const override {
    return plan_.shown_way().finished() ? nullptr : &plan_.shown_way();
  }

 private:
  void choose(const Observation& observation, Gate gate) override {
    const bool rests = at_rest(observation);
    // From the place on its way, up and down as well: from where it is measured, or has come to
    // rest beside its leg, noise would carry it off way by way, and errors that last would keep it
    // from a site that its hold has come to.
    const Vec3 at = latched() ? on_way(observation) : position_of(observation);
    plan_.update(observation, {at.x, at.y}, gate, rests);
    if (!plan_.wants_motion()) {
      if (has_legs()) drop_legs();
    } else if (rests) {
      set_legs(level_legs(at.z));
    }
  }
  Legs level_legs(double height_m) {
    Legs legs;
    const Path& way = plan_.way();
    for (std::size_t i = way.index; i < way.points.size(); ++i) {
      (void)legs.push({way.points[i].x, way.points[i].y, height_m});  // there are no more than fit
    }
    return legs;
  }
  // A leg that leads away from a robot does so from where it begins on: what errors put the robot
  // beside it by does not count.
  [[nodiscard]] Vec3 set_out_from(const Observation& observation) const override {
    return on_leg(observation);
  }
  [[nodiscard]] Vec3 recede_from(const Announcement& other) const override {
    return place_of_held(other);
  }
  void leg_ended() override { ++plan_.way().index; }
  // Nothing leads from there to its way any more.
  void carried_off() override {
    plan_.way().points.clear();
    plan_.way().index = 0;
  }

  Plan plan_;
};

// Brake; then along the shortest way with enough clearance to the site, around HELD robots.
using RouteInSpace = Level<RouteManoeuvre>;
// Brake and hold; then make room where the order of the robots asks for it.
using YieldInSpace = Level<YieldManoeuvre>;

}  // namespace rtac::safe
