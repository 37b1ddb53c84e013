// Units have one dimension and one exact factor each; what is not one is explained.
#include "compiler/sema/units.h"

#include <gtest/gtest.h>

namespace rtac::sema {
namespace {

struct Case {
  const char* text;
  Dimension dimension;
  Rational factor;
};

TEST(Units, HaveExactFactors) {
  const Case cases[] = {
      {"m", dims::length, 1},
      {"cm", dims::length, Rational(1, 100)},
      {"mm", dims::length, Rational(1, 1000)},
      {"km", dims::length, 1000},
      {"s", dims::time, 1},
      {"ms", dims::time, Rational(1, 1000)},
      {"us", dims::time, Rational(1, 1000000)},
      {"min", dims::time, 60},
      {"h", dims::time, 3600},
      {"rad", dims::angle, 1},
      {"%", dims::ratio, Rational(1, 100)},
      {"kg", {.kg = 1}, 1},
      {"g", {.kg = 1}, Rational(1, 1000)},
      {"A", {.A = 1}, 1},
      {"K", {.K = 1}, 1},
      {"Hz", {.s = -1}, 1},
      {"m/s", dims::speed, 1},
      {"km/h", dims::speed, Rational(5, 18)},
      {"m/s^2", dims::acceleration, 1},
      {"rad/s^2", dims::turn_acceleration, 1},
      {"%/m", dims::ratio_per_length, Rational(1, 100)},
      {"%/s", dims::ratio_per_time, Rational(1, 100)},
      {"1/s", {.s = -1}, 1},
      {"cm^2", {.m = 2}, Rational(1, 10000)},
      {"m/s/s", dims::acceleration, 1},
      {"m*s^-2", dims::acceleration, 1},
  };
  for (const Case& each : cases) {
    const auto meaning = parse_unit(each.text);
    ASSERT_TRUE(meaning) << each.text;
    EXPECT_EQ(meaning->dimension, each.dimension) << each.text;
    EXPECT_EQ(meaning->factor, each.factor) << each.text;
  }
}

// 1 N = 1 kg m/s^2, 1 J = 1 N m, 1 W = 1 J/s, 1 V A = 1 W, 1 Wh = 3600 J.
TEST(Units, DeriveFromEachOther) {
  const auto same = [](const char* a, const char* b) {
    const auto left = parse_unit(a);
    const auto right = parse_unit(b);
    ASSERT_TRUE(left && right) << a << " " << b;
    EXPECT_EQ(left->dimension, right->dimension) << a << " " << b;
    EXPECT_EQ(left->factor, right->factor) << a << " " << b;
  };
  same("N", "kg*m/s^2");
  same("J", "N*m");
  same("W", "J/s");
  same("V*A", "W");
  same("Wh", "W*h");
  same("kWh", "kW*h");
  same("Ah", "A*h");
  same("kHz", "1/ms");
}

// A bound in degrees must not become smaller than what was written: pi is rounded up, by less
// than any grid can show.
TEST(Units, DegreesAreRoundedUp) {
  const auto degree = parse_unit("deg");
  ASSERT_TRUE(degree);
  EXPECT_EQ(degree->dimension, dims::angle);
  const Rational below("31415926535897932384626/10000000000000000000000");  // pi, cut off
  EXPECT_GT(Rational(degree->factor * 180), below);
  EXPECT_LT(Rational(degree->factor * 180 - below), Rational("1/100000000000000000000"));
}

TEST(Units, RejectsWhatIsNotOne) {
  for (const char* text : {"", "sm", "meters", "m/", "/s", "m^", "m^0", "m^33", "m^100", "m^x",
                           "m//s", "M", "m s", "Kg", "2m"}) {
    EXPECT_FALSE(parse_unit(text)) << text;
  }
}

TEST(Units, SuggestsWhatMayBeMeant) {
  const auto suggested = [](const char* text, std::optional<Dimension> due = std::nullopt) {
    return suggest_unit(text, due).value_or("nothing");
  };
  EXPECT_EQ(suggested("sm"), "cm");
  EXPECT_EQ(suggested("meters"), "m");
  EXPECT_EQ(suggested("seconds"), "s");
  EXPECT_EQ(suggested("degrees"), "deg");
  EXPECT_EQ(suggested("percent"), "%");
  EXPECT_EQ(suggested("mps"), "m/s");
  EXPECT_EQ(suggested("kmh"), "km/h");
  EXPECT_EQ(suggested("M"), "m");
  EXPECT_EQ(suggested("KG"), "kg");
  EXPECT_EQ(suggested("m/sec"), "m/s");
  EXPECT_EQ(suggested("meters/sec^2"), "m/s^2");
  EXPECT_EQ(suggested("rads/s"), "rad/s");
  EXPECT_EQ(suggested("furlong"), "nothing");
}

// What is due decides between equally near units.
TEST(Units, SuggestsAUnitOfTheDimensionThatIsDue) {
  EXPECT_EQ(suggest_unit("sm", dims::time), "ms");
  EXPECT_EQ(suggest_unit("sm", dims::length), "cm");
}

TEST(Units, AreNamedInMessages) {
  EXPECT_EQ(describe(dims::speed), "a speed (m/s)");
  EXPECT_EQ(describe(dims::number), "a number without a unit");
  EXPECT_EQ(describe(Dimension{.m = 2, .s = -1}), "a quantity in m^2/s");
  EXPECT_EQ(describe(Dimension{.m = -1}), "a quantity in 1/m");
  EXPECT_EQ(unit_of(dims::ratio_per_length), "%/m");
  EXPECT_EQ(show(Rational(1, 20), dims::ratio), "5 %");
  EXPECT_EQ(show(Rational(1, 25), dims::time), "40 ms");
  EXPECT_EQ(show(Rational(3, 2), dims::time), "1.5 s");
  EXPECT_EQ(show(Rational(-11, 100), dims::length), "-0.11 m");
  // nobody counts zeros
  Rational large = 36;
  for (int i = 0; i < 30; ++i) large *= 10;
  EXPECT_EQ(show(large, dims::time), "3.6e31 s");
  EXPECT_EQ(show(Rational(-large), dims::length), "-3.6e31 m");
  EXPECT_EQ(show(Rational(Rational(1) / large * 36), dims::length), "1e-30 m");
  EXPECT_EQ(show(Rational(1099511627776), dims::time), "1099511627776 s");
  EXPECT_EQ(show(Rational(0), dims::length), "0 m");
}

}  // namespace
}  // namespace rtac::sema
