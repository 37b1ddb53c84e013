#include "compiler/verify/starts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "compiler/analysis/liveness.h"
#include "compiler/analysis/outline.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/linear.h"
#include "compiler/verify/aside.h"
#include "compiler/verify/centres.h"

namespace rtac::verify {
namespace {

using analysis::outline::Outline;
using analysis::outline::P;
using geometry::Region;

// As many attempts as there are, less those that start anywhere.
constexpr std::size_t own_starts_most = 4;

bool is_refuted_by(const Obligation& o, diag::Code code) {
  return o.status == Status::refuted && o.method == by_diagnostic(code);
}

std::vector<std::int64_t> in_mm(P p) {
  return {std::llround(p.x), std::llround(p.y)};
}

// Where every property holds, as far as places of the plane decide.
Region all_hold(const Subject& s) {
  Region all = Region::everywhere();
  for (const ir::Monitor& m : s.decision.monitors) {
    all = all.intersect(centres_of(s, m, start_spare_mm));
  }
  return all;
}

// From where a recovery that moves elsewhere leads out of the property of its own monitor, whoever
// of those that share it has it drive.
void add_damage(const Subject& s, Obligation& o) {
  const auto& monitors = s.decision.monitors;
  const bool pair = o.kind == Kind::keeps && o.starts.empty();
  if (o.kind != Kind::p2a && !pair) return;
  for (std::size_t judged = 0; judged < monitors.size(); ++judged) {
    if (monitors[judged].name != o.monitor) continue;
    for (std::size_t driving = 0; driving < monitors.size(); ++driving) {
      const std::string& leads = pair ? o.recovery : monitors[judged].recovery.name;
      if (monitors[driving].recovery.name != leads) continue;
      for (Start& start : starts_of_damage(s, driving, judged)) {
        o.starts.push_back(std::move(start));
      }
    }
  }
  if (o.starts.size() > own_starts_most) o.starts.resize(own_starts_most);
}

// From where a recovery that takes turns with others leads to where one of those takes over.
void add_turns(const Subject& s, Obligation& o) {
  for (const int driving : o.in_turns->modes) {
    for (const int judged : o.in_turns->modes) {
      if (driving == judged) continue;
      const auto from = std::size_t(driving - 1), to = std::size_t(judged - 1);
      const bool in_space = s.decision.body.in_space;
      for (Start& start :
           in_space ? starts_of_take_over_in_space(s, from, to) : starts_of_damage(s, from, to)) {
        if (o.starts.size() < own_starts_most) o.starts.push_back(std::move(start));
      }
    }
  }
}

// A battery that falls below a constant charge while a robot is braked that is too fast for less:
// just above, by what the way there takes at most, and what it takes to get fast.
std::optional<Start> above_floor(const Subject& s, const ir::Monitor& m) {
  constexpr std::int64_t us_per_s = 1'000'000, seen_ppm = 1'000;
  std::optional<std::int64_t> floor_ppm;
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto least = ir::lower_bound(block, compare, s.decision.facts.params);
    if (!least || least->leaf.kind != ir::Leaf::Kind::battery) return;
    floor_ppm = std::max(floor_ppm.value_or(0), least->need.strictest);
  });
  if (!floor_ppm) return std::nullopt;
  const ir::Motion& any = s.decision.motions.front();
  const std::int64_t gets_fast_us =
      us_per_s * any.speed_mmps / std::max<std::int64_t>(any.accel_mmps2, 1);
  const std::int64_t us = m.lookahead.duration_us + s.decision.body.latency_us +
                          s.decision.return_extra_us + gets_fast_us;
  const std::int64_t taken_ppm = s.decision.body.drain_ppm_per_s * us / us_per_s;
  return Start{{}, {}, *floor_ppm + taken_ppm + seen_ppm};
}

// The waits of a way home, and the way.
std::int64_t takes_s(const Subject& s, const ir::Recovery& recovery) {
  constexpr std::int64_t us_per_s = 1'000'000;
  std::int64_t waits_us = 0;
  for (const ir::Recovery* step : ir::steps_of(recovery)) waits_us += step->lasts_us;
  return waits_us / us_per_s + analysis::patience_s(s.kind, s.module, s.decision, recovery);
}

