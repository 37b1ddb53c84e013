// All files of one module.
#pragma once

#include <string>
#include <vector>

#include "compiler/codegen/wrapper.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

struct GeneratedFile {
  std::string name;  // without a directory
  std::string text;
};

// `naming.space` may be empty: then it is the name of the specification.
// The same module always gives the same bytes. Nothing at all of a mutant that changes nothing in
// this module.
std::vector<GeneratedFile> generate(ir::Module module, const sema::Spec& spec, Naming naming);

}  // namespace rtac::codegen
