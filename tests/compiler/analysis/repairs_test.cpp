// Every number that a message offers really works when it is written into the specification; where
// it is the largest, a little more does not.
#include <cmath>

#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

TEST(Repairs, TheLeastLookaheadOf5001Works) {
  const std::string faulty = edited(drone_spec(), "ahead   100 ms, 2 waypoints", "ahead 49 ms");
  const auto c = compiled(faulty);
  ASSERT_TRUE(has(*c, Code::lookahead_too_short)) << reports(*c);
  const std::string least = number_in_help(*c, Code::lookahead_too_short, "`", "ms`");
  EXPECT_EQ(least, "50");
  EXPECT_TRUE(compiled(edited(faulty, "49 ms", least + " ms"))->module);
}

TEST(Repairs, AnExternalRecoveryNeedsTwoPeriods) {
  const std::string external = edited(edited(drone_spec(), "= retreat within room speed 0.3 m/s",
                                             "extern keeps inside room speed <= 1 m/s"),
                                      "ahead   100 ms, 2 waypoints", "ahead 99 ms");
  const auto c = compiled(external);
  ASSERT_TRUE(has(*c, Code::lookahead_too_short)) << reports(*c);
  EXPECT_EQ(number_in_help(*c, Code::lookahead_too_short, "`", "ms`"), "100");
  EXPECT_TRUE(compiled(edited(external, "99 ms", "100 ms"))->module);
}

TEST(Repairs, TheLargestLookaheadOf5007WorksAndOneMillisecondMoreDoesNot) {
  const std::string faulty = edited(drone_spec(), "ahead   100 ms", "ahead 2 s");
  const auto c = compiled(faulty);
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "at most ", "ms");
  const auto good = compiled(edited(faulty, "2 s", most + " ms"));
  EXPECT_TRUE(good->module) << reports(*good);
  const auto bad = compiled(edited(faulty, "2 s", std::to_string(std::stol(most) + 1) + " ms"));
  EXPECT_TRUE(has(*bad, Code::return_set_empty));
}

TEST(Repairs, TheWideningOf5007Works) {
  const std::string narrow = edited(drone_spec(), "to (5 m, 5 m)", "to (5 m, 400 mm)");
  const auto c = compiled(narrow);
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string by = number_in_help(*c, Code::return_set_empty, "widen the zone by ", "m");
  const long mm = 400 + std::lround(1000 * std::stod(by));
  const auto good = compiled(edited(narrow, "400 mm", std::to_string(mm) + " mm"));
  EXPECT_TRUE(good->module) << reports(*good);
  EXPECT_TRUE(has(*compiled(edited(narrow, "400 mm", std::to_string(mm - 8) + " mm")),
                  Code::return_set_empty));
}

// Too little of the brake is left to hold a place with; the error of the output counts, too.
std::string pushed(const std::string& by, const std::string& output_error = "") {
  return R"(spec adrift;
zone yard = rectangle (0 m, 0 m) to (90 m, 90 m);
robot Raft {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; disturbance <= )" +
         by + R"( m/s^2; }
  sense    position : point   error 2 cm   max_age 20 ms;
  sense    velocity : vector  error 1 cm/s max_age 20 ms;
  output   thrust : acceleration)" +
         output_error + R"(;
  latency  20 ms;
}
fleet r1 : Raft;
controller row  : advanced for Raft extern;
controller stop : safe for Raft = brake_and_hold;
monitor fence for r : Raft {
  "SR-1: in" always r inside yard; recover stop; hold when violated "it drifts back";
}
decision go for Raft { advanced row; period 50 ms; priority fence; }
)";
}
TEST(Repairs, TheLargestDisturbanceOf5005WorksAndMoreDoesNot) {
  const auto c = compiled(pushed("0.9"));
  ASSERT_TRUE(has(*c, Code::limit_contradictory)) << reports(*c);
  EXPECT_EQ(number_in_help(*c, Code::limit_contradictory, "at most ", "m/s^2"), "0.75");
  const auto most = compiled(pushed("0.75"));
  EXPECT_TRUE(most->module) << reports(*most);
  EXPECT_TRUE(has(*compiled(pushed("0.751")), Code::limit_contradictory));
  const auto errs = compiled(pushed("0.5", " error 0.3 m/s^2"));
  ASSERT_TRUE(has(*errs, Code::limit_contradictory)) << reports(*errs);
  EXPECT_EQ(number_in_help(*errs, Code::limit_contradictory, "at most ", "m/s^2"), "0.25");
}

void expect_place_works(const std::string& faulty, const std::string& place, Code code) {
  const auto c = compiled(faulty);
  ASSERT_TRUE(has(*c, code)) << reports(*c);
  const std::string help = c->diagnostics.all()[0].help;
  const std::size_t at = help.find(" is (");
  ASSERT_NE(at, std::string::npos) << help;
  const auto good = compiled(edited(faulty, place, help.substr(at + 4)));
  EXPECT_TRUE(good->module) << reports(*good);
}

TEST(Repairs, ThePlaceOf4008Works) {
  expect_place_works(rover_spec(), "(6.5 m, 1 m)", Code::site_outside_zone);
}

TEST(Repairs, ThePlaceOf5012Works) {
  expect_place_works(edited(rover_spec(), "(6.5 m, 1 m)", "(0.15 m, 3 m)"), "(0.15 m, 3 m)",
                     Code::site_unreachable);
}

