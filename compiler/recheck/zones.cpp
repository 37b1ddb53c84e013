#include "compiler/recheck/zones.h"

#include <algorithm>
#include <queue>
#include <set>
#include <utility>

#include "compiler/recheck/grid.h"
#include "compiler/recheck/joining.h"
#include "compiler/recheck/on_grid.h"
#include "compiler/recheck/straight.h"

namespace rtac::recheck {

// A zone without a name is called by what it leaves out, or by its line, and a number where that is
// taken.
NamedZones::NamedZones(const sema::Spec& spec, const SourceManager& sources)
    : spec_(spec), zones_(spec) {
  std::set<std::string> taken;
  for (const sema::Zone& zone : spec.zones) taken.insert(zone.name);
  for (const sema::Zone& zone : spec.zones) {
    names_.push_back(zone.name);
    if (!zone.name.empty()) continue;
    const auto* complement = std::get_if<sema::ZoneComplement>(&zone.value->node);
    const std::string of = complement != nullptr ? spec[complement->zone].name : "";
    const SourceRange& range = zone.value->range;
    const std::string base =
        !of.empty()
            ? "outside_of_" + of
            : "zone_of_line_" + std::to_string(sources.position(range.file, range.begin).line);
    std::string& name = names_.back();
    name = base;
    for (int n = 2; !taken.insert(name).second; ++n) name = base + "_" + std::to_string(n);
  }
}

std::string NamedZones::name(sema::ZoneId id) const {
  return names_[static_cast<std::size_t>(id)];
}

std::optional<sema::ZoneId> NamedZones::find(const std::string& name) const {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (names_[i] == name) return sema::ZoneId{static_cast<std::uint32_t>(i)};
  }
  return std::nullopt;
}

bool NamedZones::clear(sema::ZoneId zone, const geometry::Point& place, const Rational& clearance) {
  const geometry::Region* const known = region(zone);
  if (known == nullptr || known->empty() || !known->contains(place)) return false;
  const interp::Outline outline(*known);
  return outline.square_to({place.x, place.y}) >= clearance * clearance;
}

std::optional<geometry::Solid> NamedZones::solid(sema::ZoneId zone) {
  if (const geometry::Solid* const known = zones_.solid_within(zone)) return *known;
  const geometry::Region* const flat = region(zone);
  if (flat == nullptr || flat->empty()) return std::nullopt;
  const geometry::Solid everywhere = geometry::Solid::everywhere();
  const geometry::Slab& all = everywhere.slabs().front();
  return geometry::Solid::prism(*flat, all.floor, all.ceiling);
}

bool NamedZones::clear_in_space(sema::ZoneId zone, const geometry::Point& place, const Rational& z,
                                const Rational& clearance) {
  const auto known = solid(zone);
  if (!known || known->empty()) return false;
  const interp::Surface surface(*known);
  return surface.contains({place.x, place.y}, z) &&
         surface.clearance({place.x, place.y}, z).below >= clearance;
}

bool NamedZones::convex(sema::ZoneId zone, bool slab_by_slab) {
  const auto known = solid(zone);
  if (!known || known->empty()) return false;
  const std::vector<geometry::Slab>& all = known->slabs();
  return (slab_by_slab || all.size() == 1) &&
         std::ranges::all_of(
             all, [](const geometry::Slab& slab) { return is_convex(slab.region.rings()); });
}

std::size_t NamedZones::slabs(sema::ZoneId zone) {
  const auto known = solid(zone);
  return known ? known->slabs().size() : 0;
}

const geometry::Region* NamedZones::slab(sema::ZoneId zone, std::size_t slab) {
  auto known = slabs_.find(zone);
  if (known == slabs_.end()) {
    auto found = solid(zone);
    if (!found) return nullptr;
    known = slabs_.emplace(zone, std::move(*found)).first;
  }
  const std::vector<geometry::Slab>& all = known->second.slabs();
  return slab < all.size() ? &all[slab].region : nullptr;
}

bool NamedZones::convex_slab(sema::ZoneId zone, std::size_t at) {
  const geometry::Region* const region = slab(zone, at);
  return region != nullptr && is_convex(region->rings());
}

bool NamedZones::convex_for(const std::vector<sema::ZoneId>& zones, const Rational& radius) {
  geometry::Region places;
  for (const sema::ZoneId zone : zones) {
    const geometry::Region* const all = region(zone);
    const auto of_discs = all != nullptr ? all->offset(-radius) : std::nullopt;
    if (!of_discs) return false;
    places = places.unite(*of_discs);
  }
  return is_convex(places.rings());
}

