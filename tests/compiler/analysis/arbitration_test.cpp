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

// The recovery that is offered has been thought through: with it nothing is broken. Where the zone
// of the other monitor is none for this one, it is not offered, but what is left of its own.
TEST(Arbitration, OffersARecoveryThatWouldDo) {
  const std::string two = two_zones("", "priority in_yard > in_west;");
  EXPECT_NE(reports(*compiled(two)).find("a recovery within `west` works"), std::string::npos);
  const auto mended = compiled(edited(two, "retreat within yard", "retreat within west"));
  EXPECT_FALSE(mended->diagnostics.has_errors()) << reports(*mended);
  const std::string away =
      "zone pit = rectangle (6 m, 6 m) to (7 m, 7 m);\n"
      "zone off_pit = yard - grow(pit, 50 cm);\n"
      "controller off : safe for Rover = retreat within off_pit speed 0.2 m/s;\n"
      "monitor no_pit for r : Rover { \"SR-5\" always distance(r, pit) >= 20 cm; recover off; }\n";
  const std::string text = two_zones(away, "priority in_yard > no_pit;");
  const std::string said = reports(*compiled(text));
  EXPECT_EQ(said.find("within `complement(pit)`"), std::string::npos) << said;
  EXPECT_NE(said.find("within a zone that is `yard - grow(pit, 0.2 m)` works"), std::string::npos)
      << said;
  const std::string rest =
      edited(text, "zone off_pit", "zone rest = yard - grow(pit, 20 cm);\nzone off_pit");
  const std::string inwards = "retreat within yard speed 0.2 m/s;\ncontroller go_west";
  const auto left = compiled(edited(rest, inwards, edited(inwards, "yard", "rest")));
  EXPECT_FALSE(left->diagnostics.has_errors()) << reports(*left);
}

