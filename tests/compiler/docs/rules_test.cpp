// Every numbered rule of the language reference, by its name: its examples, its tables, and what
// neither can show. Rules about robots are tested on whole decisions in tests/kernel as well.
#include "compiler/interp/interpreter.h"
#include "tests/compiler/docs/reference.h"
#include "tests/compiler/interp/testing.h"

namespace rtac::docs {
namespace {

using interp::Inputs;
using interp::Interpreter;
using interp::Sample;
using interp::test::monitor;
using interp::test::show;

constexpr std::int64_t second_us = 1'000'000;

Inputs sample(bool value, std::int64_t stamp_us) {
  return {Sample{{Rational(value ? 1 : 0)}, stamp_us}};
}

TEST(Rule1_1, IsAsShown) {
  expect_as_shown("1.1");
}
// A step that comes again within its tick, or a clock that goes backwards, moves nothing.
TEST(Rule1_1, ASecondStepWithinATickJudgesNothing) {
  const auto c = monitor("input p : bool max_age inf;", "previously p");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  interpreter.step(0, sample(true, 0));
  EXPECT_EQ(show(interpreter.step(1000, sample(false, 1000)).front()), "false [-inf, -inf]");
  EXPECT_EQ(show(interpreter.step(-second_us, sample(false, 0)).front()), "false [-inf, -inf]");
  EXPECT_EQ(show(interpreter.step(second_us, sample(true, second_us)).front()), "true [inf, inf]");
}
TEST(Rule1_2, IsAsShown) {
  expect_as_shown("1.2");
}
TEST(Rule1_3, IsAsShown) {
  expect_as_shown("1.3");
}

TEST(Rule2_1, IsAsShown) {
  expect_as_shown("2.1");
}
TEST(Rule2_2, IsAsShown) {
  expect_as_shown("2.2");
}
TEST(Rule2_3, IsAsShown) {
  expect_as_shown("2.3");
}
TEST(Rule2_4, IsAsShown) {
  expect_as_shown("2.4");
}
TEST(Rule2_5, IsAsShown) {
  expect_as_shown("2.5");
}
TEST(Rule2_6, IsAsShown) {
  expect_as_shown("2.6");
}
TEST(Rule2_7, IsAsShown) {
  expect_as_shown("2.7");
}
TEST(Rule2_8, IsAsShown) {
  expect_as_shown("2.8");
}
TEST(Rule2_9, IsAsShown) {
  expect_as_shown("2.9");
}

TEST(Rule3, IsAsShown) {
  expect_as_shown("3");
}
// What a condition without margins remembers does not depend on the length of its window.
TEST(Rule3, BooleanWindowsCostTheSameWhateverTheirLength) {
  const Workbench workbench;
  const auto summary = [](const std::string& window) {
    driver::test::write(
        "spec.rta",
        "spec s;\nperiod 1 ms;\ninput p, q : bool;\nmonitor m { \"R1: p\" always once[0 s, " +
            window + "] p and q since[0 s, " + window + "] p; }\n");
    return driver::test::rtac({"check", "spec.rta"}).out;
  };
  const std::string remembered = summary("10 ms");
  EXPECT_NE(remembered.find("remembers"), std::string::npos) << remembered;
  EXPECT_EQ(remembered, summary("24 h"));
}
TEST(Rule3, MoreMemoryThanAllowedIsRefused) {
  const Workbench workbench;
  driver::test::write(
      "spec.rta",
      "spec s;\nperiod 1 s;\ninput x : real in 0 .. 9;\nmonitor m { \"R1: x\" always "
      "max[0 s, 900 s](x) <= 5; }\n");
  const auto outcome = driver::test::rtac({"check", "--max-bytes", "1000", "spec.rta"});
  EXPECT_EQ(said(outcome.status, outcome.err).codes, Codes{"9007"});
}

TEST(Rule4_1, IsAsShown) {
  expect_as_shown("4.1");
}
TEST(Rule4_2, IsAsShown) {
  expect_as_shown("4.2");
}
TEST(Rule4_3, IsAsShown) {
  expect_as_shown("4.3");
}
TEST(Rule4_4, IsAsShown) {
  expect_as_shown("4.4");
}
TEST(Rule4_5, IsAsShown) {
  expect_as_shown("4.5");
}
TEST(Rule4_6, IsAsShown) {
  expect_as_shown("4.6");
}
TEST(Rule4_7, IsAsShown) {
  expect_as_shown("4.7");
}

TEST(Rule5, IsAsShown) {
  expect_as_shown("5");
}

TEST(Rule6_1, IsAsShown) {
  expect_as_shown("6.1");
}
TEST(Rule6_2, IsAsShown) {
  expect_as_shown("6.2");
}
TEST(Rule6_2, AStampFromTheFutureOrGoingBackwardsIsUnknownForThisTickOnly) {
  const auto c = monitor("input p : bool max_age inf;", "p");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  const auto found = [&](std::int64_t now_us, std::int64_t stamp_us) {
    return interpreter.step(now_us, sample(true, stamp_us)).front().verdict;
  };
  EXPECT_EQ(found(0, 1), interp::Verdict::unknown);
  EXPECT_EQ(found(second_us, second_us), interp::Verdict::yes);
  EXPECT_EQ(found(2 * second_us, second_us - 1), interp::Verdict::unknown);
  EXPECT_EQ(found(3 * second_us, 3 * second_us), interp::Verdict::yes);
}
TEST(Rule6_3, IsAsShown) {
  expect_as_shown("6.3");
}
TEST(Rule6_4, IsAsShown) {
  expect_as_shown("6.4");
}
TEST(Rule6_5, IsAsShown) {
  expect_as_shown("6.5");
}
TEST(Rule6_6, IsAsShown) {
  expect_as_shown("6.6");
}
TEST(Rule6_7, IsAsShown) {
  expect_as_shown("6.7");
}

TEST(Rule7_1, IsAsShown) {
  expect_as_shown("7.1");
}
TEST(Rule7_2, IsAsShown) {
  expect_as_shown("7.2");
}
TEST(Rule7_3, IsAsShown) {
  expect_as_shown("7.3");
}
TEST(Rule7_4, IsAsShown) {
  expect_as_shown("7.4");
}
// Nobody knows when a tick was that no step belongs to.
TEST(Rule7_4, NothingIsKnownOfAZoneAtAMissedTick) {
  const auto c = monitor(
      "clock utc;\nzone z = circle (0 m, 0 m) radius 1 m during 00:00 .. 00:01;\n"
      "input p : point max_age inf;",
      "historically[0 s, 2 s] p inside z");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  const Inputs inside = {Sample{{Rational(0), Rational(0)}, 0}};
  EXPECT_EQ(show(interpreter.step(0, inside).front()).substr(0, 4), "true");
  EXPECT_EQ(show(interpreter.step(2 * second_us, inside).front()).substr(0, 7), "unknown");
}
TEST(Rule7_5, IsAsShown) {
  expect_as_shown("7.5");
}
TEST(Rule7_6, IsAsShown) {
  expect_as_shown("7.6");
}
TEST(Rule7_7, IsAsShown) {
  expect_as_shown("7.7");
}
TEST(Rule7_8, IsAsShown) {
  expect_as_shown("7.8");
}
TEST(Rule8, IsAsShown) {
  expect_as_shown("8");
}
TEST(Rule8_1, IsAsShown) {
  expect_as_shown("8.1");
}
TEST(Rule9_1, IsAsShown) {
  expect_as_shown("9.1");
}
TEST(Rule9_2, IsAsShown) {
  expect_as_shown("9.2");
}
TEST(Rule9_3, IsAsShown) {
  expect_as_shown("9.3");
}
TEST(Rule9_4, IsAsShown) {
  expect_as_shown("9.4");
}
TEST(Rule9_5, IsAsShown) {
  expect_as_shown("9.5");
}
TEST(Rule9_6, IsAsShown) {
  expect_as_shown("9.6");
}
TEST(Rule9_7, IsAsShown) {
  expect_as_shown("9.7");
}
TEST(Rule9_8, IsAsShown) {
  expect_as_shown("9.8");
}
TEST(Rule9_9, IsAsShown) {
  expect_as_shown("9.9");
}
TEST(Rule10, IsAsShown) {
  expect_as_shown("10");
}
TEST(Rule11, IsAsShown) {
  expect_as_shown("11");
}
TEST(Rule12, IsAsShown) {
  expect_as_shown("12");
}
TEST(Rule12_1, IsAsShown) {
  expect_as_shown("12.1");
}

TEST(Rule13_1, IsAsShown) {
  expect_as_shown("13.1");
}
TEST(Rule13_2, IsAsShown) {
  expect_as_shown("13.2");
}
TEST(Rule13_3, IsAsShown) {
  expect_as_shown("13.3");
}
// Up to 0.4 m the level has to be higher; going back, or beyond the range, is ignored.
TEST(Rule13_3, AParameterOnlyTightens) {
  const auto c = monitor(
      "input x : real [m] in 0 .. 2 m max_age inf; param h : length in 0.1 m .. 0.5 m = 0.2 m;",
      "x >= h");
  ASSERT_TRUE(c->spec);
  Interpreter interpreter(*c->spec);
  std::int64_t now_us = 0;
  const auto margin_with = [&](const Rational& h) {
    interpreter.set_param(sema::ParamId{0}, h);
    const Inputs level = {Sample{{Rational(1)}, now_us}};
    const std::string found = show(interpreter.step(now_us, level).front());
    now_us += second_us;
    return found;
  };
  EXPECT_EQ(margin_with(Rational(2, 5)), "true [0.6, 0.6] m");
  EXPECT_EQ(margin_with(Rational(1, 5)), "true [0.6, 0.6] m");
  EXPECT_EQ(margin_with(Rational(9)), "true [0.6, 0.6] m");
}

// The specification of a rule, built in a folder: the files by name.
std::map<std::string, std::string> built(const std::string& rule, const std::string& folder) {
  for (const auto& [number, fences] : rules()) {
    if (number == rule) driver::test::write(fs::path(folder) / "spec.rta", fences.front().text);
  }
  const auto outcome =
      driver::test::rtac({"build", folder + "/spec.rta", "-o", folder + "/generated"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::map<std::string, std::string> files;
  for (const auto& file : fs::directory_iterator(folder + "/generated")) {
    files[file.path().filename().string()] = driver::test::read(file.path());
  }
  return files;
}

TEST(Rule14, IsAsShown) {
  expect_as_shown("14");
}
// `class`, `double`, `while` and `errno` are names of specifications, and of nothing in C or C++.
TEST(Rule14, NamesOfOtherLanguagesCompile) {
  const Workbench workbench;
  EXPECT_FALSE(built("14", ".").empty());
  const std::string quiet = " >/dev/null 2>compiler.err";
  const std::string compiler = "${CC:-cc} -std=c99 -Wall -Wextra -Werror -fsyntax-only ";
  for (const std::string language : {"-x c -include errno.h", "-x c"}) {
    const std::string command = compiler + language + " generated/spec_kernel.c" + quiet;
    EXPECT_EQ(std::system(command.c_str()), 0) << driver::test::read("compiler.err");
  }
}

TEST(Rule15, IsAsShown) {
  expect_as_shown("15");
}
TEST(Rule15, TheSameFilesGiveTheSameFiles) {
  const Workbench workbench;
  const auto one = built("15", "one");
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(one, built("15", "another place"));
}

}  // namespace
}  // namespace rtac::docs
