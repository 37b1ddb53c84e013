#include "compiler/analysis/fences.h"

#include <algorithm>
#include <optional>

#include "compiler/analysis/paces.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/operands.h"

namespace rtac::analysis {
namespace {

using ir::Leaf;

void add(std::vector<ir::ZoneIndex>& zones, ir::ZoneIndex zone) {
  if (std::find(zones.begin(), zones.end(), zone) == zones.end()) zones.push_back(zone);
}

std::optional<ir::ZoneIndex> fence_of(const ir::Block& block, ir::ValueId id,
                                      const std::vector<ir::Param>& params) {
  const auto* compare = std::get_if<ir::AtLeast>(&block[id].op);
  const auto bound = compare ? ir::lower_bound(block, *compare, params) : std::nullopt;
  if (!bound || bound->leaf.kind != Leaf::Kind::clearance) return std::nullopt;
  return ir::ZoneIndex{bound->leaf.table};
}

std::optional<std::int64_t> speed_limit_of(const ir::Block& block, ir::ValueId id) {
  const auto* compare = std::get_if<ir::AtLeast>(&block[id].op);
  const auto most = compare ? ir::upper_bound(block, *compare) : std::nullopt;
  if (!most || most->leaf.kind != Leaf::Kind::speed) return std::nullopt;
  return most->most;
}

void collect(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
             std::vector<ir::ZoneIndex>& zones) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    collect(block, v->a, params, zones);
    collect(block, v->b, params, zones);
    return;
  }
  if (const auto zone = fence_of(block, id, params)) add(zones, *zone);
}

// Whether it holds where others are far, the battery is full, zones that come and go are gone, and
// the height is as all limits of it ask, which is how it is where control is given back.
bool holds_far(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return holds_far(block, v->a) && holds_far(block, v->b);
  }
  if (const auto* v = std::get_if<ir::Or>(&op)) {
    return holds_far(block, v->a) || holds_far(block, v->b);
  }
  if (const auto* others = std::get_if<ir::ForOthers>(&op)) {
    return others->universal && holds_far(*others->body, others->body->result);
  }
  if (const auto* v = std::get_if<ir::Not>(&op)) {
    return std::holds_alternative<ir::ZoneThere>(block[v->a].op);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return false;
  const auto terms = ir::linear_form(block, *compare).terms;
  return !terms.empty() && std::ranges::all_of(terms, [](const auto& term) {
    const Leaf::Kind kind = term.first.kind;
    return kind == Leaf::Kind::battery || kind == Leaf::Kind::energy_to ||
           kind == Leaf::Kind::distance || (kind == Leaf::Kind::agent && term.second > 0) ||
           kind == Leaf::Kind::count || kind == Leaf::Kind::altitude;
  });
}
// False: a branch is neither a zone nor apart from the robot, nor a limit of speed that is below
// `rest_mmps`, which nobody is seen to keep.
bool branches(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
              std::int64_t rest_mmps, Choice& choice) {
  const auto is_branch = [&](ir::ValueId side) {
    return branches(block, side, params, rest_mmps, choice);
  };
  if (const auto* v = std::get_if<ir::Or>(&block[id].op)) return is_branch(v->a) && is_branch(v->b);
  // of a zone that is there at times: where it may be, at the best
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    const auto there = [&](ir::ValueId side) {
      return std::holds_alternative<ir::ZoneThere>(block[side].op) || holds_far(block, side);
    };
    if (there(v->a)) return is_branch(v->b);
    return there(v->b) && is_branch(v->a);
  }
  const auto* negated = std::get_if<ir::Not>(&block[id].op);
  if (std::holds_alternative<ir::Fact>(block[negated ? negated->a : id].op)) {
    return true;
  }
  if (const auto most = speed_limit_of(block, id)) return *most < rest_mmps;
  const auto zone = fence_of(block, id, params);
  if (zone) add(choice, *zone);
  return zone.has_value();
}

void collect(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
             std::int64_t rest_mmps, std::vector<Choice>& choices) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    collect(block, v->a, params, rest_mmps, choices);
    collect(block, v->b, params, rest_mmps, choices);
  } else if (std::holds_alternative<ir::Or>(block[id].op)) {
    Choice choice;
    if (branches(block, id, params, rest_mmps, choice) && !choice.empty()) {
      choices.push_back(std::move(choice));
    }
  }
}

