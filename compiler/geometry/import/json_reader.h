// Steps that all readers of JSON share: members of an expected kind, positions, rings. Internal to
// this folder.
#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "compiler/geometry/import/json_tree.h"
#include "compiler/geometry/import/outlines.h"
#include "compiler/geometry/import/unknown_members.h"

namespace rtac::geometry::import {

class JsonReader {
 public:
  JsonReader(Findings& findings, const Limits& limits) : findings_(findings), limits_(limits) {}

  // A member that must be there, and of this kind. nullopt: the failure is reported.
  std::optional<Json> required(Json object, std::string_view name);
  std::optional<Json> required_array(Json object, std::string_view name);
  // One whose elements are objects, or something else that is no number: `of`, for messages.
  std::optional<std::vector<Json>> required_items(Json object, std::string_view name,
                                                  std::string_view of);
  std::optional<std::string_view> required_text(Json object, std::string_view name);
  std::optional<double> required_number(Json object, std::string_view name);
  // A member that may be missing or `null`, which programs write for it.
  static std::optional<Json> optional_member(Json object, std::string_view name);
  std::optional<bool> required_boolean(Json object, std::string_view name);
  bool expect_object(Json value);
  // Fails on a member that is one of these but for capitals and small letters: it would be taken
  // for missing.
  bool check_letters(Json object, std::initializer_list<std::string_view> names);
  // Members that are none of these: `UnknownMembers::check`.
  bool check_members(Json object, std::initializer_list<std::string_view> known,
                     const std::string& help =
                         "take it out if it limits nothing; what does has "
                         "its place and its spelling in the format") {
    return unknown_.check(object, known, help, findings_);
  }
  // Another version may mean something else by the same members.
  bool expect_version(Json object, double version);

  // [x, y] or [x, y, height] in the order of the file: where the latitude comes first, x is it. A
  // height is remembered, once.
  bool read_position(Json value, Position& position);
  bool read_ring(Json positions, Closing closing, Ring& ring);
  // Closed rings of longitude and latitude; the first one is the outline.
  bool read_polygon(Json rings, Polygon& polygon);

  bool wrong_kind(Json value, std::string_view expected);

  bool add(Area area, Areas& areas) { return add_area(std::move(area), limits_, areas, findings_); }

  Findings& findings() { return findings_; }
  // The first position that has a height, if any.
  const std::optional<std::string>& height_at() const { return height_at_; }
  const UnknownMembers& unknown() const { return unknown_; }

 private:
  Findings& findings_;
  const Limits& limits_;
  std::optional<std::string> height_at_;
  UnknownMembers unknown_;
};

// Parses the text and lets `Reader` read it.
template <class Reader>
std::variant<Areas, Failure> read_with(std::string_view text, const Limits& limits) {
  auto tree = JsonTree::parse(text, limits);
  if (auto* failure = std::get_if<Failure>(&tree)) return std::move(*failure);
  Findings findings;
  Reader reader(findings, limits);
  if (!reader.read_root(std::get<JsonTree>(tree).root())) return *findings.failure();
  return reader.take_areas();
}

}  // namespace rtac::geometry::import
