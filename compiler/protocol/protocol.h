// The switching protocol of a decision as a model in Promela, for `spin`: what kernel and plan
// executor do in a tick, everything that may happen to them, and what is claimed of all runs. What
// is left out, and why that is sound: compiler/docs/protocol.md.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::protocol {

// What the model takes for granted of the recoveries of a decision, when nothing comes from
// outside. A row is the recovery of a monitor, a column a monitor, both by priority.
struct Arbitration {
  // While recovery i drives, monitor j does not engage.
  std::vector<std::vector<bool>> keeps;
  // Where the return conditions of monitor i hold under its recovery, the derived one of j does.
  std::vector<std::vector<bool>> settles;
};
// Both of all pairs, but of those that the specification acknowledges.
Arbitration assumed(const ir::Decision& decision);

// The parts follow each other in one file.
struct Model {
  std::string decision;     // its name
  std::string rules;        // numbers, names, and what a tick does with what it finds
  std::string environment;  // what it may find
  std::string claims;       // formulas of linear temporal logic
  std::vector<std::string> claim_names;
  [[nodiscard]] std::string text() const { return rules + environment + claims; }
};

// `source`: name of the specification's file. The decision may be one `on plan`, too; it remembers
// nothing, and `arbitration` plays no part.
Model protocol_model(const ir::Decision& decision, const Arbitration& arbitration,
                     const std::string& source);

}  // namespace rtac::protocol
