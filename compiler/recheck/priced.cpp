#include "compiler/recheck/priced.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "compiler/interp/number.h"
#include "compiler/recheck/joining.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/on_grid.h"
#include "compiler/sema/templates.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

struct PricedAround {
  Rational body;    // with less clearance a robot is nowhere
  Rational seen;    // and with less it is seen nowhere
  Rational route;   // of the cells that ways lead over
  Rational within;  // of the site, in x and in y
};

class Prices {
 public:
  Prices(const OnGrid& zone, const PricedAround& limits)
      : edges_(zone.edges),
        grid_(zone.cells),
        body_(limits.body.get_d()),
        route_(limits.route.get_d()),
        within_(limits.within.get_d()),
        joins_{.body = limits.seen.get_d(),
               .route = route_,
               .as_clear_as_here = false,
               .back = route_,
               .reach = nearby() + grid_.cell,
               .rest = {},
               .straight = {},
               .of = {},
               .middles_within = nearby()} {}

  // Of the cells around the site in which a body may be, one whose way takes more charge than there
  // is: it is as clear as ways ask for and does not lead to the site over such cells, or from
  // somewhere in it no leg leads to one nearby that does.
  std::optional<std::size_t> missing(const geometry::Point& site) {
    const double x = site.x.get_d(), y = site.y.get_d();
    joins_.rest = led_to(x, y);
    for (std::size_t at = 0; at < grid_.clearance.size(); ++at) {
      const bool matters = is_around(at, x, y) && is_clear(at) && joins_.rest[at] < 0;
      if (matters) return at;
    }
    joins_.of = [&](std::size_t at) { return is_around(at, x, y) && may_hold_body(at); };
    return joining(edges_, grid_, joins_).apart;
  }

 private:
  // Between the middles of two cells, where the one has a way and the other one joins it.
  [[nodiscard]] double nearby() const {
    constexpr double least_m = 0.4, hair_m = 1e-9;
    return std::max(least_m, 2 * grid_.cell) + hair_m;
  }
  [[nodiscard]] Box box(std::size_t at) const {
    return grid_.box(at % grid_.columns, at / grid_.columns, 1);
  }
  [[nodiscard]] bool is_around(std::size_t at, double x, double y) const {
    return touches(box(at), x, y, within_);
  }
  static bool touches(const Box& b, double x, double y, double off) {
    return b.x <= x + off && b.right >= x - off && b.y <= y + off && b.top >= y - off;
  }
  [[nodiscard]] bool is_clear(std::size_t at) const {
    return grid_.clearance[at] >= route_ - slack_m;
  }
  // No place of a cell is farther from a segment than one of its corners: in whole millimetres,
  // rounded up.
  [[nodiscard]] bool may_hold_body(std::size_t at) const {
    const Box b = box(at);
    double least = 1e300;
    for (const Segment& s : edges_) {
      least = std::min(least, std::max({square_to(s, b.x, b.y), square_to(s, b.right, b.y),
                                        square_to(s, b.x, b.top), square_to(s, b.right, b.top)}));
    }
    return std::ceil((std::sqrt(least) + slack_m) * 1000) >= std::ceil(body_ * 1000 - slack_m);
  }
  // 0 of the cells from which a way leads to the site over such as are clear, -1 of all others.
  [[nodiscard]] std::vector<double> led_to(double x, double y) const {
    std::vector<double> rest(grid_.clearance.size(), -1);
    std::vector<std::size_t> open;
    const auto enter = [&](std::size_t at) {
      if (rest[at] >= 0 || !is_clear(at)) return;
      rest[at] = 0;
      open.push_back(at);
    };
    for (std::size_t at = 0; at < rest.size(); ++at) {
      if (touches(box(at), x, y, slack_m)) enter(at);
    }
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (at % grid_.columns > 0) enter(at - 1);
      if ((at + 1) % grid_.columns > 0) enter(at + 1);
      if (at >= grid_.columns) enter(at - grid_.columns);
      if (at + grid_.columns < rest.size()) enter(at + grid_.columns);
    }
    return rest;
  }

  const std::vector<Segment>& edges_;
  const Grid& grid_;
  const double body_, route_, within_;
  JoiningLimits joins_;
};

// Whether an expression speaks of the charge of the way to a site.
bool asks_for_way(const sema::Expr* e, sema::SiteId site) {
  bool found = false;
  if (e == nullptr) return found;
  sema::for_each_expr(*e, [&](const sema::Expr& part) {
    const auto* const way = std::get_if<sema::EnergyTo>(&part.node);
    found = found || (way != nullptr && way->site == site);
  });
  return found;
}
// How far off its site a robot that rests there is measured, at most: it counts as parked within
// 10 cm, a way ends no nearer than 2 cm or the position error, there errors and pushes that last
// move it, and it is measured as it ends its way and afterwards.
Rational seen_off(const Numbers& n) {
  const Rational parked(1, 10), ends = std::max(Rational(2, 100), n.position_error);
  return std::max(parked, Rational(ends + n.sway + n.position_error)) + n.position_error;
}

std::optional<geometry::Point> without_price(const OnGrid& zone, const PricedAround& limits,
                                             const std::vector<geometry::Point>& sites) {
  Prices prices(zone, limits);
  for (const geometry::Point& site : sites) {
    const auto at = prices.missing(site);
    if (!at) continue;
    const Box b = zone.cells.box(*at % zone.cells.columns, *at / zone.cells.columns, 1);
    const auto between = [](double low, double high) {
      return Rational(std::lround((low + high) / 2 * 1000), 1000);
    };
    return geometry::Point{between(b.x, b.right), between(b.y, b.top)};
  }
  return std::nullopt;
}

}  // namespace

// Until its recovery would act, and where the return condition alone asks for it, at this moment.
std::optional<Doubt> check_priced(const sema::Spec& spec, const sema::Decision& d,
                                  const Claims& claims, const sema::Monitor& m,
                                  const geometry::Region& zone, const Cells& cells,
                                  const Rational& route) {
  const auto way = sema::route_of(spec[*m.recover]);
  if (!way) return std::nullopt;
  const Numbers n = numbers_of(spec, d, jitter_of(spec, d));
  Rational reach;
  if (asks_for_way(m.always.get(), way->site)) {
    // less the error with which it is measured where it rests: `seen_off` has that
    reach = claims.return_clearance(d, m, return_extra(spec, d)) - n.radius - n.position_error;
  } else if (asks_for_way(m.return_when.get(), way->site)) {
    reach = n.position_error + moved_at_rest(n, driven_at_most(n, spec[*m.recover]));
  } else {
    return std::nullopt;
  }
  std::vector<geometry::Point> sites;
  for (const auto& place : spec[way->site].places) {
    if (place.robot && spec[*place.robot].kind != d.kind) continue;
    sites.push_back({place.position.x, place.position.y});
  }
  const std::optional<OnGrid> found = on_grid(zone, cells);
  if (!found) return wrong("the cells are not those of the zone");
  const Rational seen = n.radius - n.position_error - Rational(2, 1000);  // 2 mm: off the grid
  const auto at = without_price(
      *found, {n.radius, std::max(seen, Rational(0)), route, seen_off(n) + reach}, sites);
  if (!at) return std::nullopt;
  return wrong("from (" + to_decimal(at->x) + " m, " + to_decimal(at->y) + " m) beside `" +
               spec[way->site].name + "` no way is known, and no charge is enough for that");
}

}  // namespace rtac::recheck
