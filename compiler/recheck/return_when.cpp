#include "compiler/recheck/return_when.h"

#include <algorithm>
#include <utility>

#include "compiler/interp/number.h"
#include "compiler/recheck/at_place.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/sums.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// Whether a part of it looks back without an end.
bool remembers(const sema::Expr& e) {
  bool found = false;
  sema::for_each_expr(e, [&](const sema::Expr& part) {
    const auto* const past = std::get_if<sema::Past>(&part.node);
    const auto* const of = std::get_if<sema::Aggregate>(&part.node);
    found = found || (past != nullptr && !past->interval.to) || (of != nullptr && !of->interval.to);
  });
  return found;
}
bool comes_again(const sema::Expr& e, bool value);
bool comes_again(const sema::Logic& v, bool value) {
  using Op = sema::LogicOp;
  const auto is = [&](std::size_t k, bool wanted) { return comes_again(*v.operands[k], wanted); };
  const auto each = [&](const sema::ExprPtr& x) { return comes_again(*x, value); };
  switch (v.op) {
    case Op::logical_not:
      return is(0, !value);
    case Op::implies:
      return value ? is(0, false) || is(1, true) : is(0, true) && is(1, false);
    case Op::logical_and:
    case Op::logical_or:
      return (v.op == Op::logical_and) == value ? std::ranges::all_of(v.operands, each)
                                                : std::ranges::any_of(v.operands, each);
    case Op::iff:
    case Op::logical_xor:
      break;
  }
  const bool same = (v.op == Op::iff) == value;
  return (is(0, true) || is(1, !same)) && (is(0, false) || is(1, same));
}
// What inputs say may be so again, whatever they have said before; not where one moment of an
// endless past decides it.
bool comes_again(const sema::Expr& e, bool value) {
  if (const auto* v = std::get_if<sema::Logic>(&e.node)) return comes_again(*v, value);
  if (const auto* v = std::get_if<sema::Past>(&e.node)) {
    const bool decides = !v->interval.to && (v->op == sema::PastOp::once) != value;
    return !decides && comes_again(*v->operand, value);
  }
  if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) return comes_again(*v->operand, value);
  if (const auto* v = std::get_if<sema::Previously>(&e.node))
    return comes_again(*v->operand, value);
  if (const auto* v = std::get_if<sema::Since>(&e.node)) {
    return comes_again(*v->left, value) && comes_again(*v->right, value);
  }
  if (const auto* v = std::get_if<sema::WithinOf>(&e.node)) {
    return comes_again(*v->operand, value) && comes_again(*v->trigger, !value);
  }
  return !remembers(e);
}

class Condition {
 public:
  Condition(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
            const sema::Monitor& monitor, const Rational& left)
      : spec_(spec),
        decision_(decision),
        claims_(claims),
        monitor_(monitor),
        recovery_(spec[*monitor.recover]),
        left_(left),
        numbers_(numbers_of(spec, decision, 0)) {
    for (const sema::Robot& robot : spec.robots) robots_ += robot.kind == decision.kind ? 1 : 0;
    alone_ = robots_ < 2 && !spec[decision.kind].open_fleet;
  }

  bool comes_about(const sema::Expr& e) { return comes_about(e, true); }
  bool holds_at(const sema::Expr& e, const geometry::Point& at, const std::optional<Rational>& z) {
    at_ = at;
    z_ = z;
    return comes_about(e, true);
  }

