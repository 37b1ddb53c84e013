// P2b of a recovery that waits for other robots, and makes room for them.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/travel.h"
#include "compiler/geometry/parting.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

// Robots that wait for each other: in which passage they cannot get round one that holds; "": none
// is so narrow.
std::string narrow_passage(const Subject& s, const ir::Recovery& yield) {
  const ir::ZoneTable& zone = s.module[yield.zone];
  // one that holds in the middle, and the other between it and a wall
  const std::int64_t need_mm = yield.pass_gap_mm + yield.route_clearance_mm;
  const std::string wide = "to get round one that holds in its middle takes " + metres(2 * need_mm);
  if (zone.widest_mm < need_mm) {
    return "robots that meet in " + quoted(zone.name) + " cannot get round each other: it is " +
           metres(2 * std::int64_t{zone.widest_mm}) + " wide at most, and " + wide;
  }
  const auto narrow = analysis::passages(zone.cells, s.decision.body.radius_mm, need_mm);
  if (narrow.empty()) return "";
  const analysis::Stranded& worst = narrow.front();
  return "robots that meet near " + place(worst.x_mm, worst.y_mm) + " in " + quoted(zone.name) +
         " cannot get round each other: it is about " + metres(2 * worst.clearance_mm) +
         " wide there, and " + wide;
}

std::string place_of(const geometry::GridPoint& p) {
  return place(p.x_mm, p.y_mm);
}

std::int64_t ahead_us_of(const ir::Monitor& m) {
  return m.lookahead.duration ? m.lookahead.duration_us : 0;
}

// Two robots that hold nearer to each other are not given back, if they are measured as they are.
std::int64_t kept_mm(const ir::Decision& d, const ir::Monitor& m) {
  return analysis::sure_separation_mm(m.property, d.facts.params) +
         analysis::return_clearance_mm(d, ahead_us_of(m)) + d.body.radius_mm;
}

// Between the places that robots hold, and with the room for errors that the runtime leaves
// (Aside): who is given back need not part.
geometry::PartingQuery query_of(const Subject& s, const ir::Monitor& m) {
  const ir::Decision& d = s.decision;
  const auto mm = [](std::int64_t length_mm) {
    constexpr std::int64_t off_grid_mm = 1 << 30;  // farther than any two places of a zone
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(length_mm, 0, off_grid_mm));
  };
  const ir::Recovery& yield = ir::last_step(m.recovery);
  const std::int64_t error_mm = d.body.position_error_mm;
  const ir::Body& body = d.body;
  const std::int64_t back_mm = analysis::given_back_mm(
      d, ahead_us_of(m), analysis::sure_separation_mm(m.property, d.facts.params));
  // the one latches later than the other, which may have moved until then
  const std::int64_t latched_mm = analysis::latched_off_mm(body, d.period_us);
  const std::int64_t moved_mm = body.sway_mm > 0 ? body.sway_mm : latched_mm;
  const std::int64_t reach_mm = analysis::end_reach_mm(s.kind, d.period_us);
  return {.clearance_mm = mm(yield.route_clearance_mm),
          .body_mm = mm(body.radius_mm - latched_mm),
          // in space one may hold straight over the other one
          .nearest_mm = body.in_space ? 0 : mm(2 * body.radius_mm - latched_mm - moved_mm),
          .apart_mm = mm(back_mm),
          .goal_mm = mm(yield.pass_gap_mm + 3 * error_mm + reach_mm + 1),
          .stands_mm = mm(body.radius_mm + error_mm),
          .off_grid = !is_on_grid(s, yield.zone)};
}

// It says nothing but how far from all others a robot keeps, at least.
bool only_apart(const ir::Block& block, ir::ValueId id, const std::vector<ir::Param>& params) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::And>(&op)) {
    return only_apart(block, v->a, params) && only_apart(block, v->b, params);
  }
  if (const auto* each = std::get_if<ir::ForOthers>(&op)) {
    return each->universal && only_apart(*each->body, each->body->result, params);
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr) return false;
  const auto least = ir::lower_bound(block, *compare, params);
  return least && least->leaf.kind == ir::Leaf::Kind::distance;
}

