#include "compiler/analysis/fences.h"

#include <algorithm>

#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

using ir::Leaf;

void collect(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params,
             std::vector<ir::ZoneIndex>& zones) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    collect(block, v->a, params, zones);
    collect(block, v->b, params, zones);
    return;
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  const auto bound = compare ? ir::lower_bound(block, *compare, params) : std::nullopt;
  if (!bound || bound->leaf.kind != Leaf::Kind::clearance || bound->need.strictest < 0) return;
  const ir::ZoneIndex zone{bound->leaf.table};
  if (std::find(zones.begin(), zones.end(), zone) == zones.end()) zones.push_back(zone);
}

}  // namespace

std::vector<ir::ZoneIndex> fences_of(const ir::Block& property,
                                     const std::vector<ir::Param>& params) {
  std::vector<ir::ZoneIndex> zones;
  collect(property, property.result, params, zones);
  return zones;
}

Asks asks_of(const ir::Block& property, const std::vector<ir::Param>& params) {
  Asks asks;
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
      asks.clearance = asks.clearance || leaf.kind == Leaf::Kind::altitude;
    }
    const auto bound = ir::lower_bound(block, compare, params);
    if (!bound) return;
    asks.clearance = asks.clearance || bound->leaf.kind == Leaf::Kind::clearance;
    asks.distance = asks.distance || bound->leaf.kind == Leaf::Kind::distance;
  });
  return asks;
}

}  // namespace rtac::analysis
