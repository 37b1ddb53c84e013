// Bounded text building: counts what the whole text needs, writes what fits.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rtac::detail {

class TextWriter {
 public:
  TextWriter(char* out, std::size_t capacity) : out_(out), capacity_(capacity) {
    if (capacity_ > 0) out_[0] = '\0';
  }
  TextWriter& text(const char* s);
  TextWriter& put(char c);
  TextWriter& integer(std::int64_t value);
  TextWriter& natural(std::uint64_t value);
  // The shortest of 15 to 17 significant digits that reads back as the same double.
  TextWriter& real(double value);
  // As a CSV field: quoted when it holds a comma, a quote or a line break.
  TextWriter& csv(const char* s);
  // Length of the whole text, whether it fitted or not.
  [[nodiscard]] std::size_t length() const { return length_; }

 private:
  char* out_;
  std::size_t capacity_;
  std::size_t length_ = 0;
};

}  // namespace rtac::detail
