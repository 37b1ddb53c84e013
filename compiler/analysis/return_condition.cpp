#include "compiler/analysis/return_condition.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "compiler/analysis/at_odds.h"
#include "compiler/analysis/dials.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/return_set.h"
#include "compiler/analysis/site_room.h"
#include "compiler/analysis/tables.h"
#include "compiler/analysis/told.h"
#include "compiler/analysis/widening.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/words.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

using ir::Leaf;
using Finding = std::optional<diag::Diagnostic>;

std::int64_t div_up(std::int64_t a, std::int64_t b) {
  return (a + b - 1) / b;
}

// Largest price within `radius_mm` of a place of the site; of all its places the largest. nullopt:
// it has none, or one that cannot be reached, which is reported as such.
std::optional<std::int64_t> price_at(const ir::Module& module, ir::SiteIndex site,
                                     std::int64_t radius_mm) {
  const ir::Cells& cells = module[module[site].zone].cells;
  const auto clamped = [&](std::int64_t at_mm, std::int32_t count) {
    return std::clamp<std::int64_t>(at_mm / cells.cell_mm, 0, count - 1);
  };
  std::optional<std::int64_t> most;
  for (const ir::SiteTable::Place& place : module[site].places) {
    const std::int64_t x = std::int64_t{place.x_mm} - cells.origin_x_mm;
    const std::int64_t y = std::int64_t{place.y_mm} - cells.origin_y_mm;
    const auto cost = [&](std::int64_t column, std::int64_t row) {
      return place.cost_ppm[static_cast<std::size_t>(row * cells.columns + column)];
    };
    if (place.cost_ppm.empty()) return std::nullopt;
    const std::int32_t own = cost(clamped(x, cells.columns), clamped(y, cells.rows));
    if (own < 0 || own >= ir::no_way) return std::nullopt;
    for (auto row = clamped(y - radius_mm, cells.rows); row <= clamped(y + radius_mm, cells.rows);
         ++row) {
      for (auto column = clamped(x - radius_mm, cells.columns);
           column <= clamped(x + radius_mm, cells.columns); ++column) {
        most = std::max<std::int64_t>(most.value_or(0), cost(column, row));
      }
    }
  }
  return most;
}

// A part of a condition; of a condition that looks back, of what it asks of some time.
struct Part {
  const ir::Block* block;
  ir::ValueId id;
  bool may_be_over = false;  // it has held earlier, and need not hold where control returns
};
// Of `historically`, `once`, `previously` and `for` what they speak of, which is as hopeless as
// they are; nullopt: the value is none of them.
std::optional<Part> looked_back_at(const ir::Decision& decision, const Part& part) {
  const ir::Op& op = (*part.block)[part.id].op;
  if (const auto* v = std::get_if<ir::HeldFor>(&op)) {
    return Part{part.block, v->a, part.may_be_over};
  }
  if (const auto* v = std::get_if<ir::Historically>(&op)) {
    return Part{part.block, v->a, part.may_be_over || v->window.from > 0};
  }
  if (const auto* v = std::get_if<ir::Once>(&op)) return Part{part.block, v->a, true};
  if (const auto* v = std::get_if<ir::Previously>(&op)) return Part{part.block, v->a, true};
  const auto* fact = std::get_if<ir::Fact>(&op);
  if (fact == nullptr || !fact->of_robot) return std::nullopt;
  const ir::Block& judged = decision.facts.monitors[fact->index].property;
  return Part{&judged, judged.result, part.may_be_over};
}

// That a value is the constant false: said so, of two numbers that are written, or that there is
// another robot where there is none.
bool is_never(const ir::Decision& decision, const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
    return !v->universal && decision.robots < 2;
  }
  if (const auto* v = std::get_if<ir::Truth>(&op)) return !v->value;
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (!compare) return false;
  const auto* a = std::get_if<ir::Const>(&block[compare->a].op);
  const auto* b = std::get_if<ir::Const>(&block[compare->b].op);
  return a != nullptr && b != nullptr &&
         (a->value < b->value || (compare->strict && a->value == b->value));
}
bool is_never_at_all(const ir::Decision& decision, const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  const auto is = [&](ir::ValueId side) { return is_never_at_all(decision, block, side); };
  if (const auto* v = std::get_if<ir::And>(&op)) return is(v->a) || is(v->b);
  if (const auto* v = std::get_if<ir::Or>(&op)) return is(v->a) && is(v->b);
  return is_never(decision, block, id);
}

