#include "tests/bench/fences.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace rtac::bench {
namespace {

using geometry::Point;
using geometry::Ring;

// mt19937_64 is specified bit by bit, the distributions of the library are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }  // [0, 1)
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::mt19937_64 bits_;
};

// A place in metres; off the grid it keeps a third of a micrometre, which no grid divides.
Point vertex(double x_m, double y_m, Vertices where) {
  const long parts = where == Vertices::on_grid ? 1000 : 3'000'000;
  const auto coordinate = [&](double v) {
    Rational value(std::lround(v * static_cast<double>(parts)), parts);
    value.canonicalize();
    return value;
  };
  return {coordinate(x_m), coordinate(y_m)};
}

struct Polar {
  double x_m, y_m, angle, radius_m;
};
Point vertex(const Polar& p, Vertices where) {
  return vertex(p.x_m + p.radius_m * std::cos(p.angle), p.y_m + p.radius_m * std::sin(p.angle),
                where);
}

double turn(std::size_t i, std::size_t n) {
  return 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
}

Ring rough_ring(double x_m, double y_m, double radius_m, std::size_t n, double roughness,
                Vertices where, Random& random) {
  Ring ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double radius = radius_m * (1 - roughness * random.unit());
    ring.push_back(vertex({x_m, y_m, turn(i, n), radius}, where));
  }
  return ring;
}

// Rings of about `each` vertices on a square grid of places within the disc of `radius_m`.
std::vector<Ring> islands(double radius_m, std::size_t vertices, std::size_t each, Vertices where,
                          Random& random) {
  std::vector<Ring> rings;
  if (vertices < 3) return rings;
  each = std::min(each, vertices);
  const std::size_t count = vertices / each;
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double step_m = std::sqrt(2.0) * radius_m / static_cast<double>(side);
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&](std::size_t k) {
      return (static_cast<double>(k) + 0.5) * step_m - radius_m / std::sqrt(2.0);
    };
    rings.push_back(rough_ring(at(i % side), at(i / side), 0.4 * step_m, each, 0.3, where, random));
  }
  return rings;
}

// The size keeps neighbouring vertices about half a metre apart.
double radius_for(std::size_t vertices) {
  return std::max(20.0, 0.5 * static_cast<double>(vertices) / (2 * std::numbers::pi));
}

}  // namespace

Fence noisy_star(std::size_t vertices, Vertices where, std::uint64_t seed) {
  Random random(seed);
  const double radius_m = radius_for(vertices);
  const std::size_t inner = vertices / 10;
  return {rough_ring(0, 0, radius_m, vertices - inner, 0.2, where, random),
          islands(0.7 * radius_m, inner, 20, where, random)};
}

Fence mild_star(std::size_t vertices, Vertices where, std::uint64_t seed) {
  Random random(seed);
  const double radius_m = radius_for(vertices);
  const std::size_t inner = vertices / 10, outer = vertices - inner;
  const double apart_m = 2 * std::numbers::pi * radius_m / static_cast<double>(outer);
  return {rough_ring(0, 0, radius_m, outer, std::min(apart_m / radius_m, 0.3), where, random),
          islands(0.7 * radius_m, inner, 20, where, random)};
}

Fence circle_fence(std::size_t vertices, Vertices where, std::uint64_t seed) {
  Random random(seed);
  const double radius_m = radius_for(vertices);
  const std::size_t inner = vertices / 10;
  return {rough_ring(0, 0, radius_m, vertices - inner, 0, where, random),
          islands(0.7 * radius_m, inner, 100, where, random)};
}

Fence coast(std::size_t vertices, Vertices where, std::uint64_t seed) {
  Random random(seed);
  const double radius_m = radius_for(vertices);
  const std::size_t inner = vertices / 10, n = vertices - inner;
  // Waves of all lengths, each half as high as the one twice as long.
  std::vector<double> radius(n, radius_m), angle(n);
  for (std::size_t i = 0; i < n; ++i) angle[i] = turn(i, n);
  double height = 0.15 * radius_m;
  for (std::size_t waves = 3; waves < n / 4; waves *= 2, height /= 2) {
    const double phase = random.between(0, 2 * std::numbers::pi);
    const double lean = 0.7 / static_cast<double>(waves);
    for (std::size_t i = 0; i < n; ++i) {
      const double at = turn(i, n) * static_cast<double>(waves) + phase;
      radius[i] += height * (std::sin(at) - 1) / 2;
      // Leaning waves, as long as the angle still grows.
      angle[i] += lean / static_cast<double>(waves) * std::sin(at);
    }
  }
  Fence fence;
  for (std::size_t i = 0; i < n; ++i) {
    fence.outer.push_back(vertex({0, 0, angle[i], radius[i]}, where));
  }
  fence.holes = islands(0.6 * radius_m, inner, 50, where, random);
  return fence;
}

Fence comb(std::size_t vertices, Vertices where, std::uint64_t seed) {
  Random random(seed);
  const std::size_t teeth = std::max<std::size_t>(2, vertices / 4);
  const double width_m = 1, height_m = std::max(20.0, static_cast<double>(teeth) / 4);
  Fence fence;
  const double right = static_cast<double>(teeth) * width_m;
  fence.outer.push_back(vertex(right, -2, where));
  for (std::size_t i = teeth; i-- > 0;) {
    const double x = static_cast<double>(i) * width_m;
    const double top = height_m * random.between(0.5, 1), bottom = random.between(0, 1);
    fence.outer.push_back(vertex(x + 0.9, top, where));
    fence.outer.push_back(vertex(x + 0.5, top * random.between(0.9, 1), where));
    fence.outer.push_back(vertex(x + 0.4, bottom, where));
    fence.outer.push_back(vertex(x + 0.1, bottom * 0.9, where));
  }
  fence.outer.push_back(vertex(-1, -2, where));
  return fence;
}

}  // namespace rtac::bench