 private:
  // That `e` becomes true, or false.
  bool comes_about(const sema::Expr& e, bool value) {
    if (!sema::speaks_of_robot(e)) return at_ || comes_again(e, value);
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) return logic(*v, value);
    if (const auto* v = std::get_if<sema::Compare>(&e.node)) return compares(*v, value);
    if (!value) return false;
    if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) return lasts(*v->operand);
    if (const auto* v = std::get_if<sema::Previously>(&e.node)) return lasts(*v->operand);
    if (const auto* v = std::get_if<sema::Past>(&e.node)) {
      if (v->op == sema::PastOp::once && v->interval.from.value == 0) {
        return comes_about(*v->operand, true);
      }
      return (v->interval.to || v->op == sema::PastOp::once) && lasts(*v->operand);
    }
    if (const auto* v = std::get_if<sema::ForOthers>(&e.node)) {
      if (at_ && !alone_) return v->universal && comes_about(*v->body, true);
      return v->universal && (robots_ < 2 || at_);
    }
    const auto* inside = std::get_if<sema::InsideZone>(&e.node);
    return inside != nullptr && clear(inside->zone, 0);
  }
  // What has to have been so at other moments than this one.
  bool lasts(const sema::Expr& e) {
    const bool before = std::exchange(lasts_, true);
    const bool found = comes_about(e, true);
    lasts_ = before;
    return found;
  }
  // A negation moves inwards.
  bool logic(const sema::Logic& v, bool value) {
    using Op = sema::LogicOp;
    const auto is = [&](std::size_t k, bool wanted) { return comes_about(*v.operands[k], wanted); };
    const auto told = [&](std::size_t k) {
      return !sema::speaks_of_robot(*v.operands[k]) && !remembers(*v.operands[k]);
    };
    switch (v.op) {
      case Op::logical_not:
        return is(0, !value);
      case Op::implies:
        return value ? is(0, false) || is(1, true) : is(0, true) && is(1, false);
      case Op::logical_and:
      case Op::logical_or: {
        const auto each = [&](const sema::ExprPtr& x) { return comes_about(*x, value); };
        if ((v.op == Op::logical_and) == value) return std::ranges::all_of(v.operands, each);
        // in turn it is slow and it is not, which inputs do not make up for
        const auto by_itself = [&](const sema::ExprPtr& x) {
          return sema::speaks_of_robot(*x) && each(x);
        };
        return lasts_ && loiters() ? std::ranges::any_of(v.operands, by_itself) ||
                                         std::ranges::all_of(v.operands, each)
                                   : std::ranges::any_of(v.operands, each);
      }
      case Op::iff:
        return value && (told(0) || told(1) || (is(0, true) && is(1, true)));
      case Op::logical_xor:
        return value && ((told(0) && is(1, true)) || (told(1) && is(0, true)));
    }
    return false;
  }
  // The difference of its sides, of which there is one quantity to be large or small enough.
  bool compares(const sema::Compare& v, bool value) {
    using Op = sema::CompareOp;
    const bool at_least = (v.op == Op::greater || v.op == Op::greater_equal) == value;
    const bool strict = (v.op == Op::greater || v.op == Op::less) == value;
    const auto sum =
        difference(spec_, at_least ? *v.left : *v.right, at_least ? *v.right : *v.left);
    const bool asks_others = !sum || std::ranges::any_of(sum->terms, [](const auto& term) {
      return term.first.kind == Measured::Kind::distance;
    });
    if (asks_others) {
      return at_ &&
             far(of_others(at_least ? *v.left : *v.right, at_least ? *v.right : *v.left, spec_),
                 strict);
    }
    if (sum->terms.size() == 2) return way_home(*sum);
    if (sum->terms.size() != 1) return false;
    const auto& [of, by] = *sum->terms.begin();
    const Rational limit = -sum->least / by;
    if (of.kind == Measured::Kind::altitude) return height();
    if (by < 0) {
      const Rational shown = shown_speed();
      return of.kind == Measured::Kind::speed && !sum->params &&
             (strict ? shown < limit : shown <= limit);
    }
    if (of.kind == Measured::Kind::clearance) return clear(sema::ZoneId{of.index}, limit);
    return of.kind == Measured::Kind::battery && charges() &&
           limit <= shown_full(spec_[monitor_.kind]);
  }
  // Agents and robots are far away, though no farther than agents are known, and none is counted
  // where there are no others.
  [[nodiscard]] bool far(const std::optional<OfOthers>& others, bool strict) const {
    if (!others || others->counts_more || (others->counts_less && !alone_)) return false;
    const auto nearer = [](const auto& of) { return of.second < 0; };
    if (others->robots < 0 || std::ranges::any_of(others->agents, nearer)) return false;
    const auto farther =
        std::ranges::find_if(others->agents, [](const auto& of) { return of.second > 0; });
    if (farther != others->agents.end()) {
      const Rational least = -others->rest / farther->second;
      return !is_out_of_sight(spec_, decision_, farther->first, least);
    }
    if (others->robots > 0) return true;
    return others->counts_less && (strict ? others->rest > 0 : others->rest >= 0);
  }
  // battery >= energy_to(site) + ..., of the site at which it is charged.
  [[nodiscard]] bool way_home(const Sum& sum) const {
    const auto is = [&](const Measured& of, int by) {
      const auto found = sum.terms.find(of);
      return found != sum.terms.end() && found->second == by;
    };
    if (!is({Measured::Kind::battery, 0}, 1)) return false;
    if (at_) {
      return std::ranges::any_of(sum.terms, [](const auto& term) {
        return term.first.kind == Measured::Kind::energy_to && term.second == -1;
      });
    }
    const auto way = sema::route_of(recovery_);
    return way && charges() &&
           is({Measured::Kind::energy_to, static_cast<std::uint32_t>(way->site)}, -1);
  }
  // Where charge is taken up, it is taken up until it is enough; that there is enough for the way
  // home besides is for errors to say (5007).
  [[nodiscard]] bool charges() const { return at_ || ends_charged(spec_, decision_, recovery_); }
  bool height() {
    if (at_) {
      const Rational errs = seen(0) - numbers_.radius;
      return z_ && keeps_heights(spec_, *monitor_.return_when, true, *z_, errs);
    }
    const Rational errs = seen(0) - numbers_.radius, rest = left_ - errs;
    const auto steps = sema::templates_of(recovery_);
    if (!steps.empty() && std::holds_alternative<sema::Land>(steps.back())) {
      // or lower, where it has set out from there
      const Rational end = std::get<sema::Land>(steps.back()).height.value;
      const Rational anywhere_lower = end - 1'000'000;
      return keeps_heights(spec_, *monitor_.return_when, true, anywhere_lower, 0) &&
             keeps_heights(spec_, *monitor_.return_when, true, end + numbers_.hold + errs, 0);
    }
    const auto within = moves_within(recovery_);
    if (within.empty()) return false;
    const auto solid = claims_.zones().solid(within.back());
    if (!solid || solid->slabs().empty()) return false;
    return keeps_heights_inside(spec_, *monitor_.return_when, true, *solid, rest, 0);
  }
  // It goes on in laps where it has been led to; at a place it stays.
  [[nodiscard]] bool loiters() const {
    if (at_) return false;
    const auto steps = sema::templates_of(recovery_);
    return !steps.empty() && std::holds_alternative<sema::Loiter>(steps.back());
  }
  [[nodiscard]] Rational drives() const { return driven_at_most(numbers_, recovery_); }
  [[nodiscard]] Rational shown_speed() const {
    // who loiters rests between laps alone
    if (lasts_ && loiters()) {
      return seen_at_rest(numbers_) + std::max(drives(), std::min(numbers_.speed, numbers_.stands));
    }
    return shown_at_rest(spec_, numbers_, monitor_);
  }
  // The clearance of a centre at which every sample shows, as old as it may be, that a body at rest
  // is `gap` from the boundary.
  [[nodiscard]] Rational seen(const Rational& gap) const {
    return gap + numbers_.radius + 2 * numbers_.position_error + moved_at_rest(numbers_, drives());
  }
  bool clear(sema::ZoneId zone, const Rational& gap) {
    if (at_) {
      const Rational near = without_excess(seen(gap));
      return z_ ? claims_.zones().clear_in_space(zone, *at_, *z_, near)
                : claims_.zones().clear(zone, *at_, near);
    }
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
    if (more <= 0 ? out->contains(*own) : out->shrink(without_excess(more)).contains(*own))
      return true;
    const auto way = sema::route_of(recovery_);
    const Rational parked(1, 10);  // it counts as parked within this of its site
    return way && std::ranges::all_of(spec_[way->site].places, [&](const auto& place) {
             return claims_.zones().clear(zone, {place.position.x, place.position.y},
                                          Rational(need + parked));
           });
  }

  const sema::Spec& spec_;
  const sema::Decision& decision_;
  Claims& claims_;
  const sema::Monitor& monitor_;
  const sema::Controller& recovery_;
  const Rational left_;
  const Numbers numbers_;
  int robots_ = 0;
  bool alone_ = false;
  bool lasts_ = false;  // what is asked of has to last, or was so earlier
  std::optional<geometry::Point> at_;
  std::optional<Rational> z_;
};

}  // namespace

