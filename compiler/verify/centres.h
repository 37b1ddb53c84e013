// Where robots may start, for runs that are to show something.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// By which a property holds at the start: what a robot at rest may give way, measured badly.
inline constexpr std::int64_t start_spare_mm = 15;

// Where the centre of a body is while the property holds with `more_mm` to spare, as far as zones
// of the plane are concerned.
geometry::Region centres_of(const Subject& s, const ir::Monitor& m, std::int64_t more_mm);
// Of a property with a limit of speed on one side of an `or` ("slow, or far from the school"):
// where the other side holds, so that a robot of any speed is allowed there.
geometry::Region unlimited(const Subject& s, const ir::Monitor& m);
// A place of a region that is about as far from its boundary as any, in mm; none: it is empty.
std::optional<std::pair<std::int64_t, std::int64_t>> deep_in(const geometry::Region& region);

}  // namespace rtac::verify
