// Where robots in space give control back, and how they get there.
#include <algorithm>
#include <limits>

#include "compiler/analysis/limits.h"
#include "compiler/analysis/recovery_places.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"
#include "compiler/verify/proofs.h"

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
};
Band band_of(const Subject& s) {
  Band band;
  for (const ir::Monitor& m : s.decision.monitors) {
    if (!m.lookahead.duration) continue;
    const std::int64_t gap = analysis::return_clearance_mm(s.decision, m.lookahead.duration_us);
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
        band.least_mm = std::max(band.least_mm, least->need.fixed + gap);
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
  Together(const Subject& s, std::vector<Need> needs)
      : s_(s), needs_(std::move(needs)), band_(band_of(s)) {}

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
        o.claims.push_back(place_claim(s_, need.zone, spot->x_mm, spot->y_mm, need.clearance_mm));
        o.claims.back().values["z_mm"] = std::to_string(spot->z_mm);
      }
      if (band_.asked) {
        o.claims.push_back({"height",
                            {{"decision", s_.decision.name},
                             {"z_mm", std::to_string(spot->z_mm)},
                             {"extra_us", std::to_string(s_.decision.return_extra_us)},
                             {"gap_mm", std::to_string(band_.gap_mm)}}});
      }
      return o;
    }
    o.status =
        common(3, true).empty() || common(3, false).empty() ? Status::refuted : Status::unknown;
    if (o.status == Status::unknown) {
      o.because = "a place where all monitors give control back was not found";
      return o;
    }
    o.because = "no place is so clear of the boundaries that all monitors give control back there";
    o.repair = "zones that share more room, a shorter `ahead` or a lower `speed` work";
    return o;
  }

 private:
  [[nodiscard]] bool accepts(const Spot& spot) const {
    const geometry::Point p{in_m(spot.x_mm), in_m(spot.y_mm)};
    return spot.z_mm >= band_.least_mm && spot.z_mm <= band_.most_mm &&
           std::all_of(needs_.begin(), needs_.end(), [&](const Need& need) {
             const Rational gap = in_m(need.clearance_mm);
             return s_.module[need.zone].has_height() ? is_clear(s_.solid(need.zone), spot, gap)
                                                      : is_clear(s_.exact(need.zone), p, gap);
           });
  }
  [[nodiscard]] std::optional<Spot> find() const {
    for (const Need& need : needs_) {
      const ir::ZoneTable& zone = s_.module[need.zone];
      Spot spot{zone.widest_x_mm, zone.widest_y_mm, zone.has_height() ? zone.widest_z_mm : 0};
      spot.z_mm = std::clamp(spot.z_mm, std::min(band_.least_mm, band_.most_mm), band_.most_mm);
      if (accepts(spot)) return spot;
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
        const auto& reach = geometry::Solid::everywhere().slabs().front();
        all = all.intersect(
            geometry::Solid::prism(s_.exact(need.zone).shrink(gap), reach.floor, reach.ceiling));
      }
    }
    return all;
  }

  const Subject& s_;
  std::vector<Need> needs_;
  Band band_;
};

}  // namespace

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

Obligation returns_together_in_space(const Subject& s) {
  return Together(s, needs_of(s)).run();
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

// The look of a retreat in space (rtac/safe/space.h) goes to the nearest cell that is clear enough,
// straight, on a height that is. In a convex zone the clearance along a leg is no less than at its
// ends, so that every such cell is in sight from everywhere.
Obligation legs_back(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::Recovery& last = ir::last_step(m.recovery);
  const ir::ZoneTable& zone = s.module[last.zone];
  Obligation o;
  o.kind = Kind::p2b;
  o.monitor = m.name;
  o.method = "straight legs";
  const bool one = zone.slabs.size() <= 1;
  const ir::ZoneTable& flat = zone.has_height() ? s.module[zone.slabs.front().base] : zone;
  const auto& cells = flat.cells.clearance_mm_lo;
  const bool has_cell = std::any_of(cells.begin(), cells.end(),
                                    [&](auto mm) { return mm >= last.return_clearance_mm; });
  const bool convex =
      one && analysis::is_convex(zone.has_height() ? s.solid(last.zone).slabs().front().region
                                                   : s.exact(last.zone));
  if (!convex || !has_cell || last.kind != ir::RecoveryKind::retreat ||
      zone.widest_mm < last.return_clearance_mm) {
    o.status = Status::unknown;
    o.because = quoted(zone.name) +
                " is not one convex prism: that a place to return is in sight from everywhere in "
                "it is not shown";
    return o;
  }
  o.status = Status::proved;
  o.because = quoted(zone.name) +
              " is convex: from everywhere in it a leg leads straight to a "
              "clearance of " +
              metres(last.return_clearance_mm);
  Claim claim =
      place_claim(s, last.zone, zone.widest_x_mm, zone.widest_y_mm, last.return_clearance_mm);
  claim.what = "legs";
  claim.values["monitor"] = m.name;
  if (zone.has_height()) claim.values["z_mm"] = std::to_string(zone.widest_z_mm);
  o.claims.push_back(std::move(claim));
  return o;
}

}  // namespace rtac::verify
