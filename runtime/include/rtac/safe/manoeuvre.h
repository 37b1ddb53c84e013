// What a recovery wants to do, apart from how the robot moves: the part of the safe-controller
// templates that does not depend on the kind of output.
#pragma once

#include "rtac/decision.h"
#include "rtac/safe/grid_route.h"
#include "rtac/safe/setting.h"
#include "rtac/types.h"

namespace rtac::safe {

// The other robot promised not to leave its hold before now, and says where that is.
bool is_held(const Announcement& other, TimeUs now_us);
// Where it stays, of one that is HELD: the place that it holds, or else where it is measured.
Vec3 place_of_held(const Announcement& other);

// Where others see it: of one that is HELD that place, whatever is measured meanwhile. Of two that
// look at what is measured, each at a time of its own, errors may show each of them that only the
// other one has a way.
Vec2 seen_at(const Announcement& other, TimeUs now_us);

// A robot that goes first, is HELD and found no way past the others; -1: none.
int asks_for_passage(const Observation& observation);
// Distance from `place` to the rest of a robot's announced way, its position included.
double distance_to_way(Vec2 place, const Announcement& other, TimeUs now_us);

class Manoeuvre {
 public:
  // At rest, from the place that it holds, as others see it, or else from where it is measured.
  static constexpr bool looks_from_hold = false;
  static constexpr bool stands = false, leads_in = true;

  explicit Manoeuvre(const Setting& setting) : setting_(setting), route_(*setting.zone) {}
  virtual ~Manoeuvre() = default;

  virtual void engage(const Observation& observation) = 0;
  // Every tick on which the robot can be steered. `at`: where it looks from. `at_rest`: the pilot
  // has latched its hold.
  void update(const Observation& observation, Vec2 at, Gate gate, bool at_rest) {
    at_ = at;
    decide(observation, gate, at_rest);
  }

  [[nodiscard]] bool wants_motion() const { return !way_.finished(); }
  Path& way() { return way_; }
  // The way it follows, or would follow if robots did not stand there.
  [[nodiscard]] virtual const Path& shown_way() const { return way_; }
  [[nodiscard]] virtual bool blocked() const { return false; }
  [[nodiscard]] virtual bool parked() const { return false; }
  [[nodiscard]] virtual bool errand() const { return false; }
  [[nodiscard]] bool is_outside(Vec2 place) const {
    return signed_clearance(*setting_.zone, place) < setting_.limits.radius_m;
  }

 protected:
  virtual void decide(const Observation& observation, Gate gate, bool at_rest) = 0;
  void stay() {
    way_.points.clear();
    way_.index = 0;
  }
  // A query from where it looks; HELD robots as circles of the pass gap, if wanted.
  [[nodiscard]] RouteQuery query(const Observation& observation, bool around_held) const;
  // Heads for the nearest place that nobody is near, and nowhere nearer to HELD robots: over cells,
  // or first along the wall, where it stands too near to that for cells to lead on.
  bool get_away(const Observation& observation, const PlaceTest& aside);
  // Heads for the nearest place out of the way of a robot that asks for passage; stays when this is
  // one already, or when there is none.
  void make_passage(const Observation& observation, Gate gate, int asker);

  Setting setting_;
  GridRoute route_;
  Path way_;
  Vec2 at_;

 private:
  bool leave_along_wall(const RouteQuery& away, const PlaceTest& aside);
};

// Stands where the pilot has brought it to rest; makes way for nobody.
class BrakeManoeuvre {
 public:
  static constexpr bool looks_from_hold = false;
  static constexpr bool stands = true, leads_in = false;

  explicit BrakeManoeuvre(const Setting&) {}
  void engage(const Observation&) {}
  void update(const Observation&, Vec2, Gate, bool) {}
  [[nodiscard]] static bool wants_motion() { return false; }
  Path& way() { return nowhere_; }
  [[nodiscard]] const Path& shown_way() const { return nowhere_; }
  [[nodiscard]] static bool blocked() { return false; }
  [[nodiscard]] static bool parked() { return false; }
  [[nodiscard]] static bool errand() { return false; }

