#include "compiler/verify/leaving.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/analysis/travel.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/at_worst.h"

namespace rtac::verify {
namespace {

// What tables and exact zones may differ by, on either side.
constexpr std::int64_t grid_mm = 4;

// What a way loses of its clearance as it joins its cells, with some to spare.
constexpr std::int64_t stray_mm = 10;

struct Box {
  std::int64_t left, low, right, top;
};
bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.low < b.top && b.low < a.top;
}
Box around(const Box& box, std::int64_t by_mm) {
  return {box.left - by_mm, box.low - by_mm, box.right + by_mm, box.top + by_mm};
}
Box box_of(const ir::Edge& e) {
  return {std::min(e.ax, e.bx), std::min(e.ay, e.by), std::max(e.ax, e.bx), std::max(e.ay, e.by)};
}
bool is_straight(const ir::Edge& e) {
  return e.ax == e.bx || e.ay == e.by;
}
// Where a place is from the line of an edge, that is along an axis; the zone is where that is more.
std::int64_t off_mm(const ir::Edge& e, std::int64_t x_mm, std::int64_t y_mm) {
  if (e.ax == e.bx) return e.by > e.ay ? e.ax - x_mm : x_mm - e.ax;
  return e.bx > e.ax ? y_mm - e.ay : e.ay - y_mm;
}
// What lies in front of it, up to `deep_mm`.
Box in_front_of(const ir::Edge& e, std::int64_t deep_mm) {
  Box box = box_of(e);
  if (e.ax == e.bx) {
    (e.by > e.ay ? box.left : box.right) += e.by > e.ay ? -deep_mm : deep_mm;
  } else {
    (e.bx > e.ax ? box.top : box.low) += e.bx > e.ax ? deep_mm : -deep_mm;
  }
  return box;
}
// What lies beyond the ends of both edges that meet in `to`, of which the first one ends there: the
// places that have nothing nearer than that corner.
Box beyond(const ir::Edge& first, const ir::Edge& second, std::int64_t deep_mm) {
  Box box{first.bx, first.by, first.bx, first.by};
  const auto push = [&](std::int64_t dx, std::int64_t dy) {
    if (dx > 0) box.right += deep_mm;
    if (dx < 0) box.left -= deep_mm;
    if (dy > 0) box.top += deep_mm;
    if (dy < 0) box.low -= deep_mm;
  };
  push(std::int64_t{first.bx} - first.ax, std::int64_t{first.by} - first.ay);
  push(std::int64_t{second.ax} - second.bx, std::int64_t{second.ay} - second.by);
  return box;
}
bool turns_right(const ir::Edge& a, const ir::Edge& b) {
  return (std::int64_t{a.bx} - a.ax) * (std::int64_t{b.by} - b.ay) <
         (std::int64_t{a.by} - a.ay) * (std::int64_t{b.bx} - b.ax);
}
std::optional<Box> rectangle(const ir::ZoneTable& zone) {
  if (zone.has_height() || zone.edges.size() != 4) return std::nullopt;
  Box all = box_of(zone.edges.front());
  for (const ir::Edge& e : zone.edges) {
    if (!is_straight(e)) return std::nullopt;
    const Box each = box_of(e);
    all = {std::min(all.left, each.left), std::min(all.low, each.low),
           std::max(all.right, each.right), std::max(all.top, each.top)};
  }
  return all;
}

// In a rectangle ways are straight: from a place whose cell is as clear as legs keep to the site,
// and from another one by way of the centre of a cell, which lies between the two, or no further
// than half a cell beside the place, in either direction (runtime/core/grid_route.cpp).
class Ways {
 public:
  // The robot sets out from places that are `starts_mm` from the walls.
  Ways(const Subject& s, const ir::Recovery& recovery, const Box& own, std::int64_t starts_mm)
      : s_(s),
        zone_(s.module[recovery.zone]),
        site_(s.module[recovery.site]),
        cells_(zone_.cells),
        own_(own),
        starts_mm_(starts_mm),
        route_mm_(recovery.route_clearance_mm),
        half_mm_((cells_.cell_mm + 1) / 2),
        beside_mm_(analysis::beside_mm(s.kind, Rational(recovery.speed_mmps, 1000),
                                       s.decision.period_us)) {}

