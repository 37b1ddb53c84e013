// Asks `spin` whether the claims of a model hold of all of its runs.
#pragma once

#include <vector>

#include "compiler/protocol/protocol.h"

namespace rtac::driver {

// One answer for each claim, as far as they came in time; needs spin and a C compiler ($CC or cc).
std::vector<protocol::Answer> check_model(const protocol::Model& model);
// The same of a model that takes no more than seconds; of a larger one nothing is answered.
std::vector<protocol::Answer> check_small_model(const protocol::Model& model);

}  // namespace rtac::driver
