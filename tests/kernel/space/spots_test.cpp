// Distances of places and segments in space: never above the exact one, and hardly below it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "tests/kernel/space/pairs_probe.h"

namespace pairs {
namespace {

__extension__ using Wide = __int128;
using Spot = std::array<std::int64_t, 3>;

constexpr std::int64_t extent_mm = std::int64_t{1} << 29;

Wide dot(const Spot& a, const Spot& b) {
  return Wide(a[0]) * b[0] + Wide(a[1]) * b[1] + Wide(a[2]) * b[2];
}
Spot minus(const Spot& a, const Spot& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
long double length(const Spot& a) {
  return std::sqrt(static_cast<long double>(dot(a, a)));
}
// Conditions are exact; the distance has the 64 digits of a long double.
long double across(const Spot& d, const Spot& q) {
  long double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const auto c = static_cast<long double>(Wide(d[i]) * q[j] - Wide(d[j]) * q[i]);
    square += c * c;
  }
  return std::sqrt(square);
}
long double to_segment(const Spot& p, const Spot& a, const Spot& b) {
  const Spot d = minus(b, a), q = minus(p, a);
  const Wide along = dot(q, d);
  if (along <= 0) return length(q);
  if (along >= dot(d, d)) return length(minus(p, b));
  return across(d, q) / length(d);
}
// Of the lines, where the shortest way between them begins and ends within the segments.
long double between(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
  const Spot u = minus(b, a), v = minus(d, c), w = minus(a, c);
  const Wide uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const Wide whole = uu * vv - uv * uv, s = uv * vw - vv * uw, t = uu * vw - uv * uw;
  if (whole == 0 || s < 0 || s > whole || t < 0 || t > whole) return INFINITY;
  long double volume = 0, square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Wide n = Wide(u[j]) * v[k] - Wide(u[k]) * v[j];
    volume += static_cast<long double>(n * w[i]);
    square += static_cast<long double>(n) * static_cast<long double>(n);
  }
  return std::abs(volume) / std::sqrt(square);
}
long double exact(const Spot& a, const Spot& b, const Spot& c, const Spot& d) {
  return std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b),
                   to_segment(d, a, b), between(a, b, c, d)});
}

class Spots : public ::testing::Test {
 protected:
  std::int64_t whole(std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(-most, most)(random_);
  }
  // Anywhere, near another place, or in line with it.
  Spot spot(const Spot& near) {
    static const std::array<std::int64_t, 6> sizes = {3, 50, 2'000, 40'000, 10'000'000, extent_mm};
    const std::int64_t most = sizes[static_cast<std::size_t>(whole(2) + 3) % sizes.size()];
    Spot s{};
    for (std::size_t i = 0; i < 3; ++i) {
      s[i] = std::clamp(near[i] + (whole(3) == 0 ? 0 : whole(most)), -extent_mm, extent_mm);
    }
    return s;
  }
  std::mt19937_64 random_{3};
};

// 1 for what is rounded down, and a part in 10^8 of all lengths, as directions have 28 digits.
void expect_close(std::int64_t found, long double exact, long double lengths, int n) {
  ASSERT_LE(static_cast<long double>(found), exact * (1 + 1e-15L) + 1e-6L) << n;
  ASSERT_GE(static_cast<long double>(found), exact - 1.01L - 1e-8L * (exact + lengths)) << n;
}

TEST_F(Spots, AreAsFarApartAsFoundAndHardlyFarther) {
  int inner = 0, touching = 0;
  for (int n = 0; n < 100'000; ++n) {
    const Spot a = spot({0, 0, 0}), b = spot(a), c = spot(b), d = spot(c);
    const long double apart = exact(a, b, c, d);
    inner += between(a, b, c, d) <= apart ? 1 : 0;
    touching += apart < 1 ? 1 : 0;
    ASSERT_NO_FATAL_FAILURE(expect_close(probe_spots_apart(a.data(), b.data(), c.data(), d.data()),
                                         apart, length(minus(b, a)) + length(minus(d, c)), n));
    ASSERT_NO_FATAL_FAILURE(expect_close(probe_spot_segment(c.data(), a.data(), b.data()),
                                         to_segment(c, a, b), length(minus(b, a)), n));
    ASSERT_NO_FATAL_FAILURE(
        expect_close(probe_spot_gap(a.data(), c.data()), length(minus(a, c)), 0, n));
  }
  EXPECT_GT(inner, 2'000);
  EXPECT_GT(touching, 300);
}

TEST_F(Spots, OfTheLargestNumbersAreFound) {
  const std::int64_t m = extent_mm;
  const std::array<Spot, 8> corners = {{{m, m, m},
                                        {-m, m, m},
                                        {m, -m, m},
                                        {m, m, -m},
                                        {-m, -m, m},
                                        {-m, m, -m},
                                        {m, -m, -m},
                                        {-m, -m, -m}}};
  for (const Spot& a : corners) {
    for (const Spot& b : corners) {
      for (const Spot& c : corners) {
        for (const Spot& d : corners) {
          ASSERT_NO_FATAL_FAILURE(
              expect_close(probe_spots_apart(a.data(), b.data(), c.data(), d.data()),
                           exact(a, b, c, d), length(minus(b, a)) + length(minus(d, c)), 0));
        }
      }
    }
  }
}

}  // namespace
}  // namespace pairs
