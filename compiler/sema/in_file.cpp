#include "compiler/sema/in_file.h"

#include <charconv>

namespace rtac::sema {

namespace {

// The shortest text that reads back as the same number.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace

std::string position_text(const std::array<double, 2>& position) {
  return "(" + number(position[0]) + ", " + number(position[1]) + ")";
}

std::string vertex_text(const ZonePolygon::InFile& in_file, std::size_t point) {
  const std::uint32_t vertex = in_file.vertices.at(point);
  return "vertex " + std::to_string(vertex + 1) + " " + position_text(in_file.positions.at(vertex));
}

}  // namespace rtac::sema
