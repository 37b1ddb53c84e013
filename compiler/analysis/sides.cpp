#include "compiler/analysis/sides.h"

#include <algorithm>

#include "compiler/analysis/speed_limits.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

bool collect_sides(const ir::Module& module, const ir::Decision& decision, const ir::Block& block,
                   ir::ValueId id, std::vector<ir::ZoneIndex>& zones) {
  if (const auto* v = std::get_if<ir::Or>(&block[id].op)) {
    return collect_sides(module, decision, block, v->a, zones) &&
           collect_sides(module, decision, block, v->b, zones);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&block[id].op);
  const auto bound =
      compare ? ir::lower_bound(block, *compare, decision.facts.params) : std::nullopt;
  if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance || bound->need.strictest != 0 ||
      compare->strict || !bound->need.params.empty()) {
    return false;
  }
  const ir::ZoneIndex zone{bound->leaf.table};
  if (module[zone].has_height()) return false;
  zones.push_back(zone);
  return true;
}

}  // namespace

Rational metres_of(std::int64_t mm) {
  Rational m(static_cast<long>(mm), 1000);
  m.canonicalize();
  return m;
}

bool asks_for_slow(const ir::Decision& decision, std::size_t k, const ir::Block& block,
                   ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return asks_for_slow(decision, k, block, v->a) && asks_for_slow(decision, k, block, v->b);
  }
  // what an external one claims of its speed is held against its measured speed alone
  if (decision.monitors[k].recovery.claims) return false;
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  const auto bound = compare ? ir::upper_bound(block, *compare) : std::nullopt;
  return bound && bound->leaf.kind == ir::Leaf::Kind::speed &&
         fastest_while_driving(decision, k) <= bound->most;
}

bool has_slow_side(const ir::Decision& decision, std::size_t k, const ir::Block& block,
                   const ir::Or& either) {
  return asks_for_slow(decision, k, block, either.a) || asks_for_slow(decision, k, block, either.b);
}

std::vector<ir::ZoneIndex> sides_in_zones(const ir::Module& module, const ir::Decision& decision,
                                          const ir::Block& block, ir::ValueId id) {
  std::vector<ir::ZoneIndex> zones;
  if (!collect_sides(module, decision, block, id, zones)) zones.clear();
  return zones;
}

// A disc in `own` that lies in none of the zones alone meets, for each of them, what they leave out
// of `own`.
std::optional<geometry::Region> between(const geometry::Region& own,
                                        const std::vector<ir::ZoneIndex>& zones,
                                        const ExactZone& exact, std::int64_t own_mm,
                                        std::int64_t side_mm) {
  auto left = within(own, own_mm);
  for (const ir::ZoneIndex zone : zones) {
    if (!left || left->empty()) return left;
    const auto meets =
        own.subtract(exact(zone)).offset(metres_of(std::max<std::int64_t>(side_mm, 0)));
    if (!meets) return std::nullopt;
    left = left->intersect(*meets);
  }
  return left;
}

bool straight_between(const std::vector<ir::ZoneIndex>& zones, const ExactZone& exact,
                      std::int64_t radius_mm) {
  geometry::Region places;
  for (const ir::ZoneIndex zone : zones) {
    const auto in_it = within(exact(zone), radius_mm);
    if (!in_it) return false;
    places = places.unite(*in_it);
  }
  return is_convex(places);
}

bool keeps_a_side(const ir::Module& module, const ir::Decision& decision, const ExactZone& exact,
                  std::size_t k, const ir::Block& block, ir::ValueId id) {
  const auto& either = std::get<ir::Or>(block[id].op);
  if (has_slow_side(decision, k, block, either)) return true;
  const auto zones = sides_in_zones(module, decision, block, id);
  if (zones.empty()) return false;
  const auto steps = ir::steps_of(decision.monitors[k].recovery);
  return std::all_of(steps.begin(), steps.end(), [&](const ir::Recovery* step) {
    if (!ir::moves(step->kind) && !step->claims) return true;  // it stays where a side held
    if (module[step->zone].has_height()) return false;
    const geometry::Region& own = exact(step->zone);
    geometry::Region all;
    for (const ir::ZoneIndex zone : zones) all = all.unite(exact(zone));
    if (!all.contains(own)) return false;
    const std::int64_t radius_mm = decision.body.radius_mm;
    const auto none =
        between(own, zones, exact, radius_mm - offsets_round_mm, radius_mm + offsets_round_mm);
    return none && none->empty();
  });
}

}  // namespace rtac::analysis
