// The compiler includes nothing of the runtime, and generated code nothing of the compiler: what
// both sides take for the same number is compared here, when this is compiled.
#include <gtest/gtest.h>

#include "compiler/driver/decision_engine.h"
#include "compiler/ir/weights.h"
#include "compiler/sema/limits.h"
#include "rtac/kernel_bridge.h"
#include "rtac/watch.h"

namespace rtac {
namespace {

// What the compiler lets an input be, the wrapper passes on.
static_assert(bridge::grid_limit == static_cast<double>(sema::grid_steps_max));
// Findings tell whole millionths, of which kernels count the halves.
static_assert(bridge::infinite_margin == ir::margin_max / 2);
static_assert(bridge::margin_limit == driver::margin_limit);

// On all of the widest grid, doubles are exact, and so are the steps beside them.
TEST(Constants, DoublesAreExactOnTheWidestGrid) {
  constexpr double limit = bridge::grid_limit;
  EXPECT_EQ(static_cast<double>(static_cast<std::int64_t>(limit) - 1), limit - 1);
  EXPECT_LT(limit - 1, limit);
  EXPECT_GT(limit + 1, limit);
}

}  // namespace
}  // namespace rtac
