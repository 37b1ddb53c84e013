#include "compiler/geometry/import/json_tree.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compiler/geometry/import/findings.h"

namespace rtac::geometry::import {
namespace {

using Node = JsonTree::Node;

std::string_view name_of(const JsonTree& tree, const Node& node) {
  return std::string_view(tree.texts).substr(node.place, node.name_bytes);
}

bool is_plain_name(std::string_view name) {
  return !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
}

std::string place_of(const JsonTree& tree, std::uint32_t node) {
  std::vector<std::string> steps;
  for (; tree.nodes[node].parent != JsonTree::none; node = tree.nodes[node].parent) {
    const Node& child = tree.nodes[node];
    if (tree.nodes[child.parent].kind != JsonKind::object) {
      steps.push_back("[" + std::to_string(child.place) + "]");
    } else if (const std::string_view name = name_of(tree, child); is_plain_name(name)) {
      steps.push_back("." + std::string(name));
    } else {
      steps.push_back("[" + quote(name) + "]");
    }
  }
  if (steps.empty()) return "the whole text";
  std::string result;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) result += *step;
  return result.front() == '.' ? result.substr(1) : result;
}

// Receives the events of the parser; `false` stops it.
class Builder {
 public:
  Builder(std::string_view text, const Limits& limits) : text_(text), limits_(limits) {}

  bool null() { return add({.kind = JsonKind::null}); }
  bool boolean(bool value) { return add({.number = value ? 1.0 : 0.0, .kind = JsonKind::boolean}); }
  bool number_integer(std::int64_t value) { return add_number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return add_number(static_cast<double>(value)); }
  bool number_float(double value, const std::string& /*text*/) { return add_number(value); }
  bool string(const std::string& value) {
    const auto begin = static_cast<std::uint32_t>(tree_.texts.size());
    tree_.texts += value;
    return add({.first = begin,
                .count = static_cast<std::uint32_t>(value.size()),
                .kind = JsonKind::string});
  }
  bool binary(const std::vector<std::uint8_t>& /*bytes*/) { return false; }  // none in JSON texts
  bool key(const std::string& name) {
    name_begin_ = static_cast<std::uint32_t>(tree_.texts.size());
    name_bytes_ = static_cast<std::uint32_t>(name.size());
    tree_.texts += name;
    return true;
  }
  bool start_object(std::size_t /*unknown*/) { return open(JsonKind::object); }
  bool start_array(std::size_t /*unknown*/) { return open(JsonKind::array); }
  bool end_object();
  bool end_array();
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error);

  JsonTree take_tree() { return std::move(tree_); }
  Failure failure() const {
    return findings_.failure().value_or(Failure{"the whole text", "it cannot be read", ""});
  }

 private:
  // An array or object that is not closed yet; an array packs its numbers while it has no others.
  struct Open {
    std::uint32_t node, last = JsonTree::none;
    std::size_t numbers_begin;
    bool is_packing;
  };

  bool add(Node node);
  bool add_number(double value);
  bool open(JsonKind kind);
  bool unpack();
  bool append(Node node);
  std::string here() const {
    return open_.empty() ? "the whole text" : place_of(tree_, open_.back().node);
  }

  std::string_view text_;
  const Limits& limits_;
  JsonTree tree_;
  std::vector<Open> open_;
  std::uint32_t name_begin_ = 0, name_bytes_ = 0;
  std::size_t positions_ = 0;
  Findings findings_;
};

bool Builder::append(Node node) {
  if (tree_.nodes.size() - positions_ >= limits_.values_max) {
    return findings_.fail(here(), "more than " + std::to_string(limits_.values_max) + " values",
                          "split the file, or leave out what is no zone");
  }
  const auto index = static_cast<std::uint32_t>(tree_.nodes.size());
  if (!open_.empty()) {
    Open& parent = open_.back();
    node.parent = parent.node;
    const bool is_member = tree_.nodes[parent.node].kind == JsonKind::object;
    node.place = is_member ? name_begin_ : tree_.nodes[parent.node].count;
    node.name_bytes = is_member ? name_bytes_ : 0;
    (parent.last == JsonTree::none ? tree_.nodes[parent.node].first
                                   : tree_.nodes[parent.last].next) = index;
    parent.last = index;
    ++tree_.nodes[parent.node].count;
  }
  tree_.nodes.push_back(node);
  return true;
}

// The numbers so far become values of their own.
bool Builder::unpack() {
  Open& array = open_.back();
  array.is_packing = false;
  const std::vector<double> values(
      tree_.numbers.begin() + static_cast<std::ptrdiff_t>(array.numbers_begin),
      tree_.numbers.end());
  tree_.numbers.resize(array.numbers_begin);
  return std::all_of(values.begin(), values.end(), [&](double value) {
    return append({.number = value, .kind = JsonKind::number});
  });
}

bool Builder::add(Node node) {
  if (!open_.empty() && open_.back().is_packing && !unpack()) return false;
  return append(node);
}

bool Builder::add_number(double value) {
  if (!std::isfinite(value)) return false;  // the parser reports those as errors
  if (open_.empty() || !open_.back().is_packing) {
    return append({.number = value, .kind = JsonKind::number});
  }
  if (tree_.numbers.size() >= 4 * limits_.positions_max) {
    return findings_.fail(here(), "too many numbers", "split the file");
  }
  tree_.numbers.push_back(value);
  return true;
}

