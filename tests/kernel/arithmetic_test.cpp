// Roots and quotients of the kernel, against their definitions.
#include <gtest/gtest.h>

#include "tests/kernel/exact.h"

namespace rtac::kernel_test {
namespace {

constexpr std::int64_t limit = std::int64_t{1} << 62;

void check_root(std::int64_t a) {
  const std::int64_t down = probe_root_down(a), up = probe_root_up(a);
  ASSERT_LE(Wide(down) * down, a);
  ASSERT_GT(Wide(down + 1) * (down + 1), a);
  ASSERT_GE(Wide(up) * up, a);
  ASSERT_TRUE(up == 0 || Wide(up - 1) * (up - 1) < a) << a;
}

TEST(Root, IsExactAroundSquares) {
  // A digit-by-digit root goes wrong, if at all, next to squares and to powers of two.
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    const std::int64_t r = i < 2'000 ? i : random.in(1, (std::int64_t{1} << 31) - 1);
    for (const std::int64_t a : {r * r - 1, r * r, r * r + 1, r * r + 2 * r}) {
      if (a >= 0 && a < limit) check_root(a);
    }
  }
}

TEST(Root, IsExactAtPowersOfTwoAndAtTheEndOfItsRange) {
  for (int bit = 0; bit < 62; ++bit) {
    for (const std::int64_t d : {-1, 0, 1}) {
      const std::int64_t a = (std::int64_t{1} << bit) + d;
      if (a >= 0) check_root(a);
    }
  }
  check_root(limit - 1);
}

TEST(Root, IsExactForRandomNumbersOfEverySize) {
  Random random(2);
  for (int i = 0; i < 50'000; ++i) check_root(random.in(0, limit - 1) >> random.in(0, 61));
}

TEST(DivUp, IsTheSmallestQuotientThatIsNotBelow) {
  Random random(3);
  for (int i = 0; i < 50'000; ++i) {
    const std::int64_t b = random.in(1, 5'000'000), a = random.in(0, limit - 1) >> random.in(0, 61);
    const std::int64_t q = probe_div_up(a, b);
    ASSERT_GE(Wide(q) * b, a);
    ASSERT_TRUE(q == 0 || Wide(q - 1) * b < a);
  }
}

}  // namespace
}  // namespace rtac::kernel_test
