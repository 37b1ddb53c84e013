#include "compiler/geometry/import/findings.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace rtac::geometry::import {
namespace {

constexpr std::size_t quoted_max = 60;

bool continues_a_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

}  // namespace

std::string quote(std::string_view text) {
  std::size_t end = std::min(text.size(), quoted_max);
  while (end < text.size() && end > 0 && continues_a_character(text[end])) --end;
  std::string result = "`";
  for (const char byte : text.substr(0, end)) {
    const bool is_control = static_cast<unsigned char>(byte) < 0x20U || byte == 0x7f;
    result += is_control || byte == '`' ? ' ' : byte;
  }
  return result + (end < text.size() ? "...`" : "`");
}

std::string shown(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} ? std::string(text.data(), end) : "a number";
}

std::string shown(Position position) {
  return "(" + shown(position.x) + ", " + shown(position.y) + ")";
}

std::string line_and_column(std::string_view text, std::size_t offset) {
  return Lines(text.substr(0, std::min(offset, text.size()))).place(offset);
}

Lines::Lines(std::string_view text) : starts_{0} {
  for (std::size_t i = text.find('\n'); i != std::string_view::npos; i = text.find('\n', i + 1)) {
    starts_.push_back(i + 1);
  }
}

std::string Lines::place(std::size_t offset) const {
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
  return "line " + std::to_string(after - starts_.begin()) + ", column " +
         std::to_string(offset - *(after - 1) + 1);
}

}  // namespace rtac::geometry::import
