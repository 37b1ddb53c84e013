#include "compiler/analysis/return_set.h"

#include <algorithm>

#include "compiler/analysis/dials.h"
#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/reach.h"
#include "compiler/analysis/repairs.h"
#include "compiler/analysis/return_condition.h"
#include "compiler/analysis/timing.h"
#include "compiler/analysis/widening.h"
#include "compiler/analysis/zones.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/words.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

// No zone gets so much wider.
constexpr std::int64_t wider_most_mm = 1'000'000;

std::int64_t clearest_mm(const ir::Cells& cells) {
  const auto& all = cells.clearance_mm_lo;
  return all.empty() ? -1 : *std::max_element(all.begin(), all.end());
}
bool returns_over_cells(const ir::Decision& decision, const ir::Recovery& last) {
  return ir::goes_back(last.kind) && !decision.body.in_space;
}

// Where a monitor hands back: in the zone that its recovery retreats in, or else in the narrowest
// one that its property keeps the robot in. none: its property does not speak of places.
std::optional<ir::ZoneIndex> place_of(const ir::Module& module, const ir::Decision& decision,
                                      const ir::Monitor& m) {
  if (!m.lookahead.duration) return std::nullopt;
  const ir::Recovery& last = ir::last_step(m.recovery);
  if (ir::goes_back(last.kind)) {
    return last.zone;
  }
  std::optional<ir::ZoneIndex> narrowest;
  for (const ir::ZoneIndex zone : fences_of(m.property, decision.facts.params)) {
    if (!narrowest || module[zone].widest_mm < module[*narrowest].widest_mm) narrowest = zone;
  }
  return narrowest;
}

// Every recovery heads for the clearance that suits all monitors (derive.cpp): it grows with the
// longest look-ahead and the standoffs that count in its zone, whosever they are.
class ReturnSet {
 public:
  ReturnSet(const Decided& of, const ExactZone& exact, const ExactSolid& solid)
      : of_(of),
        exact_(exact),
        solid_(solid),
        module_(of.module),
        decision_(of.decision),
        now_(trial_of(of.spec, of.written)) {
    for (const ir::Monitor& m : decision_.monitors) {
      if (!returns(m)) continue;
      // what works where most is missing works in all of their zones
      if (!retreat_ || missing_mm(m) > missing_mm(*retreat_)) retreat_ = &m;
    }
  }