class Judge {
 public:
  Judge(const ir::Module& module, const ir::Decision& decision, std::size_t k,
        const Decided* of = nullptr, const ExactZones* exact = nullptr)
      : module_(module),
        decision_(decision),
        monitor_(decision.monitors[k]),
        motion_(decision.motions[k + 1]),
        k_(k),
        of_(of),
        exact_(exact) {}

  // What a comparison asks for; of a parameter, whatever it becomes.
  std::optional<ir::LowerBound> bound_of(const ir::Block& block, const ir::AtLeast& compare) const {
    return ir::lower_bound(block, compare, decision_.facts.params);
  }
  std::optional<ir::ChargeForWay> way_of(const ir::Block& block, const ir::AtLeast& compare) const {
    return ir::charge_for_way(block, compare, decision_.facts.params);
  }

  // No inputs are ever seen to make it true.
  Finding never_told(const sema::Expr& e) const {
    if (told_to_be(of_->spec, e, true, ToldHow::seen).can != CanBeTold::no) return std::nullopt;
    diag::Diagnostic d = finding(e.range);
    const Told exactly = told_to_be(of_->spec, e, true, ToldHow::exactly);
    const bool hidden = exactly.can == CanBeTold::yes;
    d.label = hidden ? "no inputs are seen to make it true" : "no inputs make it true";
    if (hidden) {
      d.notes.push_back({std::nullopt, "it is true with " + told_text(of_->spec, exactly.inputs) +
                                           ", which the errors of what is measured hide"});
    }
    d.help = hidden ? "less of an error is needed, or a condition that is not so narrow"
                    : "a condition that some inputs make true is needed";
    return d;
  }

  // The condition as written.
  Finding condition(const Part& part) const {
    const ir::Block& block = *part.block;
    const ir::ValueId id = part.id;
    const ir::Op& op = block[id].op;
    const auto side = [&](ir::ValueId of) { return condition({&block, of, part.may_be_over}); };
    if (const auto* v = std::get_if<ir::And>(&op)) {
      Finding a = side(v->a);
      if (!a) a = side(v->b);
      // both sides are of the same tick, whenever that was
      return a ? a : excluded(block, id);
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      Finding a = side(v->a);
      return a && side(v->b) ? a : std::nullopt;
    }
    if (is_never(decision_, block, id)) return never(block, id);
    if (const auto of = looked_back_at(decision_, part)) return condition(*of);
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
      if (decision_.robots < 2) return std::nullopt;  // there is no other, and all hold
      return condition({v->body.get(), v->body->result, part.may_be_over});
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (!compare || !ir::has_form(block, *compare)) return std::nullopt;
    const SourceRange& source = block[id].source;
    if (const auto bound = bound_of(block, *compare)) {
      const std::int64_t strict = compare->strict ? 1 : 0;
      if (bound->leaf.kind == Leaf::Kind::clearance) {
        return clearance(ir::ZoneIndex(bound->leaf.table), bound->need.strictest, strict, source);
      }
      if (bound->leaf.kind == Leaf::Kind::distance) {
        // robots may have been put anywhere
        if (part.may_be_over) return std::nullopt;
        return far_apart(bound->need.strictest, strict, source);
      }
      if (bound->leaf.kind == Leaf::Kind::battery) {
        return charge(bound->need.strictest, shown_full_ppm(decision_.body), strict, "", source);
      }
      if (bound->leaf.kind == Leaf::Kind::speed) return fast(bound->need.laxest, source);
      return std::nullopt;
    }
    const auto most = ir::upper_bound(block, *compare);
    if (most && most->leaf.kind == Leaf::Kind::speed) return slow(most->most, source);
    if (most && most->leaf.kind == Leaf::Kind::clearance && !part.may_be_over) {
      return too_near(ir::ZoneIndex(most->leaf.table), most->most, source);
    }
    const auto way = way_of(block, *compare);
    if (!way) return std::nullopt;
    const ir::Body& b = decision_.body;
    const std::int64_t within =
        seen_off_mm() + b.position_error_mm + way_mm(b, motion_, still_mmps(b), b.position_age_us);
    const auto price = price_at(module_, way->site, within);
    if (!price) return std::nullopt;
    if (*price >= ir::no_way) return cramped(way->site, within, source);
    const std::int64_t left = shown_full_ppm(b) - *price;
    return charge(way->reserve.strictest, left, compare->strict ? 1 : 0,
                  " beyond the way to `" + module_[way->site].name + "`", source);
  }

