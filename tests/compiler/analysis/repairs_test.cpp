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
  EXPECT_TRUE(without_offers(edited(faulty, "49 ms", least + " ms"))->module);
}

// Of what pushes a robot the largest that its hold stands is offered, however much is declared.
TEST(Repairs, TheLargestPushOf5005Works) {
  const auto pushed = [](const std::string& by, bool output) {
    return output ? edited(drone_spec(), "thrust : acceleration;",
                           "thrust : acceleration error " + by + " m/s^2;")
                  : edited(drone_spec(), "brake >= 1 m/s^2;",
                           "brake >= 1 m/s^2; disturbance <= " + by + " m/s^2;");
  };
  for (const bool output : {false, true}) {
    for (const char* const by : {"0.8", "1", "3"}) {
      const auto c = compiled(pushed(by, output));
      ASSERT_TRUE(has(*c, Code::limit_contradictory)) << reports(*c);
      const std::string most = number_in_help(*c, Code::limit_contradictory, "at most ", "m/s^2");
      EXPECT_EQ(most, "0.433") << by;  // more, and its recovery would be too slow
      EXPECT_TRUE(without_offers(pushed(most, output))->module);
      EXPECT_FALSE(without_offers(pushed("0.434", output))->module);
    }
  }
}

// A hall whose wall is a saw of 5 cm: its distances are exact near the wall alone.
TEST(Repairs, TheSpeedOf4011WorksAndAnotherFivePercentDoNot) {
  std::string saw = "polygon [";
  for (int i = 0; i < 4000; ++i) {
    const double angle = 2 * M_PI * i / 4000, deep = i % 2 * 0.05;
    saw += (i > 0 ? ", (" : "(") + std::to_string((14 - deep) * std::cos(angle)) + " m, " +
           std::to_string((9 - deep) * std::sin(angle)) + " m)";
  }
  const std::string fast =
      edited(edited(edited(drone_spec(), "rectangle (0 m, 0 m) to (5 m, 5 m)", saw + "]"),
                    "speed <= 1 m/s", "speed <= 2 m/s"),
             "100 ms, 2 waypoints", "100 ms");
  const auto c = compiled(fast);
  ASSERT_TRUE(has(*c, Code::too_many_edges)) << reports(*c);
  const std::string most = number_in_help(*c, Code::too_many_edges, "robot of at most ", "m/s");
  const auto at = [&](double speed) {
    return without_offers(
        edited(fast, "speed <= 2 m/s", "speed <= " + std::to_string(speed) + " m/s"));
  };
  EXPECT_FALSE(has(*at(std::stod(most)), Code::too_many_edges)) << most;
  EXPECT_TRUE(has(*at(1.05 * std::stod(most)), Code::too_many_edges)) << most;
}

TEST(Repairs, AnExternalRecoveryNeedsTwoPeriods) {
  const std::string external =
      edited(edited(edited(drone_spec(), "= retreat within room speed 0.3 m/s",
                           "extern keeps inside inner speed <= 1 m/s"),
                    "ahead   100 ms, 2 waypoints", "ahead 99 ms"),
             "monitor walls", "zone inner = shrink(room, 10 cm);\nmonitor walls");
  const auto c = compiled(external);
  ASSERT_TRUE(has(*c, Code::lookahead_too_short)) << reports(*c);
  EXPECT_EQ(number_in_help(*c, Code::lookahead_too_short, "`", "ms`"), "100");
  EXPECT_TRUE(without_offers(edited(external, "99 ms", "100 ms"))->module);
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
  const std::string by = number_in_help(*c, Code::return_set_empty, "`grow(room, ", "m)`");
  const long mm = std::lround(1000 * std::stod(by));
  const auto grown = [&](long by_mm) {
    return compiled(
        edited(narrow, "rectangle (0 m, 0 m) to (5 m, 400 mm)",
               "grow(rectangle (0 m, 0 m) to (5 m, 400 mm), " + std::to_string(by_mm) + " mm)"));
  };
  const auto good = grown(mm);
  EXPECT_TRUE(good->module) << reports(*good);
  EXPECT_FALSE(has(*good, Code::no_way_back)) << reports(*good);
  // to the check itself; beside round corners the recheck may miss 5 mm of the clearance of a cell
  EXPECT_FALSE(has(*grown(mm - 2), Code::return_set_empty));
  EXPECT_TRUE(has(*grown(mm - 6), Code::return_set_empty));
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
  EXPECT_TRUE(has(*without_offers(pushed("0.751")), Code::limit_contradictory));
  const auto errs = compiled(pushed("0.5", " error 0.3 m/s^2"));
  ASSERT_TRUE(has(*errs, Code::limit_contradictory)) << reports(*errs);
  EXPECT_EQ(number_in_help(*errs, Code::limit_contradictory, "at most ", "m/s^2"), "0.25");
}