// What asks for a recovery that only stands are inputs and agents, wherever the robot is, or that
// it is too fast, which it is not while that of monitor `k` drives, but where inputs say so: they
// let it go on.
bool stands_while_told(const Subject& s, std::size_t k, std::size_t i) {
  const ir::Monitor& m = s.decision.monitors[i];
  if (m.recovery.kind != ir::RecoveryKind::brake) return false;
  if (m.return_when && m.returns.how == ir::Returns::How::open) return false;
  const bool inputs = std::ranges::all_of(m.property.values, [](const ir::Value& v) {
    const auto* fact = std::get_if<ir::Fact>(&v.op);
    return (fact != nullptr && !fact->of_robot) || std::holds_alternative<ir::And>(v.op) ||
           std::holds_alternative<ir::Or>(v.op) || std::holds_alternative<ir::Not>(v.op);
  });
  if (inputs || asks_agents_only(m.property)) return true;
  return atoms_of(m.property).only_speed() && slow_enough(s, k, i) &&
         control_returns(s, i).status == Status::proved;
}

// Whose recoveries may drive in the place of that of monitor `k`: of those that rank higher, and of
// all where they are coordinated, as the one that drives goes on when `k` engages. `other`: the
// first that makes no room, and tells nobody that it cannot get away. `told`: those that only
// stand, until inputs or agents let them go on.
struct Instead {
  const ir::Monitor* other = nullptr;
  std::string told;
};
Instead drives_instead(const Subject& s, std::size_t k) {
  const ir::Decision& d = s.decision;
  Instead found;
  const std::size_t many = d.coordinated ? d.monitors.size() : k;
  for (std::size_t i = 0; i < many; ++i) {
    const ir::Monitor& m = d.monitors[i];
    if (m.recovery.name == d.monitors[k].recovery.name) continue;
    if (stands_while_told(s, k, i)) {
      found.told += (found.told.empty() ? "" : ", ") + quoted(m.name);
    } else if (found.other == nullptr) {
      found.other = &m;
    }
  }
  return found;
}

// Recoveries of a lower rank that may lead a robot past one that holds; "": there are none.
std::string led_past(const Subject& s, std::size_t k) {
  const std::vector<ir::Monitor>& all = s.decision.monitors;
  std::vector<std::string> led;
  for (std::size_t i = k + 1; i < all.size(); ++i) {
    const ir::Recovery& last = ir::last_step(all[i].recovery);
    const bool own = all[i].recovery.name == all[k].recovery.name;
    if (own || (!ir::moves(last.kind) && !last.claims)) continue;
    const std::string name = quoted(all[i].recovery.name);
    if (std::ranges::find(led, name) == led.end()) led.push_back(name);
  }
  return analysis::joined(led);
}

// "": nothing else than the other one of two robots keeps control from coming back.
std::string more_than_two(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  if (!only_apart(m.property, m.property.result, s.decision.facts.params)) {
    return quoted(m.name) + " asks for more than a distance from all other robots";
  }
  if (s.decision.open_fleet) return "more robots may come";
  if (s.decision.robots != 2) {
    return "of " + std::to_string(s.decision.robots) +
           " robots one may hold in the way of two others";
  }
  return "";
}