  [[nodiscard]] std::string site_off() const {
    const Box clear = around(own_, -(route_mm_ + cells_.cell_mm + grid_mm));
    for (const ir::SiteTable::Place& p : site_.places) {
      if (p.x_mm >= clear.left && p.x_mm <= clear.right && p.y_mm >= clear.low &&
          p.y_mm <= clear.top) {
        continue;
      }
      return quoted(site_.name) + " is nearer than " +
             metres(route_mm_ + cells_.cell_mm + grid_mm) +
             " to the boundary of the zone of its ways, where they bend";
    }
    return "";
  }
  // Why a way may lead nearer to the boundary of a zone than is asked, or than where it sets out.
  [[nodiscard]] std::string near(const Limit& limit) const {
    const ir::ZoneTable& zone = s_.module[limit.zone];
    if (zone.has_height()) return "ways in space are not followed";
    const std::int64_t asked_mm = s_.decision.body.radius_mm + limit.mm;
    const std::int64_t keeps_mm = std::max(route_mm_, asked_mm);
    const std::int64_t near_mm = keeps_mm + cells_.cell_mm + grid_mm;
    for (const ir::Edge& e : zone.edges) {
      if (std::string why = past(e, keeps_mm, near_mm); !why.empty()) return why;
      if (std::string why = beside(e, asked_mm, keeps_mm, near_mm); !why.empty()) return why;
      for (const ir::Edge& next : zone.edges) {
        if (next.ax != e.bx || next.ay != e.by || !turns_right(e, next)) continue;
        if (std::string why = corner(e, next, keeps_mm, near_mm); !why.empty()) return why;
      }
    }
    return "";
  }

