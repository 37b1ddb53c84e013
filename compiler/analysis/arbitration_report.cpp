// What is refused of pairs that are not kept, and what would work: an order or a number is offered
// after the specification has been derived once more with it.
#include <algorithm>

#include "compiler/analysis/arbitration.h"
#include "compiler/analysis/dials.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/paces.h"
#include "compiler/ir/acknowledged.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

// An order, the one that is declared as far as may be, in which everybody ranks above the
// recoveries that may break it, but where that is acknowledged; empty: there is none.
std::vector<std::size_t> order_that_keeps(const ir::Decision& decision, const Arbitration& all) {
  const std::size_t count = all.size();
  const auto breaks = [&](std::size_t i, std::size_t j) {
    const Keeping k = all[i][j].keeping;
    return (k == Keeping::broken || k == Keeping::guarded || all[i][j].silences) &&
           !ir::acknowledged(decision, decision.monitors[i].recovery.name,
                             decision.monitors[j].name);
  };
  const auto last = [&](std::size_t k) {
    return ir::last_step(decision.monitors[k].recovery).kind;
  };
  // Who goes to a place takes turns with whoever stops it on its way, and who drives for as long as
  // inputs say so with whoever leads out of what it breaks.
  const auto takes_turns = [&](std::size_t i, std::size_t j) {
    const ir::Monitor &asks = decision.monitors[i], &stops = decision.monitors[j];
    const bool moves = last(i) != ir::RecoveryKind::brake;
    const bool leads_out = last(j) != ir::RecoveryKind::brake && stops.hold_reason.empty();
    return last(i) == ir::RecoveryKind::route ||
           (moves && leads_out && told(asks.property, asks.property.result));
  };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      // nobody takes turns with what inputs stop
      if (breaks(i, j) && !all[i][j].silences && takes_turns(i, j)) return {};
    }
  }
  std::vector<std::size_t> order;
  std::vector<bool> placed(count, false);
  for (std::size_t i = 0; i < count;) {
    bool free = !placed[i];
    for (std::size_t j = 0; j < count; ++j) free = free && (placed[j] || !breaks(i, j));
    if (!free) {
      ++i;
      continue;
    }
    placed[i] = true;
    order.push_back(i);
    i = 0;
  }
  return order.size() == count ? order : std::vector<std::size_t>();
}

std::string priority_of(const ir::Decision& decision, const std::vector<std::size_t>& order) {
  std::string text;
  for (const std::size_t k : order) {
    text += (text.empty() ? "`priority " : " > ") + decision.monitors[k].name;
  }
  return text.empty() ? "" : text + ";` works";
}

// A recovery, and the monitors that it may break.
struct Breach {
  std::size_t recovery;
  std::vector<std::size_t> monitors;
};

