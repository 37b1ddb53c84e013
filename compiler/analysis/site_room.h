// Whether there is a way to a site from everywhere around it.
#pragma once

#include <optional>

#include "compiler/analysis/ways_in.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// A place of a site that has cells without a way home around it.
struct Cramped {
  PlaceMm at;
  std::optional<PlaceMm> works;  // the nearest place that has none; none: there is no such place
};
// Of the cells within `radius_mm` of a place of the site, in x and y, each has to have a way.
std::optional<Cramped> cramped_site(const ir::Module& module, ir::SiteIndex site,
                                    std::int64_t radius_mm);

}  // namespace rtac::analysis
