#include "compiler/verify/in_space.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/linear.h"

namespace rtac::verify {
namespace {

using analysis::outline::Outline;
using analysis::outline::P;

constexpr int places_across = 16;
// A box that is wider has no side there.
constexpr double widest_mm = 1e8, unbounded_mm = 10'000;

}  // namespace

Volume::Volume(const Subject& s, ir::ZoneIndex zone) {
  if (!s.module[zone].has_height()) {
    slabs_.push_back({Outline::of(s.exact(zone)), -endless_mm, endless_mm});
    return;
  }
  for (const geometry::Slab& slab : s.solid(zone).slabs()) {
    slabs_.push_back(
        {Outline::of(slab.region), 1000 * slab.floor.get_d(), 1000 * slab.ceiling.get_d()});
  }
}

bool Volume::clear(const At& at, double gap) const {
  double up_to = at.z - gap;
  for (const Slab& slab : slabs_) {
    if (slab.ceiling <= at.z - gap || slab.floor >= at.z + gap) continue;
    if (slab.floor > up_to || slab.outline.clearance(at.p) < gap) return false;
    up_to = slab.ceiling;
  }
  return up_to >= at.z + gap;
}

std::vector<At> Volume::inwards(const At& from, double clear_mm) const {
  for (const Slab& slab : slabs_) {
    if (from.z < slab.floor || from.z > slab.ceiling) continue;
    if (slab.ceiling - slab.floor < 2 * clear_mm) return {};
    At at = from;
    at.z = std::clamp(at.z, slab.floor + clear_mm, slab.ceiling - clear_mm);
    std::vector<At> way{at};
    const P border = slab.outline.nearest(at.p);
    const double away = analysis::outline::norm(at.p - border);
    if (away < 1 || away >= clear_mm) return way;
    at.p = border + (clear_mm / away) * (at.p - border);
    way.push_back(at);
    return way;
  }
  return {};
}

std::vector<Volume::BesideWall> Volume::beside_walls(double off_mm) const {
  std::vector<BesideWall> all;
  for (const Slab& slab : slabs_) {
    if (slab.floor <= -endless_mm || slab.ceiling >= endless_mm) continue;
    for (const auto& [a, b] : slab.outline.edges()) {
      const double length = analysis::outline::norm(b - a);
      for (const double side : {1.0, -1.0}) {
        const P out = (side / length) * P{b.y - a.y, a.x - b.x};
        const At at{0.5 * (a + b) + (-off_mm) * out, (slab.floor + slab.ceiling) / 2};
        if (slab.outline.clearance(at.p) > off_mm - 1) all.push_back({at, out});
      }
    }
  }
  return all;
}

void Volume::narrow(P& low, P& high, double& floor, double& ceiling) const {
  P least{endless_mm, endless_mm}, most{-endless_mm, -endless_mm};
  for (const Slab& slab : slabs_) {
    for (const auto& [a, b] : slab.outline.edges()) {
      least = {std::min(least.x, a.x), std::min(least.y, a.y)};
      most = {std::max(most.x, a.x), std::max(most.y, a.y)};
    }
  }
  low = {std::max(low.x, least.x), std::max(low.y, least.y)};
  high = {std::min(high.x, most.x), std::min(high.y, most.y)};
  floor = std::max(floor, slabs_.front().floor);
  ceiling = std::min(ceiling, slabs_.back().ceiling);
}

bool Says::holds(const At& at, double body_mm, double spare_mm) const {
  return at.z >= least_mm + spare_mm && at.z <= most_mm - spare_mm &&
         std::all_of(zones.begin(), zones.end(), [&](const auto& each) {
           return each.first.clear(at, body_mm + each.second + spare_mm);
         });
}

Says says_of(const Subject& s, const ir::Block& property) {
  const auto& params = s.decision.facts.params;
  Says says;
  for (const ir::ZoneIndex zone : analysis::fences_of(property, params)) {
    double standoff_mm = 0;
    for (const analysis::Standoff& each : analysis::fence_standoffs(property, params)) {
      if (each.zone == zone) standoff_mm = std::max(standoff_mm, double(each.mm));
    }
    says.zones.emplace_back(Volume(s, zone), standoff_mm);
  }
  ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& c) {
    const auto most = ir::upper_bound(block, c);
    if (most && most->leaf.kind == ir::Leaf::Kind::altitude) {
      says.most_mm = std::min(says.most_mm, double(most->most));
    }
    const auto least = ir::lower_bound(block, c, params);
    if (least && least->leaf.kind == ir::Leaf::Kind::altitude) {
      says.least_mm = std::max(says.least_mm, double(least->need.strictest));
    }
  });
  return says;
}

std::vector<At> grid_of(const std::vector<Says>& all, double body_mm, double rim_mm) {
  P low{-endless_mm, -endless_mm}, high{endless_mm, endless_mm};
  double least = -endless_mm, most = endless_mm;
  for (const Says& says : all) {
    for (const auto& [zone, standoff] : says.zones) zone.narrow(low, high, least, most);
    least = std::max(least, says.least_mm - body_mm);
    most = std::min(most, says.most_mm + body_mm);
  }
  if (high.x - low.x > widest_mm) low = {0, 0}, high = {unbounded_mm, unbounded_mm};
  if (most - least > widest_mm) least = most > widest_mm ? 0 : most - unbounded_mm;
  if (most - least > widest_mm) most = least + unbounded_mm;
  const auto along = [&](double from, double to, int k) {
    return from + rim_mm + (to - from - 2 * rim_mm) * k / (places_across - 1);
  };
  std::vector<At> places;
  for (int i = 0; i < places_across; ++i) {
    for (int j = 0; j < places_across; ++j) {
      for (int k = 0; k < places_across; ++k) {
        places.push_back(
            {{along(low.x, high.x, i), along(low.y, high.y, j)}, along(least, most, k)});
      }
    }
  }
  return places;
}

}  // namespace rtac::verify
