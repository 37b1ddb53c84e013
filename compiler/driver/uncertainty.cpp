#include "compiler/driver/uncertainty.h"

#include <algorithm>
#include <variant>

namespace rtac::driver {
namespace {

using namespace ir;

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}
Rational rounded_up(const Rational& value) {
  mpz_class whole;
  mpz_cdiv_q(whole.get_mpz_t(), value.get_num().get_mpz_t(), value.get_den().get_mpz_t());
  return Rational(whole);
}
// Of a whole number that is not negative.
Rational root_up(const Rational& value) {
  const mpz_class down = sqrt(value.get_num());
  return Rational(down * down < value.get_num() ? mpz_class(down + 1) : down);
}

// Ends are whole steps. Where one is rounded down and the other up, two steps are added at most,
// and never quite two: so a whole number of steps grows by one.
constexpr int rounding_steps = 1;

class Widths {
 public:
  Widths(const Watch& watch, const Block& block, const Decision* decision)
      : watch_(watch), block_(block), decision_(decision) {}

  std::vector<Rational> run() {
    for (const Value& value : block_.values) {
      value_ = &value;
      Rational width = std::visit(*this, value.op);
      if (value.range) {
        width = std::min(width, span());  // an interval lies within the range
      }
      all_.push_back(std::move(width));
    }
    return std::move(all_);
  }

  // Measured between two steps of the grid, and wrong by the error on either side.
  Rational operator()(const Input& v) const {
    return exact(2 * watch_.inputs[v.channel].grid(v.component).error_steps) + rounding_steps;
  }
  Rational operator()(const AtLeast& v) const { return of(v.a) + of(v.b); }
  Rational operator()(const Add& v) const { return of(v.a) + of(v.b); }
  Rational operator()(const Negate& v) const { return of(v.a); }
  Rational operator()(const Scale& v) const {
    const Rational width = of(v.a) * abs(exact(v.num)) / exact(v.den);
    return v.den == 1 ? width : Rational(rounded_up(width) + rounding_steps);
  }
  Rational operator()(const Multiply& v) const {
    return largest(v.a) * of(v.b) + largest(v.b) * of(v.a);
  }
  Rational operator()(const Minimum& v) const { return std::max(of(v.a), of(v.b)); }
  Rational operator()(const Maximum& v) const { return std::max(of(v.a), of(v.b)); }
  Rational operator()(const Absolute& v) const { return of(v.a); }
  // sqrt(x + w) <= sqrt(x) + sqrt(w)
  Rational operator()(const Root& v) const { return root_up(of(v.a)) + rounding_steps; }
  // a norm changes by no more than the vector does
  Rational operator()(const Norm& v) const {
    return root_up(of(v.a) * of(v.a) + of(v.b) * of(v.b)) + rounding_steps;
  }
  // The kernel bounds distances within 3 mm, of a middle that is off the grid by 1 mm at most; it
  // leaves 1 mm at most for a measurement off it; the box of the place adds half its diagonal on
  // either side. Where the zone is none of the grid, what lies between its two regions is unknown
  // as well.
  Rational operator()(const PointClearance& v) const {
    constexpr int bounds_mm = 3, middle_mm = 2;
    const auto spread = watch_.spread_mm(v.within, v.around);
    if (!spread) return span();
    const Rational diagonal = root_up(of(v.a) * of(v.a) + of(v.b) * of(v.b));
    return diagonal + exact(*spread) + 2 * (middle_mm + rounding_steps) + bounds_mm;
  }
  Rational operator()(const PointInside& v) const { return of(v.condition); }
  // In space they are 4 mm apart, with 2 mm at most for a measurement off the middle, which is off
  // by less than 2 mm.
  Rational operator()(const SolidClearance& v) const {
    constexpr int bounds_mm = 4, middle_mm = 4;
    const auto spread = watch_.spread_mm(v.within, v.around);
    if (!spread) return span();
    const Rational diagonal = root_up(of(v.a) * of(v.a) + of(v.b) * of(v.b) + of(v.c) * of(v.c));
    return diagonal + exact(*spread) + 2 * (middle_mm + rounding_steps) + bounds_mm;
  }
  Rational operator()(const SolidInside& v) const { return of(v.condition); }
  // Of legs on one side of the boundary; of others nothing bounds it.
  Rational operator()(const TrailClearance& v) const {
    const auto spread = watch_.spread_mm(v.within, v.around);
    return spread ? Rational(exact(3 + *spread) + reached(v.trail)) : span();
  }
  Rational operator()(const TrailInside& v) const { return of(v.condition); }
  // The boxes of places add half their diagonals on either side.
  Rational operator()(const TrailDistance& v) const {
    return 3 + reached(v.trail) + reached(v.other);
  }
  Rational operator()(const Between& v) const { return exact(v.hi) - exact(v.lo); }
  // the step of the angle is known to one of 2^16 of a part, and both ends are rounded outward
  Rational operator()(const Phase& v) const {
    const Rational parts =
        (of(v.a) * exact(v.most_q16) + largest(v.a) * (exact(v.most_q16) - exact(v.least_q16))) /
        exact(1 << 16);
    return rounded_up(parts) + rounding_steps;
  }
  Rational operator()(const Sine& v) const { return wave(v.a); }
  Rational operator()(const Cosine& v) const { return wave(v.a); }
  // the condition may be unknown within its own error: then it is anything of both
  Rational operator()(const Choose&) const { return span(); }
  Rational operator()(const Aggregate& v) const {
    switch (v.fold) {
      case Fold::minimum:
      case Fold::maximum:
        return of(v.a);
      case Fold::mean:
        return of(v.a) + rounding_steps;
      case Fold::sum:
        return of(v.a) * exact(v.window.to - v.window.from + 1);
      case Fold::rate:
        return of(v.a) * 2;
      case Fold::count:  // conditions may be unknown within their own error
        break;
    }
    return span();
  }
  // ---- of robots: what a sample has wrong, and how far the robot may have moved since

