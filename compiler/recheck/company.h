// Who keeps what a property says of other robots and of agents, as it is written.
#pragma once

#include <optional>

#include "compiler/geometry/region.h"
#include "compiler/sema/spec.h"

namespace rtac::recheck {

// Whether nobody but the monitored robot can make the property false: what it says of other robots
// is a condition of each pair, the same seen from either (language rule 9.7), and it says nothing
// of agents, who obey no decision (rule 9.8).
bool kept_together(const sema::Spec& spec, const sema::Decision& decision,
                   const sema::Expr& property);

// Whether the fleet of a decision is one robot, and no more may join it.
bool is_alone(const sema::Spec& spec, const sema::Decision& decision);
// Whether there are other robots that it speaks of.
bool judges_robots(const sema::Spec& spec, const sema::Decision& decision,
                   const sema::Expr& property);
// Whether it says nothing but distances to agents, which templates keep where they move (rule 9.8).
bool asks_agents_only(const sema::Expr& property);

// The largest distance to another robot that a property asks for at least, of each of them;
// nullopt: it asks for none, or there is no other robot.
std::optional<Rational> distance_asked(const sema::Spec& spec, const sema::Decision& decision,
                                       const sema::Expr& property);
// How far apart the centres of two bodies of that radius may be in a zone, in m, by the box around
// it; infinite: it has no end.
double widest_apart(const geometry::Region& zone, double radius);

// Whether a recovery ends where the robot is charged; and whether it does nothing but go there, and
// whatever the property asks for the charge of a way is about that way.
bool ends_charged(const sema::Spec& spec, const sema::Decision& decision,
                  const sema::Controller& recovery);
bool goes_to_be_charged(const sema::Spec& spec, const sema::Decision& decision,
                        const sema::Controller& recovery, const sema::Expr& property);
// Whether others may keep a recovery waiting while it spends what a property says of charge: it
// moves among robots or agents that keep a distance. How long is declared (`held`, rule 6.7).
bool waits_for_others(const sema::Spec& spec, const sema::Decision& decision,
                      const sema::Controller& recovery, const sema::Expr& property);

}  // namespace rtac::recheck
