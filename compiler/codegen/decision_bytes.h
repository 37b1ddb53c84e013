// The memory of a decision module.
#pragma once

#include <cstddef>

#include "compiler/ir/module.h"

namespace rtac::codegen {

// Size of the generated `struct M_state` on a machine with 8-byte alignment; of a decision with a
// period.
std::size_t decision_state_bytes(const ir::Decision& decision);

}  // namespace rtac::codegen
