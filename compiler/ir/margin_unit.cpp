#include "compiler/ir/margin_unit.h"

#include <algorithm>

namespace rtac::ir {
namespace {

struct UnitOfAtom {
  const Block& block;

  std::optional<Unit> operator()(const AtLeast& v) const { return block[v.a].unit; }
  std::optional<Unit> operator()(const PlanInZone&) const { return Unit::mm; }
  std::optional<Unit> operator()(const ZoneReach&) const { return Unit::mm; }
  std::optional<Unit> operator()(const ZoneCourse&) const { return Unit::mm; }
  std::optional<Unit> operator()(const PairCourse&) const { return Unit::mm; }
  std::optional<Unit> operator()(const LegsInZone&) const { return Unit::mm; }
  std::optional<Unit> operator()(const PointsInZone&) const { return Unit::mm; }
  std::optional<Unit> operator()(const PairReach&) const { return Unit::mm; }
  std::optional<Unit> operator()(const AgentReach&) const { return Unit::mm; }
  std::optional<Unit> operator()(const ReceivedReach&) const { return Unit::mm; }
  std::optional<Unit> operator()(const ReceivedCourse&) const { return Unit::mm; }
  std::optional<Unit> operator()(const LegsApart&) const { return Unit::mm; }
  std::optional<Unit> operator()(const OnTrack&) const { return Unit::mm; }
  std::optional<Unit> operator()(const EnergyReach&) const { return Unit::ppm; }
  std::optional<Unit> operator()(const ChargeReach&) const { return Unit::ppm; }
  std::optional<Unit> operator()(const SpeedReach&) const { return Unit::mmps; }
  std::optional<Unit> operator()(const AltitudeReach&) const { return Unit::mm; }
  // quantities, constants, and what joins margins
  std::optional<Unit> operator()(const Const&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Battery&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Clearance&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Distance&) const { return std::nullopt; }
  std::optional<Unit> operator()(const AgentDistance&) const { return std::nullopt; }
  std::optional<Unit> operator()(const ReceivedClearance&) const { return std::nullopt; }
  std::optional<Unit> operator()(const EnergyTo&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Speed&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Altitude&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Add&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Negate&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Scale&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Truth&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Not&) const { return std::nullopt; }
  std::optional<Unit> operator()(const And&) const { return std::nullopt; }
  std::optional<Unit> operator()(const Or&) const { return std::nullopt; }
  std::optional<Unit> operator()(const HeldFor&) const { return std::nullopt; }
  std::optional<Unit> operator()(const ForOthers&) const { return std::nullopt; }
  std::optional<Unit> operator()(const CountOthers&) const { return std::nullopt; }
};

bool has_atoms(const Block& block, Unit unit) {
  return std::any_of(block.values.begin(), block.values.end(), [&](const Value& v) {
    const Block* others = body_of(v.op);
    return (others && std::holds_alternative<ForOthers>(v.op)) ? has_atoms(*others, unit)
                                                               : atom_unit(block, v) == unit;
  });
}

}  // namespace

std::optional<Unit> atom_unit(const Block& block, const Value& value) {
  const UnitOfAtom unit{block};
  return std::visit(
      [&](const auto& op) -> std::optional<Unit> {
        if constexpr (requires { unit(op); }) {
          return unit(op);
        } else {
          return std::nullopt;  // of monitors without a robot, which carry units of their own
        }
      },
      value.op);
}

bool has_facts(const Block& block) {
  return std::any_of(block.values.begin(), block.values.end(), [](const Value& v) {
    const Block* others = body_of(v.op);
    return others ? has_facts(*others) : std::holds_alternative<Fact>(v.op);
  });
}

bool mixes_units(const Monitor& monitor) {
  if (!monitor.ahead) return false;
  if (has_facts(*monitor.ahead)) return true;
  int units = 0;
  for (const Unit& unit : {Unit::mm, Unit::ppm, Unit::robots, Unit::mmps}) {
    units += has_atoms(*monitor.ahead, unit) ? 1 : 0;
  }
  return units > 1;
}
std::string decision_unit_text(const Monitor& monitor) {
  if (monitor.unit == Unit::robots) return "";
  if (monitor.unit == Unit::mmps) return "m/s";
  return monitor.unit == Unit::ppm ? "%" : "m";
}
bool mixes_units(const Decision& decision) {
  return std::any_of(decision.monitors.begin(), decision.monitors.end(),
                     [](const Monitor& m) { return mixes_units(m); });
}
bool mixes_units(const Module& module) {
  return std::any_of(module.decisions.begin(), module.decisions.end(),
                     [](const Decision& d) { return mixes_units(d); });
}

}  // namespace rtac::ir
