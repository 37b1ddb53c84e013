#include "compiler/verify/atoms.h"

#include <algorithm>
#include <initializer_list>

#include "compiler/ir/linear.h"

namespace rtac::verify {

Atoms atoms_of(const ir::Block& property) {
  Atoms atoms;
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
      switch (leaf.kind) {
        case ir::Leaf::Kind::battery:
          atoms.charge = true;
          break;
        case ir::Leaf::Kind::clearance:
          atoms.clearance = true;
          break;
        case ir::Leaf::Kind::distance:
          atoms.distance = true;
          break;
        case ir::Leaf::Kind::energy_to:
          atoms.energy = true;
          break;
        case ir::Leaf::Kind::count:
          atoms.others = true;
          break;
        case ir::Leaf::Kind::speed:
          atoms.speed = true;
          break;
        case ir::Leaf::Kind::altitude:
          atoms.altitude = true;
          break;
        case ir::Leaf::Kind::agent:
          atoms.agent = true;
          break;
        case ir::Leaf::Kind::received:
          atoms.received = true;
          break;
      }
    }
  });
  for (const ir::Value& v : property.values) {
    atoms.clearance = atoms.clearance || std::holds_alternative<ir::PlanInZone>(v.op);
  }
  return atoms;
}

namespace {

bool told_to_be(const ir::Block& block, ir::ValueId id, bool value) {
  const ir::Op& op = block[id].op;
  if (const auto* both = std::get_if<ir::And>(&op)) {
    const bool a = told_to_be(block, both->a, value), b = told_to_be(block, both->b, value);
    return value ? a && b : a || b;
  }
  if (const auto* either = std::get_if<ir::Or>(&op)) {
    const bool a = told_to_be(block, either->a, value), b = told_to_be(block, either->b, value);
    return value ? a || b : a && b;
  }
  if (const auto* negated = std::get_if<ir::Not>(&op)) return told_to_be(block, negated->a, !value);
  const auto* fact = std::get_if<ir::Fact>(&op);
  return fact != nullptr && !fact->of_robot;
}

bool asks_agents_only(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return asks_agents_only(block, v->a) && asks_agents_only(block, v->b);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  return compare != nullptr &&
         std::ranges::all_of(ir::linear_form(block, *compare).terms, [](const auto& term) {
           return term.first.kind == ir::Leaf::Kind::agent;
         });
}

}  // namespace

bool asks_agents_only(const ir::Block& property) {
  return asks_agents_only(property, property.result);
}

bool may_hold_by_inputs(const ir::Block& property) {
  return told_to_be(property, property.result, true);
}

bool judges_others(const ir::Block& property) {
  return std::ranges::any_of(property.values,
                             [](const ir::Value& v) { return ir::body_of(v.op) != nullptr; });
}

std::vector<std::string> lemmas_of(const Atoms& atoms, const ir::Decision& decision,
                                   const ir::Monitor& monitor) {
  std::vector<std::string> all;
  const auto add = [&](std::initializer_list<const char*> names) {
    all.insert(all.end(), names.begin(), names.end());
  };
  const ir::Body& body = decision.body;
  const bool places =
      atoms.clearance || atoms.received || atoms.distance || atoms.altitude || atoms.agent;
  if (atoms.only_facts()) return all;
  add({"norms", "quotients", "roots", "horizon", "unequal_stamps"});
  if (places || atoms.energy) {
    add({"drift", "stop_difference"});
    // of the bodies that are told accelerations, and those that are told speeds
    if (body.brake_late_ms > 0) {
      add({"sampled_brake", "hold"});
    } else {
      add({"unicycle"});
    }
    if (body.disturbance_mmps2 > 0) add({"stop_disturbed", "still_lag"});
  }
  if (atoms.clearance || atoms.received || atoms.altitude) add({"capsule", "disc", "distances"});
  if (atoms.distance || atoms.others) add({"capsule", "disc", "separation"});
  if (atoms.agent) add({"agent"});
  if (atoms.speed) add({"speed"});
  if (atoms.charge) add({"energy"});
  if (body.in_space && places) add({"space_tube"});
  if (body.in_space && (atoms.distance || atoms.others || atoms.agent)) add({"space_gap"});
  if (monitor.lookahead.command) add({"command_legs", "command_stops"});
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace rtac::verify
