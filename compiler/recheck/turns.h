// The switching protocol: what its model takes for granted is shown elsewhere in the report, or by
// the specification, and the model is the one that follows from both.
#pragma once

#include "compiler/recheck/written.h"

namespace rtac::recheck {

// `accepting`: what the specification accepts counts as if it did not happen, pairs that it
// acknowledges and recoveries that need not lead out.
std::optional<Doubt> check_turns(const sema::Spec& spec, const sema::Decision& d, const Part& part,
                                 const Claim& claim, bool accepting, Claims& claims,
                                 const ProveModel& prove);

}  // namespace rtac::recheck
