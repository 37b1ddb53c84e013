// Robots that cannot be at their docks at once are charged one after the other (language rule 6.7):
// how long that takes has to be within `held`.
#include <regex>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

struct Yard {
  std::string held = "300", docks = "site dock = (3 m, 5 m);", dock = "dock", more,
              back = " return when r.battery >= 90 %;", fleet = "one, two";
};
// Until one robot is charged up to 90 % it takes 300 s; two of them may be 1 m from each other.
std::string text_of(const Yard& yard) {
  return R"(spec docking;
zone hall = rectangle (0 m, 0 m) to (16 m, 10 m);
robot Bot {
  body    radius 25 cm;
  motion  point { speed <= 0.8 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age 80 ms;
  sense   battery  : ratio  error 1 %    max_age 2 s;
  hears   other robots max_age 150 ms;
  output  push : acceleration;
  latency 30 ms;
  energy  { drive <= 0.2 %/m; idle <= 0.01 %/s; drain <= 0.1 %/s; charge >= 0.3 %/s at dock; held <= )" +
         yard.held + R"( s; detour <= 20 m; }
}
fleet )" +
         yard.fleet + " : Bot;\n" + yard.docks + R"(
controller go   : advanced for Bot extern;
controller way  : safe for Bot = yield within hall speed 0.3 m/s order id;
controller home : safe for Bot = route to dock within hall speed 0.4 m/s;
monitor apart  for r : Bot { "R1" always forall q : Bot, q != r : distance(r, q) >= 50 cm; recover way; hold when violated "staff"; }
monitor charge for r : Bot { "R2" always r.battery >= energy_to()" +
         yard.dock + R"() + 8 %; recover home;)" + yard.back + R"( }
decision drive for Bot { advanced go; period 100 ms; priority apart > charge; )" +
         yard.more + "}\n";
}
const std::string accepts = "acknowledge way may break charge \"waits are within held\"; ";

class Docking : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static Json kept(const Yard& yard) {
    const Outcome o = verified(text_of(yard), {"--format", "json", "--attack", "1"});
    const Json report = Json::parse(o.out, nullptr, false);
    if (report.is_discarded()) {
      ADD_FAILURE() << o.err;
      return {};
    }
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == "P2a" && each["monitor"] == "charge") return each;
    }
    ADD_FAILURE() << o.err;
    return {};
  }
};

TEST_F(Docking, WhoSharesADockWaitsWithinHeld) {
  Yard yard{.more = accepts};
  EXPECT_EQ(kept(yard)["status"], "acknowledged");
  yard.held = "299";
  const Json open = kept(yard);
  EXPECT_NE(open["status"], "acknowledged");
  EXPECT_NE(open["because"].get<std::string>().find(
                "they may do so for 300 s: at `dock` it waits for another robot, which is charged "
                "up to 90 % before it"),
            std::string::npos)
      << open;
}
TEST_F(Docking, OfThreeOneWaitsForTwo) {
  Yard yard{.held = "599", .more = accepts, .fleet = "one, two, three"};
  EXPECT_NE(kept(yard)["status"], "acknowledged");
  yard.held = "600";
  EXPECT_EQ(kept(yard)["status"], "acknowledged");
}
// As far apart as two robots may be, nobody waits.
TEST_F(Docking, DocksThatAreTooNearAreOne) {
  Yard yard{.held = "60", .dock = "dock(r)", .more = accepts};
  const auto docks = [](const std::string& x) {
    return "site dock(one) = (3 m, 5 m);\nsite dock(two) = (" + x + " m, 5 m);";
  };
  yard.docks = docks("3.99");
  EXPECT_NE(kept(yard)["status"], "acknowledged");
  yard.docks = docks("4");
  EXPECT_EQ(kept(yard)["status"], "acknowledged");
}
// Whatever asks for it, and whoever is led there: 90 %, as both see it.
TEST_F(Docking, AllThatIsWrittenOfACharge) {
  for (const char* back :
       {" return when r.battery >= energy_to(dock) + 90 %;", " return when not (r.battery < 90 %);",
        " return when r.battery >= 30 % and (r.battery < 95 % or r.speed <= "
        "1 m/s) and r.battery >= 90 %;"}) {
    Yard yard{.more = accepts, .back = back};
    const Outcome o = verified(text_of(yard), {"-o", "certificates", "--attack", "1"});
    EXPECT_EQ(o.status, exit_clean) << back << o.out << o.err;
    EXPECT_EQ(recheck_sealed_anew().status, exit_clean) << back;
    yard.held = "299";
    EXPECT_NE(kept(yard)["status"], "acknowledged") << back;
    write("certificates/sources/spec.rta", text_of(yard));
    EXPECT_NE(recheck_sealed_anew().out.find("until others are charged"), std::string::npos);
  }
}
// Where nothing is written of how full they have to be, none of them stays there for long.
TEST_F(Docking, WhoIsGivenBackSoonKeepsNobodyWaiting) {
  Yard yard{.held = "60", .more = accepts};
  EXPECT_NE(kept(yard)["status"], "acknowledged");
  yard.back = "";
  EXPECT_EQ(kept(yard)["status"], "acknowledged");
}
// A certificate of one `held` says nothing of a shorter one.
TEST_F(Docking, ARecheckKnowsHowLongThatTakes) {
  const Yard enough{.more = accepts};
  const Outcome o = verified(text_of(enough), {"-o", "certificates", "--attack", "1"});
  ASSERT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  Yard less = enough;
  less.held = "299";
  write("certificates/sources/spec.rta", text_of(less));
  const Outcome denied = recheck_sealed_anew();
  EXPECT_EQ(denied.status, exit_violation) << denied.out;
  EXPECT_NE(denied.out.find("P2a of `charge`: until others are charged before it takes longer "
                            "than `held`"),
            std::string::npos)
      << denied.out;
}

// The recovery engages soon where a battery begins as empty as may be, and not where it is full.
TEST_F(Docking, ARunBeginsWithBatteriesThatAreOnlyJustEnough) {
  write("yard.rta", text_of({.more = accepts}));
  const auto simulated = [](const std::string& battery) {
    write("s.json", R"({"starts": {"one": {"at": [3, 5], "battery": )" + battery +
                        R"(}, "two": {"at": [9, 5], "battery": 1}}, "runs": 4, "duration_s": 5})");
    return rtac({"sim", "yard.rta", "--scenario", "s.json"});
  };
  const auto drives = [&](const std::string& battery) {
    const Outcome o = simulated(battery);
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
    std::smatch share;
    EXPECT_TRUE(std::regex_search(o.out, share, std::regex("charge +home +([0-9.]+) %"))) << o.out;
    return share.empty() ? -1 : std::stod(share[1]);
  };
  EXPECT_GT(drives("\"tight\""), 10);
  EXPECT_LT(drives("0.95"), 5);  // until what it senses is known
  const Outcome refused = simulated("\"full\"");
  EXPECT_EQ(refused.status, exit_usage);
  EXPECT_NE(refused.err.find("a number from 0 to 1 works, or \"tight\""), std::string::npos)
      << refused.err;
}

}  // namespace
}  // namespace rtac::driver::test
