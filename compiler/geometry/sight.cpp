#include "compiler/geometry/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/geometry/connectors.h"

namespace rtac::geometry {
namespace {

// A cell is cut into four, its quarters again, at most so often.
constexpr int halvings_max = 6;
// Of what the recovery forgives a leg (loss_m of runtime/core/space.cpp), 1 mm is left for the
// resolution of the grid.
constexpr double forgiven_mm = 1;
constexpr std::int64_t looks_max = 400'000'000;

class Looking {
 public:
  Looking(const std::vector<EdgeRow>& edges, const CellGrid& cells, const SightQuery& query)
      : cells_(cells),
        query_(query),
        size_(cells.cell_mm),
        connectors_(edges, query.clearance_mm, query.body_mm, forgiven_mm) {}

  Sight run() {
    for (int row = 0; row < cells_.rows; ++row) {
      for (int column = 0; column < cells_.columns; ++column) {
        const std::int32_t clearance = clearance_at(column, row);
        if (clearance < 0 || clearance >= query_.aim_mm) continue;
        const bool seen = sees(column, row);
        if (looks_ > looks_max) return {Sight::How::too_large, {}};
        if (!seen) return {Sight::How::hidden, middle_of(column, row)};
      }
    }
    return {};
  }

 private:
  [[nodiscard]] std::int32_t clearance_at(int column, int row) const {
    return cells_
        .clearance_mm_lo[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_.columns) +
                         static_cast<std::size_t>(column)];
  }
  [[nodiscard]] double x_of(int column) const {
    return cells_.origin.x_mm + (column + 0.5) * size_;
  }
  [[nodiscard]] double y_of(int row) const { return cells_.origin.y_mm + (row + 0.5) * size_; }
  [[nodiscard]] GridPoint middle_of(int column, int row) const {
    return {static_cast<std::int32_t>(x_of(column)), static_cast<std::int32_t>(y_of(row))};
  }

  // The cells with room that may be the nearest ones from somewhere in a cell.
  std::vector<Landing> nearest_to(int column, int row) {
    std::vector<Landing> found;
    double nearest = std::numeric_limits<double>::infinity();
    const int most = std::max(cells_.columns, cells_.rows);
    // `rest_mm`: from the middle of the cell
    for (int ring = 1; ring <= most && (ring - 2) * size_ <= nearest; ++ring) {
      for (int r = row - ring; r <= row + ring; ++r) {
        if (r < 0 || r >= cells_.rows) continue;
        const bool side = std::abs(r - row) == ring;
        for (int c = column - ring; c <= column + ring; c += side ? 1 : 2 * ring) {
          if (c < 0 || c >= cells_.columns) continue;
          ++looks_;
          if (clearance_at(c, r) < query_.aim_mm) continue;
          const double way = std::hypot((c - column) * size_, (r - row) * size_);
          found.push_back({x_of(c), y_of(r), way});
          nearest = std::min(nearest, way);
        }
      }
      if (looks_ > looks_max) return {};
    }
    // from elsewhere in the cell a way is no more than half a diagonal longer, or shorter
    std::erase_if(found, [&](const Landing& l) { return l.rest_mm > nearest + 1.5 * size_; });
    return found;
  }

  bool sees(int column, int row) {
    const std::vector<Landing> landings = nearest_to(column, row);
    double reach = 0;
    for (const Landing& l : landings) reach = std::max(reach, l.rest_mm);
    const Connectors::Spot spot =
        connectors_.look_around(x_of(column) - size_ / 2, y_of(row) - size_ / 2, size_, reach);
    return sees_from(spot, landings, halvings_max);
  }
  bool sees_from(const Connectors::Spot& spot, const std::vector<Landing>& landings, int halvings) {
    if (connectors_.holds_nobody(spot)) return true;
    if (spot.gap_mm - spot.radius_mm() >= query_.aim_mm) return true;  // all of it has room
    if (landings.empty() || looks_ > looks_max) return false;
    const auto way_to = [&](const Landing& l) {
      return std::hypot(l.x_mm - spot.x_mm, l.y_mm - spot.y_mm);
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (const Landing& l : landings) nearest = std::min(nearest, way_to(l));
    const double tried = nearest + 2 * spot.radius_mm() + 1e-3;
    looks_ += 20 * static_cast<std::int64_t>(landings.size());
    const bool all = std::all_of(landings.begin(), landings.end(), [&](const Landing& l) {
      return way_to(l) > tried || connectors_.is_sound(spot, l);
    });
    if (all) return true;
    if (halvings == 0) return false;
    const auto parts = connectors_.quarters(spot);
    return std::all_of(parts.begin(), parts.end(), [&](const Connectors::Spot& part) {
      return sees_from(part, landings, halvings - 1);
    });
  }

  const CellGrid& cells_;
  const SightQuery query_;
  const double size_;
  Connectors connectors_;
  std::int64_t looks_ = 0;
};

}  // namespace

Sight sight(const std::vector<EdgeRow>& edges, const CellGrid& cells, const SightQuery& query) {
  return Looking(edges, cells, query).run();
}

}  // namespace rtac::geometry
