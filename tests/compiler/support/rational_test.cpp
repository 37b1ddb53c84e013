// Numbers of a specification are exact: what is written is what is computed with and shown.
#include "compiler/support/rational.h"

#include <gtest/gtest.h>

#include <limits>

namespace rtac {
namespace {

TEST(ParseDecimal, IsExact) {
  // 0.1 has no exact binary form: a detour over double would show here.
  EXPECT_EQ(*parse_decimal("0.1"), Rational(1, 10));
  EXPECT_EQ(*parse_decimal("12"), Rational(12));
  EXPECT_EQ(*parse_decimal("0.110"), Rational(11, 100));
  EXPECT_EQ(*parse_decimal("007"), Rational(7));
}

TEST(ParseDecimal, ReadsExponents) {
  EXPECT_EQ(*parse_decimal("1e-3"), Rational(1, 1000));
  EXPECT_EQ(*parse_decimal("2.5E+2"), Rational(250));
  EXPECT_EQ(*parse_decimal("0e0"), Rational(0));
}

TEST(ParseDecimal, RejectsEverythingElse) {
  for (const char* text : {"", ".", "5.", ".5", "-1", "+1", "1e", "1e+", "1 ", " 1", "0x10",
                           "1.2.3", "1e2.5", "nan", "inf", "1,5"}) {
    EXPECT_FALSE(parse_decimal(text)) << text;
  }
}

TEST(ParseDecimal, BoundsDigitsAndExponent) {
  // `1e999999999` must not fill the memory.
  EXPECT_TRUE(parse_decimal("1e64"));
  EXPECT_FALSE(parse_decimal("1e65"));
  EXPECT_FALSE(parse_decimal("1e-65"));
  EXPECT_FALSE(parse_decimal("1e999999999999999999999"));
  EXPECT_TRUE(parse_decimal(std::string(64, '9')));
  EXPECT_FALSE(parse_decimal(std::string(65, '9')));
}

TEST(ToDecimal, IsShortestWhenItTerminates) {
  EXPECT_EQ(to_decimal(Rational(1, 10)), "0.1");
  EXPECT_EQ(to_decimal(Rational(5)), "5");
  EXPECT_EQ(to_decimal(Rational(-11, 100)), "-0.11");
  EXPECT_EQ(to_decimal(Rational(0)), "0");
  EXPECT_EQ(to_decimal(Rational(1, 1000000000)), "0.000000001");
  EXPECT_EQ(to_decimal(Rational(1200)), "1200");
}

TEST(ToDecimal, RoundsToSixSignificantDigits) {
  EXPECT_EQ(to_decimal(Rational(1, 3)), "0.333333");
  EXPECT_EQ(to_decimal(Rational(2, 3)), "0.666667");
  EXPECT_EQ(to_decimal(Rational(-200, 3)), "-66.6667");
  EXPECT_EQ(to_decimal(Rational(1, 3000)), "0.000333333");
  EXPECT_EQ(to_decimal(Rational(20000000, 3)), "6666670");
  EXPECT_EQ(to_decimal(Rational(29999999, 30000000)), "1");
}

TEST(Rounding, GoesTheNamedWayForBothSigns) {
  EXPECT_EQ(floor_to_int(Rational(7, 2)), 3);
  EXPECT_EQ(floor_to_int(Rational(-7, 2)), -4);
  EXPECT_EQ(ceil_to_int(Rational(7, 2)), 4);
  EXPECT_EQ(ceil_to_int(Rational(-7, 2)), -3);
  EXPECT_EQ(floor_to_int(Rational(-4)), -4);
  EXPECT_EQ(ceil_to_int(Rational(-4)), -4);
}

TEST(FitsInt64, IsExactAtTheEnds) {
  const Rational highest{std::numeric_limits<long>::max()};
  const Rational lowest{std::numeric_limits<long>::min()};
  EXPECT_TRUE(fits_int64(highest));
  EXPECT_TRUE(fits_int64(lowest));
  EXPECT_FALSE(fits_int64(highest + 1));
  EXPECT_FALSE(fits_int64(lowest - 1));
  EXPECT_EQ(floor_to_int(lowest), std::numeric_limits<std::int64_t>::min());
}

}  // namespace
}  // namespace rtac
