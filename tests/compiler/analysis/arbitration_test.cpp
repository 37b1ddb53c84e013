// Whether the recovery of one monitor keeps what another one says: the matrix, and what is refused.
#include "compiler/analysis/arbitration.h"

#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

// Two zones, a site, a battery; `monitors` and the decision's clauses are the test's.
std::string two_zones(const std::string& monitors, const std::string& clauses,
                      const std::string& held = "held <= 60 s; detour <= 10 m") {
  return R"(spec yard;
zone yard = rectangle (0 m, 0 m) to (8 m, 8 m);
zone west = rectangle (0 m, 0 m) to (4 m, 8 m);
robot Rover {
  body     radius 10 cm;
  motion   unicycle { speed <= 0.3 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }
  sense    position : point   error 1 cm    max_age 100 ms;
  sense    heading  : angle   error 2 deg   max_age 100 ms;
  sense    velocity : vector  error 1 cm/s  max_age 100 ms;
  sense    battery  : ratio   error 1 %     max_age 2 s;
  hears    other robots       max_age 100 ms;
  output   drive    : twist;
  latency  20 ms;
  energy   { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at home; )" +
         held + R"(; }
}
fleet one, two : Rover;
site  home(one) = (1 m, 1 m);
site  home(two) = (3 m, 5 m);
controller explore  : advanced for Rover extern;
controller stop     : safe for Rover = brake_and_hold;
controller give_way : safe for Rover = yield within yard speed 0.1 m/s order id;
controller inwards  : safe for Rover = retreat within yard speed 0.2 m/s;
controller go_west  : safe for Rover = retreat within west speed 0.2 m/s;
controller go_home  : safe for Rover = route to home within west speed 0.2 m/s;
monitor in_yard for r : Rover { "SR-1: in the yard" always r inside yard; recover inwards; }
monitor in_west for r : Rover { "SR-2: in the west" always r inside west; recover go_west; }
monitor charged for r : Rover { "SR-3: home again" always r.battery >= energy_to(home(r)) + 5 %; recover go_home; }
monitor apart   for r : Rover { "SR-4: apart" always forall q : Rover, q != r : distance(r, q) >= 10 cm; recover give_way; }
)" + monitors +
         "decision drive for Rover { advanced explore; period 100 ms; " + clauses + " }\n";
}

std::vector<std::string> broken(const std::string& text) {
  const auto c = compiled(text);
  std::vector<std::string> all;
  for (const auto& d : c->diagnostics.all()) {
    if (diag::info(d.code).severity != diag::Severity::error) continue;
    EXPECT_EQ(d.code, Code::recovery_breaks) << reports(*c);
    all.push_back(d.message);
  }
  return all;
}
using Messages = std::vector<std::string>;

// What leads out of a zone is stopped by the monitor of that zone, if that ranks higher.
TEST(Arbitration, AZoneIsLeftByARecoveryThatRanksHigher) {
  EXPECT_EQ(broken(two_zones("", "priority in_yard > in_west;")),
            Messages{"while `inwards` drives, `in_west` may become false, and ranks lower"});
  EXPECT_EQ(broken(two_zones("", "priority in_west > in_yard;")), Messages{});
}

TEST(Arbitration, WhatIsAcknowledgedIsAccepted) {
  EXPECT_EQ(broken(two_zones("",
                             "priority in_yard > in_west; acknowledge inwards may break "
                             "in_west \"the east is a nuisance and no danger\";")),
            Messages{});
}

// A route and a retreat have bounds; who waits for others, or stands, has none.
TEST(Arbitration, ChargeIsSpentWithoutEndByARobotThatWaits) {
  EXPECT_EQ(broken(two_zones("", "priority apart > charged;")),
            Messages{"while `give_way` drives, `charged` may become false, and ranks lower"});
  EXPECT_EQ(broken(two_zones("", "priority charged > apart;")), Messages{});
  EXPECT_EQ(broken(two_zones("", "priority in_west > charged;")), Messages{});
}

TEST(Arbitration, BoundedRecoveriesFitIntoWhatTheChargeReckonsWith) {
  EXPECT_EQ(broken(two_zones("", "priority in_west > charged;", "held <= 1 s; detour <= 10 m")),
            Messages{"while `go_west` drives, `charged` may become false, and ranks lower"});
  EXPECT_EQ(broken(two_zones("", "priority in_west > charged;", "held <= 60 s; detour <= 1 cm")),
            Messages{"while `go_west` drives, `charged` may become false, and ranks lower"});
}

// All that moves is gated by the distances to others; a brake keeps every zone.
TEST(Arbitration, DistancesAndBrakesAreKept) {
  EXPECT_EQ(broken(two_zones("", "priority in_west > apart;")), Messages{});
  EXPECT_EQ(
      broken(two_zones("monitor slow for r : Rover { \"SR-5: slow\" always r.speed <= 0.3 m/s; "
                       "recover stop; }\n",
                       "priority slow > in_west;")),
      Messages{});
}

// Each message names what works, and it does.
TEST(Arbitration, TheHelpWorks) {
  const auto c = compiled(two_zones("", "priority in_yard > in_west;"));
  ASSERT_EQ(c->diagnostics.error_count(), 1);
  std::string help;
  for (const auto& d : c->diagnostics.all()) {
    if (d.code == Code::recovery_breaks) help = d.help;
  }
  EXPECT_NE(help.find("`in_west > in_yard`"), std::string::npos) << help;
  EXPECT_NE(help.find("a recovery within `west`"), std::string::npos) << help;
  EXPECT_EQ(broken(two_zones("monitor here for r : Rover { \"SR-6: in the yard\" always r inside "
                             "yard; recover go_west; }\n",
                             "priority here > in_west;")),
            Messages{});
}

}  // namespace
}  // namespace rtac::analysis::test
