// Prints the decision kernels of a module: C99 that is C++17 too, integers only, no calls out.
#pragma once

#include <string>

#include "compiler/codegen/names.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

// `stem`: base name of the generated files; `source`: base name of the specification.
std::string kernel_header(const ir::Module& module, const Names& names, const std::string& stem,
                          const std::string& source);
std::string kernel_source(const ir::Module& module, const Names& names, const std::string& stem,
                          const std::string& source);

}  // namespace rtac::codegen
