#include "compiler/recheck/coordination.h"

#include <algorithm>
#include <variant>

#include "compiler/sema/visit.h"

namespace rtac::recheck {

bool answers_to_inputs(const sema::Expr& property) {
  bool found = false;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    const auto& n = e.node;
    found = found || std::holds_alternative<sema::InputRef>(n) ||
            std::holds_alternative<sema::AgeOf>(n) || std::holds_alternative<sema::SensedAge>(n) ||
            std::holds_alternative<sema::PointInside>(n) ||
            std::holds_alternative<sema::PointClearance>(n) ||
            std::holds_alternative<sema::TrailInside>(n) ||
            std::holds_alternative<sema::TrailClearance>(n) ||
            std::holds_alternative<sema::TrailDistance>(n) ||
            std::holds_alternative<sema::PathGiven>(n) ||
            std::holds_alternative<sema::ZoneOpen>(n) ||
            std::holds_alternative<sema::WhileOpen>(n) ||
            std::holds_alternative<sema::IsValue>(n) || std::holds_alternative<sema::SameValue>(n);
  });
  return found;
}

bool asks_by_inputs(const sema::Expr& property) {
  const auto* logic = std::get_if<sema::Logic>(&property.node);
  if (logic != nullptr && logic->op == sema::LogicOp::logical_and) {
    return std::ranges::any_of(logic->operands,
                               [](const sema::ExprPtr& each) { return asks_by_inputs(*each); });
  }
  return !sema::speaks_of_robot(property) && answers_to_inputs(property);
}

bool shown_to_keep(const sema::Spec& spec, const sema::Decision& d, const Part& part,
                   const sema::Monitor& driving, const sema::Monitor& judged) {
  if (!driving.recover) return false;
  if (judged.recover == driving.recover) return true;
  if (d.coordinated && answers_to_inputs(*judged.always)) return false;
  return std::any_of(part.entries.begin(), part.entries.end(), [&](const Entry& e) {
    return e.kind == "C" && e.monitor == judged.name && e.recovery == spec[*driving.recover].name &&
           is_shown(e) && speaks_of(e, driving) && claim_of(e, "outranks") == nullptr &&
           claim_of(e, "coordinated") == nullptr;
  });
}

namespace {

bool is_of_the_robot_alone(const sema::Spec& spec, const sema::Expr& property) {
  const auto is_known = [&](sema::ZoneId zone) {
    return !std::holds_alternative<sema::ZoneReceived>(spec[zone].value->node);
  };
  bool alone = true;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    if (const auto* signal = std::get_if<sema::SignalRef>(&e.node)) {
      alone = alone &&
              (signal->signal == sema::Signal::altitude || signal->signal == sema::Signal::speed);
    } else if (const auto* inside = std::get_if<sema::InsideZone>(&e.node)) {
      alone = alone && is_known(inside->zone);
    } else if (const auto* clearance = std::get_if<sema::Clearance>(&e.node)) {
      alone = alone && is_known(clearance->zone);
    } else {
      alone = alone && (std::holds_alternative<sema::Constant>(e.node) ||
                        std::holds_alternative<sema::ParamRef>(e.node) ||
                        std::holds_alternative<sema::Arithmetic>(e.node) ||
                        std::holds_alternative<sema::Compare>(e.node) ||
                        std::holds_alternative<sema::Logic>(e.node) ||
                        std::holds_alternative<sema::Math>(e.node));
    }
  });
  return alone;
}

}  // namespace

bool drives_on(const sema::Spec& spec, const sema::Decision& d, const Part& part,
               const sema::Monitor& driving, const sema::Monitor& judged) {
  const auto rank = [&](const sema::Monitor& m) {
    return std::ranges::find_if(d.priority, [&](sema::MonitorId id) { return &spec[id] == &m; });
  };
  return rank(judged) < rank(driving) && is_of_the_robot_alone(spec, *judged.always) &&
         shown_to_keep(spec, d, part, driving, judged);
}

bool in_circle(const sema::Spec& spec, const sema::Decision& d, const Part& part,
               const sema::Monitor& judged) {
  std::vector<const sema::Monitor*> left;
  for (const sema::MonitorId id : d.priority) {
    left.push_back(&spec[id]);
    if (left.back() == &judged) break;
  }
  // Again and again those are taken away whose recovery keeps all that are left. Who stays then, is
  // in a circle or leads to one.
  for (bool again = true; again;) {
    const std::vector<const sema::Monitor*> all = left;
    const auto keeps_all = [&](const sema::Monitor* m) {
      return std::all_of(all.begin(), all.end(), [&](const sema::Monitor* other) {
        return other == m || shown_to_keep(spec, d, part, *m, *other);
      });
    };
    again = std::erase_if(left, keeps_all) > 0;
  }
  return std::find(left.begin(), left.end(), &judged) != left.end();
}

}  // namespace rtac::recheck
