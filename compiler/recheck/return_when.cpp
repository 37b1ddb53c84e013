#include "compiler/recheck/return_when.h"

#include <algorithm>

#include "compiler/recheck/numbers.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

class Condition {
 public:
  Condition(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
            const sema::Monitor& monitor, const Rational& left)
      : spec_(spec),
        claims_(claims),
        monitor_(monitor),
        recovery_(spec[*monitor.recover]),
        left_(left),
        numbers_(numbers_of(spec[decision.kind], decision, 0)) {
    for (const sema::Robot& robot : spec.robots) robots_ += robot.kind == decision.kind ? 1 : 0;
  }

  // Of what is negated nothing but inputs.
  bool comes_about(const sema::Expr& e) {
    if (!sema::speaks_of_robot(e)) return true;
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) return logic(*v);
    if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) return comes_about(*v->operand);
    if (const auto* v = std::get_if<sema::Past>(&e.node)) {
      return (v->interval.to || v->op == sema::PastOp::once) && comes_about(*v->operand);
    }
    if (std::holds_alternative<sema::ForOthers>(e.node)) return robots_ < 2;
    if (const auto* v = std::get_if<sema::InsideZone>(&e.node)) return clear(v->zone, 0);
    const auto* compare = std::get_if<sema::Compare>(&e.node);
    return compare != nullptr && compares(*compare);
  }

 private:
  bool logic(const sema::Logic& v) {
    const auto is = [&](const sema::ExprPtr& operand) { return comes_about(*operand); };
    if (v.op == sema::LogicOp::logical_and) return std::ranges::all_of(v.operands, is);
    if (v.op == sema::LogicOp::logical_or) return std::ranges::any_of(v.operands, is);
    if (v.op == sema::LogicOp::implies) return is(v.operands[1]);
    const auto* compare = v.op == sema::LogicOp::logical_not
                              ? std::get_if<sema::Compare>(&v.operands[0]->node)
                              : nullptr;
    return compare != nullptr && compared(*compare->right, *compare->left, *compare);
  }
  bool compares(const sema::Compare& v) { return compared(*v.left, *v.right, v); }
  // `left` op `right`, or the other way round of what is negated.
  bool compared(const sema::Expr& left, const sema::Expr& right, const sema::Compare& v) {
    const bool at_least =
        v.op == sema::CompareOp::greater || v.op == sema::CompareOp::greater_equal;
    const sema::Expr& large = at_least ? left : right;
    const sema::Expr& small = at_least ? right : left;
    if (const auto* clearance = std::get_if<sema::Clearance>(&large.node)) {
      const auto least = most_of(small);
      return least && clear(clearance->zone, *least);
    }
    const auto is = [](const sema::Expr& x, sema::Signal wanted) {
      const auto* signal = std::get_if<sema::SignalRef>(&x.node);
      return signal != nullptr && signal->signal == wanted;
    };
    if (is(large, sema::Signal::battery)) return charges();
    if (is(small, sema::Signal::speed)) {
      const auto* most = std::get_if<sema::Constant>(&large.node);
      return most != nullptr && most->value >= numbers_.velocity_error;
    }
    if (is(large, sema::Signal::altitude) || is(small, sema::Signal::altitude)) return height();
    return false;
  }
  // A limit that does not depend on what is measured, whatever its parameter becomes.
  [[nodiscard]] std::optional<Rational> most_of(const sema::Expr& e) const {
    if (const auto* v = std::get_if<sema::Constant>(&e.node)) return v->value;
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) return spec_[v->param].most.value;
    return std::nullopt;
  }
  // Where charge is taken up, it is taken up until it is enough; that there is enough is for errors
  // to say (5007).
  [[nodiscard]] bool charges() const {
    const auto way = sema::route_of(recovery_);
    const auto& energy = spec_[monitor_.kind].energy;
    return way && energy && energy->charge_at == way->site;
  }
  bool height() {
    const auto within = moves_within(recovery_);
    if (within.empty()) return false;
    const auto solid = claims_.zones().solid(within.back());
    if (!solid || solid->slabs().empty()) return false;
    const Rational errs = seen(0) - numbers_.radius, rest = left_ - errs;
    return keeps_heights(*monitor_.return_when, true, solid->slabs().front().floor + rest, 0) &&
           keeps_heights(*monitor_.return_when, true, solid->slabs().back().ceiling - rest, 0);
  }
  // The clearance of a centre at which every sample shows, as old as it may be, that a body at rest
  // is `gap` from the boundary.
  [[nodiscard]] Rational seen(const Rational& gap) const {
    return gap + numbers_.radius + 2 * numbers_.position_error +
           numbers_.velocity_error * numbers_.position_age;
  }
  bool clear(sema::ZoneId zone, const Rational& gap) {
    const auto within = moves_within(recovery_);
    if (within.empty()) return false;
    const Rational need = seen(gap), more = need - left_;
    if (within.back() == zone) return more <= 0;
    const geometry::Region* const own = claims_.zones().region(within.back());
    const geometry::Region* const out = claims_.zones().region(zone);
    if (own == nullptr || out == nullptr) {
      const auto small = claims_.zones().solid(within.back()), large = claims_.zones().solid(zone);
      return more <= 0 && small && large && small->subtract(*large).empty();
    }
    if (more <= 0 ? out->contains(*own) : out->shrink(more).contains(*own)) return true;
    const auto way = sema::route_of(recovery_);
    return way && std::ranges::all_of(spec_[way->site].places, [&](const auto& place) {
             return claims_.zones().clear(zone, {place.position.x, place.position.y}, need);
           });
  }

  const sema::Spec& spec_;
  Claims& claims_;
  const sema::Monitor& monitor_;
  const sema::Controller& recovery_;
  const Rational left_;
  const Numbers numbers_;
  int robots_ = 0;
};

}  // namespace

bool lets_go(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
             const sema::Monitor& monitor, const Rational& left) {
  if (monitor.return_when == nullptr) return true;
  return Condition(spec, decision, claims, monitor, left).comes_about(*monitor.return_when);
}

}  // namespace rtac::recheck
