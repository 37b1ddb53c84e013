// What a robot is told decides which limits of speed count: its recoveries are as slow as any that
// may, or the monitor takes over that holds it until the inputs let it go on.
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

std::string yard_with(const std::string& property, const std::string& recovery,
                      const std::string& order) {
  return R"(spec yard;
zone yard = rectangle (0 m, 0 m) to (10 m, 8 m);
input estop : bool max_age 200 ms;
input load : real [kg] in 0 .. 50 kg error 0.5 kg max_age 1 s;
robot Cart {
  body radius 0.25 m;
  motion unicycle { speed <= 1 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; turn_accel <= 8 rad/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  sense heading : angle error 2 deg max_age 100 ms;
  output drive : twist;
  latency 30 ms;
}
fleet c : Cart;
controller policy : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller back : safe for Cart = retreat within yard speed )" +
         recovery + R"(;
monitor fence for r : Cart { "R1: in the yard" always r inside yard; recover back; }
monitor told for r : Cart { "R2: as slow as it is told" always )" +
         property + R"(; recover stop; }
decision gate for Cart { advanced policy; period 50 ms; priority )" +
         order + "; }\n";
}
const char* const halts = "estop implies r.speed <= 0.05 m/s";
const char* const by_load = "if load >= 30 kg then r.speed <= 0.4 m/s else r.speed <= 0.85 m/s";

