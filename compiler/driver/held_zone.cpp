#include "compiler/driver/held_zone.h"

#include <cstddef>
#include <utility>

namespace rtac::driver {
namespace {

std::vector<std::int32_t> numbers_of(const geometry::OutlineTable& table) {
  std::vector<std::int32_t> numbers;
  for (const geometry::EdgeRow& e : table.edges) {
    numbers.insert(numbers.end(), {e.a.x_mm, e.a.y_mm, e.b.x_mm, e.b.y_mm, e.ux_q30, e.uy_q30});
  }
  return numbers;
}
HeldZone::Outline outline_of(const geometry::OutlineTable& table,
                             const std::vector<std::int32_t>& edges) {
  const geometry::CellTree& t = table.tree;
  const auto count = [](std::size_t n) { return static_cast<std::int32_t>(n); };
  return {edges.data(),
          t.words.data(),
          t.lists.data(),
          count(table.edges.size()),
          count(t.words.size()),
          count(t.lists.size()),
          t.x_mm,
          t.y_mm,
          t.shift,
          t.column,
          t.row,
          t.columns,
          t.rows,
          t.depth,
          t.leaves};
}

}  // namespace

void HeldZone::hold(std::shared_ptr<const interp::ReceivedZone> received) {
  received_ = std::move(received);
  const geometry::ZoneTables& tables = received_->tables;
  within_ = numbers_of(tables.within);
  zone_ = {};
  zone_.within = zone_.around = outline_of(tables.within, within_);
  if (!tables.around) return;
  around_ = numbers_of(*tables.around);
  zone_.around = outline_of(*tables.around, around_);
}

}  // namespace rtac::driver
