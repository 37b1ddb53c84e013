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

// Of conditions that all have to come about the hardest one, of alternatives the easiest.
Awaited waited_for(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* both = std::get_if<ir::And>(&op)) {
    return std::max(waited_for(block, both->a), waited_for(block, both->b));
  }
  if (const auto* either = std::get_if<ir::Or>(&op)) {
    return std::min(waited_for(block, either->a), waited_for(block, either->b));
  }
  if (const auto* negated = std::get_if<ir::Not>(&op)) return waited_for(block, negated->a);
  if (std::holds_alternative<ir::Fact>(op)) return Awaited::inputs;
  if (const ir::Block* body = ir::body_of(op)) {
    return std::max(Awaited::robots, waited_for(*body, body->result));
  }
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  return compare != nullptr ? waited_for(block, *compare) : Awaited::nothing;
}

}  // namespace

std::string waits_until(const ir::Block& property) {
  constexpr std::array words = {"", "others have gone away", "agents have gone away",
                                "its inputs allow it", "the zone that is received allows it"};
  return words[static_cast<std::size_t>(waited_for(property, property.result))];
}

bool waits_for_outsiders(const ir::Block& property) {
  return waited_for(property, property.result) > Awaited::robots;
}

}  // namespace rtac::analysis
