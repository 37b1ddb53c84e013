#include "compiler/recheck/leaving.h"

#include <algorithm>
#include <variant>

#include "compiler/recheck/at_worst.h"
#include "compiler/recheck/sides.h"
#include "compiler/recheck/travel.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {
namespace {

using geometry::Point;

// What robots know of a zone may be off by, with the clearances of its cells.
const Rational table(4, 1000);

struct Rectangle {
  Rational left, low, right, top;
};
std::optional<Rectangle> rectangle(const geometry::Region& zone) {
  const auto rings = zone.rings();
  if (rings.size() != 1 || rings.front().size() != 4) return std::nullopt;
  const geometry::Ring& ring = rings.front();
  Rectangle all{ring[0].x, ring[0].y, ring[0].x, ring[0].y};
  for (std::size_t i = 0; i < 4; ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % 4];
    if (a.x != b.x && a.y != b.y) return std::nullopt;
    all.left = std::min(all.left, a.x), all.right = std::max(all.right, a.x);
    all.low = std::min(all.low, a.y), all.top = std::max(all.top, a.y);
  }
  return all;
}

Rational dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
Point minus(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
// What is left of a convex ring where (p - from) * along is `least` at least.
geometry::Ring clipped(const geometry::Ring& ring, const Point& from, const Point& along,
                       const Rational& least) {
  geometry::Ring left;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const Rational at_a = dot(minus(a, from), along) - least;
    const Rational at_b = dot(minus(b, from), along) - least;
    if (at_a >= 0) left.push_back(a);
    if ((at_a >= 0) == (at_b >= 0)) continue;
    const Rational part = at_a / (at_a - at_b);
    left.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
  }
  return left;
}
bool has_area(const geometry::Ring& ring) {
  Rational twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice != 0;
}
Rational size_above(const Point& p) {
  return abs(p.x) + abs(p.y);
}
Point turned(const Point& p) {
  return {-p.y, p.x};
}
Point back(const Point& p) {
  return {-p.x, -p.y};
}

// The ways of a route within a rectangle. From a place whose cell is as clear as its legs keep they
// go straight to the site; from another one first to the centre of a cell, which in either
// direction lies between the two, or no further than half a cell beside the place.
class Ways {
 public:
  Ways(Rectangle own, const Cells& cells, Rational route, std::vector<Point> sites)
      : own_(std::move(own)),
        cells_(cells),
        cell_(milli(cells.cell_mm)),
        route_(std::move(route)),
        sites_(std::move(sites)),
        ring_({{own_.left, own_.low},
               {own_.right, own_.low},
               {own_.right, own_.top},
               {own_.left, own_.top}}) {}

