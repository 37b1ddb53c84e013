// Rule 13.1: a comparison of an input with a point of its grid is exact for every double, strict or
// not: the kernel never leaves open what the reference decides.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "compiler/driver/replay.h"
#include "tests/differential/engines.h"

namespace rtac::differential {
namespace {

using driver::Observed;

constexpr double step_m = 1e-3;

// The exact value of a double: the decimal digits of one below 4 in 2^-60ths end.
Observed observed(double value, std::int64_t now_us) {
  char text[96];
  std::snprintf(text, sizeof text, "%.60f", value);
  return {{interp::Reading::Kind::number, *interp::Decimal::parse(text)}, now_us, true};
}

// A limit as the nearest double, its neighbours, and places within a step on either side.
std::vector<double> beside(double limit) {
  return {limit,
          std::nextafter(limit, -9),
          std::nextafter(limit, 9),
          limit - step_m / 2,
          limit + step_m / 2,
          limit - step_m,
          limit + step_m};
}

std::vector<std::string> properties() {
  std::vector<std::string> all;
  for (const std::string op : {"<", "<=", ">", ">="}) {
    for (const char* left : {"x", "-x", "x + 0.1 m", "0.1 m - x", "abs(x)", "abs(x - 0.3 m)",
                             "min(x, 0.2 m)", "max(x, -0.2 m)", "max(-x, x)", "min[0 s, 3 s](x)",
                             "max[1 s, 2 s](x)", "(if x > 0.3 m then x else -x)"}) {
      for (const char* right : {"0.3 m", "-0.3 m"}) {
        all.push_back(std::string(left) + " " + op + " " + right);
      }
    }
    // parameters tighten: up where they are limits from below
    const std::string limit = op[0] == '<' ? "g" : "h";
    all.push_back("x " + op + " " + limit);
    all.push_back("x - " + limit + " " + op + " 0.1 m");
    all.push_back("not x " + op + " 0.3 m");
    all.push_back("y " + op + " 0.3 m");  // with an error
    all.push_back("count[0 s, 2 s](x " + op + " 0.3 m) >= 2");
    all.push_back("k + 1 " + op + " 3");
  }
  return all;
}

TEST(Limits, AreComparedExactlyWithEveryDouble) {
  std::string text =
      "spec s;\nperiod 1 s;\ninput x : real [m] in -2 m .. 2 m;\n"
      "input y : real [m] in -2 m .. 2 m error 1 cm;\ninput k : int in -9 .. 9;\n"
      "param g : length in 0.1 m .. 0.5 m = 0.3 m;\nparam h : length in 0.1 m .. 0.5 m = 0.3 m;\n";
  const std::vector<std::string> all = properties();
  for (std::size_t k = 0; k < all.size(); ++k) {
    text += "monitor m" + std::to_string(k) + " { \"R1: at a limit\" always " + all[k] + "; }\n";
  }
  const auto checked = check(text, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::LoadedKernel kernel = load(driver::kernel_code(checked->compilation));
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  std::vector<driver::Judgement> exact, found;
  std::int64_t tick = 0;
  for (const double limit : {0.0, 0.2, 0.3, 0.6}) {
    for (const double value : beside(limit)) {
      for (const double x : {value, -value}) {
        const std::int64_t now_us = tick * 1'000'000;
        const auto k = static_cast<double>(tick++ % 5);
        const std::vector<Observed> inputs = {observed(x, now_us), observed(x, now_us),
                                              observed(k, now_us)};
        reference->step(now_us, inputs, exact);
        kernel.engine->step(now_us, inputs, found);
        for (std::size_t m = 0; m < all.size(); ++m) {
          ASSERT_EQ(found[m].verdict, exact[m].verdict) << all[m] << " at " << x;
        }
      }
    }
  }
}

// A step of 400 km weighs 4e17 millionths of a micrometre: the most that a margin may still hold.
// It is cut off beyond one step, and keeps its sign: the step and the entry for verdicts agree.
TEST(Limits, AreComparedExactlyWhereOneStepFillsTheMargin) {
  std::string text =
      "spec s;\nperiod 1 s;\nscale 1 um;\n"
      "input x : real [m] in -1e9 m .. 1e9 m resolution 400000 m;\n";
  for (const char* op : {"<", "<=", ">", ">="}) {
    const std::string name = "m" + std::to_string(text.size());
    text += "monitor " + name + " { \"R1: at a limit\" always x " + op + " 400000 m; }\n";
  }
  const auto checked = check(text, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel whole = load(code), verdicts = load_verdicts(code);
  ASSERT_NE(whole.engine, nullptr) << whole.problem;
  ASSERT_NE(verdicts.engine, nullptr) << verdicts.problem;
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  std::vector<driver::Judgement> exact, found, alone;
  for (std::int64_t tick = 0; tick <= 6; ++tick) {
    const std::int64_t now_us = tick * 1'000'000;
    const std::vector<Observed> inputs = {
        observed(400'000.0 * static_cast<double>(tick - 3), now_us)};
    reference->step(now_us, inputs, exact);
    whole.engine->step(now_us, inputs, found);
    verdicts.engine->step(now_us, inputs, alone);
    for (std::size_t m = 0; m < exact.size(); ++m) {
      EXPECT_EQ(found[m].verdict, exact[m].verdict) << m << " at tick " << tick;
      EXPECT_EQ(alone[m].verdict, exact[m].verdict) << m << " at tick " << tick;
    }
  }
}

}  // namespace
}  // namespace rtac::differential