  // The property, looked ahead from the site that the recovery leads to, on a full battery.
  Finding property(const ir::Block& block, ir::ValueId id) const {
    const ir::Op& op = block[id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) {
      Finding a = property(block, v->a);
      return a ? a : property(block, v->b);
    }
    if (const auto* v = std::get_if<ir::Or>(&op)) {
      Finding a = property(block, v->a);
      return a && property(block, v->b) ? a : std::nullopt;
    }
    if (is_never(decision_, block, id)) return never(block, id);
    if (const auto* v = std::get_if<ir::ForOthers>(&op)) {
      if (decision_.robots < 2) return std::nullopt;  // there is no other, and all hold
      return property(*v->body, v->body->result);
    }
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (!compare) return std::nullopt;
    const ir::Recovery& way_home = ir::last_step(monitor_.recovery);
    const bool routes = way_home.kind == ir::RecoveryKind::route;
    if (const auto bound = bound_of(block, *compare)) {
      const std::int64_t least = bound->need.strictest;
      if (bound->leaf.kind == Leaf::Kind::distance) return apart(least, compare->strict, block[id]);
      if (bound->leaf.kind == Leaf::Kind::battery && !routes) {
        return charged(least, compare->strict, block[id]);
      }
    }
    if (!routes) return std::nullopt;
    const ir::SiteIndex site = way_home.site;
    std::optional<std::int64_t> reserve;
    if (const auto way = way_of(block, *compare); way && way->site == site) {
      reserve = way->reserve.strictest;
    }
    const auto bound = bound_of(block, *compare);
    if (bound && bound->leaf.kind == Leaf::Kind::battery) reserve = bound->need.strictest;
    if (!reserve) return std::nullopt;
    const ir::Body& b = decision_.body;
    const std::int64_t t_us =
        horizon_us_max(b, monitor_.lookahead.duration_us) + decision_.return_extra_us;
    const std::int64_t within =
        seen_off_mm() - b.radius_mm +
        disc_mm(b, decision_.motions[0], b.velocity_error_mmps + apart_mmps(b), t_us);
    const auto price = price_at(module_, site, within);
    if (!price) return std::nullopt;
    // without any way, and so without the errors that a way has
    const std::int64_t at_site = shown_full_ppm(b) - decision_.hold_reserve_ppm -
                                 div_up(b.drain_ppm_per_s * div_up(t_us, 1000), 1000);
    const bool is_priced = *price < ir::no_way;
    if (!is_priced && *reserve <= at_site) return cramped(site, within, block[id].source);
    const std::string way = is_priced ? ", the way to `" + module_[site].name + "`" : "";
    return charge(*reserve, is_priced ? at_site - *price : at_site, compare->strict ? 1 : 0,
                  " beyond the look-ahead" + way + ", `held` and `detour`", block[id].source);
  }

  // Of the comparisons that all have to hold, the one with the largest clearance that can be had.
  AskedClearance asked(const Part& part, ir::ZoneIndex place, const HowItLies& lies) const {
    const ir::Block& block = *part.block;
    const ir::Op& op = block[part.id].op;
    if (const auto* v = std::get_if<ir::And>(&op)) {
      const AskedClearance a = asked({&block, v->a}, place, lies);
      const AskedClearance b = asked({&block, v->b}, place, lies);
      return a.mm < b.mm ? b : a;
    }
    if (const auto of = looked_back_at(decision_, part)) return asked(*of, place, lies);
    const auto* compare = std::get_if<ir::AtLeast>(&op);
    if (!compare || !ir::has_form(block, *compare)) return {};
    const auto bound = bound_of(block, *compare);
    if (!bound || bound->leaf.kind != Leaf::Kind::clearance) return {};
    const std::int64_t need = shown_clearance_mm(decision_, motion_, bound->need.strictest);
    const ir::ZoneIndex zone{bound->leaf.table};
    if (need > module_[zone].widest_mm) return {};
    return {std::max<std::int64_t>(need - depth_mm(place, {zone, need}, lies), 0),
            block[part.id].source};
  }

