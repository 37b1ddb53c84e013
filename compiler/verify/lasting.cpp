// What `held` and `detour` of the energy clause stand for, with what it was found from.
#include <map>
#include <string>

#include "compiler/analysis/keeps_off.h"
#include "compiler/analysis/limits.h"
#include "compiler/analysis/liveness.h"
#include "compiler/support/rational.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {
namespace {

std::string text(std::int64_t n) {
  return std::to_string(n);
}

}  // namespace

Claim with_ways(const Subject& s, Claim claim, const ir::Recovery& last) {
  const ir::Body& body = s.decision.body;
  const ir::ZoneTable& zone = s.module[last.zone];
  const std::int64_t keeps_mm = analysis::starts_off_mm(s.decision, last);
  const std::int64_t aim_mm = last.return_clearance_mm + body.end_reach_mm + body.position_error_mm;
  claim = with_cells(std::move(claim), zone);
  claim.values.merge(
      std::map<std::string, std::string>{{"zone", zone.name},
                                         {"starts_mm", text(body.radius_mm + keeps_mm)},
                                         {"route_mm", text(last.route_clearance_mm)},
                                         {"return_mm", text(last.return_clearance_mm)},
                                         {"aim_mm", text(aim_mm)}});
  if (zone.tree.exact_inside_mm) claim.values["exact_mm"] = text(*zone.tree.exact_inside_mm);
  return claim;
}

std::optional<Claim> lasting_claim(const Subject& s, std::size_t k) {
  if (!s.kind.energy) return std::nullopt;
  const ir::Monitor& m = s.decision.monitors[k];
  const ir::Recovery& last = ir::last_step(m.recovery);
  const auto end = analysis::ending_of(s.kind, s.module, s.decision, m.recovery);
  if (!end) return std::nullopt;
  // of an `or` that is kept on one side, it may be more than is reckoned with
  if (end->seconds > s.kind.energy->held.value) return std::nullopt;
  if (end->metres > s.kind.energy->detour.value) return std::nullopt;
  const Claim lasts{"lasts",
                    {{"decision", s.decision.name},
                     {"monitor", m.name},
                     {"held_us", text(ceil_to_int(Rational(end->seconds * 1'000'000)))},
                     {"driven_mm", text(ceil_to_int(Rational(end->metres * 1000)))},
                     {"extra_us", text(s.decision.return_extra_us)}}};
  if (!ir::moves(last.kind)) return lasts;
  Claim claim = with_ways(s, lasts, last);
  const analysis::Ways ways = analysis::ways_of(s.module, s.decision, last);
  claim.values["way_mm"] = text(ways.longest_mm.value_or(0));
  if (const auto leg_mm = analysis::straight_mm(s.module, s.decision, last)) {
    claim.values["leg_mm"] = text(*leg_mm);
  }
  if (end->legs) {
    claim.values["legs"] = text(end->legs->count);
    claim.values["led_in_mm"] = text(end->legs->led_in_mm);
  }
  return claim;
}

}  // namespace rtac::verify
