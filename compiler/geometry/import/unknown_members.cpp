#include "compiler/geometry/import/unknown_members.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/import/property_limits.h"
#include "compiler/geometry/import/words.h"

namespace rtac::geometry::import {

bool sounds_like_limit(std::string_view name) {
  // Long words also count as a part of others (`verticallimits`), short ones would be in too many.
  constexpr std::array<std::string_view, 11> parts{"limit",    "altitude",  "height",  "ceiling",
                                                   "vertical", "elevation", "radius",  "schedule",
                                                   "applicab", "exclusion", "interior"};
  constexpr std::array<std::string_view, 16> whole{
      "upper", "lower", "floor", "top",   "bottom", "min",  "max",   "alt",
      "hole",  "holes", "inner", "outer", "buffer", "unit", "units", "uom"};
  const std::vector<std::string> words = words_of(name);
  return has_part(joined(words), parts) || has_word(words, whole);
}

bool UnknownMembers::check(Json object, std::initializer_list<std::string_view> known,
                           const std::string& help, Findings& findings) {
  for (const Json member : object.items()) {
    const std::string_view name = member.name();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (sounds_like_limit(name) || is_limit_of_height(member) || is_limit_of_time(member)) {
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
