// Where a robot has to start so that a run shows what a recovery does to the property of another
// monitor. Nothing is claimed of these places: what is refuted is what a run shows.
#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/travel.h"
#include "compiler/analysis/ways_in.h"
#include "compiler/ir/linear.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/centres.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

using analysis::outline::Outline;
using analysis::outline::P;
using geometry::Region;

constexpr std::size_t starts_most = 4;
// By which a battery is more than the charge of the way from there.
constexpr std::int64_t spare_ppm = 2'000;

class Damage {
 public:
  Damage(const Subject& s, std::size_t driving, std::size_t judged)
      : s_(s),
        driving_(s.decision.monitors[driving]),
        judged_(s.decision.monitors[judged]),
        is_too_fast_(!slow_enough(s, driving, judged)) {}

  std::vector<Start> run() {
    Region allowed = centres_of(s_, judged_, 0);
    if (is_too_fast_) allowed = allowed.intersect(unlimited(s_, judged_));
    Region from = Region::everywhere();
    for (const ir::Monitor& m : s_.decision.monitors) {
      // it is kept anywhere while inputs say so, until they ask for something else
      if (&m == &driving_ && may_hold_by_inputs(m.property)) continue;
      from = from.intersect(centres_of(s_, m, start_spare_mm));
    }
    std::vector<Start> all;
    for (const ir::Recovery* step : ir::steps_of(driving_.recovery)) {
      if (!ir::moves(step->kind) || s_.module[step->zone].has_height()) continue;
      if (from.empty()) continue;
      if (step->kind == ir::RecoveryKind::yield) {
        beside_each_other(from, allowed, all);
        if (is_too_fast_) near_each_other(from.subtract(allowed), all);
        continue;
      }
      straight_in(*step, from, allowed, all);
      const bool routes = step->kind == ir::RecoveryKind::route;
      const Region own = from.intersect(s_.exact(step->zone));
      const Region begins = routes ? own : own.subtract(given_back());
      if (begins.empty()) continue;
      const Rational speed(static_cast<long>(step->speed_mmps), 1000);
      const std::int64_t on_mm = analysis::run_out_mm(s_.kind, speed, s_.decision.period_us);
      const auto ways =
          analysis::ways_out(s_.module, s_.decision, *step, on_mm, begins, allowed, starts_most);
      for (const auto& way : ways) {
        Start start{{way.from.x_mm, way.from.y_mm}};
        if (routes) start.battery_ppm = just_enough(*step, way.from);
        all.push_back(std::move(start));
      }
    }
    if (all.size() > starts_most) all.resize(starts_most);
    if (!all.empty() || &driving_ == &judged_) return all;
    const double beside_mm = double(s_.decision.body.radius_mm + start_spare_mm);
    if (const auto moves_mm = moves_from_mm()) {
      // between where it is braked and where control is given back, by errors that it happens to
      // have
      for (const double share : {0.8125, 0.875, 1.0, 0.75})
        near_both(from, *moves_mm * share, 1, all);
    }
    near_both(from, beside_mm, starts_most, all);
    return all;
  }

