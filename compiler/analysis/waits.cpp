#include "compiler/analysis/waits.h"

#include <variant>

#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

const std::string others_leave = "others have gone away";
const std::string inputs_allow = "its inputs allow it";
const std::string zone_allows = "the zone that is received allows it";

std::string waited_for(const ir::Block& block, const ir::AtLeast& compare) {
  for (const auto& [leaf, coefficient] : ir::linear_form(block, compare).terms) {
    switch (leaf.kind) {
      case ir::Leaf::Kind::distance:
      case ir::Leaf::Kind::count:
      case ir::Leaf::Kind::agent:
        return others_leave;
      case ir::Leaf::Kind::received:
        return zone_allows;
      default:
        break;
    }
  }
  return "";
}

std::string waited_for(const ir::Block& block, ir::ValueId id) {
  const ir::Op& op = block[id].op;
  if (const auto* both = std::get_if<ir::And>(&op)) {
    std::string first = waited_for(block, both->a);
    return first.empty() ? waited_for(block, both->b) : first;
  }
  if (const auto* either = std::get_if<ir::Or>(&op)) {
    return waited_for(block, either->a).empty() ? "" : waited_for(block, either->b);
  }
  if (const auto* negated = std::get_if<ir::Not>(&op)) return waited_for(block, negated->a);
  if (std::holds_alternative<ir::Fact>(op)) return inputs_allow;
  if (ir::body_of(op) != nullptr) return others_leave;
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  return compare != nullptr ? waited_for(block, *compare) : "";
}

}  // namespace

std::string waits_until(const ir::Block& property) {
  return waited_for(property, property.result);
}

}  // namespace rtac::analysis
