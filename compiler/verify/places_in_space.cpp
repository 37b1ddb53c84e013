// Where robots in space give control back, and how they get there.
#include <algorithm>
#include <limits>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/recoveries_in_space.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/analysis/tables.h"
#include "compiler/geometry/sight.h"
#include "compiler/ir/linear.h"
#include "compiler/sema/visit.h"
#include "compiler/support/words.h"
#include "compiler/verify/at_place.h"
#include "compiler/verify/proofs.h"
#include "compiler/verify/room_for_all.h"

namespace rtac::verify {
namespace {

struct Spot {
  std::int64_t x_mm = 0, y_mm = 0, z_mm = 0;
};
std::string text_of(const Spot& p) {
  return "(" + metres(p.x_mm) + ", " + metres(p.y_mm) + ", " + metres(p.z_mm) + ")";
}
Rational in_m(std::int64_t mm) {
  return Rational(static_cast<long>(mm)) / 1000;
}
// What monitors ask of the height of a centre at rest, from what they say and what their look-ahead
// takes.
struct Band {
  std::int64_t least_mm = std::numeric_limits<std::int32_t>::min();
  std::int64_t most_mm = std::numeric_limits<std::int32_t>::max();
  std::int64_t gap_mm = 0;
  bool asked = false;
  bool beside_others = false;  // some heights are one side of what another side may do for
};
// Of an `or`, or anything else that is no `and`: then nobody has to be at that height.
bool has_height_beside_others(const sema::Expr& e) {
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  if (logic == nullptr) return false;
  if (logic->op != sema::LogicOp::logical_and) return sema::speaks_of_height(e);
  return std::ranges::any_of(logic->operands,
                             [](const auto& each) { return has_height_beside_others(*each); });
}
Band band_of(const Subject& s, std::optional<std::size_t> but = std::nullopt) {
  Band band;
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    const ir::Monitor& m = s.decision.monitors[k];
    if (!s.looks_at_places(k) || k == but) continue;
    band.beside_others = band.beside_others || has_height_beside_others(*s.monitor(k).always);
    const std::int64_t gap = analysis::return_height_mm(s.decision, m.lookahead.duration_us);
    ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      const auto most = ir::upper_bound(block, c);
      if (most && most->leaf.kind == ir::Leaf::Kind::altitude) {
        band.asked = true;
        band.gap_mm = std::max(band.gap_mm, gap);
        band.most_mm = std::min(band.most_mm, most->most - gap);
      }
      const auto least = ir::lower_bound(block, c, s.decision.facts.params);
      if (least && least->leaf.kind == ir::Leaf::Kind::altitude) {
        band.asked = true;
        band.gap_mm = std::max(band.gap_mm, gap);
        band.least_mm = std::max(band.least_mm, least->need.strictest + gap);
      }
    });
  }
  return band;
}

bool is_clear(const geometry::Region& region, const geometry::Point& p, const Rational& gap) {
  return region.contains(p) && square_to(region.rings(), p) >= gap * gap;
}
// Everything within the gap of the place lies in the solid: in each slab that it reaches, which
// follow each other without a gap.
bool is_clear(const geometry::Solid& solid, const Spot& spot, const Rational& gap) {
  const geometry::Point p{in_m(spot.x_mm), in_m(spot.y_mm)};
  const Rational low = in_m(spot.z_mm) - gap, high = in_m(spot.z_mm) + gap;
  Rational up_to = low;
  for (const geometry::Slab& slab : solid.slabs()) {
    if (slab.ceiling <= low || slab.floor >= high) continue;
    if (slab.floor > up_to || !is_clear(slab.region, p, gap)) return false;
    up_to = slab.ceiling;
  }
  return up_to >= high;
}

class Together {
 public:
  Together(const Subject& s, const JointNeeds& joint)
      : s_(s),
        joint_(joint),
        needs_(all_of(joint)),
        band_(band_of(s)),
        charged_(asks_for_charge(s)) {
    keep_to_conditions();
  }