void expect_place_works(const std::string& faulty, const std::string& place, Code code) {
  const auto c = compiled(faulty);
  ASSERT_TRUE(has(*c, code)) << reports(*c);
  const std::string help = c->diagnostics.all()[0].help;
  const std::size_t at = help.find("the place ("), to = help.find(" works", at);
  ASSERT_NE(at, std::string::npos) << help;
  const std::size_t from = help.find('(', at);
  const auto good = compiled(edited(faulty, place, help.substr(from, to - from)));
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
  EXPECT_TRUE(
      has(*without_offers(edited(thirsty, "15 %/m", more + " %/m")), Code::site_unreachable));
}

// Where the time alone takes too much, less at rest is needed.
TEST(Repairs, TheIdleOf5012WorksAndFivePercentMoreDoesNot) {
  const std::string lit = edited(edited(rover_spec(), "(6.5 m, 1 m)", "(1 m, 1 m)"),
                                 "idle <= 0.01 %/s", "idle <= 0.9 %/s");
  const std::string waste = edited(lit, "drain <= 0.2 %/s", "drain <= 1 %/s");
  const auto c = compiled(waste);
  ASSERT_TRUE(has(*c, Code::site_unreachable)) << reports(*c);
  const std::string most = number_in_help(*c, Code::site_unreachable, "`idle` of at most ", "%/s");
  const auto good = compiled(edited(waste, "0.9 %/s", most + " %/s"));
  EXPECT_TRUE(good->module) << reports(*good);
  const std::string more = std::to_string(1.05 * std::stod(most));
  EXPECT_TRUE(
      has(*without_offers(edited(waste, "0.9 %/s", more + " %/s")), Code::site_unreachable));
}

// Where no charge is ever seen to be enough, it has to be measured better, and by how much is told.
TEST(Repairs, ABatteryThatShowsTooLittleIsMeasuredBetter) {
  const auto seen = [](const std::string& with) {
    return R"(spec weak;
zone z = rectangle (0 m, 0 m) to (20 m, 20 m);
site dock = (10 m, 10 m);
robot R {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  sense battery : ratio )" +
           with + R"(;
  output o : acceleration;
  latency 20 ms;
  energy {
    drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at dock;
    held <= 0 s; detour <= 0 m;
  }
}
fleet x : R;
controller a : advanced for R extern;
controller c : safe for R = route to dock within z speed 0.4 m/s;
monitor m for r : R {
  "R1" always r.battery >= energy_to(dock) + 5 %; recover c; return when r.battery >= 60 %;
}
decision d for R { advanced a; period 50 ms; priority m; }
)";
  };
  const auto by_error = compiled(seen("error 60 % max_age 2 s"));
  const std::string error =
      number_in_help(*by_error, Code::return_set_empty, "of the battery of at most ", "%");
  EXPECT_TRUE(without_offers(seen("error " + error + " % max_age 2 s"))->module)
      << reports(*by_error);
  EXPECT_FALSE(without_offers(seen("error 20 % max_age 2 s"))->module) << error;
  const auto by_age = compiled(seen("error 1 % max_age 1 h"));
  const std::string age =
      number_in_help(*by_age, Code::return_set_empty, "of the battery of at most ", "ms");
  EXPECT_TRUE(without_offers(seen("error 1 % max_age " + age + " ms"))->module) << reports(*by_age);
  EXPECT_FALSE(without_offers(seen("error 1 % max_age 191 s"))->module) << age;
}

