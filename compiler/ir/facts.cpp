#include "compiler/ir/facts.h"

#include <algorithm>

namespace rtac::ir {
namespace {

void collect(const Decision& decision, const Block& block, std::set<std::uint32_t>& out) {
  for (const Value& value : block.values) {
    if (const Block* others = body_of(value.op)) collect(decision, *others, out);
    const auto* fact = std::get_if<Fact>(&value.op);
    if (fact == nullptr || !out.insert(fact->index).second) continue;
    collect(decision, decision.facts.monitors[fact->index].property, out);
  }
}

}  // namespace

std::set<std::uint32_t> facts_of(const Decision& decision, const Monitor& monitor) {
  std::set<std::uint32_t> found;
  collect(decision, monitor.property, found);
  if (monitor.return_when) collect(decision, *monitor.return_when, found);
  return found;
}

bool speaks_of_robot(const PlainMonitor& fact) {
  const auto& values = fact.property.values;
  return std::any_of(values.begin(), values.end(), [](const Value& v) {
    return std::holds_alternative<Battery>(v.op) || std::holds_alternative<Speed>(v.op) ||
           std::holds_alternative<Altitude>(v.op) || std::holds_alternative<Clearance>(v.op) ||
           std::holds_alternative<EnergyTo>(v.op) || std::holds_alternative<AgentDistance>(v.op) ||
           body_of(v.op) != nullptr;
  });
}

bool has_return_conditions(const Module& module) {
  return std::any_of(module.decisions.begin(), module.decisions.end(), [](const Decision& d) {
    return std::any_of(d.monitors.begin(), d.monitors.end(),
                       [](const Monitor& m) { return m.return_when.has_value(); });
  });
}

}  // namespace rtac::ir
