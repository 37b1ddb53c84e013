// Members of JSON that a format does not have, and files have all the same. What limits an area
// must not be lost, and nothing is left out without a word. Internal to this folder.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/geometry/import/json_tree.h"
#include "compiler/geometry/import/outlines.h"

namespace rtac::geometry::import {

// Does the name speak of heights, holes, a radius, units or schedules? `upper_limit`,
// `maxAltitude`.
bool sounds_like_limit(std::string_view name);

class UnknownMembers {
 public:
  // A member that is none of the known fails when it sounds like a limit, with this help; the first
  // of every other name is noted.
  bool check(Json object, std::initializer_list<std::string_view> known, const std::string& help,
             Findings& findings);
  void add_notes_to(std::vector<Note>& notes) const;

 private:
  static constexpr std::size_t notes_most = 20;
  std::set<std::string, std::less<>> names_;
  std::vector<Note> notes_;
};

}  // namespace rtac::geometry::import
