// The same as damage.cpp, of robots in space: places of a grid, of which nothing is claimed either.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/linear.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

using analysis::outline::Outline;
using analysis::outline::P;

// All in mm. Places along each axis, and along a way that is looked at.
constexpr int places_across = 16;
constexpr double look_each_mm = 20;
// By which a property holds at the start, and how far a hold strays.
constexpr double holds_by_mm = 15, strays_by_mm = 12;
constexpr double far_mm = 1e9, apart_in_space_mm = 6000, unbounded_mm = 10'000;
// A box that is wider has no side there.
constexpr double widest_mm = 1e8;
constexpr std::size_t in_space_most = 4;

struct At {
  P p;
  double z = 0;
};

// Slabs one above the other; a zone of the plane is a single one without an end.
class Volume {
 public:
  Volume(const Subject& s, ir::ZoneIndex zone) {
    if (!s.module[zone].has_height()) {
      slabs_.push_back({Outline::of(s.exact(zone)), -far_mm, far_mm});
      return;
    }
    for (const geometry::Slab& slab : s.solid(zone).slabs()) {
      slabs_.push_back(
          {Outline::of(slab.region), 1000 * slab.floor.get_d(), 1000 * slab.ceiling.get_d()});
    }
  }
  // Everything within `gap` of a place lies in it, in the box around that.
  [[nodiscard]] bool clear(const At& at, double gap) const {
    double up_to = at.z - gap;
    for (const Slab& slab : slabs_) {
      if (slab.ceiling <= at.z - gap || slab.floor >= at.z + gap) continue;
      if (slab.floor > up_to || slab.outline.clearance(at.p) < gap) return false;
      up_to = slab.ceiling;
    }
    return up_to >= at.z + gap;
  }
  // Where a retreat leads from a place in it: up or down, and then level.
  [[nodiscard]] std::vector<At> inwards(const At& from, double clear_mm) const {
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
  // The box around it, as far as a box around others goes.
  void narrow(P& low, P& high, double& floor, double& ceiling) const {
    P least{far_mm, far_mm}, most{-far_mm, -far_mm};
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

 private:
  struct Slab {
    Outline outline;
    double floor, ceiling;
  };
  std::vector<Slab> slabs_;
};

// What a property says of places, as far as it is a matter of zones and heights alone.
struct Says {
  std::vector<std::pair<Volume, double>> zones;  // with what is asked beyond touching them
  double least_mm = -far_mm, most_mm = far_mm;
  [[nodiscard]] bool holds(const At& at, double body_mm, double spare_mm) const {
    return at.z >= least_mm + spare_mm && at.z <= most_mm - spare_mm &&
           std::all_of(zones.begin(), zones.end(), [&](const auto& each) {
             return each.first.clear(at, body_mm + each.second + spare_mm);
           });
  }
};
Says says_of(const Subject& s, const ir::Monitor& m) {
  const auto& params = s.decision.facts.params;
  Says says;
  for (const ir::ZoneIndex zone : analysis::fences_of(m.property, params)) {
    double standoff_mm = 0;
    for (const analysis::Standoff& each : analysis::fence_standoffs(m.property, params)) {
      if (each.zone == zone) standoff_mm = std::max(standoff_mm, double(each.mm));
    }
    says.zones.emplace_back(Volume(s, zone), standoff_mm);
  }
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& c) {
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

class DamageInSpace {
 public:
  DamageInSpace(const Subject& s, std::size_t driving, std::size_t judged)
      : s_(s),
        driving_(s.decision.monitors[driving]),
        judged_(says_of(s, s.decision.monitors[judged])),
        drives_(says_of(s, driving_)),
        body_mm_(double(s.decision.body.radius_mm)) {
    for (const ir::Monitor& m : s.decision.monitors) {
      // it is kept anywhere while inputs say so, until they ask for something else
      if (&m == &driving_ && may_hold_by_inputs(m.property)) continue;
      all_.push_back(says_of(s, m));
    }
  }

  std::vector<Start> run() {
    using Found = std::pair<int, At>;
    std::vector<Found> found;
    for (const At& at : places()) {
      const auto holds = [&](const Says& says) { return says.holds(at, body_mm_, holds_by_mm); };
      if (!std::all_of(all_.begin(), all_.end(), holds) || !engages(at)) continue;
      for (const ir::Recovery* step : ir::steps_of(driving_.recovery)) {
        if (const int outside = outside_on(at, way_of(*step, at))) found.emplace_back(outside, at);
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.first > b.first; });
    std::vector<At> told;
    for (const auto& [outside, at] : found) {
      const auto near = [&at = at](const At& other) {
        return std::hypot(analysis::outline::norm(other.p - at.p), other.z - at.z) <
               apart_in_space_mm;
      };
      if (std::none_of(told.begin(), told.end(), near)) told.push_back(at);
      if (told.size() == in_space_most) break;
    }
    std::vector<Start> starts;
    for (const At& at : told) {
      starts.push_back({{std::llround(at.p.x), std::llround(at.p.y), std::llround(at.z)}});
    }
    return starts;
  }

 private:
  // The monitor does not let the robot go there.
  [[nodiscard]] bool engages(const At& at) const {
    if (drives_.zones.empty() && drives_.least_mm <= -far_mm && drives_.most_mm >= far_mm) {
      return true;
    }
    const double gap_mm =
        double(analysis::return_clearance_mm(s_.decision, driving_.lookahead.duration_us));
    return !drives_.holds(at, body_mm_, gap_mm - body_mm_);
  }
  [[nodiscard]] std::vector<At> way_of(const ir::Recovery& step, const At& from) const {
    if (step.kind == ir::RecoveryKind::land) {
      return {{from.p, std::min(from.z, double(step.land_mm))}};
    }
    if (!ir::goes_back(step.kind)) return {};
    return Volume(s_, step.zone).inwards(from, double(step.return_clearance_mm));
  }
  // How many places of a way do not have what is judged.
  [[nodiscard]] int outside_on(At from, const std::vector<At>& way) const {
    int count = 0;
    for (const At& to : way) {
      const double length = std::hypot(analysis::outline::norm(to.p - from.p), to.z - from.z);
      const double looks = std::ceil(length / look_each_mm);
      for (double k = 1; k <= looks; ++k) {
        const At at{from.p + (k / looks) * (to.p - from.p), from.z + (k / looks) * (to.z - from.z)};
        count += judged_.holds(at, body_mm_, -strays_by_mm) ? 0 : 1;
      }
      from = to;
    }
    return count;
  }
  // A grid in the box that all zones have in common, as near to its sides as the properties hold.
  [[nodiscard]] std::vector<At> places() const {
    P low{-far_mm, -far_mm}, high{far_mm, far_mm};
    double least = -far_mm, most = far_mm;
    for (const Says& says : all_) {
      for (const auto& [zone, standoff] : says.zones) zone.narrow(low, high, least, most);
      least = std::max(least, says.least_mm - body_mm_);
      most = std::min(most, says.most_mm + body_mm_);
    }
    if (high.x - low.x > widest_mm) low = {0, 0}, high = {unbounded_mm, unbounded_mm};
    if (most - least > widest_mm) least = most > widest_mm ? 0 : most - unbounded_mm;
    if (most - least > widest_mm) most = least + unbounded_mm;
    const double rim = body_mm_ + 2 * holds_by_mm;
    const auto along = [&](double from, double to, int k) {
      return from + rim + (to - from - 2 * rim) * k / (places_across - 1);
    };
    std::vector<At> all;
    for (int i = 0; i < places_across; ++i) {
      for (int j = 0; j < places_across; ++j) {
        for (int k = 0; k < places_across; ++k) {
          all.push_back(
              {{along(low.x, high.x, i), along(low.y, high.y, j)}, along(least, most, k)});
        }
      }
    }
    return all;
  }

  const Subject& s_;
  const ir::Monitor& driving_;
  const Says judged_, drives_;
  std::vector<Says> all_;
  const double body_mm_;
};

}  // namespace

std::vector<Start> starts_of_damage_in_space(const Subject& s, std::size_t driving,
                                             std::size_t judged) {
  return DamageInSpace(s, driving, judged).run();
}

}  // namespace rtac::verify
