// Recoveries that take over from each other for ever: a run shows it, and no order is offered with
// which they would.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class Turns : public Verify {
 protected:
  // Without what is said of it.
  static std::string page() {
    const std::string text = read(refuted_folder() + "up_and_down.rta");
    return text.substr(text.find("spec "));
  }
  static std::string in_order(const std::string& order) {
    return edited(page(), "fence > weather", order);
  }
  static Json obligation(const Outcome& o, const std::string& kind) {
    const Json report = Json::parse(o.out);
    for (const Json& each : report["decisions"][0]["obligations"]) {
      if (each["obligation"] == kind && each["status"] != "proved") return each;
    }
    return Json::object();
  }
};

TEST_F(Turns, AreShownByWhoDrives) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const Json shown = obligation(verified(page(), {"--format", "json"}), "switching");
  EXPECT_EQ(shown["status"], "refuted");
  const std::string because = shown["because"];
  EXPECT_NE(because.find("`back`, `down` take over from each other for ever"), std::string::npos);
  EXPECT_NE(because.find(" times, while control is not given back for 300 s"), std::string::npos);
  const Outcome again = rtac({"sim", "spec.rta", "--replay", shown.value("trace", "")});
  EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
  EXPECT_NE(again.out.find("not given back: one "), std::string::npos) << again.out;
}
// Over a part of the field alone: runs begin there, also where the landing ends above what the
// other monitor keeps it out of, and within its look-ahead.
TEST_F(Turns, BeginWhereTheOneLeadsToWhereTheOtherTakesOver) {
  ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  const auto over_crowd = [](const std::string& land) {
    return R"(spec over_crowd;
zone air = prism (rectangle (0 m, 0 m) to (100 m, 80 m)) from 0 m to 50 m;
zone free = air - prism (rectangle (40 m, 30 m) to (50 m, 40 m)) from 0 m to 15 m;
input link : bool max_age 1 s;
)" + a_quad +
           R"(controller down : safe for Quad = land to )" + land + R"( speed 0.5 m/s;
controller back : safe for Quad = retreat within free speed 0.8 m/s;
monitor comms for r : Quad { "R1" always link; recover down; }
monitor nofly for r : Quad { "R2" always r inside free; recover back; }
decision fly for Quad { advanced policy; period 50 ms; priority nofly > comms; }
)";
  };
  Json shown;
  for (const char* land : {"2 m", "15.4 m"}) {
    shown = obligation(verified(over_crowd(land), {"--format", "json"}), "switching");
    EXPECT_EQ(shown["status"], "refuted") << land << shown;
  }
  const std::string works = shown["repair"], before = "`land to ";
  ASSERT_EQ(works.find(before), 0) << works;
  const std::string metres = works.substr(before.size(), works.find(" m`") - before.size());
  EXPECT_EQ(verified(over_crowd(metres + " m")).status, exit_clean) << metres;
}
// The model alone does not refute it.
TEST_F(Turns, WithoutARunAreUnknown) {
  const Outcome o = verified(page(), {"--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive);
  EXPECT_EQ(obligation(o, "switching")["status"], "unknown") << o.out;
}
// `fence > weather` has no error, but its recoveries take turns.
TEST_F(Turns, OfAnOrderAreLookedAtBeforeItIsOffered) {
  const Outcome o = verified(in_order("weather > fence"), {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation);
  const std::string repair = obligation(o, "C")["repair"];
  EXPECT_EQ(repair.find("priority"), std::string::npos) << repair;
  const std::string before = "`land to ";
  ASSERT_EQ(repair.find(before), 0) << repair;
  const std::string metres = repair.substr(before.size(), repair.find(" m`") - before.size());
  for (const char* const order : {"weather > fence", "fence > weather"}) {
    const Outcome works =
        verified(edited(in_order(order), "land to 0 m", "land to " + metres + " m"));
    EXPECT_EQ(works.status, exit_clean) << works.out << works.err;
  }
}
// Where they take none it is.
TEST_F(Turns, AnOrderWithoutThemIsOffered) {
  for (const char* shared : {"parts.rta", "space_parts.rta"}) {
    write(shared, read(refuted_folder() + shared));
  }
  const std::string lands = read(refuted_folder() + "lands.rta");
  const std::string text = lands.substr(lands.find("spec "));
  const Outcome o = verified(text, {"--format", "json"});
  const std::string repair = obligation(o, "C")["repair"];
  EXPECT_NE(repair.find("`priority above > walls;` works"), std::string::npos) << repair;
  const Outcome works = verified(edited(text, "walls > above", "above > walls"));
  EXPECT_EQ(works.status, exit_clean) << works.out << works.err;
}

// A landing that the fence lifts off again keeps the fence, and is no less in its way.
TEST_F(Turns, ALandingThatIsLiftedIsDenied) {
  ASSERT_EQ(
      verified(edited(page(), "land to 0 m", "land to 0.95 m"), {"-o", "certificates"}).status,
      exit_clean);
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
  write("certificates/sources/spec.rta", edited(page(), "land to 0 m", "land to 0.9 m"));
  const Outcome denied = recheck_sealed_anew();
  EXPECT_EQ(denied.status, exit_violation) << denied.out;
  EXPECT_NE(denied.out.find("the way down of `down` need not lie in `park`"), std::string::npos)
      << denied.out;
}
// Who accepts that one recovery may break what another one is for is told what else that accepts.
TEST_F(Turns, ThatAreAcceptedAreTold) {
  const std::string text = R"(spec picker;
zone grove = rectangle (0 m, 0 m) to (30 m, 12 m);
zone shade = rectangle (0 m, 0 m) to (10 m, 12 m);
zone yard = rectangle (20 m, 0 m) to (30 m, 12 m);
input hot, full : bool max_age 1 s;
)" + a_rover + R"(controller back : safe for Rover = retreat within grove speed 0.4 m/s;
controller to_shade : safe for Rover = retreat within shade speed 0.4 m/s;
controller to_yard : safe for Rover = retreat within yard speed 0.4 m/s;
monitor fence for r : Rover { "R1" always r inside grove; recover back; }
monitor heat for r : Rover { "R2" always hot implies r inside shade; recover to_shade; }
monitor unload for r : Rover { "R3" always full implies r inside yard; recover to_yard; }
decision go for Rover { advanced drive; period 50 ms; priority fence > heat > unload;
  acknowledge back may break heat "short"; acknowledge back may break unload "short";
  acknowledge to_shade may break unload "heat is worse"; }
)";
  const Outcome o = verified(text, {"--format", "json"});
  const Json switching = obligation(o, "switching");
  EXPECT_EQ(switching["status"], "acknowledged") << o.out;
  EXPECT_NE(switching.value("because", "").find("that accepts, too, that in a run of the model"),
            std::string::npos)
      << switching;
}

}  // namespace
}  // namespace rtac::driver::test
