// What `rtac-sim` is told of a module: robots, zones, recoveries, and the properties as they are
// written. It is all that the simulator knows besides the compiled kernel.
#pragma once

#include <string>
#include <vector>

#include "compiler/codegen/mutate.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

struct Simulation {
  std::string manifest;               // JSON
  std::vector<std::string> problems;  // why it cannot be simulated; empty: it can
};

// The decisions with a period, each with its number among all decisions of fleets: that of the
// functions of the compiled kernel. Properties come from the checked specification and not from the
// IR, so that who judges by them shares nothing with what was generated. Of a mutant only what it
// does to recoveries is told: what is true stays as it is declared.
Simulation simulation(const ir::Module& module, const sema::Spec& spec, const ir::TableMap& tables,
                      const std::string& source, const Mutant* mutant);

}  // namespace rtac::codegen
