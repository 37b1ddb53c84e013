// A JSON text as a flat tree, built under limits. Internal to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "compiler/geometry/import/areas.h"

namespace rtac::geometry::import {

// `numbers` is an array of numbers alone, at least one: positions are kept packed, since they are
// nearly all of a file.
enum class JsonKind : std::uint8_t { null, boolean, number, string, array, numbers, object };

class JsonTree;

// One value of a tree, which must outlive it.
class Json {
 public:
  Json(const JsonTree& tree, std::uint32_t node) : tree_(&tree), node_(node) {}

  JsonKind kind() const;
  bool is_object() const { return kind() == JsonKind::object; }
  bool is_array() const { return kind() == JsonKind::array || kind() == JsonKind::numbers; }
  // nullopt: a value of another kind.
  std::optional<double> number() const;
  std::optional<bool> boolean() const;
  std::optional<std::string_view> string() const;
  // Of an array of numbers alone; empty otherwise.
  std::span<const double> numbers() const;
  // Of an array of anything else, or the values of an object; empty otherwise.
  std::vector<Json> items() const;
  // Of an object; nullopt when there is none.
  std::optional<Json> member(std::string_view name) const;
  std::string_view name() const;  // of a member of an object
  std::string where() const;      // `features[3].geometry`; `the whole text` for the root
  std::string described() const;  // for messages: `the text "a"`, `an array`, `5`

 private:
  const JsonTree* tree_;
  std::uint32_t node_;
};

class JsonTree {
 public:
  // Every number is finite, no object has two members of one name. `positions_max` limits the
  // arrays of numbers, `values_max` all other values.
  static std::variant<JsonTree, Failure> parse(std::string_view text, const Limits& limits);

  Json root() const { return {*this, 0}; }

  static constexpr std::uint32_t none = UINT32_MAX;
  struct Node {
    double number = 0;  // or 1 for `true`
    std::uint32_t parent = none, next = none;
    std::uint32_t first = none;  // child, packed number or byte of the text
    std::uint32_t count = 0;     // of children, packed numbers or bytes
    std::uint32_t place = 0;     // index within an array; first byte of the name within an object
    std::uint32_t name_bytes = 0;
    JsonKind kind = JsonKind::null;
  };
  std::vector<Node> nodes;
  std::vector<double> numbers;
  std::string texts;
};

}  // namespace rtac::geometry::import
