// Input, output: any block. Each value is computed once, and only if the result needs it.
//
//   %0 = const 0 : mm                     %0 = const 0 : mm
//   %1 = const 0 : mm               ->    %1 = clearance free : mm
//   %2 = clearance free : mm              %2 = at_least %1, %0 : margin
//   %3 = at_least %2, %1 : margin
#pragma once

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"

namespace rtac::passes {

void share_values(ir::Module& module, diag::Engine& diagnostics);

}  // namespace rtac::passes
