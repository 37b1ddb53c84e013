#include "compiler/recheck/by_border.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/led_from.h"

namespace rtac::recheck {
namespace {

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

double deepest_of(const LedFrom& led) {
  double most = led.aims;
  for (std::size_t at = 0; at < led.from.size(); ++at) {
    if (led.from[at] >= 0) most = std::max(most, deepest_within(led.grid, at, led.from[at]));
  }
  return most;
}

double nearest(const std::vector<Segment>& all, double x, double y) {
  double square = std::numeric_limits<double>::infinity();
  for (const Segment& s : all) square = std::min(square, square_to(s, x, y));
  return std::sqrt(square);
}

// Of the boundary of a zone what is no part of that of a fence, exactly.
std::vector<Segment> other_walls(const geometry::Region& zone, const geometry::Region& fence) {
  using geometry::Point;
  const std::vector<geometry::Ring> outer = fence.rings();
  const auto lies_on = [](const Point& p, const Point& a, const Point& b) {
    const Rational dx = b.x - a.x, dy = b.y - a.y, along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    return (p.x - a.x) * dy == (p.y - a.y) * dx && along >= 0 && along <= dx * dx + dy * dy;
  };
  const auto is_of_fence = [&](const Point& a, const Point& b) {
    return std::ranges::any_of(outer, [&](const geometry::Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &c = ring[i], &d = ring[(i + 1) % ring.size()];
        if (lies_on(a, c, d) && lies_on(b, c, d)) return true;
      }
      return false;
    });
  };
  std::vector<Segment> all;
  for (const geometry::Ring& ring : zone.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (is_of_fence(a, b)) continue;
      all.push_back({a.x.get_d(), a.y.get_d(), b.x.get_d(), b.y.get_d()});
    }
  }
  return all;
}

}  // namespace

std::optional<Doubt> check_by_border(const sema::Spec& spec, const sema::Decision& decision,
                                     Claims& claims, const Values& v) {
  const sema::Monitor* const judged = monitor_of(spec, decision, text(v, "judged"));
  const auto near_mm = number(v, "near_mm");
  const auto outer = claims.zones().find(text(v, "outer"));
  const auto standoff = v.contains("standoff_mm") ? number(v, "standoff_mm") : 0;
  if (judged == nullptr || !near_mm || !outer || !standoff || *standoff < 0) {
    return wrong("no such monitor or zone, or a number is missing");
  }
  const geometry::Region* const fence = claims.zones().region(*outer);
  if (fence == nullptr) return Doubt{false, "a zone is not known"};
  const auto found = led_from(spec, decision, claims, v, 0);
  if (const auto* const doubt = std::get_if<Doubt>(&found)) return *doubt;
  const auto& led = std::get<LedFrom>(found);
  if (!starts_within(spec, decision, claims, *judged, led.zone)) {
    return wrong("it may begin outside of its zone");
  }
  const Rational body = spec[decision.kind].radius.value;
  if (milli(*near_mm) < Rational(deepest_of(led)) + led.strays + body) {
    return wrong("it may drive farther from the border");
  }
  const auto middle = led.region->offset(-milli(*near_mm));
  const auto kept = fence->offset(-without_excess(milli(*standoff)));
  if (middle && kept && kept->contains(led.region->subtract(*middle))) return std::nullopt;
  return wrong("what is as near to the border is not contained");
}

std::optional<Doubt> check_around(const sema::Spec& spec, const sema::Decision& decision,
                                  Claims& claims, const Values& v) {
  const auto standoff_mm = number(v, "standoff_mm");
  const auto outer = claims.zones().find(text(v, "outer"));
  if (!standoff_mm || *standoff_mm < 0 || !outer) return wrong("no such zone or standoff");
  const geometry::Region* const fence = claims.zones().region(*outer);
  if (fence == nullptr) return Doubt{false, "a zone is not known"};
  const Rational standoff = milli(*standoff_mm);
  const auto found = led_from(spec, decision, claims, v, standoff);
  if (const auto* const doubt = std::get_if<Doubt>(&found)) return *doubt;
  const auto& led = std::get<LedFrom>(found);
  if (sure_gap_of(spec, *led.driving->always, *outer) < standoff) {
    return wrong("its property does not ask for so much");
  }
  if (!fence->contains(*led.region)) return wrong("its zone does not lie in that");
  const std::vector<Segment> others = other_walls(*led.region, *fence), walls = segments_of(*fence);
  const double keeps = Rational(spec[decision.kind].radius.value + standoff + led.strays).get_d();
  const Grid& grid = led.grid;
  const double around = grid.cell * std::sqrt(0.5);
  for (std::size_t at = 0; at < led.from.size(); ++at) {
    if (led.from[at] < 0) continue;
    const std::size_t column = at % grid.columns, row = at / grid.columns;
    const double x = grid.x + (double(column) + 0.5) * grid.cell;
    const double y = grid.y + (double(row) + 0.5) * grid.cell;
    if (nearest(others, x, y) - around >= keeps) continue;
    if (nearest(walls, x, y) - around < keeps + led.from[at]) {
      return wrong("from beside another wall its way may lead nearer");
    }
  }
  return std::nullopt;
}

}  // namespace rtac::recheck
