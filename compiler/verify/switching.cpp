// P1a, P1b, P3 and the start: what the compiler and the shape of the decision give.
#include <algorithm>

#include "compiler/support/words.h"
#include "compiler/verify/about_recovery.h"
#include "compiler/verify/atoms.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

Obligation of_monitor(const Subject& s, std::size_t k, Kind kind) {
  Obligation o;
  o.kind = kind;
  o.monitor = s.decision.monitors[k].name;
  return o;
}

}  // namespace

Claim limits_claim(const Subject& s) {
  const ir::Body& b = s.decision.body;
  const ir::Motion& any = s.decision.motions.front();
  Claim c{"limits", {{"decision", s.decision.name}}};
  const std::pair<const char*, std::int64_t> numbers[] = {
      {"period_us", s.decision.period_us},
      {"radius_mm", b.radius_mm},
      {"position_error_mm", b.position_error_mm},
      {"velocity_error_mmps", b.velocity_error_mmps},
      {"position_age_us", b.position_age_us},
      {"velocity_age_us", b.velocity_age_us},
      {"latency_us", b.latency_us},
      {"jitter_us", b.jitter_us},
      {"speed_mmps", any.speed_mmps},
      {"accel_mmps2", any.accel_mmps2},
      {"brake_mmps2", b.brake_mmps2},
      {"disturbance_mmps2", b.disturbance_mmps2},
      {"brake_lag_ms", b.brake_lag_ms},
      {"brake_lag_permille", b.brake_lag_permille},
      {"hold_mm", b.hold_mm}};
  for (const auto& [name, value] : numbers) c.values[name] = std::to_string(value);
  return c;
}

Claim with_cells(Claim claim, const ir::ZoneTable& zone, const std::string& of) {
  claim.values["cell_mm" + of] = std::to_string(zone.cells.cell_mm);
  claim.values["cells_x_mm" + of] = std::to_string(zone.cells.origin_x_mm);
  claim.values["cells_y_mm" + of] = std::to_string(zone.cells.origin_y_mm);
  return claim;
}

Claim lemma_claim(const std::string& lemma) {
  return {"lemma", {{"name", lemma}}};
}

Obligation decided_in_time(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o = of_monitor(s, k, Kind::p1a);
  o.method = "static check";
  if (m.lookahead.too_short || !m.lookahead.duration) {
    o.status = Status::acknowledged;
    o.because = "the look-ahead is declared unsound: " + unsound_reason(s, k);
    return o;
  }
  if (s.decision.body.latency_us > m.lookahead.duration_us) {
    o.status = Status::refuted;
    o.because = "a command acts " + millis(s.decision.body.latency_us) +
                " after it is decided, and " + quoted(m.name) + " looks " +
                millis(m.lookahead.duration_us) + " ahead";
    o.repair = "a latency of at most " + millis(m.lookahead.duration_us) + " is needed";
    return o;
  }
  o.status = Status::proved;
  o.because = "decided every " + millis(s.decision.period_us) + ", which a look-ahead of " +
              millis(m.lookahead.duration_us) + " covers, with " +
              millis(s.decision.body.latency_us + s.decision.body.jitter_us) +
              " until the command acts";
  o.claims.push_back({"horizon",
                      {{"decision", s.decision.name},
                       {"monitor", m.name},
                       {"lookahead_us", std::to_string(m.lookahead.duration_us)},
                       {"horizon_us", std::to_string(ir::horizon_us(s.decision, m))}}});
  return o;
}

Obligation same_output(const Subject& s) {
  Obligation o;
  o.kind = Kind::p1b;
  o.status = Status::proved;
  o.method = "static check";
  o.because =
      "all controllers of " + quoted(s.kind.name) + " command " + quoted(s.kind.output_name);
  o.claims.push_back({"output", {{"decision", s.decision.name}}});
  return o;
}

Obligation drives_until_next(const Subject& s, std::size_t k) {
  const ir::Monitor& m = s.decision.monitors[k];
  Obligation o = of_monitor(s, k, Kind::p3);
  if (m.lookahead.too_short && unsound_reason(s, k).empty()) {
    o.status = Status::unknown;
    o.method = "no proof";
    o.because = "the look-ahead is too short for the next decision";
    return o;
  }
  if (m.lookahead.too_short || !m.lookahead.duration || m.lookahead.points_only) {
    o.status = Status::acknowledged;
    o.method = "declared";
    o.because = "the look-ahead is declared unsound: " + unsound_reason(s, k);
    return o;
  }
  const Atoms atoms = atoms_of(m.property);
  o.status = Status::proved;
  o.method = "closed form";
  o.because = "control returns where the same test holds " + millis(s.decision.return_extra_us) +
              " further ahead, so that the test itself holds";
  if (atoms.received) {
    o.because += "; that the zone that was received does not change meanwhile is assumed";
  }
  o.claims.push_back(limits_claim(s));
  o.claims.push_back({"return",
                      {{"decision", s.decision.name},
                       {"monitor", m.name},
                       {"extra_us", std::to_string(s.decision.return_extra_us)},
                       {"dwell_ticks", std::to_string(s.decision.dwell_ticks)}}});
  o.claims.push_back(lemma_claim("return_implies_ahead"));
  for (const std::string& lemma : lemmas_of(atoms, s.decision, m)) {
    o.claims.push_back(lemma_claim(lemma));
  }
  return o;
}

Obligation starts_well(const Subject& s) {
  Obligation o;
  o.kind = Kind::initial;
  o.status = Status::proved;
  o.method = "by construction";
  o.because =
      "every monitor whose return set does not hold is engaged at the start, and a recovery "
      "drives: one that stands is held within " +
      metres(s.decision.standing_mm) +
      " of its place until it is led away, and where a property is false, a template that moves "
      "leads out (language rules 10 and 11)";
  const auto of_charge = [](const ir::Monitor& m) { return atoms_of(m.property).charge; };
  if (std::ranges::any_of(s.decision.monitors, of_charge)) {
    o.because +=
        "; a charge has to be enough, from the start on, for the way to where it is charged";
  }
  o.claims.push_back({"start", {{"decision", s.decision.name}}});
  return o;
}

std::vector<Obligation> plan_obligations(const Subject& s) {
  std::vector<Obligation> all = {same_output(s)};
  for (std::size_t k = 0; k < s.decision.monitors.size(); ++k) {
    Obligation kept = of_monitor(s, k, Kind::p2a);
    kept.status = Status::proved;
    kept.method = "by construction";
    kept.because = "a plan of the safe planner is judged like any other, and is not driven before";
    kept.claims.push_back({"judged", {{"decision", s.decision.name}}});
    all.push_back(kept);
    kept.kind = Kind::p3;
    kept.because = "a plan is judged whole before it is driven, and swapped whole";
    all.push_back(kept);
    kept.kind = Kind::p2b;
    kept.because = "the next plan of the advanced planner is judged anew";
    all.push_back(std::move(kept));
    all.push_back(can_hold(s, k));
  }
  return all;
}

}  // namespace rtac::verify
