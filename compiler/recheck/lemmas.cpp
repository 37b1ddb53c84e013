#include "compiler/recheck/lemmas.h"

#include <initializer_list>

#include "compiler/recheck/numbers.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

struct Spoken {
  bool zones = false, heights = false, robots = false, agents = false, speeds = false,
       charge = false, ways = false;
};
template <class Node>
bool is(const sema::Expr& e) {
  return std::holds_alternative<Node>(e.node);
}
Spoken spoken_in(const sema::Expr& property) {
  Spoken of;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    of.zones = of.zones || is<sema::Clearance>(e) || is<sema::InsideZone>(e);
    of.robots = of.robots || is<sema::Distance>(e);
    of.agents = of.agents || is<sema::AgentDistance>(e);
    of.ways = of.ways || is<sema::EnergyTo>(e);
    if (const auto* of_robot = std::get_if<sema::SignalRef>(&e.node)) {
      of.heights = of.heights || of_robot->signal == sema::Signal::altitude;
      of.speeds = of.speeds || of_robot->signal == sema::Signal::speed;
      of.charge = of.charge || of_robot->signal == sema::Signal::battery;
    }
  });
  return of;
}

}  // namespace

std::set<std::string> lemmas_for(const sema::Spec& spec, const sema::Decision& decision,
                                 const sema::Monitor& monitor) {
  const sema::RobotKind& kind = spec[decision.kind];
  const Numbers n = numbers_of(spec, decision, jitter_of(spec, decision));
  const Spoken of = spoken_in(*monitor.always);
  const bool walls = of.zones || of.heights, others = of.robots || of.agents;
  const bool places = walls || others;
  std::set<std::string> all;
  const auto add = [&](bool needed, std::initializer_list<const char*> names) {
    if (needed) all.insert(names.begin(), names.end());
  };
  add(places || of.speeds || of.charge,
      {"norms", "quotients", "roots", "horizon", "unequal_stamps"});
  const bool moves = places || of.ways;
  add(moves, {"drift", "stop_difference"});
  add(moves && n.unicycle, {"unicycle"});
  add(moves && !n.unicycle, {"sampled_brake", "hold"});
  add(moves && n.disturbance > 0, {"stop_disturbed", "still_lag"});
  add(walls, {"capsule", "disc", "distances"});
  add(of.robots, {"capsule", "disc", "separation"});
  add(of.agents, {"agent"});
  add(of.speeds, {"speed"});
  add(of.charge, {"energy"});
  add(kind.in_space && places, {"space_tube"});
  add(kind.in_space && others, {"space_gap"});
  add(monitor.ahead.command, {"command_legs", "command_stops"});
  return all;
}

}  // namespace rtac::recheck
