// What `rtac sim` plays of inputs, their past, and the time of day: what nobody controls in a run.
#include "tests/compiler/driver/sim_testing.h"

namespace rtac::driver::test {
namespace {

// Drawn by the seed, or as the scenario says; a run that is played again is told the same.
TEST_F(Simulations, InputsAreDrawnForEachRun) {
  const std::string inputs =
      "enum Mode { easy, careful }\n"
      "input open : bool max_age inf;\n"
      "input mode : Mode max_age 1 s;\n"
      "input load : real [kg] in 0 .. 9 kg error 100 g max_age 1 s;\n"
      "zone yard";
  write("told.rta", edited(with_pillar("r inside yard and (not open and mode == careful and load > "
                                       "4 kg implies r inside free)"),
                           "zone yard", inputs));
  const Outcome sound = rtac({"sim", "told.rta", "--runs", "20"});
  EXPECT_EQ(sound.status, 0) << sound.out << sound.err;
  write("said.json", R"({"inputs": {"open": false, "mode": "careful", "load": 5}})");
  const Outcome careful = rtac({"sim", "told.rta", "--runs", "4", "--adversary", "aimed-noise",
                                "--mutate", "no-stopping-distance", "--scenario", "said.json"});
  EXPECT_EQ(careful.status, 3) << careful.out << careful.err;
  EXPECT_NE(careful.out.find("with open = false, mode = careful, load = 5\n"), std::string::npos)
      << careful.out;
  const Outcome again = rtac(
      {"sim", "told.rta", "--mutate", "no-stopping-distance", "--replay", "yard_patrol.trace"});
  EXPECT_EQ(again.status, 3) << again.out << again.err;
}

// What would make a property false wherever robots are is no attack on anybody.
TEST_F(Simulations, InputsAreDrawnSoThatPropertiesCanHold) {
  write("told.rta",
        edited(yard("50 ms", "r inside yard and permit and not load > 2 kg"), "zone yard",
               "input permit : bool max_age inf;\n"
               "input load : real [kg] in 0 .. 9 kg;\nzone yard"));
  const Outcome o = rtac({"sim", "told.rta", "--runs", "24"});
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  write("said.json", R"({"inputs": {"permit": false}})");
  const Outcome never = rtac({"sim", "told.rta", "--runs", "1", "--scenario", "said.json"});
  EXPECT_EQ(never.status, 4) << never.out;
  EXPECT_NE(never.err.find("permit = false"), std::string::npos) << never.err;
  // no other input makes up for it, and to say what it is again is no way out
  EXPECT_NE(never.err.find("with the inputs of the scenario no place is left where `fence`"),
            std::string::npos)
      << never.err;
  EXPECT_EQ(never.err.find("a scenario says what they are"), std::string::npos) << never.err;
}

// A recovery that engages for inputs alone drives all the time where they are such: its monitor is
// none that robots break.
TEST_F(Simulations, AMonitorOfInputsAloneMayBeUnmet) {
  std::string text = edited(yard("50 ms", "r inside yard"), "zone yard",
                            "input permit : bool max_age inf;\nzone yard");
  text = edited(text, "decision",
                "monitor allowed for r : Rover { \"R2: with a permit\" always permit; recover "
                "turn_back; }\ndecision");
  write("told.rta", edited(text, "priority fence", "priority allowed > fence"));
  for (const std::string scenario :
       {R"({"unmet": "allowed", "runs": 12})", R"({"inputs": {"permit": false}, "runs": 12})"}) {
    write("said.json", scenario);
    const Outcome o = rtac({"sim", "told.rta", "--scenario", "said.json"});
    EXPECT_EQ(o.status, 0) << o.out << o.err;
    EXPECT_NE(o.out.find("advanced controller: 0.0 % of the time"), std::string::npos) << o.out;
  }
  write("said.json", R"({"unmet": "fence"})");
  const Outcome place = rtac({"sim", "told.rta", "--scenario", "said.json"});
  EXPECT_EQ(place.status, 4) << place.out;
  EXPECT_NE(place.err.find("a monitor of inputs alone works"), std::string::npos) << place.err;
  const Outcome drawn = rtac({"sim", "told.rta", "--runs", "12"});
  EXPECT_EQ(drawn.out.find("advanced controller: 0.0 %"), std::string::npos) << drawn.out;
}

TEST_F(Simulations, RecordedInputsHaveToBePossible) {
  write("told.rta", edited(yard("50 ms", "r inside yard and (steps <= 3 implies r inside yard)"),
                           "zone yard", "input steps : int in 0 .. 10;\nzone yard"));
  ASSERT_EQ(rtac({"sim", "told.rta", "--runs", "8", "--adversary", "aimed-noise", "--mutate",
                  "no-stopping-distance", "--trace", "out.trace"})
                .status,
            3);
  const std::string trace = read("out.trace");
  const std::size_t at = trace.find("\ninputs ") + 1, end = trace.find('\n', at);
  for (const std::string line : {"inputs 0x1.8p+0 0x1.8p+0", "inputs 0x1p+0 0x1p+1",
                                 "inputs 0x1p+4 0x1p+4", "inputs 0x1p+0", "inputs"}) {
    write("other.trace", trace.substr(0, at) + line + trace.substr(end));
    const Outcome o =
        rtac({"sim", "told.rta", "--mutate", "no-stopping-distance", "--replay", "other.trace"});
    EXPECT_EQ(o.status, 2) << line << o.out;
  }
}

TEST_F(Simulations, WhatScenariosSayOfInputsIsChecked) {
  write("told.rta",
        edited(yard("50 ms", "r inside yard or open or steps > 3 or load > 1 kg"), "zone yard",
               "input open : bool max_age inf;\ninput steps : int in 0 .. 10;\n"
               "input load : real [kg];\nzone yard"));
  const auto refused = [&](const std::string& inputs) {
    write("said.json", R"({"inputs": )" + inputs + "}");
    const Outcome o = rtac({"sim", "told.rta", "--runs", "1", "--scenario", "said.json"});
    EXPECT_EQ(o.status, 2) << inputs << o.out;
    return o.err;
  };
  EXPECT_NE(refused(R"({"open": 1})").find("`true` and `false` work"), std::string::npos);
  EXPECT_NE(refused(R"({"open": [true, true]})").find("2 values of `open`"), std::string::npos);
  EXPECT_NE(refused(R"({"steps": 2.5})").find("a whole number from 0 to 10"), std::string::npos);
  EXPECT_NE(refused(R"({"load": 1e999})").find("a number that is none"), std::string::npos);
  write("heavy.json", R"({"inputs": {"load": 250}, "duration_s": 1})");
  EXPECT_EQ(rtac({"sim", "told.rta", "--runs", "1", "--scenario", "heavy.json"}).status, 0);
  EXPECT_NE(refused(R"({"shut": true})").find("no decision speaks"), std::string::npos);
  EXPECT_NE(refused(R"({"open": null})").find("a number in SI units"), std::string::npos);
}

// A zone that robots have to be out of when it comes. A recovery that only stops does not lead out.
std::string lessons(const std::string& recover) {
  const bool stops = recover == "halt";
  const std::string recovers =
      "recover " + recover + ";" + (stops ? " hold when violated \"why\";" : "");
  std::string text =
      edited(yard("50 ms", "distance(r, school) >= 30 cm"), "zone yard",
             "clock utc;\nzone school = rectangle (5 m, 0 m) to (8 m, 8 m) during monday, friday "
             "07:30 .. 16:00;\nsite home = (2 m, 2 m);\nzone yard");
  text = edited(edited(text, "r1, r2 :", "r1 :"), "recover turn_back;", recovers);
  text = edited(text, "monitor",
                "controller halt : safe for Rover = brake_and_hold;\n"
                "controller go_home : safe for Rover = route to home within yard speed 0.5 m/s;\n"
                "monitor walls for r : Rover { \"R2: it stays in\" always r inside yard; "
                "ahead 50 ms; " +
                    recovers + " }\nmonitor");
  return edited(text, "priority fence;",
                "priority fence > walls;" +
                    std::string(stops ? " acknowledge halt may break fence \"why\";" : ""));
}

// Runs have a time of day, around the moments at which zones come and go.
TEST_F(Simulations, ZonesWithTimesComeAndGo) {
  write("hours.rta", lessons("halt"));
  const Outcome o = rtac({"sim", "hours.rta", "--runs", "40"});
  EXPECT_EQ(o.status, 3) << o.out << o.err;
  EXPECT_NE(o.out.find("violated: fence (distance"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find("T07:30:0"), std::string::npos) << o.out;
  const Outcome again = rtac({"sim", "hours.rta", "--replay", "yard_patrol.trace"});
  EXPECT_EQ(again.status, 3) << again.out << again.err;
  EXPECT_NE(again.out.find("the same to the last bit"), std::string::npos) << again.out;
  // who leads out in time keeps it, unless nobody looks so far ahead
  write("out.rta", lessons("go_home"));
  const Outcome kept = rtac({"sim", "out.rta", "--runs", "40"});
  EXPECT_EQ(kept.status, 0) << kept.out << kept.err;
  EXPECT_EQ(rtac({"sim", "out.rta", "--runs", "40", "--mutate", "no-lead"}).status, 3);
}

TEST_F(Simulations, AScenarioSaysWhenItBegins) {
  write("hours.rta", lessons("halt"));
  write("noon.json", R"({"begins": "2026-01-09T12:00:00Z", "starts": {"r1": {"at": [6, 4]}}})");
  const Outcome noon = rtac({"sim", "hours.rta", "--scenario", "noon.json", "--runs", "1"});
  EXPECT_EQ(noon.status, 3) << noon.out << noon.err;
  EXPECT_NE(noon.out.find("at 0 s, 2026-01-09T12:00:00Z"), std::string::npos) << noon.out;
  write("eve.json", R"({"begins": "2026-01-09T18:00:00Z", "starts": {"r1": {"at": [6, 4]}}})");
  const Outcome eve = rtac({"sim", "hours.rta", "--scenario", "eve.json", "--runs", "8"});
  EXPECT_EQ(eve.status, 0) << eve.out << eve.err;
  write("short.json", R"({"begins": "2026-01-09T12:00Z", "starts": {"r1": {"at": [6, 4]}}})");
  EXPECT_EQ(rtac({"sim", "hours.rta", "--scenario", "short.json", "--runs", "1"}).status, 3);
  write("plain.rta", yard("50 ms"));
  const Outcome plain = rtac({"sim", "plain.rta", "--scenario", "eve.json"});
  EXPECT_EQ(plain.status, 2) << plain.out;
  EXPECT_NE(plain.err.find("no monitor speaks of a zone with times"), std::string::npos);
  write("number.json", R"({"begins": 17})");
  EXPECT_NE(rtac({"sim", "hours.rta", "--scenario", "number.json"}).err.find("a moment works"),
            std::string::npos);
  write("never.json", R"({"begins": "2026-02-30T18:00:00Z"})");
  const Outcome never = rtac({"sim", "hours.rta", "--scenario", "never.json"});
  EXPECT_EQ(never.status, 2) << never.out;
  EXPECT_NE(never.err.find("a moment works"), std::string::npos) << never.err;
}

// Inputs have always been what they are: the past of them is known before a run begins.
TEST_F(Simulations, ThePastOfInputsIsAsTheyAre) {
  write("told.rta", edited(yard("50 ms",
                                "r inside yard and (once[1 s, 2 s] open implies "
                                "r.speed <= 0.7 m/s)"),
                           "zone yard", "input open : bool;\nzone yard"));
  const auto most_mps = [&](const char* open) {
    write("said.json", std::string(R"({"inputs": {"open": )") + open + "}}");
    const Outcome o = rtac({"sim", "told.rta", "--runs", "24", "--scenario", "said.json"});
    EXPECT_EQ(o.status, 0) << o.out << o.err;
    return least_m(o.out, "fence");
  };
  EXPECT_LT(most_mps("true"), 0.05);  // in m/s: nearly as fast as it may be
  EXPECT_GT(most_mps("false"), 0.05);
}

// Numbers that are made of inputs are what those make them.
TEST_F(Simulations, NumbersAreMadeOfInputs) {
  std::string text = edited(yard("50 ms", "r inside yard"), "zone yard",
                            "enum Mode { gentle, keen }\ninput open : bool;\n"
                            "input is, was : Mode;\ninput lean : vector [deg] in -9 .. 9 deg;\n"
                            "input load : real [kg] in -5 .. 5 kg;\nzone yard");
  text = edited(text, "decision",
                "monitor fit for r : Rover { \"R2: it is fit\" always abs(load) <= 3 kg and "
                "norm(lean) <= 8 deg and max(load, 1 kg) <= (if open then 2 kg else 4 kg) and "
                "sqrt(load * load) <= 3 kg and min(load, 0 kg) >= -2 kg and is == was; ahead 50 "
                "ms; recover turn_back; }\n"
                "decision");
  write("told.rta", edited(text, "priority fence", "priority fit > fence"));
  const auto advanced = [&](const std::string& inputs) {
    write("said.json", R"({"runs": 2, "duration_s": 4, "inputs": )" + inputs + "}");
    const Outcome o = rtac({"sim", "told.rta", "--scenario", "said.json"});
    EXPECT_EQ(o.status, 0) << o.out << o.err;
    return o.out.find("advanced controller: 0.0 %") == std::string::npos;
  };
  const std::string fit = R"("is": "keen", "was": "keen", "lean": [0.01, 0.02])";
  EXPECT_TRUE(advanced(R"({"open": false, "load": 2.5, )" + fit + "}"));
  EXPECT_FALSE(advanced(R"({"open": true, "load": 2.5, )" + fit + "}"));
  EXPECT_FALSE(advanced(R"({"open": false, "load": -2.5, )" + fit + "}"));
  EXPECT_FALSE(advanced(R"({"open": true, "load": 1, "is": "keen", "was": "gentle"})"));
  EXPECT_FALSE(
      advanced(R"({"open": true, "load": 1, "is": "keen", "was": "keen", "lean": [0.14, -0.14]})"));
  EXPECT_TRUE(advanced("{}"));
}

// What inputs decide has no margin: one that is on its limit hides nothing of what robots do, and a
// condition and its opposite do not hold at once.
TEST_F(Simulations, AnInputOnItsLimitHidesNothing) {
  const auto ran = [&](const std::string& always, const char* scenario, const char* mutant) {
    write("told.rta",
          edited(yard("50 ms", always), "zone yard", "input n, x : int in 0 .. 9;\nzone yard"));
    write("said.json", scenario);
    std::vector<std::string> words{"sim", "told.rta", "--scenario", "said.json"};
    if (*mutant != '\0') words.insert(words.end(), {"--mutate", mutant});
    return rtac(words);
  };
  const std::string slow = "r inside yard and (n >= 5 implies r.speed <= 0.5 m/s)";
  for (const char* const n : {"5", "6"}) {
    const std::string scenario = std::string(R"({"runs": 8, "inputs": {"n": )") + n + "}}";
    EXPECT_EQ(ran(slow, scenario.c_str(), "no-acceleration").status, 3) << n;
  }
  EXPECT_EQ(ran("r inside yard and (n > 5 or r.speed <= 0.5 m/s)",
                R"({"runs": 8, "inputs": {"n": 5}})", "no-acceleration")
                .status,
            3);
  const Outcome o =
      ran("r inside yard and (x <= (if not (n >= 5) then 1 else 3) or r.speed <= 0.5 m/s)",
          R"({"runs": 8, "inputs": {"n": 5, "x": 2}})", "");
  EXPECT_EQ(o.status, 0) << o.out << o.err;
}

// Who starts knows what was so, its charge is drawn by that, and so does what decides when control
// comes back.
TEST_F(Simulations, StartsAndReturnsKnowThePast) {
  const auto permitted = [&](const std::string& always, const std::string& ending) {
    const std::string text = edited(yard("50 ms", "r inside yard and (" + always + ")"),
                                    "zone yard", "input permit : bool;\nzone yard");
    write("told.rta", edited(text, "recover turn_back;", "recover turn_back; " + ending));
    write("said.json", R"({"inputs": {"permit": true}, "runs": 8, "return_within_s": 25,
                           "starts": "tight", "adversary": "bang-bang"})");
    return rtac({"sim", "told.rta", "--scenario", "said.json"});
  };
  const Outcome returns =
      permitted("permit or not permit", "return when once[10 min, 20 min] permit;");
  EXPECT_EQ(returns.status, 0) << returns.out << returns.err;
  const std::string plain = permitted("permit", "").out,
                    held = permitted("permit for 1 min", "").out;
  EXPECT_NE(plain.find("advanced controller: "), std::string::npos) << plain;
  EXPECT_NE(held.find("advanced controller: "), std::string::npos) << held;
  const std::string far = permitted("once[24 h, 25 h] permit", "").err;
  EXPECT_NE(far.find("error[9008]"), std::string::npos) << far;
  EXPECT_NE(far.find("looks back over 1728000 ticks"), std::string::npos) << far;
}

// Of many inputs hardly any draw is right in all of them.
TEST_F(Simulations, ManyInputsAreDrawnSoThatAllIsWell) {
  std::string names = "input level : real [m] in 0 .. 10 m;\n", all = "r inside yard";
  for (int k = 0; k < 14; ++k) {
    const std::string name = "switch" + std::to_string(k);
    names += "input " + name + " : bool;\n";
    all += k % 2 == 0 ? " and " + name : " and not " + name;
  }
  write("told.rta",
        edited(yard("50 ms", all + " and level >= 9.99 m"), "zone yard", names + "zone yard"));
  const Outcome o = rtac({"sim", "told.rta", "--runs", "4"});
  EXPECT_EQ(o.status, 0) << o.out << o.err;
}

}  // namespace
}  // namespace rtac::driver::test