// Errors and late samples let a robot rest beside its dock: it is told which of them is too much.
TEST(Repairs, WhoRestsBesideItsDockIsMeasuredBetter) {
  const auto late = [](const std::string& age) {
    return R"(spec beside;
zone z = rectangle (0 m, 0 m) to (20 m, 20 m);
site dock = (10 m, 10 m);
robot R {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age )" +
           age + R"( ms;
  sense velocity : vector error 2 cm/s max_age 20 ms;
  sense battery : ratio error 0.1 % max_age 100 ms;
  output o : acceleration;
  latency 300 ms;
  energy {
    drive <= 0.05 %/m; idle <= 0.03 %/s; drain <= 0.06 %/s; charge >= 2 %/s at dock;
    held <= 0 s; detour <= 0 m;
  }
}
fleet x : R;
controller a : advanced for R extern;
controller c : safe for R = route to dock within z speed 0.8 m/s;
monitor m for r : R {
  "R1" always r.battery >= energy_to(dock); ahead 300 ms; recover c; return when r.battery >= 60 %;
}
decision d for R { advanced a; period 50 ms; priority m; }
)";
  };
  const auto c = compiled(late("2000"));
  ASSERT_TRUE(has(*c, Code::site_not_returnable)) << reports(*c);
  EXPECT_NE(reports(*c).find("from it, and is charged within 0.15 m"), std::string::npos);
  const std::string most =
      number_in_help(*c, Code::site_not_returnable, "of the position of at most ", "ms");
  EXPECT_TRUE(without_offers(late(most))->module) << most << reports(*c);
  EXPECT_FALSE(without_offers(late(std::to_string(std::stoi(most) + 1)))->module) << most;

  // so is who asks for a charge whatever the way takes, or only to return; not who asks for none
  const std::string of_way = "r.battery >= energy_to(dock);",
                    back = " return when r.battery >= 60 %;";
  const std::string fence = "clearance(r, z) >= 5 cm;";
  for (const std::string& text :
       {edited(late("2000"), of_way, "r.battery >= 30 %;"), edited(late("2000"), of_way, fence)}) {
    EXPECT_TRUE(has(*without_offers(text), Code::site_not_returnable)) << text;
  }
  const std::string uncharged = edited(edited(late("2000"), of_way, fence), back, "");
  EXPECT_TRUE(without_offers(uncharged)->module) << reports(*without_offers(uncharged));
}

// Wheels that turn slowly need room, which their own limits may be the cause of.
TEST(Repairs, WheelsThatTurnTooSlowlyAreTold) {
  const auto wheels = [](const std::string& turn, const std::string& accel) {
    return R"(spec slow;
zone z = rectangle (0 m, 0 m) to (20 m, 20 m);
robot R {
  body radius 20 cm;
  motion unicycle { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn <= )" +
           turn + " rad/s; turn_accel <= " + accel + R"( rad/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense heading : angle error 2 deg max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output o : twist;
  latency 20 ms;
}
fleet x : R;
controller a : advanced for R extern;
controller c : safe for R = retreat within z speed 0.4 m/s;
monitor m for r : R { "R1" always r inside z; recover c; }
decision d for R { advanced a; period 50 ms; priority m; }
)";
  };
  const auto at_least = [](const std::string& text, const std::string& what) {
    return number_in_help(*compiled(text), Code::return_set_empty, what + "` of at least ", "rad");
  };
  const std::string accel = at_least(wheels("2", "0.001"), "turn_accel");
  EXPECT_TRUE(without_offers(wheels("2", accel))->module) << accel;
  EXPECT_FALSE(
      without_offers(wheels("2", std::to_string(0.95 * std::stod(accel) - 0.001)))->module);
  const std::string turn = at_least(wheels("0.001", "10"), "`turn");
  EXPECT_TRUE(without_offers(wheels(turn, "10"))->module) << turn;
}

// Neither is a full battery enough nor the way affordable: one number mends both, and is told
// twice.
TEST(Repairs, OneDriveMends5007And5012) {
  const auto c =
      compiled(driver::test::read(driver::test::fs::path(RTAC_SOURCE_DIR) /
                                  "tests/compiler/analysis/repairs/far_for_a_charge.rta"));
  for (const Code code : {Code::return_set_empty, Code::site_unreachable}) {
    EXPECT_EQ(number_in_help(*c, code, "`drive` of at most ", "%/m"), "8.48") << reports(*c);
  }
}

