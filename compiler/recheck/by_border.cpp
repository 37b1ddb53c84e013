#include "compiler/recheck/by_border.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>
#include <vector>

#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/on_grid.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/straight.h"
#include "compiler/recheck/travel.h"
#include "compiler/recheck/ways_said.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {
namespace {

// Why it is not as clear as said where it sets out, or may go elsewhere.
std::optional<Doubt> sets_out(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                              const sema::Monitor& driving, const Said& said,
                              const Rational& extra) {
  if (said.back < claims.led_to(d, driving, said.zone, extra)) {
    return wrong("it leads deeper before control is given back");
  }
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (m.recover != driving.recover || m.return_when == nullptr) continue;
    if (!lets_go(spec, d, claims, m, said.back)) {
      return wrong("`return when` of `" + m.name + "` may have it led deeper");
    }
  }
  return std::nullopt;
}

// The most clearance of any place no farther than `reach` from some place of a cell.
double deepest_within(const Grid& grid, std::size_t at, double reach) {
  const double across = grid.cell * std::sqrt(2.0);
  const auto depth = [&](std::size_t of) { return std::max(grid.clearance[of], 0.0) + across; };
  const auto side = [&](std::size_t a, std::size_t b) {
    const std::size_t apart = a > b ? a - b : b - a;
    return apart < 2 ? 0.0 : double(apart - 1) * grid.cell;
  };
  const auto around = static_cast<std::size_t>(std::min(reach / grid.cell, 1e6)) + 1;
  const auto first = [&](std::size_t of) { return of > around ? of - around : 0; };
  const std::size_t at_row = at / grid.columns, at_column = at % grid.columns;
  double most = 0;
  for (auto row = first(at_row); row < std::min(grid.rows, at_row + around + 1); ++row) {
    const double dy = side(row, at_row);
    for (auto column = first(at_column); column < std::min(grid.columns, at_column + around + 1);
         ++column) {
      const double dx = side(column, at_column);
      if (dx * dx + dy * dy > reach * reach) continue;
      most = std::max(most, depth(row * grid.columns + column));
    }
  }
  return std::min(most, depth(at) + reach);
}

// By cell, how far a way may lead from there: to where it aims, or where control is given back.
std::optional<std::vector<double>> ways_from(const geometry::Region& zone, const Said& said,
                                             const sema::Template& last) {
  std::optional<std::vector<double>> all;
  const std::vector<Rational> aims = aims_of(said, last);
  for (std::size_t k = 0; k < aims.size(); ++k) {
    const auto ways = longest_ways(zone, said.cells, said.starts, said.route, aims[k], {}, k > 0);
    if (!ways) return std::nullopt;
    if (!all) all.emplace(ways->from.size(), 0);
    for (std::size_t at = 0; at < all->size(); ++at) {
      (*all)[at] = std::max((*all)[at], ways->from[at]);
    }
  }
  return all;
}

// How far from the border it is led, but for what it strays by: from each cell by a leg that is in
// sight and short enough to be taken before a search, or else by that or a way over cells.
// nullopt: that is not known.
std::optional<Rational> deepest_of(const geometry::Region& zone, const Said& said,
                                   const sema::RobotKind& kind, const sema::Template& last,
                                   const Rational& keeps) {
  const auto in = led_in(zone, said, kind, last, keeps);
  const auto found = on_grid(zone, said.cells);
  if (!in || !found) return std::nullopt;
  const Grid& grid = found->cells;
  const double aim = aims_of(said, last).back().get_d();
  constexpr double rounded = 0.004;
  Straight straight(found->edges, grid, kind.radius.value.get_d(), found->convex);
  std::optional<std::vector<double>> ways;
  double most = aim;
  for (std::size_t at = 0; at < grid.clearance.size(); ++at) {
    if (grid.clearance[at] >= said.back.get_d() + table_m) continue;
    if (grid.clearance[at] < 0 && !straight.holds_some(at)) continue;
    auto way = straight.longest_from(at, aim, 2 * aim - rounded);
    if (!way) {
      if (!ways) ways = ways_from(zone, said, last);
      if (!ways) return std::nullopt;
      way = std::max(2 * aim, (*ways)[at]);
    }
    if (!in->from.empty()) way = std::max(*way, in->from[at]);
    most = std::max(most, deepest_within(grid, at, *way));
  }
  return Rational(most);
}

}  // namespace

