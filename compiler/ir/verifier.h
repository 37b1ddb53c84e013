// What every pass may rely on and must keep. A breach is a bug of the compiler.
#pragma once

#include <optional>
#include <string>

#include "compiler/ir/module.h"

namespace rtac::ir {

// nullopt: well-formed; otherwise what is wrong and where, for an internal error.
std::optional<std::string> verify(const Module& module);

}  // namespace rtac::ir
