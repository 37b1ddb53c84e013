// Prints the runtime of the system that a specification describes: its robots, one RTA module per
// decision and robot, the recoveries, and one typed slot for every external controller.
#pragma once

#include <string>

#include "compiler/codegen/names.h"
#include "compiler/codegen/wrapper.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

std::string system_header(const ir::Module& module, const sema::Spec& spec, const Names& names,
                          const Naming& naming);

}  // namespace rtac::codegen
