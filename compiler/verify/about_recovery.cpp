#include "compiler/verify/about_recovery.h"

#include <algorithm>
#include <utility>

#include "compiler/analysis/sides.h"
#include "compiler/analysis/site_room.h"
#include "compiler/analysis/superfluous.h"
#include "compiler/analysis/travel.h"
#include "compiler/ir/words.h"
#include "compiler/support/words.h"

namespace rtac::verify {

std::string reason(const ir::Decision& decision, const std::string& recovery,
                   const std::string& monitor) {
  for (const ir::Acknowledgement& a : decision.acknowledgements) {
    if (a.recovery == recovery && a.monitor == monitor) return a.reason;
  }
  return "";
}

Obligation blank(const Subject& s, std::size_t k, Kind kind) {
  Obligation o;
  o.kind = kind;
  o.monitor = s.decision.monitors[k].name;
  return o;
}

Obligation acknowledged(Obligation o, std::string why) {
  o.status = Status::acknowledged;
  o.method = "acknowledged";
  o.because = std::move(why);
  o.claims.clear();
  return o;
}

Claim recovery_claim(const Subject& s, std::size_t k) {
  const ir::Recovery& r = s.decision.monitors[k].recovery;
  return {"recovery",
          {{"decision", s.decision.name},
           {"monitor", s.decision.monitors[k].name},
           {"controller", r.name},
           {"template", ir::word_of(r.kind)}}};
}

std::string off_its_dock(const Subject& s, const ir::Recovery& last) {
  if (!last.charges) return "";
  const std::int64_t off_mm = analysis::rests_off_mm(s.decision.body);
  if (off_mm <= analysis::dock_reach_mm) return "";
  return quoted(last.name) + " may come to rest " + metres(off_mm) + " from " +
         quoted(s.module[last.site].name) +
         ", where lasting errors and pushes let it come no nearer, and it is charged within " +
         metres(analysis::dock_reach_mm);
}

Doubt falls_behind(const Subject& s, const ir::Recovery& recovery) {
  if (!s.decision.body.in_space) return {};
  const Rational most = analysis::follows_up_to(s.kind, s.decision.period_us);
  for (const ir::Recovery* step : ir::steps_of(recovery)) {
    const bool carries = ir::moves(step->kind) || step->kind == ir::RecoveryKind::land;
    const Rational speed(static_cast<long>(step->speed_mmps), 1000);
    if (!carries || speed <= most) continue;
    const std::int64_t most_mmps = std::max<std::int64_t>(floor_to_int(Rational(most * 1000)), 0);
    Doubt behind{quoted(recovery.name) + " leads the robot at " + to_decimal(speed) +
                 " m/s, and its brake is strong enough to follow at up to " +
                 to_decimal(analysis::metres_of(most_mmps)) + " m/s"};
    if (most_mmps > 0) behind.mends = {SlowerRecovery{recovery.name, most_mmps}};
    return behind;
  }
  return {};
}

Obligation doubted(Obligation o, Doubt doubt) {
  o.status = doubt.takes_a_run ? Status::refuted : Status::unknown;
  o.by_a_run = doubt.takes_a_run;
  o.method = doubt.takes_a_run ? "geometry and bounds" : "no proof";
  o.because = std::move(doubt.why);
  o.repair = std::move(doubt.repair);
  o.mends = std::move(doubt.mends);
  o.claims.clear();
  return o;
}

std::string unsound_reason(const Subject& s, std::size_t k) {
  const sema::Ahead& ahead = s.monitor(k).ahead;
  if (ahead.duration_unsound) return *ahead.duration_unsound;
  return ahead.unsound_reason;
}

Obligation unless_accepted(const Subject& s, std::size_t k, Kind kind,
                           const std::function<Obligation()>& prove) {
  const ir::Monitor& m = s.decision.monitors[k];
  const std::string why = reason(s.decision, m.recovery.name, m.name);
  if (why.empty()) return prove();
  if (analysis::leads_back_to_places(m)) {
    if (Obligation shown = prove(); shown.status == Status::proved) return shown;
  }
  return acknowledged(blank(s, k, kind), why);
}

}  // namespace rtac::verify