 private:
  // Outside of its zone, from where it makes straight for that, across what is not allowed.
  void straight_in(const ir::Recovery& step, const Region& from, const Region& allowed,
                   std::vector<Start>& all) const {
    const Region outside = from.subtract(s_.exact(step.zone));
    if (outside.empty()) return;
    const auto ways = analysis::ways_in(s_.module, s_.decision, step, outside, allowed);
    if (!ways.leaves) return;
    Start start{{ways.leaves->from.x_mm, ways.leaves->from.y_mm}};
    if (step.kind == ir::RecoveryKind::route)
      start.battery_ppm = just_enough(step, ways.leaves->from);
    all.push_back(std::move(start));
  }
  // Where the driving monitor lets the robot go, so that its recovery does not begin.
  [[nodiscard]] Region given_back() const {
    const std::int64_t mm =
        analysis::return_clearance_mm(s_.decision, driving_.lookahead.duration_us);
    const auto& params = s_.decision.facts.params;
    const bool of_places = !analysis::fences_of(driving_.property, params).empty() ||
                           !analysis::choices_of(driving_.property, params).empty();
    return of_places ? centres_of(s_, driving_, mm - s_.decision.body.radius_mm) : Region();
  }
  // The charge at a place with which its monitor engages there, as that does not look ahead of it.
  [[nodiscard]] std::optional<std::int64_t> just_enough(const ir::Recovery& route,
                                                        analysis::PlaceMm at) const {
    const ir::SiteTable& site = s_.module[route.site];
    const ir::Cells& cells = s_.module[site.zone].cells;
    const auto& costs = site.places.front().cost_ppm;
    const std::int64_t column = (at.x_mm - cells.origin_x_mm) / cells.cell_mm;
    const std::int64_t row = (at.y_mm - cells.origin_y_mm) / cells.cell_mm;
    if (costs.empty() || column < 0 || row < 0 || column >= cells.columns || row >= cells.rows) {
      return std::nullopt;
    }
    const std::int64_t cost = costs[static_cast<std::size_t>(row * cells.columns + column)];
    if (cost < 0 || cost == ir::no_way) return std::nullopt;
    std::optional<std::int64_t> least;
    const auto& params = s_.decision.facts.params;
    ir::for_each_comparison(driving_.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      if (const auto way = ir::charge_for_way(block, c, params)) {
        least = std::max(least.value_or(0), cost + way->reserve.strictest);
      }
      const auto floor = ir::lower_bound(block, c, params);
      if (floor && floor->leaf.kind == ir::Leaf::Kind::battery) {
        least = std::max(least.value_or(0), floor->need.strictest);
      }
    });
    return least ? std::optional(*least + spare_ppm) : std::nullopt;
  }
  // Of a recovery that drives too fast, or that nobody has written down where to: at the fence that
  // it drives for, as near as it gets there to what the other property asks for.
  // `least_mm`: from the fence; `count`: of places to be found.
  void near_both(const Region& from, double least_mm, std::size_t count,
                 std::vector<Start>& all) const {
    const auto& params = s_.decision.facts.params;
    const auto fences = analysis::fences_of(driving_.property, params);
    if (fences.empty() || s_.module[fences.front()].has_height() || from.empty()) return;
    const ir::ZoneTable& zone = s_.module[fences.front()];
    const Outline fence = Outline::of(zone), begins = Outline::of(from);
    const std::vector<Limit> limits = limits_of_judged(fence);
    // the lower, the nearer; none: it does not start there
    const auto score = [&](P p) -> std::optional<double> {
      const double clearance = fence.clearance(p);
      const auto far = clearance < least_mm ? std::nullopt : far_from_judged(p, limits);
      return far && begins.contains(p) ? std::optional(*far + clearance) : std::nullopt;
    };
    std::vector<std::pair<double, P>> found;
    const ir::Cells& cells = zone.cells;
    for (std::size_t at = 0; at < cells.clearance_mm_lo.size(); ++at) {
      if (cells.clearance_mm_lo[at] < s_.decision.body.radius_mm) continue;
      const auto columns = static_cast<std::size_t>(cells.columns);
      const std::size_t column = at % columns, row = at / columns;
      const P p{cells.origin_x_mm + (double(column) + 0.5) * cells.cell_mm,
                cells.origin_y_mm + (double(row) + 0.5) * cells.cell_mm};
      if (const auto far = score(p)) found.emplace_back(*far, p);
    }
    std::ranges::sort(found, {}, [](const auto& each) { return each.first; });
    constexpr double apart_mm = 400;  // about what the look-ahead asks for, and a body
    const std::size_t enough = std::min(all.size() + count, starts_most);
    std::vector<Start> told;
    for (const auto& [far, p] : found) {
      const bool beside = std::ranges::any_of(told, [&, at = p](const Start& start) {
        return analysis::outline::norm(
                   at - P{double(start.place_mm[0]), double(start.place_mm[1])}) < apart_mm;
      });
      if (all.size() == enough) return;
      if (beside) continue;
      told.push_back({in_mm(nearest_around(p, cells.cell_mm, score))});
      all.push_back(told.back());
    }
  }
  // The lowest score of places around the middle of a cell.
  template <class Score>
  static P nearest_around(P middle, double cell_mm, const Score& score) {
    constexpr int each_way = 8;
    P best = middle;
    double least = *score(middle);
    for (int i = -each_way; i <= each_way; ++i) {
      for (int k = -each_way; k <= each_way; ++k) {
        const P p = middle + (cell_mm / each_way) * P{double(i), double(k)};
        const auto found = score(p);
        if (!found || *found >= least) continue;
        least = *found;
        best = p;
      }
    }
    return best;
  }
  // What only claims to stay in its zone is braked, and stays where it is, unless it has room to
  // drive: at the bounds so much, at most times less. none: it claims nothing.
  [[nodiscard]] std::optional<double> moves_from_mm() const {
    if (!ir::last_step(driving_.recovery).claims) return std::nullopt;
    const auto index = static_cast<std::size_t>(&driving_ - s_.decision.monitors.data());
    return double(analysis::claim_clearance_mm(s_.decision, s_.decision.motions[index + 1],
                                               driving_.lookahead.duration_us));
  }
  // What the other property asks for of a zone: to be so far inside. Whoever leaves it where its
  // boundary is the fence's leaves that, too: `crossed` is the rest of it.
  struct Limit {
    Outline zone, crossed;
    double mm;
  };
  [[nodiscard]] std::vector<Limit> limits_of_judged(const Outline& fence) const {
    constexpr double same_mm = 100;
    std::vector<Limit> all;
    for (const analysis::Standoff& each :
         analysis::fence_standoffs(judged_.property, s_.decision.facts.params)) {
      if (s_.module[each.zone].has_height()) continue;
      const Outline zone = Outline::of(s_.module[each.zone]);
      std::vector<analysis::outline::Segment> crossed;
      for (const auto& edge : zone.edges()) {
        if (fence.clearance(0.5 * (edge.a + edge.b)) > same_mm) crossed.push_back(edge);
      }
      const Outline rest(crossed.empty() ? zone.edges() : crossed);
      all.push_back({zone, rest, double(s_.decision.body.radius_mm + each.mm)});
    }
    return all;
  }
  // How far a place is from where the other property is false, or where it asks for a speed; none:
  // it is false there, or never asks.
  [[nodiscard]] std::optional<double> far_from_judged(P p, const std::vector<Limit>& limits) const {
    const bool slow = atoms_of(judged_.property).speed;
    std::optional<double> far;
    // it asks for it anywhere, or when it is told
    if (slow && limits.empty()) far = 0;
    for (const Limit& limit : limits) {
      const double spare = limit.zone.clearance(p) - limit.mm;
      if (slow ? spare >= 0 : spare < double(start_spare_mm)) continue;
      const double away =
          slow ? 0 : analysis::outline::norm(limit.crossed.nearest(p) - p) - limit.mm;
      far = std::min(far.value_or(away), away);
    }
    return far;
  }
  // The one that goes first backs off from the other one, out of what it is near the boundary of.
  void beside_each_other(const Region& from, const Region& allowed, std::vector<Start>& all) const {
    if (s_.decision.robots < 2) return;
    const std::int64_t gap_mm = analysis::standoffs_of(s_.decision).separation_mm +
                                2 * s_.decision.body.radius_mm + start_spare_mm;
    const Outline inside = Outline::of(from), out = Outline::of(allowed);
    for (const auto& [a, b] : inside.edges()) {
      const P middle = 0.5 * (a + b), border = out.nearest(middle);
      const double away = analysis::outline::norm(middle - border);
      if (away < 1 || away > 2 * double(start_spare_mm)) continue;  // on the edge of another zone
      const P other = middle + (double(gap_mm) / away) * (middle - border);
      if (!inside.contains(other)) continue;
      all.push_back({in_mm(middle), {in_mm(other)}});
    }
  }
  // Where a limit of speed counts, as far inside as there is room for two, whichever of them makes
  // way.
  void near_each_other(const Region& limited, std::vector<Start>& all) const {
    if (s_.decision.robots < 2 || limited.empty()) return;
    const std::int64_t gap_mm = analysis::standoffs_of(s_.decision).separation_mm +
                                2 * s_.decision.body.radius_mm + start_spare_mm;
    const Outline inside = Outline::of(limited);
    const auto one = deep_in(limited);
    if (!one) return;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      const std::int64_t x = one->first + dx * gap_mm, y = one->second + dy * gap_mm;
      if (!inside.contains({double(x), double(y)})) continue;
      all.push_back({{one->first, one->second}, {{x, y}}});
      return;
    }
  }
  [[nodiscard]] static std::vector<std::int64_t> in_mm(P p) {
    return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)};
  }

  const Subject& s_;
  const ir::Monitor& driving_;
  const ir::Monitor& judged_;
  bool is_too_fast_;  // drives faster than a limit of what is judged
};

}  // namespace

std::vector<Start> starts_of_damage(const Subject& s, std::size_t driving, std::size_t judged) {
  if (s.decision.body.in_space) return starts_of_damage_in_space(s, driving, judged);
  return Damage(s, driving, judged).run();
}

}  // namespace rtac::verify
