#include "compiler/geometry/cell_need.h"

#include <algorithm>
#include <cmath>

namespace rtac::geometry {
namespace {

// The part [from, to] of an edge, of [0, 1], whose coordinate lies in [low, high].
void clip(double at, double along, double low, double high, double& from, double& to) {
  if (along == 0) return;  // level with the square, which the edge meets
  const double first = (low - at) / along, second = (high - at) / along;
  from = std::max(from, std::min(first, second));
  to = std::min(to, std::max(first, second));
}

// Less than 1e-9 of it is lost to the rounding of doubles, and less than 1e-6 of the side.
double length_within(const Square& s, const PreparedEdge& e) {
  double from = 0, to = 1;
  const auto side = static_cast<double>(s.side_mm);
  clip(static_cast<double>(e.ax - s.x_mm), static_cast<double>(e.dx), 0, side, from, to);
  clip(static_cast<double>(e.ay - s.y_mm), static_cast<double>(e.dy), 0, side, from, to);
  const double length = std::sqrt(static_cast<double>(e.squared_length)) * (to - from);
  return std::max(0.0, length * (1 - 1e-9) - side * 1e-6);
}

}  // namespace

Met met_by(const Square& square, const std::vector<PreparedEdge>& edges,
           const std::vector<std::uint32_t>& near) {
  Met met;
  for (const std::uint32_t index : near) {
    if (!meets_closed(square, edges[index])) continue;
    ++met.edges;
    met.length_mm += length_within(square, edges[index]);
  }
  return met;
}

double cells_due(const Square& square, const Met& met, std::size_t edges_max) {
  const auto most = static_cast<double>(edges_max);
  const double by_length = met.length_mm / (most * std::sqrt(2.0) * double(square.side_mm));
  const double cells = std::max(static_cast<double>(met.edges) / most, by_length * by_length);
  return std::max(1.0, cells * (1 - 1e-6));
}

std::size_t divisions_due(double cells, double from) {
  return static_cast<std::size_t>(std::ceil(std::max(0.0, cells - from) / 15));
}

}  // namespace rtac::geometry
