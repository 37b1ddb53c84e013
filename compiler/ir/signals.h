// Plain inputs and parameters on their grids, and who uses which of them.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::ir {

// In the order of the specification.
struct Signals {
  std::vector<Channel> inputs;
  std::vector<Param> params;
};
// A range that does not end on the grid ends inside, errors are rounded up. A grid finer than a
// millionth of the scale is refused (7001).
Signals build_signals(const sema::Spec& spec, diag::Engine& diagnostics);

// What properties speak of.
struct UsedSignals {
  std::set<sema::InputId> inputs;
  std::set<sema::ParamId> params;
  void add(const sema::Spec& spec, const sema::Expr& expr);
  void add(const sema::Spec& spec, const sema::Monitor& monitor);
};

// The index in the watch, which has them.
std::uint32_t channel_of(const Watch& watch, const std::string& name);
std::uint32_t param_of(const Watch& watch, const std::string& name);

}  // namespace rtac::ir