 private:
  // How far off its site a robot that rests there is measured at most.
  std::int64_t seen_off_mm() const {
    const ir::Body& b = decision_.body;
    return std::max(parked_mm, rests_off_mm(b) + b.position_error_mm) + b.position_error_mm;
  }
  std::int64_t return_horizon_us() const {
    return horizon_us_max(decision_.body, monitor_.lookahead.duration_us) +
           decision_.return_extra_us;
  }
  // The distance as the property asks for it, and what a robot at rest may come nearer until it has
  // been stopped. The other one may be held, and so counts with nothing but its body.
  Finding apart(std::int64_t least_mm, bool strict, const ir::Value& value) const {
    if (!monitor_.lookahead.duration) return std::nullopt;
    const std::int64_t reach_mm =
        disc_mm(decision_.body, decision_.motions[0], 0, return_horizon_us()) -
        decision_.body.radius_mm;
    const auto given_back_mm = given_back_apart_mm();
    Finding found = distance(least_mm + reach_mm, value.source);
    if (!found && given_back_mm && least_mm > *given_back_mm) {
      found = finding(value.source);
      found->label = "no two robots that are given back are so far apart";
      found->notes.push_back({std::nullopt, "where control is given back in the zones of `" +
                                                decision_.name + "`, it is at most " +
                                                metres(*given_back_mm) + " between two bodies"});
    }
    if (!found) return found;
    found->notes.push_back(
        {std::nullopt,
         "of the distance, the look-ahead of a robot at rest takes " + metres(reach_mm)});
    const std::int64_t gap_mm = widest_gap_mm() - reach_mm;
    const std::int64_t best = std::min(gap_mm, given_back_mm.value_or(gap_mm)) - (strict ? 1 : 0);
    const auto had = that_works(value.source, 1000, least_mm, best);
    found->help = had ? "a distance of at most " + metres(*had) + " can be had"
                      : "no distance works: widen the zone, or lower `ahead`, `speed` or `accel`";
    if (const auto wider = wider_zone(*found, least_mm - best)) found->help += "; or " + *wider;
    return found;
  }
  // The charge as the property asks for it, after what the look-ahead takes.
  Finding charged(std::int64_t least_ppm, bool strict, const ir::Value& value) const {
    const ir::Body& b = decision_.body;
    const std::int64_t left =
        shown_full_ppm(b) - div_up(b.drain_ppm_per_s * div_up(return_horizon_us(), 1000), 1000);
    return charge(least_ppm, left, strict ? 1 : 0, "", value.source);
  }

  Finding clearance(ir::ZoneIndex zone, std::int64_t least, std::int64_t strict,
                    const SourceRange& source) const {
    const ir::ZoneTable& table = module_[zone];
    const std::int64_t taken = shown_clearance_mm(decision_, motion_, 0);
    if (least <= table.widest_mm - taken) return std::nullopt;
    const ir::Recovery& last = ir::last_step(monitor_.recovery);
    const std::int64_t room = last.zone == zone ? room_mm(decision_, last, table) : table.widest_mm;
    const std::int64_t best = room - taken;
    diag::Diagnostic d = finding(source);
    d.label = "holds nowhere in `" + table.name + "`";
    d.notes.push_back(
        {std::nullopt,
         "in the widest place, at " + ir::widest_place(table) + ", the centre has " +
             metres(table.widest_mm) +
             (room < table.widest_mm ? ", and in no whole cell more than " + metres(room) : "") +
             "; body, errors and the age of a sample take " + metres(taken)});
    const auto works = that_works(source, 1000, least, best - strict);
    d.help = works                ? "a clearance of " + metres(*works) + " works"
             : best - strict >= 0 ? "no more than " + metres(best - strict) + " is shown there"
                                  : "no clearance works: widen the zone";
    return d;
  }

