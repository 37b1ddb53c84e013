// `rtac sim` as scripts see it: what is violated, with which exit code, and the same run again.
#include <cstdio>

#include "compiler/diagnostics/engine.h"
#include "tests/compiler/driver/sim_testing.h"

namespace rtac::driver::test {
namespace {

const std::string blind = R"(1 waypoint, waypoints only unsound "for the test")";

TEST_F(Simulations, ASoundSpecificationSurvivesEveryAdversary) {
  write("spec.rta", yard("50 ms"));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "21"});
  EXPECT_EQ(o.status, 0) << o.err;
  for (const char* name :
       {"bang-bang", "chase-fence", "aimed-noise", "fresh-samples", "turn_back"}) {
    EXPECT_NE(o.out.find(name), std::string::npos) << o.out;
  }
  // Nothing stops a robot that coasts and does not see it.
  EXPECT_EQ(o.out.find("drop-outs"), std::string::npos) << o.out;
  // The property speaks of no other robot and of no charge.
  EXPECT_EQ(o.out.find("chase-robot"), std::string::npos) << o.out;
  EXPECT_EQ(o.out.find("drain"), std::string::npos) << o.out;
  EXPECT_FALSE(fs::exists("yard_patrol.trace"));
}

// A robot that has nothing to attack would stand, which looks like a specification that survives.
TEST_F(Simulations, AnAdversaryWithNothingToAimAtIsRefused) {
  write("spec.rta", yard("50 ms"));
  for (const std::string name : {"chase-robot", "drain"}) {
    const Outcome o = rtac({"sim", "spec.rta", "--runs", "2", "--adversary", name});
    EXPECT_EQ(o.status, exit_usage) << o.out << o.err;
    EXPECT_NE(o.err.find("`" + name + "` has nothing to aim at"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("`bang-bang`, `chase-fence`"), std::string::npos) << o.err;
  }
  write("drain.json", R"({"runs": 2, "adversary": {"r1": "drain"}})");
  const Outcome one = rtac({"sim", "spec.rta", "--scenario", "drain.json"});
  EXPECT_EQ(one.status, exit_usage) << one.out << one.err;
  EXPECT_NE(one.err.find("no property of `r1` speaks of that"), std::string::npos) << one.err;
}

TEST_F(Simulations, AnUnsoundOneIsViolatedWithARunThatIsPlayedAgain) {
  write("spec.rta", yard(blind));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "3", "--adversary", "chase-fence"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_NE(o.out.find("violated: fence (r inside yard) by r"), std::string::npos) << o.out;
  ASSERT_TRUE(fs::exists("yard_patrol.trace"));
  for (const std::string again : {"again.trace", "once_more.trace"}) {
    const Outcome r = rtac({"sim", "spec.rta", "--replay", "yard_patrol.trace", "--trace", again});
    EXPECT_EQ(r.status, 3) << r.err;
    EXPECT_NE(r.out.find("the same to the last bit"), std::string::npos) << r.out;
    EXPECT_EQ(read(again), read("yard_patrol.trace"));
  }
}

// What is heard has heights, which a run has to keep.
TEST_F(Simulations, APairInSpaceIsPlayedAgain) {
  write("spec.rta", spec_text("tests/campaign/specs/starlings.rta"));
  const std::string starts = R"({"starts": {"s1": {"at": [0, 0, 0]}, "s2": {"at": [0, 0, 9]}}})";
  write("above.json", starts);
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "3", "--scenario", "above.json", "--mutate",
                          "others-stand", "--trace", "run.trace"});
  ASSERT_EQ(o.status, 3) << o.out << o.err;
  const Outcome r = rtac({"sim", "spec.rta", "--replay", "run.trace", "--mutate", "others-stand"});
  EXPECT_EQ(r.status, 3) << r.out << r.err;
  // without the height of one message it is another run
  const std::string run = read("run.trace");
  const std::size_t said = run.find("\nannounce 1 ", run.size() / 4);
  ASSERT_NE(said, std::string::npos);
  const std::size_t end = run.find('\n', said + 1), climb = run.rfind(' ', end - 1);
  const std::size_t height = run.rfind(' ', climb - 1);
  write("edited.trace", std::string(run).replace(height, climb - height, " 0x1p+3"));
  const Outcome e =
      rtac({"sim", "spec.rta", "--replay", "edited.trace", "--mutate", "others-stand"});
  EXPECT_EQ(e.status, 4) << e.out << e.err;
}