bool NamedZones::leads_straight(sema::ZoneId zone, std::size_t from, std::size_t to,
                                const Rational& clearance) {
  const auto known = solid(zone);
  if (!known || std::max(from, to) >= known->slabs().size()) return false;
  const std::vector<geometry::Slab>& all = known->slabs();
  if (all[to].ceiling - all[to].floor < 2 * clearance) return false;
  for (std::size_t k = from; k < to; ++k) {
    const bool joined = all[k].ceiling == all[k + 1].floor;
    if (!joined || !all[k].region.subtract(all[k + 1].region).empty()) return false;
  }
  for (std::size_t k = from; k > to; --k) {
    const bool joined = all[k].floor == all[k - 1].ceiling;
    if (!joined || !all[k].region.subtract(all[k - 1].region).empty()) return false;
  }
  return true;
}

bool NamedZones::within_slab(sema::ZoneId zone, std::size_t slab, const Rational& z,
                             const Rational& clearance) {
  const auto known = solid(zone);
  if (!known || slab >= known->slabs().size()) return false;
  const geometry::Slab& of = known->slabs()[slab];
  return of.floor + clearance <= z && z + clearance <= of.ceiling;
}

namespace {

geometry::Point middle_of(const Grid& grid, std::size_t at) {
  const std::size_t column = at % grid.columns, row = at / grid.columns;
  return {Rational(grid.x + (double(column) + 0.5) * grid.cell),
          Rational(grid.y + (double(row) + 0.5) * grid.cell)};
}
template <class Visit>
void beside(const Grid& grid, std::size_t at, const Visit& visit) {
  const std::size_t column = at % grid.columns, row = at / grid.columns;
  if (column > 0) visit(at - 1);
  if (column + 1 < grid.columns) visit(at + 1);
  if (row > 0) visit(at - grid.columns);
  if (row + 1 < grid.rows) visit(at + grid.columns);
}
// What a way that starts in a cell asks of every other one.
double asks(const Grid& grid, std::size_t at, double route) {
  return std::min(route, grid.clearance[at]);
}
// Within this a way begins at the cell with the shortest one; what it adds is reckoned with.
double reach_of(const Grid& grid) {
  return std::max(0.4, 2 * grid.cell) + grid.cell;
}
// As clear as is asked, both of them whole millimetres.
bool is_clear(double clearance, double asked) {
  return clearance >= asked - slack_m;
}

std::vector<std::size_t> goals_of(const Grid& grid, double goal,
                                  const std::vector<geometry::Point>& sites) {
  std::vector<std::size_t> goals;
  for (std::size_t at = 0; at < grid.clearance.size(); ++at) {
    bool is_goal = sites.empty() && is_clear(grid.clearance[at], goal);
    const geometry::Point middle = middle_of(grid, at);
    for (const geometry::Point& site : sites) {
      const double dx = site.x.get_d() - middle.x.get_d();
      const double dy = site.y.get_d() - middle.y.get_d();
      is_goal = is_goal || (std::abs(dx) <= grid.cell && std::abs(dy) <= grid.cell);
    }
    if (is_goal) goals.push_back(at);
  }
  return goals;
}

// Each robot has a site of its own, to which the others' lead nobody.
std::vector<std::vector<std::size_t>> ends_of(const Grid& grid, double goal,
                                              const std::vector<geometry::Point>& sites) {
  if (sites.empty()) return {goals_of(grid, goal, sites)};
  std::set<std::vector<std::size_t>> apart;
  for (const geometry::Point& site : sites) apart.insert(goals_of(grid, goal, {site}));
  return {apart.begin(), apart.end()};
}
// The least clearance along the best way from each cell; negative: there is none. From the goals
// on: a cell is entered from one that asks for no more than it has. The clearest ways first, so
// that each cell is reached with as much as it can be.
std::vector<double> best_ways(const Grid& grid, const std::vector<std::size_t>& goals) {
  std::vector<double> reached(grid.clearance.size(), -1);
  std::priority_queue<std::pair<double, std::size_t>> open;
  const auto reach = [&](std::size_t at, double with) {
    if (grid.clearance[at] < 0 || with <= reached[at]) return;
    reached[at] = with;
    open.emplace(with, at);
  };
  for (const std::size_t at : goals) reach(at, grid.clearance[at]);
  while (!open.empty()) {
    const auto [with, at] = open.top();
    open.pop();
    if (with < reached[at]) continue;
    const double so_far = with;  // lambdas take no structured bindings
    beside(grid, at, [&](std::size_t to) { reach(to, std::min(so_far, grid.clearance[to])); });
  }
  return reached;
}

// How many steps the shortest way from each cell has on which no cell is less clear than what the
// one before it asks for; negative: there is none. Every step is as long, so that the cells are
// reached in the order of their numbers.
std::vector<std::int64_t> climbs(const Grid& grid, std::vector<std::size_t> open, double route) {
  std::vector<std::int64_t> steps(grid.clearance.size(), -1);
  for (const std::size_t at : open) steps[at] = 0;
  for (std::size_t k = 0; k < open.size(); ++k) {
    const std::size_t to = open[k];
    beside(grid, to, [&](std::size_t from) {
      const bool enters = is_clear(grid.clearance[to], asks(grid, from, route));
      if (steps[from] >= 0 || grid.clearance[from] < 0 || !enters) return;
      steps[from] = steps[to] + 1;
      open.push_back(from);
    });
  }
  return steps;
}

// To the one of these ends that is reached with the least clearance.
std::vector<double> worst_reached(const Grid& grid,
                                  const std::vector<std::vector<std::size_t>>& ends) {
  std::vector<double> worst(grid.clearance.size(), 1e300);
  for (const std::vector<std::size_t>& goals : ends) {
    const std::vector<double> reached = best_ways(grid, goals);
    for (std::size_t at = 0; at < worst.size(); ++at) worst[at] = std::min(worst[at], reached[at]);
  }
  return worst;
}
// And to the farthest one; negative: to one of them there is no such way.
std::vector<std::int64_t> most_steps_of(const Grid& grid,
                                        const std::vector<std::vector<std::size_t>>& ends,
                                        double route) {
  std::vector<std::int64_t> most(grid.clearance.size(), 0);
  for (const std::vector<std::size_t>& goals : ends) {
    const std::vector<std::int64_t> steps = climbs(grid, goals, route);
    for (std::size_t at = 0; at < most.size(); ++at) {
      most[at] = most[at] < 0 || steps[at] < 0 ? -1 : std::max(most[at], steps[at]);
    }
  }
  return most;
}

}  // namespace

