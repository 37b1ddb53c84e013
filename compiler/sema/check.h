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

}  // namespace rtac::sema
