// Seeded random numbers with the same bits on every machine: xoshiro256** by Blackman and Vigna,
// seeded through splitmix64. The distributions of the standard library are not portable.
#pragma once

#include <cstdint>

#include "rtac/sim/math.h"

namespace rtac::sim {

class Random {
 public:
  explicit Random(std::uint64_t seed) {
    for (std::uint64_t& word : state_) word = split_mix(seed);
  }

  // An independent stream for each purpose, so that drawing more of one changes no other.
  static Random stream(std::uint64_t seed, std::uint64_t first, std::uint64_t second) {
    std::uint64_t mixed = split_mix(seed);
    mixed ^= first * 0x9E3779B97F4A7C15u;
    mixed = split_mix(mixed);
    mixed ^= second * 0xD1B54A32D192ED03u;
    return Random(split_mix(mixed));
  }

  std::uint64_t next() {
    const std::uint64_t result = rotate_left(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate_left(state_[3], 45);
    return result;
  }

  // In [0, 1), 53 random bits.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
  // -1 or 1.
  double sign() { return (next() >> 63) != 0 ? 1.0 : -1.0; }
  // In [0, count), count >= 1. The bias is below count / 2^53.
  std::int64_t below(std::int64_t count) {
    return static_cast<std::int64_t>(uniform() * static_cast<double>(count));
  }
  // Uniform in the disc of this radius; the result never lies outside it, rounding included.
  Vec2 in_disc(double radius) { return radius * unit_disc(); }
  // A direction, uniform, times the radius; its length exceeds the radius by no rounding.
  Vec2 on_circle(double radius);
  // The same in space.
  Vec3 in_ball(double radius) { return radius * unit_ball(); }
  Vec3 on_sphere(double radius);

 private:
  static std::uint64_t split_mix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  static std::uint64_t rotate_left(std::uint64_t x, int by) { return (x << by) | (x >> (64 - by)); }
  Vec2 unit_disc();
  Vec3 unit_ball();

  std::uint64_t state_[4] = {};
};

}  // namespace rtac::sim
