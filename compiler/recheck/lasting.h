// How long a recovery lasts and how far it drives, which a charge pays for in advance (language
// rule 6.7), from the specification.
#pragma once

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// Whether a property speaks of charge, so that who drives for `driving` has to come to an end; not
// where it stays on one side of an `or`.
bool spends_charge(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                   const sema::Monitor& driving, const sema::Expr& property);

// The claim that the recovery of `monitor` lasts and drives no longer than it says, and that this
// is within `held` and `detour`. Taken from the claim: the clearance that its legs keep, and how
// deep it aims beyond what its errors ask for.
std::optional<Doubt> check_lasting(const sema::Spec& spec, const sema::Decision& decision,
                                   Claims& claims, const sema::Monitor& monitor, const Values& v);

}  // namespace rtac::recheck