  // Nobody is given control nearer to a boundary than where the look-ahead is sure to keep what it
  // asks for: of a robot at rest that is measured at this instant, at least.
  Finding too_near(ir::ZoneIndex zone, std::int64_t most_mm, const SourceRange& source) const {
    constexpr std::int64_t rounded_mm = 10;
    const ir::Body& b = decision_.body;
    const ir::Monitor* keeps = nullptr;
    std::int64_t least_mm = most_mm;
    for (const ir::Monitor& m : decision_.monitors) {
      if (!m.lookahead.duration || m.lookahead.command) continue;  // that needs less
      const auto fences = sure_fences(m.property, decision_.facts.params);
      if (std::find(fences.begin(), fences.end(), zone) == fences.end()) continue;
      const std::int64_t us = horizon_us_max(b, m.lookahead.duration_us) - b.position_age_us +
                              decision_.return_extra_us;
      const std::int64_t need_mm =
          disc_mm(b, decision_.motions[0], 0, us) - b.radius_mm - rounded_mm;
      if (need_mm <= least_mm) continue;
      least_mm = need_mm;
      keeps = &m;
    }
    if (keeps == nullptr) return std::nullopt;
    diag::Diagnostic d = finding(source);
    d.label = "is false wherever `" + keeps->name + "` lets control go back";
    d.notes.push_back({std::nullopt, "its look-ahead needs a clearance of more than " +
                                         metres(least_mm) + " in `" + module_[zone].name +
                                         "`, at rest as well"});
    d.help =
        "`clearance >= ...` asks for a deeper place; without `return when` control goes back "
        "as soon as the look-ahead allows it";
    return d;
  }