// No monitor names a zone, and no recovery moves within one.
TEST_F(Simulations, ALandingNeedsNoZone) {
  std::string text = spec_text("tests/campaign/specs/templates/land_space.rta");
  const auto edit = [&](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos);
    text.replace(text.find(from), from.size(), to);
  };
  edit("r inside field and ", "");
  edit("  hold when violated \"what is left of a flight is a landing\";\n", "");
  const std::string shared = spec_text("tests/campaign/specs/templates/space.rta");
  write("space.rta", shared.substr(shared.find("robot Flyer")));
  text.erase(text.find("zone field"), text.find("fleet m1") - text.find("zone field"));
  write("spec.rta", text);
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "20"});
  EXPECT_EQ(o.status, 0) << o.out << o.err;
}

TEST_F(Simulations, AnEditedRunIsAnotherOne) {
  write("spec.rta", yard(blind));
  ASSERT_EQ(rtac({"sim", "spec.rta", "--runs", "1", "--trace", "run.trace"}).status, 3);
  const std::string run = read("run.trace");
  const std::size_t command = run.find("\ncommand 0 ", run.size() / 4);
  ASSERT_NE(command, std::string::npos);
  write("edited.trace", std::string(run).replace(command, 11, "\ncommand 0 0x1p-3 "));
  const Outcome o = rtac({"sim", "spec.rta", "--replay", "edited.trace"});
  EXPECT_EQ(o.status, 4);
  const auto line = count(run.substr(0, command + 1), "\n") + 1;
  EXPECT_NE(o.err.find("from line " + std::to_string(line)), std::string::npos) << line << o.err;
}

// A line is another robot's, or speaks of a robot that is not there; a number that nobody looks at.
TEST_F(Simulations, WhatDoesNotFitIsFoundWithItsLine) {
  write("spec.rta", yard(blind));
  ASSERT_EQ(rtac({"sim", "spec.rta", "--runs", "1", "--trace", "run.trace"}).status, 3);
  const std::string run = read("run.trace");
  for (const std::string word : {"sense", "command", "announce", "decide", "truth", "hear"}) {
    const std::size_t line = run.find("\n" + word + " 0 ", run.size() / 4) + 1;
    ASSERT_NE(line, std::string::npos + 1) << word;
    const auto number = count(run.substr(0, line), "\n") + 1;
    for (const std::string robot : {"5", "-1", "1"}) {
      write("edited.trace", std::string(run).replace(line + word.size() + 1, 1, robot));
      const Outcome o = rtac({"sim", "spec.rta", "--replay", "edited.trace"});
      EXPECT_EQ(o.status, 4) << word << robot << o.out;
      EXPECT_NE(o.err.find("from line " + std::to_string(number)), std::string::npos)
          << word << robot << number << o.err;
    }
  }
  // The charge of a robot without a battery comes last.
  const std::size_t sense = run.find("\nsense 0 ", run.size() / 4) + 1;
  const std::size_t last = run.rfind(' ', run.find('\n', sense)) + 1;
  std::string unused = run;
  unused.replace(last, run.find('\n', sense) - last, "nan");
  write("edited.trace", unused);
  const Outcome o = rtac({"sim", "spec.rta", "--replay", "edited.trace"});
  EXPECT_EQ(o.status, 4) << o.out;
  EXPECT_NE(o.err.find("the recorded run was changed"), std::string::npos) << o.err;
}

