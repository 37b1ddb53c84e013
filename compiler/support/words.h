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