// Why of two robots that hold one may find no way, and about where; "": one always does.
struct NoWay {
  std::string why;
  std::optional<Start> stuck{};
};
Start start_of(const geometry::Parting& stuck) {
  return {{stuck.one.x_mm, stuck.one.y_mm}, {{stuck.other.x_mm, stuck.other.y_mm}}};
}
// Where they may be stuck, if they are so near to each other that neither is given back before
// anybody drives.
std::optional<Start> near_start(const Subject& s, const ir::Monitor& m,
                                const geometry::PartingQuery& query) {
  const ir::ZoneTable& zone = s.module[ir::last_step(m.recovery).zone];
  constexpr std::int64_t spare_mm = 10;  // of what is measured as it is, and rounded
  const std::int64_t near_mm = kept_mm(s.decision, m) - spare_mm;
  // it tells where a run may begin, and is not worth much time
  constexpr double pairs_most = 10e6;
  const geometry::CellGrid cells = analysis::grid_of(zone);
  const double around = 1 + 2.0 * static_cast<double>(near_mm) / cells.cell_mm;
  if (static_cast<double>(cells.clearance_mm_lo.size()) * around * around > pairs_most) {
    return std::nullopt;
  }
  geometry::PartingQuery near = query;
  near.apart_mm = static_cast<std::int32_t>(std::max<std::int64_t>(near_mm, 0));
  // where the property holds, and no body sticks out
  const std::int64_t gap_mm = analysis::sure_separation_mm(m.property, s.decision.facts.params) +
                              2 * s.decision.body.radius_mm + spare_mm;
  near.nearest_mm = std::max(near.nearest_mm, static_cast<std::int32_t>(gap_mm));
  near.body_mm = static_cast<std::int32_t>(s.decision.body.radius_mm + spare_mm);
  const auto found = geometry::parting(analysis::edges_of(zone), cells, near);
  return found.how == geometry::Parting::How::stuck ? std::optional(start_of(found)) : std::nullopt;
}
NoWay no_way(const Subject& s, const ir::Monitor& m, const geometry::PartingQuery& query) {
  const ir::Recovery& yield = ir::last_step(m.recovery);
  const ir::ZoneTable& zone = s.module[yield.zone];
  const geometry::CellGrid cells = analysis::grid_of(zone);
  if (query.goal_mm > cells.cell_mm * std::hypot(cells.columns, cells.rows)) {
    return {"no two places of " + quoted(zone.name) + " are " + metres(yield.pass_gap_mm) +
            " apart, as far as a robot that makes way drives from the other one"};
  }
  const geometry::Parting found = geometry::parting(analysis::edges_of(zone), cells, query);
  if (found.how == geometry::Parting::How::too_large) {
    return {quoted(zone.name) + " has too many pairs of cells to look at all of them, and " +
            "that one of two robots finds a way out of the other's is not shown"};
  }
  if (found.how == geometry::Parting::How::stuck) {
    return {"robots that hold near " + place_of(found.one) + " and " + place_of(found.other) +
                " in " + quoted(zone.name) + " may both find no way to a distance of " +
                metres(yield.pass_gap_mm) + " that leads nowhere nearer to the other one",
            start_of(found)};
  }
  return {};
}

// From where a run may show that two wait for each other.
std::vector<Start> starts_of_two(const Subject& s, const ir::Monitor& m,
                                 const geometry::PartingQuery& query, const NoWay& none) {
  const ir::Recovery& yield = ir::last_step(m.recovery);
  if (s.decision.body.in_space) return lock_ups(s, yield, nullptr);
  std::vector<Start> starts;
  if (!none.stuck) return starts;
  if (const auto near = near_start(s, m, query)) starts.push_back(*near);
  starts.push_back(*none.stuck);
  std::ranges::move(lock_ups_beside_walls(s, yield, kept_mm(s.decision, m)),
                    std::back_inserter(starts));
  return starts;
}

bool speaks_of_inputs(const ir::Block& block) {
  return std::ranges::any_of(block.values, [](const ir::Value& v) {
    const auto* fact = std::get_if<ir::Fact>(&v.op);
    const ir::Block* const body = ir::body_of(v.op);
    return (fact != nullptr && !fact->of_robot) || (body != nullptr && speaks_of_inputs(*body));
  });
}
// Whether nothing but places and other robots has the recovery of a monitor drive.
bool waits_by_itself(const ir::Monitor& m) {
  return m.recovery.kind != ir::RecoveryKind::external && !atoms_of(m.property).agent &&
         !speaks_of_inputs(m.property);
}

