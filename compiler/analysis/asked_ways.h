// By what ways of a recovery in the plane are known again while a specification is analysed.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/tables.h"
#include "compiler/geometry/kept.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

// All that ways and legs of a recovery hang on.
struct AskedWays {
  AskedWays(const std::vector<geometry::EdgeRow>& edges, const ir::Cells& cells,
            const ir::Decision& decision, const ir::Recovery& recovery)
      : drawn(edges, grid_of(cells)), numbers{static_cast<std::int64_t>(recovery.kind),
                                              recovery.route_clearance_mm,
                                              recovery.return_clearance_mm,
                                              starts_off_mm(decision, recovery),
                                              decision.body.radius_mm,
                                              decision.body.end_reach_mm,
                                              decision.body.position_error_mm} {}
  // Of those that are told apart.
  void add_sites(const ir::SiteTable& site) {
    for (std::size_t robot = 0; robot < site.places.size(); ++robot) {
      if (site.table_of(robot) != robot) continue;
      numbers.insert(numbers.end(), {site.places[robot].x_mm, site.places[robot].y_mm});
    }
  }
  bool operator==(const AskedWays&) const = default;

  geometry::Drawn drawn;
  std::vector<std::int64_t> numbers;
};

}  // namespace rtac::analysis
