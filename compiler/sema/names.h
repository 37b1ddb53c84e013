// The table of declared names. All sorts of declarations share one space of names, so that a name
// means one thing in the whole specification.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/support/source.h"

namespace rtac::sema {

enum class Sort {
  zone,
  robot_kind,
  robot,
  fleet,  // of numbered robots
  site,
  controller,
  monitor,  // of a robot
  watch,    // a monitor without a robot
  decision,
  input,
  parameter,
  enumeration,
  enum_value,
  function,
  frame,
  agent,
  agents,  // numbered ones
};

const char* name_of(Sort sort);    // "kind of robot"
std::string a_name_of(Sort sort);  // "a kind of robot", "an input"
const char* plural_of(Sort sort);  // "kinds of robots"

struct Symbol {
  Sort sort;
  std::uint32_t index;  // the id within its sort
  SourceRange range;    // of the name where it is declared
};

class Symbols {
 public:
  // The symbol that already has this name, else nullptr and `symbol` is kept.
  const Symbol* add(const std::string& name, const Symbol& symbol);
  void remove(const std::string& name);
  [[nodiscard]] const Symbol* find(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> names_of(Sort sort) const;  // in alphabetical order

 private:
  std::map<std::string, Symbol, std::less<>> symbols_;
  std::map<Sort, std::set<std::string>> names_;  // the same, for suggestions
};

}  // namespace rtac::sema
