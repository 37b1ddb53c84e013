// Legs and paths: generated code against exact geometry, and exact geometry against many places
// along them. On the grid and off it, with holes, along walls, through corners.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/differential/batch.h"

namespace rtac::differential {
namespace {

using driver::Observed;
using interp::Reading;
using interp::Waypoint;

const char* const spec =
    "spec s;\nperiod 1 s;\n"
    "zone yard = polygon [(0 m, 0 m), (10 m, 0 m), (10 m, 4 m), (6 m, 4 m), (6 m, 6 m), "
    "(10 m, 6 m), (10 m, 10 m), (0 m, 10 m)] hole [(2 m, 2 m), (4 m, 2 m), (4 m, 4 m), "
    "(2 m, 4 m)];\n"
    "zone pond = circle (5 m, 5 m) radius 2 m;\n"
    "zone lane = grow(rectangle (1 m, 1 m) to (9 m, 1.5 m), 30 cm);\n"
    "input plan : path[6] max_age 3 s;\ninput other : path[3] max_age inf;\n"
    "input p : point in -20 .. 20 m;\ninput q : point in -20 .. 20 m error 2 cm;\n"
    "input r : point in -20 .. 20 m resolution 0.7 mm;\n"
    "monitor a { \"R1\" always plan inside yard; }\n"
    "monitor b { \"R2\" always plan inside complement(pond); }\n"
    "monitor c { \"R3\" always clearance(plan, yard) >= 10 cm; }\n"
    "monitor d { \"R4\" always distance(plan, pond) >= 20 cm; }\n"
    "monitor e { \"R5\" always leg(q, plan) inside yard; }\n"
    "monitor f { \"R6\" always path(p, r, plan) inside yard; }\n"
    "monitor g { \"R7\" always leg(p, r) inside lane; }\n"
    "monitor h { \"R8\" always distance(leg(p, q), lane) >= 1 m; }\n"
    "monitor i { \"R9\" always distance(plan, other) >= 50 cm; }\n"
    "monitor j { \"R10\" always distance(path(p, q, r), plan) >= 50 cm; }\n"
    "monitor k { \"R11\" always distance(leg(p, plan), r) <= 1 m; }\n"
    "monitor l { \"R12\" always clearance(leg(p, r), yard) >= -1 m; }\n"
    "monitor m { \"R13\" always once[0 s, 2 s] leg(p, r) inside complement(yard); }\n"
    "monitor n { \"R14\" always min[0 s, 2 s](clearance(leg(p, r), yard)) >= 0 m; }\n"
    "monitor o { \"R15\" always clearance(plan, complement(pond)) >= 0 m or distance(plan, q) < 1 "
    "m; "
    "}\n";

class Trails : public ::testing::TestWithParam<unsigned> {
 protected:
  double any(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool one_of(unsigned n) { return random_() % n == 0; }
  // On corners and walls, near them, on whole metres, or anywhere.
  std::pair<double, double> place() {
    static constexpr double walls[] = {0, 1, 1.5, 2, 3, 4, 5, 6, 7, 9, 10};
    const auto coordinate = [&] {
      if (one_of(3)) return any(-2, 12);
      const double off = one_of(2) ? 0 : one_of(2) ? 0.001 : any(-0.02, 0.02);
      return walls[random_() % 11] + off;
    };
    const double x = coordinate();
    return {x, coordinate()};
  }
  Reading path(std::size_t most) {
    Reading reading;
    const std::size_t count = random_() % (most + 2);
    if (count > most || one_of(20)) {  // too many of them, or not finite
      reading.kind = Reading::Kind::unknown;
      return reading;
    }
    std::vector<Waypoint> points;
    for (std::size_t k = 0; k < count; ++k) {
      const auto [x, y] = place();
      points.push_back({std::lround(x * 1000), std::lround(y * 1000)});
    }
    if (one_of(30) && count > 0) points[0].x_mm = (std::int64_t{1} << 29) + 1;
    reading.kind = Reading::Kind::number;
    reading.number = interp::Decimal(1);
    reading.path = std::make_shared<const std::vector<Waypoint>>(std::move(points));
    return reading;
  }
  void put_path(std::size_t most, std::int64_t now_us, std::vector<Observed>& to) {
    const bool is_new = one_of(2);
    to.push_back({path(most), now_us, is_new});
    const auto next = static_cast<std::int64_t>(random_() % (most + 2)) - (one_of(20) ? 2 : 0);
    to.push_back({{Reading::Kind::number, interp::Decimal(next)}, now_us, is_new});
  }
  void put_point(std::int64_t now_us, std::vector<Observed>& to) {
    const auto [x, y] = place();
    for (const double metres : {x, y}) {
      const std::string text = to_decimal(Rational(std::lround(metres * 1e4), 10000UL));
      const bool known = !one_of(60);
      to.push_back(
          {{known ? Reading::Kind::number : Reading::Kind::unknown, *interp::Decimal::parse(text)},
           now_us,
           true});
    }
  }
  std::mt19937 random_{GetParam()};
};

TEST_P(Trails, AreJudgedConservativelyAndTightly) {
  const auto checked = check(spec, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const driver::LoadedKernel alone = load_verdicts(code);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  std::vector<driver::Judgement> exact, found, verdicts;
  std::vector<std::size_t> yes(15, 0), no(15, 0);
  std::size_t tight = 0;
  constexpr std::size_t touching_last = 11;  // `l` asks for a clearance below 0
  for (std::int64_t tick = 0; tick < 800; ++tick) {
    const std::int64_t now_us = tick * 1000000;
    std::vector<Observed> inputs;
    put_path(6, now_us, inputs);
    put_path(3, now_us, inputs);
    for (int k = 0; k < 3; ++k) put_point(now_us, inputs);
    reference->step(now_us, inputs, exact);
    kernel.engine->step(now_us, inputs, found);
    alone.engine->step(now_us, inputs, verdicts);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      SCOPED_TRACE("monitor " + std::to_string(k) + " at tick " + std::to_string(tick) +
                   ": exact " + exact[k].margin + ", found " + found[k].margin);
      ASSERT_EQ(verdicts[k].verdict, found[k].verdict);
      const bool is_unknown = found[k].verdict == interp::Verdict::unknown;
      ASSERT_TRUE(is_unknown || found[k].verdict == exact[k].verdict);
      const auto e = reference->margin(k), f = kernel.engine->margin(k);
      ASSERT_FALSE(e.lo < f.lo);
      ASSERT_FALSE(f.hi < e.hi);
      if (exact[k].verdict == interp::Verdict::unknown) continue;
      const bool holds = exact[k].verdict == interp::Verdict::yes;
      (holds ? yes : no)[k] += 1;
      if (k > touching_last || !e.lo.is_finite() || !e.hi.is_finite()) continue;
      // What touches a boundary may cross it, for all that bounds can tell.
      const Rational off = holds ? e.lo.value() : Rational(-e.hi.value());
      const Rational beyond = off - (k == touching_last && holds ? 1 : 0);
      if (beyond <= Rational(12, 1000)) continue;
      EXPECT_FALSE(is_unknown);
      if (!holds) continue;
      ASSERT_TRUE(f.lo.is_finite());
      EXPECT_LE(e.lo.value() - f.lo.value(), Rational(9, 1000));
      ++tight;
    }
  }
  for (std::size_t k = 0; k < yes.size(); ++k) {
    SCOPED_TRACE("monitor " + std::to_string(k));
    EXPECT_GT(yes[k], 2U);
    EXPECT_GT(no[k], 15U);
  }
  EXPECT_GT(tight, 700U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Trails, ::testing::Values(1U, 2U));

}  // namespace
}  // namespace rtac::differential
