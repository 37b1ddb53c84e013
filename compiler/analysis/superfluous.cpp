#include "compiler/analysis/superfluous.h"

#include <algorithm>

#include "compiler/analysis/fences.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/analysis/speed_limits.h"
#include "compiler/analysis/windows.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"

namespace rtac::analysis {
namespace {

class Superfluous {
 public:
  Superfluous(const Decided& of, const ExactZone& exact, const ExactSolid& solid)
      : of_(of),
        exact_(exact),
        all_(arbitration_of(of.spec[of.written.kind], of.module, of.decision, exact, solid)) {}

  [[nodiscard]] bool is(std::size_t n) const {
    const ir::Acknowledgement& a = of_.decision.acknowledgements[n];
    const auto& monitors = of_.decision.monitors;
    for (std::size_t j = 0; j < monitors.size(); ++j) {
      if (monitors[j].name != a.monitor) continue;
      if (leaves_open(monitors[j])) return false;
      for (std::size_t i = 0; i < monitors.size(); ++i) {
        if (monitors[i].recovery.name != a.recovery) continue;
        if (i == j) {
          if (!keeps_its_own(j)) return false;
          continue;
        }
        if (all_[i][j].keeping != Keeping::kept || !stays_in_all(i, monitors[j])) return false;
        if (!gives_back(i, monitors[j]) || !keeps_speed_limits(of_, i, j)) return false;
      }
    }
    return true;
  }

 private:
  // Of zones that come and go, and of agents, more is accepted than what recoveries do.
  static bool leaves_open(const ir::Monitor& m) {
    const auto& values = m.property.values;
    return std::any_of(values.begin(), values.end(), [](const ir::Value& v) {
      return std::holds_alternative<ir::ZoneThere>(v.op) ||
             std::holds_alternative<ir::AgentDistance>(v.op);
    });
  }
  // A retreat within the one zone that its monitor asks for, or a way to a site there that is not
  // to charge at: of what is plain, P2a and P2b of `rtac verify` have no doubt.
  [[nodiscard]] bool keeps_its_own(std::size_t j) const {
    const ir::Monitor& m = of_.decision.monitors[j];
    if (!leads_back_to_places(m)) return false;
    if (m.recovery.kind == ir::RecoveryKind::route && of_.spec[of_.written.kind].energy) {
      return false;
    }
    const auto zones = fences_of(m.property, of_.decision.facts.params);
    const bool own =
        std::ranges::all_of(zones, [&](ir::ZoneIndex zone) { return zone == m.recovery.zone; });
    return own && !zones.empty() && plain(m.property) && gives_back(j, m);
  }
  // In every zone that the property names, on whichever side of an `or`: `rtac verify` has no
  // doubt about it either.
  [[nodiscard]] bool stays_in_all(std::size_t i, const ir::Monitor& judged) const {
    bool all = true;
    ir::for_each_comparison(judged.property, [&](const ir::Block& block, const ir::AtLeast& c) {
      for (const auto& [leaf, coefficient] : ir::linear_form(block, c).terms) {
        const bool received = leaf.kind == ir::Leaf::Kind::received;
        if (!received && leaf.kind != ir::Leaf::Kind::clearance) continue;
        for (const ir::Recovery* step : ir::steps_of(of_.decision.monitors[i].recovery)) {
          if (ir::moves(step->kind) || step->claims) {
            all = all && !received && lies_in(step->zone, ir::ZoneIndex{leaf.table});
          }
        }
      }
    });
    return all;
  }
  // Where the recovery ends, the other monitor lets go as well: else the acknowledgement may be
  // what accepts that recoveries take turns (docs/protocol.md). As `rtac verify` finds it, of what
  // is plain.
  [[nodiscard]] bool gives_back(std::size_t i, const ir::Monitor& judged) const {
    const ir::Decision& d = of_.decision;
    if (holds_at_rest(d, judged)) return true;
    const Asks asks = asks_of(judged.property, d.facts.params);
    if (speaks_of_charge(judged.property) || asks.other) return false;
    if (!asks.clearance) return true;  // of distances: others go away
    const ir::Recovery& last = ir::last_step(d.monitors[i].recovery);
    const bool leads =
        last.kind == ir::RecoveryKind::retreat || last.kind == ir::RecoveryKind::route;
    if (!leads || d.body.in_space || !plain(judged.property) || judged.return_when) return false;
    Standoffs own;
    ask_for_standoffs(judged.property, d.facts.params, own);
    const std::int64_t need_mm =
        return_clearance_mm(d, judged.lookahead.duration_us) + own.fence_mm;
    if (need_mm > last.return_clearance_mm) return false;
    return plain(d.monitors[i].property) && !d.monitors[i].return_when &&
           ways_of(of_.module, d, last).stranded.empty();
  }
  static bool speaks_of_charge(const ir::Block& property) {
    bool found = false;
    ir::for_each_comparison(property, [&](const ir::Block& block, const ir::AtLeast& c) {
      for (const auto& [leaf, coefficient] : ir::linear_form(block, c).terms) {
        found =
            found || leaf.kind == ir::Leaf::Kind::battery || leaf.kind == ir::Leaf::Kind::energy_to;
      }
    });
    return found;
  }
  // Nothing but comparisons, all of which have to hold, and of nobody else.
  static bool plain(const ir::Block& property) {
    return std::none_of(property.values.begin(), property.values.end(), [](const ir::Value& v) {
      return std::holds_alternative<ir::Or>(v.op) || std::holds_alternative<ir::Not>(v.op) ||
             ir::body_of(v.op) != nullptr;
    });
  }
  [[nodiscard]] bool lies_in(ir::ZoneIndex inner, ir::ZoneIndex outer) const {
    if (inner == outer) return true;
    // of zones with height the matrix has said so, and `or` is rare there
    if (of_.module[inner].has_height() || of_.module[outer].has_height()) return true;
    return exact_(outer).contains(exact_(inner));
  }

