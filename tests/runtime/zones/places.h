// Places in a zone of many edges, and the same zone without its tree: then all edges are looked at.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "rtac/zone.h"

namespace rtac::test {

inline ZoneView without_tree(ZoneView zone) {
  zone.tree = nullptr;
  return zone;
}

class Places {
 public:
  Places(const ZoneView& zone, std::uint64_t seed) : zone_(zone), bits_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  Vec2 vertex() {
    const std::int32_t* e = zone_.edges_mm + 4 * (bits_() % zone_.edge_count);
    return {e[0] * 1e-3, e[1] * 1e-3};
  }
  // Within so many metres of the boundary.
  Vec2 near(double within_m) {
    return vertex() + Vec2{between(-within_m, within_m), between(-within_m, within_m)};
  }
  // Over the box about the zone and a quarter more on every side.
  Vec2 anywhere() {
    const double width = zone_.columns * zone_.cell_mm * 1e-3,
                 height = zone_.rows * zone_.cell_mm * 1e-3;
    return {zone_.origin_x_mm * 1e-3 + between(-0.25, 1.25) * width,
            zone_.origin_y_mm * 1e-3 + between(-0.25, 1.25) * height};
  }

 private:
  const ZoneView& zone_;
  std::mt19937_64 bits_;
};

}  // namespace rtac::test
