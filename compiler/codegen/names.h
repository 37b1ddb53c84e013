// The author's names in generated code: kept as they are, changed only where C or C++ requires it.
#pragma once

#include <set>
#include <string>

namespace rtac::codegen {

// An identifier that is neither a keyword nor reserved in C99 or C++17, nor a name that a standard
// header may define as a macro; a trailing `_` is added when it was.
std::string legal(const std::string& name);
std::string camel(const std::string& name);  // plan_executor -> PlanExecutor
std::string upper(const std::string& name);  // plan_executor -> PLAN_EXECUTOR

// Hands out names that differ from each other; a clash gets a trailing `_`.
class NameScope {
 public:
  std::string claim(const std::string& name);

 private:
  std::set<std::string> taken_;
};

}  // namespace rtac::codegen
