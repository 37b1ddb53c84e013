// Which recorded runs show robots that wait for each other.
#include "compiler/driver/lock_up.h"

#include <gtest/gtest.h>

namespace rtac::driver {
namespace {

// Of two robots at rest 0.5 m apart, and a third one at x = `third_m` in mode `third_mode`.
std::string run(int second_mode, double third_m, int third_mode, const std::string& end) {
  return "rtac-sim-trace 3\ntape\n"
         "decide 0 1 0 6 2\ntruth 0 0x0p+0 0x0p+0 0x0p+0 0x0p+0\n"
         "decide 1 " +
         std::to_string(second_mode) +
         " 0 6 2\ntruth 1 0x1p-1 0x0p+0 0x0p+0 0x0p+0\n"
         "decide 2 " +
         std::to_string(third_mode) + " 0 6 2\ntruth 2 " + std::to_string(third_m) +
         " 0 0 0\nend not given back: a from_us 0 until_us 120000000\n" + end + "\n";
}
bool shows(const std::string& trace) {
  return locks_up(trace, 2, {3000, {1}});
}

TEST(LockUp, NobodyIsDrivenByItsAdvancedController) {
  EXPECT_TRUE(shows(run(1, 9, 1, "end no violation")));
  EXPECT_FALSE(shows(run(0, 9, 1, "end no violation")));
}
// Nor by what an input asks for, or something external.
TEST(LockUp, NobodyIsKeptByAnythingElse) {
  EXPECT_FALSE(shows(run(2, 9, 1, "end no violation")));
  EXPECT_FALSE(shows(run(1, 3.4, 2, "end no violation")));
}
TEST(LockUp, NobodyElseDrivesNearBy) {
  EXPECT_TRUE(shows(run(1, 3.6, 0, "end no violation")));
  EXPECT_FALSE(shows(run(1, 3.4, 0, "end no violation")));
  EXPECT_TRUE(shows(run(1, 3.4, 1, "end no violation")));
}
TEST(LockUp, NothingIsViolatedButWhereTheyBeginAndNobodyGivenBack) {
  EXPECT_TRUE(shows(run(1, 9, 1, "end violation of apart by a at_us 0 least -0x1p-3")));
  EXPECT_FALSE(shows(run(1, 9, 1, "end violation of apart by a at_us 7 least -0x1p-3")));
  EXPECT_FALSE(shows(run(1, 9, 1, "end violation of apart by a at_us 10 least -0x1p-3")));
  std::string returned = run(1, 9, 1, "end no violation");
  returned.erase(returned.find("end not given back"), 1);
  EXPECT_FALSE(shows(returned));
  EXPECT_FALSE(shows("end not given back: a from_us 0 until_us 1\nend no violation\n"));
}

}  // namespace
}  // namespace rtac::driver