  Obligation run() {
    Obligation o;
    o.kind = Kind::joint_return;
    o.method = "witness";
    if (const auto spot = find()) {
      o.status = Status::proved;
      o.because = "all monitors give control back at " + text_of(*spot);
      for (const Need& need : needs_) {
        o.because += ", " + metres(need.clearance_mm) + " from the boundary of " +
                     quoted(s_.module[need.zone].name);
      }
      for (const Need& need : joint_.zones) {
        o.claims.push_back(place_claim(s_, need.zone, spot->x_mm, spot->y_mm, need.clearance_mm));
        o.claims.back().values["z_mm"] = std::to_string(spot->z_mm);
      }
      for (Claim& claim : returned_claims(s_, spot->x_mm, spot->y_mm, spot->z_mm)) {
        o.claims.push_back(std::move(claim));
      }
      if (o.claims.empty()) {
        o.claims.push_back({"no_fences", {{"decision", s_.decision.name}}});
      }
      if (band_.asked) {
        o.claims.push_back({"height",
                            {{"decision", s_.decision.name},
                             {"z_mm", std::to_string(spot->z_mm)},
                             {"extra_us", std::to_string(s_.decision.return_extra_us)},
                             {"gap_mm", std::to_string(band_.gap_mm)}}});
        if (!s_.told.empty()) o.claims.back().values["but"] = names_of_told(s_);
      }
      if (joint_.zones.empty()) return o;
      return all_at_once(s_, joint_.zones, floor_at(spot->z_mm), std::move(o));
    }
    const bool none = common(3, true).empty() || common(3, false).empty();
    o.status = none && !band_.beside_others ? Status::refuted : Status::unknown;
    if (o.status == Status::unknown) {
      o.because = "a place where all monitors give control back was not found";
      if (band_.beside_others) o.because += " at heights that suit each side of what they say";
      return o;
    }
    if (needs_.empty()) {
      o.because = "at no height all monitors give control back: it would have to be above " +
                  metres(band_.least_mm) + " and below " + metres(band_.most_mm);
      o.repair = "limits of height that are " + metres(band_.least_mm - band_.most_mm) +
                 " further apart, a shorter `ahead` or a lower `speed` are needed";
      return o;
    }
    const auto limit = limit_in_the_way();
    o.because = limit
                    ? "no place that is clear enough of the boundaries is at a height at which all "
                      "monitors give control back"
                    : "no place is so clear of the boundaries that all monitors give control back "
                      "there";
    o.repair = limit.value_or(
        "zones that share more room, a shorter `ahead` or a lower `speed` are needed");
    return o;
  }

