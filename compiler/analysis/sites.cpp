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

}  // namespace

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
