#include "compiler/sema/nested_offsets.h"

#include <algorithm>
#include <variant>

namespace rtac::sema {
namespace {

// What a zone is made of, by name as well.
template <class Visit>
void for_each_part(const Spec& spec, const ZoneExpr& expr, Visit&& visit) {
  if (const auto* reference = std::get_if<ZoneRef>(&expr.node)) {
    visit(*spec[reference->zone].value);
  } else if (const auto* complement = std::get_if<ZoneComplement>(&expr.node)) {
    visit(*spec[complement->zone].value);
  } else if (const auto* binary = std::get_if<ZoneBinary>(&expr.node)) {
    visit(*binary->left);
    visit(*binary->right);
  } else if (const auto* offset = std::get_if<ZoneOffset>(&expr.node)) {
    visit(*offset->operand);
  } else if (const auto* prism = std::get_if<ZonePrism>(&expr.node)) {
    visit(*prism->base);
  }
}

}  // namespace

NestedOffsets::NestedOffsets(const Spec& spec) : spec_(spec) {
  for (const Zone& zone : spec.zones) count(*zone.value, 0);
}

std::size_t NestedOffsets::within(const ZoneExpr& expr) {
  if (const auto known = within_.find(&expr); known != within_.end()) return known->second;
  std::size_t most = 0;
  for_each_part(spec_, expr, [&](const ZoneExpr& part) { most = std::max(most, within(part)); });
  if (std::holds_alternative<ZoneOffset>(expr.node)) ++most;
  return within_[&expr] = most;
}

// An expression is gone through again only where more offsets are around it than before.
void NestedOffsets::count(const ZoneExpr& expr, std::size_t around) {
  const auto [known, is_first] = around_.try_emplace(&expr, around);
  if (!is_first && known->second >= around) return;
  known->second = around;
  if (const auto* offset = std::get_if<ZoneOffset>(&expr.node)) {
    most_[offset] = around + within(expr);
    ++around;
  }
  for_each_part(spec_, expr, [&](const ZoneExpr& part) { count(part, around); });
}

}  // namespace rtac::sema
