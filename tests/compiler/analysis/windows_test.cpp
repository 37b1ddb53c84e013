// Zones that come and go: what leads out of them in time, and the numbers that are offered work.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

struct Spec {
  std::string recovery = "route to home within room speed 0.5 m/s";
  std::string home = "(2 m, 2 m)";
  std::string window = "monday 08:00 .. 16:00";
  std::string property = "distance(d, lessons) >= 30 cm";
  std::string more, priority = "quiet";
};
std::string text_of(const Spec& s) {
  return R"(spec yard;
clock utc;
zone room = rectangle (0 m, 0 m) to (6 m, 4 m);
zone nook = rectangle (5 m, 1 m) to (9 m, 3 m);
zone all  = room | nook;
zone lessons = rectangle (4 m, 0 m) to (6 m, 4 m) during )" +
         s.window + R"(;
zone open    = nook during )" +
         s.window + R"(;
robot Drone {
  body     radius 8 cm;
  motion   point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense    position : point   error 1 cm    max_age 20 ms;
  sense    velocity : vector  error 1 cm/s  max_age 20 ms;
  hears    other robots       max_age 20 ms;
  output   thrust : acceleration;
  latency  10 ms;
}
fleet d1, d2 : Drone;
site home = )" +
         s.home + R"(;
controller pilot    : advanced for Drone extern;
controller back_off : safe for Drone = retreat within room speed 0.3 m/s;
controller go_home  : safe for Drone = )" +
         s.recovery + R"(;
monitor quiet for d : Drone { "SR-1: leaves" always )" +
         s.property + "; recover go_home; }\n" + s.more + R"(
decision fly for Drone { advanced pilot; period 20 ms; priority )" +
         s.priority + R"(; }
)";
}
// The only report.
std::string said(const Spec& s, Code code) {
  const auto c = compiled(text_of(s));
  EXPECT_TRUE(has(*c, code)) << reports(*c);
  return c->diagnostics.all().empty() ? "" : c->diagnostics.all().front().message;
}
void expect_works(const Spec& s) {
  const auto c = compiled(text_of(s));
  EXPECT_TRUE(c->diagnostics.all().empty()) << reports(*c);
}

TEST(Windows, ARouteLeadsOut) {
  expect_works({});
  Spec gate;
  gate.property = "d inside room or d inside open";
  gate.recovery = "route to home within all speed 0.5 m/s";
  expect_works(gate);
}

// A way knows no times: from behind the lessons it leads through them while they last.
TEST(Windows, AWayDoesNotLeadThroughWhatIsThere) {
  Spec behind;
  behind.recovery = "route to home within all speed 0.5 m/s";
  EXPECT_EQ(
      said(behind, Code::window_may_pass),
      "the way of `go_home` may lead through where `quiet` does not hold, whether `lessons` is "
      "there or not");
  behind.priority = "quiet; acknowledge go_home may break quiet \"a test\"";
  expect_works(behind);
}

// In a room without corners that point inwards ways are straight: nobody is refused whose site sees
// all that is left of it, and who does not is told from where it does not.
TEST(Windows, AWayIsStraightWhereNothingStandsInIt) {
  Spec corner;  // a zone in the corner of the room
  corner.more = "zone shut = rectangle (4 m, 2 m) to (6 m, 4 m) during monday 08:00 .. 16:00;";
  corner.property = "distance(d, shut) >= 30 cm";
  // from beside its lower wall, 38 cm off, the way to (2 m, 2 m) passes the corner at 25 cm
  EXPECT_NE(said(corner, Code::window_may_pass).find("may lead through"), std::string::npos);
  corner.home = "(2 m, 1.63 m)";
  EXPECT_NE(said(corner, Code::window_may_pass).find("may lead through"), std::string::npos);
  corner.home = "(2 m, 1.62 m)";
  expect_works(corner);
  corner.home = "(5 m, 1 m)";  // what lies above (4 m, 2 m) is behind the corner
  EXPECT_NE(said(corner, Code::window_may_pass).find("may lead through"), std::string::npos);
  Spec middle;
  middle.more = "zone shut = rectangle (3 m, 1.5 m) to (4 m, 2.5 m) during monday 08:00 .. 16:00;";
  middle.property = corner.property;
  const auto c = compiled(text_of(middle));
  bool placed = false;
  for (const auto& d : c->diagnostics.all()) {
    for (const auto& n : d.notes) {
      placed = placed || n.text == "such as from beside (4 m, 2 m), straight to `home`" ||
               n.text == "such as from beside (3.5 m, 2.5 m), straight to `home`";
    }
  }
  EXPECT_TRUE(placed) << reports(*c);
}

