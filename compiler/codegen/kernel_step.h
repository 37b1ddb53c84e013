// The step function of a periodic decision and the judge function of one on a plan.
#pragma once

#include <set>
#include <string>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

void print_step(const ir::Module& module, const ir::Decision& decision, const Names& names,
                std::set<std::string>& uses, Code& out);
void print_judge(const ir::Module& module, const ir::Decision& decision, const Names& names,
                 std::set<std::string>& uses, Code& out);

}  // namespace rtac::codegen