// What each value of a property speaks of.
struct Spoken {
  bool inputs = false, places = false, own_speed = false;
  bool given = false;  // charge, height, or how far an agent is: these suit where control returns
};
std::vector<Spoken> spoken_of(const ir::Block& block) {
  std::vector<Spoken> all;
  for (const ir::Value& value : block.values) {
    const ir::Op& op = value.op;
    Spoken own;
    if (const auto* fact = std::get_if<ir::Fact>(&op)) {
      own.inputs = !fact->of_robot;
      own.places = fact->of_robot;
    }
    own.inputs = own.inputs || std::holds_alternative<ir::InputTruth>(op) ||
                 std::holds_alternative<ir::InputIs>(op);
    own.places = own.places || std::holds_alternative<ir::Clearance>(op) ||
                 std::holds_alternative<ir::Distance>(op) ||
                 std::holds_alternative<ir::ForOthers>(op) ||
                 std::holds_alternative<ir::CountOthers>(op) ||
                 std::holds_alternative<ir::ReceivedClearance>(op);
    own.own_speed = std::holds_alternative<ir::Speed>(op);
    own.given =
        std::holds_alternative<ir::Battery>(op) || std::holds_alternative<ir::EnergyTo>(op) ||
        std::holds_alternative<ir::Altitude>(op) || std::holds_alternative<ir::AgentDistance>(op);
    if (const auto* others = std::get_if<ir::ForOthers>(&op)) {
      const Spoken of = spoken_of(*others->body)[static_cast<std::size_t>(others->body->result)];
      own.inputs = own.inputs || of.inputs;
      own.own_speed = own.own_speed || of.own_speed;
      own.given = own.given || of.given;
    }
    ir::for_each_operand(op, [&](const ir::ValueId id) {
      const Spoken& of = all[static_cast<std::size_t>(id)];
      own.inputs = own.inputs || of.inputs;
      own.places = own.places || of.places;
      own.own_speed = own.own_speed || of.own_speed;
      own.given = own.given || of.given;
    });
    all.push_back(own);
  }
  return all;
}
bool settled(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
             const AtRest& at_rest, const std::vector<Spoken>& spoken) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    return settled(block, v->a, params, at_rest, spoken) &&
           settled(block, v->b, params, at_rest, spoken);
  }
  const Spoken& of = spoken[static_cast<std::size_t>(id)];
  const bool either = std::holds_alternative<ir::Or>(block[id].op);
  const bool of_speeds = of.own_speed && !of.places && !of.inputs;
  if (either && of_speeds) return at_rest.holds(id) || (of.given && holds_far(block, id));
  if (!of.places || (!either && !of.inputs && !of.own_speed)) return true;
  if (!of.inputs && holds_far(block, id)) return true;
  Choice choice;
  return at_rest.holds(id) ||
         (branches(block, id, params, at_rest.mmps, choice) && !choice.empty());
}

// Whether a side of an `or` counts while inputs say so, and not otherwise.
bool waits_for_inputs(const ir::Block& block, ir::ValueId id) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    return waits_for_inputs(block, v->a) || waits_for_inputs(block, v->b);
  }
  if (const auto* v = std::get_if<ir::Or>(&block[id].op)) {
    return waits_for_inputs(block, v->a) && waits_for_inputs(block, v->b);
  }
  return told(block, id);
}

void collect_told(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
                  bool either, std::vector<ir::ZoneIndex>& zones) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    collect_told(block, v->a, params, either, zones);
    collect_told(block, v->b, params, either, zones);
  } else if (const auto* o = std::get_if<ir::Or>(&block[id].op)) {
    if (!waits_for_inputs(block, id)) return;
    collect_told(block, o->a, params, true, zones);
    collect_told(block, o->b, params, true, zones);
  } else if (either) {
    if (const auto zone = fence_of(block, id, params)) add(zones, *zone);
  }
}

