#include "compiler/driver/explain_text.h"

#include "compiler/ir/weights.h"
#include "compiler/sema/dimension.h"

namespace rtac::driver {

using namespace ir;

std::string count(std::size_t number, const std::string& what) {
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}
Rational decimals(const Rational& value, bool up) {
  static const Rational per_unit = 1'000'000'000;
  const Rational scaled = (up ? value : Rational(-value)) * per_unit;
  mpz_class whole;
  mpz_cdiv_q(whole.get_mpz_t(), scaled.get_num().get_mpz_t(), scaled.get_den().get_mpz_t());
  const Rational rounded = Rational(whole) / per_unit;
  return up ? rounded : Rational(-rounded);
}
std::string shown(const Rational& steps, const Unit& unit, bool up) {
  return sema::show(decimals(steps * unit.step, up), unit.dimension);
}
std::string shown(std::int64_t steps, const Unit& unit, bool up) {
  return shown(Rational(static_cast<long>(steps)), unit, up);
}
std::string shown(const Range& range, const Unit& unit) {
  return shown(range.lo, unit, false) + " .. " + shown(range.hi, unit, true);
}
std::string real_type(const sema::Dimension& dimension) {
  const std::string unit = sema::unit_of(dimension);
  return unit.empty() ? "real" : "real [" + unit + "]";
}
std::string grid(const Unit& unit) {
  Unit plain = unit;
  plain.scale = default_scale(unit.dimension);
  const std::string text = name(plain);
  const bool has_number = text.front() >= '0' && text.front() <= '9';
  return "grid: steps of " + (has_number ? text : "1 " + text);
}
std::string edges_checked(std::size_t edges, const ir::EdgeTree& tree) {
  if (tree.words.empty()) return "a place is held against every edge";
  const auto most = static_cast<std::size_t>(tree.edges_most);
  return "a place is held against at most " + count(most, "edge") + " of " + std::to_string(edges) +
         ", found in " + count(static_cast<std::size_t>(tree.depth) + 1, "step") +
         "; distances are exact " +
         (tree.exact_mm ? "up to " + to_decimal(Rational(*tree.exact_mm, 1000)) + " m"
                        : "everywhere");
}
std::string wide(const Rational& steps, const Unit& unit) {
  if (sgn(steps) == 0) return "error: none, the interval is a point";
  return "error: the interval is at most " + shown(steps, unit, true) + " wide";
}

}  // namespace rtac::driver