  [[nodiscard]] bool are_its_cells() const {
    const auto is = [](std::int64_t mm, const Rational& m) {
      return abs(Rational(milli(mm) - m)) <= Rational(3, 1000);
    };
    return is(cells_.x_mm, own_.left) && is(cells_.y_mm, own_.low) && is_their_width();
  }
  // Every site is so far from the walls that a way ends with a straight leg.
  [[nodiscard]] bool end_straight() const { return all_sites_off(route_ + cell_); }
  // So far the first leg leads from a place that is `starts` from the walls; nullopt: it may know
  // no way.
  [[nodiscard]] std::optional<Rational> joins(const Rational& starts) const {
    const Rational reach = this->reach();
    const Rational x = deepest(true) - starts, y = deepest(false) - starts;
    if (x < 0 || y < 0) return reach;
    if (!has_cells(true) || !has_cells(false) || x * x + y * y > reach * reach) return std::nullopt;
    return reach;
  }
  // The way to a site from wherever the robot is, without the leg that joins it to the cells.
  [[nodiscard]] Rational farthest() const {
    Rational most = 0;
    for (const Point& site : sites_) {
      const Rational x = std::max(Rational(site.x - own_.left), Rational(own_.right - site.x));
      const Rational y = std::max(Rational(site.y - own_.low), Rational(own_.top - site.y));
      most = std::max(most, interp::square_root(x * x + y * y).above);
    }
    return most;
  }
  // Why a way may lead nearer to the boundary of a zone than `asked`, and than legs keep off walls.
  // By what its first leg may, which leads to the centre of a cell, the look-ahead asks for more.
  [[nodiscard]] std::optional<std::string> near(const geometry::Region& zone,
                                                const Rational& asked) const {
    const Rational keeps = std::max(route_, asked);
    for (const geometry::Ring& ring : zone.rings()) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()],
                    &c = ring[(i + 2) % ring.size()];
        if (lies_before(a, b, keeps) && !passes(a, b, keeps)) return "the site does not see it";
        if (lies_round(a, b, c, keeps) && !goes_round(a, b, c, keeps)) {
          return "a way may pass a corner";
        }
      }
    }
    return std::nullopt;
  }

 private:
  // The least whole centimetres, 10 cm at least, of which there are not too many; a table may be
  // off by `table`.
  [[nodiscard]] bool is_their_width() const {
    const Rational step(1, 100), most = 40'000;
    const auto count = [&](const Rational& cell, const Rational& more) {
      const auto along = [&](const Rational& length) {
        return Rational(static_cast<long>(ceil_to_int(Rational((length + more) / cell))));
      };
      return Rational(along(own_.right - own_.left) * along(own_.top - own_.low));
    };
    if (cells_.cell_mm % 10 != 0 || cells_.cell_mm < 100 || count(cell_, -table) > most) {
      return false;
    }
    return cells_.cell_mm == 100 || count(cell_ - step, table) > most;
  }
  // Of the centres of cells that a way may begin with (runtime/core/grid_route.cpp).
  [[nodiscard]] Rational reach() const {
    return std::max(Rational(2, 5), Rational(2 * cell_)) + cell_ * 4 / 5;
  }
  [[nodiscard]] bool all_sites_off(const Rational& by) const {
    return std::ranges::all_of(sites_, [&](const Point& p) {
      return p.x - own_.left >= by && own_.right - p.x >= by && p.y - own_.low >= by &&
             own_.top - p.y >= by;
    });
  }
  // Where cells begin, of columns or rows.
  template <class Visit>
  void for_each_centre(bool column, const Rational& clear, const Visit& visit) const {
    const Rational &low = column ? own_.left : own_.low, &high = column ? own_.right : own_.top;
    for (Rational at = milli(column ? cells_.x_mm : cells_.y_mm); at < high; at += cell_) {
      if (at - low < clear || high - at - cell_ < clear) continue;
      visit(Rational(at + cell_ / 2));
    }
  }
  [[nodiscard]] bool has_cells(bool column) const {
    bool any = false;
    for_each_centre(column, route_, [&](const Rational&) { any = true; });
    return any;
  }
  // From either wall to the centre of the first cell that legs keep to.
  [[nodiscard]] Rational deepest(bool column) const {
    const Rational &low = column ? own_.left : own_.low, &high = column ? own_.right : own_.top;
    std::optional<Rational> first, last;
    for_each_centre(column, route_, [&](const Rational& at) {
      if (!first) first = at;
      last = at;
    });
    return first ? std::max(Rational(*first - low), Rational(high - *last)) : high - low;
  }
  // Places of the rectangle have nothing nearer than this edge, and are near it.
  [[nodiscard]] bool lies_before(const Point& a, const Point& b, const Rational& keeps) const {
    const Point along = minus(b, a), across = turned(along);
    geometry::Ring left = clipped(ring_, a, across, 0);
    left = clipped(left, a, along, 0);
    left = clipped(left, b, back(along), 0);
    left = clipped(left, a, back(across), -(keeps + cell_) * size_above(along));
    return has_area(left);
  }
  [[nodiscard]] bool lies_round(const Point& a, const Point& b, const Point& c,
                                const Rational& keeps) const {
    const Point first = minus(b, a), second = minus(c, b);
    if (dot(turned(first), second) >= 0) return false;  // it points outwards
    geometry::Ring left = clipped(ring_, b, first, 0);
    left = clipped(left, b, back(second), 0);
    for (const Point& to : {Point{1, 0}, Point{-1, 0}, Point{0, 1}, Point{0, -1}}) {
      left = clipped(left, b, to, -(keeps + cell_));
    }
    return has_area(left);
  }
  static bool runs_along(const Point& a, const Point& b) { return a.x == b.x || a.y == b.y; }
  // In front of the line of an edge along an axis.
  static Rational in_front(const Point& a, const Point& b, const Point& p) {
    return dot(turned(minus(b, a)), minus(p, a)) / size_above(minus(b, a));
  }
  [[nodiscard]] bool passes(const Point& a, const Point& b, const Rational& keeps) const {
    if (!runs_along(a, b)) return false;
    return std::ranges::all_of(
        sites_, [&](const Point& p) { return in_front(a, b, p) >= keeps + cell_ / 2; });
  }
  // What is near the corner is so far from the walls that ways from there are straight.
  [[nodiscard]] bool goes_round(const Point& a, const Point& b, const Point& c,
                                const Rational& keeps) const {
    if (!passes(a, b, keeps) || !passes(b, c, keeps)) return false;
    Rectangle open{b.x, b.y, b.x, b.y};
    for (const Point& to : {minus(b, a), minus(b, c)}) {
      const Rational by = (keeps + cell_ * 3 / 2) / size_above(to);
      (to.x < 0 ? open.left : open.right) += by * to.x;
      (to.y < 0 ? open.low : open.top) += by * to.y;
    }
    const Rational bend = route_ + cell_;
    return open.left - own_.left >= bend && own_.right - open.right >= bend &&
           open.low - own_.low >= bend && own_.top - open.top >= bend;
  }

  const Rectangle own_;
  const Cells cells_;
  const Rational cell_, route_;
  const std::vector<Point> sites_;
  const geometry::Ring ring_;
};