// What its own monitor asks for it had as long as it moved within the zone of that: what is left of
// the zone has to keep it as well (5016).
TEST(Arbitration, WhatItOffersKeepsWhatItsOwnMonitorAsksFor) {
  const std::string text = two_zones(
      "zone pit = rectangle (6 m, 6 m) to (7 m, 7 m);\n"
      "zone off_pit = yard - grow(pit, 50 cm);\n"
      "controller off : safe for Rover = retreat within off_pit speed 0.2 m/s;\n"
      "monitor no_pit for r : Rover { \"SR-5\" always distance(r, pit) >= 20 cm; recover off; }\n",
      "priority in_yard > no_pit;");
  const std::string asking = edited(text, "r inside yard", "clearance(r, yard) >= 10 cm");
  const std::string said = reports(*compiled(asking));
  EXPECT_NE(said.find("while `inwards` drives, `no_pit` may become false"), std::string::npos)
      << said;
  EXPECT_NE(said.find("a recovery within another zone is needed, and not alone: in `yard - "
                      "grow(pit, 0.2 m)` other errors are left"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("within a zone that is"), std::string::npos) << said;
}

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

// The way of a retreat has a bound; that others go away, or that somebody gives a permit, has none.
TEST(Arbitration, ChargeIsSpentWithoutEndWhileAMonitorWaitsForOthersOrInputs) {
  const auto with = [](const std::string& property, const std::string& order) {
    return two_zones(
        "input permit : bool max_age 1 s;\n"
        "agent person : radius 20 cm, speed <= 1 m/s error 5 cm max_age 200 ms;\n"
        "monitor waits for r : Rover { \"SR-9: waits\" always " +
            property + "; recover go_west; }\n",
        order + " acknowledge go_west may break waits \"those who walk see it\";");
  };
  const std::string others = "forall q : Rover, q != r : distance(r, q) >= 10 cm";
  const Messages lost = {"while `go_west` drives, `charged` may become false, and ranks lower"};
  for (const std::string& property :
       {others, std::string("r inside west and permit"), std::string("not permit and ") + others,
        std::string("r inside west and distance(r, person) >= 30 cm")}) {
    EXPECT_EQ(broken(with(property, "priority waits > charged;")), lost) << property;
    EXPECT_EQ(broken(with(property, "priority charged > waits;")), Messages{}) << property;
  }
  // it leads to the other side
  EXPECT_EQ(broken(with("permit or r inside west", "priority waits > charged;")), Messages{});
  EXPECT_NE(reports(*compiled(with("r inside west and permit", "priority waits > charged;")))
                .find("`priority charged > waits;` works"),
            std::string::npos);
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

// What is only counted may be near, and gates nobody: a recovery that moves may drive up to others.
TEST(Arbitration, ANumberOfOthersIsKeptByWhoStands) {
  const std::string few =
      "monitor few for r : Rover { \"SR-5: nobody near\" always count(q : Rover, q != r : "
      "distance(r, q) <= 1 m) <= 0; recover stop; hold when violated \"a test\"; }\n";
  const std::string accepts = " acknowledge stop may break few \"a test\";";
  EXPECT_EQ(broken(two_zones(few, "priority in_west > few;" + accepts)),
            Messages{"while `go_west` drives, `few` may become false, and ranks lower"});
  EXPECT_EQ(broken(two_zones(few, "priority few > in_west;" + accepts)), Messages{});
  const std::string still =
      "monitor slow for r : Rover { \"SR-6: slow\" always r.speed <= 0.3 m/s; recover halt; }\n"
      "controller halt : safe for Rover = brake_and_hold;\n";
  EXPECT_EQ(broken(two_zones(few + still, "priority slow > few;" + accepts)), Messages{});
  // as many as there are is no condition
  EXPECT_EQ(broken(two_zones(edited(few, "<= 0;", "<= 1;"), "priority in_west > few;" + accepts)),
            Messages{});
}

// ---- coordinated

// What leads out of a zone may rank anywhere, if the recovery of that zone keeps all above it.
TEST(Arbitration, CoordinatedAZoneIsKeptByItsOwnRecovery) {
  EXPECT_EQ(broken(two_zones("", "coordinate in_yard > in_west;")), Messages{});
  EXPECT_EQ(broken(two_zones("", "coordinate in_west > in_yard;")), Messages{});
  EXPECT_EQ(broken(two_zones("", "coordinate apart > charged;")), Messages{});
  EXPECT_EQ(broken(two_zones("", "coordinate apart > in_yard > in_west > charged;")), Messages{});
}

// A charge that no retreat pays for, and ways to the dock that leave the zone of that retreat.
TEST(Arbitration, CoordinatedACircleIsBrokenByWhomeverRanksAbove) {
  const char* const east =
      "zone east = rectangle (3 m, 0 m) to (8 m, 8 m);\n"
      "controller go_east : safe for Rover = retreat within east speed 0.2 m/s;\n"
      "monitor in_east for r : Rover { \"SR-7: in the east\" always r inside east; recover "
      "go_east; }\n";
  EXPECT_EQ(broken(two_zones(east, "coordinate in_east > in_west;")),
            Messages{"while `go_east` drives, `in_west` may become false, and no recovery keeps it "
                     "with what ranks above"});
  // a third one, that is led to the circle, and one that is not
  EXPECT_EQ(broken(two_zones(east, "coordinate in_yard > in_east > in_west;")).size(), 2u);
  EXPECT_EQ(broken(two_zones(east, "coordinate in_east > in_yard;")), Messages{});
  EXPECT_EQ(broken(two_zones(east,
                             "coordinate in_east > in_west; acknowledge go_east may break in_west "
                             "\"the west is a nuisance\";")),
            Messages{});
}

// To what inputs say its own recovery is the answer, and none that happens to drive.
TEST(Arbitration, CoordinatedInputsAreAnsweredByTheirOwnRecovery) {
  const std::string nobody =
      "input free : bool max_age 1 s;\n"
      "monitor nobody for r : Rover { \"SR-8: nobody is there\" always free; recover stop; }\n";
  EXPECT_EQ(broken(two_zones(nobody, "coordinate nobody > in_west;")), Messages{});
  EXPECT_EQ(broken(two_zones(nobody, "coordinate in_west > nobody;")), Messages{});
  // it stands, and spends charge; and nobody else answers
  EXPECT_EQ(broken(two_zones(nobody, "coordinate nobody > charged;")),
            Messages{"while `stop` drives, `charged` may become false, and no recovery keeps it "
                     "with what ranks above"});
}

// Of any pairs that are not kept: a circle is found exactly where some monitors, one of them and
// others above it, could fail at once of which no recovery keeps all.
TEST(Arbitration, ACircleIsFoundExactlyWhereNobodyKeepsAll) {
  unsigned next = 7;
  const auto random = [&] { return (next = next * 1103515245u + 12345u) >> 16; };
  int circles = 0;
  for (int n = 0; n < 3'000; ++n) {
    const std::size_t count = 2 + random() % 5;
    std::vector<std::vector<bool>> unkept(count, std::vector<bool>(count));
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) unkept[i][j] = i != j && random() % 4 == 0;
    }
    for (std::size_t j = 0; j < count; ++j) {
      bool lost = false;
      for (std::size_t set = 0; set < (std::size_t{1} << j); ++set) {
        const std::size_t failed = set | (std::size_t{1} << j);
        bool somebody = false;
        for (std::size_t i = 0; i <= j; ++i) {
          if ((failed >> i & 1) == 0) continue;
          bool all = true;
          for (std::size_t k = 0; k <= j; ++k) all = all && !((failed >> k & 1) && unkept[i][k]);
          somebody = somebody || all;
        }
        lost = lost || !somebody;
      }
      EXPECT_EQ(!conflict_of(unkept, j).empty(), lost);
      circles += lost;
    }
  }
  EXPECT_GT(circles, 500);
}