// What is asked of a clearance so that control returns leaves the recovery as near as before.
TEST(Repairs, ANumberThatMendsHalfOfAMonitorIsNotOffered) {
  const auto c = compiled(driver::test::read(driver::test::fs::path(RTAC_SOURCE_DIR) /
                                             "tests/compiler/analysis/repairs/wide_in_a_ring.rta"));
  ASSERT_TRUE(has(*c, Code::return_set_empty) && has(*c, Code::recovery_elsewhere)) << reports(*c);
  EXPECT_EQ(reports(*c).find("a clearance of at most"), std::string::npos) << reports(*c);
  EXPECT_EQ(reports(*c).find("such as `rim - grow(mid"), std::string::npos) << reports(*c);
  EXPECT_NE(reports(*c).find("in `rim - grow(mid, 1.8 m)` other errors are left"),
            std::string::npos)
      << reports(*c);
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
  EXPECT_FALSE(without_offers(edited(gone, "2500 mm", by))->diagnostics.has_errors());
}

TEST(Repairs, BothNeighboursOf7003AreOnTheGrid) {
  const std::string off = edited(drone_spec(), ">= 10 cm", ">= 10.05 mm");
  const auto c = compiled(off);
  ASSERT_TRUE(has(*c, Code::constant_off_grid)) << reports(*c);
  for (const char* works : {"0.01 m", "0.011 m"}) {
    EXPECT_NE(reports(*c).find(std::string("`") + works + "`"), std::string::npos);
    EXPECT_TRUE(without_offers(edited(off, "10.05 mm", works))->module);
  }
}

// 5007 of a room that is wide enough for robots: the number that is absurd is named, with one that
// works. Each is written into the text and tried; five per cent beyond it nothing returns.
struct Absurd {
  const char *clause, *absurd;  // what is written, and instead of it
  const char *says, *unit;      // what the help says of it
  const char* text;             // the clause with the number `#`
  bool least = false;
};
TEST(Repairs, OneNumberIsNamedThatWorksAlone) {
  const std::string drone = edited(drone_spec(), "ahead   100 ms, 2 waypoints;", "");
  for (const Absurd& a : std::vector<Absurd>{
           {"brake >= 1 m/s^2", "brake >= 0.01 m/s^2", "a `brake` of at least ", "m/s^2",
            "brake >= # m/s^2", true},
           {"error 2 cm ", "error 10 m ", "an `error` of the position of at most ", "m",
            "error # m "},
           {"error 2 cm ", "error 2.6 m ", "an `error` of the position of at most ", "m",
            "error # m "},
           {"radius 8 cm", "radius 3 m", "a `radius` of at most ", "m", "radius # m"},
           {"period 50 ms", "period 10 s", "a `period` of at most ", "ms", "period # ms"},
       }) {
    const auto with = [&](const std::string& clause) { return edited(drone, a.clause, clause); };
    const auto c = compiled(with(a.absurd));
    ASSERT_TRUE(has(*c, Code::return_set_empty)) << a.absurd << "\n" << reports(*c);
    const std::string works = number_in_help(*c, Code::return_set_empty, a.says, a.unit);
    const auto tried = [&](const std::string& number) {
      const auto again = compiled(with(edited(a.text, "#", number)));
      return !has(*again, Code::return_set_empty);
    };
    EXPECT_TRUE(tried(works)) << a.absurd << ": " << reports(*c);
    const double beyond = std::stod(works) * (a.least ? 0.95 : 1.05);
    const std::string unit = a.unit;
    EXPECT_FALSE(tried(unit == "ms" ? std::to_string(std::lround(std::ceil(beyond)))
                                    : std::to_string(beyond)))
        << a.absurd << ": " << reports(*c);
  }
}