  const Decided& of_;
  const ExactZone& exact_;
  const Arbitration all_;
};

}  // namespace

bool leads_back_to_places(const ir::Monitor& monitor) {
  const ir::RecoveryKind kind = monitor.recovery.kind;
  if (kind != ir::RecoveryKind::retreat && kind != ir::RecoveryKind::route) return false;
  bool some = false, only = !has_windows(monitor.property);
  ir::for_each_comparison(monitor.property, [&](const ir::Block& block, const ir::AtLeast& c) {
    for (const auto& [leaf, coefficient] : ir::linear_form(block, c).terms) {
      some = true;
      only =
          only && (leaf.kind == ir::Leaf::Kind::clearance || leaf.kind == ir::Leaf::Kind::battery ||
                   leaf.kind == ir::Leaf::Kind::energy_to);
    }
  });
  return some && only;
}

void check_acknowledgements(const sema::Spec& spec, const ir::Module& module,
                            const ExactZone& exact, const ExactSolid& solid, const HowItLies& lies,
                            diag::Engine& diagnostics) {
  for (std::size_t d = 0; d < module.decisions.size(); ++d) {
    const ir::Decision& decision = module.decisions[d];
    const sema::Decision& written = spec.decisions[d];
    if (decision.on_plan || written.acknowledgements.empty()) continue;
    const Decided decided{spec, written, module, decision, lies};
    const Superfluous superfluous(decided, exact, solid);
    for (std::size_t n = 0; n < written.acknowledgements.size(); ++n) {
      if (!superfluous.is(n)) continue;
      const ir::Acknowledgement& a = decision.acknowledgements[n];
      diagnostics.report(
          {diag::Code::acknowledge_superfluous,
           written.acknowledgements[n].range,
           quoted(a.recovery) + " keeps " + quoted(a.monitor) + ": there is nothing to acknowledge",
           "accepts what does not happen",
           {},
           "leave it out, so that a later change which breaks " + quoted(a.monitor) +
               " is an error",
           {}});
    }
  }
}

}  // namespace rtac::analysis
