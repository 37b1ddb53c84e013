// Zones that are offered in place of the one that a recovery moves in, tried as numbers are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/analysis/common_zone.h"
#include "compiler/analysis/trials.h"
#include "compiler/ir/module.h"
#include "compiler/support/source.h"

namespace rtac::analysis {

// Whether `fault` is gone, nothing is wrong that was right, and no error of places is left in
// `all_of`, when `recovery` moves in what all of `parts` have in common instead of `from`. none: a
// zone is a slab, so that it cannot be tried.
std::optional<bool> works_within(Trials& trials, const Fault& fault, const SourceRange& all_of,
                                 const std::string& recovery, const ir::Module& module,
                                 ir::ZoneIndex from, const std::vector<ZonePart>& parts);
// Of a recovery in a zone without an end: "works, such as `land & rectangle ...`", of a box around
// what bounds the zone and around places that it has to get to; or else "is needed".
std::string with_an_end(Trials& trials, const Fault& fault, const SourceRange& all_of,
                        const ir::Module& module, const ir::Recovery& recovery,
                        const std::vector<ir::SiteTable::Place>& places);
// What is said of a zone that does not work alone, or that there was no time to try.
std::string needed_besides(const Trials* trials, const std::string& zone);
// What works_within tries, as in zone_text.h.
std::string written_as(const Trials& trials, const std::vector<ZonePart>& parts);

}  // namespace rtac::analysis
