// Whether something is true whatever the robot is told.
#pragma once

#include "compiler/recheck/told.h"
#include "compiler/sema/spec.h"

namespace rtac::recheck {

// Whether a property is true whatever its inputs are, each condition on them the same wherever it
// is written; of what robots sense, what `may_be` says. false too: it has very many conditions.
bool true_whatever_told(const sema::Spec& spec, const sema::Expr& property, const MayBe& may_be);

}  // namespace rtac::recheck