// Who stands for ever spends all that there is, which is an argument. A way that begins late may be
// within what is kept for others, and a robot that is slow enough needs no charge: that takes a
// run.
void doubt_charge(const Subject& s, const ir::Monitor& m, Obligation& o) {
  const bool slow_enough = analysis::holds_standing(m);
  const bool routes = ir::last_step(m.recovery).kind == ir::RecoveryKind::route;
  o.by_a_run = slow_enough || routes;
  if (routes) o.patience_s = takes_s(s, m.recovery);
  if (!slow_enough) return;
  if (auto start = above_floor(s, m)) o.starts.insert(o.starts.begin(), std::move(*start));
}

// The clearest place of a region, as far as a grid has it.
std::optional<P> clearest(const Region& region) {
  if (region.empty()) return std::nullopt;
  constexpr int across = 32;
  constexpr double far = std::numeric_limits<double>::infinity();
  const Outline outline = Outline::of(region);
  P low{far, far}, high{-far, -far};
  for (const auto& [a, b] : outline.edges()) {
    low = {std::min(low.x, a.x), std::min(low.y, a.y)};
    high = {std::max(high.x, a.x), std::max(high.y, a.y)};
  }
  std::optional<P> best;
  double most = 0;
  for (int i = 0; i < across; ++i) {
    for (int k = 0; k < across; ++k) {
      const P p =
          low + P{(high.x - low.x) * (i + 0.5) / across, (high.y - low.y) * (k + 0.5) / across};
      const double clear = outline.clearance(p);
      if (clear <= most) continue;
      most = clear;
      best = p;
    }
  }
  return best;
}

// Where nothing but its speed makes the property hold: a robot that stands there is slow enough,
// and never seen to stay so.
void add_slow_places(const Subject& s, const ir::Monitor& m, Obligation& o) {
  const Region from = all_hold(s);
  for (const analysis::Standoff& each :
       analysis::fence_standoffs(m.property, s.decision.facts.params)) {
    if (s.module[each.zone].has_height() || o.starts.size() >= own_starts_most) continue;
    const Region& zone = s.exact(each.zone);
    const std::int64_t mm = s.decision.body.radius_mm + each.mm;
    const Region free = analysis::within(zone, mm).value_or(zone);
    if (const auto place = clearest(from.subtract(free))) o.starts.push_back({in_mm(*place)});
  }
}

