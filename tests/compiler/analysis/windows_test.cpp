// Zones that come and go: what leads out of them in time, and the numbers that are offered work.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

struct Spec {
  std::string recovery = "route to home within all speed 0.5 m/s";
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
zone lessons = rectangle (4 m, 2 m) to (5 m, 3 m) during )" +
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
  expect_works(gate);
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
  s.more = R"(monitor walls for d : Drone { "SR-2: in" always d inside all; recover back_off; })";
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
  s.window = "monday 08:00:00 .. 08:00:01";
  const std::string message = said(s, Code::window_too_short);
  const std::string found = "leave it takes ";
  const double seconds = std::stod(message.substr(message.find(found) + found.size()));
  const auto lasting = [](int s) {
    const auto two = [](int n) { return (n < 10 ? "0" : "") + std::to_string(n); };
    return "monday 08:00:00 .. 08:" + two(s / 60) + ":" + two(s % 60);
  };
  s.window = lasting(int(seconds) + 1);
  expect_works(s);
  s.window = lasting(int(seconds) - 1);
  said(s, Code::window_too_short);
}

}  // namespace
}  // namespace rtac::analysis::test
