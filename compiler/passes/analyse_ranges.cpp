#include "compiler/passes/analyse_ranges.h"

#include <algorithm>
#include <cstdlib>

#include "compiler/passes/analyse_watch_ranges.h"
#include "compiler/support/rational.h"

namespace rtac::passes {
namespace {

using namespace ir;

constexpr std::int64_t extent_mm = std::int64_t{1} << 29;  // positions saturate there
constexpr std::int64_t quantity_limit = std::int64_t{1} << 48;
constexpr std::int64_t speed_limit_mmps = 100'000;
constexpr std::int64_t accel_limit_mmps2 = 1'000'000;
constexpr std::int64_t horizon_limit_us = 60'000'000;

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}

class Ranges {
 public:
  Ranges(const Module& module, const Decision& decision, diag::Engine& diagnostics)
      : module_(module), decision_(decision), diagnostics_(diagnostics) {}

  void block(Block& block) {
    for (Value& value : block.values) {
      if (Block* others = body_of(value.op)) this->block(*others);
      if (value.unit) value.range = range(block, value);
    }
  }

 private:
  Range range(const Block& block, const Value& value) {
    const auto of = [&](ValueId id) { return *block[id].range; };
    if (const auto* v = std::get_if<Const>(&value.op)) return checked(exact(v->value), value);
    if (const auto* v = std::get_if<ParamValue>(&value.op)) {
      const Range& range = decision_.facts.params[v->param].range;
      return checked(exact(range.lo), exact(range.hi), value);
    }
    if (const auto* v = std::get_if<Add>(&value.op)) {
      const Range a = of(v->a), b = of(v->b);
      return checked(exact(a.lo) + exact(b.lo), exact(a.hi) + exact(b.hi), value);
    }
    if (const auto* v = std::get_if<Negate>(&value.op)) return {-of(v->a).hi, -of(v->a).lo};
    if (const auto* v = std::get_if<Scale>(&value.op)) {
      const Range a = of(v->a);
      const Rational k = exact(v->num) / exact(v->den);
      // the kernel multiplies before it divides
      if (!factor_fits(a, v->num, value)) return {-quantity_limit, quantity_limit};
      const Rational p = exact(a.lo) * k, q = exact(a.hi) * k;
      return checked(std::min(p, q) - 1, std::max(p, q) + 1, value);
    }
    return range_of_robot(module_, value.op);
  }
  bool factor_fits(const Range& a, std::int64_t factor, const Value& value) {
    const Rational most = exact(std::max(std::abs(a.lo), std::abs(a.hi)));
    if (abs(exact(factor)) * most <= exact(quantity_limit)) return true;
    diagnostics_.report({diag::Code::value_out_of_range,
                         value.source,
                         "the factor " + to_decimal(exact(factor)) + " does not fit the kernel",
                         "",
                         {},
                         "a factor whose numerator is at most " +
                             std::to_string(floor_to_int(exact(quantity_limit) / most)) + " works",
                         {}});
    return false;
  }
  Range checked(const Rational& only, const Value& value) { return checked(only, only, value); }
  Range checked(const Rational& lo, const Rational& hi, const Value& value) {
    const Rational limit = exact(quantity_limit);
    if (lo < -limit || hi > limit) {
      diagnostics_.report({diag::Code::value_out_of_range,
                           value.source,
                           "this value ranges over [" + to_decimal(lo) + ", " + to_decimal(hi) +
                               "] grid units, the kernel holds ±2^48",
                           "",
                           {},
                           "use smaller factors or compare in other units",
                           {}});
      return {-quantity_limit, quantity_limit};
    }
    return {floor_to_int(lo), ceil_to_int(hi)};
  }

  const Module& module_;
  const Decision& decision_;
  diag::Engine& diagnostics_;
};

// `step`: grid steps in one `unit`.
void check_limit(const SourceRange& source, const std::string& what, std::int64_t value,
                 std::int64_t limit, std::int64_t step, const std::string& unit,
                 diag::Engine& diagnostics) {
  if (value <= limit) return;
  const auto show = [&](std::int64_t v) { return to_decimal(exact(v) / exact(step)) + " " + unit; };
  diagnostics.report({diag::Code::value_out_of_range,
                      source,
                      what + " of " + show(value) + " exceeds what the kernel can multiply",
                      "",
                      {},
                      "at most " + show(limit) + " works",
                      {}});
}

}  // namespace

void analyse_ranges(ir::Module& module, diag::Engine& diagnostics) {
  for (Decision& d : module.decisions) {
    Ranges ranges(module, d, diagnostics);
    for (Monitor& monitor : d.monitors) {
      ranges.block(monitor.property);
      if (monitor.ahead) ranges.block(*monitor.ahead);
      if (monitor.return_when) ranges.block(*monitor.return_when);
      check_limit(monitor.lookahead_source,
                  "a horizon (look-ahead, sample age, latency, jitter, period)",
                  horizon_us(d, monitor) + d.body.position_age_us + d.return_extra_us,
                  horizon_limit_us, 1'000'000, "s", diagnostics);
    }
    for (const Motion& m : d.motions) {
      check_limit(m.source, "a speed", m.speed_mmps, speed_limit_mmps, 1000, "m/s", diagnostics);
      check_limit(m.source, "an acceleration, turning included,", m.accel_mmps2, accel_limit_mmps2,
                  1000, "m/s^2", diagnostics);
    }
  }
  analyse_watch_ranges(module, diagnostics);
  static_assert(extent_mm * 2 * extent_mm * 2 * 2 > 0, "products of differences fit int64");
}

}  // namespace rtac::passes