bool Builder::open(JsonKind kind) {
  if (!add({.kind = kind})) return false;
  if (open_.size() >= limits_.nesting_max) {
    return findings_.fail(here(),
                          "nested deeper than " + std::to_string(limits_.nesting_max) + " levels",
                          "zones need about ten levels; flatten the collections");
  }
  const auto node = static_cast<std::uint32_t>(tree_.nodes.size() - 1);
  open_.push_back(
      {.node = node, .numbers_begin = tree_.numbers.size(), .is_packing = kind == JsonKind::array});
  return true;
}

bool Builder::end_array() {
  const Open array = open_.back();
  if (array.is_packing && tree_.numbers.size() > array.numbers_begin) {
    Node& node = tree_.nodes[array.node];
    node.kind = JsonKind::numbers;
    node.first = static_cast<std::uint32_t>(array.numbers_begin);
    node.count = static_cast<std::uint32_t>(tree_.numbers.size() - array.numbers_begin);
    if (++positions_ > limits_.positions_max) {
      return findings_.fail(here(),
                            "more than " + std::to_string(limits_.positions_max) + " positions",
                            "simplify the outlines, or split the file");
    }
  }
  open_.pop_back();
  return true;
}

// Readers of JSON disagree on which of two members counts: either is a guess.
bool Builder::end_object() {
  std::vector<std::uint32_t> members;
  const std::uint32_t object = open_.back().node;
  for (auto i = tree_.nodes[object].first; i != JsonTree::none; i = tree_.nodes[i].next) {
    members.push_back(i);
  }
  std::sort(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
    return name_of(tree_, tree_.nodes[a]) < name_of(tree_, tree_.nodes[b]);
  });
  const auto twice =
      std::adjacent_find(members.begin(), members.end(), [&](std::uint32_t a, std::uint32_t b) {
        return name_of(tree_, tree_.nodes[a]) == name_of(tree_, tree_.nodes[b]);
      });
  if (twice != members.end()) {
    return findings_.fail(here(),
                          "has the member " + quote(name_of(tree_, tree_.nodes[*twice])) + " twice",
                          "keep one of them");
  }
  open_.pop_back();
  return true;
}

bool Builder::parse_error(std::size_t position, const std::string& token,
                          const nlohmann::detail::exception& error) {
  constexpr int number_overflow = 406;  // of the library's table of exceptions
  const std::size_t offset = position == 0 ? 0 : position - 1;
  const std::string place =
      line_and_column(text_, offset) + (open_.empty() ? "" : ", within " + here());
  if (error.id == number_overflow) {
    return findings_.fail(place, "the number " + quote(token) + " is beyond any double",
                          "degrees and metres need at most ten digits before the point");
  }
  if (offset + 1 >= text_.size() && !open_.empty()) {
    return findings_.fail(place, "the text ends before it is complete",
                          "the file was cut off; export or copy it again");
  }
  const std::string_view rest = text_.substr(std::min(offset, text_.size()), 20);
  return findings_.fail(place, "this is no JSON: unexpected " + quote(rest),
                        "JSON has no comments, no trailing commas, and no NaN or Infinity");
}

}  // namespace

JsonKind Json::kind() const {
  return tree_->nodes[node_].kind;
}

std::optional<double> Json::number() const {
  if (kind() != JsonKind::number) return std::nullopt;
  return tree_->nodes[node_].number;
}

std::optional<bool> Json::boolean() const {
  if (kind() != JsonKind::boolean) return std::nullopt;
  return tree_->nodes[node_].number != 0;
}

std::optional<std::string_view> Json::string() const {
  if (kind() != JsonKind::string) return std::nullopt;
  const Node& node = tree_->nodes[node_];
  return std::string_view(tree_->texts).substr(node.first, node.count);
}

std::span<const double> Json::numbers() const {
  if (kind() != JsonKind::numbers) return {};
  const Node& node = tree_->nodes[node_];
  return std::span(tree_->numbers).subspan(node.first, node.count);
}

std::vector<Json> Json::items() const {
  std::vector<Json> result;
  if (kind() != JsonKind::array && kind() != JsonKind::object) return result;
  result.reserve(tree_->nodes[node_].count);
  for (auto i = tree_->nodes[node_].first; i != JsonTree::none; i = tree_->nodes[i].next) {
    result.emplace_back(*tree_, i);
  }
  return result;
}

std::optional<Json> Json::member(std::string_view name) const {
  if (!is_object()) return std::nullopt;
  for (auto i = tree_->nodes[node_].first; i != JsonTree::none; i = tree_->nodes[i].next) {
    if (name_of(*tree_, tree_->nodes[i]) == name) return Json{*tree_, i};
  }
  return std::nullopt;
}

std::string_view Json::name() const {
  return name_of(*tree_, tree_->nodes[node_]);
}

std::string Json::where() const {
  return place_of(*tree_, node_);
}

std::string Json::described() const {
  switch (kind()) {
    case JsonKind::null:
      return "`null`";
    case JsonKind::boolean:
      return *boolean() ? "`true`" : "`false`";
    case JsonKind::number:
      return "the number " + shown(*number());
    case JsonKind::string:
      return "the text " + quote(*string());
    case JsonKind::array:
      return tree_->nodes[node_].count == 0 ? "an empty array" : "an array";
    case JsonKind::numbers:
      return "an array of numbers";
    case JsonKind::object:
      return "an object";
  }
  return {};
}

std::variant<JsonTree, Failure> JsonTree::parse(std::string_view text, const Limits& limits) {
  Builder builder(text, limits);
  if (!nlohmann::json::sax_parse(text, &builder)) return builder.failure();
  return builder.take_tree();
}

}  // namespace rtac::geometry::import