// Whoever keeps its height may break a ceiling, and whoever stands does not: that is offered where
// it is no worse for what the recovery is for.
TEST(Arbitration, ToStandIsOfferedWhereItWorks) {
  const auto page = [](const std::string& property, const std::string& recovery) {
    return R"(spec tower;
zone cage = prism (rectangle (0 m, 0 m) to (20 m, 20 m)) from 11 m to 15 m;
input lost : bool max_age 1 s;
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 2 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense   position : point3  error 2 cm   max_age 100 ms;
  sense   velocity : vector3 error 2 cm/s max_age 100 ms;
  output  thrust : acceleration;
  latency 40 ms;
}
fleet b : Bot;
controller go   : advanced for Bot extern;
controller down : safe for Bot = land to 1.5 m speed 0.4 m/s;
controller back : safe for Bot = )" +
           recovery + R"(;
monitor kept for x : Bot { "R1" always )" +
           property + R"(; recover back; }
monitor low for x : Bot {
  "R2: below 12 m" always x.position.z <= 12 m; recover down; hold when violated "a pilot lands it";
}
decision d for Bot { advanced go; period 50 ms; priority kept > low; }
)";
  };
  const std::string back = "retreat within cage speed 0.4 m/s";
  const std::string offer = "`brake_and_hold` as the recovery of `kept` works";
  const auto lost = compiled(page("not lost", back));
  ASSERT_TRUE(has(*lost, Code::recovery_breaks)) << reports(*lost);
  EXPECT_NE(reports(*lost).find(offer), std::string::npos) << reports(*lost);
  const auto stands = compiled(page("not lost", "brake_and_hold"));
  EXPECT_FALSE(stands->diagnostics.has_errors()) << reports(*stands);
  // which does not lead back in
  const auto outside = compiled(page("x inside cage", back));
  ASSERT_TRUE(has(*outside, Code::recovery_breaks)) << reports(*outside);
  EXPECT_EQ(reports(*outside).find(offer), std::string::npos) << reports(*outside);
}

