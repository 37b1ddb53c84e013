#include "compiler/analysis/keeps_off.h"

#include <algorithm>
#include <optional>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/geometry/apart.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

// Offsets reach up to a millimetre too far at round corners, each in a way of its own: what keeps
// the distance need not lie in what is left by the offset.
bool is_off(const geometry::Region& inner, const geometry::Region& outer, const Rational& by_m) {
  if (inner.empty() || !outer.contains(inner)) return false;
  const geometry::Region beyond = geometry::Region::everywhere().subtract(outer);
  return !beyond.empty() && geometry::square_apart(inner, beyond) >= by_m * by_m;
}

}  // namespace

std::int64_t surely_off_mm(const ir::Block& property, const std::vector<ir::Param>& params,
                           ir::ZoneIndex zone) {
  std::int64_t most = 0;
  for (const std::vector<Standoff>& either : surely_in(property, params)) {
    if (either.size() == 1 && either[0].zone == zone) most = std::max(most, either[0].mm);
  }
  return most;
}

std::int64_t starts_off_mm(const ir::Decision& decision, const ir::Recovery& step) {
  std::int64_t relied_mm = 0;
  std::optional<std::int64_t> driving_mm;
  for (const ir::Monitor& m : decision.monitors) {
    const std::int64_t mm = surely_off_mm(m.property, decision.facts.params, step.zone);
    if (relied_on(decision, m)) relied_mm = std::max(relied_mm, mm);
    if (m.recovery.name == step.name) driving_mm = std::min(driving_mm.value_or(mm), mm);
  }
  return std::min(standoff_mm(decision, step), std::max(relied_mm, driving_mm.value_or(0)));
}

bool region_lies_deep(const geometry::Region& inner, const geometry::Region& outer,
                      std::int64_t mm) {
  if (mm <= touching_mm) return outer.contains(inner);
  const auto kept = within(outer, mm);
  return kept && (kept->contains(inner) || is_off(inner, outer, metres_of(mm)));
}

bool lies_deep(const ir::Module& module, const ExactZone& exact, const ExactSolid& solid,
               ir::ZoneIndex inner, const Standoff& outer) {
  const bool high = module[inner].has_height();
  const Rational by_m = metres_of(outer.mm);
  if (module[outer.zone].has_height()) {
    // what is that far off to the sides, and up and down, is that far off in space
    return high && solid(inner).subtract(solid(outer.zone).shrink(by_m, by_m)).empty();
  }
  const auto kept = within(exact(outer.zone), outer.mm);
  if (!kept) return false;
  const auto is_deep = [&](const geometry::Region& region) {
    return kept->contains(region) || is_off(region, exact(outer.zone), by_m);
  };
  if (!high) return is_deep(exact(inner));
  const geometry::Solid tall = solid(inner);
  return std::all_of(tall.slabs().begin(), tall.slabs().end(),
                     [&](const geometry::Slab& slab) { return is_deep(slab.region); });
}

bool lies_level(const ir::Module& module, const ExactZone& exact, const ExactSolid& solid,
                ir::ZoneIndex inner, const Standoff& outer) {
  if (module[inner].has_height() || !module[outer.zone].has_height()) return false;
  const geometry::Solid fence = solid(outer.zone);
  return std::ranges::all_of(fence.slabs(), [&](const geometry::Slab& slab) {
    if (outer.mm <= touching_mm) return slab.region.contains(exact(inner));
    const auto kept = within(slab.region, outer.mm);
    return kept && kept->contains(exact(inner));
  });
}

bool lies_all_over(const ir::Module& module, const ExactZone& exact, const ExactSolid& solid,
                   ir::ZoneIndex inner, ir::ZoneIndex outer) {
  const bool high = module[inner].has_height();
  if (high != module[outer].has_height()) return false;
  if (high) {
    const geometry::Solid a = solid(inner), b = solid(outer);
    return a.subtract(b).empty() && b.subtract(a).empty();
  }
  return exact(inner).contains(exact(outer)) && exact(outer).contains(exact(inner));
}

bool keeps_off(const ir::Module& module, const ir::Decision& decision, const ExactZone& exact,
               const ExactSolid& solid, const ir::Monitor& driving, const ir::Monitor& judged,
               const ir::Recovery& step, const Standoff& fence) {
  const ir::ZoneIndex zone = step.zone;
  if (fence.mm <= touching_mm) return true;
  if (step.claims) return lies_deep(module, exact, solid, zone, fence);
  if (zone == fence.zone) return true;
  const bool has_it = driving.name == judged.name || relied_on(decision, driving);
  if (has_it && surely_off_mm(driving.property, decision.facts.params, zone) >= fence.mm) {
    return true;
  }
  return lies_deep(module, exact, solid, zone, fence) ||
         lies_level(module, exact, solid, zone, fence) ||
         lies_all_over(module, exact, solid, zone, fence.zone);
}

std::string deep_text(const ir::Module& module, ir::ZoneIndex zone, const Standoff& fence) {
  const std::string outside = "outside_of_", unnamed = "zone_of_line_";
  const std::string &from = module[zone].name, &off = module[fence.zone].name;
  const bool named = from.find(unnamed) == std::string::npos &&
                     off.find(unnamed) == std::string::npos && !from.starts_with(outside);
  if (!named) return "";
  const bool out = off.starts_with(outside);
  const std::string other = out ? off.substr(outside.size()) : off;
  const std::string far = ", " + metres(fence.mm) + ")";
  const std::string kept = fence.mm <= 0 ? other : (out ? "grow(" : "shrink(") + other + far;
  return zone == fence.zone ? kept : from + (out ? " - " : " & ") + kept;
}

}  // namespace rtac::analysis