  // Control is handed back to a robot that is in every fence of its decision, and so are the others
  // of its kind: no two centres are farther apart than the corners of the box around the least of
  // these zones. Without a fence nothing bounds the distance.
  std::int64_t widest_gap_mm() const {
    std::int64_t best = std::int64_t{1} << 31;
    for (const ir::Monitor& m : decision_.monitors) {
      for (const ir::ZoneIndex fence : sure_fences(m.property, decision_.facts.params)) {
        if (const auto apart = bodies_apart_mm(fence)) best = std::min(best, *apart);
      }
    }
    return best;
  }
  // Control is given back to both, each as clear of the boundary as its monitor needs it.
  std::optional<std::int64_t> given_back_apart_mm() const {
    std::optional<std::int64_t> least;
    if (exact_ == nullptr) return least;
    for (const ir::Monitor& m : decision_.monitors) {
      if (!m.lookahead.duration) continue;
      const std::int64_t back_mm = return_clearance_mm(decision_, m.lookahead.duration_us);
      for (const ir::ZoneIndex fence : sure_fences(m.property, decision_.facts.params)) {
        const auto across_mm =
            farthest_apart_mm(module_, decision_.body.in_space, *exact_, fence, back_mm);
        if (!across_mm || *across_mm == 0) continue;  // 0: nobody is, which is said by itself
        const std::int64_t bodies_mm =
            std::max<std::int64_t>(*across_mm - 2 * decision_.body.radius_mm, 0);
        least = std::min(least.value_or(bodies_mm), bodies_mm);
      }
    }
    return least;
  }
  // The zone that robots are held in, if it is one, so much wider that they can be as far apart.
  // Each end of its longest diagonal moves out by between once and 1.42 times the growth. Where it
  // is asked what is shown, too, that says how wide it has to be (joint return).
  std::optional<std::string> wider_zone(const diag::Diagnostic& of, std::int64_t missing_mm) const {
    if (of_ == nullptr || of_->trials == nullptr || exact_ == nullptr) return std::nullopt;
    if (!of_->trials->by_reports_alone() || decision_.body.in_space) return std::nullopt;
    std::set<ir::ZoneIndex> fences;
    for (const ir::Monitor& m : decision_.monitors) {
      for (const ir::ZoneIndex fence : sure_fences(m.property, decision_.facts.params)) {
        fences.insert(fence);
      }
    }
    if (fences.size() != 1 || missing_mm <= 0) return std::nullopt;
    return growth_that_works(*of_->trials, *fences.begin(), exact_->flat(*fences.begin()),
                             missing_mm * 5 / 14, missing_mm, fault_of(of.code, of.range));
  }
  // The distance as the return condition asks for it.
  Finding far_apart(std::int64_t least_mm, std::int64_t strict, const SourceRange& source) const {
    Finding found = distance(least_mm, source);
    if (!found) return found;
    const auto had = that_works(source, 1000, least_mm, widest_gap_mm() - strict);
    found->help = had ? "a distance of at most " + metres(*had) + " can be had"
                      : "no distance works: widen the zone";
    const std::int64_t missing_mm = least_mm + strict - widest_gap_mm();
    if (const auto wider = wider_zone(*found, missing_mm)) found->help += "; or " + *wider;
    return found;
  }
  Finding distance(std::int64_t least, const SourceRange& source) const {
    std::optional<std::int64_t> best;
    const ir::ZoneTable* nearest = nullptr;
    for (const ir::Monitor& m : decision_.monitors) {
      for (const ir::ZoneIndex fence : sure_fences(m.property, decision_.facts.params)) {
        const auto apart = bodies_apart_mm(fence);
        if (!apart || (best && *best <= *apart)) continue;
        best = apart;
        nearest = &module_[fence];
      }
    }
    if (!best || least <= *best) return std::nullopt;
    diag::Diagnostic d = finding(source);
    d.label = "no two robots in `" + nearest->name + "` are so far apart";
    d.notes.push_back({std::nullopt, "from corner to corner of the box around `" + nearest->name +
                                         "` it is " + metres(*best) + " between two bodies"});
    return d;
  }
  // Between two bodies in a zone, the farthest they may be apart. none: of robots in space a zone
  // of the plane bounds no height.
  std::optional<std::int64_t> bodies_apart_mm(ir::ZoneIndex zone) const {
    if (decision_.body.in_space && !module_[zone].has_height()) return std::nullopt;
    return diameter_mm(module_[zone]) - 2 * decision_.body.radius_mm;
  }
  // From corner to corner of the box around the zone, rounded down to the grid of distances.
  std::int64_t diameter_mm(const ir::ZoneTable& zone) const {
    const auto [dx, dy, up] = extent_of(module_, zone);  // 2^30 at most
    std::int64_t low = 0, high = dx + dy + up;
    while (low < high) {
      const std::int64_t middle = low + (high - low + 1) / 2;
      const bool fits = middle * middle <= dx * dx + dy * dy + up * up;
      fits ? low = middle : high = middle - 1;
    }
    return low;
  }