TEST_F(Simulations, ARunWithCarriageReturnsIsTheSame) {
  write("spec.rta", yard(blind));
  ASSERT_EQ(rtac({"sim", "spec.rta", "--runs", "1", "--trace", "run.trace"}).status, 3);
  std::string lines;
  for (const char c : read("run.trace"))
    lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
  write("mailed.trace", lines);
  const Outcome o = rtac({"sim", "spec.rta", "--replay", "mailed.trace"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_NE(o.out.find("the same to the last bit"), std::string::npos) << o.out;
}

TEST_F(Simulations, ARunBelongsToItsSpecification) {
  write("spec.rta", yard(blind));
  ASSERT_EQ(rtac({"sim", "spec.rta", "--runs", "1", "--trace", "run.trace"}).status, 3);
  write("other.rta", edited(yard(blind), "0.3 m/s", "0.2 m/s"));
  const Outcome o = rtac({"sim", "other.rta", "--replay", "run.trace"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("error[9009]"), std::string::npos) << o.err;
}

TEST_F(Simulations, TheSameSeedsAreTheSameRuns) {
  write("spec.rta", yard("50 ms"));
  const Outcome a = rtac({"sim", "spec.rta", "--runs", "8", "--seed", "5"});
  const Outcome b = rtac({"sim", "spec.rta", "--runs", "8", "--seed", "5"});
  const Outcome c = rtac({"sim", "spec.rta", "--runs", "8", "--seed", "6"});
  EXPECT_EQ(steady(a.out), steady(b.out));
  EXPECT_NE(steady(a.out), steady(c.out));
}

// Neither the table, nor which run is the first violation, nor that run depends on who played it.
TEST_F(Simulations, TheNumberOfJobsChangesNothing) {
  write("spec.rta", yard(blind));
  const auto table = [this](const std::string& jobs) {
    const Outcome o =
        rtac({"sim", "spec.rta", "--runs", "40", "--jobs", jobs, "--trace", "run.trace"});
    EXPECT_EQ(o.status, 3) << o.err;
    return steady(o.out) + read("run.trace");
  };
  const std::string one = table("1");
  EXPECT_EQ(table("3"), one);
  EXPECT_EQ(table("64"), one);
}

// The wind of a scenario blows when its run is played again, too.
TEST_F(Simulations, ALastingWindIsPlayedAgain) {
  write("spec.rta",
        edited(yard("50 ms"), "brake >= 1 m/s^2;", "brake >= 1 m/s^2; disturbance <= 0.2 m/s^2;"));
  write("wind.json", R"({"duration_s": 3, "runs": 1, "adversary": "bang-bang", "noise": "lasting",
                        "starts": {"r1": {"at": [-0.2, 4]}, "r2": {"at": [4, 4]}}})");
  const Outcome o = rtac({"sim", "spec.rta", "--scenario", "wind.json", "--trace", "run.trace"});
  ASSERT_EQ(o.status, 3) << o.err;
  EXPECT_NE(read("run.trace").find("\nnoise lasting\n"), std::string::npos);
  const Outcome r = rtac({"sim", "spec.rta", "--replay", "run.trace", "--trace", "again.trace"});
  EXPECT_EQ(r.status, 3) << r.err;
  EXPECT_EQ(read("again.trace"), read("run.trace"));
}

// Starts are taken as they are; the referee sees the first moment.
TEST_F(Simulations, AScenarioSaysWhereRobotsStart) {
  write("spec.rta", yard("50 ms"));
  write("out.json", R"({"duration_s": 1, "runs": 1, "adversary": "bang-bang",
                       "starts": {"r1": {"at": [-1, 4]}, "r2": {"at": [4, 4]}}})");
  const Outcome o = rtac({"sim", "spec.rta", "--scenario", "out.json"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_NE(o.out.find("by r1 at 0 s, down to -1.2"), std::string::npos) << o.out;
  EXPECT_NE(o.out.find(", where the scenario lets it start\n"), std::string::npos) << o.out;
}

// Three numbers are a place in space, and two one of the plane.
TEST_F(Simulations, APlaceHasAsManyNumbersAsItsRobotKnows) {
  const auto refused = [](const std::string& at) {
    write("s.json", R"({"duration_s": 1, "runs": 1, "starts": {")" + at + "}}");
    return rtac({"sim", "spec.rta", "--scenario", "s.json"});
  };
  write("spec.rta", yard("50 ms"));
  const Outcome plane = refused(R"(r1": {"at": [1, 4, 2]})");
  EXPECT_EQ(plane.status, exit_usage) << plane.err;
  EXPECT_NE(plane.err.find("where `r1` starts by three numbers, and it is in the plane"),
            std::string::npos)
      << plane.err;
  const std::string folder = "tests/campaign/specs/templates/";
  write("space.rta", spec_text(folder + "space.rta"));
  write("spec.rta", spec_text(folder + "retreat_space.rta"));
  const Outcome space = refused(R"(m1": {"at": [1, 4]})");
  EXPECT_EQ(space.status, exit_usage) << space.err;
  EXPECT_NE(space.err.find("`\"at\": [1, 2, 3]` has its height as well"), std::string::npos)
      << space.err;
}

// Of the only zone that is spoken of the outside goes on for hundreds of km: nobody would come
// near.
TEST_F(Simulations, WhatKeepsOutIsAttackedWhereItIs) {
  write("spec.rta", with_pillar("r inside complement(pillar)"));
  const Outcome sound = rtac({"sim", "spec.rta", "--runs", "8"});
  EXPECT_EQ(sound.status, 0) << sound.err << sound.out;
  EXPECT_LT(least_m(sound.out, "\nfence "), 0.4) << sound.out;
  const Outcome mutant = rtac({"sim", "spec.rta", "--runs", "8", "--adversary", "chase-fence",
                               "--mutate", "no-stopping-distance"});
  EXPECT_EQ(mutant.status, 3) << mutant.err << mutant.out;
}

// Beside a zone that must hold, a hole is a hole in it.
TEST_F(Simulations, WhatKeepsOutAndWhatKeepsInAreAttackedTogether) {
  const std::string both = with_pillar("r inside yard and distance(r, pillar) >= 10 cm");
  write("spec.rta", edited(both, "yard - pillar", "yard - grow(pillar, 10 cm)"));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "8"});
  EXPECT_EQ(o.status, 0) << o.err << o.out;
  EXPECT_LT(least_m(o.out, "\nfence "), 0.4) << o.out;
}

