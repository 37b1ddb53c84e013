// Exact references on 128-bit integers: distances as squared fractions, never rounded. Products of
// two squared differences of coordinates within +-2^29 mm fit 125 bits.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "tests/kernel/kernel_probe.h"

namespace rtac::kernel_test {

__extension__ using Wide = __int128;

constexpr std::int64_t extent_mm = std::int64_t{1} << 29;

inline Wide dot(probe_vec a, probe_vec b) {
  return Wide(a.x) * b.x + Wide(a.y) * b.y;
}
inline Wide cross(probe_vec a, probe_vec b) {
  return Wide(a.x) * b.y - Wide(a.y) * b.x;
}
inline probe_vec minus(probe_vec a, probe_vec b) {
  return {a.x - b.x, a.y - b.y};
}
inline int sign(Wide w) {
  return w > 0 ? 1 : (w < 0 ? -1 : 0);
}

// Square of a distance.
struct Square {
  Wide num, den;
  // distance <= d, distance >= d for integers d
  [[nodiscard]] bool at_most(std::int64_t d) const { return d >= 0 && num <= Wide(d) * d * den; }
  [[nodiscard]] bool at_least(std::int64_t d) const { return d <= 0 || num >= Wide(d) * d * den; }
  [[nodiscard]] double root() const {
    return static_cast<double>(
        std::sqrt(static_cast<long double>(num) / static_cast<long double>(den)));
  }
};

inline Square point_segment(probe_vec p, probe_vec a, probe_vec b) {
  const probe_vec d = minus(b, a), q = minus(p, a), r = minus(p, b);
  const Wide along = dot(q, d), length = dot(d, d);
  if (along <= 0) return {dot(q, q), 1};
  if (along >= length) return {dot(r, r), 1};
  const Wide area = cross(d, q);
  return {area * area, length};
}

inline int side(probe_vec a, probe_vec b, probe_vec p) {
  return sign(cross(minus(b, a), minus(p, a)));
}
inline bool in_box(probe_vec p, probe_vec a, probe_vec b) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}
inline bool on_segment(probe_vec p, probe_vec a, probe_vec b) {
  return side(a, b, p) == 0 && in_box(p, a, b);
}
inline bool meet(probe_vec a, probe_vec b, probe_vec c, probe_vec d) {
  if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)) {
    return true;
  }
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}
// The four candidates of the distance of two segments; a single zero when they meet.
inline std::vector<Square> segment_gaps(probe_vec a, probe_vec b, probe_vec c, probe_vec d) {
  if (meet(a, b, c, d)) return {{0, 1}};
  return {point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b),
          point_segment(d, a, b)};
}
// lower <= distance <= lower + slack, the distance being the least of the candidates.
inline bool bounds_from_below(std::int64_t lower, std::int64_t slack,
                              const std::vector<Square>& candidates) {
  bool tight = false;
  for (const Square& s : candidates) {
    if (!s.at_least(lower)) return false;
    tight = tight || s.at_most(lower + slack);
  }
  return tight;
}

using Ring = std::vector<probe_vec>;

inline probe_edge edge_of(probe_vec a, probe_vec b) {
  const long double x = static_cast<long double>(b.x - a.x),
                    y = static_cast<long double>(b.y - a.y);
  const long double scale = 1073741824.0L / std::sqrt(x * x + y * y);
  return {static_cast<std::int32_t>(a.x),
          static_cast<std::int32_t>(a.y),
          static_cast<std::int32_t>(b.x),
          static_cast<std::int32_t>(b.y),
          static_cast<std::int32_t>(std::llround(x * scale)),
          static_cast<std::int32_t>(std::llround(y * scale))};
}
inline void add_ring(probe_zone& z, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    z.edges[z.count++] = edge_of(ring[i], ring[(i + 1) % ring.size()]);
  }
}
inline probe_vec begin_of(const probe_edge& e) {
  return {e.ax, e.ay};
}
inline probe_vec end_of(const probe_edge& e) {
  return {e.bx, e.by};
}
inline bool on_boundary(const probe_zone& z, probe_vec p) {
  for (std::int32_t i = 0; i < z.count; ++i) {
    if (on_segment(p, begin_of(z.edges[i]), end_of(z.edges[i]))) return true;
  }
  return false;
}
// Along a ray to +y, where the kernel's runs to +x.
inline bool inside(const probe_zone& z, probe_vec p) {
  bool in = false;
  for (std::int32_t i = 0; i < z.count; ++i) {
    const probe_vec a = begin_of(z.edges[i]), b = end_of(z.edges[i]);
    if ((a.x <= p.x) == (b.x <= p.x)) continue;
    const int s = side(a, b, p);
    if (a.x < b.x ? s < 0 : s > 0) in = !in;
  }
  return in;
}

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::int64_t in(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
  }
  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  bool one_in(int n) { return in(1, n) == 1; }
  probe_vec point(std::int64_t size) { return {in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 engine_;
};

// A star-shaped ring around `centre`, counter-clockwise, with `n` vertices.
inline Ring star(Random& random, probe_vec centre, double least, double most, int n) {
  Ring ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * (i + random.real(0, 0.8)) / n;
    const double radius = random.real(least, most);
    ring.push_back({centre.x + std::llround(radius * std::cos(angle)),
                    centre.y + std::llround(radius * std::sin(angle))});
  }
  return ring;
}
// A star with a star-shaped hole; the hole runs clockwise.
inline probe_zone random_zone(Random& random, double size) {
  probe_zone z{};
  const probe_vec centre = {0, 0};
  add_ring(z, star(random, centre, size / 2, size, static_cast<int>(random.in(3, 12))));
  if (random.one_in(2)) {
    Ring hole = star(random, centre, size / 16, size / 8, static_cast<int>(random.in(5, 9)));
    add_ring(z, Ring(hole.rbegin(), hole.rend()));
  }
  return z;
}

}  // namespace rtac::kernel_test
