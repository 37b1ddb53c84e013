#include "tests/differential/places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace rtac::differential {
namespace {

using Spot = std::vector<std::int64_t>;  // in millionths of a metre

class Spots {
 public:
  explicit Spots(const ZoneCase& c) : case_(c) {}

  Spot next() {
    const auto& one = case_.places[random_() % case_.places.size()];
    const auto& other = case_.places[random_() % case_.places.size()];
    const bool anywhere = random_() % 3 == 0;
    const double t = static_cast<double>(random_() % 5) / 4;  // both ends and between them
    std::uniform_real_distribution<double> any(-case_.scale_m, case_.scale_m);
    Spot at;
    for (std::size_t axis = 0; axis < one.size(); ++axis) {
      at.push_back(near(anywhere ? any(random_) : one[axis] + t * (other[axis] - one[axis])));
    }
    return at;
  }

 private:
  std::int64_t near(double metres) {
    const std::int64_t offsets[] = {0, 0, 1, 400, 500, 1000, 3000, 20000};
    const auto at = static_cast<std::int64_t>(metres * 1e6 + (metres < 0 ? -0.5 : 0.5));
    const std::int64_t offset = offsets[random_() % 8];
    return random_() % 2 == 0 ? at + offset : at - offset;
  }

  const ZoneCase& case_;
  std::mt19937 random_{7};
};

std::string text_of(const Spot& at) {
  std::string text;
  for (const std::int64_t micro : at) text += std::to_string(micro) + " ";
  return text + "um";
}

}  // namespace

driver::Observed observed(std::int64_t micro, std::int64_t now_us) {
  const std::string text = to_decimal(Rational(static_cast<long>(micro), 1000000));
  return {{interp::Reading::Kind::number, *interp::Decimal::parse(text)}, now_us, true};
}

std::string spec_of(const ZoneCase& c, const std::string& robot) {
  const std::string point = c.places.front().size() == 3 ? "point3" : "point";
  return std::string("spec s;\nperiod 1 s;\norigin 47.3977 deg, 8.5456 deg;\nzone z = ") + c.zone +
         ";\ninput p : " + point + ";\ninput q : " + point +
         " error 2 cm;\n"
         "monitor a { \"R1: in\" always p inside z; }\n"
         "monitor b { \"R2: out\" always not p inside z; }\n"
         "monitor c { \"R3: clear\" always clearance(p, z) >= 10 cm; }\n"
         "monitor d { \"R4: near\" always distance(q, z) <= 50 cm; }\n"
         "monitor e { \"R5: in\" always q inside z; }\n" +
         robot;
}

void expect_conservative_and_tight(const ZoneCase& c, const std::string& spec,
                                   double most_on_grid_m, double most_m) {
  const auto checked = check(spec, Until::kernel);
  ASSERT_EQ(checked->problem, "");
  const auto reference = driver::make_interpreter(*checked->compilation.spec);
  const driver::KernelCode code = driver::kernel_code(checked->compilation);
  const driver::LoadedKernel kernel = load(code);
  ASSERT_NE(kernel.engine, nullptr) << kernel.problem;
  const driver::LoadedKernel alone = load_verdicts(code);
  ASSERT_NE(alone.engine, nullptr) << alone.problem;
  std::vector<driver::Judgement> exact, found, verdicts;
  std::size_t decided = 0, inside = 0;
  Spots spots(c);
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    const Spot at = spots.next();
    const std::int64_t now_us = tick * 1000000;
    std::vector<driver::Observed> inputs;  // all of them are there
    for (std::size_t k = 0; k < checked->compilation.spec->inputs.size(); ++k) {
      for (const std::int64_t micro : at) inputs.push_back(observed(micro, now_us));
    }
    reference->step(now_us, inputs, exact);
    kernel.engine->step(now_us, inputs, found);
    alone.engine->step(now_us, inputs, verdicts);
    const bool on_grid = c.on_grid && std::all_of(at.begin(), at.end(), [](std::int64_t micro) {
                           return micro % 1000 == 0;
                         });
    for (std::size_t k = 0; k < exact.size(); ++k) {
      SCOPED_TRACE(std::string(c.name) + " monitor " + std::to_string(k) + " at " + text_of(at) +
                   ": exact " + exact[k].margin + ", found " + found[k].margin);
      ASSERT_EQ(verdicts[k].verdict, found[k].verdict);
      const bool is_unknown = found[k].verdict == interp::Verdict::unknown;
      ASSERT_TRUE(is_unknown || found[k].verdict == exact[k].verdict);
      if (on_grid && k < 2) {
        ASSERT_EQ(found[k].verdict, exact[k].verdict);
      }
      const double below = std::stod(exact[k].margin) - std::stod(found[k].margin);
      const double most = on_grid && k < 3 ? most_on_grid_m : most_m;
      ASSERT_LE(below, most + std::abs(std::stod(exact[k].margin)) * 1e-5);
      ASSERT_GT(below, -1e-5 * (1 + std::abs(std::stod(exact[k].margin))));
      decided += is_unknown ? 0 : 1;
      inside += k == 0 && exact[k].verdict == interp::Verdict::yes ? 1 : 0;
    }
  }
  EXPECT_GT(decided, 5000U);
  EXPECT_GT(inside, 100U);
}

}  // namespace rtac::differential