 private:
  void keep_to_conditions() {
    band_.least_mm = std::max(band_.least_mm, joint_.low_mm);
    band_.most_mm = std::min(band_.most_mm, joint_.high_mm);
  }
  // How much more one monitor's limit of height has to leave, where without that there is a place.
  [[nodiscard]] std::optional<std::string> limit_in_the_way() const {
    for (std::size_t k = 0; k < s_.decision.monitors.size(); ++k) {
      Together without = *this;
      without.band_ = band_of(s_, k);
      without.keep_to_conditions();
      const geometry::Solid left = without.common(-2, std::nullopt);
      if (left.empty()) continue;
      const std::int64_t low_mm = ceil_to_int(Rational(left.slabs().front().floor * 1000));
      const std::int64_t high_mm = -ceil_to_int(Rational(left.slabs().back().ceiling * -1000));
      const std::int64_t higher_mm = low_mm - band_.most_mm, lower_mm = band_.least_mm - high_mm;
      if (higher_mm <= 0 && lower_mm <= 0) continue;
      return "a limit of height of " + quoted(s_.decision.monitors[k].name) + " that is " +
             (higher_mm > 0 ? metres(higher_mm) + " higher" : metres(lower_mm) + " lower") +
             " is needed";
    }
    return std::nullopt;
  }
  [[nodiscard]] bool is_clear_of(const std::vector<Need>& zones, const Spot& spot) const {
    const geometry::Point p{in_m(spot.x_mm), in_m(spot.y_mm)};
    return std::ranges::all_of(zones, [&](const Need& need) {
      const Rational gap = in_m(need.clearance_mm);
      return s_.module[need.zone].has_height() ? is_clear(s_.solid(need.zone), spot, gap)
                                               : is_clear(s_.exact(need.zone), p, gap);
    });
  }
  [[nodiscard]] bool accepts(const Spot& spot) const {
    return spot.z_mm >= band_.least_mm && spot.z_mm <= band_.most_mm && is_charged(spot) &&
           is_clear_of(needs_, spot);
  }
  [[nodiscard]] bool is_charged(const Spot& spot) const {
    return !charged_ || is_charged_at(s_, {spot.x_mm, spot.y_mm, spot.z_mm}, needs_);
  }
  // Of the height at which one robot is given back.
  [[nodiscard]] Floor floor_at(std::int64_t z_mm) const {
    Floor floor;
    const geometry::Solid left = common(0, true);
    for (const geometry::Slab& slab : left.slabs()) {
      for (const geometry::Ring& ring : slab.region.rings()) {
        floor.corners += ring.size();
        floor.around.push_back(ring);
      }
    }
    floor.has = [this, z_mm](const geometry::Point& p) {
      const Spot spot{in_mm(p.x), in_mm(p.y), z_mm};
      return is_charged(spot) && is_clear_of(joint_.zones, spot);
    };
    floor.z_mm = z_mm;
    return floor;
  }
  [[nodiscard]] std::optional<Spot> find() const {
    const std::vector<Place> sites = charged_ ? charging_places(s_) : std::vector<Place>();
    if (needs_.empty() && band_.least_mm <= band_.most_mm) {
      Spot spot{0, 0, std::clamp<std::int64_t>(0, band_.least_mm, band_.most_mm)};
      if (is_charged(spot)) return spot;
      for (const Place& site : sites) {
        spot.x_mm = site.x_mm, spot.y_mm = site.y_mm;
        if (is_charged(spot)) return spot;
      }
      return std::nullopt;
    }
    for (const Need& need : needs_) {
      const ir::ZoneTable& zone = s_.module[need.zone];
      Spot spot{zone.widest_x_mm, zone.widest_y_mm, zone.has_height() ? zone.widest_z_mm : 0};
      spot.z_mm = std::clamp(spot.z_mm, std::min(band_.least_mm, band_.most_mm), band_.most_mm);
      if (accepts(spot)) return spot;
      for (const Place& site : sites) {
        const Spot there{site.x_mm, site.y_mm, spot.z_mm};
        if (accepts(there)) return there;
      }
    }
    // a corner of what is left; on the grid it is up to 2 mm beside it
    const geometry::Solid left = common(-2, std::nullopt);
    for (const geometry::Slab& slab : left.slabs()) {
      for (const geometry::Ring& ring : slab.region.rings()) {
        for (const geometry::Point& p : ring) {
          const Spot spot{in_mm(p.x), in_mm(p.y), -in_mm(Rational(-slab.floor))};
          if (accepts(spot)) return spot;
        }
      }
    }
    return std::nullopt;
  }
  // The places that are so clear of all zones, `less_mm` less than is asked for; sideways, or up
  // and down, alone: no fewer than there are; both: no more.
  [[nodiscard]] geometry::Solid common(std::int64_t less_mm, std::optional<bool> sideways) const {
    geometry::Solid all = geometry::Solid::everywhere();
    const auto& whole = all.slabs().front();
    all = geometry::Solid::prism(whole.region, std::max(whole.floor, in_m(band_.least_mm)),
                                 std::min(whole.ceiling, in_m(band_.most_mm)));
    for (const Need& need : needs_) {
      const Rational gap = in_m(std::max<std::int64_t>(need.clearance_mm - less_mm, 0));
      const Rational none = 0;
      if (s_.module[need.zone].has_height()) {
        all = all.intersect(s_.solid(need.zone).shrink(sideways.value_or(true) ? gap : none,
                                                       sideways.value_or(false) ? none : gap));
      } else if (sideways.value_or(true)) {
        all = all.intersect(analysis::without_end(s_.exact(need.zone).shrink(gap)));
      }
    }
    return all;
  }

  const Subject& s_;
  const JointNeeds& joint_;
  std::vector<Need> needs_;
  Band band_;
  const bool charged_;  // enough of it is needed for ways that begin there
};

}  // namespace

analysis::ExactSolid any_solid(const Subject& s) {
  return [&s](ir::ZoneIndex zone) {
    return s.module[zone].has_height() ? s.solid(zone) : analysis::without_end(s.exact(zone));
  };
}

bool asks_for_height(const Subject& s, const JointNeeds& needs) {
  return band_of(s).asked || needs.low_mm != JointNeeds().low_mm ||
         needs.high_mm != JointNeeds().high_mm;
}

bool lies_in(const Subject& s, ir::ZoneIndex inner, ir::ZoneIndex outer) {
  const bool high = s.module[inner].has_height(), bounded = s.module[outer].has_height();
  if (!high && !bounded) return s.exact(outer).contains(s.exact(inner));
  if (high && bounded) return s.solid(inner).subtract(s.solid(outer)).empty();
  if (!high) return false;  // it has no end above and below
  const auto& slabs = s.solid(inner).slabs();
  return std::all_of(slabs.begin(), slabs.end(), [&](const geometry::Slab& slab) {
    return s.exact(outer).contains(slab.region);
  });
}

