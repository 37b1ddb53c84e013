#include "compiler/ir/weights.h"

#include <algorithm>

namespace rtac::ir {
namespace {

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}

}  // namespace

std::int64_t span_max(const Module& module) {
  constexpr std::int64_t beside_robots = 1'000'000'000'000;
  return module.decisions.empty() && module.watch ? quantity_max : beside_robots;
}

Weight weight_of(const Unit& unit) {
  // At least one step either way is weighed before the margin is cut off, so that it keeps its sign
  // (kernel: at_least_wide).
  constexpr std::int64_t most = margin_max / 2 - 2;
  const Rational weight = unit.weight();
  if (weight.get_num() > exact(most).get_num() || !weight.get_den().fits_slong_p()) {
    return {0, 1};
  }
  return {weight.get_num().get_si(), weight.get_den().get_si()};
}

bool is_plain_margin(const Block& block, const AtLeast& compare) {
  const Value& a = block[compare.a];
  const Value& b = block[compare.b];
  const Weight weight = weight_of(*a.unit);
  if (weight.den != 1 || !a.range || !b.range) return false;
  const Rational widest = std::max(abs(exact(a.range->hi) - exact(b.range->lo)),
                                   abs(exact(a.range->lo) - exact(b.range->hi)));
  // kernel: margins count halves of a millionth
  return widest * exact(weight.num) * 2 < exact(margin_max - 1);
}

}  // namespace rtac::ir
