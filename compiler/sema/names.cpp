#include "compiler/sema/names.h"

namespace rtac::sema {

const char* name_of(Sort sort) {
  switch (sort) {
    case Sort::zone:
      return "zone";
    case Sort::robot_kind:
      return "kind of robot";
    case Sort::robot:
      return "robot";
    case Sort::fleet:
      return "numbered fleet";
    case Sort::site:
      return "site";
    case Sort::controller:
      return "controller";
    case Sort::monitor:
      return "monitor";
    case Sort::watch:
      return "monitor without a robot";
    case Sort::decision:
      return "decision";
    case Sort::input:
      return "input";
    case Sort::parameter:
      return "parameter";
    case Sort::enumeration:
      return "enumeration";
    case Sort::enum_value:
      return "value of an enumeration";
    case Sort::function:
      return "function";
    case Sort::frame:
      return "frame";
    case Sort::agent:
      return "agent";
    case Sort::agents:
      return "group of agents";
  }
  return "";
}

std::string a_name_of(Sort sort) {
  const bool vowel = sort == Sort::input || sort == Sort::enumeration || sort == Sort::agent;
  return std::string(vowel ? "an " : "a ") + name_of(sort);
}

const char* plural_of(Sort sort) {
  switch (sort) {
    case Sort::zone:
      return "zones";
    case Sort::robot_kind:
      return "kinds of robots";
    case Sort::robot:
      return "robots";
    case Sort::fleet:
      return "numbered fleets";
    case Sort::site:
      return "sites";
    case Sort::controller:
      return "controllers";
    case Sort::monitor:
      return "monitors";
    case Sort::watch:
      return "monitors without a robot";
    case Sort::decision:
      return "decisions";
    case Sort::input:
      return "inputs";
    case Sort::parameter:
      return "parameters";
    case Sort::enumeration:
      return "enumerations";
    case Sort::enum_value:
      return "values of enumerations";
    case Sort::function:
      return "functions";
    case Sort::frame:
      return "frames";
    case Sort::agent:
      return "agents";
    case Sort::agents:
      return "groups of agents";
  }
  return "";
}

const Symbol* Symbols::add(const std::string& name, const Symbol& symbol) {
  const auto [place, added] = symbols_.emplace(name, symbol);
  if (added) names_[symbol.sort].insert(name);
  return added ? nullptr : &place->second;
}

void Symbols::remove(const std::string& name) {
  const auto place = symbols_.find(name);
  if (place == symbols_.end()) return;
  names_[place->second.sort].erase(name);
  symbols_.erase(place);
}

const Symbol* Symbols::find(std::string_view name) const {
  const auto place = symbols_.find(name);
  return place == symbols_.end() ? nullptr : &place->second;
}

std::vector<std::string> Symbols::names_of(Sort sort) const {
  const auto names = names_.find(sort);
  if (names == names_.end()) return {};
  return {names->second.begin(), names->second.end()};
}

}  // namespace rtac::sema