  // The charge may have run down since it was measured, between two steps of the grid.
  Rational operator()(const Battery&) const {
    const Body& b = decision_->body;
    return exact(2 * b.battery_error_ppm + 1) +
           rounded_up(exact(b.drain_ppm_per_s) * exact(whole_ms(b.battery_age_us)) / 1000);
  }
  // Bounds of distances are 3 mm apart (kernel/checks.c).
  Rational operator()(const Clearance&) const {
    return 2 * displaced_mm(decision_->body.position_age_us) + 3;
  }
  Rational operator()(const ReceivedClearance&) const {
    return 2 * displaced_mm(decision_->body.position_age_us) + 3;
  }
  Rational operator()(const Distance&) const {
    const Body& b = decision_->body;
    return 2 * (displaced_mm(b.position_age_us) +
                std::max(displaced_mm(b.hears_age_us),
                         exact(b.position_error_mm + grid_mm() + b.hold_mm))) +
           1;
  }
  // The agent may have moved since, too.
  Rational operator()(const AgentDistance& v) const {
    const Agent& agent = (*decision_)[v.agent];
    const std::int64_t moved_mm = whole_ms(agent.speed_mmps * whole_ms(agent.age_us));
    return 2 * (displaced_mm(decision_->body.position_age_us) +
                exact(agent.error_mm + grid_mm() + moved_mm)) +
           1;
  }
  // 4: the grid of both components and of the length; what it has gained or lost since.
  Rational operator()(const Speed&) const {
    const Body& b = decision_->body;
    const std::int64_t apart_ms = whole_ms(std::max(b.position_age_us, b.velocity_age_us));
    return 2 * (exact(b.velocity_error_mmps + 4) +
                2 * rounded_up(exact(b.accel_mmps2) * exact(apart_ms) / 1000));
  }
  // The price of a way differs from cell to cell.
  Rational operator()(const EnergyTo&) const { return span(); }
  Rational operator()(const CountOthers&) const { return span(); }

