#include "compiler/codegen/fleet_index.h"

#include <algorithm>

namespace rtac::codegen {
namespace {

using ir::Block;
using ir::Value;

constexpr std::uint32_t fleet_from = 6;

bool of_distance(const Block& block) {
  return std::all_of(block.values.begin(), block.values.end(), [&](const Value& v) {
    if (const auto* compared = std::get_if<ir::AtLeast>(&v.op)) {
      return std::holds_alternative<ir::Distance>(block[compared->a].op) &&
             std::holds_alternative<ir::Const>(block[compared->b].op);
    }
    const auto* pair = std::get_if<ir::PairReach>(&v.op);
    return std::holds_alternative<ir::Distance>(v.op) || std::holds_alternative<ir::Const>(v.op) ||
           (pair != nullptr && !pair->more);
  });
}

// Robots that are joined by the smallest margin.
bool by_the_nearest(const Block& block) {
  return std::all_of(block.values.begin(), block.values.end(), [](const Value& v) {
    const auto* others = std::get_if<ir::ForOthers>(&v.op);
    return body_of(v.op) == nullptr ||
           (others != nullptr && others->universal && of_distance(*others->body));
  });
}

}  // namespace

bool leaves_far_out(const ir::Decision& decision) {
  if (decision.robots < fleet_from || judges_commands(decision)) return false;
  const auto& facts = decision.facts.monitors;
  return std::all_of(facts.begin(), facts.end(),
                     [](const ir::PlainMonitor& fact) {
                       const auto& values = fact.property.values;
                       return std::all_of(values.begin(), values.end(),
                                          [](const Value& v) { return body_of(v.op) == nullptr; });
                     }) &&
         std::all_of(decision.monitors.begin(), decision.monitors.end(), [](const ir::Monitor& m) {
           return by_the_nearest(m.property) && (!m.ahead || by_the_nearest(*m.ahead)) &&
                  (!m.return_when || by_the_nearest(*m.return_when));
         });
}

}  // namespace rtac::codegen
