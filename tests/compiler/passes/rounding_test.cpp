// The bound on what integers may move the margin of a monitor: each operation adds what it rounds.
#include "compiler/ir/rounding.h"

#include "compiler/passes/analyse_ranges.h"
#include "compiler/passes/share_values.h"
#include "tests/compiler/ir/watch_testing.h"

namespace rtac::passes {
namespace {

const char* const inputs =
    "enum Gear { park, drive }\n"
    "input p : bool;\ninput g : Gear;\ninput n : int in 0 .. 10;\n"
    "input x, y : real [m] in 0 m .. 4 m;\n"  // steps of a millimetre: 1000 millionths
    "input z : real [m] in 0 m .. 4 m error 0.5 mm;\n"
    "input a, b : point in -1 .. 1 m;\n"
    "param h : length in 1 m .. 2 m = 1 m;\n";

ir::Rounding rounding(const std::string& property) {
  ir::test::Built b = ir::test::built(inputs, property);
  EXPECT_FALSE(b.diagnostics.has_errors()) << b.report();
  if (!b.module.watch) return {};
  share_values(b.module, b.diagnostics);
  analyse_ranges(b.module, b.diagnostics);
  EXPECT_FALSE(b.diagnostics.has_errors()) << b.report();
  return ir::rounding_of(*b.spec, *b.module.watch, b.first().property);
}
Rational millionths(const std::string& property) {
  return rounding(property).millionths;
}

TEST(Rounding, OfTruthValuesAndWholeNumbersIsNone) {
  for (const char* property :
       {"p", "g == park", "n >= 3", "once[0 s, 1 s] (p and n + n < 3)", "age(x) <= 1 s",
        "count[0 s, 1 s](p) >= 3", "(if p then n else 3) >= 2", "sum[0 s, 1 s](n * n) <= 99"}) {
    EXPECT_EQ(millionths(property), 0) << property;
    EXPECT_TRUE(rounding(property).has_exact_verdict) << property;
  }
}

TEST(Rounding, OfAnInputIsAStepAndWhatItsErrorLacks) {
  EXPECT_EQ(millionths("x >= 1 m"), 1000);
  EXPECT_EQ(millionths("x >= h"), 1000);
  EXPECT_EQ(millionths("z >= 1 m"), 1500);
  EXPECT_FALSE(rounding("x + y >= 1 m").has_exact_verdict);
}

// Rule 13.1: what keeps open ends compares with the grid as exact numbers do.
TEST(Rounding, OfOneInputLeavesVerdictsExact) {
  for (const char* property : {"x >= 1 m", "x < h", "1 m - x > 0 m", "min(x, abs(y)) >= 1 m",
                               "x + h > 2 m", "max[0 s, 90 ms](x) > 1 m",
                               "(if x > 1 m then y else h) <= 2 m", "once[0 s, 1 s] x > 1 m"}) {
    EXPECT_TRUE(rounding(property).has_exact_verdict) << property;
  }
  for (const char* property : {"z >= 1 m", "x > y", "2 * x > 1 m", "mean[0 s, 90 ms](x) > 1 m"}) {
    EXPECT_FALSE(rounding(property).has_exact_verdict) << property;
  }
}

TEST(Rounding, AddsUpInArithmetic) {
  EXPECT_EQ(millionths("x + y >= 1 m"), 2000);
  EXPECT_EQ(millionths("x - 3 * y >= 1 m"), 4000);
  EXPECT_EQ(millionths("min(x, abs(y)) >= 1 m"), 1000);
  EXPECT_EQ(millionths("x >= y"), 2000);
  // 4 m times a step, twice
  EXPECT_EQ(millionths("x * y >= 1 m^2"), 8000);
}

// A third of a step is no whole number of millionths: the margin rounds as well.
TEST(Rounding, OfAQuotientIsThatOfItsMargin) {
  EXPECT_EQ(millionths("x / 3 >= 1 m"), Rational(1003, 3));
}

// On the finest grid, of micrometres: a seventh of a step of the input, rounded.
TEST(Rounding, OfAQuotientBetweenStepsIsAStepMore) {
  EXPECT_EQ(millionths("x / 7000 >= 0 m"), Rational(8, 7));
}

TEST(Rounding, OfARootIsAStepMore) {
  // root of 1 + 1, rounded up, and a step
  EXPECT_EQ(millionths("distance(a, b) >= 1 m"), 4000);
  // a step of x is 1000 mm^2, whose root is rounded up to 32, and a step
  EXPECT_EQ(millionths("sqrt(x * 1 m) >= 1 m"), 33'000);
}

TEST(Rounding, OfAWindowIsThatOfItsTicks) {
  EXPECT_EQ(millionths("once[0 s, 1 s] x >= 1 m"), 1000);
  EXPECT_EQ(millionths("max[0 s, 90 ms](x) >= 1 m"), 1000);
  EXPECT_EQ(millionths("sum[0 s, 90 ms](x) >= 1 m"), 10000);
  EXPECT_EQ(millionths("mean[0 s, 90 ms](x) >= 1 m"), 2000);
  EXPECT_EQ(millionths("not (x >= 1 m and x + y <= 2 m)"), 2000);
}

// What hangs on a comparison that is rounded may be anything of both sides.
TEST(Rounding, OfAChoiceIsThatOfItsSidesWhenItsConditionIsExact) {
  EXPECT_EQ(millionths("(if p then x else 2 m) >= 1 m"), 1000);
  const ir::Rounding choice = rounding("(if x + y >= 1 m then x else 2 m) >= 1 m");
  EXPECT_EQ(choice.millionths, 4000000);
  EXPECT_TRUE(choice.has_rounded_choice);
  EXPECT_EQ(millionths("count[0 s, 90 ms](x + y >= 1 m) >= 3"), 10000000);
}

TEST(Rounding, SaysWhereOnlyVerdictsAreKept) {
  EXPECT_FALSE(rounding("once[0 s, 10 s] x >= 1 m").has_verdicts_only);
  EXPECT_TRUE(rounding("once[0 s, 11 s] x >= 1 m").has_verdicts_only);
  EXPECT_FALSE(rounding("once[0 s, 11 s] p").has_verdicts_only);
}

}  // namespace
}  // namespace rtac::passes