// What stands in its place does so for that monitor alone: others go on with what they share.
TEST(Arbitration, ToStandIsTriedForOneMonitor) {
  const auto page = [](const std::string& of_other, const std::string& of_first) {
    return R"(spec tower;
zone cage = prism (rectangle (0 m, 0 m) to (20 m, 20 m)) from 0 m to 15 m;
input lost : bool max_age 1 s;
input hot : bool max_age 1 s;
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 2 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense   position : point3  error 2 cm   max_age 100 ms;
  sense   velocity : vector3 error 2 cm/s max_age 100 ms;
  output  thrust : acceleration;
  latency 40 ms;
}
fleet b : Bot;
controller go    : advanced for Bot extern;
controller down  : safe for Bot = land to 1.5 m speed 0.4 m/s;
controller back  : safe for Bot = retreat within cage speed 0.4 m/s;
controller stand : safe for Bot = brake_and_hold;
monitor kept for x : Bot { "R1" always not lost; recover )" +
           of_first + R"(; }
monitor cool for x : Bot { "R3" always )" +
           of_other + R"(; recover back; }
monitor low for x : Bot {
  "R2: below 12 m" always x.position.z <= 12 m; recover down; hold when violated "a pilot lands it";
}
decision d for Bot { advanced go; period 50 ms; priority kept > cool > low; }
)";
  };
  const std::string offer = "`brake_and_hold` as the recovery of `kept` works";
  for (const char* of_other : {"not hot", "x inside cage"}) {
    const auto moves = compiled(page(of_other, "back")), stands = compiled(page(of_other, "stand"));
    const auto errors = [](const driver::Compilation& c) { return c.diagnostics.error_count(); };
    EXPECT_EQ(reports(*moves).find(offer) != std::string::npos, errors(*stands) < errors(*moves))
        << of_other << "\n"
        << reports(*moves) << "\n"
        << reports(*stands);
  }
}

// Each message names what works, and it does.
TEST(Arbitration, TheHelpWorks) {
  const auto c = compiled(two_zones("", "priority in_yard > in_west;"));
  ASSERT_EQ(c->diagnostics.error_count(), 1);
  std::string help;
  for (const auto& d : c->diagnostics.all()) {
    if (d.code == Code::recovery_breaks) help = d.help;
  }
  EXPECT_NE(help.find("`priority in_west > in_yard;` works"), std::string::npos) << help;
  EXPECT_NE(help.find("a recovery within `west`"), std::string::npos) << help;
  EXPECT_EQ(broken(two_zones("monitor here for r : Rover { \"SR-6: in the yard\" always r inside "
                             "yard; recover go_west; }\n",
                             "priority here > in_west;")),
            Messages{});
}

std::string help_of_6005(const std::string& text) {
  const auto c = compiled(text);
  for (const auto& d : c->diagnostics.all()) {
    if (d.code == Code::recovery_breaks) return d.help;
  }
  ADD_FAILURE() << reports(*c);
  return "";
}
// An order is offered where one keeps everything, all of it at once.
TEST(Arbitration, AnOrderThatIsOfferedIsOneThatKeepsEverything) {
  const std::string inner =
      "zone bay = rectangle (0 m, 0 m) to (3 m, 3 m);\n"
      "controller go_bay : safe for Rover = retreat within bay speed 0.2 m/s;\n"
      "monitor in_bay for r : Rover { \"SR-6: in the bay\" always r inside bay; recover go_bay; "
      "}\n";
  const std::string help = help_of_6005(two_zones(inner, "priority in_yard > in_west > in_bay;"));
  EXPECT_NE(help.find("`priority in_bay > in_west > in_yard;` works"), std::string::npos) << help;
  EXPECT_EQ(broken(two_zones(inner, "priority in_bay > in_west > in_yard;")), Messages{});
}
// Of two zones that overlap each recovery leads out of the other one, whatever the order is: what
// they share is offered, and works.
TEST(Arbitration, WhereNoOrderKeepsBothWhatTheyShareIsOffered) {
  const auto text = [](const std::string& within) {
    return two_zones(
        "zone low = rectangle (0 m, 0 m) to (8 m, 5 m);\nzone shared = west & low;\n"
        "controller go_low : safe for Rover = retreat within " +
            within +
            " speed 0.2 m/s;\n"
            "controller to_west : safe for Rover = retreat within " +
            (within == "low" ? std::string("west") : within) +
            " speed 0.2 m/s;\n"
            "monitor in_low for r : Rover { \"SR-6: low\" always r inside low; recover go_low; }\n"
            "monitor west_too for r : Rover { \"SR-7: west\" always r inside west; recover "
            "to_west; }\n",
        "priority in_low > west_too;");
  };
  const std::string help = help_of_6005(text("low"));
  EXPECT_EQ(help.find("priority"), std::string::npos) << help;
  EXPECT_NE(help.find("a recovery within a zone that is `low & west` works"), std::string::npos)
      << help;
  EXPECT_EQ(broken(text("shared")), Messages{});
}

