#include "compiler/analysis/return_set.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/return_condition.h"
#include "compiler/analysis/standoffs.h"
#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

std::string metres(std::int64_t mm) {
  return to_decimal(Rational(mm, 1000)) + " m";
}
std::string millis(std::int64_t us) {
  return to_decimal(Rational(us, 1000)) + " ms";
}

// Where a monitor hands back: in the zone that its recovery retreats in, or else in the narrowest
// one that its property keeps the robot in. none: its property does not speak of places.
std::optional<ir::ZoneIndex> place_of(const ir::Module& module, const ir::Decision& decision,
                                      const ir::Monitor& m) {
  if (!m.lookahead.duration) return std::nullopt;
  const ir::Recovery& last = ir::last_step(m.recovery);
  if (last.kind == ir::RecoveryKind::retreat || last.kind == ir::RecoveryKind::loiter) {
    return last.zone;
  }
  std::optional<ir::ZoneIndex> narrowest;
  for (const ir::ZoneIndex zone : fences_of(m.property, decision.facts.params)) {
    if (!narrowest || module[zone].widest_mm < module[*narrowest].widest_mm) narrowest = zone;
  }
  return narrowest;
}

// Every recovery heads for the clearance that suits all monitors (derive.cpp): it grows with the
// longest look-ahead and the largest standoff, whosever they are.
class ReturnSet {
 public:
  ReturnSet(const ir::Module& module, const ir::Decision& decision)
      : module_(module), decision_(decision), standoff_mm_(standoffs_of(decision).fence_mm) {
    for (const ir::Monitor& m : decision.monitors) {
      lookahead_us_ = std::max(lookahead_us_, m.lookahead.duration_us);
      if (!returns(m)) continue;
      // what works in the narrowest of their zones works in all
      if (!retreat_ || widest_mm(m) < widest_mm(*retreat_)) retreat_ = &m;
    }
  }

  std::vector<diag::Diagnostic> findings() const {
    if (!retreat_) return {};
    if (need_mm(lookahead_us_, standoff_mm_) > widest_mm(*retreat_)) return of_all_monitors();
    std::vector<diag::Diagnostic> all;
    for (std::size_t k = 0; k < decision_.monitors.size(); ++k) {
      const ir::Monitor& m = decision_.monitors[k];
      if (returns(m) && m.recovery.return_clearance_mm > widest_mm(m)) all.push_back(asked(m, k));
    }
    return all;
  }

 private:
  bool returns(const ir::Monitor& m) const { return place_of(module_, decision_, m).has_value(); }
  const ir::ZoneTable& zone_of(const ir::Monitor& m) const {
    return module_[*place_of(module_, decision_, m)];
  }
  std::int64_t widest_mm(const ir::Monitor& m) const { return zone_of(m).widest_mm; }
  std::int64_t need_mm(std::int64_t lookahead_us, std::int64_t standoff_mm) const {
    return return_clearance_mm(decision_, lookahead_us) + standoff_mm;
  }
  std::int64_t standoff_mm(const ir::Monitor& m) const {
    Standoffs own;
    ask_for_standoffs(m.property, decision_.facts.params, own);
    return own.fence_mm;
  }

  // Shorter look-aheads work, or smaller standoffs, or neither does alone.
  std::vector<diag::Diagnostic> of_all_monitors() const {
    const std::int64_t widest = widest_mm(*retreat_);
    const std::int64_t ahead_us = lookahead_max_us(decision_, widest, standoff_mm_);
    const std::int64_t spare_mm = widest - need_mm(lookahead_us_, 0);
    std::vector<diag::Diagnostic> all;
    for (const ir::Monitor& m : decision_.monitors) {
      const std::int64_t own_mm = standoff_mm(m);
      if (ahead_us >= decision_.period_us) {
        if (m.lookahead.duration_us <= ahead_us) continue;
        all.push_back(finding(m, need_mm(m.lookahead.duration_us, standoff_mm_)));
        all.back().help = "`ahead` of at most " + millis(ahead_us) + " works";
      } else if (spare_mm >= 0) {
        if (own_mm <= spare_mm) continue;
        all.push_back(finding(m, need_mm(lookahead_us_, own_mm)));
        all.back().range = standoff_source(m, own_mm);
        all.back().help = "a clearance of at most " + metres(spare_mm) + " works";
      } else if (m.lookahead.duration_us == lookahead_us_) {
        const std::int64_t need = need_mm(lookahead_us_, standoff_mm_);
        all.push_back(finding(m, need));
        all.back().help = "no look-ahead works here: widen the zone by " +
                          metres(2 * (need - widest)) + ", or lower `speed` or `accel`";
      }
    }
    return all;
  }

  // The return condition of the monitor itself asks for more, in another zone than it retreats in.
  diag::Diagnostic asked(const ir::Monitor& m, std::size_t k) const {
    const std::int64_t widest = widest_mm(m);
    const ir::Block& when = *m.return_when;
    const std::int64_t least = widest - shown_clearance_mm(decision_, decision_.motions[k + 1], 0);
    diag::Diagnostic d = finding(m, asked_clearance_mm(module_, decision_, k));
    d.range = when[when.result].source;
    d.notes = {note(m)};
    d.help = least >= 0 ? "a clearance of " + metres(least) + " works"
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
      const bool goes = kind == ir::RecoveryKind::retreat || kind == ir::RecoveryKind::loiter;
      d.notes.push_back({std::nullopt, "monitor `" + retreat_->name +
                                           (goes ? "` retreats there, to where "
                                                 : "` keeps the robot there, where ") +
                                           "all monitors of the decision hand back"});
    }
    return d;
  }
  diag::Note note(const ir::Monitor& retreat) const {
    const ir::ZoneTable& zone = zone_of(retreat);
    return {std::nullopt, "the widest place of `" + zone.name + "` has a clearance of " +
                              metres(zone.widest_mm) + ", at (" + metres(zone.widest_x_mm) + ", " +
                              metres(zone.widest_y_mm) +
                              (zone.has_height() ? ", " + metres(zone.widest_z_mm) : "") + ")"};
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

  const ir::Module& module_;
  const ir::Decision& decision_;
  std::int64_t lookahead_us_ = 0, standoff_mm_;
  const ir::Monitor* retreat_ = nullptr;  // in the narrowest zone; none: no monitor does
};

}  // namespace

std::vector<diag::Diagnostic> empty_return_sets(const ir::Module& module,
                                                const ir::Decision& decision) {
  return ReturnSet(module, decision).findings();
}

std::int64_t lookahead_max_us(const ir::Decision& decision, std::int64_t widest_mm,
                              std::int64_t standoff_mm) {
  const auto fits = [&](std::int64_t ms) {
    return return_clearance_mm(decision, 1000 * ms) + standoff_mm <= widest_mm;
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