  std::vector<diag::Diagnostic> findings() const {
    if (!retreat_) return {};
    if (missing_mm(*retreat_) > 0) return of_all_monitors();
    std::vector<diag::Diagnostic> all;
    for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
      const ir::Monitor& m = decision_.monitors[k];
      if (returns(m) && m.recovery.return_clearance_mm > most_mm(m)) all.push_back(asked(m, k));
    }
    return all;
  }

 private:
  bool returns(const ir::Monitor& m) const { return place_of(module_, decision_, m).has_value(); }
  const ir::ZoneTable& zone_of(const ir::Monitor& m) const {
    return module_[*place_of(module_, decision_, m)];
  }
  std::int64_t room_mm(const ir::Monitor& m) const {
    return analysis::room_mm(decision_, ir::last_step(m.recovery), zone_of(m));
  }
  // Of cells that are too coarse for that something else is said (4012).
  std::int64_t most_mm(const ir::Monitor& m) const {
    const ir::ZoneTable& zone = zone_of(m);
    return zone.cells.cell_mm > cell_mm_least ? zone.widest_mm : room_mm(m);
  }
  std::int64_t standoff_mm(const ir::Monitor& m) const {
    return standoff_in(decision_, m, *place_of(module_, decision_, m), of_.lies);
  }
  static std::int64_t need_mm(const Trial& trial, std::int64_t standoff_mm) {
    return return_clearance_mm(trial.decision, trial.lookahead_us) + standoff_mm;
  }
  std::int64_t missing_mm(const ir::Monitor& m) const {
    return need_mm(now_, standoff_mm(m)) - most_mm(m);
  }
  // What the property of a monitor adds where most is missing.
  std::int64_t added_mm(const ir::Monitor& m) const {
    return standoff_of(m.property, decision_.facts.params,
                       m.recovery.name == retreat_->recovery.name,
                       *place_of(module_, decision_, *retreat_), of_.lies);
  }
  // The most that a monitor may ask for where nothing but `spare_mm` is left: of another zone also
  // what the whole place keeps from its boundary.
  std::int64_t kept_mm(const ir::Monitor& m, std::int64_t spare_mm) const {
    const ir::ZoneIndex place = *place_of(module_, decision_, *retreat_);
    std::optional<std::int64_t> least;
    for (const Standoff& each : fence_standoffs(m.property, decision_.facts.params)) {
      if (each.mm <= spare_mm) continue;
      const auto deep = [&](std::int64_t mm) {
        return of_.lies(place, {each.zone, mm}) == Lies::deep;
      };
      if (each.zone == place || !deep(spare_mm)) return spare_mm;
      std::int64_t low = spare_mm, high = each.mm;
      while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (deep(middle) ? low : high) = middle;
      }
      least = std::min(least.value_or(low), low);
    }
    return least.value_or(spare_mm);
  }
  const sema::Monitor& written(const ir::Monitor& m) const {
    const auto k = static_cast<std::size_t>(&m - decision_.monitors.data());
    return of_.spec[of_.written.priority[k]];
  }

  // The longest look-ahead with which `fits` holds, in whole ms, if all that are longer are
  // declared and may be so short.
  std::optional<std::int64_t> shorter_us(const Fits& fits) const {
    std::int64_t low = 0, high = now_.lookahead_us / 1000 + 1;  // ms
    const auto works = [&](std::int64_t ms) {
      return fits(with_lookahead(of_.spec, of_.written, 1000 * ms));
    };
    if (!works(low)) return std::nullopt;
    while (high - low > 1) {
      const std::int64_t middle = (low + high) / 2;
      (works(middle) ? low : high) = middle;
    }
    for (const ir::Monitor& m : decision_.monitors) {
      if (m.lookahead.duration_us <= 1000 * low) continue;
      const std::int64_t least_us = periods_of(of_.spec, written(m)) * decision_.period_us;
      if (!written(m).ahead.duration || 1000 * low < least_us) return std::nullopt;
    }
    return 1000 * low;
  }

  // Shorter look-aheads work, or smaller standoffs, or neither does alone.
  std::vector<diag::Diagnostic> of_all_monitors() const {
    const std::int64_t room = room_mm(*retreat_), standoff = standoff_mm(*retreat_);
    // with a look-ahead that covers the latency, too
    const Fits fits = [&](const Trial& t) {
      return return_clearance_mm(t.decision, covering_us(t)) + standoff <= room;
    };
    const std::optional<std::int64_t> ahead_us = shorter_us(fits);
    const std::int64_t spare_mm = room - need_mm(now_, 0);
    std::vector<diag::Diagnostic> all;
    for (const ir::Monitor& m : decision_.monitors) {
      const std::int64_t own_mm = added_mm(m);
      if (ahead_us) {
        if (m.lookahead.duration_us <= *ahead_us) continue;
        all.push_back(finding(
            m, need_mm(with_lookahead(of_.spec, of_.written, m.lookahead.duration_us), standoff)));
        all.back().help = "`ahead` of at most " + millis(*ahead_us) + " works";
      } else if (spare_mm >= 0) {
        if (own_mm <= spare_mm) continue;
        all.push_back(finding(m, need_mm(now_, own_mm)));
        all.back().range = standoff_source(m, own_mm);
        const auto works = clearance_that_works(m, all.back().range, kept_mm(m, spare_mm));
        all.back().help =
            works ? "a clearance of at most " + metres(*works) + " works"
                  : "a smaller clearance is needed, and none works alone: a wider zone, too";
      } else if (m.lookahead.duration_us == now_.lookahead_us) {
        all.push_back(finding(m, need_mm(now_, standoff)));
        all.back().notes.push_back(taken(standoff));
        all.back().help =
            "no look-ahead works here" + wider(fault_of(all.back().code, all.back().range), fits);
      }
    }
    return all;
  }
  // In place of what is asked for at `range`, with which all of its monitor works.
  std::optional<std::int64_t> clearance_that_works(const ir::Monitor& m,
                                                   const std::optional<SourceRange>& range,
                                                   std::int64_t guess_mm) const {
    if (of_.trials == nullptr || guess_mm < 0) return std::nullopt;
    const Fault fault = fault_of(diag::Code::return_set_empty, range);
    return asked_that_works(
        *of_.trials,
        {fault, 1000, guess_mm + 1, guess_mm, guess_mm / asked_share, written(m).range}, *range);
  }
  // "": a zone would have to be much larger, or to try that takes long.
  std::string wider_zone(const Fault& fault) const {
    if (of_.trials == nullptr) return "";  // nobody reads it
    const ir::ZoneTable& zone = zone_of(*retreat_);
    if (zone.has_height()) {
      // legs end within that of a place that is so clear, straight up or down
      const bool by_legs = ir::goes_back(ir::last_step(retreat_->recovery).kind);
      const std::int64_t by_mm =
          missing_mm(*retreat_) + (by_legs ? decision_.body.end_reach_mm + 1 : 0);
      const ir::ZoneIndex in_space = *place_of(module_, decision_, *retreat_);
      return growth_that_works(*of_.trials, in_space, solid_(in_space), by_mm,
                               2 * by_mm + need_mm(now_, standoff_mm(*retreat_)), fault, by_mm)
          .value_or("the zone has to be wider and higher");
    }
    // what is grown has round corners
    const std::int64_t need_mm = most_mm(*retreat_) + missing_mm(*retreat_) + recheck_misses_mm;
    const auto fits = [&](const std::vector<geometry::EdgeRow>&, const ir::Cells& cells) {
      return clearest_mm(cells) >= need_mm;
    };
    const ir::ZoneIndex place = *place_of(module_, decision_, *retreat_);
    const bool over_cells = returns_over_cells(decision_, ir::last_step(retreat_->recovery));
    const std::int64_t guess_mm = missing_mm(*retreat_) + recheck_misses_mm;
    const auto by_mm = over_cells ? widening_mm(exact_(place), guess_mm, wider_most_mm / 2, fits)
                                  : std::optional(guess_mm);
    if (!by_mm || *by_mm > wider_most_mm / 2) {
      return distance_that_works(*of_.trials, place, need_mm, fault).value_or("");
    }
    return growth_that_works(*of_.trials, place, exact_(place), *by_mm, 2 * need_mm, fault, *by_mm)
        .value_or("");
  }
  // Or one other number.
  std::string wider(const Fault& fault, const Fits& fits) const {
    const auto others = repairs(of_.written, of_.trials, fault, fits);
    const std::string zone = wider_zone(fault),
                      one = others.empty() ? "" : joined(others) + " works";
    if (!zone.empty()) return ": " + zone + (one.empty() ? "" : "; or " + one);
    if (!one.empty()) return ": " + one;
    return of_.trials != nullptr && of_.trials->ran_out()
               ? "; " + as_tried(of_.trials, "")
               : ", nor any one other number: several have to change";
  }

  // The return condition of the monitor itself asks for more, in another zone than it retreats in.
  diag::Diagnostic asked(const ir::Monitor& m, std::size_t k) const {
    const ir::ZoneIndex place = *place_of(module_, decision_, m);
    const AskedClearance asked = asked_clearance(module_, decision_, k, place, of_.lies);
    // in another zone, in which it lies deep, that is as much more
    const HowItLies beside = [](ir::ZoneIndex, const Standoff&) { return Lies::elsewhere; };
    const std::int64_t deeper_mm =
        asked_clearance(module_, decision_, k, place, beside).mm - asked.mm;
    const std::int64_t least =
        room_mm(m) + deeper_mm - shown_clearance_mm(decision_, decision_.motions[k + 1], 0);
    diag::Diagnostic d = finding(m, asked.mm);
    d.range = asked.source;
    d.notes = {note(m)};
    const auto works = clearance_that_works(m, d.range, least);
    d.help = works ? "a clearance of " + metres(*works) + " works"
                   : "no clearance works: widen `" + zone_of(m).name + "`";
    return d;
  }

  diag::Diagnostic finding(const ir::Monitor& m, std::int64_t need) const {
    diag::Diagnostic d{};
    d.code = diag::Code::return_set_empty;
    d.range = m.lookahead_source;
    d.message = "monitor `" + m.name + "` can never hand control back";
    d.label = "the return set is empty: it needs a clearance of " + metres(need);
    d.notes = {note(*retreat_)};
    if (&m != retreat_ && m.recovery.name != retreat_->recovery.name) {
      const ir::RecoveryKind kind = ir::last_step(retreat_->recovery).kind;
      const bool goes = ir::goes_back(kind);
      d.notes.push_back({std::nullopt, "monitor `" + retreat_->name +
                                           (goes ? "` retreats there, to where "
                                                 : "` keeps the robot there, where ") +
                                           "all monitors of the decision hand back"});
    }
    return d;
  }
  diag::Note note(const ir::Monitor& retreat) const {
    const ir::ZoneTable& zone = zone_of(retreat);
    const bool cells = most_mm(retreat) < zone.widest_mm;
    return {std::nullopt, "the widest place of `" + zone.name + "` has a clearance of " +
                              metres(zone.widest_mm) + ", at " + ir::widest_place(zone) +
                              (cells ? ", and no whole cell of " + metres(zone.cells.cell_mm) +
                                           " has more than " + metres(room_mm(retreat))
                                     : "")};
  }

  // What takes the room, where no look-ahead is short enough.
  diag::Note taken(std::int64_t standoff_mm) const {
    const ir::Body& body = now_.decision.body;
    // where it is, and where it is seen to be back
    const std::int64_t errors_mm = 2 * body.position_error_mm;
    const std::int64_t t_us =
        horizon_us_max(body, now_.lookahead_us) + now_.decision.return_extra_us;
    const std::int64_t way_mm = need_mm(now_, 0) - body.radius_mm - errors_mm;
    std::string text = "of the " + metres(need_mm(now_, standoff_mm)) + ", " +
                       metres(body.radius_mm) + " are for the body, ";
    if (errors_mm > 0) text += metres(errors_mm) + " for twice the error of the position, ";
    if (standoff_mm > 0) text += metres(standoff_mm) + " for what the property asks for, ";
    return {std::nullopt, text + "and " + metres(way_mm) + " for what the robot may do within " +
                              millis(t_us) +
                              ", ages of samples and latency included, and until it stands"};
  }

  // Of the comparison that asks for so much.
  SourceRange standoff_source(const ir::Monitor& m, std::int64_t standoff_mm) const {
    for (const ir::Value& value : m.property.values) {
      const auto* compare = std::get_if<ir::AtLeast>(&value.op);
      const auto bound =
          compare ? ir::lower_bound(m.property, *compare, decision_.facts.params) : std::nullopt;
      if (bound && bound->leaf.kind == ir::Leaf::Kind::clearance &&
          bound->need.strictest >= standoff_mm) {
        return value.source;
      }
    }
    return m.lookahead_source;
  }

  const Decided& of_;
  const ExactZone& exact_;
  const ExactSolid& solid_;
  const ir::Module& module_;
  const ir::Decision& decision_;
  const Trial now_;
  const ir::Monitor* retreat_ = nullptr;  // where most is missing; none: no monitor returns
};

}  // namespace

std::int64_t room_mm(const ir::Decision& decision, const ir::Recovery& last,
                     const ir::ZoneTable& zone) {
  const bool has_cells = !zone.cells.clearance_mm_lo.empty();
  return has_cells && returns_over_cells(decision, last) ? clearest_mm(zone.cells) : zone.widest_mm;
}

std::vector<diag::Diagnostic> empty_return_sets(const Decided& of, const ExactZones& exact) {
  return ReturnSet(of, exact.flat, exact.solid).findings();
}

std::int64_t lookahead_max_us(const ir::Decision& decision, std::int64_t room_mm,
                              std::int64_t standoff_mm) {
  const auto fits = [&](std::int64_t ms) {
    return return_clearance_mm(decision, 1000 * ms) + standoff_mm <= room_mm;
  };
  if (!fits(0)) return 0;
  std::int64_t low = 0, high = 60'000;  // no robot looks further ahead than a minute
  while (high - low > 1) {
    const std::int64_t middle = (low + high) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return 1000 * low;
}

}  // namespace rtac::analysis
