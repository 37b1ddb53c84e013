#include "compiler/analysis/waits.h"

#include <algorithm>
#include <variant>

#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

const std::string others_leave = "others have gone away";
const std::string inputs_allow = "its inputs allow it";

bool is_about_others(const ir::Block& block, const ir::AtLeast& compare) {
  const auto& terms = ir::linear_form(block, compare).terms;
  return std::any_of(terms.begin(), terms.end(), [](const auto& term) {
    const ir::Leaf::Kind kind = term.first.kind;
    return kind == ir::Leaf::Kind::distance || kind == ir::Leaf::Kind::count ||
           kind == ir::Leaf::Kind::agent;
  });
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
  return compare != nullptr && is_about_others(block, *compare) ? others_leave : "";
}

}  // namespace

std::string waits_until(const ir::Block& property) {
  return waited_for(property, property.result);
}

}  // namespace rtac::analysis
