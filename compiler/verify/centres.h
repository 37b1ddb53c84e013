// Where robots may start, for runs that are to show something.
#pragma once

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// By which a property holds at the start: what a robot at rest may give way, measured badly.
inline constexpr std::int64_t start_spare_mm = 15;

// Where the centre of a body is while the property holds with `more_mm` to spare, as far as zones
// of the plane are concerned.
geometry::Region centres_of(const Subject& s, const ir::Monitor& m, std::int64_t more_mm);

}  // namespace rtac::verify
