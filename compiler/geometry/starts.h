// Where bodies may be: places in a region, or hardly beyond it. Internal to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"

namespace rtac::geometry {

// As far as offsets and the grid tell. In mm.
class Starts {
 public:
  explicit Starts(const Region& region);
  // Cells that cover them; nullopt: they have no end.
  [[nodiscard]] std::optional<CellGrid> cells() const;
  // Some of them may be so near.
  [[nodiscard]] bool are_near(double x_mm, double y_mm, double within_mm) const;

 private:
  // Twice that of offsets, and of the grid, so that who rounds other things finds the same.
  static constexpr std::int32_t off_mm = 9;
  struct Line {
    double ax, ay, bx, by;
  };
  std::vector<Line> lines_;
};

}  // namespace rtac::geometry