// A recovery that outranks it, unless that is accepted, or other robots that it waits for.
std::optional<Doubt> is_free(const sema::Spec& spec, const sema::Decision& d,
                             const sema::Monitor& monitor) {
  if (spec.robots.size() > 1) return wrong("it leads round other robots, or waits for them");
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (&m == &monitor) break;
    if (m.recover == monitor.recover) continue;
    const bool accepted = std::ranges::any_of(d.acknowledgements, [&](const auto& a) {
      return m.recover && a.recovery == *m.recover && &spec[a.monitor] == &monitor;
    });
    if (!accepted) return wrong("while the recovery of `" + m.name + "` drives, nobody leads out");
  }
  return std::nullopt;
}

// Whether the centre of a robot surely is in a zone of the plane, wherever something holds.
bool keeps_in(const sema::Spec& spec, Claims& claims, const sema::Expr& e, sema::ZoneId own) {
  if (const auto* logic = std::get_if<sema::Logic>(&e.node)) {
    const auto keeps = [&](const sema::ExprPtr& each) {
      return keeps_in(spec, claims, *each, own);
    };
    if (logic->op == sema::LogicOp::logical_and) {
      return std::ranges::any_of(logic->operands, keeps);
    }
    return logic->op == sema::LogicOp::logical_or && std::ranges::all_of(logic->operands, keeps);
  }
  const auto zones = kept_in(spec, e);
  if (zones.size() != 1) return false;
  const geometry::Region* const in = claims.zones().region(zones.front());
  const geometry::Region* const out = claims.zones().region(own);
  return in != nullptr && out != nullptr && out->contains(*in);
}
// By what any monitor says that looks ahead, and that nobody may break.
bool stays_in(const sema::Spec& spec, const sema::Decision& d, Claims& claims, sema::ZoneId own) {
  return std::ranges::any_of(d.priority, [&](sema::MonitorId id) {
    const sema::Ahead& ahead = spec[id].ahead;
    const bool looks = !ahead.waypoints_only && !is_unsound(ahead);
    const bool broken = !looks || std::ranges::any_of(d.acknowledgements, [&](const auto& a) {
      return a.monitor == id;
    });
    return !broken && keeps_in(spec, claims, *spec[id].always, own);
  });
}

