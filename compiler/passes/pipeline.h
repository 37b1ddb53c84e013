// The ordered list of passes. After each one the IR verifier runs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"

namespace rtac::passes {

struct Pass {
  const char* name;
  void (*run)(ir::Module&, diag::Engine&);
};
// In order, with the reason for the order in pipeline.cpp.
const std::vector<Pass>& pipeline();

// Runs every pass; `after` is told the name of each one that ran. Returns a text when a pass left
// the IR malformed: a bug of the compiler, to be shown as an internal error.
std::optional<std::string> run_pipeline(ir::Module& module, diag::Engine& diagnostics,
                                        const std::function<void(const Pass&)>& after);

}  // namespace rtac::passes
