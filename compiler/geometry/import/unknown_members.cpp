#include "compiler/geometry/import/unknown_members.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace rtac::geometry::import {
namespace {

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool is_capital(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

// `maxAltitude_m`: `max`, `altitude` and `m`.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  bool starts = true;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!is_letter(name[i])) {
      starts = true;
      continue;
    }
    const bool turns = i > 0 && is_capital(name[i]) && !is_capital(name[i - 1]);
    if (starts || turns) words.emplace_back();
    words.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    starts = false;
  }
  return words;
}

template <std::size_t n>
bool has_part(const std::string& text, const std::array<std::string_view, n>& parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return text.find(part) != std::string::npos; });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

}  // namespace

bool sounds_like_limit(std::string_view name) {
  // Long words also count as a part of others (`verticallimits`), short ones would be in too many.
  constexpr std::array<std::string_view, 11> parts{"limit",    "altitude",  "height",  "ceiling",
                                                   "vertical", "elevation", "radius",  "schedule",
                                                   "applicab", "exclusion", "interior"};
  constexpr std::array<std::string_view, 16> whole{
      "upper", "lower", "floor", "top",   "bottom", "min",  "max",   "alt",
      "hole",  "holes", "inner", "outer", "buffer", "unit", "units", "uom"};
  const std::vector<std::string> words = words_of(name);
  return has_part(joined(words), parts) ||
         std::any_of(words.begin(), words.end(), [&](const std::string& word) {
           return std::find(whole.begin(), whole.end(), word) != whole.end();
         });
}

bool is_limit_of_height(Json property) {
  constexpr std::array<std::string_view, 10> parts{
      "upperlimit", "lowerlimit", "verticallimit", "heightlimit", "altitude",
      "ceiling",    "maxheight",  "minheight",     "maxalt",      "minalt"};
  if (!has_part(joined(words_of(property.name())), parts)) return false;
  const auto text = property.string();
  if (!text) return property.kind() != JsonKind::null && !property.boolean();
  return std::any_of(text->begin(), text->end(),
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

bool UnknownMembers::check(Json object, std::initializer_list<std::string_view> known,
                           const std::string& help, Findings& findings) {
  for (const Json member : object.items()) {
    const std::string_view name = member.name();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (sounds_like_limit(name)) {
      return findings.fail(member.where(),
                           "is no member that the format has, and sounds like a limit", help);
    }
    if (!names_.emplace(name).second || names_.size() > notes_most + 1) continue;
    notes_.push_back(
        names_.size() > notes_most
            ? Note{member.where(), "like others, is no member that the format has: left out"}
            : Note{member.where(), "is no member that the format has, and is left out"});
  }
  return true;
}

void UnknownMembers::add_notes_to(std::vector<Note>& notes) const {
  notes.insert(notes.end(), notes_.begin(), notes_.end());
}

}  // namespace rtac::geometry::import
