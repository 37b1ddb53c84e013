// How long a recovery takes for its way, once more, exactly, from how the pilots pace theirs
// (docs/templates.md, retreat and route). SI units.
#pragma once

#include <optional>

#include "compiler/sema/spec.h"

namespace rtac::recheck {

// From where it stands to the centre of a cell, and over those.
Rational joined_way(const Rational& way, const Rational& cell);
// From taking over at full speed until control is given back, at most, when the way over cells of
// `cell` is `way`. nullopt: it does not get on against what pushes it.
std::optional<Rational> return_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                       const sema::Controller& recovery, const Rational& cell,
                                       const Rational& way);
// The same of one that brakes alone, and how far it drives meanwhile, in m.
struct Stop {
  Rational seconds, metres;
};
Stop stop_of(const sema::RobotKind& kind, const sema::Decision& decision);
// The same of a retreat that takes one leg, no longer than `leg`.
std::optional<Rational> leg_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                    const sema::Controller& recovery, const Rational& leg);
// The same of one along a way that has so many legs, and is looked for so often.
std::optional<Rational> legs_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                     const sema::Controller& recovery, const Rational& cell,
                                     const Rational& way, int legs, int looks);
// What the price of a way over cells counts, which is driven at `speed`: nothing but the way.
std::optional<Rational> priced_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                       const Rational& speed, const Rational& cell,
                                       const Rational& way);
// How far a recovery drives until control is given back, past where that is, and in the steps
// before and as long as it circles afterwards, `after` the condition of return needs: along a way
// over cells of `cell` which begins beside it, or a leg.
std::optional<Rational> driven_metres(const sema::RobotKind& kind, const sema::Decision& decision,
                                      const sema::Controller& recovery,
                                      const std::optional<Rational>& cell, const Rational& way,
                                      const Rational& after);
// Whether a robot in space follows the holds that its recovery carries: its brake is not spent.
bool follows_its_hold(const sema::RobotKind& kind, const sema::Decision& decision,
                      const sema::Controller& recovery);
// From taking over at full speed until a way of `way` has been driven that has three legs at most.
// nullopt: as above, or it moves in space.
std::optional<Rational> leaving_seconds(const sema::RobotKind& kind, const sema::Decision& decision,
                                        const sema::Controller& recovery, const Rational& way);
// Whether each step of a recovery that drives gets on against what errs and pushes.
bool makes_way(const sema::RobotKind& kind, const sema::Decision& decision,
               const sema::Controller& recovery);
// What every way has room for beside it.
inline const Rational beside_least(1, 20);
// How far beside its leg a recovery of the plane comes that means to be so fast, what pushes it
// included; what does not get on has no way.
Rational beside_way(const sema::RobotKind& kind, const sema::Decision& decision,
                    const Rational& speed);
// How near to the end of its leg a recovery of the plane counts as having come there, in m.
double ends_within(const sema::RobotKind& kind, const sema::Decision& decision);
// How far beside its leg a point mass comes at most, what pushes it included. nullopt: as above, or
// it has wheels.
std::optional<Rational> beside_leg(const sema::RobotKind& kind, const sema::Decision& decision,
                                   const sema::Controller& recovery);

}  // namespace rtac::recheck
