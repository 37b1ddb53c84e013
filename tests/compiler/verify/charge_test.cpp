// What is said of charge (language rule 6.7): it is given back where the robot is charged, and what
// other recoveries take before that is within `held` and `detour` for all of them, there and back.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

// Two sites, of which `home` charges, in a room of 8 m.
std::string cart(const std::string& energy, const std::string& rest) {
  return R"(spec charges;
zone yard = rectangle (0 m, 0 m) to (8 m, 8 m);
zone spot = rectangle (3 m, 3 m) to (5 m, 5 m);
robot Cart {
  body     radius 10 cm;
  motion   point { speed <= 0.3 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 1 cm    max_age 100 ms;
  sense    velocity : vector  error 1 cm/s  max_age 100 ms;
  sense    battery  : ratio   error 1 %     max_age 2 s;
  output   push     : acceleration;
  latency  20 ms;
  energy   { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.3 %/s; charge >= 1 %/s at home; )" +
         energy + R"( }
}
fleet one : Cart;
site home = (1 m, 1 m);
site base = (4 m, 4 m);
controller explore : advanced for Cart extern;
controller inwards : safe for Cart = retreat within yard speed 0.2 m/s;
controller to_base : safe for Cart = route to base within yard speed 0.2 m/s;
controller go_home : safe for Cart = route to home within yard speed 0.2 m/s;
)" + rest;
}
const std::string ample = "held <= 60 s; detour <= 2 m;";

class Charge : public Verify {
 protected:
  static Json obligation(const std::string& text, const std::string& kind,
                         const std::string& monitor, const std::string& recovery = "") {
    const Json report = Json::parse(verified(text, {"--format", "json"}).out);
    for (const Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == kind && o.value("monitor", "") == monitor &&
          (recovery.empty() || o.value("recovery", "") == recovery)) {
        return o;
      }
    }
    ADD_FAILURE() << kind << " of " << monitor;
    return {};
  }
  // Under another text the certificates of `honest` are denied, and why.
  static void expect_denied(const std::string& honest, const std::string& text,
                            const std::string& why) {
    const Outcome o = verified(honest, {"-o", "certificates"});
    ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
    write("certificates/sources/spec.rta", text);
    const Outcome denied = recheck_sealed_anew();
    EXPECT_EQ(denied.status, exit_violation) << denied.out;
    EXPECT_NE(denied.out.find(why), std::string::npos) << denied.out;
  }
};

// A site at which nobody charges the robot is no end of what its idling takes.
TEST_F(Charge, IsGivenBackWhereTheRobotIsCharged) {
  const auto page = [](const std::string& property, const std::string& recovery) {
    return cart(ample, "monitor charge for c : Cart { \"R1\" always " + property + "; recover " +
                           recovery +
                           "; }\ndecision drive for Cart { advanced explore; period 50 ms; "
                           "priority charge; }\n");
  };
  const std::string home = page("c.battery >= energy_to(home) + 5 %", "go_home");
  EXPECT_EQ(verified(home).status, exit_clean);
  for (const auto& [property, recovery] :
       {std::pair("c.battery >= energy_to(base) + 5 %", "to_base"),
        std::pair("c.battery >= 20 %", "to_base")}) {
    const std::string text = page(property, recovery);
    const Outcome o = verified(text);
    EXPECT_NE(o.status, exit_clean) << o.out;
    EXPECT_NE(o.err.find("the recovery `to_base` ends where nobody charges the robot"),
              std::string::npos)
        << o.err;
    EXPECT_EQ(obligation(text, "P2b", "charge")["status"], "unknown");
  }
  const std::string moved = edited(home, "at home", "at base");
  expect_denied(home, moved,
                "P2a of `charge`: nobody accounts for the charge that `go_home` spends");
  expect_denied(home, moved,
                "P2b of `charge`: where the recovery has led to, nothing gives control back");
}

// A brake takes charge, too, and gets none.
TEST_F(Charge, IsNotGivenBackByABrake) {
  const std::string home = cart(ample, R"(controller stop : safe for Cart = brake_and_hold;
monitor charge for c : Cart { "R1" always c.battery >= 20 %; recover go_home; }
decision drive for Cart { advanced explore; period 50 ms; priority charge; }
)");
  const std::string stands = edited(home, "recover go_home", "recover stop");
  EXPECT_NE(obligation(stands, "P2a", "charge")["status"], "proved");
  EXPECT_EQ(obligation(stands, "P2b", "charge")["status"], "unknown");
  expect_denied(home, stands, "P2a of `charge`");
}

// Who is led away from the dock has as much further to go home.
TEST_F(Charge, PaysForTheWayBackAsWell) {
  const auto page = [](const std::string& energy) {
    return cart(
        energy,
        R"(monitor walls  for c : Cart { "R1" always c inside yard; recover to_base; return when c inside spot; }
monitor charge for c : Cart { "R2" always c.battery >= energy_to(home) + 5 %; recover go_home; }
decision drive for Cart { advanced explore; period 50 ms; priority walls > charge; }
)");
  };
  const std::string narrow = page("held <= 600 s; detour <= 12 m;");
  EXPECT_NE(verified(narrow).err.find("may drive"), std::string::npos) << verified(narrow).err;
  const std::string wide = page("held <= 600 s; detour <= 24 m;");
  const Json kept = obligation(wide, "C", "charge", "to_base");
  EXPECT_EQ(kept["status"], "acknowledged");
  EXPECT_EQ(kept["method"], "declared");
  expect_denied(wide, narrow, "there and back other recoveries drive further than `detour`");
  expect_denied(wide, page("held <= 70 s; detour <= 24 m;"), "last longer than `held`");
}