// What is older than the room allows.
TEST(Repairs, TheAgeOfASampleIsNamedThatWorks) {
  const std::string old =
      edited(drone_spec(), "sense    position : point   error 2 cm    max_age 50 ms",
             "sense    position : point   error 2 cm    max_age 60 s");
  const auto c = compiled(old);
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most =
      number_in_help(*c, Code::return_set_empty, "`max_age` of the position of at most ", "ms");
  EXPECT_FALSE(has(*without_offers(edited(old, "60 s", most + " ms")), Code::return_set_empty));
  EXPECT_TRUE(has(*without_offers(edited(old, "60 s", std::to_string(std::stol(most) + 1) + " ms")),
                  Code::return_set_empty));
}

// No recovery of this robot is fast enough to make way: not its speed is wrong.
TEST(Repairs, TheErrorOfAVelocityIsNamedThatLetsARecoveryMakeWay) {
  const std::string blind = edited(drone_spec(), "error 2 cm/s", "error 0.6 m/s");
  const auto c = compiled(blind);
  ASSERT_TRUE(has(*c, Code::limit_contradictory)) << reports(*c);
  const std::string most = number_in_help(*c, Code::limit_contradictory,
                                          "an `error` of the velocity of at most ", "m/s");
  EXPECT_EQ(most, "0.15");
  const auto works = compiled(edited(blind, "error 0.6 m/s", "error " + most + " m/s"));
  EXPECT_FALSE(has(*works, Code::limit_contradictory)) << reports(*works);
}

// Of a recovery in space whose zone is too high and too low the help says both at once, and of a
// way to a site, which keeps its height, no zone with heights.
std::string crane(const std::string& recovery, const std::string& zone, const std::string& always) {
  return R"(spec crane;
zone ground = rectangle (0 m, 0 m) to (20 m, 20 m);
zone air = prism (ground) from 0 m to 30 m - prism (rectangle (8 m, 8 m) to (12 m, 12 m)) from 0 m to 15 m;
zone where = )" +
         zone + R"(;
site pad = (4 m, 4 m);
robot Lift {
  body     radius 20 cm;
  motion   point { speed <= 2 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense    position : point3  error 5 cm   max_age 50 ms;
  sense    velocity : vector3 error 5 cm/s max_age 50 ms;
  output   push : acceleration;
  latency  20 ms;
}
fleet l1 : Lift;
controller pilot : advanced for Lift extern;
controller back  : safe for Lift = )" +
         recovery + R"(;
monitor keep for l : Lift { "SR-1: kept" always )" +
         always + R"(; recover back; }
decision go for Lift { advanced pilot; period 50 ms; priority keep; }
)";
}
TEST(Repairs, AZoneTooHighAndTooLowIsToldBoth) {
  const auto within = [](const std::string& zone) {
    return compiled(crane("retreat within where speed 0.5 m/s", zone,
                          "l.position.z >= 5 m and l.position.z <= 25 m"));
  };
  const auto c = within("prism (ground) from 0 m to 30 m");
  EXPECT_NE(reports(*c).find("a zone with a ceiling of at most 25.2 m and a floor of at least "
                             "4.8 m works"),
            std::string::npos)
      << reports(*c);
  const auto works = within("prism (ground) from 4.8 m to 25.2 m");
  EXPECT_TRUE(works->module) << reports(*works);
  EXPECT_TRUE(has(*within("prism (ground) from 4.8 m to 25.21 m"), Code::recovery_elsewhere));
  EXPECT_TRUE(has(*within("prism (ground) from 4.79 m to 25.2 m"), Code::recovery_elsewhere));
  // what is no single prism may lead up and down
  const auto two = within(
      "prism (ground) from 4 m to 15 m | prism (ground - rectangle (8 m, 8 m) to (12 m, 12 m)) "
      "from 15 m to 26 m");
  EXPECT_NE(reports(*two).find("a ceiling of at most 25 m and a floor of at least 5 m works"),
            std::string::npos)
      << reports(*two);
}
TEST(Repairs, AWayThatKeepsItsHeightIsToldAZoneOfThePlane) {
  const auto within = [](const std::string& zone) {
    return compiled(crane("route to pad within where speed 0.5 m/s", zone, "l inside air"));
  };
  const auto c = within("ground");
  ASSERT_TRUE(has(*c, Code::recovery_elsewhere)) << reports(*c);
  EXPECT_NE(
      reports(*c).find("a zone of the plane all of which lies in `air` at every height works"),
      std::string::npos)
      << reports(*c);
  const auto works = within("ground - rectangle (8 m, 8 m) to (12 m, 12 m)");
  EXPECT_TRUE(works->module) << reports(*works);
}

