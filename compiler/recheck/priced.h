// Whether ways to a site are known from all around it, found once more from exact outlines.
#pragma once

#include <optional>

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// Of a monitor that asks for the charge of the way to the site that its recovery leads to, over
// cells as clear as `route`: that the way is priced from all that its samples leave open to a robot
// that rests there. Else no charge is enough, and control is never given back.
std::optional<Doubt> check_priced(const sema::Spec& spec, const sema::Decision& d,
                                  const Claims& claims, const sema::Monitor& m,
                                  const geometry::Region& zone, const Cells& cells,
                                  const Rational& route);

}  // namespace rtac::recheck
