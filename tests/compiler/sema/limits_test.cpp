// Limits of inputs between two steps of the grid: what is known includes all that was declared
// (rule 13.1).
#include "compiler/sema/limits.h"

#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

// As text: "1/4 .. 3/2".
std::string ends(const Measurement& measured) {
  return measured.least->value.get_str() + " .. " + measured.most->value.get_str();
}
Input input(const std::string& declaration, const std::string& property) {
  const auto checked = check_text("spec s;\nperiod 1 s;\nframe base;\ninput x : " + declaration +
                                  ";\nmonitor m { \"R1: a limit\" always " + property + "; }\n");
  EXPECT_TRUE(checked->spec) << checked->reports();
  return checked->spec ? checked->spec->inputs.at(0) : Input{};
}
std::string length(const std::string& limits) {
  const Input x = input("real [m] in " + limits, "x >= 0 m");
  return x.least ? ends(x) : "";
}

TEST(Limits, GoOutwardToTheNextStep) {
  EXPECT_EQ(length("-0.4 mm .. 0.4 mm"), "-1/1000 .. 1/1000");
  EXPECT_EQ(length("0.4 m .. 1.3 m resolution 0.25 m"), "1/4 .. 3/2");
  EXPECT_EQ(length("0.25 m .. 1.5 m resolution 0.25 m"), "1/4 .. 3/2");
}

// No whole number lies between: inward leaves none of them out.
TEST(Limits, OfWholeNumbersGoInward) {
  Input x;
  x.type = InputType::integer;
  x.least = Quantity{Rational(-7, 2), {}};
  x.most = Quantity{Rational(5, 2), {}};
  round_limits(x);
  EXPECT_EQ(ends(x), "-3 .. 2");
}

TEST(Limits, OfHeadingsGoOutwardAsWell) {
  const Input x =
      input("pose of base @ map in -1.0004 .. 1 m, -0.0004 .. 0.0004 rad", "x.heading >= 0 rad");
  ASSERT_TRUE(x.turning && x.turning->least);
  EXPECT_EQ(ends(x), "-1001/1000 .. 1");
  EXPECT_EQ(ends(*x.turning), "-1/1000 .. 1/1000");
}

}  // namespace
}  // namespace rtac::sema::test