Rational shown_at_rest(const sema::Spec& spec, const Numbers& numbers,
                       const sema::Monitor& monitor) {
  const Rational first = seen_at_rest(numbers);
  const Rational gained = first + planar_accel(numbers) * numbers.position_age;
  if (!monitor.recover) return gained;
  return std::min(std::max(driven_at_most(numbers, spec[*monitor.recover]), first), gained);
}
Rational shown_full(const sema::RobotKind& kind) {
  if (!kind.battery || !kind.energy) return 0;
  return 1 - 2 * kind.battery->error.value - kind.energy->drain.value * kind.battery->max_age.value;
}

bool lets_go(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
             const sema::Monitor& monitor, const Rational& left) {
  if (monitor.return_when == nullptr) return true;
  return Condition(spec, decision, claims, monitor, left).comes_about(*monitor.return_when);
}

bool lets_go_at(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                const sema::Monitor& monitor, const geometry::Point& at,
                const std::optional<Rational>& z) {
  if (monitor.return_when == nullptr) return true;
  return Condition(spec, decision, claims, monitor, 0).holds_at(*monitor.return_when, at, z);
}

bool is_limit_kept_at_rest(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                           const sema::Monitor& monitor, const sema::Expr& e) {
  const auto* const limit = std::get_if<sema::Compare>(&e.node);
  if (limit == nullptr || !monitor.recover) return false;
  const auto is_own_speed = [](const sema::Expr& side) {
    const auto* const v = std::get_if<sema::SignalRef>(&side.node);
    return v != nullptr && v->signal == sema::Signal::speed && v->subject == sema::Subject::self;
  };
  const auto is_number = [](const sema::Expr& side) {
    return std::holds_alternative<sema::Constant>(side.node);
  };
  return ((is_own_speed(*limit->left) && is_number(*limit->right)) ||
          (is_own_speed(*limit->right) && is_number(*limit->left))) &&
         Condition(spec, decision, claims, monitor, 0).comes_about(e);
}

}  // namespace rtac::recheck
