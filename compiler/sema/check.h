// Semantic checks: names, types, units, ranges. Reports, never rewrites the tree.
#pragma once

#include <optional>

#include "compiler/diagnostics/engine.h"
#include "compiler/sema/spec.h"
#include "compiler/syntax/ast.h"

namespace rtac::sema {

// Input: a parsed program (root file last). Output: the checked specification, or nullopt when
// any error was reported. One mistake, one error: what depends on a faulty declaration is silent.
std::optional<Spec> check(const syntax::Program& program, diag::Engine& diagnostics);
// The same, but for errors that refute what a decision is obliged to, and leave no doubt about what
// was meant: no recovery (5002), limits that contradict each other (5005), two that write one
// output (5011). With nothing but these the specification is there, to say of what; nothing can be
// derived.
std::optional<Spec> check_refuted(const syntax::Program& program, diag::Engine& diagnostics);

}  // namespace rtac::sema
