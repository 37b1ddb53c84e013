#include "compiler/verify/within_zones.h"

#include <algorithm>

#include "compiler/analysis/around.h"
#include "compiler/analysis/by_border.h"
#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/stays_put.h"
#include "compiler/analysis/straight_in.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"

namespace rtac::verify {
namespace {

// No place of a zone is so far from its boundary.
constexpr std::int64_t nowhere_mm = 1 << 30;

Claim contained(const Subject& s, ir::ZoneIndex inner, const analysis::Standoff& outer) {
  Claim claim{"contained", {{"inner", s.module[inner].name}, {"outer", s.module[outer.zone].name}}};
  // only where the robot need not have it where it sets out
  const bool deep = outer.mm > analysis::touching_mm && inner != outer.zone &&
                    analysis::lies_deep(s.module, s.exact, s.solid, inner, outer);
  if (deep) claim.values["standoff_mm"] = std::to_string(outer.mm);
  return claim;
}
// As deep at each height as the fence asks for where it lies so deep.
Claim level(const Subject& s, ir::ZoneIndex inner, const analysis::Standoff& outer) {
  Claim claim{"level", {{"inner", s.module[inner].name}, {"outer", s.module[outer.zone].name}}};
  const bool deep = outer.mm > analysis::touching_mm &&
                    analysis::lies_level(s.module, s.exact, s.solid, inner, outer);
  if (deep) claim.values["standoff_mm"] = std::to_string(outer.mm);
  return claim;
}
bool has(const ir::Block& property, bool (*is)(const ir::Op&)) {
  return std::any_of(property.values.begin(), property.values.end(),
                     [&](const ir::Value& v) { return is(v.op); });
}
bool has_choice(const ir::Block& property) {
  return has(property, [](const ir::Op& op) { return std::holds_alternative<ir::Or>(op); });
}
// What the recovery of monitor `k` has to stay in to keep a property: the zones that hold the robot
// wherever it holds; of an `or` all that it names, since the side that holds has to go on to hold,
// but where the recovery keeps some side or other. What speaks of zones that come and go is another
// matter (leaving.h).
struct Keeping {
  std::vector<analysis::Standoff> zones;  // with what is asked for beyond touching
  bool by_sides = false;
  std::vector<std::vector<ir::ZoneIndex>> either;  // zones of those that ask for more than speed
  bool received = false;                           // and a zone that is received
};
void ask_for(const Subject& s, std::size_t k, const ir::Block& block, ir::ValueId id, bool any,
             Keeping& asked) {
  const ir::Op& op = block[id].op;
  if (const auto* both = std::get_if<ir::And>(&op)) {
    ask_for(s, k, block, both->a, any, asked);
    ask_for(s, k, block, both->b, any, asked);
  } else if (analysis::speaks_of_windows(block, id)) {
    return;
  } else if (const auto* either = std::get_if<ir::Or>(&op)) {
    if (analysis::keeps_a_side(s.module, s.decision, s.exact, k, block, id)) {
      asked.by_sides = true;
      if (!analysis::has_slow_side(s.module, s.decision, k, block, *either)) {
        asked.either.push_back(analysis::sides_in_zones(s.module, s.decision, block, id));
      }
      return;
    }
    ask_for(s, k, block, either->a, true, asked);
    ask_for(s, k, block, either->b, true, asked);
  } else if (const auto* negated = std::get_if<ir::Not>(&op)) {
    ask_for(s, k, block, negated->a, true, asked);
  } else if (const ir::Block* body = ir::body_of(op)) {
    ask_for(s, k, *body, body->result, true, asked);
  } else if (const auto* compare = std::get_if<ir::AtLeast>(&op)) {
    for (const auto& [leaf, coefficient] : ir::linear_form(block, *compare).terms) {
      asked.received = asked.received || leaf.kind == ir::Leaf::Kind::received;
    }
    const auto least = ir::lower_bound(block, *compare, s.decision.facts.params);
    for (const auto& [leaf, coefficient] : ir::linear_form(block, *compare).terms) {
      if (leaf.kind != ir::Leaf::Kind::clearance) continue;
      const std::int64_t mm = least ? std::max<std::int64_t>(least->need.strictest, 0) : nowhere_mm;
      asked.zones.push_back({ir::ZoneIndex{leaf.table}, mm});
    }
  }
}
Keeping keeping_of(const Subject& s, std::size_t k, const ir::Block& property) {
  Keeping asked;
  ask_for(s, k, property, property.result, false, asked);
  return asked;
}
std::optional<analysis::Standoff> stays_put(const Subject& s, const ir::Monitor& driving,
                                            const ir::Recovery& step, const ir::Monitor& judged) {
  return analysis::stays_put(s.module, s.decision, s.exact, driving, step, judged);
}
// The steps of a recovery that move within a zone.
std::vector<const ir::Recovery*> moving_steps(const ir::Recovery& recovery) {
  std::vector<const ir::Recovery*> steps = ir::steps_of(recovery);
  std::erase_if(steps,
                [](const ir::Recovery* step) { return !ir::moves(step->kind) && !step->claims; });
  return steps;
}
// Those that set out where a property holds.
std::vector<const ir::Recovery*> leading_steps(const Subject& s, const ir::Monitor& driving,
                                               const ir::Monitor& judged) {
  std::vector<const ir::Recovery*> steps = moving_steps(driving.recovery);
  std::erase_if(steps, [&](const ir::Recovery* step) {
    return stays_put(s, driving, *step, judged).has_value();
  });
  return steps;
}
// What moves within a zone of the plane keeps its height, so that a fence need not have it at all
// heights; nobody claims that of what is external.
bool keeps_level(const Subject& s, const ir::Recovery& step, const analysis::Standoff& outer) {
  return !step.claims && analysis::lies_level(s.module, s.exact, s.solid, step.zone, outer);
}
// Anywhere in the zone of the step.
Doubt doubt_of_zone(const Subject& s, const analysis::TakeOver& take_over,
                    const ir::Monitor& driving, const ir::Recovery& step,
                    const analysis::Standoff& outer) {
  if (step.zone == outer.zone && !step.claims) return {};
  const std::string name = quoted(s.module[step.zone].name);
  const std::string outer_name = analysis::name_as_written(s.module[outer.zone]);
  const ir::Monitor& judged = take_over.decision.monitors[take_over.judged];
  if (!keeps_level(s, step, {outer.zone, 0}) && !lies_in(s, step.zone, outer.zone)) {
    return {has_choice(judged.property)
                ? "a way from one zone of the `or` to another is not shown to stay in one of them"
                : name + " does not lie in " + outer_name};
  }
  if (!analysis::keeps_off(s.module, s.decision, s.exact, s.solid, driving, judged, step, outer) &&
      !analysis::keeps_around(s.kind, s.module, s.decision, s.exact, driving, judged, outer)) {
    return {"places of " + name + " are nearer than " + metres(outer.mm) + " to the boundary of " +
            outer_name};
  }
  if (step.claims) return {};
  const auto missing = analysis::missing_to_come_in(take_over, step, outer.zone);
  if (!missing) return {};
  return {"from outside of " + name + " it makes straight for it, and is not shown to stay in " +
              outer_name + " on its way, which is not convex" +
              (missing->empty() ? "" : ": " + *missing),
          analysis::begins_inside(s.module[step.zone])};
}
// That it lies by the border of its zone; nullopt: that is not shown.
std::optional<Claim> by_border(const Subject& s, const analysis::TakeOver& take_over,
                               const ir::Monitor& driving, const analysis::Standoff& outer) {
  const ir::Recovery& retreat = ir::last_step(driving.recovery);
  const auto near_mm = analysis::by_border_mm(s.kind, take_over, driving);
  if (!near_mm || !analysis::border_lies_deep(take_over, retreat.zone, *near_mm, outer))
    return std::nullopt;
  const auto text = [](std::int64_t n) { return std::to_string(n); };
  Claim claim = with_ways(s,
                          {"by_border",
                           {{"decision", s.decision.name},
                            {"monitor", driving.name},
                            {"judged", s.decision.monitors[take_over.judged].name},
                            {"outer", s.module[outer.zone].name},
                            {"near_mm", text(*near_mm)},
                            {"extra_us", text(s.decision.return_extra_us)}}},
                          retreat);
  if (outer.mm > analysis::touching_mm) claim.values["standoff_mm"] = text(outer.mm);
  return claim;
}
// That it keeps off the boundary of a fence which it moves around.
Claim around(const Subject& s, const ir::Monitor& driving, const analysis::Standoff& outer) {
  return with_ways(s,
                   {"around",
                    {{"decision", s.decision.name},
                     {"monitor", driving.name},
                     {"outer", s.module[outer.zone].name},
                     {"standoff_mm", std::to_string(outer.mm)},
                     {"extra_us", std::to_string(s.decision.return_extra_us)}}},
                   ir::last_step(driving.recovery));
}
// Of one step and one zone that the property asks for.
Doubt doubt_of_step(const Subject& s, const analysis::TakeOver& take_over,
                    const ir::Monitor& driving, const ir::Recovery& step,
                    const analysis::Standoff& outer) {
  Doubt doubt = doubt_of_zone(s, take_over, driving, step, outer);
  if (doubt.why.empty() || by_border(s, take_over, driving, outer)) return {};
  return doubt;
}

}  // namespace

bool moves_within_zones(const ir::Recovery& recovery) {
  return !moving_steps(recovery).empty();
}

void claim_zones(const Subject& s, std::size_t k, std::size_t of, std::vector<Claim>& claims) {
  const ir::Monitor &driving = s.decision.monitors[k], &judged = s.decision.monitors[of];
  for (const ir::Recovery* step : moving_steps(driving.recovery)) {
    const auto around = stays_put(s, driving, *step, judged);
    if (around) claims.push_back(contained(s, around->zone, {step->zone, around->mm}));
  }
  const auto steps = leading_steps(s, driving, judged);
  const Keeping asked = keeping_of(s, k, judged.property);
  const analysis::ExactSolid solid = any_solid(s);
  const analysis::TakeOver take_over{s.module, s.decision, s.exact, solid, of, s.known.get()};
  for (const ir::Recovery* step : steps) {
    for (const analysis::Standoff& outer : asked.zones) {
      const ir::ZoneIndex inner = step->zone;
      if (!doubt_of_zone(s, take_over, driving, *step, outer).why.empty()) {
        if (auto claim = by_border(s, take_over, driving, outer)) {
          claims.push_back(std::move(*claim));
          continue;
        }
      }
      claims.push_back(keeps_level(s, *step, {outer.zone, 0}) ? level(s, inner, outer)
                                                              : contained(s, inner, outer));
      if (inner == outer.zone) continue;
      if (outer.mm > analysis::touching_mm &&
          analysis::lies_all_over(s.module, s.exact, s.solid, inner, outer.zone)) {
        claims.push_back(contained(s, outer.zone, {inner, 0}));
      }
      if (step->claims) continue;
      if (!analysis::keeps_off(s.module, s.decision, s.exact, s.solid, driving, judged, *step,
                               outer)) {
        claims.push_back(around(s, driving, outer));
      }
      claims.push_back(
          with_cells({"comes_in",
                      {{"decision", s.decision.name},
                       {"monitor", judged.name},
                       {"zone", s.module[inner].name},
                       {"aim_mm", std::to_string(analysis::aims_at_mm(s.decision, *step))},
                       {"fence", s.module[outer.zone].name}}},
                     s.module[inner]));
    }
  }
  if (!asked.by_sides) return;
  for (const ir::Recovery* step : steps) {
    claims.push_back(
        with_cells({"sides",
                    {{"decision", s.decision.name},
                     {"controller", driving.recovery.name},
                     {"monitor", judged.name},
                     {"zone", s.module[step->zone].name},
                     {"aim_mm", std::to_string(analysis::aims_at_mm(s.decision, *step))}}},
                   s.module[step->zone]));
  }
}

Doubt doubt_of_zones(const Subject& s, std::size_t k, std::size_t judged) {
  const Keeping asked = keeping_of(s, k, s.decision.monitors[judged].property);
  if (asked.received) return {"where the zone that is received will be is not known"};
  const analysis::ExactSolid solid = any_solid(s);
  const analysis::TakeOver take_over{s.module, s.decision, s.exact, solid, judged, s.known.get()};
  const ir::Monitor& driving = s.decision.monitors[k];
  const ir::Block& says = s.decision.monitors[judged].property;
  const bool faster = analysis::sets_out_faster(s.module, s.decision, k, says, says.result);
  for (const ir::Recovery* step : leading_steps(s, driving, s.decision.monitors[judged])) {
    if (faster && ir::moves(step->kind) && !analysis::starts_within(take_over, step->zone)) {
      return {"a robot outside of " + quoted(s.module[step->zone].name) +
                  " that is slow enough may be led from there, and faster than " +
                  quoted(s.decision.monitors[judged].name) + " allows",
              "a recovery that is as slow is needed, or " +
                  analysis::begins_inside(s.module[step->zone]),
              true};
    }
    for (const analysis::Standoff& outer : asked.zones) {
      Doubt doubt = doubt_of_step(s, take_over, driving, *step, outer);
      if (!doubt.why.empty()) return doubt;
    }
    if (ir::moves(step->kind) && !analysis::comes_in_by_sides(take_over, *step, asked.either)) {
      return {"from outside of " + quoted(s.module[step->zone].name) +
                  " it makes straight for it, and is not shown to stay in one zone of the `or`",
              analysis::begins_inside(s.module[step->zone])};
    }
  }
  return {};
}

}  // namespace rtac::verify