// One over the other: the first two coordinates are those of the plane.
bool stacked(const Start& start) {
  const std::vector<std::int64_t>& first = start.place_mm;
  const std::vector<std::vector<std::int64_t>>& others = start.others_mm;
  return !others.empty() && std::equal(first.begin(), first.begin() + 2, others[0].begin());
}

// What nothing is known of, but that a run may show robots which wait for each other for ever, from
// one of `starts`.
Obligation unless_locked(const Subject& s, const ir::Recovery& yield, std::vector<Start> starts,
                         Obligation o) {
  if (starts.empty()) return o;
  // whoever drives farther off is in nobody's way (YieldManoeuvre)
  LockUp lock_up{2 * yield.pass_gap_mm + 4 * s.decision.body.position_error_mm};
  for (std::size_t i = 0; i < s.decision.monitors.size(); ++i) {
    if (waits_by_itself(s.decision.monitors[i])) lock_up.waiting.push_back(static_cast<int>(i) + 1);
  }
  lock_up.errors_last = stacked(starts.front());
  o.lock_up = std::move(lock_up);
  o.starts = std::move(starts);
  o.status = Status::refuted;
  o.method = "robots that wait for each other";
  o.by_a_run = true;
  return o;
}
std::string may_lock(const std::vector<Start>& starts) {
  const std::vector<std::int64_t>& first = starts.front().place_mm;
  const std::vector<std::vector<std::int64_t>>& others = starts.front().others_mm;
  if (stacked(starts.front())) {
    return "those that hold at " + place(first[0], first[1]) + ", one over the other, may wait " +
           "for each other for ever, where what they measure stays off";
  }
  return "those that hold at " + place(first[0], first[1]) + " and beside it, at " +
         place(others[0][0], others[0][1]) + ", may wait for each other for ever";
}

// None of its cells is as far from the boundary as ways lead.
bool leads_nowhere(const ir::ZoneTable& zone, const ir::Recovery& yield) {
  return std::ranges::none_of(zone.cells.clearance_mm_lo, [&](std::int32_t clearance_mm) {
    return clearance_mm >= yield.route_clearance_mm;
  });
}

// Of more than two robots, which say `more`.
Obligation of_many(const Subject& s, const ir::Recovery& yield, const std::string& more,
                   Obligation o) {
  std::vector<Start> starts = lock_ups(s, yield, nullptr);
  const std::string narrow = narrow_passage(s, yield);
  o.because = more;
  if (!narrow.empty()) o.because += "; " + narrow;
  if (!starts.empty()) o.because += "; " + may_lock(starts);
  if (narrow.empty() && starts.empty()) {
    o.because += "; " + quoted(s.module[yield.zone].name) +
                 " has no narrow passage, but that robots always find a way round each other is "
                 "not shown";
  }
  return unless_locked(s, yield, std::move(starts), std::move(o));
}

// Where another recovery may drive.
Obligation beside(const Subject& s, const ir::Recovery& yield, const ir::Monitor& other,
                  const std::string& more, const NoWay& none, Obligation o) {
  o.because = "where " + quoted(other.name) + " is engaged as well, " +
              quoted(other.recovery.name) + " may drive, which makes no room for others";
  const std::string& too = more.empty() ? none.why : more;
  if (!more.empty()) o.because += "; " + more;
  // below it, what inputs ask for would be broken instead
  if (too.empty() && !s.decision.coordinated && waits_by_itself(other)) {
    o.repair = quoted(o.monitor) + " ranked above " + quoted(other.name) + "; or " + o.repair;
  }
  std::vector<Start> starts = lock_ups(s, yield, &other);
  if (!starts.empty()) o.because += ": " + may_lock(starts);
  return unless_locked(s, yield, std::move(starts), std::move(o));
}

