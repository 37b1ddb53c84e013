// Input: monitors with a property block. Output: their `ahead` block, the property on everything
// within reach, and `unit` and `separation_mm`; `unit` is none when atoms of different units
// decide. Invariant: every atom of a property with robot state is replaced by its registered
// transformer (lookahead/registry.h); an atom without one is an error (5006). What parameters add
// to a limit stays a value of the block; facts are judged now. A block that judges legs checks the
// tracking, too.
//
//   %0 = clearance free : mm              %0 = zone_reach free, least 0 : margin
//   %1 = const 0 : mm               ->    %1 = legs_in_zone free, legs 2, need 210 : margin
//   %2 = at_least %0, %1 : margin         %2 = and %0, %1 : margin
//                                         %3 = on_track within 100 : margin
//                                         %4 = and %2, %3 : margin
#pragma once

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"

namespace rtac::passes {

void expand_lookahead(ir::Module& module, diag::Engine& diagnostics);

}  // namespace rtac::passes
