#include "compiler/analysis/sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "compiler/sema/templates.h"

namespace rtac::analysis {
namespace {

bool is_used(const sema::Spec& spec, std::size_t controller) {
  const sema::ControllerId id{static_cast<std::uint32_t>(controller)};
  return std::any_of(
      spec.decisions.begin(), spec.decisions.end(), [&](const sema::Decision& decision) {
        return std::any_of(decision.priority.begin(), decision.priority.end(),
                           [&](sema::MonitorId monitor) { return spec[monitor].recover == id; });
      });
}

double distance_m(const geometry::Point& p, const geometry::Point& a, const geometry::Point& b) {
  const double ax = Rational(a.x - p.x).get_d(), ay = Rational(a.y - p.y).get_d();
  const double dx = Rational(b.x - a.x).get_d(), dy = Rational(b.y - a.y).get_d();
  const double t = std::clamp(-(ax * dx + ay * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(ax + t * dx, ay + t * dy);
}

// To the boundary, from either side.
double distance_m(const geometry::Point& p, const geometry::Region& region) {
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const geometry::Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      least = std::min(least, distance_m(p, ring[i], ring[(i + 1) % ring.size()]));
    }
  };
  for (const geometry::PolygonWithHoles& part : region.polygons()) {
    consider(part.outer);
    for (const geometry::Ring& hole : part.holes) consider(hole);
  }
  return least;
}

constexpr double rounding_m = 1e-9;  // of the doubles, within a few km

std::string millimetres_down(double value_m) {
  const double whole_mm = std::floor((value_m + rounding_m) * 1000);
  return to_decimal(Rational(static_cast<long>(whole_mm), 1000)) + " m";
}
std::string millimetres_up(double value_m) {
  const double whole_mm = std::ceil((value_m - rounding_m) * 1000);
  return to_decimal(Rational(static_cast<long>(whole_mm), 1000)) + " m";
}

std::string name_of(const sema::Spec& spec, const sema::Site& site,
                    const sema::Site::Place& place) {
  return "`" + site.name + (place.robot ? "(" + spec[*place.robot].name + ")`" : "`");
}

class Checker {
 public:
  Checker(const sema::Spec& spec, diag::Engine& diagnostics)
      : spec_(spec), diagnostics_(diagnostics) {}

  void route(const sema::Controller& controller, const sema::Route& route,
             const geometry::Region& region) {
    const sema::Site& site = spec_[route.site];
    for (const sema::Site::Place& place : site.places) {
      if (place.robot && spec_[*place.robot].kind != controller.kind) continue;
      check(place, name_of(spec_, site, place), spec_[route.zone].name, region,
            spec_[controller.kind].radius.value);
    }
  }

 private:
  void check(const sema::Site::Place& place, const std::string& what, const std::string& zone,
             const geometry::Region& region, const Rational& radius) {
    const geometry::Point p{place.position.x, place.position.y};
    const double gap_m = distance_m(p, region);
    const std::string fits = to_decimal(radius) + " m from the boundary";
    if (!region.contains(p)) {
      report(place,
             what + " lies outside `" + zone + "`, " + millimetres_up(gap_m) + " away from it",
             "move it inside, at least " + fits + ", the radius of the body");
    } else if (gap_m < radius.get_d() - rounding_m) {
      report(place,
             "a body at " + what + " reaches out of `" + zone + "`: its centre is " +
                 millimetres_down(gap_m) + " from the boundary",
             "at least " + fits + " works, the radius of the body");
    }
  }
  void report(const sema::Site::Place& place, std::string message, std::string help) {
    diagnostics_.report({diag::Code::site_outside_zone,
                         place.range,
                         std::move(message),
                         "",
                         {},
                         std::move(help),
                         {}});
  }

