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
      : spec_(spec), open_(spec[decision.kind].open_fleet) {
    for (const sema::Robot& robot : spec.robots) robots_ += robot.kind == decision.kind ? 1 : 0;
  }

  // As something that has to be true, or false.
  [[nodiscard]] bool keeps(const sema::Expr& e, bool value = true) const {
    if (!speaks_of_others(e)) return true;
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) {
      if (v->op == Op::logical_not) return keeps(*v->operands.front(), !value);
      const auto is = [&](const sema::ExprPtr& x) {
        return (v->op == Op::logical_and) == value ? keeps(*x, value) : of_both(*x, value);
      };
      const bool plain = v->op == Op::logical_and || v->op == Op::logical_or;
      return plain && std::ranges::all_of(v->operands, is);
    }
    if (const auto* v = std::get_if<sema::ForOthers>(&e.node)) {
      if (robots_ < 2) return true;
      // one other robot that cannot be away is all and some of them
      const bool of_all = v->universal == value || (robots_ == 2 && !open_);
      return of_all && keeps(*v->body, value);
    }
    return asks_for_distance(e, value) || any_number(e, value);
  }

 private:
  using Op = sema::LogicOp;
  // The same, whichever robot of the pair looks at the other one.
  [[nodiscard]] bool of_both(const sema::Expr& e, bool value) const {
    if (std::holds_alternative<sema::Truth>(e.node)) return true;
    const auto* v = std::get_if<sema::Logic>(&e.node);
    if (v == nullptr) return asks_for_distance(e, value);
    if (v->op == Op::logical_not) return of_both(*v->operands.front(), !value);
    const bool plain = v->op == Op::logical_and || v->op == Op::logical_or;
    return plain &&
           std::ranges::all_of(v->operands, [&](const auto& x) { return of_both(*x, value); });
  }
  // From the other robot at least so much, which is the same for both of them.
  [[nodiscard]] bool asks_for_distance(const sema::Expr& e, bool value) const {
    return least_distance(spec_, e, value).has_value();
  }
  // At most as many as there are is no condition.
  [[nodiscard]] bool any_number(const sema::Expr& e, bool value) const {
    const auto* v = std::get_if<sema::Compare>(&e.node);
    if (v == nullptr) return false;
    const bool counts = std::holds_alternative<sema::CountOthers>(v->left->node) ||
                        std::holds_alternative<sema::CountOthers>(v->right->node);
    if (robots_ < 2 && !open_) return counts;
    using Compared = sema::CompareOp;
    const bool at_most = (v->op == Compared::less || v->op == Compared::less_equal) == value;
    const bool strict = (v->op == Compared::less || v->op == Compared::greater) == value;
    const sema::Expr& number = at_most ? *v->left : *v->right;
    const sema::Expr& limit = at_most ? *v->right : *v->left;
    const auto* most = std::get_if<sema::Constant>(&limit.node);
    if (!std::holds_alternative<sema::CountOthers>(number.node) || most == nullptr) return false;
    return strict ? most->value > robots_ - 1 : most->value >= robots_ - 1;
  }

  const sema::Spec& spec_;
  const bool open_;
  int robots_ = 0;
};

// The distance from another robot that something asks for which has to be true, or false: of what
// has to hold at once the most, and of a choice the least.
std::optional<Rational> distance_of(const sema::Spec& spec, const sema::Expr& e, bool value) {
  if (const auto* others = std::get_if<sema::ForOthers>(&e.node)) {
    return others->universal == value ? distance_of(spec, *others->body, value) : std::nullopt;
  }
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr) return least_distance(spec, e, value);
  using Op = sema::LogicOp;
  if (logic->op == Op::logical_not) return distance_of(spec, *logic->operands.front(), !value);
  if (logic->op != Op::logical_and && logic->op != Op::logical_or) return std::nullopt;
  const bool at_once = (logic->op == Op::logical_and) == value;
  std::optional<Rational> found;
  for (const sema::ExprPtr& each : logic->operands) {
    const auto asked = distance_of(spec, *each, value);
    if (!asked && !at_once) return std::nullopt;
    if (asked && (!found || (at_once ? *asked > *found : *asked < *found))) found = asked;
  }
  return found;
}

}  // namespace

bool kept_together(const sema::Spec& spec, const sema::Decision& decision,
                   const sema::Expr& property) {
  return Company(spec, decision).keeps(property);
}

std::optional<Rational> distance_asked(const sema::Spec& spec, const sema::Decision& decision,
                                       const sema::Expr& property) {
  if (std::ranges::count(spec.robots, decision.kind, &sema::Robot::kind) < 2) return std::nullopt;
  return distance_of(spec, property, true);
}

bool is_alone(const sema::Spec& spec, const sema::Decision& decision) {
  return !spec[decision.kind].open_fleet &&
         std::ranges::count(spec.robots, decision.kind, &sema::Robot::kind) < 2;
}

bool judges_robots(const sema::Spec& spec, const sema::Decision& decision,
                   const sema::Expr& property) {
  bool speaks = false;
  sema::for_each_expr(property, [&](const sema::Expr& part) {
    speaks = speaks || std::holds_alternative<sema::ForOthers>(part.node) ||
             std::holds_alternative<sema::CountOthers>(part.node) ||
             std::holds_alternative<sema::Distance>(part.node);
  });
  return speaks && !is_alone(spec, decision);
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
