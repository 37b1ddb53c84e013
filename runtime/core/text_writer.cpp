#include "text_writer.h"

#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace rtac::detail {

TextWriter& TextWriter::put(char c) {
  if (length_ + 1 < capacity_) {
    out_[length_] = c;
    out_[length_ + 1] = '\0';
  }
  ++length_;
  return *this;
}

TextWriter& TextWriter::text(const char* s) {
  if (s == nullptr) return *this;
  for (; *s != '\0'; ++s) put(*s);
  return *this;
}

TextWriter& TextWriter::integer(std::int64_t value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%" PRId64, value);
  return text(digits.data());
}

TextWriter& TextWriter::natural(std::uint64_t value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%" PRIu64, value);
  return text(digits.data());
}

TextWriter& TextWriter::real(double value) {
  std::array<char, 40> digits{};
  for (int precision = 15; precision <= 17; ++precision) {
    std::snprintf(digits.data(), digits.size(), "%.*g", precision, value);
    const double back = std::strtod(digits.data(), nullptr);
    if (!(back < value) && !(back > value)) break;  // equal, or not a number
  }
  return text(digits.data());
}

TextWriter& TextWriter::csv(const char* s) {
  if (s == nullptr) return *this;
  if (std::strpbrk(s, ",\"\r\n") == nullptr) return text(s);
  put('"');
  for (; *s != '\0'; ++s) {
    if (*s == '"') put('"');
    put(*s);
  }
  return put('"');
}

}  // namespace rtac::detail
