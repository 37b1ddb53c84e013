// From where runs begin that may show what is refuted, beside the places that its argument names.
#pragma once

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// To all obligations of the decision. Of what spends charge that nobody accounts for it says as
// well whether that is an argument, or takes a run.
void add_starts(const Subject& s, Decision& decision);

}  // namespace rtac::verify