// Nobody is near anybody before there are two.
TEST_F(Simulations, RobotsStartTogetherWhereTheyMust) {
  write("spec.rta", yard("50 ms", "exists q : Rover, q != r : distance(r, q) >= 1 m"));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "1", "--adversary", "bang-bang"});
  EXPECT_TRUE(o.status == 0 || o.status == 3) << o.err;
  EXPECT_NE(o.out.find("least margin"), std::string::npos) << o.out;
}

// Why a number of other robots is refused (6003): each robot keeps its own, and breaks another's.
// What is said of each pair is kept.
TEST_F(Simulations, ANumberOfOthersIsBrokenByAThird) {
  const std::string three = edited(yard("50 ms", "WHAT"), "r1, r2 : Rover", "r1, r2, r3 : Rover");
  const std::string crowd = "count(q : Rover, q != r : distance(r, q) <= 1 m) <= 1";
  const std::string accepted = edited(
      three, "priority fence;", "priority fence; acknowledge turn_back may break fence \"x\";");
  write("near.json", R"({"duration_s": 20, "runs": 6, "adversary": "chase-robot",
    "starts": {"r1": {"at": [4, 4]}, "r2": {"at": [2.7, 4]}, "r3": {"at": [7, 4]}}})");
  const std::vector<std::string> attack = {"sim", "spec.rta", "--scenario", "near.json"};
  write("spec.rta", edited(three, "WHAT", crowd));
  EXPECT_EQ(rtac(attack).status, 1);
  write("spec.rta", edited(accepted, "WHAT", crowd));
  const Outcome broken = rtac(attack);
  EXPECT_EQ(broken.status, 3) << broken.err << broken.out;
  write("spec.rta", edited(three, "WHAT", "forall q : Rover, q != r : distance(r, q) >= 50 cm"));
  const Outcome kept = rtac(attack);
  EXPECT_EQ(kept.status, 0) << kept.err << kept.out;
}