std::variant<std::monostate, geometry::Point, BadCells> without_way(
    const geometry::Region& zone, const Cells& cells, const Rational& body_m,
    const Rational& route_m, const Rational& goal_m, const std::vector<geometry::Point>& sites) {
  const std::optional<OnGrid> found = on_grid(zone, cells);
  if (!found) return BadCells{};
  const Grid& grid = found->cells;
  const double route = route_m.get_d(), body = body_m.get_d(), goal = goal_m.get_d();
  const std::vector<double> reached = worst_reached(grid, ends_of(grid, goal, sites));
  Straight straight(found->edges, grid, body_m.get_d(), found->convex);
  JoiningLimits limits{body_m.get_d(),
                       route,
                       sites.empty(),
                       goal,
                       reach_of(grid),
                       std::vector<double>(reached.size(), 0),
                       {}};
  if (sites.empty()) {
    limits.straight = [&](std::size_t at) { return straight.longest_from(at, goal); };
  }
  for (std::size_t at = 0; at < reached.size(); ++at) {
    if (!is_clear(grid.clearance[at], body)) continue;
    if (is_clear(reached[at], asks(grid, at, route))) continue;
    if (!limits.straight || !limits.straight(at)) return middle_of(grid, at);
    limits.rest[at] = -1;
  }
  if (const auto from = joining(found->edges, grid, limits).apart) return middle_of(grid, *from);
  return std::monostate{};
}

std::variant<std::monostate, geometry::Point, BadCells> without_leg(
    const geometry::Region& zone, const Cells& cells, const Rational& seen_m,
    const Rational& body_m, const Rational& error_m, const Rational& fits_m) {
  const std::optional<OnGrid> found = on_grid(zone, cells);
  if (!found) return BadCells{};
  const double goal = fits_m.get_d();
  Straight straight(found->edges, found->cells, seen_m.get_d(), found->convex);
  bool from_bodies = false;
  for (std::size_t at = 0; at < found->cells.clearance.size(); ++at) {
    const double clearance = found->cells.clearance[at];
    if (is_clear(clearance, goal) || (clearance < 0 && !straight.holds_some(at))) continue;
    if (straight.longest_from(at, goal)) continue;
    if (!from_bodies) {
      from_bodies = true;
      // no place where a body fits is lost by how offsets round
      const auto bodies = zone.offset(offsets_round - body_m);
      const Rational off = error_m + offsets_round;
      if (bodies) straight.begin_at({{*bodies}, off.get_d()});
      if (straight.longest_from(at, goal)) continue;
    }
    return middle_of(found->cells, at);
  }
  return std::monostate{};
}

