// Prints the C++17 side of a module: one class per decision around its kernel, the tables of the
// decision record, the zones for safe controllers and pictures, the limits of the robots.
#pragma once

#include <string>

#include "compiler/codegen/names.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

struct Naming {
  std::string stem;      // base name of the generated files
  std::string source;    // base name of the specification
  std::string space;     // C++ namespace
  std::string mutant{};  // name of a deliberately unsound variant (mutate.h); empty: none
};

std::string wrapper_header(const ir::Module& module, const sema::Spec& spec, const Names& names,
                           const Naming& naming);
std::string wrapper_source(const ir::Module& module, const sema::Spec& spec, const Names& names,
                           const Naming& naming);

}  // namespace rtac::codegen
