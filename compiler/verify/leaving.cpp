#include "compiler/verify/leaving.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/sides.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/at_worst.h"

namespace rtac::verify {
namespace {

// What tables and exact zones may differ by, on either side.
constexpr std::int64_t grid_mm = 4;

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
    if (!ir::is_along_an_axis(e)) return std::nullopt;
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
  Ways(const Subject& s, const ir::Recovery& recovery, const Box& own)
      : s_(s),
        site_(s.module[recovery.site]),
        cells_(s.module[recovery.zone].cells),
        own_(own),
        route_mm_(recovery.route_clearance_mm),
        half_mm_((cells_.cell_mm + 1) / 2) {}

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
    if (ir::is_along_an_axis(e)) return overlap(in_front_of(e, near_mm), own_);
    return overlap(around(box_of(e), near_mm), own_);
  }
  // Straight ways from anywhere to the site come no nearer to an edge than their ends, if the site
  // is as far in front of its line.
  [[nodiscard]] std::string past(const ir::Edge& e, std::int64_t keeps_mm,
                                 std::int64_t near_mm) const {
    if (!matters(e, near_mm)) return "";
    if (!ir::is_along_an_axis(e)) return text_of(e) + " does not run along the cells of the ways";
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
  // A corner that points into what is left: the site has both of its edges in front of it, and it
  // is so far from the walls that ways from near it are straight.
  [[nodiscard]] std::string corner(const ir::Edge& e, const ir::Edge& next, std::int64_t keeps_mm,
                                   std::int64_t near_mm) const {
    const Box at{e.bx, e.by, e.bx, e.by};
    const bool straight = ir::is_along_an_axis(e) && ir::is_along_an_axis(next);
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
  const ir::SiteTable& site_;
  const ir::Cells& cells_;
  const Box own_;
  const std::int64_t route_mm_, half_mm_;
};

// Whether the centre of the robot surely is in the zone of the ways, by what any monitor says that
// looks ahead, and that nobody may break.
class Stays {
 public:
  Stays(const Subject& s, ir::ZoneIndex own) : s_(s), own_(own) {}
  [[nodiscard]] bool in_zone() const {
    const auto& monitors = s_.decision.monitors;
    return std::any_of(monitors.begin(), monitors.end(), [&](const ir::Monitor& m) {
      const auto& accepted = s_.decision.acknowledgements;
      const bool broken = m.lookahead.too_short || m.lookahead.points_only ||
                          std::any_of(accepted.begin(), accepted.end(),
                                      [&](const auto& a) { return a.monitor == m.name; });
      return !broken && keeps(m.property, m.property.result);
    });
  }

 private:
  [[nodiscard]] bool keeps(const ir::Block& block, ir::ValueId id) const {
    const ir::Op& op = block[id].op;
    if (const auto* both = std::get_if<ir::And>(&op)) {
      return keeps(block, both->a) || keeps(block, both->b);
    }
    if (const auto* either = std::get_if<ir::Or>(&op)) {
      return keeps(block, either->a) && keeps(block, either->b);
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    const auto bound =
        compare ? ir::lower_bound(block, *compare, s_.decision.facts.params) : std::nullopt;
    if (!bound || bound->leaf.kind != ir::Leaf::Kind::clearance) return false;
    const ir::ZoneIndex zone{bound->leaf.table};
    if (s_.module[zone].has_height() || bound->need.strictest < 0) return false;
    return zone == own_ || s_.exact(own_).contains(s_.exact(zone));
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
  if (!Stays(s, way.zone).in_zone()) {
    return "nothing keeps the robot in " + quoted(s.module[way.zone].name) +
           ", the zone of the ways, from outside of which they are not known";
  }
  const Ways ways(s, way, *own);
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
  return with_cells({"leaves",
                     {{"decision", s.decision.name},
                      {"monitor", m.name},
                      {"zone", zone.name},
                      {"starts_mm", text(s.decision.body.radius_mm + m.recovery.leave_least_mm)},
                      {"route_mm", text(m.recovery.route_clearance_mm)},
                      {"leave_us", text(m.recovery.leave_us)}}},
                    zone);
}

}  // namespace rtac::verify