// What a value out of range is told works, works.
TEST(Repairs, TheNumbersOf3008And5005Work) {
  struct Case {
    const char *clause, *absurd, *works;
  };
  for (const Case& each : std::vector<Case>{
           {"accel <= 1 m/s^2", "accel <= 0 m/s^2", "accel <= 0.001 m/s^2"},
           {"speed <= 1 m/s", "speed <= 0 m/s", "speed <= 0.3 m/s"},
           {"period 50 ms", "period 0 ms", "period 1 ms"},
           {"speed 0.3 m/s", "speed 0 m/s", "speed 0.04 m/s"},
           {"speed 0.3 m/s", "speed -1 m/s", "speed 1 m/s"},
           {"speed 0.3 m/s", "speed 3 m/s", "speed 1 m/s"},
       }) {
    const std::string drone = edited(drone_spec(), "ahead   100 ms, 2 waypoints;", "");
    const auto bad = compiled(edited(drone, each.clause, each.absurd));
    EXPECT_TRUE(has(*bad, Code::quantity_out_of_range) || has(*bad, Code::limit_contradictory))
        << each.absurd << "\n"
        << reports(*bad);
    const auto good = compiled(edited(drone, each.clause, each.works));
    EXPECT_FALSE(has(*good, Code::quantity_out_of_range) || has(*good, Code::limit_contradictory) ||
                 has(*good, Code::value_out_of_range))
        << each.works << "\n"
        << reports(*good);
  }
}

// Who cannot stop is told with which brake all of the specification works: it does, and with a
// twentieth less it does not.
TEST(Repairs, TheBrakeOfWhoCannotStopWorks) {
  const std::string drone = edited(drone_spec(), "ahead   100 ms, 2 waypoints;", "");
  const auto with = [&](const std::string& brake) {
    return compiled(edited(drone, "brake >= 1 m/s^2", "brake >= " + brake + " m/s^2"));
  };
  const std::string least =
      number_in_help(*with("0"), Code::limit_contradictory, "at least ", "m/s^2 works");
  EXPECT_EQ(number_in_help(*with("-1"), Code::limit_contradictory, "at least ", "m/s^2 works"),
            least);
  EXPECT_TRUE(with(least)->module) << least;
  const double less = std::stod(least) * 0.95;
  EXPECT_FALSE(with(std::to_string(less))->module) << less;
}

// A brake that is sampled takes a long way to turn into a hold where it is very strong: to declare
// less of it works.
TEST(Repairs, ABrakeThatIsTooStrongIsToldWhichOneWorks) {
  const std::string drone = edited(drone_spec(), "ahead   100 ms, 2 waypoints;", "");
  const auto with = [&](const std::string& brake) {
    return compiled(edited(drone, "brake >= 1 m/s^2", "brake >= " + brake + " m/s^2"));
  };
  const auto c = with("1000");
  const std::string most =
      number_in_help(*c, Code::return_set_empty, "a `brake` of at most ", "m/s^2");
  EXPECT_TRUE(with(most)->module) << most;
  EXPECT_FALSE(with(std::to_string(std::stod(most) * 1.05))->module) << most;
}

// Where inputs may ask for less speed than a recovery has, the greatest that it may have works.
TEST(Repairs, ARecoveryThatInputsMayFindTooFastIsToldItsSpeed) {
  const auto with = [](const std::string& speed) {
    return compiled(R"(spec ward;
zone floor = rectangle (0 m, 0 m) to (20 m, 12 m);
input alarm : bool max_age 1 s;
robot Cart {
  body     radius 30 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 100 ms;
  sense    velocity : vector  error 2 cm/s  max_age 100 ms;
  output   push : acceleration;
  latency  40 ms;
}
fleet c : Cart;
controller nav  : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller back : safe for Cart = retreat within floor speed )" +
                    speed + R"( m/s;
monitor walls for r : Cart { "R1: on the floor" always r inside floor; recover back; }
monitor calm  for r : Cart { "R2: slow after an alarm" always once[0 s, 20 s] alarm implies r.speed <= 0.3 m/s; recover stop; }
decision drive for Cart { advanced nav; period 50 ms; priority walls > calm; }
)");
  };
  const auto c = with("0.5");
  const std::string most =
      number_in_help(*c, Code::recovery_breaks, "a recovery of at most ", "m/s works");
  EXPECT_TRUE(with(most)->module) << most << reports(*with(most));
  EXPECT_TRUE(has(*with(std::to_string(std::stod(most) * 1.05)), Code::recovery_breaks)) << most;
}

