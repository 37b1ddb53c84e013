// Limits of speeds and heights, written in other words or asked for by inputs, under certificates
// of pages that ask for less.
#include "tests/compiler/verify/forged.h"

namespace rtac::driver::test {
namespace {

class ForgedLimits : public Forged {
 protected:
  static std::string rover(const std::string& calm, const std::string& recovery,
                           const std::string& more = "fence > calm;") {
    return "spec s;\nzone hall = rectangle (0 m, 0 m) to (6 m, 5 m);\n"
           "input estop : bool max_age 200 ms;\n" +
           a_rover +
           "controller back : safe for Rover = retreat within hall speed 0.3 m/s;\n"
           "controller stop : safe for Rover = brake_and_hold;\n"
           "monitor calm for r : Rover { \"R1\" always " +
           calm + "; recover " + recovery +
           "; }\nmonitor fence for r : Rover { \"R2\" always r inside hall; recover back; }\n"
           "decision go for Rover { advanced drive; period 50 ms; priority " +
           more + " }\n";
  }
  static std::string quad(const std::string& always, const std::string& recovery) {
    const std::string stays = recovery.starts_with("land") ? " hold when violated \"x\";" : "";
    return "spec s;\nzone park = box (0 m, 0 m, 0 m) to (20 m, 20 m, 30 m);\n" + a_quad +
           "controller go : safe for Quad = " + recovery +
           ";\nmonitor m for r : Quad { \"R\" always " + always + "; recover go;" + stays +
           " }\ndecision fly for Quad { advanced policy; period 50 ms; priority m; }\n";
  }
};

TEST_F(ForgedLimits, ASumOrAMultipleOfTheSpeedIsALimitOfIt) {
  const std::string faster = "`back` drives faster than `calm` allows";
  prove(rover("r.speed + 0.05 m/s <= 0.9 m/s", "back"));
  expect_noticed_in("spec.rta", "<= 0.9 m/s", "<= 0.2 m/s", faster);
  prove(rover("1 m/s - r.speed >= 0.1 m/s", "back"));
  expect_noticed_in("spec.rta", ">= 0.1 m/s", ">= 0.8 m/s", faster);
  prove(rover("2 * r.speed <= 1.8 m/s", "back"));
  expect_noticed_in("spec.rta", "2 * r.speed", "8 * r.speed", faster);
}

// A limit that inputs ask for is kept by who takes over, if that is another one, who ranks higher.
TEST_F(ForgedLimits, OneThatInputsAskForIsKeptWhereAnotherRecoveryTakesOver) {
  prove(rover("estop implies r.speed <= 0.5 m/s", "back"));
  expect_noticed_in("spec.rta", "0.5 m/s", "0.2 m/s", "`back` drives faster than `calm` allows");
  prove(rover("estop implies r.speed <= 0.5 m/s", "stop"));
  expect_noticed_in("spec.rta", "<= 0.5 m/s", "<= 0.28 m/s",
                    "C of `calm` while `back` drives: `back` drives faster than `calm` allows");
}

// What is acknowledged is that it may be broken, and not that who rests is too fast for it.
TEST_F(ForgedLimits, WhoRestsIsLetGo) {
  prove(rover("r.speed <= 0.5 m/s", "stop", "calm; acknowledge stop may break calm \"x\";"));
  expect_noticed_in("spec.rta", "<= 0.5 m/s", "<= 0.2 m/s",
                    "who rests may be too fast for it to give control back");
  EXPECT_NE(recheck_sealed_anew().out.find("joint return: who rests may be too fast for `calm`"),
            std::string::npos);
}

// Who rests is not as fast as something asks.
TEST_F(ForgedLimits, ALeastSpeedLetsNobodyGo) {
  prove(rover("r.speed <= 0.9 m/s", "stop"));
  expect_noticed_in("spec.rta", "<= 0.9 m/s", ">= 0.2 m/s", "P2b of `calm`");
}

TEST_F(ForgedLimits, ASumOrAMultipleOfTheHeightIsALimitOfIt) {
  const std::string beyond = "may go beyond a height that `m` allows";
  prove(quad("r.position.z - 1 m >= 9 m", "land to 15 m speed 0.5 m/s"));
  expect_noticed_in("spec.rta", "land to 15 m", "land to 5 m", beyond);
  prove(quad("2 * r.position.z >= 20 m", "land to 15 m speed 0.5 m/s"));
  expect_noticed_in("spec.rta", "land to 15 m", "land to 5 m", beyond);
}

// It leads down, and holds who is lower: a limit from above is for where it ends (P2b).
TEST_F(ForgedLimits, ALandingKeepsWhatIsAskedFromAbove) {
  for (const char* always : {"r.position.z <= 4 m", "r.position.z + 1 m <= 5 m"}) {
    prove(quad(always, "land to 5 m speed 0.5 m/s"));
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean) << always;
  }
}

TEST_F(ForgedLimits, ADwellIsThatOfThePage) {
  prove(rover("r.speed <= 0.9 m/s", "stop"));
  for (Json& claim : entry("switching", "")["claims"]) {
    if (claim["claim"] == "protocol") claim["dwell_ticks"] = "3";
  }
  expect_noticed("switching: protocol: control returns after another dwell");
}

// That something is not so near is no less than that it is so far.
TEST_F(ForgedLimits, WhatIsNotLessIsSeenAtItsPlace) {
  for (const char* less :
       {"clearance(r, hall) < 20 cm", "clearance(r, hall) < 20 cm or r.speed > 1 m/s"}) {
    prove(rover(std::string("not (") + less + ")", "back"));
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean) << less;
  }
}

