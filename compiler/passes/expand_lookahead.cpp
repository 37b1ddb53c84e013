#include "compiler/passes/expand_lookahead.h"

#include "compiler/passes/lookahead/expansion.h"

namespace rtac::passes {

using namespace ir;

void expand_lookahead(Module& module, diag::Engine& diagnostics) {
  for (Decision& decision : module.decisions) {
    for (Monitor& monitor : decision.monitors) {
      // on a plan there is nothing to look ahead, but the same forms can be judged
      Block ahead = lookahead::Expansion(module, decision, monitor, diagnostics).run();
      if (decision.on_plan) {
        monitor.unit = Unit::mm;  // of legs
      } else {
        monitor.ahead = std::move(ahead);
      }
    }
  }
}

}  // namespace rtac::passes
