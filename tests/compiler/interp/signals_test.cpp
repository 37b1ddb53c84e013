// Rules 6 and 13: which sample a tick sees, and when it sees none.
#include "tests/compiler/interp/testing.h"

namespace rtac::interp::test {
namespace {

constexpr std::int64_t second = 1000000;

std::string found(Interpreter& interpreter, std::int64_t now_us, const Inputs& inputs) {
  return show(interpreter.step(now_us, inputs).front());
}

TEST(Signals, APlainInputMustArriveEveryTick) {
  const auto c = monitor("input p : bool;", "p");
  EXPECT_EQ(judge(*c, "time,p\n0,1\n1,\n2,1\n"),
            (Lines{"true [inf, inf]", "unknown [-inf, inf]", "true [inf, inf]"}));
}

TEST(Signals, WithAnAgeLimitTheNewestSampleCountsUpToIt) {
  const auto c = monitor("input p : bool max_age 2 s;", "p");
  EXPECT_EQ(
      judge(*c, "time,p\n0,1\n1,\n2,\n3,\n"),
      (Lines{"true [inf, inf]", "true [inf, inf]", "true [inf, inf]", "unknown [-inf, inf]"}));
}

TEST(Signals, WithoutAnAgeLimitTheLastSampleHoldsForEver) {
  const auto c = monitor("input p : bool max_age inf;", "p");
  EXPECT_EQ(judge(*c, "time,p\n0,\n1,1\n1000,\n"),
            (Lines{"unknown [-inf, inf]", "true [inf, inf]", "true [inf, inf]"}));
}

TEST(Signals, StampsFromTheFutureOrGoingBackwardsAreUnknown) {
  const auto c = monitor("input p : bool max_age inf;", "p");
  ASSERT_TRUE(c->spec);
  const auto sample = [](std::int64_t stamp_us) { return Inputs{Sample{{Rational(1)}, stamp_us}}; };
  Interpreter interpreter(*c->spec);
  EXPECT_EQ(found(interpreter, 0, sample(1)), "unknown [-inf, inf]");
  EXPECT_EQ(found(interpreter, second, sample(second)), "true [inf, inf]");
  EXPECT_EQ(found(interpreter, 2 * second, sample(second - 1)), "unknown [-inf, inf]");
  EXPECT_EQ(found(interpreter, 3 * second, sample(second)), "true [inf, inf]");
}

// The sample stays where it is until another one comes.
TEST(Signals, AStampFromTheFutureCountsWhenItsTimeHasCome) {
  const auto c = monitor("input p : bool max_age inf;", "p");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  EXPECT_EQ(found(interpreter, 0, {Sample{{Rational(1)}, second}}), "unknown [-inf, inf]");
  EXPECT_EQ(found(interpreter, second, {std::nullopt}), "true [inf, inf]");
}

// The last tick is the one before, also when no step belongs to it, or to any.
TEST(Signals, ASampleOfMoreThanAPeriodAgoHasNotArrivedSinceTheLastTick) {
  const auto c = monitor("input p : bool;", "p");
  ASSERT_TRUE(c->spec);
  const auto sample = [](std::int64_t stamp_us) { return Inputs{Sample{{Rational(1)}, stamp_us}}; };
  Interpreter interpreter(*c->spec);
  EXPECT_EQ(found(interpreter, 0, sample(-second)), "unknown [-inf, inf]");
  EXPECT_EQ(found(interpreter, 3 * second, sample(2 * second)), "unknown [-inf, inf]");
  EXPECT_EQ(found(interpreter, 6 * second, sample(5 * second + 1)), "true [inf, inf]");
}

TEST(Signals, AValueOutsideTheRangeIsUnknown) {
  const auto c = monitor("input x : real in 0 .. 3;", "x >= 1");
  EXPECT_EQ(judge(*c, "time,x\n0,3\n1,3.0000001\n2,-1\n"),
            (Lines{"true [2, 2]", "unknown [-inf, inf]", "unknown [-inf, inf]"}));
}

// The components of an input arrive together: half a sample is none for the other half.
TEST(Signals, AMissingComponentIsUnknown) {
  const auto c = monitor("input p : point in -9 m .. 9 m max_age inf;", "p.y >= 0 m");
  EXPECT_EQ(judge(*c, "time,p.x,p.y\n0,1,1\n1,2,\n"),
            (Lines{"true [1, 1] m", "unknown [-inf, inf]"}));
}

TEST(Signals, TheAgeIsThatOfTheNewestSampleAlsoWhenItIsStale) {
  const auto c = monitor("input p : bool max_age 1 s;", "age(p) <= 2 s");
  EXPECT_EQ(judge(*c, "time,p\n0,\n1,1\n2,\n4,\n"),
            (Lines{"unknown [-inf, inf]", "true [2, 2] s", "true [1, 1] s", "false [-1, -1] s"}));
}

TEST(Signals, EnumerationsAndConditionsHaveNoMargin) {
  const auto c = monitor("enum Gear { park, drive } input g : Gear;", "g == park");
  EXPECT_EQ(judge(*c, "time,g\n0,park\n1,drive\n2,nan\n"),
            (Lines{"true [inf, inf]", "false [-inf, -inf]", "unknown [-inf, inf]"}));
}

TEST(Signals, AParameterMovesOnlyWhereItTightens) {
  const auto c = monitor("param h : real in 1 .. 5 = 2; input x : real in 0 .. 9;", "x >= h");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  const auto at = [](std::int64_t now_us) { return Inputs{Sample{{Rational(4)}, now_us}}; };
  EXPECT_EQ(found(interpreter, 0, at(0)), "true [2, 2]");
  interpreter.set_param(sema::ParamId{0}, 3);
  EXPECT_EQ(found(interpreter, second, at(second)), "true [1, 1]");
  interpreter.set_param(sema::ParamId{0}, 1);   // looser
  interpreter.set_param(sema::ParamId{0}, 10);  // out of its range
  EXPECT_EQ(found(interpreter, 2 * second, at(2 * second)), "true [1, 1]");
}

// The grid of a parameter is part of what it means: the kernel has no other values.
TEST(Signals, AParameterBetweenTwoStepsIsTheTighterOne) {
  const auto c =
      monitor("param h : length in 1 m .. 5 m = 2 m; input x : length in 0 m .. 9 m;", "x >= h");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  interpreter.set_param(sema::ParamId{0}, Rational(25001, 10000));
  EXPECT_EQ(found(interpreter, 0, Inputs{Sample{{Rational(4)}, 0}}), "true [1.499, 1.499] m");
}

// At a missed tick it still has the value of the step before.
TEST(Signals, AParameterMovesWithTheNextStep) {
  const auto c = monitor("param h : real in 1 .. 5 = 2;", "previously h <= 2.5");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  interpreter.step(0, {});
  interpreter.set_param(sema::ParamId{0}, 3);
  EXPECT_EQ(found(interpreter, 2 * second, {}), "true [0.5, 0.5]");
  EXPECT_EQ(found(interpreter, 3 * second, {}), "false [-0.5, -0.5]");
}

}  // namespace
}  // namespace rtac::interp::test