// A latency that the look-ahead does not cover: both numbers work.
TEST(Repairs, TheNumbersOf5018Work) {
  const std::string late = edited(drone_spec(), "latency  20 ms", "latency  200 ms");
  const auto c = compiled(late);
  ASSERT_TRUE(has(*c, Code::latency_too_long)) << reports(*c);
  const std::string ahead = number_in_help(*c, Code::latency_too_long, "`ahead ", "ms` works");
  const auto longer = compiled(edited(late, "ahead   100 ms", "ahead " + ahead + " ms"));
  EXPECT_FALSE(has(*longer, Code::latency_too_long)) << reports(*longer);
  EXPECT_TRUE(longer->module) << reports(*longer);
  const std::string most = number_in_help(*c, Code::latency_too_long, "latency of at most ", "ms");
  const auto sooner = compiled(edited(late, "latency  200 ms", "latency " + most + " ms"));
  EXPECT_FALSE(has(*sooner, Code::latency_too_long)) << reports(*sooner);
}

// One that no look-ahead covers in this room contradicts it: with the largest that is offered one
// does.
TEST(Repairs, TheLatencyThatSomeLookaheadCoversIsNamed) {
  const std::string late = edited(drone_spec(), "latency  20 ms", "latency  700 ms");
  const auto c = compiled(late);
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most =
      number_in_help(*c, Code::return_set_empty, "a `latency` of at most ", "ms");
  const auto with = [&](long ms) {
    return compiled(edited(late, "latency  700 ms", "latency " + std::to_string(ms) + " ms"));
  };
  EXPECT_FALSE(with(std::stol(most))->diagnostics.has_errors());
  EXPECT_TRUE(with(std::stol(most) + 1)->diagnostics.has_errors());
}

// With way-points, legs that track so badly fit nowhere.
TEST(Repairs, TheTrackingOf5007Works) {
  const std::string wide = edited(drone_spec(), "tracking <= 10 cm", "tracking <= 10 m");
  const auto c = compiled(wide);
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "`tracking <= ", "m` works");
  EXPECT_TRUE(
      without_offers(edited(wide, "tracking <= 10 m", "tracking <= " + most + " m"))->module);
  const std::string more = std::to_string(std::stod(most) + 0.001);
  EXPECT_TRUE(has(*without_offers(edited(wide, "tracking <= 10 m", "tracking <= " + more + " m")),
                  Code::return_set_empty));
}

// Cells that are as narrow as cells get: the zone has to be wider.
TEST(Repairs, TheWideningOf4012Works) {
  const auto mine = [](const std::string& wide, const std::string& length) {
    const std::string drone = edited(drone_spec(), "ahead   100 ms, 2 waypoints;", "");
    return edited(drone, "rectangle (0 m, 0 m) to (5 m, 5 m)",
                  "rectangle (0 m, 0 m) to (" + length + ", " + wide +
                      " mm) | rectangle (0 m, 0 m) to (" + wide + " mm, " + length + ")");
  };
  const auto c = compiled(edited(mine("800", "400 m"), ">= 10 cm", ">= 0 cm"));
  ASSERT_TRUE(has(*c, Code::cells_too_coarse)) << reports(*c);
  const std::string by = number_in_help(*c, Code::cells_too_coarse, "widen its passages by ", "m");
  const long mm = 800 + std::lround(1000 * std::stod(by));
  EXPECT_FALSE(has(*without_offers(edited(mine(std::to_string(mm), "20 m"), ">= 10 cm", ">= 0 cm")),
                   Code::cells_too_coarse));
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

// Zones that are written in a property have no name to move within: what stands there is offered.
std::string by_the_pond(const std::string& property, const std::string& moves_within) {
  return R"(spec pond;
zone yard = rectangle (0 m, 0 m) to (12 m, 12 m);
zone pond = rectangle (5 m, 5 m) to (7 m, 7 m);
zone kept = )" +
         moves_within + R"(;
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 0.6 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm max_age 50 ms;
  sense   velocity : vector error 2 cm/s max_age 50 ms;
  output  push : acceleration;
  latency 50 ms;
}
fleet bot : Bot;
controller run  : advanced for Bot extern;
controller back : safe for Bot = retreat within kept speed 0.3 m/s;
monitor dry for r : Bot { "R1" always )" +
         property + R"(; recover back; }
