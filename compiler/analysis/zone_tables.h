// What evaluated zones become in the decision IR: tables for robots, and edges for points.
#pragma once

#include <vector>

#include "compiler/analysis/zones.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::analysis {

// What points are held against: for the watch, whose monitors come later.
struct PointTables {
  std::vector<ir::Region> regions;
  std::vector<ir::Solid> solids;
};
// Appends the tables of what robots move in to `module`, and enters all of them in `tables`.
PointTables number_zones(const sema::Spec& spec, const SourceManager& sources,
                         const std::vector<ZoneUse>& wanted, const EvaluatedZones& evaluated,
                         ir::Module& module, ir::TableMap& tables);

}  // namespace rtac::analysis