class Told : public Verify {
 protected:
  static void expect_proved(const std::string& text) {
    const Outcome o = verified(text, {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
    const Outcome again = recheck_sealed_anew();
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  }
};

// No robot can be so slow at once, whoever drives: the brake of the monitor is the answer to it.
TEST_F(Told, AnEmergencyStopTakesOverFromWhatItOutranks) {
  expect_proved(yard_with(halts, "0.3 m/s", "told > fence"));
}
TEST_F(Told, NobodyLooksAfterAnEmergencyStopThatRanksLower) {
  const Outcome o = verified(yard_with(halts, "0.3 m/s", "fence > told"));
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_NE(o.err.find("`back` drives at up to 0.3 m/s, and the inputs of `told` may allow less"),
            std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("`priority told > fence;` works"), std::string::npos) << o.err;
  // what somebody accepts is no turn that recoveries take for ever: inputs let go
  const std::string accepts = "fence > told; acknowledge back may break told \"so slow\"";
  expect_proved(yard_with(halts, "0.3 m/s", accepts));
}
// However it is written: here as a property of inputs alone, which no recovery makes true or false.
TEST_F(Told, NobodyDrivesOnWhileInputsAskForAStop) {
  const std::string stopped = "not estop";
  expect_proved(yard_with(stopped, "0.3 m/s", "told > fence"));
  const Outcome o = verified(yard_with(stopped, "0.3 m/s", "fence > told"));
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_NE(o.err.find("`back` drives on, whatever inputs ask of `stop`"), std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("`priority told > fence;` works"), std::string::npos) << o.err;
  const std::string accepts = "fence > told; acknowledge back may break told \"out first\"";
  expect_proved(yard_with(stopped, "0.3 m/s", accepts));
  // which a recheck does not take for proved
  Json report = Json::parse(read("certificates/verification.json"));
  for (Json& each : report["decisions"][0]["obligations"]) {
    if (each["obligation"] != "C" || each["monitor"] != "told") continue;
    each["status"] = "proved";
    each["claims"] = Json::array({{{"claim", "recovery"},
                                   {"decision", "gate"},
                                   {"monitor", "fence"},
                                   {"controller", "back"}}});
  }
  write("certificates/verification.json", report.dump());
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_violation) << again.out;
  EXPECT_NE(again.out.find("it drives on while inputs ask for a stop"), std::string::npos)
      << again.out;
}
TEST_F(Told, AnEmergencyStopIsItsOwnAnswerWhereverWhoCoordinatesRanksIt) {
  for (const char* const order : {"told > fence", "fence > told"}) {
    for (const char* const speed : {"0.3 m/s", "0.04 m/s"}) {
      expect_proved(edited(yard_with(halts, speed, order), "priority", "coordinate"));
    }
  }
}

// An emergency stop uses up the charge, which is accepted, so that the charge and its way home are
// in a circle with it. Inputs that have let go are no reason to engage, whoever of them drives.
TEST_F(Told, AnEmergencyStopThatHasLetGoIsNoTurnOfWhoCoordinates) {
  std::string text = yard_with(halts, "0.3 m/s", "told > fence > charge");
  text = edited(text, "  output drive",
                R"(  sense battery : ratio error 1 % max_age 5 s;
  energy { drive <= 0.2 %/m; idle <= 0.01 %/s; drain <= 0.3 %/s; charge >= 1 %/s at dock; held <= 60 s; detour <= 15 m; }
  output drive)");
  text = edited(text, "robot Cart", "site dock = (3 m, 4 m);\nrobot Cart");
  text = edited(text, "decision gate",
                R"(controller home : safe for Cart = route to dock within yard speed 0.5 m/s;
monitor charge for r : Cart { "R3: comes home" always r.battery >= energy_to(dock) + 10 %; recover home; return when r.battery >= 85 %; }
decision gate)");
  text = edited(text, "priority told > fence > charge",
                "coordinate told > fence > charge; acknowledge stop may break charge \"staff\"");
  expect_proved(text);
}

// Inputs ask for it wherever the robot is, and stay as they are in a run: a place tells.
TEST_F(Told, ALandingThatInputsAskForOverWhatIsNotToBeHitIsRefuted) {
  const std::string text = R"(spec cranes;
zone air   = prism (rectangle (0 m, 0 m) to (60 m, 60 m)) from 0 m to 50 m;
zone crane = prism (rectangle (20 m, 20 m) to (30 m, 30 m)) from 0 m to 25 m;
zone free  = air - crane;
input link : bool max_age 1 s;
robot Quad {
  body radius 30 cm;
  motion point { speed <= 3 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense position : point3 error 5 cm max_age 50 ms;
  sense velocity : vector3 error 5 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller back : safe for Quad = retreat within free speed 0.5 m/s;
controller down : safe for Quad = land to 2 m speed 0.5 m/s;
monitor radio for d : Quad { "R1: lands without a link" always link; recover down; }
monitor walls for d : Quad { "R2: off the crane" always d inside free; recover back; }
decision fly for Quad { advanced policy; period 50 ms; priority radio > walls; }
)";
  const Outcome o = verified(text, {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  const Json report = Json::parse(o.out);
  bool refuted = false;
  for (const Json& each : report["decisions"][0]["obligations"]) {
    if (each["obligation"] != "C" || each["monitor"] != "walls") continue;
    refuted = each["status"] == "refuted";
    const std::string why = each["because"];
    EXPECT_NE(why.find("where inputs ask for it at ("), std::string::npos) << why;
  }
  EXPECT_TRUE(refuted) << o.out;
}

// Where a landing ends the robot rests, and is as slow as is asked; unless it would be too fast
// again before the next decision.
TEST_F(Told, WhereALandingEndsControlIsGivenBackToWhoWasTooFast) {
  const auto drone = [](const std::string& limit) {
    return R"(spec lands;
zone area = prism (rectangle (0 m, 0 m) to (60 m, 60 m)) from 0 m to 50 m;
input link : bool max_age 500 ms;
robot Quad {
  body radius 30 cm;
  motion point { speed <= 4 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense position : point3 error 10 cm max_age 50 ms;
  sense velocity : vector3 error 10 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller down : safe for Quad = land to 1.5 m speed 0.3 m/s;
controller back : safe for Quad = retreat within area speed 1 m/s;
monitor radio for d : Quad { "R1: slow without a link" always )" +
           limit + R"(; ahead 100 ms; recover down; }
monitor walls for d : Quad { "R2: in the area" always d inside area; ahead 100 ms; recover back; }
decision fly for Quad { advanced policy; period 50 ms; priority radio > walls; }
)";
  };
  expect_proved(drone("link or d.speed <= 1.5 m/s"));
  const Outcome o = verified(drone("d.speed <= 0.6 m/s"), {"--format", "json"});
  EXPECT_NE(statuses(o.out, "P2b", "radio"), Statuses{"proved"}) << o.out;
}

// By night it is home, from wherever that finds it; straight across the pond of a fence that ranks
// lower, which no run shows. What no input asks for does not.
TEST_F(Told, AWayHomeThatInputsAskForAcrossWhatIsKeptOffIsRefuted) {
  const auto horseshoe = [](const std::string& home) {
    return R"(spec horseshoe;
input night, calm : bool max_age 1 s;
zone yard = rectangle (0 m, 0 m) to (20 m, 20 m) - rectangle (6 m, 6 m) to (14 m, 20 m);
zone tip = rectangle (0 m, 14 m) to (6 m, 20 m);
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet one : Cart;
controller pilot : advanced for Cart extern;
controller home : safe for Cart = retreat within tip speed 0.3 m/s;
controller back : safe for Cart = retreat within yard speed 0.3 m/s;
monitor sleep for c : Cart { "R1: home by night" always )" +
           home + R"(; recover home; }
monitor fence for c : Cart { "R2: in the yard" always c inside yard; recover back; }
decision guard for Cart { advanced pilot; period 50 ms; priority sleep > fence; }
)";
  };
  const auto of_fence = [&](const std::string& home) {
    return statuses(verified(horseshoe(home), {"--format", "json"}).out, "C", "fence");
  };
  EXPECT_EQ(of_fence("night implies c inside tip"), Statuses{"refuted"});
  EXPECT_EQ(of_fence("c inside tip or not (night and not night)"), Statuses{"unknown"});
  EXPECT_EQ(of_fence("c inside tip or calm or night"), Statuses{"unknown"});
}

// Over a ledge: it is told to land, is led back from above what it would hit, and told to land
// again. Nobody leads it anywhere where the ground below is as wide.
TEST_F(Told, WhatInputsAskForAndAnotherOneLeadsBackFromGoesOnForAsLong) {
  const auto air = [](const std::string& below, const std::string& clauses = "") {
    return R"(spec ledge;
zone air = prism (rectangle (0 m, 0 m) to (40 m, 40 m)) from 4 m to 30 m | prism (rectangle )" +
           below + R"() from 0 m to 4 m;
input wind : real [m/s] in 0 .. 40 m/s error 1 m/s max_age 1 s;
robot Quad {
  body radius 40 cm;
  motion point { speed <= 3 m/s; accel <= 2.5 m/s^2; brake >= 2.5 m/s^2; }
  sense position : point3 error 8 cm max_age 50 ms;
  sense velocity : vector3 error 8 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller down : safe for Quad = land to 1.5 m speed 0.6 m/s;
controller back : safe for Quad = retreat within air speed 0.6 m/s;
monitor walls for d : Quad { "R1: in the air" always d inside air; recover back; }
monitor storm for d : Quad { "R2: lands in a storm" always wind <= 12 m/s; recover down; }
decision fly for Quad { advanced policy; period 50 ms; priority walls > storm; )" +
           clauses + " }\n";
  };
  const auto switching = [](const std::string& text) {
    const Outcome o = verified(text, {"--format", "json"});
    return std::pair(statuses(o.out, "switching", ""), o.out);
  };
  const auto [turns, why] = switching(air("(10 m, 10 m) to (30 m, 30 m)"));
  EXPECT_EQ(turns, Statuses{"unknown"}) << why;
  EXPECT_NE(why.find("as long as inputs ask for `down`, it and `back` may take over"),
            std::string::npos)
      << why;
  EXPECT_EQ(switching(air("(0 m, 0 m) to (40 m, 40 m)")).first, Statuses{"proved"});
  EXPECT_NE(switching(air("(10 m, 10 m) to (30 m, 30 m)",
                          "acknowledge down may break walls \"the net\";"))
                .first,
            Statuses{"unknown"});
}

// Inputs say when a place counts: where the other recovery leads it holds whatever they say, so
// that neither takes over from the other for ever. Where that need not be it is not known to end.
TEST_F(Told, APlaceThatInputsAskForIsSettledWhereTheOtherRecoveryLeads) {
  const auto page = [](const std::string& property, const std::string& leads) {
    return R"(spec works;
zone hall = rectangle (0 m, 0 m) to (12 m, 9 m);
zone pit = rectangle (8 m, 5 m) to (9 m, 6 m);
zone free = hall - grow(pit, 30 cm);
zone east = rectangle (7 m, 0 m) to (12 m, 4 m);
input alarm : bool max_age 200 ms;
input load : real [kg] in 0 .. 50 kg error 0.5 kg max_age 1 s;
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet c : Cart;
controller policy : advanced for Cart extern;
controller back : safe for Cart = retreat within free speed 0.3 m/s;
controller away : safe for Cart = )" +
           leads + R"( within free speed 0.25 m/s;
monitor walls for r : Cart { "R1: in the hall, off the pit" always r inside free; recover back; }
monitor told for r : Cart { "R2: as it is told" always )" +
           property + R"(; recover away; }
decision drive for Cart { advanced policy; period 50 ms; priority walls > told; }
)";
  };
  for (const char* property :
       {"alarm implies distance(r, pit) >= 20 cm", "distance(r, pit) >= 20 cm or load <= 10 kg",
        "(alarm or load >= 30 kg) implies distance(r, pit) >= 15 cm and r.speed <= 0.6 m/s",
        "not alarm and distance(r, pit) >= 20 cm"}) {
    expect_proved(page(property, "retreat"));
  }
  expect_proved(page("alarm implies distance(r, pit) >= 20 cm", "loiter"));
  const Outcome o = verified(page("alarm implies r inside east", "retreat"), {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "C", "told").front(), "unknown") << o.out;
}

// What inputs alone have fail somewhere else than its recovery may stay is asked for without end,
// in whatever form that is written.
TEST_F(Told, WhatFailsByInputsIsAskedForWithoutEnd) {
  const auto page = [](const std::string& property, const std::string& far) {
    return R"(spec halls;
zone west = rectangle (0 m, 0 m) to (10 m, 14 m);
zone east = rectangle ()" +
           far + R"( m, 0 m) to (24 m, 14 m);
input alarm, calm : bool max_age 200 ms;
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet c : Cart;
controller policy : advanced for Cart extern;
controller back : safe for Cart = retreat within west speed 0.3 m/s;
controller away : safe for Cart = retreat within east speed 0.3 m/s;
monitor walls for r : Cart { "R1: in the west" always r inside west; recover back; }
monitor told for r : Cart { "R2: as it is told" always )" +
           property + R"(; recover away; }
decision drive for Cart { advanced policy; period 50 ms; priority walls > told; }
)";
  };
  for (const char* property :
       {"alarm or (calm and r.speed <= 0.9 m/s)", "alarm implies (calm and r.speed <= 0.9 m/s)",
        "if alarm then false else r.speed <= 0.9 m/s", "not alarm and r.speed <= 0.9 m/s",
        "not (alarm or r.speed > 0.9 m/s)"}) {
    const Outcome o = verified(page(property, "12"), {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(statuses(o.out, "switching", ""), Statuses{"unknown"}) << property << o.out;
    EXPECT_NE(o.out.find("as long as inputs ask for `away`"), std::string::npos) << property;
  }
  // what a limit is enough for does not; who claims the same of the others is denied
  const auto certified = [&](const std::string& property) {
    (void)verified(page(property, "12"), {"-o", "certificates"});
    return Json::parse(read("certificates/verification.json"));
  };
  const auto switching = [](Json& report) -> Json& {
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == "switching") return o;
    }
    throw std::runtime_error("nothing is said of switching");
  };
  for (const char* property :
       {"not alarm and r.speed <= 0.9 m/s", "not (alarm or r.speed > 0.9 m/s)",
        "alarm or (calm and r.speed <= 0.9 m/s)", "if alarm then false else r.speed <= 0.9 m/s"}) {
    Json forged = certified(property);
    Json proved = certified("alarm implies r.speed <= 0.9 m/s");
    ASSERT_EQ(switching(proved)["status"], "proved");
    switching(forged) = switching(proved);
    write("certificates/sources/spec.rta", page(property, "12"));
    write("certificates/verification.json", forged.dump());
    const Outcome denied = recheck_sealed_anew();
    EXPECT_EQ(denied.status, exit_violation) << property;
    EXPECT_NE(denied.out.find("as long as inputs ask for one it leads out of the other"),
              std::string::npos)
        << property << denied.out;
  }
}

// Of inputs that exclude each other one asks for its recovery, and then the other property holds:
// no way of it leads out of that while they stay, and who knows what comes when they change.
TEST_F(Told, WhatAnInputAsksForIsNotHeldAgainstWhatItAllowsThen) {
  const std::string text = R"(spec shifts;
input night : bool max_age 1 s;
zone east = rectangle (14 m, 0 m) to (24 m, 14 m);
zone west = rectangle (0 m, 0 m) to (12 m, 14 m);
)" + a_rover + R"(controller go_east : safe for Rover = retreat within east speed 0.4 m/s;
controller go_west : safe for Rover = retreat within west speed 0.4 m/s;
monitor nights for r : Rover { "R1: east at night" always night implies r inside east; recover go_east; }
monitor days for r : Rover { "R2: west by day" always )";
  const std::string end = R"(; recover go_west; }
decision go for Rover { advanced drive; period 100 ms; priority nights > days; }
)";
  const Outcome o = verified(text + "not night implies r inside west" + end, {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "C", "days").front(), "unknown") << o.out;
  // whatever it says
  const Outcome always = verified(text + "r inside west" + end, {"--format", "json"});
  EXPECT_EQ(statuses(always.out, "C", "days").front(), "refuted") << always.out;
}

// A landing that ends too low for where it is led back in: the least height that is high enough is
// said, and is.
TEST_F(Told, TheHeightToLandAtIsSaid) {
  const auto flight = [](const std::string& height) {
    return R"(spec low;
zone air = prism (rectangle (0 m, 0 m) to (40 m, 40 m)) from 1 m to 30 m;
input lost : bool max_age 500 ms;
robot Quad {
  body radius 40 cm;
  motion point { speed <= 3 m/s; accel <= 2.5 m/s^2; brake >= 2.5 m/s^2; }
  sense position : point3 error 8 cm max_age 50 ms;
  sense velocity : vector3 error 8 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller down : safe for Quad = land to )" +
           height + R"( speed 0.5 m/s;
controller back : safe for Quad = retreat within air speed 0.6 m/s;
monitor walls for d : Quad { "R1: in the air" always clearance(d, air) >= 30 cm; recover back; }
monitor link for d : Quad { "R2: it sinks without a link" always not lost; recover down; }
decision fly for Quad { advanced policy; period 50 ms; priority walls > link; }
)";
  };
  const Outcome low = verified(flight("1.9 m"), {"--format", "json"});
  EXPECT_EQ(statuses(low.out, "switching", ""), Statuses{"unknown"}) << low.out;
  const std::string works = "m` in `down` works", to = "`land to ";
  const std::size_t end = low.out.find(works), from = low.out.rfind(to, end) + to.size();
  ASSERT_NE(end, std::string::npos) << low.out;
  const std::string metres = low.out.substr(from, end - from);
  expect_proved(flight(metres + "m"));
  const std::string less = std::to_string(std::stod(metres) - 0.001) + " m";
  const Outcome lower = verified(flight(less), {"--format", "json"});
  EXPECT_EQ(statuses(lower.out, "switching", ""), Statuses{"unknown"}) << lower.out;
}

