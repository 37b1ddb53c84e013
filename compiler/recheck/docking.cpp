#include "compiler/recheck/docking.h"

#include <algorithm>
#include <variant>
#include <vector>

#include "compiler/recheck/company.h"
#include "compiler/recheck/sums.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// Of a full battery; 0: nothing is written.
Rational charged_up_to(const sema::Spec& spec, const sema::Monitor& charge) {
  Rational most = 0;
  if (charge.return_when) {
    sema::for_each_expr(*charge.return_when, [&](const sema::Expr& e) {
      if (!std::holds_alternative<sema::Compare>(e.node)) return;
      for (const bool value : {true, false}) {
        const auto limit = limit_of_one(spec, e, value);
        const bool counts = limit && limit->of.kind == Measured::Kind::battery && limit->at_least;
        if (counts && (value || !limit->strict)) most = std::max(most, limit->bound);
      }
    });
  }
  return most;
}

std::vector<sema::Point> docks_of(const sema::Spec& spec, sema::KindId kind, sema::SiteId site) {
  std::vector<sema::Point> docks;
  for (std::size_t r = 0; r < spec.robots.size(); ++r) {
    if (spec.robots[r].kind != kind) continue;
    const auto place = std::ranges::find_if(spec[site].places, [&](const sema::Site::Place& p) {
      return !p.robot || static_cast<std::size_t>(*p.robot) == r;
    });
    if (place != spec[site].places.end()) docks.push_back(place->position);
  }
  return docks;
}

}  // namespace

bool docks_for_longer(const sema::Spec& spec, const sema::Decision& decision,
                      const sema::Monitor& charge) {
  const sema::RobotKind& kind = spec[decision.kind];
  if (!kind.energy || kind.open_fleet || kind.energy->charge.value <= 0) return false;
  if (!charge.recover || !ends_charged(spec, decision, spec[*charge.recover])) return false;
  Rational apart = 0;
  bool gated = false;  // by each other: else nobody waits
  for (const sema::MonitorId id : decision.priority) {
    gated = gated || sema::speaks_of<sema::Distance>(*spec[id].always);
    const auto asked = distance_asked(spec, decision, *spec[id].always);
    if (asked) apart = std::max(apart, *asked);
  }
  if (!gated) return false;
  const Rational rounding(2, 1000);  // of two places on a grid of 1 mm
  const Rational need = std::max(Rational(2 * kind.radius.value + apart - rounding), Rational(0));
  const std::vector<sema::Point> docks = docks_of(spec, decision.kind, kind.energy->charge_at);
  std::ptrdiff_t most = 0;
  for (const sema::Point& own : docks) {
    most = std::max(most, std::ranges::count_if(docks, [&](const sema::Point& other) {
                      const Rational dx = other.x - own.x, dy = other.y - own.y;
                      return dx * dx + dy * dy < need * need;
                    }));
  }
  const Rational others(static_cast<long>(std::max<std::ptrdiff_t>(most - 1, 0)));
  return others * charged_up_to(spec, charge) > kind.energy->held.value * kind.energy->charge.value;
}

}  // namespace rtac::recheck