  const sema::Spec& spec_;
  diag::Engine& diagnostics_;
};

// What a property asks for of a zone: so much of the clearance of the body, in m.
struct Fence {
  sema::ZoneId zone;
  double least_m = 0;
};
std::optional<Fence> fence_of(const sema::Expr& e) {
  if (const auto* inside = std::get_if<sema::InsideZone>(&e.node)) return Fence{inside->zone, 0};
  const auto* compare = std::get_if<sema::Compare>(&e.node);
  if (compare == nullptr) return std::nullopt;
  const bool at_most =
      compare->op == sema::CompareOp::less || compare->op == sema::CompareOp::less_equal;
  const sema::Expr& larger = at_most ? *compare->right : *compare->left;
  const sema::Expr& smaller = at_most ? *compare->left : *compare->right;
  const auto* clearance = std::get_if<sema::Clearance>(&larger.node);
  const auto* least = std::get_if<sema::Constant>(&smaller.node);
  if (clearance == nullptr || least == nullptr) return std::nullopt;
  return Fence{clearance->zone, least->value.get_d()};
}

std::string out_of_reach(const Barred& barred) {
  return "out of reach: by " + millimetres_up(barred.short_m);
}

// What monitors ask of the places where robots are.
class Fences {
 public:
  Fences(const sema::Spec& spec, const RegionOf& region_of) : spec_(spec), region_of_(region_of) {}

  // How far the place is out of what a monitor allows a robot of the kind that may be `within_m` of
  // it; none: it may be there.
  [[nodiscard]] std::optional<double> short_of(sema::MonitorId monitor,
                                               const sema::Site::Place& place, sema::KindId kind,
                                               double within_m) const {
    return short_of({place.position.x, place.position.y}, *spec_[monitor].always,
                    spec_[kind].radius.value.get_d() - within_m);
  }

 private:
  // How far from `p` at least the next place is that has what the property asks for, with `needs_m`
  // of room around it; none: it may be nearer than that room.
  [[nodiscard]] std::optional<double> short_of(const geometry::Point& p, const sema::Expr& always,
                                               double needs_m) const {
    if (const auto* logic = std::get_if<sema::Logic>(&always.node)) {
      return short_of(p, *logic, needs_m);
    }
    const std::optional<Fence> fence = fence_of(always);
    if (!fence || spec_[fence->zone].has_height) return std::nullopt;  // a site has none
    const auto region = region_of_(fence->zone);
    if (!region) return std::nullopt;
    const double clear_m = distance_m(p, *region) * (region->contains(p) ? 1 : -1);
    const double short_m = fence->least_m + needs_m - clear_m;
    return short_m > rounding_m ? std::optional(short_m) : std::nullopt;
  }
  // All operands of `and` are needed, and one of `or`.
  [[nodiscard]] std::optional<double> short_of(const geometry::Point& p, const sema::Logic& logic,
                                               double needs_m) const {
    const bool all = logic.op == sema::LogicOp::logical_and;
    if (!all && logic.op != sema::LogicOp::logical_or) return std::nullopt;
    std::optional<double> found;
    for (const auto& operand : logic.operands) {
      const auto short_m = short_of(p, *operand, needs_m);
      if (!short_m && !all) return std::nullopt;
      if (!short_m) continue;
      found = !found ? *short_m : (all ? std::max(*found, *short_m) : std::min(*found, *short_m));
    }
    return found;
  }

  const sema::Spec& spec_;
  const RegionOf& region_of_;
};

// A robot charges so near to the place: see `charge` in the language reference.
constexpr double charges_within_m = 0.15;

// Sites against the fences of those whose sites they are.
class FencedOut {
 public:
  FencedOut(const sema::Spec& spec, const RegionOf& region_of, diag::Engine& diagnostics)
      : spec_(spec), fences_(spec, region_of), diagnostics_(diagnostics) {}

  void check(sema::SiteId id) {
    const sema::Site& site = spec_[id];
    for (const sema::Site::Place& place : site.places) {
      bool charges = false;
      for (const sema::KindId kind : kinds_for(place)) {
        const auto& energy = spec_[kind].energy;
        if (!energy || energy->charge_at != id) continue;
        charges = true;
        if (is_routed_to(id, kind)) continue;
        if (const auto fence = against(place, kind)) report(site, place, *fence, true);
      }
      if (charges) continue;
      if (const auto fence = against_all(id, place)) report(site, place, *fence, false);
    }
  }