TEST_F(Simulations, ScenariosAreRefusedWithWhatWouldWork) {
  write("spec.rta", yard("50 ms"));
  const std::pair<const char*, const char*> cases[] = {
      {"{", "`s.json`: the scenario is no JSON: line 1, column 2"},
      {"{\"runs\": 2,\n  \"seed\": }", "line 2, column 11"},
      {"[1]", "is one"},
      {R"({"seed": 1, "seed": 2})", "has \"seed\" twice"},
      {R"({"starts": {"r1": {"at": [1, 2], "at": [2, 1]}}})", "has \"at\" twice"},
      {R"({"duration": 3})", "`duration_s`"},
      {R"({"duration_s": 0})", "a number from 0.001 to 86400.0 works"},
      {R"({"noise": "loud"})", "`aimed`"},
      {R"({"ages": 3})", "`wandering`"},
      {R"({"adversary": "nobody"})", "`chase-fence`"},
      {R"({"adversary": {"r3": "bang-bang"}})", "`r3`"},
      {R"({"starts": {"r1": {"at": 3}}})", "`heading_deg`"},
      {R"({"starts": 3})", "or `\"starts\": \"tight\"`"},
      {R"({"inputs": 3})", "`\"inputs\": {\"open\": true}` works"},
      {R"({"undecided": 1})", "`true` and `false` work"},
      {R"({"starts": {"nobody": {"at": [1, 2]}}})", "there are `r1`"},
      {R"({"starts": {"r1": {"battery": 0.5}}})", "or declare `sense battery`"},
      {R"({"about": "nothing"})", "which does not exist\nhelp: there are `"},
      {R"({"jitter_ms": 5.1})", "up to 5 works"},
      {R"({"runs": 0})", "a whole number from 1 to "},
      {R"({"runs": -1})", "a whole number from 1 to "}};
  for (const auto& [text, help] : cases) {
    write("s.json", text);
    const Outcome o = rtac({"sim", "spec.rta", "--scenario", "s.json"});
    EXPECT_EQ(o.status, 2) << text;
    EXPECT_NE(o.err.find("error[9009]"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find(help), std::string::npos) << text << "\n" << o.err;
  }
  EXPECT_EQ(rtac({"sim", "spec.rta", "--scenario", "missing.json"}).status, 2);
}

TEST_F(Simulations, WhatCannotBeReadIsToldAsSuch) {
  write("spec.rta", yard("50 ms"));
  fs::create_directory("folder");
  for (const std::string flag : {"--scenario", "--replay"}) {
    for (const std::string path : {"folder", "missing"}) {
      const Outcome o = rtac({"sim", "spec.rta", flag, path});
      EXPECT_EQ(o.status, 2) << flag;
      EXPECT_NE(o.err.find("error[9002]"), std::string::npos) << o.err;
      EXPECT_NE(o.err.find("`" + path + "`: "), std::string::npos) << o.err;
    }
  }
}

TEST_F(Simulations, ARunThatCannotBeWrittenIsNotSaidToBeThere) {
  write("spec.rta", yard(blind));
  fs::create_directory("folder");
  // found before anything is played
  for (const std::string place : {"folder", "no/such/folder", "spec.rta/below"}) {
    const Outcome o = rtac({"sim", "spec.rta", "--runs", "1", "--trace", place});
    EXPECT_EQ(o.status, 2) << place;
    EXPECT_NE(o.err.find("error[9003]: cannot write the run to `" + place + "`: "),
              std::string::npos)
        << o.err;
    EXPECT_NE(o.err.find("`--trace FILE` names another place"), std::string::npos) << o.err;
    EXPECT_EQ(o.out, "") << place;
  }
  if (!fs::is_character_file("/dev/full")) return;
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "1", "--trace", "/dev/full"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("error[9003]: cannot write the run to `/dev/full`: No space left"),
            std::string::npos)
      << o.err;
  EXPECT_EQ(o.out.find("the run is in"), std::string::npos) << o.out;
}

// That a disk is full is no matter of the scenario.
TEST_F(Simulations, WhatWasFoundAndCannotBeWrittenIsToldAsSuch) {
  ASSERT_TRUE(fs::is_character_file("/dev/full"));  // Linux has one
  write("spec.rta", yard("50 ms"));
  write("full.sh", "#!/bin/sh\nexec '" RTAC_SIM_PROGRAM "' \"$@\" >/dev/full\n");
  fs::permissions("full.sh", fs::perms::owner_all);
  ::setenv("RTAC_SIM", fs::absolute("full.sh").c_str(), 1);
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "1"});
  EXPECT_EQ(o.status, 2) << o.err;
  EXPECT_NE(
      o.err.find("error[9003]: cannot write what was found to standard output: No space left"),
      std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("help: make room"), std::string::npos) << o.err;
}

