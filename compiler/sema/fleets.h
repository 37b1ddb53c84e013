// Fleets and sites: who there is, and the places that belong to them.
#pragma once

#include "compiler/sema/context.h"

namespace rtac::sema {

// Most robots of one kind: the runtime's tables of other robots have this many places.
inline constexpr int max_fleet = 256;
// Most agents of one declaration: each is judged on its own.
inline constexpr int max_agents = 64;

// The robot that `r1` or `bots[3]` names; otherwise reports what is wrong. `number`: null for none.
std::optional<RobotId> resolve_robot(Context& context, const syntax::Name& name,
                                     const syntax::Expr* number);

// The same of whatever is declared one by one or in numbered groups: an index in its list.
struct Numbered {
  Sort one, group;
  const std::vector<NumberedFleet>& groups;
  const char *a_one, *a_group,
      *member;         // "one robot, not a fleet", "a fleet, not one robot", "robot"
  std::string also{};  // what else than a number would help
};
std::optional<std::uint32_t> resolve_numbered(Context& context, const syntax::Name& name,
                                              const syntax::Expr* number, const Numbered& what);

// Finds the kind of every robot. Needs all names to be declared.
void check_fleets(Context& context, const syntax::Program& program);
// Fills the places of the sites. Needs the robots.
void check_sites(Context& context, const syntax::Program& program);

}  // namespace rtac::sema
