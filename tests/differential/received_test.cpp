// Zones that are received: generated code against exact geometry, while zones come, change and grow
// too old. On the grid and off it, with holes, near vertices and edges.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/differential/batch.h"

namespace rtac::differential {
namespace {

using driver::Observed;

class Received : public ::testing::TestWithParam<unsigned> {
 protected:
  double any(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // A star about a place: its vertices on the grid, or anywhere; with a hole, at times.
  std::string star(bool on_grid) {
    const int count = 3 + static_cast<int>(random_() % 38);
    const double x = any(-50, 50), y = any(-50, 50);
    const auto ring = [&](double least, double most) {
      std::string text, first;
      for (int i = 0; i < count; ++i) {
        const double angle = 2 * 3.14159265358979 * (i + any(0, 0.7)) / count;
        const double radius = any(least, most);
        const auto decimal = [&](double v) {
          const double unit = on_grid ? 1e3 : 1e6;
          return to_decimal(Rational(std::lround(v * unit), on_grid ? 1000UL : 1000000UL));
        };
        const std::string at =
            decimal(x + radius * std::cos(angle)) + " " + decimal(y + radius * std::sin(angle));
        if (i == 0) first = at;
        text += at + ", ";
      }
      return "(" + text + first + ")";
    };
    const double size = std::pow(10, any(0, 2));
    const std::string outer = ring(2 * size, 5 * size);
    return "POLYGON (" + outer +
           (random_() % 3 == 0 && count > 5 ? ", " + ring(0.3 * size, 0.8 * size) : "") + ")";
  }
  // nullptr: a robot refuses it.
  static std::shared_ptr<const interp::ReceivedZone> received(const std::string& wkt) {
    auto regions = geometry::receive_wkt(wkt, 128);
    auto* good = std::get_if<geometry::ReceivedRegions>(&regions);
    if (good == nullptr) return nullptr;
    auto tables = geometry::make_zone_tables(*good, 128);
    auto* made = std::get_if<geometry::ZoneTables>(&tables);
    if (made == nullptr) return nullptr;
    return std::make_shared<const interp::ReceivedZone>(
        interp::ReceivedZone{std::move(*good), std::move(*made)});
  }
  static Observed number(double metres, std::int64_t now_us) {
    const std::string text = to_decimal(Rational(std::lround(metres * 1e4), 10000UL));
    return {{interp::Reading::Kind::number, *interp::Decimal::parse(text)}, now_us, true};
  }
  // On a vertex of the zone, near it, on the way to the next one, or anywhere.
  std::pair<double, double> place(const interp::ReceivedZone* zone) {
    if (zone == nullptr || random_() % 3 == 0) return {any(-300, 300), any(-300, 300)};
    const auto& edges = zone->tables.within.edges;
    const auto& e = edges[random_() % edges.size()];
    const double t = static_cast<double>(random_() % 5) / 4;
    const double off = random_() % 2 == 0 ? 0 : any(-0.01, 0.01);
    return {(e.a.x_mm + t * (e.b.x_mm - e.a.x_mm)) / 1000.0 + off,
            (e.a.y_mm + t * (e.b.y_mm - e.a.y_mm)) / 1000.0 - off};
  }
  std::mt19937 random_{GetParam()};
};

const char* const spec =
    "spec s;\nperiod 1 s;\ninput z : zone[128] max_age 30 s;\ninput p : point;\n"
    "input q : point error 2 cm;\n"
    "monitor a { \"R1: in\" always p inside z; }\n"
    "monitor b { \"R2: out\" always not p inside z; }\n"
    "monitor c { \"R3: clear\" always clearance(p, z) >= 10 cm; }\n"
    "monitor d { \"R4: near\" always distance(q, z) <= 50 cm; }\n"
    "monitor e { \"R5: lately in\" always once[0 s, 2 s] q inside z; }\n"
    "monitor f { \"R6: how near\" always min[0 s, 3 s](clearance(p, z)) >= 1 m; }\n";

TEST_P(Received, AreJudgedConservativelyAndTightly) {
  const auto checked = check(spec, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const driver::LoadedKernel alone = load_verdicts(code);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  std::vector<driver::Judgement> exact, found, verdicts;
  std::shared_ptr<const interp::ReceivedZone> present;
  std::size_t taken = 0, decided = 0, unknown = 0, tight = 0;
  bool on_grid = false;
  for (std::int64_t tick = 0; tick < 1500; ++tick) {
    const std::int64_t now_us = tick * 1000000;
    Observed zone{{}, 0, false};
    if (random_() % 20 == 0) {
      const bool even = random_() % 2 == 0;
      if (auto next = received(star(even))) {
        ++taken;
        on_grid = even;
        present = std::move(next);
        zone = {{interp::Reading::Kind::number, interp::Decimal(1), present}, now_us, true};
      }
    }
    const auto [x, y] = place(present.get());
    const std::vector<Observed> inputs = {zone, number(x, now_us), number(y, now_us),
                                          number(x, now_us), number(y, now_us)};
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
      (exact[k].verdict == interp::Verdict::unknown ? unknown : decided) += 1;
      if (k > 3 || !on_grid || !e.lo.is_finite()) continue;
      // farther off, distances are bounds
      const std::int32_t exact_mm = present->tables.within.tree.exact_mm.value_or(1'000'000);
      if (abs(e.lo.value()) * 1000 > exact_mm - 1000) continue;
      ++tight;
      ASSERT_TRUE(f.lo.is_finite());
      EXPECT_LE(e.lo.value() - f.lo.value(), Rational(15, 1000));
    }
  }
  EXPECT_GT(taken, 40U);
  EXPECT_GT(decided, 4000U);
  EXPECT_GT(unknown, 100U);
  EXPECT_GT(tight, 500U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Received, ::testing::Values(1U, 2U, 3U));

}  // namespace
}  // namespace rtac::differential
