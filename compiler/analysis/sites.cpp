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

class Checker {
 public:
  Checker(const sema::Spec& spec, diag::Engine& diagnostics)
      : spec_(spec), diagnostics_(diagnostics) {}

  void route(const sema::Controller& controller, const sema::Route& route,
             const geometry::Region& region) {
    const sema::Site& site = spec_[route.site];
    for (const sema::Site::Place& place : site.places) {
      if (place.robot && spec_[*place.robot].kind != controller.kind) continue;
      const std::string what =
          "`" + site.name + (place.robot ? "(" + spec_[*place.robot].name + ")`" : "`");
      check(place, what, spec_[route.zone].name, region, spec_[controller.kind].radius.value);
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

// The zones that a robot is in wherever the property holds.
void collect_fences(const sema::Expr& e, std::vector<sema::ZoneId>& fences) {
  if (const auto* logic = std::get_if<sema::Logic>(&e.node)) {
    if (logic->op != sema::LogicOp::logical_and) return;
    for (const auto& operand : logic->operands) collect_fences(*operand, fences);
  } else if (const auto* inside = std::get_if<sema::InsideZone>(&e.node)) {
    fences.push_back(inside->zone);
  } else if (const auto* compare = std::get_if<sema::Compare>(&e.node)) {
    const auto* clearance = std::get_if<sema::Clearance>(&compare->left->node);
    const auto* least = std::get_if<sema::Constant>(&compare->right->node);
    const bool keeps =
        compare->op == sema::CompareOp::greater_equal || compare->op == sema::CompareOp::greater;
    if (keeps && clearance != nullptr && least != nullptr && least->value >= 0) {
      fences.push_back(clearance->zone);
    }
  }
}

// A robot charges so near to the place: see `charge` in the language reference.
constexpr double charges_within_m = 0.15;

// The places at which robots of a kind charge and no controller of theirs ends.
class ChargingPlaces {
 public:
  ChargingPlaces(const sema::Spec& spec, const RegionOf& region_of, diag::Engine& diagnostics)
      : spec_(spec), region_of_(region_of), diagnostics_(diagnostics) {}

  void check(sema::KindId kind) {
    const auto& energy = spec_[kind].energy;
    if (!energy || is_routed_to(energy->charge_at, kind)) return;
    const sema::Site& site = spec_[energy->charge_at];
    for (const sema::Site::Place& place : site.places) {
      if (place.robot && spec_[*place.robot].kind != kind) continue;
      const auto fence = against({place.position.x, place.position.y}, kind);
      if (fence) warn(site, place, spec_[*fence]);
    }
  }

 private:
  [[nodiscard]] bool is_routed_to(sema::SiteId site, sema::KindId kind) const {
    return std::any_of(spec_.controllers.begin(), spec_.controllers.end(), [&](const auto& c) {
      const auto route = sema::route_of(c);
      return c.kind == kind && route && route->site == site;
    });
  }
  // The first monitor that never lets a robot of the kind be there.
  [[nodiscard]] std::optional<sema::MonitorId> against(const geometry::Point& p,
                                                       sema::KindId kind) const {
    for (const sema::Decision& decision : spec_.decisions) {
      if (decision.kind != kind) continue;
      for (const sema::MonitorId id : decision.priority) {
        if (is_outside(p, *spec_[id].always)) return id;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] bool is_outside(const geometry::Point& p, const sema::Expr& always) const {
    std::vector<sema::ZoneId> fences;
    collect_fences(always, fences);
    return std::any_of(fences.begin(), fences.end(), [&](sema::ZoneId zone) {
      if (spec_[zone].has_height) return false;  // a site has none
      const auto region = region_of_(zone);
      return region && !region->contains(p) && distance_m(p, *region) > charges_within_m;
    });
  }
  void warn(const sema::Site& site, const sema::Site::Place& place, const sema::Monitor& monitor) {
    const std::string robot = place.robot ? "(" + spec_[*place.robot].name + ")" : "";
    const std::string& kind = spec_[monitor.kind].name;
    diagnostics_.report({diag::Code::charge_behind_fence,
                         place.range,
                         "`" + site.name + robot + "`, where `" + kind + "` charges, lies where `" +
                             monitor.name + "` lets none be",
                         "out of reach",
                         {{monitor.always_range, "robots are kept in here"}},
                         "move it inside, as far as the body needs",
                         {}});
  }

  const sema::Spec& spec_;
  const RegionOf& region_of_;
  diag::Engine& diagnostics_;
};

}  // namespace

void check_charging_sites(const sema::Spec& spec, const RegionOf& region_of,
                          diag::Engine& diagnostics) {
  ChargingPlaces places(spec, region_of, diagnostics);
  for (std::size_t i = 0; i < spec.kinds.size(); ++i) places.check(sema::KindId(i));
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
