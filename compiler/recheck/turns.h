// The switching protocol: what its model takes for granted is shown elsewhere in the report, or by
// the specification, and the model is the one that follows from both.
#pragma once

#include "compiler/recheck/written.h"

namespace rtac::recheck {

std::optional<Doubt> check_turns(const sema::Spec& spec, const sema::Decision& d, const Part& part,
                                 const Claim& claim, Claims& claims, const ProveModel& prove);

}  // namespace rtac::recheck
