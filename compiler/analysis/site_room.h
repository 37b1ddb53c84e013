// Whether there is a way to a site from everywhere around it, and how near to it one rests.
#pragma once

#include <cstdint>
#include <optional>

#include "compiler/analysis/ways_in.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// A robot is charged so near to its dock (language rule 6.7).
inline constexpr std::int64_t dock_reach_mm = 150;
// Whether a recovery goes to where its robot is charged, and how far from there errors and pushes
// that last may let it rest.
bool goes_to_charge(const sema::RobotKind& kind, const sema::Spec& spec, const ir::Module& module,
                    const ir::Recovery& way);
inline std::int64_t rests_off_mm(const ir::Body& body) {
  return body.end_reach_mm + body.sway_mm;
}

// A place of a site that has cells without a way home around it.
struct Cramped {
  PlaceMm at;
  std::optional<PlaceMm> works;  // the nearest place that has none; none: there is no such place
};
// Of the cells within `radius_mm` of a place of the site, in x and y, each has to have a way.
std::optional<Cramped> cramped_site(const ir::Module& module, ir::SiteIndex site,
                                    std::int64_t radius_mm);

}  // namespace rtac::analysis
