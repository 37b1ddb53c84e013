// Ranges of monitors without a robot: what bounds a value, and what is refused with its ranges.
#include "compiler/ir/weights.h"
#include "compiler/passes/analyse_ranges.h"
#include "compiler/passes/share_values.h"
#include "tests/compiler/ir/watch_testing.h"

namespace rtac::passes {
namespace {

using ir::test::Built;

Built analysed(const std::string& declarations, const std::string& property) {
  Built b = ir::test::built(declarations, property);
  if (b.diagnostics.has_errors()) return b;
  share_values(b.module, b.diagnostics);
  analyse_ranges(b.module, b.diagnostics);
  return b;
}
const char* const speed = "input v : real [m/s] in -2 m/s .. 4 m/s error 1 cm/s;";

TEST(WatchRanges, TheErrorWidensAnInput) {
  EXPECT_TRUE(analysed(speed, "v <= 1 m/s").has("input v : 1/1000 m/s [-2010, 4010]"));
}

TEST(WatchRanges, ASquareIsNotNegative) {
  EXPECT_TRUE(analysed(speed, "v * v <= 1 m^2/s^2").has("[0, 16080100]"));
}

TEST(WatchRanges, AProductTakesItsExtremesAtTheCorners) {
  const Built b = analysed("input a : real in -2 .. 3;\ninput b : real in -5 .. 4;", "a * b <= 1");
  EXPECT_TRUE(b.has("scale %2, 1/1000000 : 1/1000000 [-15000000, 12000000]")) << b.block();
}

TEST(WatchRanges, WhatLeaves62BitsIsRefusedWithItsRange) {
  const std::string report = analysed("input a : real [m];", "a * a <= 1 m^2").report();
  EXPECT_EQ(report.substr(0, 37), "7001: this value ranges over [0 m^2, ") << report;
}

// One mistake is one report: what is made of the refused product has no range of its own.
TEST(WatchRanges, WhatIsMadeOfARefusedValueIsNotReported) {
  const Built b = analysed("input a : real [m] in 0 .. 1e12 m;", "a * a * a - a * a * a >= 1 m^3");
  ASSERT_EQ(b.diagnostics.all().size(), 1U) << b.report();
  EXPECT_EQ(b.report().substr(0, 37), "7001: this value ranges over [0 m^2, ");
  const Built two = analysed("input a : real [m] in 0 .. 1e12 m;\ninput b : real [m];",
                             "a * a >= 1 m^2 and b * b >= 1 m^2");
  EXPECT_EQ(two.diagnostics.all().size(), 2U);
}

// The kernel multiplies before it divides: 10^9 steps times 12345678000 / 7000007 would fit.
TEST(WatchRanges, TheProductInsideAFractionIsHeldAgainst62Bits) {
  const std::string input = "input a : real [m] in 0 m .. 1000 km;";
  const std::string report = analysed(input, "a * (12345678 / 7000007) <= 9 m").report();
  EXPECT_EQ(report.substr(0, 34), "7001: this value ranges over [0 m,") << report;
  EXPECT_EQ(analysed(input, "a * (12345 / 7000007) <= 9 m").report(), "");
}

TEST(WatchRanges, TheRootOfWhatMayBeNegativeIsRefused) {
  EXPECT_EQ(analysed("input b : real [m] in -1 m .. 1 m;", "sqrt(b * 1 m) <= 1 m").report(),
            "7001: the root of something that may be negative: its operand ranges over [-1 m^2, "
            "1 m^2] | `sqrt(max(x, 0))` works, or a range of the inputs that leaves negative ones "
            "out");
  EXPECT_EQ(
      analysed("input b : real [m] in -1 m .. 1 m;", "sqrt(max(b * 1 m, 0 m^2)) <= 1 m").report(),
      "");
}

TEST(WatchRanges, ASumGrowsWithItsWindowAndHoldsZero) {
  const Built b = analysed("input n : int in 2 .. 5;", "sum[0 s, 90 ms](n) <= 40");
  EXPECT_TRUE(b.has("sum [0, 9] %0, slot 0 : 1 [0, 50]")) << b.block();
}

TEST(WatchRanges, OneInputWithoutARangeMakesAllUndeclared) {
  const Built b = analysed("input p : real [m];\ninput q : real [m] in 0 m .. 1 m;",
                           "max[0 s, 1 s](p + q) <= 1 m");
  ASSERT_EQ(b.report(), "");
  for (const ir::Value& v : b.first().property.values) {
    if (std::holds_alternative<ir::Add>(v.op)) {
      EXPECT_FALSE(v.range->declared);
    }
  }
}

// A margin that could leave its bounds is cut off, never wrapped.
TEST(WatchRanges, ALargeMarginIsNotPlain) {
  const Built small = analysed("input n : int in 0 .. 10;", "n <= 5");
  const Built large = analysed("input n : int in 0 .. 1000000000000000;", "n <= 5");
  const auto plain = [](const Built& b) {
    const ir::Block& block = b.first().property;
    return ir::is_plain_margin(block, std::get<ir::AtLeast>(block[block.result].op));
  };
  EXPECT_TRUE(plain(small));
  EXPECT_FALSE(plain(large));
}

// The scale is as near as any: what does not fit is the fraction that a degree is of it.
TEST(WatchRanges, AResolutionThatIsNoFractionOfTheScaleIsRefusedWithOneThatIs) {
  const auto report = [](const std::string& resolution) {
    return analysed("input a : real [rad] in -1 rad .. 1 rad resolution " + resolution + ";",
                    "a <= 0 rad")
        .report();
  };
  EXPECT_EQ(report("1 deg"),
            "7001: margins count millionths of the scale 1 rad, and the step here is no simple "
            "fraction of it | `resolution 0.01 rad` at the input works, with constants that are "
            "multiples of it");
  EXPECT_EQ(report("0.01 rad"), "");
}

// A margin of one step that is cut off before it is weighed would lose its sign: the step would not
// know what the entry for verdicts alone does.
TEST(WatchRanges, AStepThatMarginsCannotHoldIsRefused) {
  const auto report = [](const std::string& resolution) {
    return analysed(
               "scale 1 um;\ninput x : real [m] in -1e9 m .. 1e9 m resolution " + resolution + ";",
               "x > 0 m")
        .report();
  };
  EXPECT_EQ(report("400000 m"), "");
  EXPECT_EQ(report("1000000 m"),
            "7001: margins cannot be counted in millionths of the scale 0.000001 m | a `scale` "
            "between a millionth and a million of the `resolution` works");
}

}  // namespace
}  // namespace rtac::passes
