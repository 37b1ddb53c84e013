// Properties of the true state: each operation, and the referee that skips what cannot matter.
#include <gtest/gtest.h>

#include <cmath>

#include "rtac/sim/math.h"
#include "rtac/sim/random.h"
#include "rtac/sim/referee.h"
#include "scene.h"

namespace rtac::sim {
namespace {

using testing::Room;

Property constant(double value) {
  Property p;
  p.op = PropertyOp::constant;
  p.value = value;
  return p;
}
Property quantity(PropertyOp op, int index = 0) {
  Property p;
  p.op = op;
  p.index = index;
  return p;
}
Property with(PropertyOp op, std::vector<Property> of) {
  Property p;
  p.op = op;
  p.of = std::move(of);
  return p;
}
Property at_least(Property a, Property b, double scale = 1, bool strict = false) {
  Property p = with(PropertyOp::at_least, {std::move(a), std::move(b)});
  p.value = scale;
  p.flag = strict;
  return p;
}

double made(PropertyOp op, std::vector<double> of) {
  return combined(op, of.size(), [&](std::size_t k) { return of[k]; });
}

TEST(Arithmetic, EachOperationIsItsOwn) {
  EXPECT_EQ(made(PropertyOp::add, {2, 3}), 5);
  EXPECT_EQ(made(PropertyOp::subtract, {2, 3}), -1);
  EXPECT_EQ(made(PropertyOp::multiply, {2, 3}), 6);
  EXPECT_EQ(made(PropertyOp::divide, {3, 2}), 1.5);
  EXPECT_EQ(made(PropertyOp::negate, {2}), -2);
  EXPECT_EQ(made(PropertyOp::minimum, {2, -3, 1}), -3);
  EXPECT_EQ(made(PropertyOp::maximum, {2, -3, 5}), 5);
  EXPECT_EQ(made(PropertyOp::absolute, {-2}), 2);
  EXPECT_EQ(made(PropertyOp::square_root, {9}), 3);
  EXPECT_EQ(made(PropertyOp::norm, {2, -3, 6}), 7);
  EXPECT_EQ(made(PropertyOp::norm, {-2}), 2);
  EXPECT_NEAR(made(PropertyOp::sine, {pi / 6}), 0.5, 1e-12);
  EXPECT_NEAR(made(PropertyOp::cosine, {pi / 3}), 0.5, 1e-12);
  EXPECT_TRUE(std::isnan(made(PropertyOp::inside, {1})));
}

class Properties : public ::testing::Test {
 protected:
  Properties() : truths(3) {
    surroundings.zones = {room.view()};
    surroundings.sites = {{{1, 1}, {1, 1}, {1, 1}}};
    surroundings.radius_m = 0.1;
    surroundings.drive_per_m = 0.01;
    truths[0].position = {1, 1};
    truths[1].position = {1, 2};
    truths[2].position = {1, 3.5};
    truths[0].battery = 0.5;
    truths[0].velocity = {0.3, 0.4};
  }
  double margin(const Property& p, int self = 0) const {
    return margin_of(p,
                     {surroundings, truths, self, truths[static_cast<std::size_t>(self)].position});
  }
  Room room;
  Surroundings surroundings;
  std::vector<TruthState> truths;
};

TEST_F(Properties, ZonesAreJudgedByTheBody) {
  EXPECT_NEAR(margin(quantity(PropertyOp::inside)), 0.9, 1e-12);
  EXPECT_NEAR(margin(at_least(quantity(PropertyOp::clearance), constant(0.4))), 0.5, 1e-12);
  truths[0].position = {2.5, 2.5};  // in the pillar, which is a hole
  EXPECT_NEAR(margin(quantity(PropertyOp::inside)), -0.6, 1e-12);
}

TEST_F(Properties, DistancesAreBetweenBodies) {
  const Property apart = at_least(quantity(PropertyOp::distance), constant(0.5));
  EXPECT_NEAR(margin(with(PropertyOp::forall, {apart})), 0.3, 1e-12);
  EXPECT_NEAR(margin(with(PropertyOp::exists, {apart})), 1.8, 1e-12);
  const Property near = at_least(constant(1), quantity(PropertyOp::distance));
  const Property count = with(PropertyOp::count, {near});
  EXPECT_EQ(margin(at_least(constant(2), count)), 1);
  EXPECT_EQ(margin(at_least(count, constant(2))), -1);
}

TEST_F(Properties, ChargeHasAScaleOfItsOwn) {
  const Property need = with(PropertyOp::add, {quantity(PropertyOp::energy_to), constant(0.05)});
  truths[0].position = {1, 3};  // 2 m: 2 %
  EXPECT_NEAR(margin(at_least(quantity(PropertyOp::battery), need, 0.01)), 43, 1e-9);
}

TEST_F(Properties, ArithmeticAndSpeed) {
  const Property sum =
      with(PropertyOp::subtract, {with(PropertyOp::multiply, {constant(3), constant(2)}),
                                  with(PropertyOp::divide, {constant(1), constant(4)})});
  EXPECT_EQ(margin(at_least(sum, with(PropertyOp::negate, {constant(1)}))), 6.75);
  EXPECT_NEAR(margin(at_least(constant(1), quantity(PropertyOp::speed))), 0.5, 1e-12);
}

TEST_F(Properties, ConnectivesTakeTheDecidingMargin) {
  const Property a = at_least(constant(3), constant(1)), b = at_least(constant(0), constant(1));
  EXPECT_EQ(margin(with(PropertyOp::logical_and, {a, b})), -1);
  EXPECT_EQ(margin(with(PropertyOp::logical_or, {a, b})), 2);
  EXPECT_EQ(margin(with(PropertyOp::logical_not, {a})), -2);
  Property truth;
  EXPECT_EQ(margin(truth), HUGE_VAL);
  truth.value = 0;
  EXPECT_EQ(margin(truth), -HUGE_VAL);
}

TEST_F(Properties, StrictlyMoreIsNotAsMuch) {
  EXPECT_EQ(margin(at_least(constant(1), constant(1))), 0);
  EXPECT_LT(margin(at_least(constant(1), constant(1), 1, true)), 0);
}

// What is not a condition holds nowhere: a manifest with a mistake must not pass for sound.
TEST_F(Properties, AQuantityIsNoCondition) {
  EXPECT_EQ(margin(constant(1)), -HUGE_VAL);
  EXPECT_TRUE(std::isnan(margin(at_least(quantity(PropertyOp::inside), constant(0)))));
}

// The referee judges less often than at every step; it must find the same to the last bit.
TEST_F(Properties, TheRefereeMissesNothing) {
  const std::vector<Property> properties{
      quantity(PropertyOp::inside),
      with(PropertyOp::forall, {at_least(quantity(PropertyOp::distance), constant(0.2), 0.5)}),
      at_least(quantity(PropertyOp::battery), quantity(PropertyOp::energy_to), 0.01)};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Referee referee(surroundings, properties, 3);
    std::vector<double> least(properties.size(), HUGE_VAL);
    TimeUs first_us = never_us;
    for (TruthState& t : truths) t.position = {random.uniform(0.5, 1.8), random.uniform(0.5, 3.5)};
    truths[0].battery = 1;
    for (TimeUs now = 0; now < 8'000'000; now += 1000) {
      for (TruthState& t : truths) t.position = t.position + random.in_disc(0.02);
      truths[0].battery -= 1e-6;
      referee.observe(now, truths);
      for (std::size_t m = 0; m < properties.size(); ++m) {
        for (int r = 0; r < 3; ++r) {
          const double found = margin(properties[m], r);
          least[m] = std::min(least[m], found);
          if (found < -referee_rounding && first_us == never_us) first_us = now;
        }
      }
    }
    for (std::size_t m = 0; m < properties.size(); ++m) {
      EXPECT_EQ(referee.least(static_cast<int>(m)).value, least[m]) << seed << " " << m;
    }
    EXPECT_EQ(referee.first_violation().time_us, first_us) << seed;
  }
}

}  // namespace
}  // namespace rtac::sim
