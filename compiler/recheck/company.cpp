#include "compiler/recheck/company.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/sums.h"
#include "compiler/recheck/zones.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

bool speaks_of_others(const sema::Expr& e) {
  bool found = false;
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    found = found || std::holds_alternative<sema::ForOthers>(part.node) ||
            std::holds_alternative<sema::CountOthers>(part.node) ||
            std::holds_alternative<sema::Distance>(part.node) ||
            std::holds_alternative<sema::AgentDistance>(part.node);
  });
  return found;
}

class Company {
 public:
  Company(const sema::Spec& spec, const sema::Decision& decision)
      : open_(spec[decision.kind].open_fleet) {
    for (const sema::Robot& robot : spec.robots) robots_ += robot.kind == decision.kind ? 1 : 0;
  }

  [[nodiscard]] bool keeps(const sema::Expr& e) const {
    if (!speaks_of_others(e)) return true;
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) {
      const auto is = [&](const sema::ExprPtr& x) {
        return v->op == sema::LogicOp::logical_and ? keeps(*x) : of_both(*x);
      };
      const bool plain = v->op == sema::LogicOp::logical_and || v->op == sema::LogicOp::logical_or;
      return plain && std::ranges::all_of(v->operands, is);
    }
    if (const auto* v = std::get_if<sema::ForOthers>(&e.node)) {
      if (robots_ < 2) return true;
      // one other robot that cannot be away is all and some of them
      return (v->universal || (robots_ == 2 && !open_)) && keeps(*v->body);
    }
    const auto* compare = std::get_if<sema::Compare>(&e.node);
    return compare != nullptr && (compares_pair(*compare) || any_number(*compare));
  }

 private:
  // The same, whichever robot of the pair looks at the other one.
  [[nodiscard]] static bool of_both(const sema::Expr& e) {
    if (std::holds_alternative<sema::Truth>(e.node)) return true;
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) {
      const bool plain = v->op == sema::LogicOp::logical_and || v->op == sema::LogicOp::logical_or;
      return plain && std::ranges::all_of(v->operands, [](const auto& x) { return of_both(*x); });
    }
    const auto* compare = std::get_if<sema::Compare>(&e.node);
    return compare != nullptr && compares_pair(*compare);
  }
  // A distance between robots, with what is the same for both of them.
  static bool compares_pair(const sema::Compare& v) {
    bool distance = false, other = false;
    for (const sema::Expr* side : {v.left.get(), v.right.get()}) {
      sema::for_each_expr(*side, [&](const sema::Expr& e) {
        if (std::holds_alternative<sema::Distance>(e.node)) {
          distance = true;
        } else {
          other = other || (!std::holds_alternative<sema::Constant>(e.node) &&
                            !std::holds_alternative<sema::ParamRef>(e.node) &&
                            !std::holds_alternative<sema::Arithmetic>(e.node));
        }
      });
    }
    return distance && !other;
  }
  // At most as many as there are is no condition.
  [[nodiscard]] bool any_number(const sema::Compare& v) const {
    const bool counts = std::holds_alternative<sema::CountOthers>(v.left->node) ||
                        std::holds_alternative<sema::CountOthers>(v.right->node);
    if (robots_ < 2 && !open_) return counts;
    using Op = sema::CompareOp;
    const bool at_most = v.op == Op::less || v.op == Op::less_equal;
    const sema::Expr& number = at_most ? *v.left : *v.right;
    const sema::Expr& limit = at_most ? *v.right : *v.left;
    const auto* most = std::get_if<sema::Constant>(&limit.node);
    if (!std::holds_alternative<sema::CountOthers>(number.node) || most == nullptr) return false;
    const bool strict = v.op == Op::less || v.op == Op::greater;
    return strict ? most->value > robots_ - 1 : most->value >= robots_ - 1;
  }

  const bool open_;
  int robots_ = 0;
};

}  // namespace

bool kept_together(const sema::Spec& spec, const sema::Decision& decision,
                   const sema::Expr& property) {
  return Company(spec, decision).keeps(property);
}

