#include "tests/bench/zones/outline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace rtac::bench {
namespace {

// mt19937_64 is specified bit by bit, the distributions of the library are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  std::int64_t in(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }

 private:
  std::mt19937_64 bits_;
};

GridPlace place(std::int64_t x, std::int64_t y) {
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
}
std::vector<GridPlace> grid_ring(const geometry::Ring& ring) {
  std::vector<GridPlace> to;
  const auto mm = [](const Rational& metres) {
    return std::lround(Rational(metres * 1000).get_d());
  };
  for (const geometry::Point& p : ring) to.push_back(place(mm(p.x), mm(p.y)));
  return to;
}

}  // namespace

std::size_t Outline::vertices() const {
  std::size_t all = 0;
  for (const auto& ring : rings) all += ring.size();
  return all;
}

Outline outline_of(const std::string& name, const Fence& fence) {
  Outline to{name, {grid_ring(fence.outer)}};
  for (const geometry::Ring& hole : fence.holes) to.rings.push_back(grid_ring(hole));
  return to;
}

std::string well_known_text(const Outline& outline) {
  std::string text = "POLYGON (";
  for (std::size_t r = 0; r < outline.rings.size(); ++r) {
    const auto& ring = outline.rings[r];
    text += r == 0 ? "(" : ",\n(";
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const GridPlace& p = ring[i % ring.size()];
      char vertex[60];
      std::snprintf(vertex, sizeof vertex, "%s%.3f %.3f", i == 0 ? "" : ", ", p.x_mm / 1000.0,
                    p.y_mm / 1000.0);
      text += vertex;
    }
    text += ")";
  }
  return text + ")\n";
}

std::vector<GridPlace> uniform_places(const Outline& outline, std::size_t count,
                                      std::uint64_t seed) {
  Random random(seed);
  const auto& ring = outline.rings.front();
  const auto [left, right] =
      std::ranges::minmax(ring, {}, [](const GridPlace& p) { return p.x_mm; });
  const auto [low, high] = std::ranges::minmax(ring, {}, [](const GridPlace& p) { return p.y_mm; });
  std::vector<GridPlace> places;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t x = random.in(left.x_mm, right.x_mm);
    places.push_back(place(x, random.in(low.y_mm, high.y_mm)));
  }
  return places;
}

std::vector<GridPlace> near_places(const Outline& outline, std::int32_t near_mm, std::size_t count,
                                   std::uint64_t seed) {
  Random random(seed);
  std::vector<std::pair<GridPlace, GridPlace>> edges;
  for (const auto& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
    }
  }
  std::vector<GridPlace> places;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b] =
        edges[static_cast<std::size_t>(random.in(0, static_cast<std::int64_t>(edges.size()) - 1))];
    const std::int64_t part = random.in(0, 1000);
    const std::int64_t x = a.x_mm + (std::int64_t{b.x_mm} - a.x_mm) * part / 1000;
    const std::int64_t y = a.y_mm + (std::int64_t{b.y_mm} - a.y_mm) * part / 1000;
    const std::int64_t dx = random.in(-near_mm, near_mm);
    places.push_back(place(x + dx, y + random.in(-near_mm, near_mm)));
  }
  return places;
}

std::vector<GridPlace> way_places(const Outline& outline, std::int32_t near_mm,
                                  std::int32_t step_mm, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const auto& ring = outline.rings.front();
  std::vector<GridPlace> places;
  std::int64_t off_x = 0, off_y = 0;
  const auto wander = [&](std::int64_t& off) {
    off = std::clamp<std::int64_t>(off + random.in(-step_mm, step_mm), -near_mm, near_mm);
  };
  double along_mm = 0;  // of the present edge
  for (std::size_t i = static_cast<std::size_t>(random.in(0, std::int64_t(ring.size()) - 1));
       places.size() < count; i = (i + 1) % ring.size()) {
    const GridPlace &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double dx = double(b.x_mm) - a.x_mm, dy = double(b.y_mm) - a.y_mm;
    const double length_mm = std::hypot(dx, dy);
    for (; along_mm < length_mm && places.size() < count; along_mm += step_mm) {
      wander(off_x);
      wander(off_y);
      places.push_back(place(std::llround(a.x_mm + dx * along_mm / length_mm) + off_x,
                             std::llround(a.y_mm + dy * along_mm / length_mm) + off_y));
    }
    along_mm -= length_mm;
  }
  return places;
}

std::vector<GridPlace> legs_from(const std::vector<GridPlace>& starts, std::int32_t length_mm,
                                 std::uint64_t seed) {
  Random random(seed);
  std::vector<GridPlace> legs;
  for (const GridPlace& p : starts) {
    const std::int64_t dx = random.in(-length_mm, length_mm);
    legs.push_back(p);
    legs.push_back(place(p.x_mm + dx, p.y_mm + random.in(-length_mm, length_mm)));
  }
  return legs;
}

}  // namespace rtac::bench
