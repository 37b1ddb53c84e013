// What the obligations about a recovery share: how one begins, what the specification accepts, and
// what is not known of any way of a recovery.
#pragma once

#include <functional>
#include <string>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

Obligation blank(const Subject& s, std::size_t k, Kind kind);
// Unknown, without a claim.
Obligation doubted(Obligation o, Doubt doubt);
Obligation acknowledged(Obligation o, std::string why);

// Why it is accepted that a recovery breaks what a monitor says; "": it is not.
std::string reason(const ir::Decision& decision, const std::string& recovery,
                   const std::string& monitor);
// What the author writes where the look-ahead is less than it takes; "": it is enough.
std::string unsound_reason(const Subject& s, std::size_t k);
// What is accepted need not be so. Of a monitor that asks for places or charge what is proved
// counts; of others the acknowledgement accepts what is reported otherwise (5030 and on), and no
// proof looks at that.
Obligation unless_accepted(const Subject& s, std::size_t k, Kind kind,
                           const std::function<Obligation()>& prove);

// Who goes to a site to be charged has to rest so near to it (language rule 6.7); "": it does.
std::string off_its_dock(const Subject& s, const ir::Recovery& last);
// In space the hold of who moves leads the robot, which follows as long as its brake is not spent:
// beyond, nothing is known of its ways.
Doubt falls_behind(const Subject& s, const ir::Recovery& recovery);

Claim recovery_claim(const Subject& s, std::size_t k);

}  // namespace rtac::verify
