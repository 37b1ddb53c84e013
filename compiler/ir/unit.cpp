#include "compiler/ir/unit.h"

#include "compiler/sema/dimension.h"

namespace rtac::ir {

const Unit Unit::mm{sema::Dimension{.m = 1}, Rational(1, 1000), 1};
const Unit Unit::ppm{sema::Dimension{.ratio = 1}, Rational(1, 1'000'000), Rational(1, 100)};
const Unit Unit::robots{sema::Dimension{}, 1, 1};
const Unit Unit::mmps{sema::Dimension{.m = 1, .s = -1}, Rational(1, 1000), 1};

std::string name(const Unit& unit) {
  if (unit == Unit::mm) return "mm";
  if (unit == Unit::ppm) return "ppm";
  std::string text = unit.step.get_str();
  const bool ratio = unit.dimension == sema::Dimension{.ratio = 1};
  const std::string si = ratio ? "of full" : sema::unit_of(unit.dimension);
  if (!si.empty()) text += " " + si;
  if (unit.scale != default_scale(unit.dimension)) text += " by " + unit.scale.get_str();
  return text;
}

Rational common_step(const Rational& a, const Rational& b) {
  mpz_class divisor;
  const mpz_class left = a.get_num() * b.get_den(), right = b.get_num() * a.get_den();
  mpz_gcd(divisor.get_mpz_t(), left.get_mpz_t(), right.get_mpz_t());
  Rational step(divisor, a.get_den() * b.get_den());
  step.canonicalize();
  return step;
}

Rational default_scale(const sema::Dimension& dimension) {
  return dimension == sema::Dimension{.ratio = 1} ? Rational(1, 100) : Rational(1);
}

}  // namespace rtac::ir
