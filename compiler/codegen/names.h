// The author's names in generated code: kept as they are, changed only where C or C++ requires it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

// An identifier that is neither a keyword nor reserved in C99 or C++17, nor a name that a standard
// header may define as a macro; a trailing `_` is added when it was.
std::string legal(const std::string& name);
// The same for a namespace, which collides with what libraries declare in the global one as well.
std::string legal_namespace(const std::string& name);
std::string camel(const std::string& name);  // plan_executor -> PlanExecutor, a_ -> A_
std::string upper(const std::string& name);  // plan_executor -> PLAN_EXECUTOR
// Any text, such as the name of a file, as an identifier: `_` for what no identifier has.
std::string word_of(const std::string& text);
// `bots[3].position` as one word, `bots_3_position`.
std::string signal_word(const std::string& signal);

// One identifier per name of a specification, with trailing `_` where it would clash: everything
// that is derived from the identifiers (`zone_NAME`, `NAME_limits`, ...) differs from each other
// and from what the kernel library and the generated classes declare themselves.
class Names {
 public:
  Names(const ir::Module& module, const sema::Spec& spec);
  // A name that the specification does not declare is only made legal.
  std::string operator()(const std::string& name) const;

 private:
  template <class Derived>
  void claim(const std::string& name, const Derived& derived);
  void claim_tables(const ir::Module& module);
  void claim_robots(const sema::Spec& spec);
  void claim_controllers(const sema::Spec& spec);
  void claim_decisions(const ir::Module& module);
  void claim_monitors(const ir::Module& module);
  void claim_watch(const ir::Module& module);

  std::map<std::string, std::string> identifiers_;
  std::set<std::string> taken_;  // "scope:identifier"
};

}  // namespace rtac::codegen