  Finding charge(std::int64_t least, std::int64_t best, std::int64_t strict,
                 const std::string& beyond, const SourceRange& source) const {
    if (least <= best) return std::nullopt;
    diag::Diagnostic d = finding(source);
    d.label = "a full battery does not show it";
    d.notes.push_back({std::nullopt,
                       "with its error and the age of its sample, a full battery is "
                       "sure to have " +
                           percent(shown_full_ppm(decision_.body))});
    const auto works = that_works(source, 1'000'000, least, best - strict);
    const auto less = works ? std::nullopt : consumption_for(source, least - best);
    // as much as can be shown; what is asked for may not be all that is wrong
    const bool is_shown = !works && !less && best - strict >= 0;
    d.help = works      ? "`" + percent(*works) + "` works" + beyond
             : less     ? *less + " works; or a nearer site"
             : is_shown ? "no more than `" + percent(best - strict) + "` is shown" + beyond
                        : "no charge works" + beyond + ": " + shown_for(source, least - best);
    return d;
  }
  // With which a full battery is seen to have so much more.
  std::string shown_for(const SourceRange& source, std::int64_t missing_ppm) const {
    const std::int64_t full_ppm = shown_full_ppm(decision_.body);
    const auto others =
        of_ == nullptr
            ? std::vector<std::string>{}
            : repairs(of_->written, of_->trials, fault_of(diag::Code::return_set_empty, source),
                      [&](const Trial& t) {
                        return shown_full_ppm(t.decision.body) - full_ppm >= missing_ppm;
                      });
    if (!others.empty()) return joined(others) + " works";
    return full_ppm > 0 ? "a nearer site is needed" : "its battery has to be measured better";
  }
  // With which a battery has as much as is missing.
  std::optional<std::string> consumption_for(const SourceRange& source,
                                             std::int64_t missing_ppm) const {
    if (of_ == nullptr || of_->trials == nullptr) return std::nullopt;
    const std::int64_t full_ppm = shown_full_ppm(decision_.body);
    if (full_ppm <= 0) return std::nullopt;
    const Rational share(static_cast<long>(full_ppm + missing_ppm), static_cast<long>(full_ppm));
    return consumption_that_works(*of_->trials, fault_of(diag::Code::return_set_empty, source),
                                  of_->written.kind, share);
  }
  // In place of what a comparison asks for: the nearest number with which all of the monitor works.
  // `guess`: with which this finding is gone.
  std::optional<std::int64_t> that_works(const SourceRange& source, int per_unit,
                                         std::int64_t asked, std::int64_t guess) const {
    if (of_ == nullptr || of_->trials == nullptr || guess < 0) return std::nullopt;
    const sema::Monitor& written = of_->spec[of_->written.priority[k_]];
    return asked_that_works(*of_->trials,
                            {fault_of(diag::Code::return_set_empty, source), per_unit, asked,
                             std::min(guess, asked - 1), guess / asked_share, written.range},
                            source);
  }
  // No charge is enough where there is no way.
  Finding cramped(ir::SiteIndex site, std::int64_t within_mm, const SourceRange& source) const {
    const std::vector<Cramped> rooms = cramped_places(module_, site, within_mm);
    if (rooms.empty()) return std::nullopt;
    const std::string name = "`" + module_[site].name + "`";
    const std::string zone = "`" + module_[module_[site].zone].name + "`";
    const auto text = [](const auto& p) {
      return "(" + metres(p.x_mm) + ", " + metres(p.y_mm) + ")";
    };
    diag::Diagnostic d = finding(source);
    d.label = "has no way from some places beside " + name;
    d.notes.push_back({std::nullopt, "control is given back at " + name + ", " +
                                         text(rooms.front().at) +
                                         ", if a way is known from all that a robot may reach "
                                         "before its recovery acts, up to " +
                                         metres(within_mm) + " from there in x and in y; " +
                                         "near the boundary of " + zone + " there is none"});
    std::vector<MovedTo> works;
    if (of_ != nullptr && of_->trials != nullptr) {  // else nobody reads it
      works = places_that_work(*of_->trials, fault_of(d.code, d.range), moves_of(rooms, site));
    }
    for (const MovedTo& each : works) {
      d.help += (d.help.empty() ? name : ", and") + " at " + text(each.to) +
                (works.size() == 1 ? ""
                                   : " in place of (" + to_decimal(each.from.x) + " m, " +
                                         to_decimal(each.from.y) + " m)");
    }
    d.help += works.empty() ? "no site in " + zone + " works: " +
                                  room_for_site(module_[site].zone, within_mm, d)
                                      .value_or("widen it, or lower `ahead`, `speed` or `accel`")
                            : " works";
    return d;
  }
  // How much wider the zone is with which there is a way from all around its site.
  std::optional<std::string> room_for_site(ir::ZoneIndex zone, std::int64_t within_mm,
                                           const diag::Diagnostic& of) const {
    if (of_ == nullptr || of_->trials == nullptr) return std::nullopt;  // nobody reads it
    return growth_that_works(*of_->trials, zone, exact_->flat(zone), within_mm / 4, 2 * within_mm,
                             fault_of(of.code, of.range));
  }
  // Each place once that is written; robots may share one.
  [[nodiscard]] std::vector<Move> moves_of(const std::vector<Cramped>& rooms,
                                           ir::SiteIndex site) const {
    std::vector<Move> moves;
    for (const Cramped& room : rooms) {
      const sema::Site::Place* const written = written_place(of_->spec, module_[site], room.at);
      if (written == nullptr) return {};
      const bool known = std::ranges::any_of(
          moves, [&](const Move& each) { return each.written == written->range; });
      if (!known) moves.push_back({written->range, room.roomy});
    }
    return moves;
  }
  // What two comparisons ask for of one signal excludes each other.
  Finding excluded(const ir::Block& block, ir::ValueId id) const {
    const auto found = at_odds(block, id, decision_.facts.params);
    if (!found) return std::nullopt;
    diag::Diagnostic d = finding(block[found->least].source);
    d.label = "is false wherever the other comparison is true";
    d.notes.push_back({block[found->most].source, "this asks for less than that"});
    d.help = "leave one of the two out";
    return d;
  }
  Finding fast(std::int64_t least_mmps, const SourceRange& source) const {
    const std::int64_t most_mmps = decision_.motions[0].speed_mmps;
    if (least_mmps <= most_mmps) return std::nullopt;
    diag::Diagnostic d = finding(source);
    d.label = "no `" + decision_.kind + "` is so fast";
    d.notes.push_back(
        {std::nullopt, "it drives at up to " + to_decimal(Rational(most_mmps, 1000)) + " m/s"});
    d.help = "a recovery ends at rest: `r.speed <= ...` asks for what it leads to";
    return d;
  }
  // Measured to stand, this instant, it may still have the error of its velocity: below that no
  // sample shows it. Up to what every sample shows it is a matter of luck, which P2b does not
  // trust.
  Finding slow(std::int64_t most_mmps, const SourceRange& source) const {
    const std::int64_t error_mmps = decision_.body.velocity_error_mmps;
    if (most_mmps >= error_mmps) return std::nullopt;
    diag::Diagnostic d = finding(source);
    const auto text = [](std::int64_t mmps) { return to_decimal(Rational(mmps, 1000)) + " m/s"; };
    d.label = "no robot at rest is seen to be so slow";
    d.notes.push_back({std::nullopt, "its velocity errs by up to " + text(error_mmps)});
    d.help = "a speed of at least " + text(shown_speed_mmps(decision_, motion_)) +
             " works, whatever the sample";
    return d;
  }
  Finding never(const ir::Block& block, ir::ValueId id) const {
    diag::Diagnostic d = finding(block[id].source);
    d.label = "is false, whatever the robot does";
    if (std::holds_alternative<ir::ForOthers>(block[id].op)) {
      d.notes.push_back({std::nullopt, "there is no other `" + decision_.kind + "`"});
    }
    d.help = "what can be true works; nothing else of the monitor makes up for it";
    return d;
  }
  diag::Diagnostic finding(const SourceRange& source) const {
    diag::Diagnostic d{};
    d.code = diag::Code::return_set_empty;
    d.range = source;
    d.message = "monitor `" + monitor_.name + "` can never hand control back";
    return d;
  }