std::optional<Doubt> check_by_border(const sema::Spec& spec, const sema::Decision& decision,
                                     Claims& claims, const Values& v) {
  const sema::RobotKind& kind = spec[decision.kind];
  const sema::Monitor* const driving = monitor_of(spec, decision, text(v, "monitor"));
  const sema::Monitor* const judged = monitor_of(spec, decision, text(v, "judged"));
  const auto near_mm = number(v, "near_mm"), extra_us = number(v, "extra_us");
  const auto said = said_of(claims, v);
  const auto outer = claims.zones().find(text(v, "outer"));
  if (driving == nullptr || judged == nullptr || !driving->recover || !near_mm || !extra_us ||
      !said || !outer) {
    return wrong("no such monitor or zone, or a number is missing");
  }
  const sema::Controller& recovery = spec[*driving->recover];
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  const auto* const retreat = steps.empty() ? nullptr : std::get_if<sema::Retreat>(&steps.back());
  const bool brakes_before =
      !steps.empty() && std::all_of(steps.begin(), std::prev(steps.end()), [](const auto& step) {
        return std::holds_alternative<sema::BrakeAndHold>(step);
      });
  if (retreat == nullptr || !brakes_before || retreat->zone != said->zone || kind.in_space) {
    return wrong("it is no retreat of the plane within that zone");
  }
  if (!is_alone(spec, decision)) return wrong("others may stand in its way");
  const geometry::Region* const zone = claims.zones().region(said->zone);
  const geometry::Region* const fence = claims.zones().region(*outer);
  if (zone == nullptr || fence == nullptr) return Doubt{false, "a zone is not known"};
  if (!starts_within(spec, decision, claims, *judged, said->zone)) {
    return wrong("it may begin outside of its zone");
  }
  if (auto doubt = sets_out(spec, decision, claims, *driving, *said, micro(*extra_us)))
    return doubt;
  if (said->route < claims.leg_clearance(decision, *driving, said->zone)) return wrong(too_near);
  const Rational keeps = starts_off(spec, decision, *driving, said->zone);
  const Rational step(1, 1000), error = kind.position ? kind.position->error.value : Rational(0);
  if (said->starts > kind.radius.value + keeps + 2 * step) {
    return wrong("it leaves out places that a body fits");
  }
  if (said->aim < said->back + std::max(Rational(1, 50), error) + error) {
    return wrong("it aims deeper");
  }
  if (said->exact && *said->exact < std::max(said->aim, said->route)) {
    return wrong("farther from the boundary than the tables are exact it may be led anywhere");
  }
  const auto deepest = deepest_of(*zone, *said, kind, steps.back(), keeps);
  const auto run_out = driven_metres(kind, decision, recovery, std::nullopt, 0, 0);
  if (!deepest || !run_out) return wrong("its way may be longer");
  const Numbers n = numbers_of(spec, decision, jitter_of(spec, decision));
  const Rational grid(1, 200);
  const Rational off =
      beside_way(kind, decision, retreat->speed.value) + n.sway + n.hold + 3 * error + grid;
  if (milli(*near_mm) < *deepest + *run_out + off + kind.radius.value) {
    return wrong("it may drive farther from the border");
  }
  const auto middle = zone->offset(-milli(*near_mm));
  const auto standoff = v.contains("standoff_mm") ? number(v, "standoff_mm") : 0;
  if (!middle || !standoff || *standoff < 0) return wrong("the standoff is no number");
  const auto kept = fence->offset(-without_excess(milli(*standoff)));
  if (kept && kept->contains(zone->subtract(*middle))) return std::nullopt;
  return wrong("what is as near to the border is not contained");
}

}  // namespace rtac::recheck