// 400 commands are under way at once.
TEST_F(Simulations, ALatencyOfManyPeriodsLosesNoCommand) {
  std::string slow = edited(yard("400 ms, command"), "latency  20 ms", "latency  400 ms");
  slow = edited(slow, "acceleration;", "acceleration error 0.05 m/s^2;");
  slow = edited(slow, "(8 m, 8 m)", "(30 m, 30 m)");
  write("spec.rta", edited(slow, "period 50 ms", "period 1 ms"));
  write("s.json", R"({"duration_s": 2, "runs": 2})");
  const Outcome o = rtac({"sim", "spec.rta", "--scenario", "s.json"});
  EXPECT_EQ(o.status, 0) << o.err;
}

// No gap is known of a recovery that stands still; plan executors went along others' ways in steps
// of half of it, for ever.
TEST_F(Simulations, RobotsThatOnlyBrakeFollowPlans) {
  const std::string brake =
      edited(yard("50 ms"), "retreat within yard speed 0.3 m/s", "brake_and_hold");
  write("spec.rta", edited(brake, "recover turn_back;",
                           "recover turn_back; hold when violated \"it stands\";"));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "2", "--adversary", "follow-plans"});
  EXPECT_EQ(o.status, 0) << o.err;
}

// Of the line on the share of the advanced controller: had, distance and prediction, in percent.
struct Share {
  double had = -1, points = -1, predicted = -1;
  bool below = false;
};
Share share_of(const std::string& out) {
  Share s;
  char where[8] = "";
  const std::size_t at = out.find("advanced controller: ");
  const char* const line = at == std::string::npos ? "" : out.c_str() + at;
  std::sscanf(line, "advanced controller: %lf %% of the time, %lf points %5s the predicted %lf %%",
              &s.had, &s.points, where, &s.predicted);
  s.below = std::string(where) == "below";
  return s;
}

// What the summary says is what the table says, and the prediction that of `rtac check`.
TEST_F(Simulations, TellHowFarTheShareIsFromThePrediction) {
  write("spec.rta", yard("50 ms"));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "4", "--adversary", "push-at-fence"});
  ASSERT_EQ(o.status, 0) << o.err;
  const Share s = share_of(o.out);
  EXPECT_TRUE(s.below) << o.out;
  EXPECT_GT(s.had, 5) << o.out;
  EXPECT_NEAR(s.predicted - s.had, s.points, 0.051) << o.out;
  char had[16];
  std::snprintf(had, sizeof had, "  %.1f %%", s.had);
  EXPECT_EQ(count(o.out, had), 2u) << o.out;  // of the adversary, and of all
  const std::string check = rtac({"check", "spec.rta"}).out;
  EXPECT_NE(check.find("control back in " + std::to_string(int(s.predicted)) + " %"),
            std::string::npos)
      << check;
}

TEST_F(Simulations, PushingAtTheFenceHasToBeAskedFor) {
  write("spec.rta", yard("50 ms"));
  const Outcome o = rtac({"sim", "spec.rta", "--runs", "21"});
  EXPECT_EQ(o.out.find("push-at-fence"), std::string::npos) << o.out;
}

// The runs of `rtac sim` with its defaults, behind what is derived for the line.
TEST_F(Simulations, ExplainSimulatesWhenItIsTold) {
  write("spec.rta", yard("50 ms"));
  const Outcome alone = rtac({"explain", "spec.rta:15"});
  ASSERT_EQ(alone.status, 0) << alone.err;
  const Outcome o = rtac({"explain", "spec.rta:15", "--simulate", "9"});
  ASSERT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out.substr(0, alone.out.size()), alone.out);
  EXPECT_NE(o.out.find("\nsimulated, 9 runs of 30 s:\ndecision drive, advanced controller: "),
            std::string::npos)
      << o.out;
  const Share told = share_of(o.out), sim = share_of(rtac({"sim", "spec.rta", "--runs", "9"}).out);
  EXPECT_GT(told.had, 0) << o.out;
  EXPECT_EQ(told.had, sim.had);
  EXPECT_EQ(told.predicted, sim.predicted);
}

