#include "compiler/interp/decimal.h"

#include <cstddef>
#include <limits>
#include <string>

namespace rtac::interp {
namespace {

constexpr std::size_t short_digits_max = 18;  // 10^18 fits into 63 bits

__extension__ typedef __int128 Wide;

constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();

std::int64_t power_of_ten(unsigned exponent) {
  std::int64_t result = 1;
  for (; exponent > 0; --exponent) result *= 10;
  return result;
}

std::int64_t saturated(Wide value) {
  if (value > most) return most;
  return value < least ? least : static_cast<std::int64_t>(value);
}

Decimal::Grid saturated(const Rational& value) {
  if (fits_int64(value)) return {floor_to_int(value), ceil_to_int(value)};
  return sgn(value) < 0 ? Decimal::Grid{least, least} : Decimal::Grid{most, most};
}

struct Short {
  std::int64_t mantissa = 0;
  unsigned places = 0;
};
// Digits with an optional fraction, few enough.
std::optional<Short> parse_short(std::string_view text) {
  Short result;
  std::size_t digits = 0;
  bool behind_point = false;
  for (const char c : text) {
    if (c == '.' && !behind_point) {
      behind_point = true;
      continue;
    }
    if (c < '0' || c > '9' || ++digits > short_digits_max) return std::nullopt;
    result.mantissa = result.mantissa * 10 + (c - '0');
    result.places += behind_point ? 1 : 0;
  }
  return digits > 0 ? std::optional(result) : std::nullopt;
}

// Programs write `.5` and `5.` as well; numbers of a specification have digits on both sides.
std::string with_digits_around_point(std::string_view text) {
  std::string full(text);
  const std::size_t point = full.find('.');
  if (point == std::string::npos) return full;
  const auto is_digit = [&](std::size_t i) {
    return i < full.size() && full[i] >= '0' && full[i] <= '9';
  };
  const bool before = point > 0 && is_digit(point - 1), behind = is_digit(point + 1);
  if (before && !behind) full.insert(point + 1, 1, '0');
  if (behind && point == 0) full.insert(0, 1, '0');
  return full;
}

}  // namespace

std::optional<Decimal> Decimal::parse(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  Decimal result;
  if (const auto number = parse_short(text)) {
    result.mantissa_ = negative ? -number->mantissa : number->mantissa;
    result.places_ = number->places;
    return result;
  }
  const auto number = parse_decimal(with_digits_around_point(text), of_doubles);
  if (!number) return std::nullopt;
  result.long_ = negative ? Rational(-*number) : *number;
  return result;
}

Rational Decimal::value() const {
  if (long_) return *long_;
  Rational result(static_cast<long>(mantissa_), static_cast<long>(power_of_ten(places_)));
  if (places_ > 0) result.canonicalize();
  return result;
}

bool Decimal::is_whole() const {
  return long_ ? long_->get_den() == 1 : mantissa_ % power_of_ten(places_) == 0;
}

Decimal::Grid Decimal::on_grid(const Rational& step) const {
  const bool narrow = !long_ && step.get_num().fits_slong_p() && step.get_den().fits_slong_p();
  if (!narrow) return saturated(Rational(value() / step));
  // mantissa * den / (10^places * num): both below 2^126.
  const Wide above = Wide(mantissa_) * step.get_den().get_si();
  const Wide below = Wide(power_of_ten(places_)) * step.get_num().get_si();
  const Wide quotient = above / below;
  const Wide rest = above % below;
  return {saturated(quotient - (rest < 0 ? 1 : 0)), saturated(quotient + (rest > 0 ? 1 : 0))};
}

}  // namespace rtac::interp
