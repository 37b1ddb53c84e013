// How a box of grid lines lies to a zone, exactly: the box may have no width.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/kernel/zones/exact_zone.h"

namespace rtac::kernel_test {

using Box = probe_box;

struct Fraction {
  Wide num, den;  // den > 0
};
inline Fraction fraction(Wide num, Wide den) {
  return den < 0 ? Fraction{-num, -den} : Fraction{num, den};
}
inline bool operator<(const Fraction& a, const Fraction& b) {
  return a.num * b.den < b.num * a.den;
}

// Whether part of the edge lies strictly within a box with area: the values of t for which
// a + t (b - a) does are open at the sides of the box, and closed at 0 and 1.
inline bool enters(const Edge& e, const Box& b) {
  Fraction from{-1, 1}, to{2, 1};
  const auto between = [&](std::int64_t low, std::int64_t start, std::int64_t end,
                           std::int64_t high) {
    const std::int64_t d = end - start;
    if (d == 0) return low < start && start < high;
    const Fraction one = fraction(low - start, d), other = fraction(high - start, d);
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
    return true;
  };
  return between(b.x0, e.a.x, e.b.x, b.x1) && between(b.y0, e.a.y, e.b.y, b.y1) && from < to &&
         from < Fraction{1, 1} && Fraction{0, 1} < to;
}
inline bool touches(const Edge& e, const Box& b) {
  const Place p{b.x0, b.y0}, q{b.x1, b.y0}, r{b.x1, b.y1}, s{b.x0, b.y1};
  const bool holds = e.a.x >= b.x0 && e.a.x <= b.x1 && e.a.y >= b.y0 && e.a.y <= b.y1;
  return holds || meet(e, {p, q}) || meet(e, {q, r}) || meet(e, {r, s}) || meet(e, {s, p});
}

// `where` of the place (x, y) / den, for x and y below 2^94.
inline int where(const std::vector<Edge>& edges, Wide x, Wide y, Wide den) {
  int winding = 0;
  for (const Edge& e : edges) {
    const Wide c =
        Wide(e.b.x - e.a.x) * (y - e.a.y * den) - Wide(e.b.y - e.a.y) * (x - e.a.x * den);
    const auto within = [&](std::int64_t a, std::int64_t b, Wide v) {
      return std::min(a, b) * den <= v && v <= std::max(a, b) * den;
    };
    if (c == 0 && within(e.a.x, e.b.x, x) && within(e.a.y, e.b.y, y)) return 0;
    if (e.a.y * den <= y && e.b.y * den > y && c > 0) ++winding;
    if (e.a.y * den > y && e.b.y * den <= y && c < 0) --winding;
  }
  return winding != 0 ? 1 : -1;
}

// A box without height, between the places where edges cross its line: all of what is between two
// of them lies on one side.
inline int flat_box_in(const std::vector<Edge>& edges, const Box& b) {
  std::vector<Fraction> cuts{{b.x0, 1}, {b.x1, 1}};
  for (const Edge& e : edges) {
    if (std::min(e.a.y, e.b.y) > b.y0 || std::max(e.a.y, e.b.y) < b.y0) continue;
    if (e.a.y == e.b.y) {
      cuts.insert(cuts.end(), {{e.a.x, 1}, {e.b.x, 1}});
    } else {
      const std::int64_t dy = e.b.y - e.a.y;
      cuts.push_back(fraction(Wide(e.a.x) * dy + Wide(e.b.x - e.a.x) * (b.y0 - e.a.y), dy));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  bool in = false, out = false;
  const auto look = [&](Wide x, Wide y, Wide den) {
    if (x < b.x0 * den || x > b.x1 * den) return;
    (where(edges, x, y, den) >= 0 ? in : out) = true;
  };
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    look(cuts[i].num, b.y0 * cuts[i].den, cuts[i].den);
    if (i == 0 || !(cuts[i - 1] < cuts[i])) continue;
    const Wide den = 2 * cuts[i - 1].den * cuts[i].den;
    look(cuts[i - 1].num * cuts[i].den + cuts[i].num * cuts[i - 1].den, b.y0 * den, den);
  }
  return out ? (in ? 0 : -1) : 1;
}

// 1: all of the box lies in the zone, boundary included; -1: none of it does; 0: neither.
inline int box_in(const std::vector<Edge>& edges, const Box& b) {
  if (b.y0 == b.y1) return flat_box_in(edges, b);
  if (b.x0 == b.x1) {
    std::vector<Edge> turned;  // by a mirror, the other way round
    for (const Edge& e : edges) turned.push_back({{e.b.y, e.b.x}, {e.a.y, e.a.x}});
    return flat_box_in(turned, {b.y0, b.y1, b.x0, b.x0});
  }
  bool touched = false;
  for (const Edge& e : edges) {
    if (enters(e, b)) return 0;
    touched = touched || touches(e, b);
  }
  if (where(edges, Wide(b.x0) + b.x1, Wide(b.y0) + b.y1, 2) > 0) return 1;
  return touched ? 0 : -1;
}

}  // namespace rtac::kernel_test