// Exit code 3, and no file: `rtac sim` is the one that records.
TEST_F(Simulations, ExplainDoesNotKeepAViolationToItself) {
  write("spec.rta", yard(blind));
  const Outcome o = rtac({"explain", "spec.rta:15", "--simulate", "5"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_NE(o.out.find("; a property was violated in "), std::string::npos) << o.out;
  EXPECT_FALSE(fs::exists("yard_patrol.trace"));
}

TEST_F(Simulations, ExplainSimulatesNoDiagnostic) {
  const Outcome o = rtac({"explain", "3001", "--simulate", "5"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("give FILE:LINE"), std::string::npos) << o.err;
}

// The check of the claim is what keeps the robot in; played again, the attack is the same.
TEST_F(Simulations, ExternalRecoveriesAreAttackedBehindTheirClaim) {
  write("own.rta", edited(edited(yard("100 ms"), "= retreat within yard speed 0.3 m/s",
                                 "extern keeps inside yard speed <= 0.3 m/s"),
                          "recover turn_back;",
                          "recover turn_back; hold when violated \"somebody carries it back\";"));
  const Outcome sound = rtac({"sim", "own.rta", "--runs", "16"});
  EXPECT_EQ(sound.status, 0) << sound.out << sound.err;
  const Outcome blind = rtac({"sim", "own.rta", "--runs", "4", "--adversary", "chase-fence",
                              "--mutate", "unchecked-claim", "--trace", "out.trace"});
  EXPECT_EQ(blind.status, 3) << blind.out << blind.err;
  EXPECT_NE(read("out.trace").find("\nrecover "), std::string::npos);
  const Outcome again =
      rtac({"sim", "own.rta", "--mutate", "unchecked-claim", "--replay", "out.trace"});
  EXPECT_EQ(again.status, 3) << again.out << again.err;
  EXPECT_NE(again.out.find("the same to the last bit"), std::string::npos) << again.out;
}

// Nothing is known then: that is not the same as no violation.
TEST_F(Simulations, WhatCannotBeSimulatedIsInconclusive) {
  write("door.rta",
        "spec door; period 10 ms; input open : bool;\n"
        "monitor shut { \"R1: closed\" always not open; }\n");
  write("often.rta", edited(yard("50 ms", "r inside yard or count[0 s, 1 s](open) >= 3"),
                            "zone yard", "input open : bool;\nzone yard"));
  for (const auto& [name, why] :
       {std::pair<std::string, std::string>("door.rta", "no robot of a fleet"),
        std::pair<std::string, std::string>("often.rta", "how often something was so")}) {
    const Outcome o = rtac({"sim", name});
    EXPECT_NE(o.err.find(why), std::string::npos) << o.err;
    EXPECT_EQ(o.status, 4) << name << o.err;
    EXPECT_NE(o.err.find("error[9008]"), std::string::npos) << o.err;
    EXPECT_EQ(o.out, "");
  }
}

TEST_F(Simulations, FlagsAreChecked) {
  write("spec.rta", yard("50 ms"));
  EXPECT_EQ(rtac({"sim", "spec.rta", "--runs", "many"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--runs", "0"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--jobs", "0"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--jobs", "2000"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--jobs", "two"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--seed", "-1"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--seed", "18446744073709551616"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--seed", "18446744073709551615", "--runs", "2"}).status, 0);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--replay", "x", "--seed", "1"}).status, 2);
  EXPECT_EQ(rtac({"sim", "spec.rta", "--adversary", "nobody"}).status, 2);
  ::setenv("RTAC_SIM", "no_such_program", 1);
  const Outcome o = rtac({"sim", "spec.rta"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("no_such_program"), std::string::npos) << o.err;
}

// The codes that this command reports.
TEST_F(Simulations, CodesAreThoseOfTheirPages) {
  EXPECT_EQ(static_cast<int>(diag::Code::cannot_simulate), 9008);
  EXPECT_EQ(static_cast<int>(diag::Code::bad_scenario), 9009);
}

}  // namespace
}  // namespace rtac::driver::test