// What is asked with all zones at their worst is kept on every way.
std::optional<Doubt> keeps_off(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                               const sema::Monitor& monitor, const Ways& ways, sema::ZoneId moves) {
  const std::vector<const sema::Expr*> parts = parts_of(*monitor.always);
  if (parts.empty()) return wrong("its property speaks of no zone that comes and goes");
  for (const sema::Expr* part : parts) {
    const AtWorst worst = at_worst(spec, *part);
    if (worst.kind == AtWorst::Kind::holds) continue;
    if (worst.kind != AtWorst::Kind::limit) return wrong("it asks for more than one limit at once");
    const geometry::Region* const zone = claims.zones().region(worst.limit->zone);
    if (zone == nullptr) return Doubt{false, "a zone is not known"};
    const Rational asked = spec[d.kind].radius.value + worst.limit->gap;
    if (const auto why = ways.near(*zone, asked)) {
      return wrong("of `" + claims.zones().name(worst.limit->zone) + "`: " + *why);
    }
    if (!waits_for_gates(*part)) continue;
    const auto zones = gates_of(spec, *part);
    if (!zones || !Sides(spec, d, claims).in_one_of(moves, *zones)) {
      return wrong("on its way a body may be in none of its zones");
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Doubt> check_leaving(const sema::Spec& spec, const sema::Decision& decision,
                                   Claims& claims, const sema::Monitor& monitor, const Values& v) {
  const sema::RobotKind& kind = spec[decision.kind];
  const auto zone = claims.zones().find(text(v, "zone"));
  const auto cell = number(v, "cell_mm"), x = number(v, "cells_x_mm"), y = number(v, "cells_y_mm");
  const auto starts = number(v, "starts_mm"), route = number(v, "route_mm");
  const auto leave_us = number(v, "leave_us");
  if (!zone || !cell || *cell <= 0 || !x || !y || !starts || !route || !leave_us) {
    return wrong("a number is missing");
  }
  const sema::Controller& recovery = spec[*monitor.recover];
  const auto* way = std::get_if<sema::Route>(&recovery.implementation);
  if (way == nullptr || way->zone != *zone) return wrong("its recovery is no way within that zone");
  if (milli(*route) < claims.leg_clearance(decision, monitor, *zone)) return wrong(too_near);
  if (milli(*starts) < kind.radius.value) {
    return wrong("where it sets out leaves no room for the body");
  }
  if (auto doubt = is_free(spec, decision, monitor)) return doubt;

  const geometry::Region* const region = claims.zones().region(*zone);
  const auto own = region != nullptr ? rectangle(*region) : std::nullopt;
  if (!own) return wrong("the zone of the ways is no rectangle along the axes");
  std::vector<Point> sites;
  for (const auto& place : spec[way->site].places) {
    sites.push_back({place.position.x, place.position.y});
  }
  if (!stays_in(spec, decision, claims, *zone))
    return wrong("nothing keeps the robot in the zone of the ways");
  const Ways ways(*own, {*cell, *x, *y}, milli(*route), sites);
  if (!ways.are_its_cells()) return wrong("the cells are not those of the zone");
  if (!ways.end_straight()) return wrong("the site is too near to the boundary of the zone");
  if (auto doubt = keeps_off(spec, decision, claims, monitor, ways, *zone)) return doubt;

  const auto joins = ways.joins(milli(*starts));
  if (!joins) return wrong("from some places it may know no way");
  const auto seconds = leaving_seconds(kind, decision, recovery, ways.farthest() + 2 * *joins);
  if (!seconds || *seconds > micro(*leave_us)) return wrong("it may take longer to lead out");
  return std::nullopt;
}

}  // namespace rtac::recheck
