#include "compiler/recheck/zones.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace rtac::recheck {
namespace {

// Of the grid on which ways are looked for, in m; the least of the compiler's tables.
constexpr double cell_m = 0.1;
constexpr std::size_t cells_most = 400'000;
// Doubles find distances to this, in m; bounds are taken to the safe side.
constexpr double slack_m = 1e-6;

struct Segment {
  double ax, ay, bx, by;
};
std::vector<Segment> segments(const geometry::Region& region) {
  std::vector<Segment> all;
  for (const geometry::Ring& ring : region.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const geometry::Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      all.push_back({a.x.get_d(), a.y.get_d(), b.x.get_d(), b.y.get_d()});
    }
  }
  return all;
}
double square_to(const Segment& s, double x, double y) {
  const double dx = s.bx - s.ax, dy = s.by - s.ay;
  const double along =
      std::clamp(((x - s.ax) * dx + (y - s.ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double ex = s.ax + along * dx - x, ey = s.ay + along * dy - y;
  return ex * ex + ey * ey;
}
// Crossings to the right of the place decide; on the boundary the distance is 0 anyway.
bool inside(const std::vector<Segment>& all, double x, double y) {
  bool in = false;
  for (const Segment& s : all) {
    if ((s.ay > y) == (s.by > y)) continue;
    if (x < s.ax + (y - s.ay) / (s.by - s.ay) * (s.bx - s.ax)) in = !in;
  }
  return in;
}

struct Grid {
  double x = 0, y = 0;
  std::size_t columns = 0, rows = 0;
  std::vector<double> clearance;  // of every place of the cell, at least; negative: none
};
Grid grid_of(const std::vector<Segment>& all) {
  Grid grid;
  double right = all[0].ax, top = all[0].ay;
  grid.x = right, grid.y = top;
  for (const Segment& s : all) {
    grid.x = std::min(grid.x, s.ax), grid.y = std::min(grid.y, s.ay);
    right = std::max(right, s.ax), top = std::max(top, s.ay);
  }
  grid.columns = static_cast<std::size_t>(std::ceil((right - grid.x) / cell_m)) + 1;
  grid.rows = static_cast<std::size_t>(std::ceil((top - grid.y) / cell_m)) + 1;
  if (grid.columns * grid.rows > cells_most) return grid;
  for (std::size_t i = 0; i < grid.columns * grid.rows; ++i) {
    const std::size_t column = i % grid.columns, row = i / grid.columns;
    const double x = grid.x + (double(column) + 0.5) * cell_m;
    const double y = grid.y + (double(row) + 0.5) * cell_m;
    double square = 1e300;
    for (const Segment& s : all) square = std::min(square, square_to(s, x, y));
    const double gap = std::sqrt(square) - cell_m * std::sqrt(0.5) - slack_m;
    grid.clearance.push_back(inside(all, x, y) ? gap : -1);
  }
  return grid;
}

}  // namespace

NamedZones::NamedZones(const sema::Spec& spec, const SourceManager& sources)
    : spec_(spec), sources_(sources), zones_(spec) {}

std::string NamedZones::name(sema::ZoneId id) const {
  const sema::Zone& zone = spec_[id];
  if (!zone.name.empty()) return zone.name;
  const SourceRange& range = zone.value->range;
  return "zone_of_line_" + std::to_string(sources_.position(range.file, range.begin).line);
}

std::optional<sema::ZoneId> NamedZones::find(const std::string& name) const {
  for (std::size_t i = 0; i < spec_.zones.size(); ++i) {
    const sema::ZoneId id{static_cast<std::uint32_t>(i)};
    if (this->name(id) == name) return id;
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

bool NamedZones::convex(sema::ZoneId zone) {
  const auto known = solid(zone);
  if (!known || known->slabs().size() != 1) return false;
  const auto rings = known->slabs().front().region.rings();
  if (rings.size() != 1) return false;
  const std::size_t count = rings.front().size();
  for (std::size_t i = 0; i < count; ++i) {
    const geometry::Point &a = rings[0][i], &b = rings[0][(i + 1) % count];
    // no corner lies to the right of an edge
    for (const geometry::Point& p : rings[0]) {
      if ((b.x - a.x) * (p.y - a.y) < (b.y - a.y) * (p.x - a.x)) return false;
    }
  }
  return true;
}

std::optional<geometry::Point> without_way(const geometry::Region& zone, const Rational& body_m,
                                           const Rational& route_m, const Rational& goal_m,
                                           const std::vector<geometry::Point>& sites) {
  const std::vector<Segment> all = segments(zone);
  const Grid grid = grid_of(all);
  const auto place = [&](std::size_t at) {
    const std::size_t column = at % grid.columns, row = at / grid.columns;
    return geometry::Point{Rational(grid.x + (double(column) + 0.5) * cell_m),
                           Rational(grid.y + (double(row) + 0.5) * cell_m)};
  };
  if (grid.clearance.empty()) return place(0);
  // From the goals on: a cell is entered from one that asks for no more than it has. The clearest
  // ways first, so that each cell is reached with as much as it can be.
  const double route = route_m.get_d(), goal = goal_m.get_d(), body = body_m.get_d();
  const auto asks = [&](std::size_t at) { return std::min(route, grid.clearance[at]); };
  std::vector<double> reached(grid.clearance.size(), -1);  // least clearance along the best way
  std::priority_queue<std::pair<double, std::size_t>> open;
  const auto reach = [&](std::size_t at, double with) {
    if (grid.clearance[at] < 0 || with <= reached[at]) return;
    reached[at] = with;
    open.emplace(with, at);
  };
  for (std::size_t at = 0; at < reached.size(); ++at) {
    bool is_goal = sites.empty() && grid.clearance[at] >= goal;
    for (const geometry::Point& site : sites) {
      const double dx = site.x.get_d() - place(at).x.get_d();
      const double dy = site.y.get_d() - place(at).y.get_d();
      is_goal = is_goal || (std::abs(dx) <= cell_m && std::abs(dy) <= cell_m);
    }
    if (is_goal) reach(at, grid.clearance[at]);
  }
  while (!open.empty()) {
    const double with = open.top().first;
    const std::size_t at = open.top().second;
    open.pop();
    if (with < reached[at]) continue;
    const std::size_t column = at % grid.columns, row = at / grid.columns;
    const auto step = [&](std::size_t to) { reach(to, std::min(with, grid.clearance[to])); };
    if (column > 0) step(at - 1);
    if (column + 1 < grid.columns) step(at + 1);
    if (row > 0) step(at - grid.columns);
    if (row + 1 < grid.rows) step(at + grid.columns);
  }
  for (std::size_t at = 0; at < reached.size(); ++at) {
    if (grid.clearance[at] >= body && reached[at] < asks(at)) return place(at);
  }
  return std::nullopt;
}

}  // namespace rtac::recheck
