// Numbers and names in sentences.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/support/rational.h"

namespace rtac::verify {

inline std::string quoted(const std::string& name) {
  return "`" + name + "`";
}
inline std::string metres(std::int64_t mm) {
  return to_decimal(Rational(mm, 1000)) + " m";
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

}  // namespace rtac::verify
