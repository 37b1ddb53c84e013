#include "compiler/recheck/sums.h"

namespace rtac::recheck {
namespace {

// A number as written.
std::optional<Rational> fixed(const sema::Expr& e) {
  if (const auto* v = std::get_if<sema::Constant>(&e.node)) return v->value;
  const auto* v = std::get_if<sema::Arithmetic>(&e.node);
  if (v == nullptr) return std::nullopt;
  const auto a = fixed(*v->operands[0]);
  if (v->op == sema::ArithmeticOp::negate) return a ? std::optional(Rational(-*a)) : std::nullopt;
  const auto b = fixed(*v->operands[1]);
  if (!a || !b) return std::nullopt;
  switch (v->op) {
    case sema::ArithmeticOp::add:
      return Rational(*a + *b);
    case sema::ArithmeticOp::subtract:
      return Rational(*a - *b);
    case sema::ArithmeticOp::multiply:
      return Rational(*a * *b);
    case sema::ArithmeticOp::divide:
      return *b == 0 ? std::nullopt : std::optional(Rational(*a / *b));
    case sema::ArithmeticOp::negate:
      break;
  }
  return std::nullopt;
}

class Adding {
 public:
  explicit Adding(const sema::Spec& spec) : spec_(spec) {}

  // `by` times the expression; false: it is no sum.
  bool add(const sema::Expr& e, const Rational& by) {
    if (by == 0) return true;
    if (const auto value = fixed(e)) {
      sum_.least += by * *value;
      return true;
    }
    if (const auto* v = std::get_if<sema::ParamRef>(&e.node)) {
      const sema::Param& param = spec_[v->param];
      sum_.least += by * (by > 0 ? param.least.value : param.most.value);
      sum_.params = true;
      return true;
    }
    if (const auto* v = std::get_if<sema::Arithmetic>(&e.node)) return arithmetic(*v, by);
    const auto what = measured(e);
    if (!what) return false;
    Rational& slot = sum_.terms[*what];
    slot += by;
    if (slot == 0) sum_.terms.erase(*what);
    return true;
  }
  [[nodiscard]] const Sum& sum() const { return sum_; }

 private:
  bool arithmetic(const sema::Arithmetic& v, const Rational& by) {
    const sema::Expr& a = *v.operands[0];
    if (v.op == sema::ArithmeticOp::negate) return add(a, Rational(-by));
    const sema::Expr& b = *v.operands[1];
    switch (v.op) {
      case sema::ArithmeticOp::add:
        return add(a, by) && add(b, by);
      case sema::ArithmeticOp::subtract:
        return add(a, by) && add(b, Rational(-by));
      case sema::ArithmeticOp::multiply: {
        const auto left = fixed(a), right = fixed(b);
        if (left) return add(b, Rational(by * *left));
        return right && add(a, Rational(by * *right));
      }
      case sema::ArithmeticOp::divide: {
        const auto right = fixed(b);
        return right && *right != 0 && add(a, Rational(by / *right));
      }
      case sema::ArithmeticOp::negate:
        break;
    }
    return false;
  }
  // Of the robot itself, and how far it is from another one.
  static std::optional<Measured> measured(const sema::Expr& e) {
    using Kind = Measured::Kind;
    if (const auto* v = std::get_if<sema::Clearance>(&e.node)) {
      return Measured{Kind::clearance, static_cast<std::uint32_t>(v->zone)};
    }
    if (const auto* v = std::get_if<sema::EnergyTo>(&e.node)) {
      return Measured{Kind::energy_to, static_cast<std::uint32_t>(v->site)};
    }
    if (std::holds_alternative<sema::Distance>(e.node)) return Measured{Kind::distance, 0};
    const auto* v = std::get_if<sema::SignalRef>(&e.node);
    if (v == nullptr || v->subject != sema::Subject::self) return std::nullopt;
    if (v->signal == sema::Signal::battery) return Measured{Kind::battery, 0};
    if (v->signal == sema::Signal::speed) return Measured{Kind::speed, 0};
    if (v->signal == sema::Signal::altitude) return Measured{Kind::altitude, 0};
    return std::nullopt;
  }

  const sema::Spec& spec_;
  Sum sum_;
};

}  // namespace

std::optional<Sum> difference(const sema::Spec& spec, const sema::Expr& large,
                              const sema::Expr& small) {
  Adding adding(spec);
  if (!adding.add(large, 1) || !adding.add(small, -1)) return std::nullopt;
  return adding.sum();
}

std::optional<Sum> excess(const sema::Spec& spec, const sema::Expr& comparison) {
  const auto* compare = std::get_if<sema::Compare>(&comparison.node);
  if (compare == nullptr) return std::nullopt;
  using Op = sema::CompareOp;
  const bool above = compare->op == Op::greater || compare->op == Op::greater_equal;
  if (!above && compare->op != Op::less && compare->op != Op::less_equal) return std::nullopt;
  return above ? difference(spec, *compare->left, *compare->right)
               : difference(spec, *compare->right, *compare->left);
}

std::optional<LimitOfOne> limit_of_one(const sema::Spec& spec, const sema::Expr& comparison,
                                       bool value) {
  const auto* compare = std::get_if<sema::Compare>(&comparison.node);
  if (compare == nullptr) return std::nullopt;
  using Op = sema::CompareOp;
  const bool above = (compare->op == Op::greater || compare->op == Op::greater_equal) == value;
  const bool strict = (compare->op == Op::greater || compare->op == Op::less) == value;
  const auto sum = above ? difference(spec, *compare->left, *compare->right)
                         : difference(spec, *compare->right, *compare->left);
  if (!sum || sum->terms.size() != 1) return std::nullopt;
  const auto& [of, by] = *sum->terms.begin();
  return LimitOfOne{of, by > 0, Rational(-sum->least / by), strict};
}

std::optional<Rational> least_distance(const sema::Spec& spec, const sema::Expr& comparison,
                                       bool value) {
  const auto limit = limit_of_one(spec, comparison, value);
  const bool is_one = limit && limit->at_least && limit->of.kind == Measured::Kind::distance;
  return is_one ? std::optional(limit->bound) : std::nullopt;
}

std::optional<Floor> floor_of(const sema::Spec& spec, const sema::Expr& comparison, bool value) {
  if (const auto* logic = std::get_if<sema::Logic>(&comparison.node)) {
    if (logic->op != sema::LogicOp::logical_not) return std::nullopt;
    return floor_of(spec, *logic->operands.front(), !value);
  }
  if (const auto* inside = std::get_if<sema::InsideZone>(&comparison.node)) {
    return value ? std::optional(Floor{inside->zone, 0, 0}) : std::nullopt;
  }
  const auto* compare = std::get_if<sema::Compare>(&comparison.node);
  if (compare == nullptr) return std::nullopt;
  using Op = sema::CompareOp;
  const bool above = (compare->op == Op::greater || compare->op == Op::greater_equal) == value;
  const sema::Expr& large = above ? *compare->left : *compare->right;
  const sema::Expr& small = above ? *compare->right : *compare->left;
  const auto least = difference(spec, large, small), most = difference(spec, small, large);
  if (!least || !most || least->terms.size() != 1) return std::nullopt;
  const auto& [of, by] = *least->terms.begin();
  if (of.kind != Measured::Kind::clearance || by <= 0) return std::nullopt;
  return Floor{sema::ZoneId{of.index}, Rational(-least->least / by), Rational(most->least / by)};
}

}  // namespace rtac::recheck