Obligation returns_together_in_space(const Subject& s, const JointNeeds& needs) {
  Obligation o = Together(s, needs).run();
  if (o.status == Status::proved && !needs.open.empty()) {
    o.claims.clear();
    return returns_open(needs, std::move(o));
  }
  if (o.status == Status::refuted && needs.one_of_several) o.status = Status::unknown;
  return o;
}

bool rests_at_height(const Subject& s, const ir::Recovery& last, std::int64_t gap_mm,
                     const ir::Block& block, const ir::AtLeast& limit) {
  if (!ir::moves(last.kind) || !s.module[last.zone].has_height()) return false;
  const auto most = ir::upper_bound(block, limit);
  const auto least = ir::lower_bound(block, limit, s.decision.facts.params);
  const auto& slabs = s.module[last.zone].slabs;
  const std::int64_t low_mm = slabs.front().floor_mm + last.return_clearance_mm;
  const std::int64_t high_mm = slabs.back().ceiling_mm - last.return_clearance_mm;
  return (!most || high_mm + gap_mm <= most->most) &&
         (!least || low_mm - gap_mm >= least->need.strictest);
}

namespace {

// The slabs of the zone that a retreat moves within; of one in the plane a single one without end.
// nullopt: the tables of the module have others.
std::optional<std::vector<geometry::Slab>> slabs_of(const Subject& s, ir::ZoneIndex index) {
  const ir::ZoneTable& zone = s.module[index];
  if (!zone.has_height()) {
    const geometry::Solid tall = analysis::without_end(s.exact(index));
    return tall.slabs();
  }
  const std::vector<geometry::Slab> slabs = s.solid(index).slabs();
  const bool same =
      std::equal(slabs.begin(), slabs.end(), zone.slabs.begin(), zone.slabs.end(),
                 [](const geometry::Slab& a, const ir::ZoneTable::Slab& b) {
                   return a.floor == in_m(b.floor_mm) && a.ceiling == in_m(b.ceiling_mm);
                 });
  if (!same) return std::nullopt;
  return slabs;
}

// The table that a slab of the zone has in the plane.
const ir::ZoneTable& base_of(const Subject& s, const ir::ZoneTable& zone, std::size_t k) {
  return zone.has_height() ? s.module[zone.slabs[k].base] : zone;
}

// A place of a slab with as much clearance, if the slab is high enough.
std::optional<Spot> place_in(const Subject& s, const ir::ZoneTable& zone, std::size_t k,
                             std::int64_t clearance_mm) {
  const bool high = zone.has_height();
  const ir::Cells& cells = base_of(s, zone, k).cells;
  const auto widest = std::max_element(cells.clearance_mm_lo.begin(), cells.clearance_mm_lo.end());
  if (widest == cells.clearance_mm_lo.end() || *widest < clearance_mm) return std::nullopt;
  const auto at = static_cast<std::int64_t>(widest - cells.clearance_mm_lo.begin());
  Spot spot;
  spot.x_mm = cells.origin_x_mm + at % cells.columns * cells.cell_mm + cells.cell_mm / 2;
  spot.y_mm = cells.origin_y_mm + at / cells.columns * cells.cell_mm + cells.cell_mm / 2;
  if (!high) return spot;
  const ir::ZoneTable::Slab& slab = zone.slabs[k];
  // 1 mm: doubles at run time
  if (slab.ceiling_mm - slab.floor_mm < 2 * clearance_mm + 1) return std::nullopt;
  spot.z_mm = (std::int64_t{slab.floor_mm} + slab.ceiling_mm) / 2;
  return spot;
}

// Whether from everywhere in a slab that is not convex the nearest places with room are in sight.
geometry::Sight sight_in(const Subject& s, const ir::ZoneTable& base, const ir::Recovery& last,
                         std::int64_t aim_mm) {
  const ir::Body& body = s.decision.body;
  return geometry::sight(analysis::edges_of(base), analysis::grid_of(base),
                         {.aim_mm = static_cast<std::int32_t>(aim_mm),
                          .clearance_mm = static_cast<std::int32_t>(last.route_clearance_mm),
                          .body_mm = static_cast<std::int32_t>(
                              std::max<std::int64_t>(body.radius_mm - body.position_error_mm, 0))});
}

// From any place of slab `from` straight up or down to slab `to`: through slabs that join, and get
// no narrower on the way, so that the clearance does not fall.
bool leads_straight(const std::vector<geometry::Slab>& slabs, std::size_t from, std::size_t to) {
  for (std::size_t k = from; k != to; k = to > k ? k + 1 : k - 1) {
    const std::size_t next = to > k ? k + 1 : k - 1;
    const auto& [below, above] = std::minmax(k, next);
    if (slabs[below].ceiling != slabs[above].floor) return false;
    if (!slabs[next].region.contains(slabs[k].region)) return false;
  }
  return true;
}

Obligation not_in_sight(const Subject& s, std::size_t k, Obligation o,
                        const std::optional<Spot>& hidden) {
  const ir::Recovery& last = ir::last_step(s.decision.monitors[k].recovery);
  o.status = Status::unknown;
  o.because = "that from everywhere in " + quoted(s.module[last.zone].name) +
              " a leg leads up or down, through what gets no narrower, to where a place to return "
              "is in sight, " +
              metres(last.return_clearance_mm + s.decision.body.end_reach_mm) +
              " from the boundary, is not shown";
  if (!hidden) return o;
  o.because += "; from near " + place(hidden->x_mm, hidden->y_mm) + " it may not be";
  // a run that begins where nothing is in sight may show it, and says so if it does
  auto starts = starts_stranded_in_space(s, k);
  return starts.empty() ? o : shown_from(s, last, std::move(o), std::move(starts));
}

// A place over or below which there is less room than it asks for, in the middle of what lies
// beyond the slabs next to it: where a low gap over an obstacle is. none: a body does not fit.
std::optional<Spot> in_the_gap(const Subject& s, const std::vector<geometry::Slab>& slabs,
                               std::size_t k) {
  geometry::Region beyond = slabs[k].region;
  if (k > 0) beyond = beyond.subtract(slabs[k - 1].region);
  if (k + 1 < slabs.size()) beyond = beyond.subtract(slabs[k + 1].region);
  if (beyond.empty()) return std::nullopt;
  const geometry::Ring outer = beyond.polygons().front().outer;
  geometry::Point low = outer.front(), high = low;
  for (const geometry::Point& p : outer) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const geometry::Point middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const Rational z = (slabs[k].floor + slabs[k].ceiling) / 2;
  const Rational radius = in_m(s.decision.body.radius_mm);
  if (slabs[k].ceiling - slabs[k].floor < 2 * radius || !is_clear(beyond, middle, radius)) {
    return std::nullopt;
  }
  return Spot{in_mm(middle.x), in_mm(middle.y), in_mm(z)};
}

bool is_too_low(const ir::ZoneTable& zone, std::size_t slab, std::int64_t aim_mm) {
  if (!zone.has_height()) return false;
  return zone.slabs[slab].ceiling_mm - zone.slabs[slab].floor_mm <= 2 * aim_mm;
}
// A slab that is too low to give control back in, and from which nothing leads straight up or down
// to another one: a run that begins there may show it, and says so if it does.
Obligation too_low(const Subject& s, const ir::Monitor& m, const std::vector<geometry::Slab>& slabs,
                   std::size_t k, std::int64_t aim_mm, Obligation o) {
  const ir::Recovery& last = ir::last_step(m.recovery);
  const std::int64_t floor_mm = in_mm(slabs[k].floor), ceiling_mm = in_mm(slabs[k].ceiling);
  const std::int64_t high_mm = 2 * aim_mm + 1;
  const std::string between = metres(floor_mm) + " and " + metres(ceiling_mm);
  o.because = "between " + between + " " + quoted(s.module[last.zone].name) + " is " +
              metres(ceiling_mm - floor_mm) + " high, and no leg leads straight up or down from " +
              "all of that to where control is given back, " + metres(aim_mm) +
              " from the boundary";
  o.repair = metres(high_mm) + " between the two would be high enough there";
  const auto spot = in_the_gap(s, slabs, k);
  bool asks = false;  // its own property is what keeps control there
  ir::for_each_comparison(m.property, [&](const ir::Block& block, const ir::AtLeast& c) {
    const auto least = ir::lower_bound(block, c, s.decision.facts.params);
    asks = asks || (least && least->leaf.kind == ir::Leaf::Kind::clearance);
  });
  if (!spot || !asks) return o;
  return shown_from(s, last, std::move(o), {{{spot->x_mm, spot->y_mm, spot->z_mm}}});
}

Claim legs_claim(const Subject& s, const ir::Monitor& m, std::int64_t aim_mm) {
  const ir::Recovery& last = ir::last_step(m.recovery);
  Claim claim = place_claim(s, last.zone, 0, 0, last.return_clearance_mm);
  claim.what = "legs";
  claim.values["aim_mm"] = std::to_string(aim_mm);
  claim.values["monitor"] = m.name;
  return claim;
}

}  // namespace