class Report {
 public:
  Report(const sema::Spec& spec, std::size_t n, const ir::Module& module, Arbitration all,
         const Try& attempt, Trials* trials, diag::Engine& diagnostics)
      : spec_(spec),
        n_(n),
        from_(spec.decisions[n]),
        module_(module),
        decision_(module.decisions[n]),
        all_(std::move(all)),
        attempt_(attempt),
        trials_(trials),
        diagnostics_(diagnostics) {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      Breach breach{i, {}};
      for (std::size_t j = 0; j < all_.size(); ++j) {
        const bool accepted = ir::acknowledged(decision_, decision_.monitors[i].recovery.name,
                                               decision_.monitors[j].name);
        if (all_[i][j].keeping == Keeping::broken && !accepted) breach.monitors.push_back(j);
      }
      if (!breach.monitors.empty()) breaches_.push_back(std::move(breach));
    }
  }

  // One report for each recovery, whatever number of monitors it may break.
  void run() {
    std::vector<diag::Diagnostic> found;
    for (const Breach& breach : breaches_) found.push_back(finding(breach));
    for (std::size_t k = 0; k < found.size(); ++k) help(breaches_[k], found, k);
    for (diag::Diagnostic& d : found) diagnostics_.report(std::move(d));
  }

 private:
  [[nodiscard]] const std::string& name(std::size_t j) const { return decision_.monitors[j].name; }

  [[nodiscard]] diag::Diagnostic finding(const Breach& breach) const {
    const std::vector<Entry>& row = all_[breach.recovery];
    const auto& broken = breach.monitors;
    std::string names;
    for (std::size_t k = 0; k < broken.size(); ++k) {
      names += (k == 0 ? "" : k + 1 == broken.size() ? " and " : ", ") + quoted(name(broken[k]));
    }
    diag::Diagnostic d{};
    d.code = diag::Code::recovery_breaks;
    d.range = spec_[from_.priority[breach.recovery]].recover_range;
    d.message =
        "while " + quoted(decision_.monitors[breach.recovery].recovery.name) + " drives, " + names +
        " may become false, and " +
        (decision_.coordinated ? "no recovery keeps it with what ranks above"
                               : "rank" + std::string(broken.size() == 1 ? "s" : "") + " lower");
    d.label = "may break " + names;
    for (const std::size_t j : broken) {
      d.notes.push_back({std::nullopt, row[j].why});
      d.notes.push_back(
          {spec_[from_.priority[j]].name_range, quoted(name(j)) + " is declared here"});
      if (!row[j].conflict.empty()) {
        d.notes.push_back({std::nullopt, conflict_text(decision_, row[j])});
      }
    }
    return d;
  }
  void help(const Breach& breach, std::vector<diag::Diagnostic>& found, std::size_t at) const {
    const std::vector<Entry>& row = all_[breach.recovery];
    std::string& text = found[at].help;
    const auto offer = [&text](const std::string& way) {
      if (!way.empty()) text += (text.empty() ? "" : ", or ") + way;
    };
    // which takes turns with nobody; after another order it may
    offer(elsewhere(breach, found[at]));
    if (!decision_.coordinated) {
      const std::vector<std::size_t> order = order_that_keeps(decision_, all_);
      if (!order.empty() && works({order}, breach, found, at)) offer(priority_of(decision_, order));
    }
    // what mends one pair alone mends nothing while there is another one
    const Entry& most = asks_most(row, breach.monitors);
    const bool all = std::ranges::all_of(breach.monitors, [&](std::size_t j) {
      return row[j].help == most.help || (landing(row[j]) && landing(most));
    });
    if (all && (!most.change || works(*most.change, breach, found, at))) offer(most.help);
    offer(slower(breach, found[at]));
    if (text.empty()) offer(needed_elsewhere(breach, found[at]));
    std::string accepted;
    for (const std::size_t j : breach.monitors) {
      accepted += (accepted.empty() ? "" : " and ") + std::string("`acknowledge ") +
                  decision_.monitors[breach.recovery].recovery.name + " may break " + name(j) +
                  " \"why\";`";
    }
    offer(accepted);
  }
  static std::optional<std::int64_t> landing(const Entry& entry) {
    if (!entry.change || !entry.change->lands) return std::nullopt;
    return entry.change->lands->second;
  }
  // Who lands as high as any of them asks for keeps all of them.
  static const Entry& asks_most(const std::vector<Entry>& row,
                                const std::vector<std::size_t>& monitors) {
    const std::size_t most =
        *std::ranges::max_element(monitors, {}, [&](std::size_t j) { return landing(row[j]); });
    return row[most];
  }
  // The greatest speed at which it breaks none of them, where they ask for less than it has.
  [[nodiscard]] std::string slower(const Breach& breach, const diag::Diagnostic& of) const {
    if (trials_ == nullptr) return "";
    const ir::Recovery& last = ir::last_step(decision_.monitors[breach.recovery].recovery);
    std::int64_t guess_mmps = last.speed_mmps;
    for (const std::size_t j : breach.monitors) {
      ir::for_each_comparison(
          decision_.monitors[j].property, [&](const ir::Block& block, const ir::AtLeast& compare) {
            const auto most = ir::upper_bound(block, compare);
            if (!most || most->leaf.kind != ir::Leaf::Kind::speed) return;
            const std::int64_t above_mmps = fastest_mmps(decision_.body, decision_.pushed_mmps,
                                                         decision_.period_us, most->most) -
                                            most->most;
            guess_mmps = std::min(guess_mmps, most->most - above_mmps);
          });
    }
    if (guess_mmps < 1 || guess_mmps >= last.speed_mmps) return "";
    return recovery_speed_that_works(
               *trials_, {fault_of(of.code, of.range), 1000, last.speed_mmps, guess_mmps, 1},
               decision_.monitors[breach.recovery].recovery.name)
        .value_or("");
  }
  // The first zone for the recovery with which it breaks none of them.
  [[nodiscard]] std::string elsewhere(const Breach& breach, const diag::Diagnostic& of) const {
    if (trials_ == nullptr) return "";  // nobody reads it
    for (const std::size_t j : breach.monitors) {
      for (const Within& each : all_[breach.recovery][j].within) {
        if (!works_elsewhere(each, breach, of).value_or(false)) continue;
        const std::string text =
            each.help.empty() ? within_what_is(each.parts) : each.help + " works";
        if (!text.empty()) return text;
      }
    }
    const Within all = in_all(breach);
    if (all.parts.empty() || !works_elsewhere(all, breach, of).value_or(false)) return "";
    return within_what_is(all.parts);
  }
  // Where none of them works alone: the narrowest one that keeps what it breaks, if it was tried.
  [[nodiscard]] std::string needed_elsewhere(const Breach& breach,
                                             const diag::Diagnostic& of) const {
    if (trials_ == nullptr) return "";
    const auto& first = all_[breach.recovery][breach.monitors.front()].within;
    const bool one = breach.monitors.size() == 1 && !first.empty();
    const Within needed = one ? first.back() : in_all(breach);
    if (needed.parts.empty() || !works_elsewhere(needed, breach, of)) return "";
    const std::string zone = written_as(*trials_, needed.parts);
    return zone.empty() ? "" : "a recovery within another zone " + needed_besides(trials_, zone);
  }
  // nullopt: it cannot be tried
  [[nodiscard]] std::optional<bool> works_elsewhere(const Within& within, const Breach& breach,
                                                    const diag::Diagnostic& of) const {
    return works_within(
        *trials_, fault_of(of.code, of.range), spec_[from_.priority[breach.recovery]].range,
        decision_.monitors[breach.recovery].recovery.name, module_, within.from, within.parts);
  }
  [[nodiscard]] std::string within_what_is(const std::vector<ZonePart>& parts) const {
    const std::string text = written_as(*trials_, parts);
    return text.empty() ? "" : "a recovery within a zone that is `" + text + "` works";
  }
  // In its own zone and in those of all that it does not keep, where they are several: others that
  // rank higher, or coordinate, among them.
  [[nodiscard]] Within in_all(const Breach& breach) const {
    Within all;
    std::size_t count = 0;
    for (const Entry& entry : all_[breach.recovery]) {
      if (entry.keeping == Keeping::kept) continue;
      if (entry.within.empty()) return {};
      const Within& shared = entry.within.back();  // the narrowest
      if (count > 0 && shared.from != all.from) return {};
      if (count == 0) all.parts.push_back({{shared.from}});
      all.from = shared.from;
      for (const ZonePart& part : shared.parts) {
        if (std::ranges::find(all.parts, part) == all.parts.end()) all.parts.push_back(part);
      }
      ++count;
    }
    return count > 1 ? all : Within{};
  }
  // What several recoveries may be offered, as an order is, is tried once.
  [[nodiscard]] const Tried& tried_of(const Change& change) const {
    if (change_ != change) tried_ = attempt_(n_, change);
    change_ = change;
    return tried_;
  }
  // The same recovery is too fast for one of the monitors all the same (5033).
  [[nodiscard]] bool is_as_fast(const diag::Diagnostic& d, const Breach& breach) const {
    if (d.recovery != decision_.monitors[breach.recovery].recovery.name || !d.range) return false;
    return std::ranges::any_of(breach.monitors, [&](std::size_t j) {
      const SourceRange& of = spec_[from_.priority[j]].range;
      return of.file == d.range->file && of.begin <= d.range->begin && d.range->begin < of.end;
    });
  }
  // Nothing is wrong with it then that is not wrong now, nothing less is shown, this is not wrong,
  // and of another order nobody waits above others for what may never come about.
  [[nodiscard]] bool works(const Change& change, const Breach& breach,
                           const std::vector<diag::Diagnostic>& found, std::size_t at) const {
    const Tried& tried = tried_of(change);
    if (!change.order.empty() && tried.waits) return false;
    if (trials_ != nullptr && !trials_->shows_no_less(tried.left)) return false;
    const auto same = [](const diag::Diagnostic& a, const diag::Diagnostic& b) {
      return a.code == b.code && a.range && b.range && a.range->file == b.range->file &&
             a.range->begin == b.range->begin;
    };
    return std::ranges::all_of(tried.errors, [&](const diag::Diagnostic& d) {
      if (same(d, found[at]) || is_as_fast(d, breach)) return false;
      const auto is_it = [&](const diag::Diagnostic& known) { return same(d, known); };
      return std::ranges::any_of(found, is_it) || std::ranges::any_of(diagnostics_.all(), is_it);
    });
  }

  const sema::Spec& spec_;
  const std::size_t n_;
  const sema::Decision& from_;
  const ir::Module& module_;
  const ir::Decision& decision_;
  const Arbitration all_;
  const Try& attempt_;
  Trials* trials_;
  diag::Engine& diagnostics_;
  std::vector<Breach> breaches_;
  mutable std::optional<Change> change_;  // that was tried last
  mutable Tried tried_;
};

}  // namespace

void check_arbitration(const sema::Spec& spec, const ir::Module& module, const ExactZone& exact,
                       const ExactSolid& solid, const Try& attempt, Trials* trials,
                       diag::Engine& diagnostics) {
  for (std::size_t n = 0; n < module.decisions.size(); ++n) {
    const ir::Decision& decision = module.decisions[n];
    if (decision.on_plan) continue;
    const sema::RobotKind& kind = spec[spec.decisions[n].kind];
    Report(spec, n, module, arbitration_of(kind, module, decision, exact, solid), attempt, trials,
           diagnostics)
        .run();
  }
}

}  // namespace rtac::analysis
