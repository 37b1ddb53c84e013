// What properties of monitors without a robot become: grids, constants, negation, the past.
#include "compiler/ir/unit.h"
#include "tests/compiler/ir/testing.h"
#include "tests/compiler/ir/watch_testing.h"

namespace rtac::ir::test {
namespace {

const char* const gap = "input gap : length in 0 m .. 2 m;";

TEST(WatchBlock, AComparisonIsOnTheGridOfItsInput) {
  EXPECT_EQ(built(gap, "gap >= 0.3 m").block(),
            "%0 = input gap : mm\n%1 = const 300 : mm\n%2 = at_least %0, %1 : margin\nresult %2\n");
}

TEST(WatchBlock, AConstantBetweenTwoStepsIsRefusedWithAFinerResolution) {
  EXPECT_EQ(built(gap, "gap >= 0.3005 m").report(),
            "7003: this constant does not lie on the grid of 0.001 m | `0.3 m` and `0.301 m` do, "
            "or `resolution 0.0005 m` at the input `gap`");
  EXPECT_EQ(
      built("input gap : length in 0 m .. 2 m resolution 0.0005 m;", "gap >= 0.3005 m").report(),
      "");
}

std::string rounded_input(const std::string& resolution) {
  return "input v : real [m/s] in -10 m/s .. 10 m/s resolution " + resolution + ";";
}

// 1 km/h is 5/18 m/s, and a degree is no share of a radian: no resolution that decimals can write
// has them on its grid, so they stay between two steps.
TEST(WatchBlock, AConstantThatIsOnNoGridLiesBetweenTwoSteps) {
  const char* const tilt = "input tilt : angle in -2 rad .. 2 rad;";
  EXPECT_TRUE(built(rounded_input("1 mm/s"), "v <= 1 km/h").has("strictly_between 277, 278"))
      << built(rounded_input("1 mm/s"), "v <= 1 km/h").report();
  EXPECT_TRUE(built(tilt, "tilt >= -45 deg").has("strictly_between -786, -785"))
      << built(tilt, "tilt >= -45 deg").report();
  EXPECT_TRUE(built(tilt, "tilt + 45 deg >= 0 rad").has("strictly_between 785, 786"));
  EXPECT_TRUE(built("input x : real in 0 .. 9;", "x <= 1 / 3").has("between 333333, 333334"));
}
TEST(WatchBlock, AParameterThatIsOnNoGridIsRefusedWithItsNeighbours) {
  EXPECT_EQ(
      built("input tilt : angle in -2 rad .. 2 rad; param most : angle in 0 rad .. 1 rad = 30 deg;",
            "tilt <= most")
          .report(),
      "7003: this value does not lie on the grid of 0.001 rad | `0.523 rad` and `0.524 rad` do");
}
// 0.1 nm is a decimal, though nothing counts it: it is a mistake.
TEST(WatchBlock, AConstantThatIsTooFineIsNotRounded) {
  EXPECT_EQ(built(gap, "gap >= 0.0000000001 m").report().substr(0, 5), "7003:");
}

TEST(WatchBlock, NoNeighbourIsProposedThatDecimalsCannotWrite) {
  EXPECT_EQ(built(rounded_input("1 km/h"), "v <= 0.3 m/s").report(),
            "7003: this constant does not lie on the grid of 0.277778 m/s | `resolution 0.1 m/s` "
            "at the input `v` works");
  EXPECT_EQ(built(rounded_input("0.1 m/s"), "v <= 0.3 m/s").report(), "");
  EXPECT_EQ(built(rounded_input("5 km/h"), "v <= 7 km/h").report(),
            "7003: this constant does not lie on the grid of 1.38889 m/s | a `resolution` with a "
            "few decimals in SI units works, with constants that are multiples of it");
}

// A root has the usual grid of its dimension, whatever the resolution of what it is drawn from.
TEST(WatchBlock, NoResolutionIsProposedThatDoesNotDecide) {
  EXPECT_EQ(built("input v : real in 0 .. 10;", "sqrt(v) <= 0.3005").report(),
            "7003: this constant does not lie on the grid of 0.001 | `0.3` and `0.301` do");
}

// Nothing could be declared that makes it finer.
TEST(WatchBlock, AWholeNumberTakesTheGridOfTheConstant) {
  const char* const n = "input n : int in 0 .. 9;";
  EXPECT_EQ(built(n, "n >= 1.5").report(), "");
  EXPECT_TRUE(built(n, "n >= 1.5").has("%2 = const 3 : 1/2")) << built(n, "n >= 1.5").block();
  EXPECT_EQ(built(n, "n / 3 <= 0.5").report(), "");
  EXPECT_TRUE(built(n, "n / 3 <= 0.5").has("const 3 : 1/6")) << built(n, "n / 3 <= 0.5").block();
  EXPECT_EQ(built(n, "n >= 2").block(),
            "%0 = input n : 1\n%1 = const 2 : 1\n%2 = at_least %0, %1 : margin\nresult %2\n");
  // margins cannot tell it
  EXPECT_NE(built(n, "n >= 0.00000015").report(), "");
}

// On their own grid the mean of 1 and 2 would be anything between them.
TEST(WatchBlock, AMeanOfWholeNumbersIsFinerThanThey) {
  const Built b = built("input n : int in 0 .. 9;", "mean[0 s, 3 s](n) >= 1.5");
  EXPECT_EQ(b.report(), "");
  EXPECT_TRUE(b.has("const 1500 : 1/1000")) << b.block();
}

// The atom that decides must be known, so a negation is a comparison again.
TEST(WatchBlock, TheNegationOfAComparisonIsTheOppositeOne) {
  EXPECT_EQ(
      built(gap, "not gap >= 0.3 m").block(),
      "%0 = input gap : mm\n%1 = const 300 : mm\n%2 = more_than %1, %0 : margin\nresult %2\n");
}

// if-then-else of conditions: (c and a) or (not c and b), and its negation by De Morgan.
TEST(WatchBlock, TheNegationOfAChoiceNegatesBothBranches) {
  const Built b = built("input c, a, b : bool;", "not (if c then a else b)");
  EXPECT_TRUE(b.has("%4 = or %1, %3 : margin")) << b.block();
  EXPECT_TRUE(b.has("%8 = or %5, %7 : margin")) << b.block();
  EXPECT_TRUE(b.has("%9 = and %4, %8 : margin")) << b.block();
}

TEST(WatchBlock, ADivisionTakesAFinerGridAndStaysExact) {
  const Built b = built(gap, "gap / 3 <= 0.1 m");
  EXPECT_TRUE(b.has("scale %0, 1/1 : 1/3000 m")) << b.block();
  EXPECT_TRUE(b.has("const 300 : 1/3000 m")) << b.block();
}

TEST(WatchBlock, AProductIsNeverFinerThanAMillionthOfTheScale) {
  EXPECT_TRUE(built(gap, "gap * gap <= 1 m^2").has(" : 1/1000000 m^2"));
  const Built fine = built("input a, b : real in 0 .. 1;", "a * b <= 1");
  EXPECT_TRUE(fine.has("multiply %0, %1 : 1/1000000000000\n")) << fine.block();
  EXPECT_TRUE(fine.has("scale %2, 1/1000000 : 1/1000000\n")) << fine.block();
}

TEST(WatchBlock, AMultipleOfTwoGridsIsOnTheirCommonStep) {
  const Built b = built(
      "input a : length in 0 m .. 2 m resolution 0.002 m;\n"
      "input b : length in 0 m .. 3 m resolution 0.003 m;",
      "a + b <= 1 m");
  EXPECT_TRUE(b.has("scale %0, 2/1 : mm")) << b.block();
  EXPECT_TRUE(b.has("scale %1, 3/1 : mm") || b.has("scale %2, 3/1 : mm")) << b.block();
}

// Rule 2: not ((not a) since[d, inf] (b and not a)).
TEST(WatchBlock, WithinIsTheNegationOfASince) {
  EXPECT_EQ(built("input a, b : bool;", "a within 50 ms of b").block(),
            "%0 = truth a : margin\n%1 = not %0 : margin\n%2 = truth b : margin\n"
            "%3 = and %2, %1 : margin\n%4 = since [5, inf] verdicts %1, %3, slot 0 : margin\n"
            "%5 = not %4 : margin\nresult %5\n");
}

// Rule 2: historically[0, d], and d has elapsed.
TEST(WatchBlock, ForHoldsOnlyAfterItsDuration) {
  const Built b = built("input a : bool;", "a for 50 ms");
  EXPECT_TRUE(b.has("historically [0, 5] verdicts %0, slot 0")) << b.block();
  EXPECT_TRUE(b.has("elapsed 5 ticks")) << b.block();
}

TEST(WatchBlock, WindowsKeepMarginsUpTo1024TicksAndOnlyWhenThereAreSome) {
  EXPECT_TRUE(built(gap, "once[0 s, 10.24 s] gap >= 1 m").has("once [0, 1024] %2"));
  EXPECT_TRUE(built(gap, "once[0 s, 10.25 s] gap >= 1 m").has("once [0, 1025] verdicts %2"));
  EXPECT_TRUE(built("input a : bool;", "once[0 s, 1 s] a").has("once [0, 100] verdicts %0"));
}

TEST(WatchBlock, ARateIsExactBeforeItComesOntoTheUsualGrid) {
  const Built b = built(gap, "rate[0 s, 100 ms](gap) <= 0.5 m/s");
  EXPECT_TRUE(b.has("rate [0, 10] %0, slot 0 : 1/100 m/s")) << b.block();
  EXPECT_TRUE(b.has("const 500 : 1/1000 m/s")) << b.block();
}

TEST(WatchBlock, ASumOverAllOfThePastIsRefused) {
  EXPECT_NE(built(gap, "sum[0 s, inf](gap) <= 1 m").diagnostics.error_count(), 0);
}

TEST(WatchBuilder, RangesEndOutsideAndErrorsAreRoundedUp) {
  const Built b = built("input x : length in 0.0004 m .. 1.0006 m error 0.1 mm;", "x >= 0 m");
  EXPECT_TRUE(b.has("input x : number on mm [0, 1001] error 1, every tick")) << print(b.module);
}

// A parameter never leaves the range that was declared.
TEST(WatchBuilder, RangesOfParametersEndInside) {
  const Built b =
      built(std::string(gap) + "param h : length in 0.4 mm .. 1000.6 mm = 0.5 m;", "gap >= h");
  EXPECT_TRUE(b.has("param h on mm [1, 1000] = 500")) << print(b.module);
}

// The sizes of bodies are none that a property writes: they may lie between two steps.
TEST(WatchBuilder, TheSizesOfBodiesAreKnownAsWellAsTheirGridAllows) {
  const Built b = built(
      "robot Cart { body radius 10.03 cm; motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake "
      ">= 1 m/s^2; } sense position : point error 1 cm max_age 1 s; sense velocity : vector error "
      "1 cm/s max_age 1 s; output push : acceleration; latency 20 ms; }\nfleet one, two : Cart;",
      "distance(one, two) >= 1 m");
  ASSERT_FALSE(b.diagnostics.has_errors()) << b.report();
  EXPECT_TRUE(b.has("between 200, 201 : mm")) << b.block();
}

TEST(WatchBuilder, AnInputWithoutARangeHasADefaultOne) {
  EXPECT_TRUE(built("input x : length;", "x >= 0 m").has("by default"));
}

TEST(WatchBuilder, AGridFinerThanAMillionthOfTheScaleIsRefused) {
  const std::string report =
      built("input x : real [m] in 0 m .. 1 m resolution 0.0000001 m;", "x >= 0 m").report();
  EXPECT_EQ(report.substr(0, 5), "7001:") << report;
  EXPECT_EQ(
      built("input x : real [m] in 0 m .. 1 m resolution 0.0000001 m;\nscale 0.1 m;", "x >= 0 m")
          .report(),
      "");
}

TEST(WatchVerifier, FindsWhatPassesRelyOn) {
  Built b = built("input a, b : bool;", "once[0 s, 1 s] a and once[0 s, 1 s] b");
  ASSERT_EQ(verify(b.module).value_or(""), "");
  b.module.watch->slots = 1;
  EXPECT_NE(verify(b.module).value_or("").find("slot that the state does not have"),
            std::string::npos);
  b.module.watch->slots = 2;
  std::get<Once>(b.module.watch->monitors[0].property.values[3].op).slot = 0;
  EXPECT_NE(verify(b.module).value_or("").find("slot that another operator has"),
            std::string::npos);
  b.module.watch->monitors[0].property.values[0].op = PairReach{0};
  EXPECT_NE(verify(b.module).value_or("").find("another robot outside"), std::string::npos);
  b.module.watch->monitors[0].property.values[0].op = ChargeReach{0};
  EXPECT_NE(verify(b.module).value_or("").find("an operation of robots"), std::string::npos);
}

TEST(Units, ACommonStepDividesBoth) {
  EXPECT_EQ(common_step(Rational(1, 100), Rational(3, 1000)), Rational(1, 1000));
  EXPECT_EQ(common_step(6, 4), 2);
}

TEST(Units, AreNamedByStepDimensionAndUnusualScale) {
  const sema::Dimension speed{.m = 1, .s = -1};
  EXPECT_EQ(name(Unit::mm), "mm");
  EXPECT_EQ(name(Unit(speed, Rational(1, 1000), 1)), "1/1000 m/s");
  EXPECT_EQ(name(Unit(speed, Rational(1, 1000), Rational(1, 2))), "1/1000 m/s by 1/2");
  EXPECT_EQ(Unit(speed, Rational(1, 1000), Rational(1, 2)).weight(), 2000);
}

}  // namespace
}  // namespace rtac::ir::test