// Keeping out of a part of one's own zone: the rest of it is offered, and what would lead out of a
// third zone is not.
TEST(Arbitration, WhatIsLeftOfAZoneIsOffered) {
  const auto text = [](const std::string& within) {
    return two_zones(
        "zone pit = rectangle (5 m, 5 m) to (6 m, 6 m);\nzone rest = yard - pit;\n"
        "controller off : safe for Rover = retreat within rest speed 0.2 m/s;\n"
        "controller aside : safe for Rover = yield within " +
            within +
            " speed 0.1 m/s order id;\n"
            "monitor gap for r : Rover { \"SR-6\" always forall q : Rover, q != r : "
            "distance(r, q) >= 10 cm; recover aside; }\n"
            "monitor no_pit for r : Rover { \"SR-7\" always distance(r, pit) >= 0 m; recover off; "
            "}\n",
        "priority in_yard > gap > no_pit; acknowledge inwards may break no_pit \"a test\";");
  };
  const std::string help = help_of_6005(text("yard"));
  EXPECT_NE(help.find("a recovery within a zone that is `yard - pit` works"), std::string::npos)
      << help;
  EXPECT_EQ(help.find("complement"), std::string::npos) << help;
  EXPECT_EQ(broken(text("rest")), Messages{});
}

// Of two pairs each has to be accepted, and what mends one of them alone is not offered.
TEST(Arbitration, TwoPairsAreMendedAtOnce) {
  const std::string held = "held <= 1 s; detour <= 10 m";
  const std::string text = two_zones("",
                                     "priority in_yard > in_west > charged; acknowledge go_west "
                                     "may break charged \"a test\";",
                                     held);
  const std::string help = help_of_6005(text);
  EXPECT_NE(help.find("`acknowledge inwards may break in_west \"why\";` and `acknowledge inwards "
                      "may break charged \"why\";`"),
            std::string::npos)
      << help;
  EXPECT_EQ(help.find("a recovery within"), std::string::npos) << help;
  EXPECT_EQ(broken(edited(text, "acknowledge go_west",
                          "acknowledge inwards may break in_west \"a test\"; acknowledge inwards "
                          "may break charged \"a test\"; acknowledge go_west")),
            Messages{});
}

// A way home that leaves a zone is not mended by the rank of that: whoever takes the robot from its
// way leaves it with less charge each time. The way within the zone is offered, and works.
TEST(Arbitration, AWayHomeThatLeavesAZoneIsOfferedInside) {
  const std::string south =
      "zone south = rectangle (0 m, 0 m) to (4 m, 7 m);\n"
      "controller go_south : safe for Rover = retreat within south speed 0.2 m/s;\n"
      "monitor in_south for r : Rover { \"SR-6: south\" always r inside south; recover go_south; "
      "}\n";
  const std::string text = two_zones(south, "priority charged > in_south;");
  const std::string help = help_of_6005(text);
  EXPECT_EQ(help.find("priority"), std::string::npos) << help;
  EXPECT_NE(help.find("a way to `home` within `south` works"), std::string::npos) << help;
  EXPECT_EQ(broken(edited(text, "route to home within west", "route to home within south")),
            Messages{});
}

}  // namespace
}  // namespace rtac::analysis::test
