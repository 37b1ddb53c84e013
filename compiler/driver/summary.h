// What `rtac check` prints: the derived numbers of every decision.
#pragma once

#include <string>

#include "compiler/ir/module.h"

namespace rtac::driver {

std::string summary(const ir::Module& module);

}  // namespace rtac::driver
