#include "compiler/ir/grid_help.h"

#include "compiler/ir/weights.h"
#include "compiler/sema/dimension.h"

namespace rtac::ir {
namespace {

bool can_be_counted(const Unit& unit) {
  return unit.is_fine_enough() && weight_of(unit).num > 0;
}

Rational power_of_ten_within(const Rational& positive) {
  Rational power = 1;
  while (power > positive) power /= 10;
  while (power * 10 <= positive) power *= 10;
  return power;
}

}  // namespace

std::optional<std::string> exact_text(const Rational& value, const sema::Dimension& dimension) {
  // What is printed is the value times a power of ten (sema::show). One that makes it larger keeps
  // its digits; reciprocals of ratios become smaller.
  Rational shown = abs(value);
  for (int i = dimension.ratio; i < 0; ++i) shown /= 100;
  const auto read = parse_decimal(to_decimal(shown));
  if (!read || *read != shown) return std::nullopt;
  return sema::show(value, dimension);
}

std::optional<std::string> neighbours(const Rational& value, const Unit& unit) {
  const Rational steps = value / unit.step;
  const Rational nearer = Rational(steps.get_num() / steps.get_den()) * unit.step;
  const auto one = exact_text(nearer, unit.dimension);
  const auto other = exact_text(Rational(nearer + sgn(value) * unit.step), unit.dimension);
  if (!one || !other) return std::nullopt;
  return "`" + *one + "` and `" + *other + "`";
}

std::optional<std::string> fitting_resolution(const Rational& value, const Rational& step,
                                              const Unit& unit) {
  for (const Rational& of : {step, power_of_ten_within(step)}) {
    const Unit finer(unit.dimension, common_step(of, abs(value)), unit.scale);
    if (!can_be_counted(finer)) continue;
    if (auto text = exact_text(finer.step, unit.dimension)) return text;
  }
  return std::nullopt;
}

bool is_on_no_grid(const Rational& value, const Unit& unit) {
  return !exact_text(value, unit.dimension) && exact_text(unit.step, unit.dimension) &&
         !fitting_resolution(value, unit.step, unit);
}

std::optional<std::string> round_resolution(const Unit& unit) {
  const Unit round(unit.dimension, power_of_ten_within(unit.step), unit.scale);
  return can_be_counted(round) ? exact_text(round.step, unit.dimension) : std::nullopt;
}

}  // namespace rtac::ir
