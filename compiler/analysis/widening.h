// How much wider a zone would have to be: tried on its cells.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/analysis/trials.h"
#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"
#include "compiler/geometry/solid.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// Of a zone, whether it works.
using FitsZone =
    std::function<bool(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells)>;

// The least growth on every side, in mm, with which `fits` holds of the zone, and of
// no growth that is 1 mm less, if then `whole`, which is asked once, holds, too; at most `most_mm`,
// and looked for from `guess_mm` on. None: it does not help, or the zone is so large that to try
// takes long.
std::optional<std::int64_t> widening_mm(const geometry::Region& zone, std::int64_t guess_mm,
                                        std::int64_t most_mm, const FitsZone& fits,
                                        const FitsZone& whole = {});

// What a zone is written as, within `grow`, or with a negative distance within `shrink`; and as it
// was.
void offset(sema::ZoneExprPtr& value, std::int64_t by_mm);
void take_offset_back(sema::ZoneExprPtr& value);

// Of the plane, or in space.
using ExactShape = std::variant<geometry::Region, geometry::Solid>;

// "`grow(yard, 0.2 m)` in place of `yard` works": of a distance that the author has written in the
// zone, what there may be of it (distance_that_works); else the least growth of the zone with which
// the whole specification has been tried, looked for from `guess_mm` to `most_mm`, and no less than
// `least_mm`, which is no more than the guess; and where that would reach into what the zone leaves
// out, or is kept off by a distance, of the zone around. None: as of other numbers
// (Trials::nearest), or what the zone leaves out would be grown over.
std::optional<std::string> growth_that_works(Trials& trials, ir::ZoneIndex zone,
                                             const ExactShape& exact, std::int64_t guess_mm,
                                             std::int64_t most_mm, const Fault& fault,
                                             std::int64_t least_mm = 0);

// "`grow(shrink(yard, 0.8 m), 0.8 m)`, ..., in place of `yard` works": the zone without what is
// narrower than twice the least distance with which the whole specification has been tried, looked
// for from `guess_mm` to `most_mm`. None: as of its growth, or it has no name.
std::optional<std::string> opening_that_works(Trials& trials, ir::ZoneIndex zone,
                                              std::int64_t guess_mm, std::int64_t most_mm,
                                              const Fault& fault);

// "`grow(pond, 0.4 m)` in place of `grow(pond, 0.5 m)` works": of the distances that a zone is
// written with, or one without a name in it, the first that makes it wider by about `guess_mm`, and
// with which the whole specification has been tried.
std::optional<std::string> distance_that_works(Trials& trials, ir::ZoneIndex zone,
                                               std::int64_t guess_mm, const Fault& fault);

}  // namespace rtac::analysis