// In a zone with wide cells the site itself has more clearance than its cell.
TEST(Repairs, AWideCellIsNamedAsTheCauseOf5012) {
  const std::string large = edited(rover_spec(), "to (6 m, 6 m)", "to (300 m, 300 m)");
  const std::string faulty = edited(large, "(6.5 m, 1 m)", "(0.8 m, 0.8 m)");
  const auto c = compiled(faulty);
  ASSERT_TRUE(has(*c, Code::site_unreachable)) << reports(*c);
  EXPECT_NE(reports(*c).find("about 0 m in its cell of 1.5 m"), std::string::npos) << reports(*c);
  EXPECT_EQ(
      reports(*compiled(edited(rover_spec(), "(6.5 m, 1 m)", "(0.15 m, 3 m)"))).find("in its cell"),
      std::string::npos);
}

TEST(Repairs, ThePlaceOf5009Works) {
  const std::string slow = edited(edited(rover_spec(), "speed 0.2 m/s", "speed 0.01 m/s"),
                                  "ahead   100 ms", "ahead 400 ms");
  // at so slow a speed the time takes much of the charge
  const std::string lasting = edited(slow, "idle <= 0.01", "idle <= 0.001");
  expect_place_works(edited(lasting, "(6.5 m, 1 m)", "(0.35 m, 3 m)"), "(0.35 m, 3 m)",
                     Code::site_not_returnable);
}

TEST(Repairs, AZoneWithoutAnyPlaceForASiteIsSaidToBeTooNarrow) {
  const auto c = compiled(edited(edited(rover_spec(), "(6.5 m, 1 m)", "(3 m, 0.1 m)"),
                                 "to (6 m, 6 m)", "to (6 m, 0.2 m)"));
  ASSERT_TRUE(c->diagnostics.has_errors());
  EXPECT_NE(reports(*c).find("no place of `yard`"), std::string::npos) << reports(*c);
}

TEST(Repairs, TheDriveOf5012WorksAndFivePercentMoreDoesNot) {
  const std::string thirsty = edited(edited(rover_spec(), "(6.5 m, 1 m)", "(1 m, 1 m)"),
                                     "drive <= 0.5 %/m", "drive <= 15 %/m");
  const auto c = compiled(thirsty);
  ASSERT_TRUE(has(*c, Code::site_unreachable)) << reports(*c);
  const std::string most = number_in_help(*c, Code::site_unreachable, "at most ", "%/m");
  const auto good = compiled(edited(thirsty, "15 %/m", most + " %/m"));
  EXPECT_TRUE(good->module) << reports(*good);
  const std::string more = std::to_string(1.05 * std::stod(most));
  EXPECT_TRUE(has(*compiled(edited(thirsty, "15 %/m", more + " %/m")), Code::site_unreachable));
}

TEST(Repairs, TheShrinkingOf4007Works) {
  const std::string gone =
      "spec a;\nzone room = rectangle (0 m, 0 m) to (4 m, 4 m);\n"
      "zone core = shrink(room, 2500 mm);\n";
  const auto c = compiled(gone);
  ASSERT_TRUE(has(*c, Code::empty_zone)) << reports(*c);
  const double most = std::stod(number_in_help(*c, Code::empty_zone, "less than ", "m"));
  EXPECT_NEAR(most, 2, 0.002);
  const std::string by = std::to_string(std::lround(1000 * most) - 3) + " mm";
  EXPECT_FALSE(compiled(edited(gone, "2500 mm", by))->diagnostics.has_errors());
}

TEST(Repairs, BothNeighboursOf7003AreOnTheGrid) {
  const std::string off = edited(drone_spec(), ">= 10 cm", ">= 10.05 mm");
  const auto c = compiled(off);
  ASSERT_TRUE(has(*c, Code::constant_off_grid)) << reports(*c);
  for (const char* works : {"0.01 m", "0.011 m"}) {
    EXPECT_NE(reports(*c).find(std::string("`") + works + "`"), std::string::npos);
    EXPECT_TRUE(compiled(edited(off, "10.05 mm", works))->module);
  }
}

// Limits of sizes: the one that is offered works, a little more does not.
struct Size {
  const char *from, *unit;
  std::string limit;
  const char* above;
};

TEST(Repairs, TheSizesOf7001Work) {
  for (const Size& size :
       std::vector<Size>{{"radius 8 cm", "m", "radius 1000 m", "radius 1001 m"},
                         {"speed <= 1 m/s", "", "speed <= 100 m/s", "speed <= 101 m/s"},
                         {"accel <= 1 m/s^2", "", "accel <= 1000 m/s^2", "accel <= 1001 m/s^2"},
                         {"brake >= 1 m/s^2", "", "brake >= 0.001 m/s^2", "brake >= 0.0009 m/s^2"},
                         {"latency  20 ms", "", "latency 60 s", "latency 61 s"},
                         {"error 2 cm ", "", "error 1 km ", "error 1.001 km "},
                         {"tracking <= 10 cm", "", "tracking <= 1 km", "tracking <= 1.001 km"}}) {
    const auto at_limit = compiled(edited(drone_spec(), size.from, size.limit));
    EXPECT_EQ(reports(*at_limit).find("does not fit the integer kernel"), std::string::npos)
        << size.limit << "\n"
        << reports(*at_limit);
    const auto above = compiled(edited(drone_spec(), size.from, size.above));
    EXPECT_TRUE(has(*above, Code::value_out_of_range)) << size.above << "\n" << reports(*above);
  }
}

}  // namespace
}  // namespace rtac::analysis::test
