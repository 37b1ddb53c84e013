// Numbers of a trace, exactly as written: most are short, and a trace has millions of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/support/rational.h"

namespace rtac::interp {

class Decimal {
 public:
  Decimal() = default;
  explicit Decimal(std::int64_t whole) : mantissa_(whole) {}
  // An optional sign, then what parse_decimal reads, also without digits on one side of the point;
  // nullopt on anything else.
  static std::optional<Decimal> parse(std::string_view text);

  [[nodiscard]] Rational value() const;
  [[nodiscard]] bool is_whole() const;
  // floor(value / step) and ceil(value / step), step > 0; saturated.
  struct Grid {
    std::int64_t lo, hi;
  };
  [[nodiscard]] Grid on_grid(const Rational& step) const;

 private:
  std::int64_t mantissa_ = 0;  // value = mantissa * 10^-places, unless it is long
  unsigned places_ = 0;
  std::optional<Rational> long_;
};

}  // namespace rtac::interp
