#include "compiler/analysis/waits.h"

#include <algorithm>
#include <array>
#include <variant>

#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

// From what a recovery brings about itself to what no decision has a hand in.
enum class Awaited { nothing, robots, agents, inputs, zone };

Awaited waited_for(const ir::Block& block, const ir::AtLeast& compare) {
  for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
    switch (leaf.kind) {
      case ir::Leaf::Kind::distance:
      case ir::Leaf::Kind::count:
        return Awaited::robots;
      case ir::Leaf::Kind::agent:
        return Awaited::agents;
      case ir::Leaf::Kind::received:
        return Awaited::zone;
      default:
        break;
    }
  }
  return Awaited::nothing;
}

// For it to become `value`. Of conditions that all have to come about the hardest one, of
// alternatives the easiest: what is denied of an `or` is denied of each side, and of an `and` of
// one.
Awaited waited_for(const ir::Block& block, ir::ValueId id, bool value) {
  const ir::Op& op = block[id].op;
  const auto of_both = [&](ir::ValueId a, ir::ValueId b, bool both) {
    const Awaited first = waited_for(block, a, value), second = waited_for(block, b, value);
    return both ? std::max(first, second) : std::min(first, second);
  };
  if (const auto* v = std::get_if<ir::And>(&op)) return of_both(v->a, v->b, value);
  if (const auto* v = std::get_if<ir::Or>(&op)) return of_both(v->a, v->b, !value);
  if (const auto* v = std::get_if<ir::Not>(&op)) return waited_for(block, v->a, !value);
  if (std::holds_alternative<ir::Fact>(op)) return Awaited::inputs;
  if (const ir::Block* body = ir::body_of(op)) {
    return std::max(Awaited::robots, waited_for(*body, body->result, value));
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  return compare != nullptr ? waited_for(block, *compare) : Awaited::nothing;
}

}  // namespace

std::string waits_until(const ir::Block& property) {
  constexpr std::array words = {"", "others have gone away", "agents have gone away",
                                "its inputs allow it", "the zone that is received allows it"};
  return words[static_cast<std::size_t>(waited_for(property, property.result, true))];
}

bool waits_for_outsiders(const ir::Block& property) {
  return waited_for(property, property.result, true) > Awaited::robots;
}

bool waits_for_inputs(const ir::Block& property) {
  return waited_for(property, property.result, true) == Awaited::inputs;
}

}  // namespace rtac::analysis