 private:
  static std::string text_of(const ir::Edge& e) {
    return "the boundary from " + place(e.ax, e.ay) + " to " + place(e.bx, e.by);
  }
  [[nodiscard]] bool matters(const ir::Edge& e, std::int64_t near_mm) const {
    if (is_straight(e)) return overlap(in_front_of(e, near_mm), own_);
    return overlap(around(box_of(e), near_mm), own_);
  }
  // Straight ways from anywhere to the site come no nearer to an edge than their ends, if the site
  // is as far in front of its line.
  [[nodiscard]] std::string past(const ir::Edge& e, std::int64_t keeps_mm,
                                 std::int64_t near_mm) const {
    if (!matters(e, near_mm)) return "";
    if (!is_straight(e)) return text_of(e) + " does not run along the cells of the ways";
    return unseen(e, keeps_mm);
  }
  [[nodiscard]] std::string unseen(const ir::Edge& e, std::int64_t keeps_mm) const {
    const std::int64_t need_mm = keeps_mm + half_mm_ + grid_mm;
    for (const ir::SiteTable::Place& p : site_.places) {
      const std::int64_t has_mm = off_mm(e, p.x_mm, p.y_mm);
      if (has_mm >= need_mm) continue;
      return quoted(site_.name) + " is not " + metres(need_mm) + " in front of " + text_of(e) +
             ", so that ways may lead past it, and nearer";
    }
    return "";
  }
  // Beside the walls a way begins with a leg to the centre of a cell, which may lie nearer to an
  // edge by half a cell: a hold may have room for that. Of all cells in reach it is the one with
  // the shortest way in all. It lies no nearer than the place where the robot sets out if the site
  // is farther from there across the edge than along it, as a step across shortens what is left by
  // all of its length then.
  [[nodiscard]] std::string beside(const ir::Edge& e, std::int64_t asked_mm, std::int64_t keeps_mm,
                                   std::int64_t near_mm) const {
    if (!matters(e, near_mm) || !joins_near(e, asked_mm, keeps_mm) || has_room()) return "";
    const std::string leads = "beside the walls of " + quoted(zone_.name) +
                              " ways begin with a leg that may lead nearer to " + text_of(e) + ": ";
    const std::int64_t off_walls_mm = in_reach_from_mm();
    if (starts_mm_ < off_walls_mm) {
      return leads + "a monitor that keeps " + metres(off_walls_mm - s_.decision.body.radius_mm) +
             " off them works";
    }
    for (const ir::SiteTable::Place& p : site_.places) {
      const std::int64_t need_mm = across_mm(e, keeps_mm, p);
      if (off_mm(e, p.x_mm, p.y_mm) >= need_mm) continue;
      return leads + "a site that is " + metres(need_mm) + " in front of that works, beside " +
             place(p.x_mm, p.y_mm);
    }
    return "";
  }
  // Whether a first leg may end near it, nearer than legs keep.
  [[nodiscard]] bool joins_near(const ir::Edge& e, std::int64_t asked_mm,
                                std::int64_t keeps_mm) const {
    const bool upright = e.ax == e.bx;
    const std::int64_t from_mm = upright ? cells_.origin_x_mm : cells_.origin_y_mm;
    const std::int64_t count = upright ? cells_.columns : cells_.rows;
    for (std::int64_t k = 0; k < count; ++k) {
      const std::int64_t at_mm = from_mm + k * cells_.cell_mm;
      if (!may_be_on_a_way(upright, at_mm)) continue;
      const std::int64_t centre_mm = at_mm + cells_.cell_mm / 2;
      const std::int64_t off = upright ? off_mm(e, centre_mm, 0) : off_mm(e, 0, centre_mm);
      if (off >= asked_mm - half_mm_ - grid_mm && off < keeps_mm - grid_mm) return true;
    }
    return false;
  }
  // For half a cell, and for what steering leaves beside a leg: what the look-ahead finds clear
  // around a stop for the hold, which lets no other robots rely on it.
  [[nodiscard]] bool has_room() const {
    sema::RobotKind alone = s_.kind;
    alone.hears_max_age.reset();
    const ir::Decision& d = s_.decision;
    const ir::Body body = analysis::body_of(alone, d.period_us, d.body.jitter_us);
    return body.hold_mm >= half_mm_ + beside_mm_ + stray_mm + grid_mm;
  }
  // How far from the walls a place has to be so that the cells that its way begins with, and those
  // beside them, are in reach of the search.
  [[nodiscard]] std::int64_t in_reach_from_mm() const {
    const std::int64_t cell_mm = cells_.cell_mm;
    const std::int64_t reach_mm = std::max<std::int64_t>(400, 2 * cell_mm) + cell_mm * 4 / 5;
    const double square = double(reach_mm * reach_mm - cell_mm * cell_mm);
    return route_mm_ + cell_mm + half_mm_ + grid_mm -
           static_cast<std::int64_t>(std::floor(std::sqrt(square)));
  }
  // How far in front of an edge a site has to be.
  [[nodiscard]] std::int64_t across_mm(const ir::Edge& e, std::int64_t keeps_mm,
                                       const ir::SiteTable::Place& p) const {
    const bool upright = e.ax == e.bx;
    const std::int64_t at = upright ? p.y_mm : p.x_mm;
    const std::int64_t low = upright ? own_.low : own_.left;
    const std::int64_t high = upright ? own_.top : own_.right;
    const std::int64_t along_mm = std::max(at - low, high - at) - route_mm_;
    return keeps_mm + along_mm + 2 * cells_.cell_mm + 2 * grid_mm;
  }
  [[nodiscard]] bool may_be_on_a_way(bool upright, std::int64_t at_mm) const {
    const std::int64_t low = upright ? own_.left : own_.low, high = upright ? own_.right : own_.top;
    const std::int64_t least_mm = route_mm_ - grid_mm;
    return at_mm >= low + least_mm && at_mm + cells_.cell_mm <= high - least_mm;
  }
  // A corner that points into what is left: the site has both of its edges in front of it, and it
  // is so far from the walls that ways from near it are straight.
  [[nodiscard]] std::string corner(const ir::Edge& e, const ir::Edge& next, std::int64_t keeps_mm,
                                   std::int64_t near_mm) const {
    const Box at{e.bx, e.by, e.bx, e.by};
    const bool straight = is_straight(e) && is_straight(next);
    if (!overlap(straight ? beyond(e, next, near_mm) : around(at, near_mm), own_)) return "";
    if (!straight) return text_of(e) + " does not run along the cells of the ways";
    for (const ir::Edge* each : {&e, &next}) {
      if (std::string why = unseen(*each, keeps_mm); !why.empty()) return why;
    }
    const std::int64_t bend_mm = route_mm_ + cells_.cell_mm + grid_mm;
    const Box clear = around(own_, -bend_mm), open = beyond(e, next, near_mm + half_mm_);
    if (open.left >= clear.left && open.right <= clear.right && open.low >= clear.low &&
        open.top <= clear.top) {
      return "";
    }
    return "places that have nothing nearer than the corner at " + place(e.bx, e.by) +
           " are nearer than " + metres(bend_mm) +
           " to the boundary of the zone of the ways, where they begin with another leg";
  }

  const Subject& s_;
  const ir::ZoneTable& zone_;
  const ir::SiteTable& site_;
  const ir::Cells& cells_;
  const Box own_;
  const std::int64_t starts_mm_, route_mm_, half_mm_, beside_mm_;
};

// How far from the boundary of the zone of the ways the centre of the robot surely is, by what any
// monitor says that looks ahead, and that nobody may break; nullopt: it may be anywhere.
class Starts {
 public:
  Starts(const Subject& s, ir::ZoneIndex own) : s_(s), own_(own) {}
  [[nodiscard]] std::optional<std::int64_t> least_mm() const {
    std::optional<std::int64_t> most;
    for (const ir::Monitor& m : s_.decision.monitors) {
      const auto& accepted = s_.decision.acknowledgements;
      const bool broken = m.lookahead.too_short || m.lookahead.points_only ||
                          std::any_of(accepted.begin(), accepted.end(),
                                      [&](const auto& a) { return a.monitor == m.name; });
      const auto mm = broken ? std::nullopt : kept_mm(m.property, m.property.result);
      if (mm) most = std::max(most.value_or(0), s_.decision.body.radius_mm + *mm);
    }
    return most;
  }

