#include "compiler/verify/centres.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/verify/atoms.h"

namespace rtac::verify {

geometry::Region centres_of(const Subject& s, const ir::Monitor& m, std::int64_t more_mm) {
  const auto& params = s.decision.facts.params;
  const std::int64_t body_mm = s.decision.body.radius_mm + more_mm;
  const auto shrunk = [&](ir::ZoneIndex zone) {
    std::int64_t mm = body_mm;
    for (const analysis::Standoff& each : analysis::fence_standoffs(m.property, params)) {
      if (each.zone == zone) mm = std::max(mm, body_mm + each.mm);
    }
    return analysis::within(s.exact(zone), mm).value_or(s.exact(zone));
  };
  geometry::Region all = geometry::Region::everywhere();
  for (const ir::ZoneIndex fence : analysis::fences_of(m.property, params)) {
    if (!s.module[fence].has_height()) all = all.intersect(shrunk(fence));
  }
  for (const analysis::Choice& choice : analysis::choices_of(m.property, params)) {
    geometry::Region some;
    for (const ir::ZoneIndex zone : choice) {
      if (!s.module[zone].has_height()) some = some.unite(shrunk(zone));
    }
    if (!some.empty()) all = all.intersect(some);
  }
  return all;
}

geometry::Region unlimited(const Subject& s, const ir::Monitor& m) {
  geometry::Region all = geometry::Region::everywhere();
  if (!atoms_of(m.property).speed) return all;
  for (const analysis::Standoff& each :
       analysis::fence_standoffs(m.property, s.decision.facts.params)) {
    if (s.module[each.zone].has_height()) continue;
    const std::int64_t mm = s.decision.body.radius_mm + each.mm;
    all = all.intersect(analysis::within(s.exact(each.zone), mm).value_or(s.exact(each.zone)));
  }
  return all;
}

std::optional<std::pair<std::int64_t, std::int64_t>> deep_in(const geometry::Region& region) {
  using analysis::outline::P;
  constexpr int steps = 16;
  const auto inside = analysis::outline::Outline::of(region);
  if (inside.edges().empty()) return std::nullopt;
  P low = inside.edges().front().a, high = low;
  for (const auto& edge : inside.edges()) {
    low = {std::min(low.x, edge.a.x), std::min(low.y, edge.a.y)};
    high = {std::max(high.x, edge.a.x), std::max(high.y, edge.a.y)};
  }
  double widest_mm = 0;
  std::optional<std::pair<std::int64_t, std::int64_t>> best;
  for (int n = 0; n < steps * steps; ++n) {
    const int column = n % steps, row = n / steps;
    const P at{low.x + (column + 0.5) / steps * (high.x - low.x),
               low.y + (row + 0.5) / steps * (high.y - low.y)};
    const double clear_mm = inside.clearance(at);
    if (clear_mm <= widest_mm) continue;
    widest_mm = clear_mm;
    best = {static_cast<std::int64_t>(at.x), static_cast<std::int64_t>(at.y)};
  }
  return best;
}

}  // namespace rtac::verify
