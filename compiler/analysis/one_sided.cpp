#include "compiler/analysis/one_sided.h"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace rtac::analysis {

bool OneSided::none(sema::ZoneId id) {
  std::optional<bool>& known = known_[static_cast<std::uint32_t>(id)];
  if (!known) {
    known = false;  // of one that depends on itself, which is reported
    const sema::ZoneExprPtr& value = spec_[id].value;
    known = value != nullptr && none_in(*value);
  }
  return *known;
}

bool OneSided::none_in(const sema::ZoneExpr& e) {
  return std::visit([&](const auto& node) { return none(node); }, e.node);
}

bool OneSided::none(const sema::ZoneImport& import) {
  const auto straight = [](const sema::ZoneImport::Area& area) {
    return std::ranges::all_of(area.parts, [](const auto& part) {
      return std::holds_alternative<sema::ZonePolygon>(part);
    });
  };
  const auto all_straight = [&](const auto& areas) { return std::ranges::all_of(areas, straight); };
  return sgn(import.error) == 0 && std::ranges::all_of(import.inclusions, all_straight) &&
         all_straight(import.exclusions);
}

}  // namespace rtac::analysis
