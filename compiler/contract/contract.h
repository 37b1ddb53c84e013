// A kernel with contracts in ACSL, which are comments of C, for Frama-C to prove. Those of the
// library stand in acsl/*.acsl; those of decisions and monitors are made of the checked
// specification alone, so that a mistake of analysis, passes or code generation is not repeated in
// what the kernel is held against. What is proved and what is not: compiler/docs/kernel_proof.md.
#pragma once

#include <string>
#include <vector>

#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::contract {

struct Contracts {
  std::string text;  // of the library's form, see notes.h
  // What no contract says yet: a property, and why; the proof is none without it.
  std::vector<std::string> gaps;
};
// `prefix`: of what the kernel declares, the name of the specification. `sources`: a zone without a
// name is called by its line.
Contracts contracts_of(const sema::Spec& spec, const SourceManager& sources,
                       const std::string& prefix);

struct Annotated {
  std::string text;                  // the kernel with its contracts
  std::vector<std::string> missing;  // functions without a contract, contracts without a place
};
// `kernel`: the text of a generated kernel. Its tables of edges and cells are declared, not
// defined: no proof looks into them.
Annotated annotate(const std::string& kernel, const std::string& prefix,
                   const std::string& contracts);

}  // namespace rtac::contract
