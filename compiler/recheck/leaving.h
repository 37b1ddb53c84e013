// Zones that come and go: that a recovery leads out in time, and keeps what is asked for on its way
// (language rule 9.4), from the specification.
#pragma once

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// The claim that the recovery of `monitor` has led out `leave_us` after it took over, whenever a
// zone comes or goes, and keeps what the property says on its way. Taken from the claim: the
// clearance that its legs keep.
std::optional<Doubt> check_leaving(const sema::Spec& spec, const sema::Decision& decision,
                                   Claims& claims, const sema::Monitor& monitor, const Values& v);

}  // namespace rtac::recheck