// Slow enough for either limit, in whatever order.
TEST_F(Told, EitherSideOfAChoiceIsKeptByARecoveryThatIsSlowEnough) {
  expect_proved(yard_with(by_load, "0.4 m/s", "fence > told"));
  expect_proved(yard_with(by_load, "0.4 m/s", "told > fence"));
  const Outcome o = verified(yard_with(by_load, "0.41 m/s", "fence > told"));
  EXPECT_EQ(o.status, exit_violation) << o.out;
}

// A limit that a robot at rest does not exceed gives control back to a recovery that is faster, and
// so on for ever: no rank mends that, though none of them has to break it.
TEST_F(Told, ALimitThatLetsGoIsKeptByEverybody) {
  const std::string lets_go = "estop implies r.speed <= 0.85 m/s";
  const Outcome o = verified(yard_with(lets_go, "0.9 m/s", "told > fence"));
  EXPECT_EQ(o.status, exit_inconclusive) << o.out;
  EXPECT_NE(o.err.find("error[5033]"), std::string::npos) << o.err;
  expect_proved(yard_with(lets_go, "0.85 m/s", "told > fence"));
}

// What is told is the same on both sides of a choice: a limit that no robot exceeds, whatever it is
// told, is never false, and one that it may exceed on either side is not.
TEST_F(Told, AChoiceCanFailWhereOneOfItsSidesCan) {
  const auto checked = [](const std::string& property) {
    write("spec.rta", yard_with(property, "0.3 m/s", "told > fence"));
    return rtac({"check", "spec.rta"});
  };
  const std::string never = "warning[7004]: the monitor `told` is never false";
  for (const std::string condition : {"estop", "not estop"}) {
    const Outcome o = checked("if " + condition + " then r.speed <= 4 m/s else r.speed <= 5 m/s");
    EXPECT_NE(o.err.find(never), std::string::npos) << condition << o.err;
    for (const std::string sides :
         {"r.speed <= 0.4 m/s else r.speed <= 5 m/s", "r.speed <= 4 m/s else r.speed <= 0.4 m/s"}) {
      const Outcome one = checked("if " + condition + " then " + sides);
      EXPECT_EQ(one.status, exit_clean) << one.err;
      EXPECT_EQ(one.err.find("7004"), std::string::npos) << condition << sides << one.err;
    }
  }
  expect_proved(yard_with("if estop then r.speed <= 0.4 m/s else true", "0.3 m/s", "told > fence"));
}

// Nothing of what it may be told gives control back: not proved, and not taken for a proof.
TEST_F(Told, WhatNoInputLetsGoIsNotProved) {
  const Outcome o =
      verified(yard_with("(estop and r.speed <= 0.05 m/s) or (not estop and r.speed <= 0.06 m/s)",
                         "0.3 m/s", "told > fence"));
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_NE(o.err.find("can never hand control back"), std::string::npos) << o.err;
}

// One that is not built in is as fast as it claims to be.
TEST_F(Told, AnExternalRecoveryIsAsSlowAsItClaims) {
  const auto outside = [](const std::string& speed) {
    const std::string text = yard_with(by_load, "0.4 m/s", "told > fence");
    const std::string claimed = edited(text, "= retreat within yard speed 0.4 m/s",
                                       "extern keeps inside yard speed <= " + speed);
    return edited(claimed, "recover back;", "recover back; hold when violated \"staff\";");
  };
  expect_proved(outside("0.4 m/s"));
  expect_proved(edited(outside("0.3 m/s"), by_load, halts));
}

}  // namespace
}  // namespace rtac::driver::test