std::optional<LongestWays> longest_ways(const geometry::Region& zone, const Cells& cells,
                                        const Rational& body_m, const Rational& route_m,
                                        const Rational& goal_m,
                                        const std::vector<geometry::Point>& sites, bool deeper) {
  const std::optional<OnGrid> found = on_grid(zone, cells);
  if (!found) return std::nullopt;
  const Grid& grid = found->cells;
  const double route = route_m.get_d(), body = body_m.get_d(), goal = goal_m.get_d();
  const auto ends = ends_of(grid, goal, sites);
  const std::vector<double> reached = worst_reached(grid, ends);
  const std::vector<std::int64_t> steps = most_steps_of(grid, ends, route);
  Straight straight(found->edges, grid, body_m.get_d(), found->convex);
  std::vector<double> rest(steps.size(), 0);
  JoiningLimits limits{body_m.get_d(), route, sites.empty(), goal, reach_of(grid), {}, {}};
  bool endless = false;  // from some cell
  // in sight a way may end, even where none leads over cells; to a site no such leg is taken
  limits.straight = [&](std::size_t at) -> std::optional<double> {
    if (!sites.empty()) return std::nullopt;
    const auto leg = straight.longest_from(at, goal);
    return leg || endless || !deeper ? leg : straight.farthest_from(at, goal);
  };
  std::vector<std::size_t> without;
  std::int64_t most_steps = 0;  // as steps: 96 cells of 0.13 m are more than 12.48 m in doubles
  for (std::size_t at = 0; at < steps.size(); ++at) {
    if (!is_clear(grid.clearance[at], body)) continue;
    most_steps = std::max(most_steps, steps[at]);
    rest[at] = grid.cell * static_cast<double>(std::max<std::int64_t>(steps[at], 0));
    if (steps[at] >= 0) continue;
    endless = endless || is_clear(reached[at], asks(grid, at, route));
    if (!sites.empty()) return std::nullopt;
    without.push_back(at);
  }
  double longest = 0;
  std::vector<double> from = rest;
  for (double& each : from) each += limits.reach;  // of all cells in reach it takes the best one
  for (const std::size_t at : without) {
    const auto leg = limits.straight(at);
    if (!leg) return std::nullopt;
    longest = std::max(longest, *leg - limits.reach);
    rest[at] = -1;
    from[at] = *leg;
  }
  limits.rest = std::move(rest);
  const Joining begins = joining(found->edges, grid, limits);
  if (begins.apart) return std::nullopt;
  const Rational over_cells = Rational(static_cast<long>(cells.cell_mm * most_steps)) / 1000;
  for (std::size_t at = 0; at < from.size(); ++at) {
    const bool leads_on = steps[at] >= 0 && is_clear(grid.clearance[at], body);
    if (begins.from[at] < 0) continue;
    from[at] = leads_on ? begins.from[at] : std::max(begins.from[at], from[at]);
  }
  return LongestWays{
      std::max(over_cells, Rational(std::max(longest, begins.longest - limits.reach))),
      std::move(from)};
}

std::optional<Rational> longest_way(const geometry::Region& zone, const Cells& cells,
                                    const Rational& body_m, const Rational& route_m,
                                    const Rational& goal_m,
                                    const std::vector<geometry::Point>& sites, bool deeper) {
  const auto ways = longest_ways(zone, cells, body_m, route_m, goal_m, sites, deeper);
  return ways ? std::optional(ways->longest) : std::nullopt;
}

bool legs_lead(const geometry::Region& zone, const Cells& cells, const Rational& body_m,
               const Rational& back_m, const Rational& aim_m, const Rational& most_m) {
  const std::vector<Segment> edges = segments_of(zone);
  const std::optional<Grid> grid = grid_of(edges, cells);
  if (!grid) return false;
  Straight straight(edges, *grid, body_m.get_d(), is_convex(zone.rings()));
  for (std::size_t at = 0; at < grid->clearance.size(); ++at) {
    if (grid->clearance[at] >= back_m.get_d() + table_m) continue;
    if (grid->clearance[at] < 0 && !straight.holds_some(at)) continue;
    if (!straight.longest_from(at, aim_m.get_d(), most_m.get_d())) return false;
  }
  return true;
}

bool has_end(const geometry::Region& region) {
  const Rational far(100'000);
  return std::ranges::all_of(region.rings(), [&](const geometry::Ring& ring) {
    return std::ranges::all_of(
        ring, [&](const geometry::Point& p) { return abs(p.x) <= far && abs(p.y) <= far; });
  });
}

}  // namespace rtac::recheck