std::optional<Rational> distance_asked(const sema::Spec& spec, const sema::Decision& decision,
                                       const sema::Expr& property) {
  if (std::ranges::count(spec.robots, decision.kind, &sema::Robot::kind) < 2) return std::nullopt;
  const auto* logic = std::get_if<sema::Logic>(&property.node);
  std::optional<Rational> most;
  const auto take = [&](const std::optional<Rational>& asked) {
    if (asked && (!most || *asked > *most)) most = asked;
  };
  if (logic != nullptr && logic->op == sema::LogicOp::logical_and) {
    for (const sema::ExprPtr& each : logic->operands) take(distance_asked(spec, decision, *each));
  }
  const auto* others = std::get_if<sema::ForOthers>(&property.node);
  if (others != nullptr && others->universal) take(distance_asked(spec, decision, *others->body));
  take(least_distance(spec, property));
  return most;
}

bool judges_robots(const sema::Spec& spec, const sema::Decision& decision,
                   const sema::Expr& property) {
  const bool alone = !spec[decision.kind].open_fleet &&
                     std::ranges::count(spec.robots, decision.kind, &sema::Robot::kind) < 2;
  bool speaks = false;
  sema::for_each_expr(property, [&](const sema::Expr& part) {
    speaks = speaks || std::holds_alternative<sema::ForOthers>(part.node) ||
             std::holds_alternative<sema::CountOthers>(part.node) ||
             std::holds_alternative<sema::Distance>(part.node);
  });
  return speaks && !alone;
}

bool asks_agents_only(const sema::Expr& property) {
  if (const auto* logic = std::get_if<sema::Logic>(&property.node)) {
    return logic->op == sema::LogicOp::logical_and &&
           std::ranges::all_of(logic->operands,
                               [](const auto& each) { return asks_agents_only(*each); });
  }
  if (!std::holds_alternative<sema::Compare>(property.node)) return false;
  bool only = true;
  sema::for_each_expr(property, [&](const sema::Expr& part) {
    only = only && (std::holds_alternative<sema::Compare>(part.node) ||
                    std::holds_alternative<sema::Arithmetic>(part.node) ||
                    std::holds_alternative<sema::Constant>(part.node) ||
                    std::holds_alternative<sema::AgentDistance>(part.node));
  });
  return only;
}

double widest_apart(const geometry::Region& zone, double radius) {
  double left = 1e300, right = -1e300, low = 1e300, top = -1e300;
  if (!has_end(zone)) return std::numeric_limits<double>::infinity();
  for (const geometry::Ring& ring : zone.rings()) {
    for (const geometry::Point& p : ring) {
      left = std::min(left, p.x.get_d()), right = std::max(right, p.x.get_d());
      low = std::min(low, p.y.get_d()), top = std::max(top, p.y.get_d());
    }
  }
  return std::hypot(std::max(right - left - 2 * radius, 0.0),
                    std::max(top - low - 2 * radius, 0.0));
}

bool ends_charged(const sema::Spec& spec, const sema::Decision& decision,
                  const sema::Controller& recovery) {
  const auto& energy = spec[decision.kind].energy;
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  if (!energy || steps.empty()) return false;
  const auto* const last = std::get_if<sema::Route>(&steps.back());
  return last != nullptr && last->site == energy->charge_at;
}

bool goes_to_be_charged(const sema::Spec& spec, const sema::Decision& decision,
                        const sema::Controller& recovery, const sema::Expr& property) {
  const auto& energy = spec[decision.kind].energy;
  const bool goes = sema::route_of(recovery) && ends_charged(spec, decision, recovery);
  bool there = goes;
  sema::for_each_expr(property, [&](const sema::Expr& e) {
    const auto* const way = std::get_if<sema::EnergyTo>(&e.node);
    there = there && (way == nullptr || way->site == energy->charge_at);
  });
  return there;
}

bool waits_for_others(const sema::Spec& spec, const sema::Decision& decision,
                      const sema::Controller& recovery, const sema::Expr& property) {
  const sema::RobotKind& kind = spec[decision.kind];
  if (!kind.energy || moves_within(recovery).empty() || !sema::speaks_of_charge(property)) {
    return false;
  }
  const auto robots = std::ranges::count(spec.robots, decision.kind, &sema::Robot::kind);
  const bool company = robots > 1 || kind.open_fleet;
  return std::ranges::any_of(decision.priority, [&](sema::MonitorId id) {
    const sema::Expr& kept = *spec[id].always;
    return (company && sema::speaks_of<sema::Distance>(kept)) ||
           sema::speaks_of<sema::AgentDistance>(kept);
  });
}

}  // namespace rtac::recheck
