// Robots start where every property holds with what a robot at rest needs to spare: else its hold,
// which gives way a little, would break one, and the run show a violation of nobody's.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "run.h"

namespace rtac::simulate {
namespace {

using sim::Property;
using sim::PropertyOp;

constexpr double standing_m = 0.2, apart_m = 2;
constexpr std::int32_t hall_mm[] = {0,      0,      20'000, 0,      20'000, 0,      20'000, 10'000,
                                    20'000, 10'000, 0,      10'000, 0,      10'000, 0,      0};
// Between its walls a robot has 0.3 m to spare at most: what one needs, and two do not have.
constexpr std::int32_t corridor_mm[] = {0,      0,     20'000, 0,     20'000, 0,     20'000, 1'000,
                                        20'000, 1'000, 0,      1'000, 0,      1'000, 0,      0};

// Three robots in a hall, each of which keeps a distance from all others, or from some.
DecisionCase hall(PropertyOp whom) {
  DecisionCase d;
  d.name = "go";
  d.robots = {"a", "b", "c"};
  d.period_us = 50'000;
  d.standing_m = standing_m;
  d.limits.speed_mps = d.limits.accel_mps2 = d.limits.brake_mps2 = 1;
  d.limits.radius_m = d.surroundings.radius_m = 0.2;
  ZoneView zone;
  zone.edges_mm = hall_mm;
  zone.edge_count = std::size(hall_mm) / 4;
  d.surroundings.zones.push_back(zone);
  Property inside, gap, least, apart, others;
  inside.op = PropertyOp::inside;
  gap.op = PropertyOp::distance;
  least.op = PropertyOp::constant;
  least.value = apart_m;
  apart.op = PropertyOp::at_least;
  apart.of = {gap, least};
  others.op = whom;
  others.of = {apart};
  d.properties = {inside, others};
  d.monitors.resize(d.properties.size());
  return d;
}

double spare_of(const DecisionCase& d, const Setup& setup) {
  std::vector<sim::TruthState> truths(setup.starts.size());
  for (std::size_t i = 0; i < truths.size(); ++i) truths[i].position = setup.starts[i].place;
  double least = std::numeric_limits<double>::infinity();
  for (const Property& p : d.properties) {
    for (std::size_t i = 0; i < truths.size(); ++i) {
      least =
          std::min(least, margin_of(p, sim::scene_of(d.surroundings, truths, static_cast<int>(i))));
    }
  }
  return least;
}

// Somebody else has to be there: nobody has a place of his own before the others have theirs.
TEST(Starts, LeaveRoomToStandAlsoWhereNobodyCanBeAlone) {
  for (const PropertyOp whom : {PropertyOp::exists, PropertyOp::forall}) {
    const DecisionCase d = hall(whom);
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
      simulate::Setup setup;
      ASSERT_FALSE(make_setup(d, {}, seed, setup)) << seed;
      ASSERT_EQ(setup.starts.size(), d.robots.size());
      EXPECT_GE(spare_of(d, setup), standing_m) << seed;
    }
  }
}

// Two in corners and the third in the middle of the other side: hardly any draw finds them, nor
// does one that begins in the middle.
TEST(Starts, AreFoundWhereThereIsHardlyRoomForAll) {
  const auto kept = [](double apart) {
    DecisionCase d = hall(PropertyOp::forall);
    d.properties[1].of[0].of[1].value = apart;
    return d;
  };
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    simulate::Setup setup;
    const DecisionCase d = kept(12.3);
    ASSERT_FALSE(make_setup(d, {}, seed, setup)) << seed;
    EXPECT_GE(spare_of(d, setup), standing_m) << seed;
    EXPECT_TRUE(make_setup(kept(13.5), {}, seed, setup)) << seed;
  }
}

// A distance is kept by two, and a fence by each alone.
TEST(Starts, AskOfAFenceWhatOneRobotNeeds) {
  for (const bool joined : {false, true}) {
    DecisionCase d = hall(PropertyOp::forall);
    d.surroundings.zones.front().edges_mm = corridor_mm;
    if (joined) {
      Property both;
      both.op = PropertyOp::logical_and;
      both.of = d.properties;
      d.properties = {both};
    }
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      simulate::Setup setup;
      ASSERT_FALSE(make_setup(d, {}, seed, setup)) << seed;
      EXPECT_GE(spare_of(d, setup), standing_m) << seed;
    }
  }
}

}  // namespace
}  // namespace rtac::simulate