// How old what is heard of a robot may be, at most, when nothing is lost: what it has measured is
// as old as samples may be, or as one of its periods, when it is told, and is told anew a period
// later.
std::int64_t heard_by_us(const Subject& s) {
  const ir::Body& b = s.decision.body;
  const std::int64_t told_us =
      std::max({s.decision.period_us, b.position_age_us, b.velocity_age_us});
  return told_us + s.decision.period_us;
}

}  // namespace

Obligation makes_room(const Subject& s, std::size_t k, Obligation o) {
  const ir::Recovery& yield = ir::last_step(s.decision.monitors[k].recovery);
  const ir::ZoneTable& zone = s.module[yield.zone];
  o.status = Status::unknown;
  o.method = "no proof";
  o.repair = "`hold when violated \"why\"` accepts that they may wait for each other";
  const geometry::PartingQuery query = query_of(s, s.decision.monitors[k]);
  const std::string more = more_than_two(s, k);
  const NoWay none = more.empty() ? no_way(s, s.decision.monitors[k], query) : NoWay{};
  const auto [other, told] = drives_instead(s, k);
  if (other != nullptr) return beside(s, yield, *other, more, none, std::move(o));
  if (!more.empty()) return of_many(s, yield, more, std::move(o));
  o.because = none.why;
  if (!none.why.empty() && leads_nowhere(zone, yield)) {
    o.because += "; " + quoted(yield.name) + " leads over cells that are " +
                 metres(yield.route_clearance_mm) +
                 " from the boundary, of which there are none in a zone less than about " +
                 metres(2 * yield.route_clearance_mm + 2 * zone.cells.cell_mm) + " wide";
  }
  if (!none.why.empty()) {
    const std::int64_t asked_mm =
        analysis::sure_separation_mm(s.decision.monitors[k].property, s.decision.facts.params);
    o.besides = true;
    if (s.is_read && asked_mm > 1) o.mends = {LessApart{o.monitor, asked_mm}};
    // in a zone that much wider one may pass on either side of the other one
    if (s.is_read) o.mends.emplace_back(RoomToPass{zone.name, yield.pass_gap_mm});
    return unless_locked(s, yield, starts_of_two(s, s.decision.monitors[k], query, none),
                         std::move(o));
  }
  if (const std::int64_t us = heard_by_us(s); s.decision.body.hears_age_us < us) {
    o.because =
        "robots may never know where the other one is: what they hear may be older than `hears` "
        "allows, though nothing is lost";
    o.repair = "`hears other robots max_age " + std::to_string((us + 999) / 1000) + " ms`";
    return o;
  }
  o.status = Status::proved;
  o.method = "ways over cells";
  o.because = "of two robots that hold in " + quoted(zone.name) +
              " too near to each other one always finds a way, nowhere nearer to the other one, " +
              "to a distance of " + metres(yield.pass_gap_mm) +
              "; it is given back, and the other one as soon as nobody drives near it";
  if (const std::string led = led_past(s, k); !led.empty()) {
    o.because += ", as " + led + " may try to";
  }
  if (!told.empty()) o.because += "; both of it where inputs and agents let them go on: " + told;
  o.repair.clear();
  o.claims.push_back(with_cells({"parting",
                                 {{"decision", s.decision.name},
                                  {"monitor", o.monitor},
                                  {"zone", zone.name},
                                  {"route_mm", std::to_string(query.clearance_mm)},
                                  {"extra_us", std::to_string(s.decision.return_extra_us)},
                                  {"apart_mm", std::to_string(query.apart_mm)},
                                  {"gap_mm", std::to_string(yield.pass_gap_mm)}}},
                                zone));
  o.claims.push_back(lemma_claim("return_reached"));
  return o;
}

}  // namespace rtac::verify
