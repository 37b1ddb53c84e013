#include "compiler/sema/limits.h"

#include <algorithm>

namespace rtac::sema {
namespace {

Rational next_step(const Rational& value, const Rational& step, bool up) {
  const Rational steps = value / step;
  mpz_class whole;
  if (up) {
    mpz_cdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  } else {
    mpz_fdiv_q(whole.get_mpz_t(), steps.get_num_mpz_t(), steps.get_den_mpz_t());
  }
  return Rational(whole) * step;
}

void round(Measurement& measured, bool outward) {
  const Rational& step = measured.resolution;
  if (measured.least) measured.least->value = next_step(measured.least->value, step, !outward);
  if (measured.most) measured.most->value = next_step(measured.most->value, step, outward);
}

}  // namespace

std::int64_t reach_steps(const Input& input) {
  const bool has_coordinates =
      std::any_of(input.components.begin(), input.components.end(), [](const std::string& part) {
        return !part.empty() && (part.back() == 'x' || part.back() == 'y' || part.back() == 'z');
      });
  return std::int64_t{1} << (has_coordinates ? 29 : 44);
}

void round_limits(Input& input) {
  round(input, input.type != InputType::integer);
  if (input.turning) round(*input.turning, true);
}

}  // namespace rtac::sema