 private:
  Path nowhere_;
};

class RetreatManoeuvre : public Manoeuvre {
 public:
  explicit RetreatManoeuvre(const Setting& setting) : RetreatManoeuvre(setting, 0) {}
  void engage(const Observation& observation) override;

 protected:
  // `room_m`: how much more clearance than it needs it would like to have.
  RetreatManoeuvre(const Setting& setting, double room_m) : Manoeuvre(setting), room_m_(room_m) {}
  void decide(const Observation& observation, Gate gate, bool at_rest) override;
  // At rest, with control not given back.
  virtual void look(const Observation& observation);

 private:
  bool find(const RouteQuery& query, double clearance_now_m, double wanted_m);
  bool find_straight(const RouteQuery& query, double clearance_now_m, double wanted_m);
  void run_out(const RouteQuery& query);

  double room_m_;
  TimeUs next_look_us_ = never_us;
};

// Retreats, and then drives laps around a place of rest, with a stop after each. Every point of a
// lap is a place where control can be given back: its radius is the clearance that is left over.
class LoiterManoeuvre : public RetreatManoeuvre {
 public:
  // The largest radius of a lap, and the least one worth driving, in metres.
  static constexpr double radius_m_max = 0.5, radius_m_min = 0.1;

  explicit LoiterManoeuvre(const Setting& setting) : RetreatManoeuvre(setting, radius_m_max) {}
  void engage(const Observation& observation) override;

 protected:
  void look(const Observation& observation) override;

 private:
  bool lap(const RouteQuery& from_here, double radius_m);

  TimeUs rests_since_us_ = never_us;
};

class RouteManoeuvre : public Manoeuvre {
 public:
  RouteManoeuvre(const Setting& setting, Vec2 site) : Manoeuvre(setting), site_(site) {}
  void engage(const Observation& observation) override;
  [[nodiscard]] const Path& shown_way() const override { return blocked_ ? blocked_way_ : way_; }
  [[nodiscard]] bool blocked() const override { return blocked_; }
  [[nodiscard]] bool parked() const override { return parked_; }
  [[nodiscard]] bool errand() const override { return true; }

 private:
  void decide(const Observation& observation, Gate gate, bool at_rest) override;
  void look(const Observation& observation);
  [[nodiscard]] bool goes_on() const;
  void count_driven(const Observation& observation, bool at_rest);
  [[nodiscard]] RouteQuery around_robots(const Observation& observation, bool held_only) const;
  [[nodiscard]] bool meets_held(const Observation& observation) const;

  Vec2 site_;
  Path blocked_way_;
  // Where the way that it follows was cut off, if it was.
  Vec2 joint_;
  bool cut_ = false;
  bool blocked_ = false, parked_ = false;
  TimeUs next_look_us_ = never_us;
  // The direct way when it first looked, and what it has driven since: a way around robots must fit
  // into the rest of the allowed detour.
  double direct_m_ = -1, driven_m_ = 0;
  TimeUs driven_until_us_ = never_us;
};

class YieldManoeuvre : public Manoeuvre {
 public:
  static constexpr bool looks_from_hold = true;
  static constexpr bool leads_in = false;  // for others alone
  using Manoeuvre::Manoeuvre;
  void engage(const Observation& observation) override;
  // It should back off and has no place to go: the others have to move.
  [[nodiscard]] bool blocked() const override { return cornered_; }

 private:
  void decide(const Observation& observation, Gate gate, bool at_rest) override;
  // The robot that it makes way for; -1: none.
  [[nodiscard]] int makes_way_for(const Observation& observation) const;
  // Nobody has made way for as long as any other wait lasts.
  [[nodiscard]] bool waits_in_vain(const Observation& observation) const;
  // This robot has to make the room: all close robots are HELD, and it goes first, or has waited
  // for those that do in vain.
  [[nodiscard]] bool must_back_off(const Observation& observation) const;
  void back_off(const Observation& observation);
  void reconsider(const Observation& observation, Gate gate);
  void start_waiting(const Observation& observation);

  bool cornered_ = false;
  TimeUs held_since_us_ = never_us;     // at rest without a wish to move
  TimeUs wanting_since_us_ = never_us;  // at rest, wanting to move
  TimeUs next_look_us_ = never_us;
};

}  // namespace rtac::safe
