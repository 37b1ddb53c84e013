// What recoveries stay in: each zone that one moves within against the zones that a property keeps
// the robot in (language rules 11 and 12), as obligations rest on it.
#pragma once

#include <string>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

bool moves_within_zones(const ir::Recovery& recovery);

// That each step of the recovery of monitor `k` stays within the zones of the property of monitor
// `of`, or keeps one side of it.
void claim_zones(const Subject& s, std::size_t k, std::size_t of, std::vector<Claim>& claims);

// Why that is not shown.
Doubt doubt_of_zones(const Subject& s, std::size_t k, std::size_t judged);

}  // namespace rtac::verify
