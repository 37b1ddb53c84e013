#include "compiler/ir/rounding.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/ir/weights.h"

namespace rtac::ir {
namespace {

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}
// Of what is not negative, in whole numbers.
Rational root_up(const Rational& value) {
  mpz_class above;
  mpz_cdiv_q(above.get_mpz_t(), value.get_num().get_mpz_t(), value.get_den().get_mpz_t());
  const mpz_class down = sqrt(above);
  return Rational(down * down < above ? mpz_class(down + 1) : down);
}

// Ends of one value.
struct Slack {
  // Steps of its grid; of a margin, millionths.
  Rational by;
  // Of a quantity: a comparison with a point of the grid has the verdict of exact numbers. Of a
  // margin: it is that verdict.
  bool decides = true;
  bool measured = false;  // of a margin: it may be finite
  bool has_rounded_choice = false, has_verdicts_only = false, has_crossing_legs = false;
};

class Roundings {
 public:
  Roundings(const sema::Spec& spec, const Watch& watch, const Block& block)
      : spec_(spec), watch_(watch), block_(block) {}

  Slack run() {
    for (const Value& value : block_.values) {
      value_ = &value;
      all_.push_back(std::visit(*this, value.op));
    }
    return of(block_.result);
  }

  // ---- quantities

  // Less than a step on either side, and what the declared error lacks to whole steps. Ends between
  // two steps are open, so that a point of the grid is on the right side of them.
  Slack operator()(const Input& v) const {
    const sema::Input& input = spec_.inputs[watch_.inputs[v.channel].declared];
    const sema::Measurement& measured = input.measurement(v.component);
    Rational widened = 0;
    if (measured.error) {
      const ChannelGrid& grid = watch_.inputs[v.channel].grid(v.component);
      widened = exact(grid.error_steps) - measured.error->value / grid.unit.step;
    }
    const bool whole = input.type == sema::InputType::integer;
    return quantity(widened + (whole ? 0 : 1), sgn(widened) == 0);
  }
  Slack operator()(const Add& v) const {
    const Slack &a = of(v.a), &b = of(v.b);
    Slack result = derived(a.by + b.by, {v.a, v.b});
    result.decides = decides(a, b);
    return result;
  }
  Slack operator()(const Negate& v) const { return of(v.a); }
  Slack operator()(const Scale& v) const {
    if (v.num == 1 && v.den == 1) return of(v.a);  // the same steps, in another unit
    const Rational by = of(v.a).by * abs(exact(v.num)) / exact(v.den) + (v.den == 1 ? 0 : 1);
    return derived(by, {v.a});
  }
  Slack operator()(const Multiply& v) const {
    const Rational by = largest(v.a) * of(v.b).by + largest(v.b) * of(v.a).by;
    return derived(by, {v.a, v.b});
  }
  Slack operator()(const Minimum& v) const { return either(v.a, v.b); }
  Slack operator()(const Maximum& v) const { return either(v.a, v.b); }
  Slack operator()(const Absolute& v) const { return of(v.a); }
  // sqrt(x) - sqrt(x - e) <= sqrt(e), and <= e / sqrt(x - e)
  Slack operator()(const Root& v) const {
    const Slack& a = of(v.a);
    Rational by = root_up(a.by);
    const std::int64_t least = (*block_[v.a].range).lo;
    if (least > 0) by = std::min(by, Rational(a.by / sqrt(mpz_class(static_cast<long>(least)))));
    return derived(by + 1, {v.a});
  }
  // a norm changes by no more than the vector does
  Slack operator()(const Norm& v) const {
    const Slack &a = of(v.a), &b = of(v.b);
    return derived(root_up(a.by * a.by + b.by * b.by) + 1, {v.a, v.b});
  }
  // Distances are bounded within 3 mm, of a middle that is taken down to the grid; how far the box
  // reaches from there is rounded up, with 1 mm at most for a measurement off the middle. A box
  // that is wider by some steps moves its middle by half of them.
  Slack operator()(const PointClearance& v) const {
    const Slack &a = of(v.a), &b = of(v.b);
    const Rational wider = root_up(a.by * a.by + b.by * b.by);
    const auto spread = watch_.spread_mm(v.within, v.around);
    return derived(spread ? up_to_span(exact(7 + *spread) + wider * 3 / 2) : span(), {v.a, v.b});
  }
  Slack operator()(const PointInside& v) const { return of(v.condition); }
  // In space bounds are 4 mm apart, and both the middle and its room are off by 1 mm more.
  Slack operator()(const SolidClearance& v) const {
    const Slack &a = of(v.a), &b = of(v.b), &c = of(v.c);
    const Rational wider = root_up(a.by * a.by + b.by * b.by + c.by * c.by);
    const auto spread = watch_.spread_mm(v.within, v.around);
    const Rational by = spread ? up_to_span(exact(10 + *spread) + wider * 3 / 2) : span();
    return derived(by, {v.a, v.b, v.c});
  }
  Slack operator()(const SolidInside& v) const { return of(v.condition); }
  // On one side of the boundary as of places, of two regions as there. How far a leg that crosses
  // it leads beyond is found by places along it: nothing bounds how much of that they miss.
  Slack operator()(const TrailClearance& v) const {
    const auto spread = watch_.spread_mm(v.within, v.around);
    Slack result =
        of_trail(spread ? up_to_span(reached(v.trail) + exact(3 + *spread)) : span(), v.trail);
    result.has_crossing_legs = true;
    return result;
  }
  Slack operator()(const TrailInside& v) const { return of(v.condition); }
  // Bounds of distances are 3 mm apart, of middles with a room that is rounded up.
  Slack operator()(const TrailDistance& v) const {
    Slack result = of_trail(reached(v.trail) + reached(v.other) + 3, v.trail);
    for (const ValueId id : v.other.own) inherit(result, of(id));
    return result;
  }
  // around the exact constant
  Slack operator()(const Between& v) const {
    return quantity(exact(v.hi) - exact(v.lo), v.lo == v.hi);
  }
  // the step of the angle is known to some 2^-16 of a part of a turn, and the ends are rounded
  Slack operator()(const Phase& v) const {
    constexpr std::int64_t q16 = 1 << 16;
    const Rational parts =
        of(v.a).by * exact(v.most_q16) + largest(v.a) * (exact(v.most_q16) - exact(v.least_q16));
    return derived(parts / exact(q16) + 1, {v.a});
  }
  Slack operator()(const Sine& v) const { return wave(v.a); }
  Slack operator()(const Cosine& v) const { return wave(v.a); }
  Slack operator()(const Choose& v) const {
    const Slack& condition = of(v.condition);
    Slack result = either(v.a, v.b);
    inherit(result, condition);
    if (!condition.decides) {
      result.by = span();
      result.decides = sgn(result.by) == 0;
      result.has_rounded_choice = true;
    }
    return result;
  }
  Slack operator()(const Aggregate& v) const {
    const Slack& a = of(v.a);
    switch (v.fold) {
      case Fold::minimum:
      case Fold::maximum:
        return a;
      case Fold::mean:
        return derived(a.by + 1, {v.a});
      case Fold::sum:
        return derived(a.by * exact(v.window.to - v.window.from + 1), {v.a});
      case Fold::rate:
        return derived(a.by * 2, {v.a});
      case Fold::count:
        break;
    }
    return derived(a.decides ? Rational(0) : span(), {v.a});
  }

