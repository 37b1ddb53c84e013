#include "compiler/analysis/straight_in.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/sides.h"

namespace rtac::analysis {
namespace {

using geometry::Region;
using geometry::Solid;
using Held = std::vector<std::vector<Standoff>>;

Held held_at(const TakeOver& at) {
  const ir::Decision& d = at.decision;
  Held all;
  for (std::size_t k = 0; k < d.monitors.size(); ++k) {
    const ir::Monitor& m = d.monitors[k];
    if (k != at.judged && !relied_on(d, m)) continue;
    for (auto& either : surely_in(m.property, d.facts.params)) all.push_back(std::move(either));
  }
  return all;
}

// The places of bodies that lie so far off the boundary; more of them where that is not known.
Region centres(const TakeOver& at, const Standoff& held) {
  const Region& region = at.exact(held.zone);
  return within(region, at.decision.body.radius_mm + held.mm).value_or(region);
}
Solid centres_in_space(const TakeOver& at, const Standoff& held) {
  const Rational by = metres_of(at.decision.body.radius_mm + held.mm);
  const Rational upright = at.module[held.zone].has_height() ? by : Rational(0);
  return at.solid(held.zone).shrink(by, upright);
}

template <class Zone, class Centres>
Zone where_held(const TakeOver& at, const Held& held, const Centres& centres_of) {
  Zone all = Zone::everywhere();
  for (const std::vector<Standoff>& either : held) {
    Zone some;
    for (const Standoff& each : either) some = some.unite(centres_of(at, each));
    all = all.intersect(some);
  }
  return all;
}

}  // namespace

bool starts_within(const TakeOver& at, ir::ZoneIndex zone) {
  const Held held = held_at(at);
  const auto is_zone = [&](const std::vector<Standoff>& either) {
    return either.size() == 1 && either[0].zone == zone;
  };
  if (std::ranges::any_of(held, is_zone)) return true;
  const std::int64_t body_mm =
      std::max<std::int64_t>(at.decision.body.radius_mm - offsets_round_mm, 0);
  if (at.decision.body.in_space) {
    const Rational by = metres_of(body_mm);
    const Rational upright = at.module[zone].has_height() ? by : Rational(0);
    return where_held<Solid>(at, held, centres_in_space)
        .subtract(at.solid(zone).shrink(by, upright))
        .empty();
  }
  const auto inside = within(at.exact(zone), body_mm);
  return inside && inside->contains(where_held<Region>(at, held, centres));
}

bool comes_in_within(const TakeOver& at, ir::ZoneIndex zone, ir::ZoneIndex fence) {
  if (zone == fence) return true;
  if (!at.module[fence].has_height()) {
    if (is_convex(at.exact(fence))) return true;
    return starts_within(at, zone);
  }
  const Solid solid = at.solid(fence);
  const bool level = !at.module[zone].has_height();
  const bool one = level || solid.slabs().size() == 1;
  const bool convex = one && std::ranges::all_of(solid.slabs(), [](const geometry::Slab& slab) {
                        return is_convex(slab.region);
                      });
  return convex || starts_within(at, zone);
}

}  // namespace rtac::analysis