 private:
  // Nobody charges there; it is for whoever gets there.
  [[nodiscard]] std::optional<Barred> against_all(sema::SiteId id,
                                                  const sema::Site::Place& place) const {
    std::optional<Barred> fence;
    for (const sema::KindId kind : kinds_for(place)) {
      fence = is_routed_to(id, kind) ? std::nullopt : against(place, kind);
      if (!fence) return std::nullopt;
    }
    return fence;
  }
  // Those of which there are robots.
  [[nodiscard]] std::vector<sema::KindId> kinds_for(const sema::Site::Place& place) const {
    if (place.robot) return {spec_[*place.robot].kind};
    std::vector<sema::KindId> kinds;
    for (std::uint32_t i = 0; i < spec_.kinds.size(); ++i) {
      const bool has_robots = std::ranges::any_of(
          spec_.robots, [&](const sema::Robot& r) { return r.kind == sema::KindId(i); });
      if (has_robots) kinds.push_back(sema::KindId(i));
    }
    return kinds;
  }
  [[nodiscard]] bool is_routed_to(sema::SiteId site, sema::KindId kind) const {
    return std::any_of(spec_.controllers.begin(), spec_.controllers.end(), [&](const auto& c) {
      const auto route = sema::route_of(c);
      return c.kind == kind && route && route->site == site;
    });
  }
  // The first monitor that never lets a robot of the kind be there.
  [[nodiscard]] std::optional<Barred> against(const sema::Site::Place& place,
                                              sema::KindId kind) const {
    for (const sema::Decision& decision : spec_.decisions) {
      if (decision.kind != kind) continue;
      for (const sema::MonitorId id : decision.priority) {
        if (const auto short_m = fences_.short_of(id, place, kind, charges_within_m)) {
          return Barred{id, *short_m};
        }
      }
    }
    return std::nullopt;
  }
  void report(const sema::Site& site, const sema::Site::Place& place, const Barred& barred,
              bool charges) {
    const sema::Monitor& monitor = spec_[barred.by];
    const std::string use = charges ? ", where `" + spec_[monitor.kind].name + "` charges," : "";
    diagnostics_.report(
        {charges ? diag::Code::charge_behind_fence : diag::Code::site_behind_fence,
         place.range,
         name_of(spec_, site, place) + use + " lies where `" + monitor.name + "` lets none be",
         out_of_reach(barred),
         {{monitor.always_range, "robots are kept in here"}},
         "move it inside, as far as the body needs" +
             std::string(charges ? "" : ", or leave it out"),
         {}});
  }

  const sema::Spec& spec_;
  const Fences fences_;
  diag::Engine& diagnostics_;
};

}  // namespace

std::optional<Barred> barred_on_the_way(const sema::Spec& spec, const RegionOf& region_of,
                                        const sema::Decision& decision, std::size_t k,
                                        const sema::Site::Place& place) {
  const auto& recover = spec[decision.priority[k]].recover;
  const auto route = recover ? sema::route_of(spec[*recover]) : std::nullopt;
  const auto own = route ? region_of(route->zone) : std::nullopt;
  // outside of the zone of its way as well: one mistake
  if (!own || !own->contains({place.position.x, place.position.y})) return std::nullopt;
  const Fences fences(spec, region_of);
  for (std::size_t j = 0; j < k; ++j) {
    const sema::MonitorId by = decision.priority[j];
    // as its own property, what it recovers for leads out of its zone (5016)
    if (spec[by].recover == recover) continue;
    if (const auto m = fences.short_of(by, place, decision.kind, 0)) return Barred{by, *m};
  }
  return std::nullopt;
}

diag::Diagnostic barred_site(const sema::Spec& spec, const Barred& barred,
                             const std::string& recovery, const sema::Site& site,
                             const sema::Site::Place& place) {
  const sema::Monitor& monitor = spec[barred.by];
  return {diag::Code::site_outside_zone,
          place.range,
          name_of(spec, site, place) + ", where `" + recovery + "` leads, lies where `" +
              monitor.name + "` lets none be",
          out_of_reach(barred),
          {{monitor.always_range, "robots are kept in here, before anything else"}},
          "move it inside, as far as the body needs",
          {}};
}

void check_fenced_out_sites(const sema::Spec& spec, const RegionOf& region_of,
                            diag::Engine& diagnostics) {
  FencedOut fenced_out(spec, region_of, diagnostics);
  for (std::uint32_t i = 0; i < spec.sites.size(); ++i) fenced_out.check(sema::SiteId(i));
}

void check_idle_sites(const sema::Spec& spec, const RegionOf& region_of,
                      diag::Engine& diagnostics) {
  for (std::size_t i = 0; i < spec.controllers.size(); ++i) {
    const sema::Controller& controller = spec.controllers[i];
    const auto route = sema::route_of(controller);
    if (!route || is_used(spec, i)) continue;
    if (const auto region = region_of(route->zone)) {
      Checker(spec, diagnostics).route(controller, *route, *region);
    }
  }
}

}  // namespace rtac::analysis
