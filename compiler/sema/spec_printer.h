// The canonical text of a checked specification: `--dump-spec`, and what tests compare.
#pragma once

#include <string>

#include "compiler/sema/spec.h"

namespace rtac::sema {

// One declaration after the other, in the order of their ids; quantities in SI units (a ratio in
// per cent), properties fully bracketed; without places, so that it is stable under reformatting.
std::string dump(const Spec& spec);

// One property: `(clearance(self, room) >= 0.12 m)`. The monitored robot is `self`, the robot of
// the quantifier `other`.
std::string dump(const Spec& spec, const Expr& expr);

// A zone expression; a zone without a name is written out where it is used.
std::string dump(const Spec& spec, const ZoneExpr& expr);

}  // namespace rtac::sema
