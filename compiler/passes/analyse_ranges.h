// Input: the final values. Output: the range of every quantity; 7001 where a product of the
// kernel would leave 62 bits, with the numbers that caused it.
#pragma once

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"

namespace rtac::passes {

void analyse_ranges(ir::Module& module, diag::Engine& diagnostics);

}  // namespace rtac::passes