 private:
  [[nodiscard]] std::optional<std::int64_t> kept_mm(const ir::Block& block, ir::ValueId id) const {
    const ir::Op& op = block[id].op;
    if (const auto* both = std::get_if<ir::And>(&op)) {
      const auto a = kept_mm(block, both->a), b = kept_mm(block, both->b);
      return !a ? b : !b ? a : std::optional(std::max(*a, *b));
    }
    if (const auto* either = std::get_if<ir::Or>(&op)) {
      const auto a = kept_mm(block, either->a), b = kept_mm(block, either->b);
      return a && b ? std::optional(std::min(*a, *b)) : std::nullopt;
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    const auto bound =
        compare ? ir::lower_bound(block, *compare, s_.decision.facts.params) : std::nullopt;
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) return std::nullopt;
    const ir::ZoneIndex zone{bound->leaf.table};
    if (s_.module[zone].has_height() || bound->need.strictest < 0) return std::nullopt;
    if (zone != own_ && !s_.exact(own_).contains(s_.exact(zone))) return std::nullopt;
    // a parameter may be less strict now than it may become
    return bound->need.params.empty() ? bound->need.strictest : 0;
  }

  const Subject& s_;
  const ir::ZoneIndex own_;
};

// While a zone is there, a body that leaves it is in another one before it is out of that.
std::string on_a_seam(const Subject& s, const ir::Recovery& way,
                      const std::vector<ir::ZoneIndex>& either) {
  if (either.empty()) return "";
  const geometry::Region& own = s.exact(way.zone);
  geometry::Region all;
  for (const ir::ZoneIndex zone : either) all = all.unite(s.exact(zone));
  const std::int64_t radius_mm = s.decision.body.radius_mm;
  const auto none = analysis::between(own, either, s.exact, radius_mm - analysis::offsets_round_mm,
                                      radius_mm + analysis::offsets_round_mm);
  if (all.contains(own) && none && none->empty()) return "";
  return "on its way " + quoted(way.name) +
         " may lead over a seam of zones, where a body is in none of them";
}

std::string outranked(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  for (std::size_t j = 0; j < k; ++j) {
    const std::string& other = s.decision.monitors[j].recovery.name;
    if (other == m.recovery.name || ir::acknowledged(s.decision, other, m.name)) continue;
    return "while " + quoted(other) + " drives, nobody leads out";
  }
  return "";
}

}  // namespace

std::string doubt_of_leaving(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::Recovery& way = m.recovery;
  if (way.kind != ir::RecoveryKind::route) {
    return quoted(way.name) + " does not lead out of zones that come and go in time";
  }
  if (s.spec.robots.size() > 1) {
    return "ways lead round other robots that are near, or wait for them, whatever comes and goes";
  }
  if (std::string why = outranked(s, k); !why.empty()) return why;
  const auto own = rectangle(s.module[way.zone]);
  if (!own) {
    return "ways are known to be straight in a rectangle along the axes alone, and " +
           quoted(s.module[way.zone].name) + " is none";
  }
  const auto terms = at_worst(s.decision, m.property);
  if (!terms) return "what it says of zones that come and go is more than one limit at a time";
  const auto starts_mm = Starts(s, way.zone).least_mm();
  if (!starts_mm) {
    return "nothing keeps the robot in " + quoted(s.module[way.zone].name) +
           ", the zone of the ways, from outside of which they are not known";
  }
  const Ways ways(s, way, *own, *starts_mm);
  std::string why = ways.site_off();
  for (const Term& term : *terms) {
    if (why.empty()) why = ways.near(term.kept);
    if (why.empty()) why = on_a_seam(s, way, term.either);
  }
  return why;
}

Claim leaves_claim(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::ZoneTable& zone = s.module[m.recovery.zone];
  const auto text = [](std::int64_t n) { return std::to_string(n); };
  return {"leaves",
          {{"decision", s.decision.name},
           {"monitor", m.name},
           {"zone", zone.name},
           {"cell_mm", text(zone.cells.cell_mm)},
           {"cells_x_mm", text(zone.cells.origin_x_mm)},
           {"cells_y_mm", text(zone.cells.origin_y_mm)},
           {"starts_mm", text(s.decision.body.radius_mm + m.recovery.leave_least_mm)},
           {"route_mm", text(m.recovery.route_clearance_mm)},
           {"leave_us", text(m.recovery.leave_us)}}};
}

}  // namespace rtac::verify
