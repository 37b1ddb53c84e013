// Zones of many edges, opened by the kernel to recoveries and applications: their tables, and the
// questions that decisions do not ask. A module whose zones are all small has none of this: the
// runtime looks at all edges of those, and the functions would be longer than the tables.
#pragma once

#include <set>
#include <string>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

bool has_areas(const ir::Module& module);
// `free` -> `spec_free_area`
std::string area_symbol(const ir::Module& module, const ir::ZoneTable& zone, const Names& names);
// For the header of the kernel.
void print_area_declarations(const ir::Module& module, const Names& names, Code& out);
// For its source, behind the tables of the zones, which are called `<symbol>_edges` and so on.
void print_area(const ir::Module& module, const ir::ZoneTable& zone, const std::string& symbol,
                const Names& names, Code& out);
// What the library has to hold for them.
void use_areas(const ir::Module& module, std::set<std::string>& uses);

}  // namespace rtac::codegen
