// The generated wrapper takes paths of applications.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "trucks.h"

namespace rtac::differential {
namespace {

using namespace rtac::literals;

class PathsOfApplications : public ::testing::Test {
 protected:
  static Path path(const std::vector<Vec2>& points, std::size_t index) {
    Path made;
    for (const Vec2& p : points) EXPECT_TRUE(made.points.push(p));
    made.index = index;
    return made;
  }
  // `kept`, `ahead`, `near` and `fresh`, one letter each; both entries agree.
  std::string judged(TimeUs now_us) {
    std::string text;
    const auto& findings = monitors_.step(now_us);
    const auto verdicts = monitors_.verdicts(now_us);
    for (std::size_t k = 0; k < trucks::Monitors::count; ++k) {
      EXPECT_EQ(findings[k].verdict, verdicts[k]);
      text += verdicts[k] == Verdict::is_true ? 'y' : verdicts[k] == Verdict::is_false ? 'n' : '?';
    }
    return text;
  }
  std::string judged(const Path& plan, TimeUs now_us) {
    monitors_.at({1_m, 1_m}, now_us);
    monitors_.plan(plan, now_us);
    return judged(now_us);
  }
  trucks::Monitors monitors_;
};

TEST_F(PathsOfApplications, AreUnknownUntilOneHasCome) {
  EXPECT_EQ(judged(0), "????");
}
TEST_F(PathsOfApplications, AreHeldAgainstZonesAndPlaces) {
  EXPECT_EQ(judged(path({{2, 2}, {9, 2}, {9, 9}}, 0), 0), "yyyy");
  EXPECT_EQ(judged(path({{2, 2}, {12, 2}, {9, 9}}, 0), 100'000), "nnyy");
  EXPECT_EQ(judged(path({{2, 2}, {12, 2}, {9, 9}}, 2), 200'000), "nyyy");
  EXPECT_EQ(judged(path({{9, 9}}, 1), 300'000), "yyny");
}
TEST_F(PathsOfApplications, MayBeEmpty) {
  EXPECT_EQ(judged(path({}, 0), 0), "yyny");
}
TEST_F(PathsOfApplications, CountToTheNearestMillimetre) {
  EXPECT_EQ(judged(path({{2, 2}, {10.0004, 2}}, 0), 0), "??yy");  // it touches the fence
  EXPECT_EQ(judged(path({{2, 2}, {10.004, 2}}, 0), 100'000), "nnyy");
}
TEST_F(PathsOfApplications, AreUnknownWhereTheyMakeNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(judged(path({{2, 2}, {nan, 2}}, 0), 0), "????");
  EXPECT_EQ(judged(path({{2, 2}, {3, 2}, {4, 2}, {5, 2}}, 0), 100'000), "????");
  EXPECT_EQ(judged(path({{2, 2}, {3, 2}}, 3), 200'000), "???y");
  EXPECT_EQ(judged(path({{2, 2}, {1e9, 2}}, 0), 300'000), "???y");
  EXPECT_EQ(judged(path({{2, 2}}, 0), 400'000), "yyyy");
}
TEST_F(PathsOfApplications, GrowTooOld) {
  EXPECT_EQ(judged(path({{2, 2}}, 0), 0), "yyyy");
  EXPECT_EQ(judged(400'000), "yyyn");
  EXPECT_EQ(judged(600'000), "???n");
}

}  // namespace
}  // namespace rtac::differential
