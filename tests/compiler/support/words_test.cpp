// Numbers in sentences.
#include "compiler/support/words.h"

#include <gtest/gtest.h>

namespace rtac {
namespace {

TEST(Words, AreasHaveThreeDigitsFromAbove) {
  EXPECT_EQ(square_metres(Rational(1'072'552'299, 1'000'000)), "1080 m^2");
  EXPECT_EQ(square_metres(Rational(40)), "40 m^2");
  EXPECT_EQ(square_metres(Rational(1000)), "1000 m^2");
  EXPECT_EQ(square_metres(Rational(160'001, 1'000'000)), "0.161 m^2");
  EXPECT_EQ(square_metres(Rational(1, 300'000)), "0.00000334 m^2");
  EXPECT_EQ(square_metres(Rational(0)), "0 m^2");
}

}  // namespace
}  // namespace rtac
