// The reference experiment of the theory: what is left to an advanced controller that drives at the
// fence is no less than there, where it can be, and judging its commands leaves more.
#include "shares.h"

#include <gtest/gtest.h>

#include "reference_design.h"

namespace rtac::campaign {
namespace {

constexpr int clean = 0, has_errors = 1;

// With the same horizon. At 0.4 s even against the one that always pushes; at 0.2 s its share is
// above one half, which nobody can have who does nothing else: then who slides and runs up, too.
TEST(Shares, OfARetreatAreThoseOfTheTheory) {
  const struct {
    std::size_t row;
    const char* adversary;
  } cases[] = {{2, "chase-fence"}, {3, "chase-fence"}, {3, "push-at-fence"}};
  for (const auto& [row, adversary] : cases) {
    const TheoryRow& theory = theory_shares()[row];
    const Measured m = measure({theory.delta_ms, false, true, adversary, 2, 300});
    ASSERT_EQ(m.status, clean) << m.said;
    EXPECT_GT(m.percent, theory.retreat) << theory.delta_ms << " ms, " << adversary;
    EXPECT_GT(m.clearance_m, 0) << m.said;
  }
}

// The theory's own design comes as near to the wall as is told of it. Its share against an
// adversary that always pushes is what that leaves to anybody; the generated decision, which looks
// further ahead for what the reference leaves out (the tube of the sampled brake, a late decision),
// has nine tenths of it.
TEST(Shares, OfWhoAlwaysPushesAreNearlyThoseOfTheReferenceDesign) {
  constexpr double most_percent = 50, start_percent = 1;  // A = b
  for (const TheoryRow& theory : theory_shares()) {
    const Left own = left_by_the_reference(theory.delta_ms, theory.delta_ms, 4, 600);
    if (theory.retreat == 0) {
      EXPECT_EQ(own.percent, 0);
      continue;
    }
    EXPECT_NEAR(own.clearance_m, theory.clearance_m, 0.04) << theory.delta_ms << " ms";
    const Left reference = left_by_the_reference(theory.delta_ms, 50, 2, 300);
    EXPECT_LT(reference.percent, most_percent + start_percent);
    const Measured m = measure({theory.delta_ms, false, true, "push-at-fence", 2, 300});
    ASSERT_EQ(m.status, clean) << m.said;
    EXPECT_GT(m.percent, 0.9 * reference.percent) << theory.delta_ms << " ms: " << m.said;
    EXPECT_LT(m.percent, most_percent + start_percent) << m.said;
  }
}

// A recovery that holds its place leads nowhere; a proposal that leads away may be let through.
TEST(Shares, AreMuchLargerWhereCommandsAreJudged) {
  for (const TheoryRow& theory : theory_shares()) {
    if (theory.delta_ms != 50 && theory.delta_ms != 200) continue;
    const Measured any = measure({theory.delta_ms, false, false, "chase-fence", 2, 300});
    const Measured command = measure({theory.delta_ms, true, false, "chase-fence", 2, 300});
    ASSERT_EQ(any.status, clean) << any.said;
    ASSERT_EQ(command.status, clean) << command.said;
    EXPECT_GT(command.percent, 4 * any.percent) << theory.delta_ms;
    EXPECT_GT(command.percent, theory.brake) << theory.delta_ms;
    EXPECT_GT(command.clearance_m, 0) << command.said;
  }
}

// Two periods of 0.8 s are more than the fence is wide for; that is said, and nothing simulated.
TEST(Shares, WhatCanNeverHandBackIsRefused) {
  const Measured m = measure({800, false, true, "push-at-fence", 1, 30});
  EXPECT_EQ(m.status, has_errors);
  EXPECT_NE(m.said.find("error[5007]"), std::string::npos) << m.said;
}

}  // namespace
}  // namespace rtac::campaign