  // Constants, parameters and ages are exact, and so are truth values.
  template <class Other>
  Rational operator()(const Other&) const {
    return 0;
  }

 private:
  [[nodiscard]] const Rational& of(ValueId id) const {
    return all_[static_cast<std::uint32_t>(id)];
  }
  // A sine changes by no more than its angle does, and a part of a turn is 2 pi / 2^32 < 7 / 2^32;
  // the bounds of one phase lie within `sine_width` (kernel/angle.c).
  [[nodiscard]] Rational wave(ValueId phase) const {
    constexpr int sine_width = 40, parts = 4;
    return rounded_up(of(phase) * 7 / parts) + 2 * sine_width;
  }
  // Each coordinate lies between two steps of the grid.
  [[nodiscard]] std::int64_t grid_mm() const { return decision_->body.in_space ? 3 : 2; }
  static std::int64_t whole_ms(std::int64_t us) { return (us + 999) / 1000; }
  // How far the centre is from where it was seen, when the sample is as old as it may be: the speed
  // is that of any control, or one that was measured and may have changed until the position was.
  [[nodiscard]] Rational displaced_mm(std::int64_t age_us) const {
    constexpr std::int64_t rounding_mmps = 4, rounding_mm = 2;
    const Body& b = decision_->body;
    const std::int64_t apart_ms =
        whole_ms(std::max({b.position_age_us, b.velocity_age_us, age_us}));
    const Rational speed_mmps =
        exact(decision_->motions[0].speed_mmps + 2 * b.velocity_error_mmps + rounding_mmps) +
        rounded_up(exact(b.accel_mmps2) * exact(apart_ms) / 1000);
    return exact(b.position_error_mm + grid_mm() + rounding_mm) +
           rounded_up(speed_mmps * exact(whole_ms(age_us)) / 1000);
  }
  [[nodiscard]] Rational reached(const Trail& t) const {
    Rational most = 0;
    for (std::size_t i = 0; i + 1 < t.own.size(); i += 2) {
      const Rational &x = of(t.own[i]), &y = of(t.own[i + 1]);
      most = std::max(most, Rational(root_up(x * x + y * y) + 2 * rounding_steps));
    }
    return most;
  }
  [[nodiscard]] Rational span() const {
    return exact(value_->range->hi) - exact(value_->range->lo);
  }
  [[nodiscard]] Rational largest(ValueId id) const {
    const Range& range = *block_[id].range;
    return std::max(abs(exact(range.lo)), abs(exact(range.hi)));
  }

  const Watch& watch_;
  const Block& block_;
  const Decision* decision_;
  const Value* value_ = nullptr;
  std::vector<Rational> all_;
};

}  // namespace

std::vector<Rational> widths(const Watch& watch, const Block& block, const Decision* decision) {
  return Widths(watch, block, decision).run();
}

bool rounds(const Op& op) {
  if (const auto* scale = std::get_if<Scale>(&op)) return scale->den != 1;
  if (const auto* fold = std::get_if<Aggregate>(&op)) return fold->fold == Fold::mean;
  if (std::holds_alternative<Battery>(op) || std::holds_alternative<Clearance>(op) ||
      std::holds_alternative<Distance>(op) || std::holds_alternative<EnergyTo>(op) ||
      std::holds_alternative<Speed>(op) || std::holds_alternative<AgentDistance>(op) ||
      std::holds_alternative<ReceivedClearance>(op)) {
    return true;
  }
  return std::holds_alternative<Input>(op) || std::holds_alternative<PointClearance>(op) ||
         std::holds_alternative<TrailClearance>(op) || std::holds_alternative<TrailDistance>(op) ||
         std::holds_alternative<SolidClearance>(op) || std::holds_alternative<Root>(op) ||
         std::holds_alternative<Norm>(op) || std::holds_alternative<Phase>(op) ||
         std::holds_alternative<Sine>(op) || std::holds_alternative<Cosine>(op);
}

}  // namespace rtac::driver
