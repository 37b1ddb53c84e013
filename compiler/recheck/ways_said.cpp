#include "compiler/recheck/ways_said.h"

#include <algorithm>
#include <variant>

#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/way_legs.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {
namespace {

// What one that loiters would like to have more.
const Rational to_circle(1, 2);

}  // namespace

std::optional<Said> said_of(Claims& claims, const Values& v) {
  const auto zone = claims.zones().find(text(v, "zone"));
  const auto cell = number(v, "cell_mm"), x = number(v, "cells_x_mm"), y = number(v, "cells_y_mm");
  if (!zone || !cell || *cell <= 0 || !x || !y) return std::nullopt;
  Said said{*zone, {*cell, *x, *y}, {}, {}, {}, {}, {}};
  for (const auto& [key, to] :
       {std::pair("starts_mm", &said.starts), std::pair("route_mm", &said.route),
        std::pair("return_mm", &said.back), std::pair("aim_mm", &said.aim)}) {
    const auto mm = number(v, key);
    if (!mm || *mm < 0) return std::nullopt;
    *to = milli(*mm);
  }
  if (v.contains("exact_mm")) {
    const auto mm = number(v, "exact_mm");
    if (!mm) return std::nullopt;
    said.exact = milli(*mm);
  }
  return said;
}

Rational starts_off(const sema::Spec& spec, const sema::Decision& d, const sema::Monitor& driving,
                    sema::ZoneId zone) {
  Rational relied = 0;
  std::optional<Rational> drives;
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    const Rational gap = sure_gap_of(spec, *m.always, zone);
    if (relied_on(spec, d, m)) relied = std::max(relied, gap);
    if (m.recover == driving.recover) drives = std::min(drives.value_or(gap), gap);
  }
  return std::max(relied, drives.value_or(0));
}

std::vector<geometry::Point> sites_of(const sema::Spec& spec, const sema::Template& last) {
  std::vector<geometry::Point> sites;
  if (const auto* route = std::get_if<sema::Route>(&last)) {
    for (const auto& place : spec[route->site].places) {
      sites.push_back({place.position.x, place.position.y});
    }
  }
  return sites;
}

std::optional<Rational> longest(const geometry::Region& zone, const Said& said,
                                const std::vector<geometry::Point>& sites,
                                const sema::Template& last) {
  auto most = longest_way(zone, said.cells, said.starts, said.route, said.back, sites);
  if (!sites.empty()) return most;
  // one that loiters would like to have half a metre more; a leg in sight is taken that is no
  // longer than twice what is wanted
  std::vector<Rational> aims{said.aim};
  if (std::holds_alternative<sema::Loiter>(last)) aims.emplace_back(said.aim + to_circle);
  for (const Rational& aim : aims) {
    const auto deeper = longest_way(zone, said.cells, said.starts, said.route, aim, sites, true);
    if (!most || !deeper) return std::nullopt;
    most = std::max({*most, *deeper, Rational(2 * aim)});
  }
  return most;
}

bool takes_legs(const geometry::Region& zone, const Said& said, const sema::RobotKind& kind,
                const sema::Template& last, const Rational& leg) {
  const bool loiters = std::holds_alternative<sema::Loiter>(last);
  if (!loiters && !std::holds_alternative<sema::Retreat>(last)) return false;
  const Rational aim = loiters ? Rational(said.aim + to_circle) : said.aim;
  const Rational rounded(1, 250);
  return aim <= leg && leg <= 2 * aim - rounded &&
         legs_lead(zone, said.cells, kind.radius.value, said.back, aim, leg);
}

std::vector<Rational> aims_of(const Said& said, const sema::Template& last) {
  std::vector<Rational> aims{said.back, said.aim};
  if (std::holds_alternative<sema::Loiter>(last)) aims.emplace_back(said.aim + to_circle);
  return aims;
}

std::optional<Led> led_in(const geometry::Region& zone, const Said& said,
                          const sema::RobotKind& kind, const sema::Template& last,
                          const Rational& keeps) {
  const Rational& body = kind.radius.value;
  const Rational error = kind.position ? kind.position->error.value : Rational(0);
  const Rational kept = std::min(Rational(said.starts - body), keeps);
  if (kept >= error) return Led{0, 0};
  if (kept + body <= error) return std::nullopt;
  const auto in =
      leads_in_within(zone, said.cells, body + kept - error, body, said.route, aims_of(said, last));
  if (!in) return std::nullopt;
  return Led{std::max(in->first, said.route), std::max(in->all, aims_of(said, last).back()),
             in->from};
}

}  // namespace rtac::recheck