decision drive for Bot { advanced run; period 50 ms; priority dry; }
)";
}
TEST(Repairs, WhatIsWrittenInAPropertyIsOfferedAsAZone) {
  for (const std::string zone :
       {"yard - grow(pond, 1.2 m)", "shrink(yard, 0.6 m)", "yard - pond", "yard - (pond & yard)"}) {
    const auto c = compiled(by_the_pond("r inside " + zone, "yard"));
    ASSERT_TRUE(has(*c, Code::recovery_elsewhere)) << reports(*c);
    EXPECT_NE(reports(*c).find("works, such as `" + zone + "`"), std::string::npos) << reports(*c);
    const auto good = compiled(by_the_pond("r inside " + zone, zone));
    EXPECT_TRUE(good->module) << reports(*good);
  }
}

// The site of a way lies in what the property keeps it out of: no part of its zone is enough.
TEST(Repairs, AZoneThatHasNotWorkedIsNotSaidToWork) {
  const std::string faulty = edited(edited(by_the_pond("distance(r, pond) >= 1 m", "yard"),
                                           "robot Bot", "site hut = (6 m, 6 m);\nrobot Bot"),
                                    "retreat within", "route to hut within");
  const auto c = compiled(faulty);
  ASSERT_TRUE(has(*c, Code::recovery_elsewhere)) << reports(*c);
  EXPECT_NE(reports(*c).find("is needed, and not alone: in `kept - grow(pond, 1 m)` other errors"),
            std::string::npos)
      << reports(*c);
  EXPECT_FALSE(
      without_offers(edited(faulty, "kept = yard", "kept = yard - grow(pond, 1 m)"))->module);
}

// A distance within a zone that has no name is the number of a place in common.
std::string lane_and_shrunk_yard(const std::string& off) {
  return R"(spec joint;
zone yard = rectangle (0 m, 0 m) to (12 m, 12 m);
zone mid  = shrink(yard, 1.9 m);
zone lane = rectangle (0 m, 0 m) to (12 m, 2 m);
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 0.6 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm max_age 50 ms;
  sense   velocity : vector error 2 cm/s max_age 50 ms;
  output  push : acceleration;
  latency 50 ms;
}
fleet bot : Bot;
controller run  : advanced for Bot extern;
controller back : safe for Bot = retreat within lane speed 0.3 m/s;
controller off  : safe for Bot = retreat within mid speed 0.3 m/s;
monitor fence for r : Bot { "R1" always r inside lane; recover back; }
monitor dry   for r : Bot { "R2" always r inside shrink(yard, )" +
         off + R"( m); recover off; }
decision drive for Bot { advanced run; period 50 ms; priority fence > dry; acknowledge back may break dry "x"; }
)";
}
TEST(Repairs, ADistanceInAZoneWithoutANameOf5007Works) {
  const auto c = compiled(lane_and_shrunk_yard("1.8"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  const std::string most =
      number_in_help(*c, Code::return_set_empty, "`shrink(yard, ", "m)` in place of");
  EXPECT_FALSE(has(*without_offers(lane_and_shrunk_yard(most)), Code::return_set_empty)) << most;
  const std::string beyond = std::to_string(1.05 * std::stod(most));
  EXPECT_TRUE(has(*without_offers(lane_and_shrunk_yard(beyond)), Code::return_set_empty)) << most;
}

}  // namespace
}  // namespace rtac::analysis::test
