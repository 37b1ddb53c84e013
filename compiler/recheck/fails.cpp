#include "compiler/recheck/fails.h"

#include <algorithm>
#include <variant>
#include <vector>

namespace rtac::recheck {
namespace {

// Beyond any signal, in SI units.
const Rational endless = 1'000'000'000;
// What has no end reaches as far as places are named, 536 km from the origin.
const Rational world_end = 535'000;

struct Extent {
  Rational lo = -endless, hi = endless;
};

class Reader {
 public:
  Reader(const sema::Spec& spec, NamedZones& zones, const sema::Decision& decision)
      : spec_(spec), zones_(zones), decision_(decision), numbers_(of(spec, decision)) {
    for (const sema::Robot& robot : spec.robots) robots_ += robot.kind == decision.kind ? 1 : 0;
  }

  bool can_be(const sema::Expr& e, bool value) {
    if (const auto* v = std::get_if<sema::Truth>(&e.node)) return v->value == value;
    if (const auto* v = std::get_if<sema::Logic>(&e.node)) return logic(*v, value);
    if (const auto* v = std::get_if<sema::Compare>(&e.node)) return compare(*v, value);
    if (const auto* v = std::get_if<sema::HeldFor>(&e.node)) {
      return !value || can_be(*v->operand, true);
    }
    if (const auto* v = std::get_if<sema::ForOthers>(&e.node)) {
      return robots_ < 2 ? v->universal == value : can_be(*v->body, value);
    }
    return true;  // of places and plans, of zones that come and go, and of what is told
  }

 private:
  static Numbers of(const sema::Spec& spec, const sema::Decision& decision) {
    return numbers_of(spec, decision, 0);
  }
  bool logic(const sema::Logic& v, bool value) {
    const auto can = [&](std::size_t k, bool wanted) { return can_be(*v.operands[k], wanted); };
    const auto one = [&] {
      return std::any_of(v.operands.begin(), v.operands.end(),
                         [&](const auto& operand) { return can_be(*operand, value); });
    };
    const auto all = [&] {
      return std::all_of(v.operands.begin(), v.operands.end(),
                         [&](const auto& operand) { return can_be(*operand, value); });
    };
    switch (v.op) {
      case sema::LogicOp::logical_not:
        return can(0, !value);
      case sema::LogicOp::logical_and:
        return value ? all() : one();
      case sema::LogicOp::logical_or:
        return value ? one() : all();
      case sema::LogicOp::implies:
        return value ? can(0, false) || can(1, true) : can(0, true) && can(1, false);
      case sema::LogicOp::iff:
      case sema::LogicOp::logical_xor: {
        const bool same = (v.op == sema::LogicOp::iff) == value;
        return (can(0, true) && can(1, same)) || (can(0, false) && can(1, !same));
      }
    }
    return false;
  }
  bool compare(const sema::Compare& v, bool value) {
    const Extent a = extent(*v.left), b = extent(*v.right);
    switch (v.op) {
      case sema::CompareOp::less:
        return value ? a.lo < b.hi : a.hi >= b.lo;
      case sema::CompareOp::less_equal:
        return value ? a.lo <= b.hi : a.hi > b.lo;
      case sema::CompareOp::greater:
        return value ? a.hi > b.lo : a.lo <= b.hi;
      case sema::CompareOp::greater_equal:
        return value ? a.hi >= b.lo : a.lo < b.hi;
    }
    return false;
  }

  Extent extent(const sema::Expr& e) {
    if (const auto* v = std::get_if<sema::Constant>(&e.node)) return {v->value, v->value};
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) {
      const sema::Param& param = spec_[v->param];
      return {param.least.value, param.most.value};
    }
    if (const auto* v = std::get_if<sema::SignalRef>(&e.node)) return signal(v->signal);
    if (const auto* v = std::get_if<sema::Clearance>(&e.node)) return clearance(v->zone);
    if (std::holds_alternative<sema::Distance>(e.node)) {
      return {Rational(-2 * numbers_.radius), endless};
    }
    if (const auto* v = std::get_if<sema::AgentDistance>(&e.node)) {
      return {Rational(-numbers_.radius - spec_[v->agent].radius.value), endless};
    }
    if (std::holds_alternative<sema::EnergyTo>(e.node)) return {0, endless};
    if (std::holds_alternative<sema::CountOthers>(e.node)) {
      return {0, Rational(std::max(robots_ - 1, 0))};
    }
    if (const auto* v = std::get_if<sema::Arithmetic>(&e.node)) return arithmetic(*v);
    return {};
  }
  [[nodiscard]] Extent signal(sema::Signal which) const {
    switch (which) {
      case sema::Signal::battery:
        return {0, 1};
      case sema::Signal::speed:
        return {0, numbers_.speed};
      case sema::Signal::altitude:
        return {};
    }
    return {};
  }
  // Inside of what a zone without an end leaves out, a body is surely that little outside.
  Extent clearance(sema::ZoneId zone) {
    const geometry::Region* const region = zones_.region(zone);
    const bool is_endless = region != nullptr && region->contains({world_end, world_end});
    return {is_endless ? Rational(-numbers_.radius) : Rational(-endless), endless};
  }
  Extent arithmetic(const sema::Arithmetic& v) {
    const Extent a = extent(*v.operands[0]);
    if (v.op == sema::ArithmeticOp::negate) return {Rational(-a.hi), Rational(-a.lo)};
    const Extent b = extent(*v.operands[1]);
    switch (v.op) {
      case sema::ArithmeticOp::add:
        return {Rational(a.lo + b.lo), Rational(a.hi + b.hi)};
      case sema::ArithmeticOp::subtract:
        return {Rational(a.lo - b.hi), Rational(a.hi - b.lo)};
      case sema::ArithmeticOp::multiply: {
        const std::vector<Rational> ends{Rational(a.lo * b.lo), Rational(a.lo * b.hi),
                                         Rational(a.hi * b.lo), Rational(a.hi * b.hi)};
        return {*std::min_element(ends.begin(), ends.end()),
                *std::max_element(ends.begin(), ends.end())};
      }
      default:
        break;
    }
    // a division by what may be 0 has been refused
    const std::vector<Rational> ends{Rational(a.lo / b.lo), Rational(a.lo / b.hi),
                                     Rational(a.hi / b.lo), Rational(a.hi / b.hi)};
    return {*std::min_element(ends.begin(), ends.end()),
            *std::max_element(ends.begin(), ends.end())};
  }

  const sema::Spec& spec_;
  NamedZones& zones_;
  const sema::Decision& decision_;
  const Numbers numbers_;
  int robots_ = 0;
};

}  // namespace

bool can_be(const sema::Spec& spec, NamedZones& zones, const sema::Decision& decision,
            const sema::Expr& property, bool value) {
  return Reader(spec, zones, decision).can_be(property, value);
}

}  // namespace rtac::recheck
