// What the properties of a decision keep beyond "not touching", however they are written.
#pragma once

#include <cstdint>

#include "compiler/sema/spec.h"

namespace rtac::analysis {

// Largest c of atoms like `clearance(r, zone) >= c` and `distance(r, q) >= c`, in mm, rounded up.
struct Standoffs {
  std::int64_t fence_mm = 0, separation_mm = 0;
};

// Raises `wanted` to what `property` asks for. The same atoms count as in the look-ahead: those
// that are linear in one clearance or one distance.
void ask_for_standoffs(const sema::Expr& property, Standoffs& wanted);

}  // namespace rtac::analysis