  // ---- margins

  Slack operator()(const AtLeast& v) const {
    const Slack &a = of(v.a), &b = of(v.b);
    const Weight weight = weight_of(*block_[v.a].unit);
    const Rational steps = a.by + b.by;
    const Rational by = steps * exact(weight.num) / exact(weight.den) + (weight.den == 1 ? 0 : 1);
    Slack result = derived(by, {v.a, v.b});
    result.decides = decides(a, b);
    result.measured = true;
    return result;
  }
  Slack operator()(const Not& v) const { return of(v.a); }
  Slack operator()(const And& v) const { return either(v.a, v.b); }
  Slack operator()(const Or& v) const { return either(v.a, v.b); }
  Slack operator()(const Previously& v) const { return of(v.a); }
  Slack operator()(const Once& v) const { return over(of(v.a), v.window); }
  Slack operator()(const Historically& v) const { return over(of(v.a), v.window); }
  Slack operator()(const Since& v) const { return over(either(v.a, v.b), v.window); }

  // Constants, parameters and ages are exact, and so are truth values; operations of robots never
  // occur here.
  template <class Other>
  Slack operator()(const Other&) const {
    return {};
  }

 private:
  [[nodiscard]] const Slack& of(ValueId id) const { return all_[static_cast<std::uint32_t>(id)]; }
  static Slack quantity(Rational by, bool decides) {
    Slack result;
    result.by = std::move(by);
    result.decides = decides;
    return result;
  }
  // Whether their sum or difference compares as exact numbers do: one of them may have open ends.
  static bool decides(const Slack& a, const Slack& b) {
    return (a.decides && sgn(b.by) == 0) || (b.decides && sgn(a.by) == 0);
  }
  [[nodiscard]] Slack of_trail(const Rational& by, const Trail& t) const {
    Slack result = derived(by, {});
    for (const ValueId id : t.own) inherit(result, of(id));
    return result;
  }
  // How far its places are from where they would be exactly, with the rounding of their middles.
  [[nodiscard]] Rational reached(const Trail& t) const {
    Rational most = 0;
    for (std::size_t i = 0; i + 1 < t.own.size(); i += 2) {
      const Slack &a = of(t.own[i]), &b = of(t.own[i + 1]);
      most = std::max(most, Rational(root_up(a.by * a.by + b.by * b.by) * 3 / 2 + 2));
    }
    return most;
  }
  // A sine changes by no more than its angle does: 2 pi / 2^32 a part of the turn, in units of
  // 2^-30 less than 8 / 5. Its bounds are within 40 of it (kernel/angle.c).
  [[nodiscard]] Slack wave(ValueId phase) const {
    return derived(of(phase).by * 8 / 5 + 40, {phase});
  }
  static void inherit(Slack& to, const Slack& from) {
    to.measured = to.measured || from.measured;
    to.has_rounded_choice = to.has_rounded_choice || from.has_rounded_choice;
    to.has_verdicts_only = to.has_verdicts_only || from.has_verdicts_only;
    to.has_crossing_legs = to.has_crossing_legs || from.has_crossing_legs;
  }
  [[nodiscard]] Slack derived(Rational by, std::initializer_list<ValueId> operands) const {
    const bool is_exact = sgn(by) == 0;
    Slack result = quantity(std::move(by), is_exact);
    for (const ValueId id : operands) inherit(result, of(id));
    return result;
  }
  // One of both, whichever.
  [[nodiscard]] Slack either(ValueId a, ValueId b) const {
    Slack result = derived(std::max(of(a).by, of(b).by), {a, b});
    result.decides = of(a).decides && of(b).decides;
    return result;
  }
  static Slack over(Slack operand, const Window& window) {
    if (operand.measured && !window.full) operand.has_verdicts_only = true;
    return operand;
  }
  [[nodiscard]] Rational span() const {
    return exact(value_->range->hi) - exact(value_->range->lo);
  }
  [[nodiscard]] Rational up_to_span(const Rational& by) const { return std::min(by, span()); }
  [[nodiscard]] Rational largest(ValueId id) const {
    const Range& range = *block_[id].range;
    return std::max(abs(exact(range.lo)), abs(exact(range.hi)));
  }

  const sema::Spec& spec_;
  const Watch& watch_;
  const Block& block_;
  const Value* value_ = nullptr;
  std::vector<Slack> all_;
};

}  // namespace

Rounding rounding_of(const sema::Spec& spec, const Watch& watch, const Block& block) {
  Slack slack = Roundings(spec, watch, block).run();
  return {std::move(slack.by), slack.decides, slack.has_rounded_choice, slack.has_verdicts_only,
          slack.has_crossing_legs};
}

}  // namespace rtac::ir
