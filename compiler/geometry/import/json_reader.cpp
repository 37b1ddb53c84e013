#include "compiler/geometry/import/json_reader.h"

#include <algorithm>
#include <cctype>

namespace rtac::geometry::import {

bool JsonReader::wrong_kind(Json value, std::string_view expected) {
  return findings_.fail(value.where(), "is " + value.described(),
                        "write " + std::string(expected) + " here");
}

std::optional<Json> JsonReader::required(Json object, std::string_view name) {
  const auto value = object.member(name);
  if (!value) {
    findings_.fail(object.where(), "lacks the member " + quote(name), "add it");
  }
  return value;
}

std::optional<Json> JsonReader::required_array(Json object, std::string_view name) {
  const auto value = required(object, name);
  if (value && !value->is_array()) {
    wrong_kind(*value, "an array");
    return std::nullopt;
  }
  return value;
}

std::optional<std::vector<Json>> JsonReader::required_items(Json object, std::string_view name,
                                                            std::string_view of) {
  const auto value = required(object, name);
  if (!value) return std::nullopt;
  if (value->kind() != JsonKind::array) {
    wrong_kind(*value, "an array of " + std::string(of));
    return std::nullopt;
  }
  return value->items();
}

std::optional<std::string_view> JsonReader::required_text(Json object, std::string_view name) {
  const auto value = required(object, name);
  if (!value) return std::nullopt;
  if (!value->string()) wrong_kind(*value, "a text");
  return value->string();
}

std::optional<double> JsonReader::required_number(Json object, std::string_view name) {
  const auto value = required(object, name);
  if (!value) return std::nullopt;
  if (!value->number()) wrong_kind(*value, "a number");
  return value->number();
}

bool JsonReader::expect_object(Json value) {
  return value.is_object() || wrong_kind(value, "an object");
}

bool JsonReader::check_letters(Json object, std::initializer_list<std::string_view> names) {
  const auto same_letter = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  for (const Json member : object.items()) {
    const std::string_view written = member.name();
    for (const std::string_view name : names) {
      if (written == name ||
          !std::equal(written.begin(), written.end(), name.begin(), name.end(), same_letter)) {
        continue;
      }
      return findings_.fail(member.where(), "is no member that the format has",
                            "write it as " + quote(name) + ", if it is meant");
    }
  }
  return true;
}

std::optional<Json> JsonReader::optional_member(Json object, std::string_view name) {
  const auto value = object.member(name);
  return value && value->kind() != JsonKind::null ? value : std::nullopt;
}

std::optional<bool> JsonReader::required_boolean(Json object, std::string_view name) {
  const auto value = required(object, name);
  if (!value) return std::nullopt;
  if (!value->boolean()) wrong_kind(*value, "`true` or `false`");
  return value->boolean();
}

bool JsonReader::expect_version(Json object, double version) {
  const auto found = required_number(object, "version");
  if (!found || *found == version) return found.has_value();
  return findings_.fail(object.where(), "is of version " + shown(*found),
                        "version " + shown(version) +
                            " can be read; open the file in the program that it comes from, in its "
                            "present version, and save it again");
}

bool JsonReader::read_position(Json value, Position& position) {
  const auto numbers = value.numbers();
  if (numbers.size() < 2 || numbers.size() > 3) {
    // `["8.54", "47.39"]` is an array of two, too
    const auto items = value.kind() == JsonKind::array ? value.items() : std::vector<Json>{};
    const auto no_number =
        std::find_if(items.begin(), items.end(), [](const Json& item) { return !item.number(); });
    const std::string element = no_number == items.end()
                                    ? ""
                                    : ", and its element " +
                                          std::to_string(no_number - items.begin() + 1) + " is " +
                                          no_number->described();
    return findings_.fail(value.where(),
                          numbers.empty() ? "is " + value.described() + element
                                          : "has " + std::to_string(numbers.size()) + " numbers",
                          "a position is an array of two numbers, or three with a height");
  }
  if (numbers.size() == 3 && !height_at_) height_at_ = value.where();
  position = {numbers[0], numbers[1]};
  return true;
}

bool JsonReader::read_ring(Json positions, Closing closing, Ring& ring) {
  ring.where = positions.where();
  if (positions.kind() != JsonKind::array) return wrong_kind(positions, "an array of positions");
  std::size_t dimensions = 0;
  for (const Json item : positions.items()) {
    if (!read_position(item, ring.positions.emplace_back())) return false;
    const std::size_t count = item.numbers().size();
    if (dimensions == 0) dimensions = count;
    if (count == dimensions) continue;
    return findings_.fail(item.where(),
                          "a position of " + std::to_string(count) + " numbers, among those of " +
                              std::to_string(dimensions),
                          "two numbers at all positions of a ring, or three with a height at all; "
                          "a decimal comma makes two numbers of `47,3986`: write `47.3986`");
  }
  return finish_ring(ring, closing, findings_);
}

bool JsonReader::read_polygon(Json rings, Polygon& polygon) {
  const auto items = rings.items();
  if (rings.kind() != JsonKind::array || items.empty()) {
    return wrong_kind(rings, "an array of rings");
  }
  if (!read_ring(items.front(), Closing::required, polygon.outer)) return false;
  for (std::size_t i = 1; i < items.size(); ++i) {
    if (!read_ring(items[i], Closing::required, polygon.holes.emplace_back())) return false;
  }
  return true;
}

}  // namespace rtac::geometry::import
