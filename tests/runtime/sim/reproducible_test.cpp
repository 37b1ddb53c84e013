#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "rtac/sim/adversary.h"
#include "tests/runtime/sim/scene.h"

namespace rtac::sim::testing {
namespace {

// Everything that was sensed and the final truth, bit by bit.
template <class Output>
std::vector<std::uint64_t> run(const RobotLimits& limits, std::uint64_t seed) {
  WorldOptions options;
  options.seed = seed;
  World<Output> world({robot_at(limits, {1, 1}), robot_at(limits, {2, 2})}, options);
  BangBang<Output> wild(limits, 11);
  std::vector<std::uint64_t> bits;
  const auto keep = [&bits](double value) {
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof word);
    bits.push_back(word);
  };
  Observation observation;
  for (TimeUs t = 0; t < 20 * s; t += 100 * ms) {
    world.wait_until(t);
    for (int robot = 0; robot < 2; ++robot) {
      world.robot(robot).sense(observation);
      world.robot(robot).actuate(wild.command(observation));
      world.robot(robot).announce({});
      keep(observation.position.value.x);
      keep(observation.heading.value);
      keep(observation.others[static_cast<std::size_t>(1 - robot)].position.value.y);
      bits.push_back(static_cast<std::uint64_t>(observation.position.stamp_us));
    }
  }
  keep(world.truth(0).position.x);
  keep(world.truth(1).position.y);
  keep(world.truth(1).battery);
  return bits;
}

TEST(Reproducible, TheSameSeedGivesTheSameBits) {
  EXPECT_EQ(run<Twist>(turtle_limits(), 1), run<Twist>(turtle_limits(), 1));
  EXPECT_EQ(run<Acceleration>(drone_limits(), 1), run<Acceleration>(drone_limits(), 1));
}

std::uint64_t digest(const std::vector<std::uint64_t>& words) {  // FNV-1a over words
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const std::uint64_t word : words) hash = (hash ^ word) * 0x100000001B3u;
  return hash;
}

TEST(Reproducible, CompilersAndOptimisationDoNotChangeTheBits) {
  // Pinned, so that every compiler, build type and machine of the tests is held to it. A change
  // of the dynamics or of the order of draws changes these numbers, and says so in its commit.
  EXPECT_EQ(digest(run<Twist>(turtle_limits(), 1)), 653261719783665051u);
  EXPECT_EQ(digest(run<Acceleration>(drone_limits(), 1)), 395105257247073134u);
}

TEST(Reproducible, AnotherSeedGivesAnotherRun) {
  EXPECT_NE(run<Twist>(turtle_limits(), 1), run<Twist>(turtle_limits(), 2));
  EXPECT_NE(run<Acceleration>(drone_limits(), 1), run<Acceleration>(drone_limits(), 2));
}

TEST(Reproducible, AFaultOfOneSenseLeavesTheOthersBitsAlone) {
  // Separate streams: campaigns with and without a fault stay paired.
  const auto velocity_after = [](bool with_fault) {
    World<Twist> world({robot_at(turtle_limits(), {1, 1})}, WorldOptions{});
    if (with_fault) world.inject({0, Sense::position, FaultKind::jump, 0, 10 * s, 1.0});
    world.wait_until(5 * s);
    Observation observation;
    world.robot(0).sense(observation);
    return observation.velocity.value.x;
  };
  EXPECT_EQ(velocity_after(true), velocity_after(false));
}

}  // namespace
}  // namespace rtac::sim::testing
