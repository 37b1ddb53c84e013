// How long a recovery lasts and how far it drives, which a charge pays for in advance (language
// rule 6.7), from the specification.
#pragma once

#include <optional>
#include <string>

#include "compiler/recheck/claims.h"
#include "compiler/recheck/written.h"

namespace rtac::recheck {

// Whether a property speaks of charge, so that who drives for `driving` has to come to an end; not
// where it stays on one side of an `or`.
bool spends_charge(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                   const sema::Monitor& driving, const sema::Expr& property);

// Why all that claims of a part let `driving` and other recoveries take before the one of `charge`
// drives may be more than `held` and `detour`, each of them once: where one leads away from where
// it is charged, the robot has to get back as well. Of others nobody has accepted that they break
// it.
std::optional<std::string> takes_too_much(const sema::Spec& spec, const sema::Decision& decision,
                                          const Part& part, const sema::Monitor& charge,
                                          const std::string& driving);

// The claim that the recovery of `monitor` lasts and drives no longer than it says. Taken from the
// claim: the clearance that its legs keep, and how deep it aims beyond what its errors ask for.
std::optional<Doubt> check_lasting(const sema::Spec& spec, const sema::Decision& decision,
                                   Claims& claims, const sema::Monitor& monitor, const Values& v);

}  // namespace rtac::recheck
