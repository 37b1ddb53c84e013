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
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace rtac::geometry::import