// A distance that others keep as well is one from below, in whichever words; of a choice the least
// one has to fit, of all robots at once.
TEST_F(ForgedLimits, DistancesAreReadInOtherWords) {
  const auto fleet = [](const std::string& asked) {
    return "spec s;\nzone hall = rectangle (0 m, 0 m) to (14 m, 12 m);\n" +
           edited(edited(a_rover, "fleet r1", "fleet r1, r2, r3"), "  output thrust",
                  "  hears other robots max_age 100 ms;\n  output thrust") +
           "controller back : safe for Rover = retreat within hall speed 0.3 m/s;\n"
           "controller stop : safe for Rover = brake_and_hold;\n"
           "monitor apart for r : Rover { \"R1\" always forall q : Rover, q != r : " +
           asked +
           "; recover stop; hold when violated \"x\"; }\n"
           "monitor fence for r : Rover { \"R2\" always r inside hall; recover back; }\n"
           "decision go for Rover { advanced drive; period 50 ms; priority apart > fence; }\n";
  };
  for (const char* near :
       {"not (distance(r, q) < 1 m)", "(distance(r, q) >= 2 m or distance(r, q) >= 1 m)"}) {
    prove(fleet(near));
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean) << near;
  }
  prove(fleet("distance(r, q) >= 1 m"));
  expect_noticed_in("spec.rta", "q) >= 1 m", "q) <= 12 m",
                    "P2a of `apart`: others may break it, whatever the recovery does");
  prove(fleet("(distance(r, q) >= 1 m or distance(r, q) >= 2 m)"));
  expect_noticed_in("spec.rta", "q) >= 1 m or distance(r, q) >= 2 m",
                    "q) >= 12 m or distance(r, q) >= 13 m",
                    "joint return: two of its robots are too near to each other");
}

// In a wind, as slowly as `check` lets it.
TEST_F(ForgedLimits, InSpaceARecoveryMakesWayWhateverItsVelocityErrs) {
  const std::string windy =
      edited(edited(quad("r inside park", "retreat within park speed 0.3 m/s"), "brake >= 2 m/s^2;",
                    "brake >= 3 m/s^2; disturbance <= 1 m/s^2;"),
             "vector3 error 5 cm/s", "vector3 error 8 cm/s");
  prove(windy);
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  // nor does it help to be faster than its brake can follow
  const Outcome o = verified(edited(edited(windy, "accel <= 2 m/s^2", "accel <= 4 m/s^2"),
                                    "disturbance <= 1 m/s^2", "disturbance <= 2.2 m/s^2"));
  EXPECT_NE(o.err.find("`go` is too slow to make way"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("help: a `disturbance` of at most"), std::string::npos) << o.err;
}

// Who is led to a site where a monitor that ranks higher takes over never arrives there.
TEST_F(ForgedLimits, ASiteThatAHigherMonitorBarsIsReachedByNoWay) {
  prove(
      "spec s;\nzone hall = rectangle (0 m, 0 m) to (12 m, 9 m);\n"
      "zone part = rectangle (0 m, 0 m) to (12 m, 9 m);\ninput called : bool max_age 1 s;\n" +
      a_rover +
      "site dock = (9 m, 4 m);\n"
      "controller back : safe for Rover = retreat within part speed 0.3 m/s;\n"
      "controller home : safe for Rover = route to dock within hall speed 0.3 m/s;\n"
      "monitor fence for r : Rover { \"R1\" always r inside part; recover back; }\n"
      "monitor call for r : Rover { \"R2\" always r inside hall and not called; recover home; }\n"
      "decision go for Rover { advanced drive; period 50 ms; priority fence > call; }\n");
  expect_noticed_in("spec.rta", "zone part = rectangle (0 m, 0 m) to (12 m",
                    "zone part = rectangle (0 m, 0 m) to (6 m",
                    "a monitor that ranks higher lets none be at a site of the recovery");
}

// A file says nothing of heights for a zone of the plane.
TEST_F(ForgedLimits, AZoneOfAFileIsReadByARecheck) {
  write("yard.wkt", "POLYGON ((0 0, 14 0, 14 9, 0 9, 0 0))");
  prove(edited(edited(rover("r.speed <= 0.9 m/s", "stop"), "rectangle (0 m, 0 m) to (6 m, 5 m)",
                      "import \"yard.wkt\" in m"),
               "retreat within hall", "retreat within core") +
        "zone core = shrink(hall, 1 m);\n");
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
}

// Each of them is asked about in two ways by the one around it.
TEST_F(ForgedLimits, ConditionsWithinConditionsAreReadOnce) {
  std::string iff = "estop", some = "estop", of_speed = "estop", values = "1";
  for (int k = 0; k < 12; ++k) {
    iff = "(estop iff " + iff + ")";
    some = "(estop xor not " + some + ")";
    of_speed = "(r.speed <= 0.9 m/s iff " + of_speed + ")";
  }
  for (int k = 0; k < 40; ++k) values = "(if " + values + " >= 1 and estop then 1 else 2)";
  for (const std::string& all : {iff, values + " >= 1"}) {
    const Outcome o = verified(rover("r.speed <= 0.9 m/s and " + all, "stop"), {"-o", "proofs"});
    EXPECT_TRUE(o.status == exit_clean || o.status == exit_inconclusive) << o.out << o.err;
    EXPECT_EQ(rtac({"verify", "--recheck", "proofs"}).status, o.status);
  }
  for (const std::string& when : {some, of_speed}) {
    const Outcome o = verified(edited(rover("r.speed <= 0.9 m/s", "stop"), "recover stop;",
                                      "recover stop; return when " + when + ";"));
    EXPECT_TRUE(o.status == exit_clean || o.status == exit_inconclusive) << o.err;
  }
}

}  // namespace
}  // namespace rtac::driver::test