// RetreatInSpace tries legs up or down, and then level ones to the nearest cells, at a glance
// first. Where a slab is convex, the clearance along a level leg is no less than at its ends, so
// that every cell is in sight; elsewhere `sight` finds out. The heights that it tries include the
// one of that slab that is next to where it comes from; and up to this number of slabs its looks
// are enough for all of them.
Obligation legs_back(const Subject& s, std::size_t k) {
  constexpr std::size_t slabs_max = 6;  // runtime/core/space.cpp, looks_max
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::Recovery& last = ir::last_step(m.recovery);
  Obligation o;
  o.kind = Kind::p2b;
  o.monitor = m.name;
  o.method = "straight legs";
  const auto slabs = slabs_of(s, last.zone);
  std::optional<Spot> hidden;
  if (!ir::goes_back(last.kind) || !slabs || slabs->size() > slabs_max) {
    return not_in_sight(s, k, std::move(o), hidden);
  }
  const ir::ZoneTable& zone = s.module[last.zone];
  // it may come to rest beside where its legs end
  const std::int64_t aim_mm = last.return_clearance_mm + s.decision.body.end_reach_mm;
  Claim claim = legs_claim(s, m, aim_mm);
  bool all_convex = true;
  // the places of the slabs that legs may lead to, once each
  std::vector<std::optional<Spot>> places;
  for (std::size_t to = 0; to < slabs->size(); ++to) {
    places.push_back(place_in(s, zone, to, aim_mm));
    if (!places[to] || analysis::is_convex((*slabs)[to].region)) continue;
    const ir::ZoneTable& base = base_of(s, zone, to);
    const geometry::Sight found = sight_in(s, base, last, aim_mm);
    if (found.how != geometry::Sight::How::clear) places[to].reset();
    if (found.how == geometry::Sight::How::hidden) {
      hidden = Spot{found.place.x_mm, found.place.y_mm, 0};
    }
    all_convex = false;
    const std::string of = "_of_" + std::to_string(to);
    claim = with_cells(std::move(claim), base, of);
    claim.values["route_mm"] = std::to_string(last.route_clearance_mm);
  }
  for (std::size_t from = 0; from < slabs->size(); ++from) {
    std::optional<Spot> place;
    for (std::size_t to = 0; to < slabs->size() && !place; ++to) {
      if (!places[to] || !leads_straight(*slabs, from, to)) continue;
      place = places[to];
      claim.values["to_" + std::to_string(from)] = std::to_string(to);
    }
    if (!place && is_too_low(zone, from, aim_mm)) {
      return too_low(s, m, *slabs, from, aim_mm, std::move(o));
    }
    if (!place) return not_in_sight(s, k, std::move(o), hidden);
    const std::string of = "_" + std::to_string(from);
    claim.values["x_mm" + of] = std::to_string(place->x_mm);
    claim.values["y_mm" + of] = std::to_string(place->y_mm);
    if (zone.has_height()) claim.values["z_mm" + of] = std::to_string(place->z_mm);
  }
  claim.values.erase("x_mm");
  claim.values.erase("y_mm");
  o.status = Status::proved;
  const std::string where = all_convex ? "to a convex prism" : "to where room is in sight";
  o.because = slabs->size() > 1 ? "from everywhere in " + quoted(zone.name) +
                                      " a leg leads up or down, through what gets no narrower, " +
                                      where + ", and another one to a clearance of "
              : all_convex ? quoted(zone.name) +
                                 " is convex: from everywhere in it a leg leads straight to a "
                                 "clearance of "
                           : "from everywhere in " + quoted(zone.name) +
                                 " the nearest places with room are in sight: a leg leads "
                                 "straight to a clearance of ";
  o.because += metres(aim_mm);
  if (const auto bound = analysis::return_seconds(s.kind, s.module, s.decision, m.recovery)) {
    o.because += ", within " + seconds(*bound) + " in all";
  }
  o.claims.push_back(std::move(claim));
  return o;
}

}  // namespace rtac::verify
