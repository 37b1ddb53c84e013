// Edges of a zone in metres. Internal to this folder.
#pragma once

#include <algorithm>
#include <cstddef>

#include "rtac/zone.h"

namespace rtac::detail {

inline constexpr double m_per_mm = 1e-3;

struct Edge {
  Vec2 a, b;  // metres
};

inline Edge edge_at(const ZoneView& zone, std::size_t i) {
  const std::int32_t* e = zone.edges_mm + 4 * i;
  return {{e[0] * m_per_mm, e[1] * m_per_mm}, {e[2] * m_per_mm, e[3] * m_per_mm}};
}

inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}

inline Vec2 closest_on(const Edge& e, Vec2 p) {
  const Vec2 d = e.b - e.a;
  const double length2 = dot(d, d);
  if (length2 <= 0) return e.a;
  const double t = std::clamp(dot(p - e.a, d) / length2, 0.0, 1.0);
  return e.a + t * d;
}

inline bool segments_meet(const Edge& e, Vec2 a, Vec2 b) {
  const Vec2 d = e.b - e.a, s = b - a;
  const double a_side = cross(d, a - e.a), b_side = cross(d, b - e.a);
  const double ea_side = cross(s, e.a - a), eb_side = cross(s, e.b - a);
  if (a_side == 0 && b_side == 0) return false;  // collinear: the end points' distances decide
  return ((a_side <= 0 && b_side >= 0) || (a_side >= 0 && b_side <= 0)) &&
         ((ea_side <= 0 && eb_side >= 0) || (ea_side >= 0 && eb_side <= 0));
}

}  // namespace rtac::detail