// Two that rank above it may drive one after the other; of either alone there would be enough.
TEST_F(Charge, PaysForAllThatDriveBefore) {
  const auto page = [](const std::string& held) {
    return cart(
        "held <= " + held + "; detour <= 30 m;",
        R"(monitor clear  for c : Cart { "R1" always clearance(c, yard) >= 5 cm; recover inwards; return when clearance(c, yard) >= 5 cm for 300 s; }
monitor walls  for c : Cart { "R2" always c inside yard; recover to_base; return when c inside spot for 300 s; }
monitor charge for c : Cart { "R3" always c.battery >= energy_to(home) + 5 %; recover go_home; }
decision drive for Cart { advanced explore; period 50 ms; priority clear > walls > charge; }
)");
  };
  const Outcome o = verified(page("500 s"));
  EXPECT_NE(o.status, exit_clean) << o.out;
  EXPECT_NE(o.err.find("`inwards` and `to_base` may last"), std::string::npos) << o.err;
  expect_denied(page("1000 s"), page("500 s"), "last longer than `held`");
}

// What somebody accepts of one recovery is no matter of another one, and is judged all the same.
TEST_F(Charge, PaysForNobodyWhoMayBreakIt) {
  const auto page = [](const std::string& held, const std::string& more) {
    return cart(
        "held <= " + held + "; detour <= 30 m;",
        R"(monitor clear  for c : Cart { "R1" always clearance(c, yard) >= 5 cm; recover inwards; return when clearance(c, yard) >= 5 cm for 300 s; }
monitor walls  for c : Cart { "R2" always c inside yard; recover to_base; return when c inside spot for 300 s; }
monitor charge for c : Cart { "R3" always c.battery >= energy_to(home) + 5 %; recover go_home; }
decision drive for Cart { advanced explore; period 50 ms; priority clear > walls > charge; )" +
            more + "}\n");
  };
  const std::string accept = "acknowledge inwards may break charge \"a test\"; ";
  ASSERT_EQ(verified(page("500 s", accept), {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  const Json alone = obligation(page("100 s", accept), "C", "charge", "inwards");
  EXPECT_EQ(alone["method"], "acknowledged") << alone;
}

// Who stands in the way of a robot keeps it there, with or without company of its own kind.
TEST_F(Charge, RestsOnWhatIsDeclaredAmongAgents) {
  const std::string text =
      edited(cart(ample, R"(controller stop : safe for Cart = brake_and_hold;
monitor charge for c : Cart { "R1" always c.battery >= energy_to(home) + 5 %; recover go_home; }
monitor off for c : Cart { "R2" always distance(c, worker) >= 30 cm; recover stop; }
decision drive for Cart {
  advanced explore; period 50 ms; priority charge > off;
  acknowledge stop may break off "who walks up to it sees it";
  acknowledge go_home may break off "the same";
}
)"),
             "fleet one",
             "agent worker : radius 25 cm, speed <= 1 m/s error 5 cm max_age 200 ms;\nfleet one");
  const Json kept = obligation(text, "P2a", "charge");
  EXPECT_EQ(kept["status"], "acknowledged");
  EXPECT_EQ(kept["method"], "declared");
  ASSERT_EQ(verified(text, {"-o", "certificates"}).status, exit_clean);
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a" && o["monitor"] == "charge") o["status"] = "proved";
  }
  write("certificates/verification.json", report.dump());
  const Outcome denied = recheck_sealed_anew();
  EXPECT_NE(denied.out.find("what others take of a charge is declared, and not proved"),
            std::string::npos)
      << denied.out;
}

// Where a look-ahead is declared unsound, nothing was found clear for as long as a brake takes.
TEST_F(Verify, WhatIsDeclaredUnsoundIsNoProofOfItsRecovery) {
  const std::string sound =
      R"(monitor walls for r : Rover { "R1" always r inside room; recover back; }
decision go for Rover { advanced drive; period 50 ms; priority walls; }
)";
  const std::string page =
      "spec ahead;\nzone room = rectangle (0 m, 0 m) to (9 m, 9 m);\n" + a_rover +
      "controller back : safe for Rover = retreat within room speed 0.3 m/s;\n";
  const std::string unsound =
      edited(sound, "recover back", "ahead 1 ms unsound \"to compare\"; recover back");
  const Outcome o = verified(page + unsound, {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2a", "walls"), Statuses{"acknowledged"});
  ASSERT_EQ(verified(page + sound, {"-o", "certificates"}).status, exit_clean);
  write("certificates/sources/spec.rta", page + unsound);
  const Outcome denied = recheck_sealed_anew();
  EXPECT_NE(denied.out.find("P2a of `walls`: its look-ahead is declared unsound"),
            std::string::npos)
      << denied.out;
}

}  // namespace
}  // namespace rtac::driver::test
