#include "compiler/recheck/docking.h"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/recheck/company.h"
#include "compiler/recheck/sums.h"
#include "compiler/sema/visit.h"

namespace rtac::recheck {
namespace {

// The most charge that a comparison asks for at a dock which has to be true, or false there: from
// it no way takes any. 0: none.
Rational asked_by(const sema::Spec& spec, const sema::Compare& c, bool value) {
  using Op = sema::CompareOp;
  const bool above = (c.op == Op::greater || c.op == Op::greater_equal) == value;
  const auto sum =
      above ? difference(spec, *c.left, *c.right) : difference(spec, *c.right, *c.left);
  if (!sum || sum->terms.empty() || sum->terms.size() > 2) return 0;
  Rational battery = 0;
  for (const auto& [of, by] : sum->terms) {
    if (of.kind == Measured::Kind::battery) battery = by;
    const bool way = of.kind == Measured::Kind::energy_to && by == -1;
    if (of.kind != Measured::Kind::battery && !way) return 0;
  }
  const bool alone = sum->terms.size() == 1;
  return battery > 0 && (alone || battery == 1) ? Rational(-sum->least / battery) : Rational(0);
}

// The same of all that an expression asks for.
Rational asked_by(const sema::Spec& spec, const sema::Expr& e, bool value) {
  if (const auto* c = std::get_if<sema::Compare>(&e.node)) return asked_by(spec, *c, value);
  Rational most = 0;
  const auto* logic = std::get_if<sema::Logic>(&e.node);
  using Op = sema::LogicOp;
  const bool either = logic != nullptr && (logic->op == Op::iff || logic->op == Op::logical_xor);
  bool first = true;
  sema::for_each_operand(e, [&](const sema::ExprPtr& operand) {
    const bool turned =
        logic != nullptr &&
        (logic->op == Op::logical_not || (logic->op == Op::implies && std::exchange(first, false)));
    most = std::max(most, asked_by(spec, *operand, value != turned));
    if (either) most = std::max(most, asked_by(spec, *operand, !value));
  });
  return most;
}

// Of a full battery, by all whose recovery ends at the dock; 0: nothing is written.
Rational charged_up_to(const sema::Spec& spec, const sema::Decision& decision) {
  Rational most = 0;
  for (const sema::MonitorId id : decision.priority) {
    const sema::Monitor& m = spec[id];
    if (!m.return_when || !m.recover || !ends_charged(spec, decision, spec[*m.recover])) continue;
    most = std::max(most, asked_by(spec, *m.return_when, true));
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
  return others * charged_up_to(spec, decision) >
         kind.energy->held.value * kind.energy->charge.value;
}

}  // namespace rtac::recheck