// Robots that need not keep off, on one side of an `or`, beside one that has to: that one half in
// the zone which the other side asks for, the other one wholly, and just as far away as is asked.
// The longest sides first.
void add_passing_by(const Subject& s, const ir::Monitor& m, Obligation& o) {
  constexpr double outside_mm = 100;
  const Outline allowed = Outline::of(all_hold(s));
  const double body_mm = double(s.decision.body.radius_mm);
  const double apart_mm =
      2 * body_mm + outside_mm + double(analysis::standoffs_of(s.decision).separation_mm);
  std::vector<std::pair<double, Start>> found;
  for (const analysis::Standoff& each :
       analysis::fence_standoffs(m.property, s.decision.facts.params)) {
    if (s.module[each.zone].has_height()) continue;
    const Outline zone = Outline::of(s.exact(each.zone));
    const double inside_mm = body_mm + double(each.mm);
    for (const auto& [a, b] : zone.edges()) {
      const double length_mm = analysis::outline::norm(b - a);
      for (const double side : {1.0, -1.0}) {
        const P inwards = (side / length_mm) * P{a.y - b.y, b.x - a.x};
        const P first = 0.5 * (a + b) + (inside_mm - outside_mm) * inwards;
        const P other = first + apart_mm * inwards;
        if (zone.clearance(other) < inside_mm || zone.clearance(first) >= inside_mm) continue;
        if (!allowed.contains(first) || !allowed.contains(other)) continue;
        found.emplace_back(-length_mm, Start{in_mm(first), {in_mm(other)}});
      }
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<double, Start>::first);
  for (auto& [rank, start] : found) {
    if (o.starts.size() < own_starts_most) o.starts.push_back(std::move(start));
  }
}

// Robots as far from each other as their zones let them be: at the ends of where each of them may
// start, one after the other, each as far as can be from all before it.
std::optional<Start> far_apart(const Subject& s) {
  const Outline begins = Outline::of(all_hold(s));
  const auto robots = static_cast<std::size_t>(s.decision.robots);
  const auto from = [](P a, const std::vector<P>& others) {
    double least = std::numeric_limits<double>::infinity();
    for (const P b : others) least = std::min(least, analysis::outline::norm(a - b));
    return least;
  };
  std::vector<P> placed;
  double farthest = 0;
  for (const auto& one : begins.edges()) {
    for (const auto& other : begins.edges()) {
      const double away = analysis::outline::norm(one.a - other.a);
      if (away <= farthest) continue;
      farthest = away;
      placed = {one.a, other.a};
    }
  }
  if (placed.empty()) return std::nullopt;
  while (placed.size() < robots) {
    const auto next = std::ranges::max_element(
        begins.edges(), {}, [&](const auto& edge) { return from(edge.a, placed); });
    placed.push_back(next->a);
  }
  Start start{in_mm(placed.front())};
  for (std::size_t i = 1; i < placed.size(); ++i) start.others_mm.push_back(in_mm(placed[i]));
  return start;
}

// What asks for more distance than there is room for where control is given back.
bool asks_for_room(const Subject& s, const Obligation& o) {
  const bool never = is_refuted_by(o, diag::Code::return_set_empty) ||
                     (o.kind == Kind::joint_return && o.status == Status::refuted);
  return never && !o.place_mm && o.starts.empty() && s.decision.robots > 1 &&
         analysis::sure_separation_mm(s.decision) > 0;
}

// Of runs that are about some robots of a fleet; of who waits for whom, nobody else has a part in
// it.
void put_others_aside(const Subject& s, Obligation& o) {
  if (o.lock_up) return;
  std::vector<std::vector<std::int64_t>> begins;
  for (const Start& start : o.starts) {
    if (!start.place_mm.empty()) begins.push_back(start.place_mm);
    begins.insert(begins.end(), start.others_mm.begin(), start.others_mm.end());
  }
  if (o.place_mm && !s.decision.body.in_space) {
    begins.push_back({o.place_mm->first, o.place_mm->second});
  }
  o.aside_mm = aside_of(s, begins);
}

void add_own_starts(const Subject& s, Obligation& o) {
  add_damage(s, o);
  const auto m = std::ranges::find(s.decision.monitors, o.monitor, &ir::Monitor::name);
  const bool own = m != s.decision.monitors.end();
  if (own && is_refuted_by(o, diag::Code::recovery_spends_charge)) doubt_charge(s, *m, o);
  // anywhere
  if (o.kind == Kind::p2b && is_refuted_by(o, diag::Code::speed_limit_unkept)) {
    o.starts.emplace_back();
  }
  if (own && o.kind == Kind::p2b && is_refuted_by(o, diag::Code::recovery_elsewhere)) {
    const auto k = std::size_t(m - s.decision.monitors.begin());
    for (Start& start : starts_stranded_in_space(s, k)) o.starts.push_back(std::move(start));
  }
  if (s.decision.body.in_space) return;
  if (own && is_refuted_by(o, diag::Code::recovery_stands)) add_slow_places(s, *m, o);
  if (own && is_refuted_by(o, diag::Code::others_unkept) && s.decision.robots > 1) {
    add_passing_by(s, *m, o);
  }
  if (!asks_for_room(s, o)) return;
  if (auto start = far_apart(s)) o.starts.push_back(std::move(*start));
}

}  // namespace

void add_starts(const Subject& s, Decision& decision) {
  if (s.decision.on_plan) return;
  for (Obligation& o : decision.obligations) {
    if (o.status != Status::refuted && !o.in_turns) continue;
    if (o.in_turns) {
      add_turns(s, o);
    } else {
      add_own_starts(s, o);
    }
    put_others_aside(s, o);
  }
}

}  // namespace rtac::verify
