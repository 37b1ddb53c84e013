// Properties with `or`, as they are written: which zones a recovery has to stay in to keep one, and
// whether a robot that has come to rest is given back by one.
#pragma once

#include <vector>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// What a recovery has to stay in to keep a property; `by_sides`: some `or` is kept as one side of
// it always holds, whose zones are none of these, but those of `either`, of each `or` of which no
// side asks for no more than to be slow; `faster`: some `or` of zones and speeds holds of a robot
// that is slower than the recovery, wherever that is; `windows`: some part speaks of zones that
// come and go, which is a matter of leading out (leaving.h).
struct Keeping {
  std::vector<sema::ZoneId> zones;
  std::vector<std::vector<sema::ZoneId>> either;
  bool by_sides = false, faster = false, windows = false;
};

class Sides {
 public:
  Sides(const sema::Spec& spec, const sema::Decision& decision, Claims& claims);
  Keeping keeping(const sema::Controller& recovery, const sema::Expr& property);
  // That every body in a zone lies in one of others.
  bool in_one_of(sema::ZoneId own, const std::vector<sema::ZoneId>& zones) {
    return one_holds(own, zones, numbers_.radius);
  }
  // That a straight way from a body in one of the zones to one in another leads over such bodies
  // alone, of each of these.
  bool straight_between(const std::vector<std::vector<sema::ZoneId>>& either);
  // That a recovery is no faster than the limits of a property that count wherever the robot is,
  // and whatever it is told, unless another recovery takes over.
  bool keeps_limits(const sema::Controller& recovery, const sema::Expr& property, bool taken_over);
  // That a property holds of whoever drives as slowly as a recovery, wherever and whatever it is
  // told.
  bool holds_of_slow(const sema::Controller& recovery, const sema::Expr& property);
  // That the robot of a monitor is given back where its recovery has come to rest as clear of the
  // boundary of its zone as control returns at, `extra` s further ahead: by what the property says
  // of zones, and of speeds. Inputs are taken as they come.
  bool gives_back(const sema::Monitor& m, const Rational& extra);
  // The same wherever it has come to rest, and whatever others do.
  bool holds_at_rest(const sema::Monitor& m, const Rational& extra);
  // The same whatever keeps it moving there.
  bool holds_in_hold(const sema::Monitor& m, const Rational& extra);
  // That who is braked and held fulfils a property from when it stands on, whoever comes near.
  bool holds_held(const sema::Expr& property);
  // That each part of what it says of agents holds where they are far, and of whoever is held.
  bool slow_beside_agents(const sema::Expr& property);
  // The same as at rest of a part of what it says.
  bool holds_at_rest(const sema::Expr& part, const sema::Monitor& m, const Rational& extra);
  // That this is a limit of speed that a robot at rest is seen to exceed, as far as it looks ahead.
  bool is_exceeded_at_rest(const sema::Expr& part, const sema::Monitor& m, const Rational& extra);
  // How fast a robot that rests may be as far as a monitor looks ahead, `extra` s further, in m/s.
  [[nodiscard]] Rational from_rest(const sema::Monitor& m, const Rational& extra) const {
    return rests_of(m, extra).from_rest;
  }
  // That a recovery is slow enough for a property of speeds and inputs alone, but where inputs ask
  // for so little speed that a robot at rest stays there until they change.
  bool keeps_while_told(const sema::Controller& recovery, const sema::Monitor& m,
                        const Rational& extra);

 private:
  struct Part {
    const sema::Expr* expr;
    bool value;  // it has to be true, or false
  };
  struct Split {
    bool all = false, any = false;  // of the parts; neither: it is no connective of these
    std::vector<Part> parts;
  };
  static Part plain(Part part);
  static Split split(const Part& part);
  static std::optional<Part> of_each(const Part& part);
  static bool speaks_of_inputs(const Part& part);
  bool holds_far_from_agents(const Part& part);
  bool slow_beside_agents(const Part& part);
  // From when a brake has turned into a hold on.
  [[nodiscard]] Rational fastest_held() const;
  void collect(const sema::Controller& recovery, const Part& part, bool either, Keeping& asked);
  bool is_faster(const sema::Controller& recovery, const Part& part);
  bool is_slow(const sema::Controller& recovery, const Split& parts);
  bool keeps_a_side(const sema::Controller& recovery, const Part& part, const Split& parts);
  // How fast a recovery truly drives; nullopt: that is an external one's own.
  [[nodiscard]] std::optional<Rational> speed_of(const sema::Controller& recovery) const;
  // The same, of an external one as fast as it claims.
  [[nodiscard]] std::optional<Rational> claimed_speed_of(const sema::Controller& recovery) const;
  // The same of one that means to drive at `speed`.
  [[nodiscard]] Rational while_driving(const Rational& speed) const;
  bool within_limits(const Part& part, const Rational& speed, bool taken_over);
  bool keeps_each(const Part& part, const Rational& speed);
  bool slow(const Part& part, const Rational& speed);
  // What inputs are taken to say.
  using Told = std::vector<std::pair<const sema::Expr*, bool>>;
  bool slow(const Part& part, const Rational& speed, Told& told);
  bool slow_if(const Part& part, const Rational& speed, const Told& told);
  static std::optional<bool> as_told(const Part& part, const Told& told);
  // The first that they say nothing of; null: there is none.
  static const sema::Expr* said_by_inputs(const Part& part, const Told& told);
  bool slow_while_told(const Part& part, const Rational& speed, const Rational& from_rest);
  bool waits(const Part& part, const Rational& from_rest);
  bool slow_side(const Part& part, const Rational& speed);
  bool zones_of(const Part& part, std::vector<sema::ZoneId>& zones);
  // Every disc in the zone lies in one of the zones.
  bool one_holds(sema::ZoneId own, const std::vector<sema::ZoneId>& zones, const Rational& radius);
  // `slow`: it holds at rest, and may not as soon as the robot speeds up; `until_told`: that is so
  // as long as inputs say so
  enum class Back { yes, no, told, slow, until_told };
  struct Rests {
    const sema::Monitor& monitor;
    std::optional<sema::ZoneId> own;
    Rational extra, clearance, from_rest, from_hold;
  };
  [[nodiscard]] Rests rests_of(const sema::Monitor& m, const Rational& extra) const;
  Back back(const Rests& rests, const Part& part, bool either);
  Back back_of_leaf(const Rests& rests, const Part& part, bool either);
  [[nodiscard]] bool asks_for_charge(const Part& part) const;

  const sema::Spec& spec_;
  const sema::Decision& decision_;
  Claims& claims_;
  Numbers numbers_;
  int robots_ = 0;
};

// Whether a robot at rest may exceed what a monitor allows, wherever it is and whatever it is told,
// as far as that looks ahead.
bool too_fast_at_rest(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                      const sema::Monitor& m);

}  // namespace rtac::recheck
