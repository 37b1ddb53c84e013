// The setters of the plain inputs and parameters of a decision.
#pragma once

#include "compiler/codegen/signal_setters.h"

namespace rtac::codegen {

inline SignalSetters decision_setters(const ir::Decision& d, const Names& names) {
  const std::string name = camel(names(d.name));
  return {d.facts,
          names,
          {name, "in_.facts.", "state_.facts."},
          {name, "position", "velocity", "battery", "heading", "plan", "heard", "sent", "proposed",
           "step", "info", "reset", "state_", "in_", "record_"}};
}

}  // namespace rtac::codegen