// What a comparison surely leaves of a clearance; nothing: it may ask for none.
std::optional<Standoff> sure_of(const ir::Block& block, ir::ValueId id,
                                const std::vector<ir::Param>& params) {
  const auto* compare = std::get_if<ir::AtLeast>(&block[id].op);
  const auto bound = compare ? ir::lower_bound(block, *compare, params) : std::nullopt;
  if (!bound || bound->leaf.kind != Leaf::Kind::clearance || bound->need.laxest < 0) {
    return std::nullopt;
  }
  return Standoff{ir::ZoneIndex{bound->leaf.table}, bound->need.laxest};
}

// False: a branch may hold wherever the robot is.
bool sure_branches(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
                   std::vector<Standoff>& either) {
  if (const auto* v = std::get_if<ir::Or>(&block[id].op)) {
    return sure_branches(block, v->a, params, either) && sure_branches(block, v->b, params, either);
  }
  const auto sure = sure_of(block, id, params);
  if (sure) either.push_back(*sure);
  return sure.has_value();
}

void collect_sure(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
                  std::vector<std::vector<Standoff>>& all) {
  if (const auto* v = std::get_if<ir::And>(&block[id].op)) {
    collect_sure(block, v->a, params, all);
    collect_sure(block, v->b, params, all);
    return;
  }
  std::vector<Standoff> either;
  if (sure_branches(block, id, params, either)) all.push_back(std::move(either));
}

}  // namespace

std::vector<std::vector<Standoff>> surely_in(const ir::Block& property,
                                             const std::vector<ir::Param>& params) {
  std::vector<std::vector<Standoff>> all;
  collect_sure(property, property.result, params, all);
  return all;
}

std::vector<ir::ZoneIndex> sure_fences(const ir::Block& property,
                                       const std::vector<ir::Param>& params) {
  std::vector<ir::ZoneIndex> zones;
  for (const std::vector<Standoff>& either : surely_in(property, params)) {
    if (either.size() == 1) add(zones, either[0].zone);
  }
  return zones;
}

bool relied_on(const ir::Decision& decision, const ir::Monitor& monitor) {
  const auto accepted = [&](const ir::Acknowledgement& a) { return a.monitor == monitor.name; };
  return monitor.lookahead.duration && !monitor.lookahead.too_short &&
         std::ranges::none_of(decision.acknowledgements, accepted);
}

std::vector<ir::ZoneIndex> told_fences_of(const ir::Block& property,
                                          const std::vector<ir::Param>& params) {
  std::vector<ir::ZoneIndex> zones;
  collect_told(property, property.result, params, false, zones);
  return zones;
}

std::vector<ir::ZoneIndex> fences_of(const ir::Block& property,
                                     const std::vector<ir::Param>& params) {
  std::vector<ir::ZoneIndex> zones;
  collect(property, property.result, params, zones);
  return zones;
}

bool places_settle(const ir::Block& property, const std::vector<ir::Param>& params,
                   const AtRest& at_rest) {
  return settled(property, property.result, params, at_rest, spoken_of(property));
}

std::vector<Choice> choices_of(const ir::Block& property, const std::vector<ir::Param>& params,
                               std::int64_t rest_mmps) {
  std::vector<Choice> choices;
  collect(property, property.result, params, rest_mmps, choices);
  return choices;
}

Asks asks_of(const ir::Block& property, const std::vector<ir::Param>& params) {
  Asks asks;
  bool ceilings = false, others = false;
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    bool fences = false;
    for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
      const bool height = leaf.kind == Leaf::Kind::altitude;
      const auto most = height ? ir::upper_bound(block, compare) : std::nullopt;
      asks.clearance = asks.clearance || height;
      const bool of_zone = leaf.kind == Leaf::Kind::clearance || leaf.kind == Leaf::Kind::received;
      fences = fences || of_zone || leaf.kind == Leaf::Kind::distance;
      (most ? ceilings : others) |=
          height || of_zone || leaf.kind == Leaf::Kind::distance || leaf.kind == Leaf::Kind::agent;
    }
    const auto bound = ir::lower_bound(block, compare, params);
    if (!bound) {
      asks.other = asks.other || fences;
      return;
    }
    asks.clearance = asks.clearance || bound->leaf.kind == Leaf::Kind::clearance ||
                     bound->leaf.kind == Leaf::Kind::received;
    asks.distance = asks.distance || bound->leaf.kind == Leaf::Kind::distance;
  });
  asks.only_lower = ceilings && !others;
  return asks;
}

}  // namespace rtac::analysis
