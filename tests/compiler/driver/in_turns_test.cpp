// Which recorded runs show recoveries that take over from each other.
#include "compiler/driver/in_turns.h"

#include <gtest/gtest.h>

namespace rtac::driver {
namespace {

constexpr const char* kept = "end not given back: a from_us 0 until_us 300000000\n";

// Of robots and the modes that drive them.
std::string run(const std::vector<std::pair<int, int>>& decisions, const std::string& end) {
  std::string trace = "rtac-sim-trace 3\ntape\n";
  for (const auto& [robot, mode] : decisions) {
    trace += "decide " + std::to_string(robot) + " " + std::to_string(mode) + " 0 6 2\n";
    trace += "truth " + std::to_string(robot) + " 0x0p+0 0x0p+0 0x0p+0 0x0p+0\n";
  }
  return trace + end;
}

TEST(InTurns, WhoTakesOverIsCounted) {
  EXPECT_EQ(turns_taken(run({{0, 1}, {0, 1}, {0, 2}, {0, 2}, {0, 1}}, kept), {1, 2}), 2);
  EXPECT_EQ(turns_taken(run({{0, 1}, {0, 1}}, kept), {1, 2}), 0);
}
TEST(InTurns, SinceAnybodyElseHasDriven) {
  EXPECT_EQ(turns_taken(run({{0, 1}, {0, 2}, {0, 0}, {0, 1}, {0, 2}, {0, 1}}, kept), {1, 2}), 2);
  EXPECT_EQ(turns_taken(run({{0, 1}, {0, 2}, {0, 1}, {0, 3}}, kept), {1, 2}), 0);
}
TEST(InTurns, OfOneRobot) {
  EXPECT_EQ(turns_taken(run({{0, 1}, {1, 2}, {0, 1}, {1, 2}}, kept), {1, 2}), 0);
  EXPECT_EQ(turns_taken(run({{0, 0}, {1, 2}, {0, 1}, {1, 1}}, kept), {1, 2}), 1);
}
TEST(InTurns, ControlIsNotGivenBack) {
  EXPECT_EQ(turns_taken(run({{0, 1}, {0, 2}}, "end no violation\n"), {1, 2}), 0);
  EXPECT_EQ(turns_taken(run({{0, 1}, {0, 2}}, std::string(kept) + "end no violation\n"), {1, 2}),
            1);
}

}  // namespace
}  // namespace rtac::driver