  const ir::Module& module_;
  const ir::Decision& decision_;
  const ir::Monitor& monitor_;
  const ir::Motion& motion_;
  const std::size_t k_;
  const Decided* of_;  // what is found out is offered help for; none: it is not asked for that
  const ExactZones* exact_;
};

}  // namespace

AskedClearance asked_clearance(const ir::Module& module, const ir::Decision& decision,
                               std::size_t k, ir::ZoneIndex zone, const HowItLies& lies) {
  const auto& when = decision.monitors[k].return_when;
  if (!when) return {};
  return Judge(module, decision, k).asked({&*when, when->result}, zone, lies);
}

bool never_holds(const ir::Decision& decision, const ir::Block& property) {
  return is_never_at_all(decision, property, property.result);
}

std::optional<diag::Diagnostic> hopeless_return(const Decided& of, std::size_t k,
                                                const ExactZones& exact) {
  const Judge judge(of.module, of.decision, k, &of, &exact);
  const ir::Monitor& monitor = of.decision.monitors[k];
  const sema::Monitor& written = of.spec[of.written.priority[k]];
  if (const auto& when = monitor.return_when) {
    if (Finding found = judge.condition({&*when, when->result})) return found;
    if (Finding found = judge.never_told(*written.return_when)) return found;
  }
  Finding found = judge.property(monitor.property, monitor.property.result);
  return found ? found : judge.never_told(*written.always);
}

}  // namespace rtac::analysis
