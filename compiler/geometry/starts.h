// Where bodies may be: places in a region, or hardly beyond it. Internal to this folder.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/geometry/bake.h"
#include "compiler/geometry/region.h"

namespace rtac::geometry {

class Starts {
 public:
  // Nobody is farther than `off_mm` from all of them.
  Starts(const Region& region, std::int32_t off_mm);
  // Cells that cover them; nullopt: they have no end.
  [[nodiscard]] std::optional<CellGrid> cells() const;
  // Some of them may be so near.
  [[nodiscard]] bool are_near(double x_mm, double y_mm, double within_mm) const;

 private:
  struct Line {
    double ax, ay, bx, by;
  };
  std::vector<Line> lines_;
  std::int32_t off_mm_;
};

}  // namespace rtac::geometry
