#include "compiler/analysis/site_room.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rtac::analysis {
namespace {

// Counts cells without a way in rectangles of cells.
class Blocked {
 public:
  Blocked(const ir::Cells& cells, const std::vector<std::int32_t>& cost_ppm)
      : cells_(cells), sums_(std::size_t(cells.columns + 1) * std::size_t(cells.rows + 1), 0) {
    for (std::int64_t row = 0; row < cells.rows; ++row) {
      for (std::int64_t column = 0; column < cells.columns; ++column) {
        const std::int32_t cost = cost_ppm[std::size_t(row * cells.columns + column)];
        const std::int64_t own = cost < 0 || cost >= ir::no_way ? 1 : 0;
        sum(column + 1, row + 1) =
            own + sum(column, row + 1) + sum(column + 1, row) - sum(column, row);
      }
    }
  }
  // Of the cells that come within `radius_mm` of a place, in x and y; beside the grid there are
  // none.
  [[nodiscard]] bool around(const PlaceMm& p, std::int64_t radius_mm) {
    const auto column = [&](std::int64_t x_mm) {
      return cell(x_mm - cells_.origin_x_mm, cells_.columns);
    };
    const auto row = [&](std::int64_t y_mm) {
      return cell(y_mm - cells_.origin_y_mm, cells_.rows);
    };
    const std::int64_t left = column(p.x_mm - radius_mm), right = column(p.x_mm + radius_mm) + 1;
    const std::int64_t low = row(p.y_mm - radius_mm), high = row(p.y_mm + radius_mm) + 1;
    return sum(right, high) - sum(left, high) - sum(right, low) + sum(left, low) > 0;
  }
  [[nodiscard]] PlaceMm middle(std::int64_t column, std::int64_t row) const {
    const std::int64_t half = cells_.cell_mm / 2;
    return {cells_.origin_x_mm + column * cells_.cell_mm + half,
            cells_.origin_y_mm + row * cells_.cell_mm + half};
  }

 private:
  [[nodiscard]] std::int64_t cell(std::int64_t from_origin_mm, std::int32_t count) const {
    return std::clamp<std::int64_t>(from_origin_mm / cells_.cell_mm, 0, count - 1);
  }
  std::int64_t& sum(std::int64_t column, std::int64_t row) {
    return sums_[std::size_t(row * (cells_.columns + 1) + column)];
  }
  const ir::Cells& cells_;
  std::vector<std::int64_t> sums_;
};

}  // namespace

bool goes_to_charge(const sema::RobotKind& kind, const sema::Spec& spec, const ir::Module& module,
                    const ir::Recovery& way) {
  return way.kind == ir::RecoveryKind::route && kind.energy &&
         module[way.site].name == spec[kind.energy->charge_at].name;
}

std::optional<Cramped> cramped_site(const ir::Module& module, ir::SiteIndex site,
                                    std::int64_t radius_mm) {
  const ir::Cells& cells = module[module[site].zone].cells;
  for (const ir::SiteTable::Place& place : module[site].places) {
    if (place.cost_ppm.empty()) continue;
    Blocked blocked(cells, place.cost_ppm);
    Cramped found{{place.x_mm, place.y_mm}, {}};
    if (!blocked.around(found.at, radius_mm)) continue;
    std::int64_t least = 0;
    for (std::int64_t row = 0; row < cells.rows; ++row) {
      for (std::int64_t column = 0; column < cells.columns; ++column) {
        const PlaceMm p = blocked.middle(column, row);
        const std::int64_t dx = p.x_mm - found.at.x_mm, dy = p.y_mm - found.at.y_mm;
        const std::int64_t square = dx * dx + dy * dy;  // coordinates differ by 2^30 at most
        if (found.works && square >= least) continue;
        if (blocked.around(p, radius_mm)) continue;
        found.works = p;
        least = square;
      }
    }
    return found;
  }
  return std::nullopt;
}

}  // namespace rtac::analysis
