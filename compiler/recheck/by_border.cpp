#include "compiler/recheck/by_border.h"

#include <algorithm>
#include <variant>

#include "compiler/recheck/coming_in.h"
#include "compiler/recheck/company.h"
#include "compiler/recheck/numbers.h"
#include "compiler/recheck/return_when.h"
#include "compiler/recheck/travel.h"
#include "compiler/recheck/ways_said.h"
#include "compiler/sema/templates.h"

namespace rtac::recheck {
namespace {

// Why it is not as clear as said where it sets out, or may go elsewhere.
std::optional<Doubt> sets_out(const sema::Spec& spec, const sema::Decision& d, Claims& claims,
                              const sema::Monitor& driving, const Said& said,
                              const Rational& extra) {
  if (said.back < claims.return_clearance(d, said.zone, extra) ||
      said.back < claims.return_clearance(d, driving, extra)) {
    return wrong("it leads deeper before control is given back");
  }
  for (const sema::MonitorId id : d.priority) {
    const sema::Monitor& m = spec[id];
    if (m.recover != driving.recover || m.return_when == nullptr) continue;
    if (!lets_go(spec, d, claims, m, said.back)) {
      return wrong("`return when` of `" + m.name + "` may have it led deeper");
    }
  }
  return std::nullopt;
}

// How far from the border its ways lead, but for what it strays by; nullopt: that is not known, or
// they may be longer than is claimed.
std::optional<Rational> deepest_of(const geometry::Region& zone, const Said& said,
                                   const sema::RobotKind& kind, const sema::Decision& d,
                                   const sema::Controller& recovery, const Rational& keeps,
                                   const Values& v) {
  const sema::Template last = sema::templates_of(recovery).back();
  const auto led_in_mm = number(v, "led_in_mm");
  const auto in = led_in(zone, said, kind, last, keeps);
  if (!led_in_mm || !in || std::max(in->first, in->all) > milli(*led_in_mm)) return std::nullopt;
  const Rational led = kind.radius.value + milli(*led_in_mm);
  const auto run_out = driven_metres(kind, d, recovery, std::nullopt, 0, 0);
  if (!run_out) return std::nullopt;
  if (const auto leg_mm = number(v, "leg_mm"), deepest_mm = number(v, "deepest_mm");
      leg_mm && deepest_mm) {
    const Rational deepest = milli(*deepest_mm);
    if (!takes_legs(zone, said, kind, last, milli(*leg_mm), deepest)) return std::nullopt;
    return std::max(deepest, led) + *run_out;
  }
  const auto way = longest(zone, said, {}, last);
  if (!way || *way > said.way) return std::nullopt;
  const Rational joined = joined_way(said.way, milli(said.cells.cell_mm));
  return std::max(Rational(said.back + joined), led) + *run_out;
}

}  // namespace

std::optional<Doubt> check_by_border(const sema::Spec& spec, const sema::Decision& decision,
                                     Claims& claims, const Values& v) {
  const sema::RobotKind& kind = spec[decision.kind];
  const sema::Monitor* const driving = monitor_of(spec, decision, text(v, "monitor"));
  const sema::Monitor* const judged = monitor_of(spec, decision, text(v, "judged"));
  const auto near_mm = number(v, "near_mm"), extra_us = number(v, "extra_us");
  const auto said = said_of(claims, v);
  const auto outer = claims.zones().find(text(v, "outer"));
  if (driving == nullptr || judged == nullptr || !driving->recover || !near_mm || !extra_us ||
      !said || !outer) {
    return wrong("no such monitor or zone, or a number is missing");
  }
  const sema::Controller& recovery = spec[*driving->recover];
  const auto* const retreat = std::get_if<sema::Retreat>(&recovery.implementation);
  if (retreat == nullptr || retreat->zone != said->zone || kind.in_space) {
    return wrong("it is no retreat of the plane within that zone");
  }
  if (!is_alone(spec, decision)) return wrong("others may stand in its way");
  const geometry::Region* const zone = claims.zones().region(said->zone);
  const geometry::Region* const fence = claims.zones().region(*outer);
  if (zone == nullptr || fence == nullptr) return Doubt{false, "a zone is not known"};
  if (!starts_within(spec, decision, claims, *judged, said->zone)) {
    return wrong("it may begin outside of its zone");
  }
  if (auto doubt = sets_out(spec, decision, claims, *driving, *said, micro(*extra_us)))
    return doubt;
  if (said->route < claims.leg_clearance(decision, *driving, said->zone)) return wrong(too_near);
  const Rational keeps = relied_on(spec, decision, *driving)
                             ? sure_gap_of(spec, *driving->always, said->zone)
                             : Rational(0);
  const Rational step(1, 1000), error = kind.position ? kind.position->error.value : Rational(0);
  if (said->starts > kind.radius.value + keeps + 2 * step) {
    return wrong("it leaves out places that a body fits");
  }
  if (said->aim < said->back + std::max(Rational(1, 50), error) + error) {
    return wrong("it aims deeper");
  }
  const auto deepest = deepest_of(*zone, *said, kind, decision, recovery, keeps, v);
  if (!deepest) return wrong("its way may be longer");
  const Numbers n = numbers_of(spec, decision, jitter_of(spec, decision));
  const Rational off =
      beside_way(kind, decision, retreat->speed.value) + n.sway + n.hold + 3 * error;
  if (milli(*near_mm) < *deepest + off + kind.radius.value) {
    return wrong("it may drive farther from the border");
  }
  const auto middle = zone->offset(-milli(*near_mm));
  const auto standoff = v.contains("standoff_mm") ? number(v, "standoff_mm") : 0;
  if (!middle || !standoff || *standoff < 0) return wrong("the standoff is no number");
  const auto kept = fence->offset(-without_excess(milli(*standoff)));
  if (kept && kept->contains(zone->subtract(*middle))) return std::nullopt;
  return wrong("what is as near to the border is not contained");
}

}  // namespace rtac::recheck
