// Zones that come and go: that a recovery leads out in time, along ways that keep what is asked for
// while they are at their worst (language rule 9.4). docs/templates.md has the argument.
#pragma once

#include <string>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// Why it is not shown that the recovery of monitor `k` leads out in time, and keeps what the
// monitor says on its way; "": it is. Of the parts of its property that speak of such zones.
std::string doubt_of_leaving(const Subject& s, std::size_t k);
Claim leaves_claim(const Subject& s, std::size_t k);

}  // namespace rtac::verify
