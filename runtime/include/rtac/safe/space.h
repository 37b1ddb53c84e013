// Recoveries of robots in space that move: after the brake they carry the place of their hold along
// straight legs, and the robot follows it, by what its spring trails. Each leg ends at rest. A hold
// that leads the robot is no hold: whatever stops it on a leg begins with the brake.
#pragma once

#include "rtac/controller.h"
#include "rtac/safe/pilot.h"
#include "rtac/safe/setting.h"

namespace rtac::safe {

class Carried : public SafeController<Acceleration> {
 public:
  explicit Carried(const Setting& setting) : setting_(setting), pilot_(setting) {}
  void engage(const Observation& observation) override;
  void go_on(const Halt& halt) override;
  [[nodiscard]] std::optional<Halt> halt() const override;
  Acceleration command(const Observation& observation, Gate gate) override;
  [[nodiscard]] bool holding() const override { return pilot_.latched() && legs_.empty(); }

 protected:
  [[nodiscard]] bool can_steer(const Observation& observation) const {
    return pilot_.can_steer(observation);
  }
  // A way of the plane, and back to the leg that it was stopped on.
  static constexpr std::size_t legs_max = max_waypoints + 1;
  using Legs = FixedList<Vec3, legs_max>;  // their ends
  // In every tick in which it can steer: chooses its legs, where it has come to rest.
  virtual void choose(const Observation& observation, Gate gate);
  // Where to go from a place of rest, once a second at most; nowhere: it stays.
  virtual void look(TimeUs /*now_us*/, Vec3 /*from*/, Legs& /*legs*/) {}
  // The places from which, and away from which, the gate may ask that it recedes: where both robots
  // are measured, or where both holds are. What lasts, such as wind, moves both of them alike.
  [[nodiscard]] virtual Vec3 set_out_from(const Observation& observation) const;
  [[nodiscard]] virtual Vec3 recede_from(const Announcement& other) const;
  virtual void leg_ended() {}
  // It rests further off its leg than a stop explains.
  virtual void carried_off() {}
  // How far from where its legs end it may be measured, once it rests there.
  [[nodiscard]] double sway_m() const { return pilot_.sway_m(); }
  // How far beside its leg a stop leaves it at most.
  [[nodiscard]] double stray_m() const;

  [[nodiscard]] bool latched() const { return pilot_.latched(); }
  // Latched, slow enough to be driven off, and with a hold that is not carried anywhere.
  [[nodiscard]] bool at_rest(const Observation& observation) const {
    return !carries_ && pilot_.at_rest(observation);
  }
  [[nodiscard]] bool has_legs() const { return !legs_.empty(); }
  // The place of its hold, once it is latched.
  [[nodiscard]] Vec3 held() const { return pilot_.halting()->place; }
  // Errors may have put it beside its leg as it is measured: where it holds, or how far along its
  // leg it is.
  [[nodiscard]] Vec3 on_leg(const Observation& observation) const;
  // The same, or where on its leg it goes back to first.
  [[nodiscard]] Vec3 on_way(const Observation& observation) const;
  // From where it rests, once it is back on the leg that it was stopped on.
  void set_legs(const Legs& legs);
  // Brakes, and holds where that ends, until it is told of other legs.
  void drop_legs();

  Setting setting_;

 private:
  // Past robots that are HELD the gate lets it go only where that brings it nearer to none of them.
  [[nodiscard]] bool allowed(const Observation& observation, Gate gate) const;
  // What it makes for: first back to its leg, if it was stopped beside it.
  [[nodiscard]] Vec3 aim() const;
  void carry(const Observation& observation);
  // Where it holds if it is stopped while it has hardly left its hold: on its way, and no further
  // away than it sways. Else the brake comes first.
  [[nodiscard]] std::optional<Halt> hold_on_way() const;
  void hold_at(Vec3 place);
  void begin_leg();
  // Brakes, and latches where it comes to rest, if the hold leads the robot.
  void stop();
  void leave_far_leg();

  Pilot<Acceleration> pilot_;
  Legs legs_;
  std::size_t leg_ = 0;
  Vec3 leg_from_, leg_to_;    // that it drives, or was stopped on
  Vec3 return_from_;          // and from where it goes back to that
  std::optional<Vec3> near_;  // the place of its way that it has hardly left
  bool on_leg_ = false;
  Legs broken_off_;  // when it was engaged anew: another recovery may have driven in between
  bool leg_broken_off_ = false;
  bool leads_ = false;      // the hold is farther ahead of the robot than it sways
  bool carries_ = false;    // it moved the hold in the last tick, and not to its end
  bool stopped_ = false;    // on its leg, and it has not come to rest since
  bool returning_ = false;  // to its leg
  TimeUs next_look_us_ = never_us;
};

// Up or down, and then on that level, to the nearest place from which control can be given back
// that it sees, never closer to the boundary than now, or than it may be; from outside back in the
// same way. In a zone of the plane, `Setting::zone`, it keeps its height.
class RetreatInSpace : public Carried {
 public:
  using Carried::Carried;
  [[nodiscard]] bool leads_in(const Observation& observation) const override;

 protected:
  void look(TimeUs now_us, Vec3 from, Legs& legs) override;
};

// Retreats, rests long enough for control to be given back, and then drives level laps around the
// place of rest, or first goes where there is room for them, with a rest after each. Every point of
// a lap is a place where control can be given back: its radius is the clearance that is left over.
class LoiterInSpace final : public RetreatInSpace {
 public:
  using RetreatInSpace::RetreatInSpace;
  void engage(const Observation& observation) override;

 private:
  void look(TimeUs now_us, Vec3 from, Legs& legs) override;
  static void lap(Vec3 centre, double radius_m, Legs& legs);

  TimeUs rests_since_us_ = never_us;
};

// Straight down to `Setting::land_at_m`, and stays there. From below it stays where it is.
class Land final : public Carried {
 public:
  using Carried::Carried;

 private:
  void look(TimeUs now_us, Vec3 from, Legs& legs) override;
};

}  // namespace rtac::safe
