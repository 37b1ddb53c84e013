// Deliberately unsound variants of a decision: natural first attempts at what the theory forbids.
// They exist to be killed by simulation; whoever survives one has not looked.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::codegen {

// An edit of the text of a generated kernel: every place of `from`.
struct TextEdit {
  const char *from, *to;
};
struct Mutant {
  const char* name;
  const char* about;            // what it believes
  void (*edit)(ir::Decision&);  // may be null
  std::vector<TextEdit> text;
  void (*of_recovery)(ir::Recovery&) = nullptr;
  // Without it no decision changes, whatever is edited; null: edits tell.
  bool (*matters)(const ir::Decision&) = nullptr;
};

const std::vector<Mutant>& mutants();
// nullptr: none has this name.
const Mutant* find_mutant(const std::string& name);
std::string mutant_names();

// Whether it may change any decision. A function whose contract is proved alone may be wrong all
// the same: only what is run asks for this.
bool may_matter(const Mutant& mutant, const ir::Module& module);

// Of all decisions.
void mutate(const Mutant& mutant, ir::Module& module);
void mutate(const Mutant& mutant, ir::Recovery& recovery);
std::string mutate(const Mutant& mutant, std::string kernel_source);

// What every generated file of it says about itself.
std::string mark_of(const Mutant& mutant);

}  // namespace rtac::codegen
