// The manifest: what was generated from what, for tools and for the evidence.
#pragma once

#include <string>

#include "compiler/codegen/wrapper.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::codegen {

std::string manifest(const ir::Module& module, const sema::Spec& spec, const Naming& naming);

}  // namespace rtac::codegen
