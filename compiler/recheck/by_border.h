// A retreat that drives beside the border of its zone alone, and one around what its property keeps
// it off (docs/templates.md).
#pragma once

#include <optional>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// The claim that wherever the recovery of a monitor sets out while another one holds, the robot is
// no farther from the border of its zone than is said, and that all of the zone which is as near
// lies in another one, as far from the boundary of that as is claimed.
std::optional<Doubt> check_by_border(const sema::Spec& spec, const sema::Decision& decision,
                                     Claims& claims, const Values& v);

// The claim that it keeps as far off the boundary of another zone as is claimed: its own property
// has the robot there where it sets out, and from beside other walls no way leads so near.
std::optional<Doubt> check_around(const sema::Spec& spec, const sema::Decision& decision,
                                  Claims& claims, const Values& v);

}  // namespace rtac::recheck
