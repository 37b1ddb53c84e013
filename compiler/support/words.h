// Numbers and names in sentences.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/support/rational.h"

namespace rtac {

inline std::string quoted(const std::string& name) {
  return "`" + name + "`";
}
inline std::string metres(const Rational& m) {
  return to_decimal(m) + " m";
}
inline std::string metres(std::int64_t mm) {
  return metres(Rational(mm, 1000));
}
// To three significant digits, from above.
inline std::string square_metres(const Rational& area) {
  constexpr long least = 100, most = 1000;
  if (area <= 0) return "0 m^2";
  Rational unit = 1;
  while (area < least * unit) unit /= 10;
  while (area > most * unit) unit *= 10;
  return to_decimal(ceil_to_int(Rational(area / unit)) * unit) + " m^2";
}
inline std::string percent(std::int64_t ppm) {
  return to_decimal(Rational(ppm, 10'000)) + " %";
}
inline std::string place(std::int64_t x_mm, std::int64_t y_mm) {
  return "(" + metres(x_mm) + ", " + metres(y_mm) + ")";
}
inline std::int64_t in_mm(const Rational& m) {
  return floor_to_int(Rational(m * 1000));
}
inline std::string millis(std::int64_t us) {
  return to_decimal(Rational(us, 1000)) + " ms";
}
inline std::string seconds(const Rational& s) {
  return to_decimal(Rational(ceil_to_int(Rational(s * 10)), 10)) + " s";
}

}  // namespace rtac
