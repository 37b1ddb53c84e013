#include "compiler/interp/openings.h"

#include <algorithm>
#include <chrono>

#include "compiler/support/rational.h"

namespace rtac::interp {
namespace {

const Rational day_s(86400);

bool lies_in(const Rational& s, const sema::Opening& opening) {
  return s >= Rational(static_cast<long>(opening.from_s)) &&
         s < Rational(static_cast<long>(opening.until_s));
}

}  // namespace

bool is_open(const std::vector<sema::Opening>& openings, std::int64_t now_us) {
  Rational now_s(static_cast<long>(now_us), 1000000L);
  now_s.canonicalize();
  const std::int64_t day = floor_to_int(now_s / day_s);
  const Rational of_day_s = now_s - Rational(static_cast<long>(day)) * day_s;
  const std::chrono::weekday weekday{std::chrono::sys_days(std::chrono::days(day))};
  const unsigned bit = weekday.iso_encoding() - 1;  // 0: Monday
  return std::any_of(openings.begin(), openings.end(), [&](const sema::Opening& opening) {
    if (opening.days == 0) return lies_in(now_s, opening);
    return (opening.days >> bit & 1U) != 0 && lies_in(of_day_s, opening);
  });
}

}  // namespace rtac::interp
