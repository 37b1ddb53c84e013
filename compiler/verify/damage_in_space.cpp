// The same as damage.cpp, of robots in space: places of a grid, of which nothing is claimed either.
#include <algorithm>
#include <cmath>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/in_space.h"

namespace rtac::verify {
namespace {

using analysis::outline::Outline;
using analysis::outline::P;

// All in mm. Between places of a way that are looked at.
constexpr double look_each_mm = 20;
// By which a property holds at the start, and how far a hold strays.
constexpr double holds_by_mm = 15, strays_by_mm = 12;
constexpr double apart_in_space_mm = 6000;
constexpr std::size_t in_space_most = 4;

class DamageInSpace {
 public:
  DamageInSpace(const Subject& s, std::size_t driving, std::size_t judged, double spare_mm)
      : s_(s),
        spare_mm_(spare_mm),
        driving_(s.decision.monitors[driving]),
        judged_(says_of(s, s.decision.monitors[judged].property)),
        drives_(says_of(s, driving_.property)),
        body_mm_(double(s.decision.body.radius_mm)) {
    for (const ir::Monitor& m : s.decision.monitors) {
      // it is kept anywhere while inputs say so, until they ask for something else
      if (&m == &driving_ && may_hold_by_inputs(m.property)) continue;
      all_.push_back(says_of(s, m.property));
    }
  }

  std::vector<Start> run() {
    using Found = std::pair<int, At>;
    std::vector<Found> found;
    for (const At& at : grid_of(all_, body_mm_, body_mm_ + 2 * holds_by_mm)) {
      if (!all_hold(at) || !engages(at)) continue;
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
      starts.push_back({in_mm(at)});
    }
    for (const ir::Recovery* step : ir::steps_of(driving_.recovery)) {
      if (step->kind == ir::RecoveryKind::yield) beside_each_other(*step, starts);
    }
    return starts;
  }

 private:
  static std::vector<std::int64_t> in_mm(const At& at) {
    return {std::llround(at.p.x), std::llround(at.p.y), std::llround(at.z)};
  }
  [[nodiscard]] bool all_hold(const At& at) const {
    return judged_.holds(at, body_mm_, std::max(spare_mm_, holds_by_mm)) &&
           std::ranges::all_of(
               all_, [&](const Says& says) { return says.holds(at, body_mm_, holds_by_mm); });
  }
  // The one that goes first backs off from the other one, through a wall of what it is to keep.
  void beside_each_other(const ir::Recovery& yield, std::vector<Start>& starts) const {
    if (s_.decision.robots < 2) return;
    const Volume may_drive(s_, yield.zone);
    const double apart_mm =
        2 * body_mm_ + 2 * holds_by_mm + double(analysis::standoffs_of(s_.decision).separation_mm);
    for (const auto& [zone, standoff] : judged_.zones) {
      const double inside_mm = body_mm_ + standoff + 2 * holds_by_mm;
      for (const auto& [at, outwards] : zone.beside_walls(inside_mm)) {
        const At other{at.p + (-apart_mm) * outwards, at.z};
        const At out{at.p + inside_mm * outwards, at.z};
        if (!all_hold(at) || !all_hold(other) || !may_drive.clear(out, body_mm_)) continue;
        if (starts.size() < in_space_most) starts.push_back({in_mm(at), {in_mm(other)}});
      }
    }
  }
  // The monitor does not let the robot go there.
  [[nodiscard]] bool engages(const At& at) const {
    if (drives_.zones.empty() && drives_.least_mm <= -endless_mm && drives_.most_mm >= endless_mm) {
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
        count += judged_.holds(at, body_mm_, spare_mm_) ? 0 : 1;
      }
      from = to;
    }
    return count;
  }
  const Subject& s_;
  const double spare_mm_;  // with less beyond the body, what is judged is not had
  const ir::Monitor& driving_;
  const Says judged_, drives_;
  std::vector<Says> all_;
  const double body_mm_;
};

}  // namespace

std::vector<Start> starts_of_damage_in_space(const Subject& s, std::size_t driving,
                                             std::size_t judged) {
  return DamageInSpace(s, driving, judged, -strays_by_mm).run();
}

std::vector<Start> starts_of_take_over_in_space(const Subject& s, std::size_t driving,
                                                std::size_t judged) {
  const std::int64_t ahead_us = s.decision.monitors[judged].lookahead.duration_us;
  const std::int64_t gap_mm = analysis::return_clearance_mm(s.decision, ahead_us);
  return DamageInSpace(s, driving, judged, double(gap_mm - s.decision.body.radius_mm)).run();
}

}  // namespace rtac::verify
