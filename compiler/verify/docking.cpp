#include "compiler/verify/docking.h"

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/analysis/site_room.h"
#include "compiler/ir/linear.h"
#include "compiler/support/words.h"

namespace rtac::verify {
namespace {

constexpr std::int64_t full_ppm = 1'000'000;

bool is_charged_by(const ir::Monitor& m) {
  const ir::Recovery& way = ir::last_step(m.recovery);
  return way.kind == ir::RecoveryKind::route && way.charges;
}

// What keeps robots there: of all that is written in the `return when` of who is charged the most,
// at the dock, from where no way takes any charge; 0: nothing is.
std::int64_t charged_level_ppm(const ir::Decision& decision) {
  const auto& params = decision.facts.params;
  std::int64_t level_ppm = 0;
  const auto read = [&](const ir::Block& block, const ir::AtLeast& compare) {
    const auto least = ir::lower_bound(block, compare, params);
    if (least && least->leaf.kind == ir::Leaf::Kind::battery) {
      level_ppm = std::max(level_ppm, least->need.strictest);
    } else if (const auto way = ir::charge_for_way(block, compare, params)) {
      level_ppm = std::max(level_ppm, way->reserve.strictest);
    }
  };
  for (const ir::Monitor& m : decision.monitors) {
    if (is_charged_by(m) && m.return_when) ir::for_each_comparison(*m.return_when, read);
  }
  return level_ppm;
}

void find_busiest(const Subject& s, const ir::SiteTable& docks, Docking& docking) {
  const std::int64_t need_mm = analysis::at_once_mm(s.decision);
  for (const ir::SiteTable::Place& own : docks.places) {
    const auto near = std::ranges::count_if(docks.places, [&](const ir::SiteTable::Place& other) {
      return analysis::square_mm2(own, other) < need_mm * need_mm;
    });
    if (near - 1 <= docking.before) continue;  // it counts itself
    docking.before = near - 1;
    docking.robot = own.robot;
    docking.at_mm = {own.x_mm, own.y_mm};
  }
}

std::int64_t seconds_to_charge(const sema::Energy& energy, std::int64_t level_ppm) {
  return ceil_to_int(Rational(Rational(level_ppm, full_ppm) / energy.charge.value));
}

}  // namespace

Docking docking_of(const Subject& s, const ir::Monitor& charge) {
  const sema::Energy& energy = *s.kind.energy;
  if (s.decision.open_fleet || energy.charge.value <= 0 || !is_charged_by(charge)) return {};
  const ir::SiteTable& docks = s.module[ir::last_step(charge.recovery).site];
  Docking docking;
  docking.site = docks.name;
  find_busiest(s, docks, docking);
  docking.level_ppm = charged_level_ppm(s.decision);
  docking.each_s = seconds_to_charge(energy, docking.level_ppm);
  return docking;
}

std::vector<Mend> longer_waits(const Subject& s, const Docking& docking) {
  std::vector<Mend> all;
  const sema::Energy& energy = *s.kind.energy;
  if (s.decision.open_fleet || energy.charge.value <= 0) return all;
  const std::int64_t before = docking.in_turn() ? docking.before : s.decision.robots - 1;
  const std::int64_t each_s =
      docking.each_s > 0 ? docking.each_s : seconds_to_charge(energy, full_ppm);
  for (const std::int64_t times : {1, 2}) {
    const std::int64_t wait_s = times * before * each_s;
    if (wait_s > energy.held.value) all.emplace_back(LongerWait{s.kind.name, wait_s});
  }
  return all;
}

Obligation held_for_too_long(const Subject& s, const Docking& docking, Obligation o) {
  const std::string wait = seconds(docking.wait_s());
  o.status = Status::refuted;
  o.by_a_run = true;
  o.because += "; they may do so for " + wait + ": at " + quoted(docking.site) + " it waits for " +
               (docking.before == 1 ? "another robot, which is"
                                    : std::to_string(docking.before) + " others, each of them") +
               " charged up to " + percent(docking.level_ppm) + " before it";
  o.or_else = "`held <= " + wait + "` in " + quoted(s.kind.name) + ", or places of " +
              quoted(docking.site) + " that are at least " +
              metres(analysis::at_once_mm(s.decision)) + " apart, are needed";
  return o;
}

}  // namespace rtac::verify
