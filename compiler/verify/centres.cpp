#include "compiler/verify/centres.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"

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

}  // namespace rtac::verify