// A zone to stay in counts as if it was there; outside of it nothing may be driven at any time.
TEST(Windows, ARecoveryMovesWhereItsPropertyHoldsAtTimes) {
  Spec outside;
  outside.property = "d inside room or d inside open";
  outside.recovery = "route to home within wide speed 0.5 m/s";
  outside.more = "zone wide = all | rectangle (0 m, 4 m) to (6 m, 6 m);";
  EXPECT_NE(said(outside, Code::recovery_elsewhere).find("moves within `wide`"), std::string::npos);
}

TEST(Windows, StandingStillDoesNot) {
  Spec s;
  s.recovery = "retreat within room speed 0.5 m/s";
  EXPECT_EQ(said(s, Code::window_without_way_out),
            "the recovery `go_home` does not lead out before `lessons` changes");
  s.priority = "quiet; acknowledge go_home may break quiet \"a test\"";
  expect_works(s);
}

// The return set lies in the lessons, or too near to them.
TEST(Windows, TheSiteIsWhereTheyDoNotMatter) {
  Spec s;
  s.home = "(3.7 m, 2.5 m)";
  EXPECT_NE(said(s, Code::window_without_way_out).find("ends at `home`, (3.7 m, 2.5 m), where it"),
            std::string::npos);
}

TEST(Windows, OtherRecoveriesThatOutrankAreAcknowledged) {
  Spec s;
  s.more = R"(monitor walls for d : Drone { "SR-2: in" always d inside room; recover back_off; })";
  s.priority = "quiet > walls";
  expect_works(s);
  s.priority = "walls > quiet";
  EXPECT_EQ(said(s, Code::window_may_pass),
            "while `back_off` drives for `walls`, nobody leads out before `lessons` changes");
  s.priority = "walls > quiet; acknowledge back_off may break quiet \"a test\"";
  expect_works(s);
}

TEST(Windows, RobotsThatKeepApartWaitForEachOther) {
  Spec s;
  s.more = R"(monitor apart for d : Drone {
  "SR-2: apart" always forall q : Drone, q != d : distance(d, q) >= 10 cm; recover go_home; })";
  s.priority = "quiet > apart";
  EXPECT_NE(said(s, Code::window_may_pass).find("stands still while another robot is near"),
            std::string::npos);
  s.priority = "quiet > apart; acknowledge go_home may break quiet \"a test\"";
  expect_works(s);
}

// A window as long as is offered, in whole seconds, and one that is a second shorter.
TEST(Windows, OfAZoneToStayInAreLongEnough) {
  Spec s;
  s.property = "d inside room or d inside open";
  s.recovery = "route to home within all speed 0.5 m/s";
  s.window = "monday 08:00:00 .. 08:00:01";
  const std::string message = said(s, Code::window_too_short);
  const std::string found = "leave it takes ";
  const double seconds = std::stod(message.substr(message.find(found) + found.size()));
  const auto lasting = [](int all) {
    const auto two = [](int n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    return "monday 08:00:00 .. 08:" + two(all / 60) + ":" + two(all % 60);
  };
  s.window = lasting(int(seconds) + 1);
  expect_works(s);
  s.window = lasting(int(seconds) - 1);
  said(s, Code::window_too_short);
}

}  // namespace
}  // namespace rtac::analysis::test
