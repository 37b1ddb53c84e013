#include "compiler/recheck/led_from.h"

#include <algorithm>
#include <iterator>
#include <optional>

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

// By a leg that is in sight and short enough to be taken before a search, or else by that or a way
// over cells.
std::optional<std::vector<double>> lengths_from(const geometry::Region& zone, const OnGrid& on,
                                                const Said& said, const sema::RobotKind& kind,
                                                const sema::Template& last, const Rational& keeps) {
  const auto in = led_in(zone, said, kind, last, keeps);
  if (!in) return std::nullopt;
  const Grid& grid = on.cells;
  const double aim = aims_of(said, last).back().get_d();
  constexpr double rounded = 0.004;
  Straight straight(on.edges, grid, kind.radius.value.get_d(), on.convex);
  std::optional<std::vector<double>> ways;
  std::vector<double> all(grid.clearance.size(), -1);
  for (std::size_t at = 0; at < all.size(); ++at) {
    if (grid.clearance[at] >= said.back.get_d() + table_m) continue;
    if (grid.clearance[at] < 0 && !straight.holds_some(at)) continue;
    auto way = straight.longest_from(at, aim, 2 * aim - rounded);
    if (!way) {
      if (!ways) ways = ways_from(zone, said, last);
      if (!ways) return std::nullopt;
      way = std::max(2 * aim, (*ways)[at]);
    }
    all[at] = in->from.empty() ? *way : std::max(*way, in->from[at]);
  }
  return all;
}

// A retreat, but for brakes before it.
const sema::Retreat* retreat_of(const std::vector<sema::Template>& steps) {
  const auto brakes = [](const sema::Template& step) {
    return std::holds_alternative<sema::BrakeAndHold>(step);
  };
  if (steps.empty() || !std::all_of(steps.begin(), std::prev(steps.end()), brakes)) return nullptr;
  return std::get_if<sema::Retreat>(&steps.back());
}

}  // namespace

std::variant<LedFrom, Doubt> led_from(const sema::Spec& spec, const sema::Decision& decision,
                                      Claims& claims, const Values& v, const Rational& standoff) {
  const sema::RobotKind& kind = spec[decision.kind];
  const sema::Monitor* const driving = monitor_of(spec, decision, text(v, "monitor"));
  const auto extra_us = number(v, "extra_us");
  const auto said = said_of(claims, v);
  if (driving == nullptr || !driving->recover || !extra_us || !said) {
    return wrong("no such monitor or zone, or a number is missing");
  }
  const sema::Controller& recovery = spec[*driving->recover];
  const std::vector<sema::Template> steps = sema::templates_of(recovery);
  const sema::Retreat* const retreat = retreat_of(steps);
  if (retreat == nullptr || retreat->zone != said->zone || kind.in_space) {
    return wrong("it is no retreat of the plane within that zone");
  }
  if (!is_alone(spec, decision)) return wrong("others may stand in its way");
  const geometry::Region* const zone = claims.zones().region(said->zone);
  if (zone == nullptr) return Doubt{false, "a zone is not known"};
  if (auto doubt = sets_out(spec, decision, claims, *driving, *said, micro(*extra_us))) {
    return *doubt;
  }
  const Rational own = gap_of(spec, *driving->always, said->zone);
  const Rational least = claims.leg_clearance(decision, *driving, said->zone);
  if (said->route < least - own + std::max(own, standoff)) return wrong(too_near);
  // somebody may have broken it before
  const Rational keeps = relied_on(spec, decision, *driving)
                             ? starts_off(spec, decision, *driving, said->zone)
                             : Rational(0);
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
  auto on = on_grid(*zone, said->cells);
  if (!on) return wrong("the cells are not those of the zone");
  auto from = lengths_from(*zone, *on, *said, kind, steps.back(), keeps);
  const auto run_out = driven_metres(kind, decision, recovery, std::nullopt, 0, 0);
  if (!from || !run_out) return wrong("nothing bounds its ways");
  const Numbers n = numbers_of(spec, decision, jitter_of(spec, decision));
  const Rational grid(1, 200);
  const Rational strays = *run_out + beside_way(kind, decision, retreat->speed.value) + n.sway +
                          n.hold + 3 * error + grid;
  return LedFrom{driving,
                 said->zone,
                 zone,
                 std::move(on->cells),
                 std::move(*from),
                 aims_of(*said, steps.back()).back().get_d(),
                 strays};
}

}  // namespace rtac::recheck
