// Who waits at a dock until others are charged (language rule 6.7), as it is written.
#pragma once

#include "compiler/sema/spec.h"

namespace rtac::recheck {

// Whether robots of the decision that cannot be at their docks at once, by their bodies and by what
// monitors keep between them, take longer than `held` until all but one are charged, from
// nothing up to what has to be so before control is given back there. Not where their number is not
// known.
bool docks_for_longer(const sema::Spec& spec, const sema::Decision& decision,
                      const sema::Monitor& charge);

}  // namespace rtac::recheck
