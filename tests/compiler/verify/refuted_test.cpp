// Specifications that cannot work, each in a file of `refuted`: the obligation that its first line
// names is refuted, and a recorded run is played again to what shows it: the violation, or the time
// in which control is not given back, or nothing is decided.
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

struct Expected {
  std::string kind, monitor;
  // Whether this is what the run comes to when it is played again: of recoveries that take turns,
  // nobody is given back, or a charge fails.
  [[nodiscard]] bool is_shown_by(const std::string& played) const {
    const auto has = [&](const std::string& end) { return played.find(end) != std::string::npos; };
    if (kind == "P1a") return has("undecided: ");
    const bool of_return = kind == "P2b" || kind == "joint return" || kind == "switching";
    if (of_return && has("not given back: ")) return true;
    return (!of_return || kind == "switching") && has("violated: " + monitor);
  }
};
// A fleet of one robot.
const std::regex& of_one() {
  static const std::regex text("\\nfleet (\\w+) : (\\w+);");
  return text;
}

// `// refuted: P2a of walls`
Expected expected_of(const std::string& text) {
  const std::string start = "// refuted: ";
  std::string line = text.substr(0, text.find('\n'));
  EXPECT_EQ(line.substr(0, start.size()), start);
  line = line.substr(start.size());
  Expected e;
  const std::size_t of = line.find(" of ");
  e.kind = line.substr(0, of);
  if (of != std::string::npos) e.monitor = line.substr(of + 4);
  return e;
}

class Shown : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
};
// The specification refutes what its first line names and nothing else, and the run shows it.
void is_refuted_and_shown(const std::string& path, const Expected& e) {
  const Outcome o = rtac({"verify", path, "--format", "json", "-o", "certificates"});
  ASSERT_EQ(o.status, exit_violation) << o.out << o.err;
  bool found = false;
  std::string trace;
  const Json report = Json::parse(o.out);
  for (const Json& d : report["decisions"]) {
    for (const Json& obligation : d["obligations"]) {
      if (obligation["status"] != "refuted") continue;
      // who moves elsewhere is not given back there either, and who never is, not with others
      const bool follows = e.kind == "P2a" && obligation["obligation"] == "P2b";
      if (follows && obligation.value("monitor", "") == e.monitor) continue;
      if (e.kind == "P2b" && obligation["method"] == "P2b of `" + e.monitor + "`") continue;
      // nothing else is wrong with it
      EXPECT_EQ(obligation["obligation"], e.kind) << o.out;
      EXPECT_EQ(obligation.value("monitor", ""), e.monitor) << o.out;
      found = true;
      trace = obligation.value("trace", trace);
    }
  }
  EXPECT_TRUE(found) << o.out;
  ASSERT_NE(trace, "") << o.out;
  const Outcome again = rtac({"sim", path, "--replay", trace});
  EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
  EXPECT_TRUE(e.is_shown_by(again.out)) << again.out;
}

class Refuted : public Shown, public ::testing::WithParamInterface<std::string> {};

TEST_P(Refuted, IsRefutedAndShown) {
  const std::string path = refuted_folder() + GetParam() + ".rta";
  is_refuted_and_shown(path, expected_of(read(path)));
}

// Whoever else is about stands aside, and it goes wrong all the same.
class RefutedOfTwo : public Shown, public ::testing::WithParamInterface<std::string> {};

TEST_P(RefutedOfTwo, IsRefutedAndShown) {
  const std::string text = read(refuted_folder() + GetParam() + ".rta");
  for (const char* shared : {"parts.rta", "space_parts.rta"})
    write(shared, read(refuted_folder() + shared));
  const std::string of_two = std::regex_replace(text, of_one(), "\nfleet $1, another : $2;");
  ASSERT_NE(of_two, text);
  write("two.rta", of_two);
  is_refuted_and_shown("two.rta", expected_of(text));
}

// A retreat that knows nothing of the pond: where its own zone has room it leads no further, which
// is no violation, and not where control is given back either.
TEST_F(Shown, WhoMovesElsewhereIsNotGivenBackThere) {
  write("pond.rta", R"(spec pond;
zone hall = rectangle (0 m, 0 m) to (12 m, 10 m);
zone water = circle (6 m, 5 m) radius 2 m;
robot Bot {
  body radius 20 cm;
  motion point { speed <= 1.2 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet b : Bot;
controller nav : advanced for Bot extern;
controller back : safe for Bot = retreat within hall speed 0.3 m/s;
monitor dry for x : Bot {
  "R1: in the hall, off the water"
  always x inside hall and distance(x, water) >= 20 cm; recover back;
}
decision drive for Bot { advanced nav; period 50 ms; priority dry; }
)");
  const Outcome o = rtac({"verify", "pond.rta", "--format", "json"});
  ASSERT_EQ(o.status, exit_violation) << o.out << o.err;
  const Json report = Json::parse(o.out);
  std::set<std::string> refuted;
  for (const Json& obligation : report["decisions"][0]["obligations"]) {
    if (obligation["status"] != "refuted") continue;
    refuted.insert(obligation["obligation"]);
    if (obligation["obligation"] != "P2b") continue;
    const Outcome again = rtac({"sim", "pond.rta", "--replay", obligation.value("trace", "")});
    EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
    EXPECT_NE(again.out.find("not given back: b by dry"), std::string::npos) << again.out;
  }
  EXPECT_EQ(refuted, std::set<std::string>{"P2b"}) << o.out;
}

// No two places in the pen are far enough apart for both to be given back: robots begin where they
// are farthest from each other, and are kept there.
TEST_F(Shown, WhoAsksForMoreRoomThanThereIsIsNotGivenBack) {
  write("pen.rta", R"(spec pen;
zone pen = circle (0 m, 0 m) radius 2.5 m;
robot Cart {
  body radius 30 cm;
  motion point { speed <= 0.6 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 100 ms;
  sense velocity : vector error 2 cm/s max_age 100 ms;
  hears other robots max_age 150 ms;
  output push : acceleration;
  latency 50 ms;
}
fleet a, b : Cart;
controller job  : advanced for Cart extern;
controller give : safe for Cart = yield within pen speed 0.2 m/s order id;
controller back : safe for Cart = retreat within pen speed 0.2 m/s;
monitor apart for r : Cart {
  "R1: apart" always forall q : Cart, q != r : distance(r, q) >= 3.4 m; recover give;
  hold when violated "somebody comes";
}
monitor fence for r : Cart { "R2: in the pen" always r inside pen; recover back; }
decision drive for Cart { advanced job; period 100 ms; priority apart > fence; }
)");
  const Outcome o = rtac({"verify", "pen.rta", "--format", "json"});
  ASSERT_EQ(o.status, exit_violation) << o.out << o.err;
  std::set<std::string> refuted;
  const Json report = Json::parse(o.out);
  for (const Json& obligation : report["decisions"][0]["obligations"]) {
    if (obligation["status"] != "refuted") continue;
    refuted.insert(obligation["obligation"]);
    const Outcome again = rtac({"sim", "pen.rta", "--replay", obligation.value("trace", "")});
    EXPECT_NE(again.out.find("not given back: "), std::string::npos) << obligation << again.err;
  }
  EXPECT_EQ(refuted, (std::set<std::string>{"P2b", "joint return"})) << o.out;
}

// A limit of speed below what the recovery drives at: that is braked first, and control is given
// back at rest. And a way home that begins three seconds late, for which what is kept for others
// suffices. Neither fails in a run, and neither is proved.
TEST_F(Shown, WhatNobodyKeepsAndNoRunBreaksIsUnknown) {
  const std::string late_cart = R"(
zone room = rectangle (0 m, 0 m) to (10 m, 8 m);
robot Cart {
  body radius 30 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  sense battery : ratio error 1 % max_age 2 s;
  output thrust : acceleration;
  latency 30 ms;
  energy { drive <= 0.3 %/m; idle <= 0.02 %/s; drain <= 0.5 %/s; charge >= 1 %/s at dock;
           held <= 60 s; detour <= 8 m; }
}
site dock = (5 m, 4 m);
fleet c : Cart;
controller scan : advanced for Cart extern;
controller back : safe for Cart = retreat within room speed 0.6 m/s;
controller home : safe for Cart =
  sequence brake_and_hold for 3 s then route to dock within room speed 0.4 m/s;
)";
  const struct {
    const char *monitor, *text, *method;
  } cases[] = {{"calm", "always r.speed <= 0.5 m/s; recover back;", "diagnostic 5033"},
               {"charged",
                "always r.battery >= energy_to(dock) + 4 %; recover home;"
                " return when r.battery >= 70 %;",
                "diagnostic 5013"}};
  for (const auto& each : cases) {
    const std::string name = each.monitor;
    write("spec.rta", "spec late;" + late_cart + "monitor " + name + " for r : Cart { \"R1: so\" " +
                          each.text + " }\ndecision go for Cart { advanced scan; period 50 ms; " +
                          "priority " + name + "; }\n");
    const Outcome o = rtac({"verify", "spec.rta", "--format", "json"});
    EXPECT_EQ(o.status, exit_inconclusive) << name << o.out << o.err;
    int found = 0;
    const Json report = Json::parse(o.out);
    for (const Json& obligation : report["decisions"][0]["obligations"]) {
      if (obligation["obligation"] != "P2a") continue;
      ++found;
      EXPECT_EQ(obligation["status"], "unknown") << obligation;
      EXPECT_EQ(obligation["method"], each.method) << obligation;
      EXPECT_EQ(obligation.value("not_shown", ""), "no run under attack has shown it");
    }
    EXPECT_EQ(found, 1) << o.out;
  }
}

// Robots that come too close while each of them waits for the other one, which is accepted, have
// not been led there by the way home.
TEST_F(Shown, ARunInWhichAnotherRecoveryDrivesShowsNothingOfAPair) {
  write("few.rta", R"(spec few;
zone yard = rectangle (0 m, 0 m) to (30 m, 30 m);
robot Tug {
  body radius 40 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 60 ms;
  sense velocity : vector error 2 cm/s max_age 60 ms;
  hears other robots max_age 200 ms;
  output push : acceleration;
  latency 30 ms;
}
fleet tugs : Tug[3];
site base = (15 m, 15 m);
controller nav : advanced for Tug extern;
controller home : safe for Tug = route to base within yard speed 0.4 m/s;
controller back : safe for Tug = retreat within yard speed 0.4 m/s;
monitor fence for t : Tug { "R1: in" always t inside yard; ahead 100 ms; recover home; }
monitor few for t : Tug {
  "R2: nobody within 3 m"
  always count(u : Tug, u != t : distance(t, u) <= 3 m) <= 0;
  ahead 100 ms; recover back;
}
decision drive for Tug {
  advanced nav; period 50 ms; priority fence > few;
  acknowledge back may break few "it waits";
}
)");
  const Outcome o = rtac({"verify", "few.rta", "--format", "json"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  const Json report = Json::parse(o.out);
  bool found = false;
  for (const Json& obligation : report["decisions"][0]["obligations"]) {
    if (obligation.value("recovery", "") != "home") continue;
    found = true;
    EXPECT_EQ(obligation["status"], "unknown") << obligation;
    EXPECT_FALSE(obligation.contains("trace")) << obligation;
  }
  EXPECT_TRUE(found) << o.out;
}

// Nobody is told that no run has shown it.
TEST_F(InFolder, ASimulatorThatFailsIsAnInternalError) {
  write("sim.sh", "#!/bin/sh\nkill -BUS $$\n");
  fs::permissions("sim.sh", fs::perms::owner_all);
  ::setenv("RTAC_SIM", fs::absolute("sim.sh").c_str(), 1);
  const Outcome o = rtac({"verify", refuted_folder() + "strays.rta"});
  ::unsetenv("RTAC_SIM");
  EXPECT_EQ(o.status, exit_internal) << o.out << o.err;
  EXPECT_NE(o.out.find("not shown: the simulator has failed"), std::string::npos) << o.out;
  EXPECT_NE(o.err.find("internal error: the simulator has failed"), std::string::npos) << o.err;
}

// A simulator whose trace is longer than what is read again: what it has shown is shown.
class Unrecorded : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("sim.sh",
          "#!/bin/sh\n"
          "for word; do [ \"$before\" = --trace ] && trace=$word; before=$word; done\n"
          "\"" RTAC_SIM_PROGRAM
          "\" \"$@\"\n"
          "status=$?\n"
          "[ \"$status\" != 3 ] || truncate -s 65M \"$trace\"\n"
          "exit $status\n");
    fs::permissions("sim.sh", fs::perms::owner_all);
    ::setenv("RTAC_SIM", fs::absolute("sim.sh").c_str(), 1);
  }
  static Json shown(const std::string& name) {
    const std::string path =
        std::string(RTAC_SOURCE_DIR) + "/tests/compiler/verify/refuted/" + name + ".rta";
    const Outcome o = rtac({"verify", path, "--format", "json"});
    EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
    const Json report = Json::parse(o.out);
    for (const Json& obligation : report["decisions"][0]["obligations"]) {
      if (obligation["status"] == "refuted") return obligation;
    }
    ADD_FAILURE() << o.out;
    return Json::object();
  }
};
TEST_F(Unrecorded, WhatIsShownAndTooLongToKeepIsNotCalledNotShown) {
  for (const char* const name : {"too_late", "lower_rank", "turns"}) {
    const Json found = shown(name);
    EXPECT_EQ(found.value("not_recorded", ""), "the run is too long") << name << found;
    EXPECT_FALSE(found.contains("not_shown")) << name << found;
    EXPECT_FALSE(found.contains("trace")) << name << found;
  }
  const std::string path =
      std::string(RTAC_SOURCE_DIR) + "/tests/compiler/verify/refuted/too_late.rta";
  const Outcome o = rtac({"verify", path});
  EXPECT_NE(o.out.find("shown, not recorded: the run is too long"), std::string::npos) << o.out;
}

// How the time is spent in which runs are sought: a simulator that finds nothing, or what it is
// told to, keeps a list of what it is asked for.
class Attacks : public InFolder {
 protected:
  // Of a call: its `--core-s`, the file of the manifest, and the scenario.
  struct Call {
    int core_s;
    std::string manifest;
    Json scenario;
  };
  // `answer`: what the script does, which knows $core, $scenario and $trace.
  static void play(const std::string& answer) {
    write("sim.sh",
          "#!/bin/sh\n"
          "for word; do\n"
          "  case $before in --core-s) core=$word;; --scenario) scenario=$word;;\n"
          "    --trace) trace=$word;; --manifest) manifest=$word;; esac\n"
          "  before=$word\n"
          "done\n"
          "echo \"$core ${manifest##*/} $(cat \"$scenario\")\" >> \"${0%/*}/calls\"\n" +
              answer);
    fs::permissions("sim.sh", fs::perms::owner_all);
    ::setenv("RTAC_SIM", fs::absolute("sim.sh").c_str(), 1);
  }
  static std::vector<Call> calls() {
    std::vector<Call> all;
    std::istringstream lines(read("calls"));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      Call call;
      words >> call.core_s >> call.manifest >> call.scenario;
      all.push_back(std::move(call));
    }
    return all;
  }
  static std::string refuted_spec(const std::string& name) {
    return std::string(RTAC_SOURCE_DIR) + "/tests/compiler/verify/refuted/" + name + ".rta";
  }
};
// Processor time, as much as it may take.
const char* const busy = "(ulimit -t \"$core\"; while :; do :; done)\n";
const char* const nothing = "echo 'the time was up after 2 of 60 runs'\n";

// The first seconds show most; who is cut goes on from the seed where it was.
TEST_F(Attacks, GiveEachScenarioASecondBeforeOneGetsMore) {
  play(nothing);
  (void)rtac({"verify", refuted_spec("lower_rank"), "--attack", "60"});
  const std::vector<Call> all = calls();
  ASSERT_EQ(all.size() % 3, 0U);
  const std::size_t scenarios = all.size() / 3;
  ASSERT_GE(scenarios, 3U);
  for (std::size_t k = 0; k < scenarios; ++k) {
    const Call &first = all[k], &then = all[scenarios + k], &last = all[2 * scenarios + k];
    EXPECT_EQ(first.core_s, 1);
    EXPECT_EQ(then.core_s, 4);
    EXPECT_GE(last.core_s, 50);
    EXPECT_FALSE(first.scenario.contains("seed")) << first.scenario;
    EXPECT_EQ(then.scenario["seed"], 3) << then.scenario;
    EXPECT_EQ(last.scenario["seed"], 5) << last.scenario;
    EXPECT_EQ(last.scenario["runs"], first.scenario["runs"].get<int>() - 4);
  }
}

TEST_F(Attacks, EndWhenTheirTimeIsUp) {
  play(std::string(busy) + nothing);
  const Outcome o = rtac({"verify", refuted_spec("lower_rank"), "--attack", "2"});
  EXPECT_LE(calls().size(), 3U);
  EXPECT_NE(o.out.find("no run under attack has shown it until the time was up"), std::string::npos)
      << o.out;
  const Outcome none = rtac({"verify", refuted_spec("lower_rank"), "--attack", "0"});
  EXPECT_EQ(none.status, exit_usage) << none.out;
  EXPECT_NE(none.err.find("`--attack 0` simulates nothing"), std::string::npos) << none.err;
}

// What an argument refutes is sought first, and what nothing but a run refutes gets little more
// when that is shown: P2a of who is walked up to, then of who moves elsewhere, and P2b of that one
// for six seconds.
TEST_F(Attacks, SeekWhatIsRefutedBeforeWhatMayBe) {
  play("if ! grep -q return_within_s \"$scenario\"; then echo run > \"$trace\"; exit 3; fi\n" +
       std::string(busy) + nothing);
  write("both.rta", R"(spec both;
zone room  = rectangle (0 m, 0 m) to (6 m, 6 m);
zone porch = rectangle (0 m, -3 m) to (6 m, 0.25 m);
)" + a_rover + R"(agent worker : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;
controller to_porch : safe for Rover = retreat within porch speed 0.3 m/s;
controller stop     : safe for Rover = brake_and_hold;
monitor walls for r : Rover { "R1: in the room" always r inside room; recover to_porch; }
monitor apart for r : Rover { "R2: off who walks" always distance(r, worker) >= 30 cm; recover stop; }
decision fly for Rover { advanced drive; period 50 ms; priority walls > apart; }
)");
  const Outcome o = rtac({"verify", "both.rta"});
  EXPECT_EQ(o.status, exit_violation) << o.out;
  const std::vector<Call> all = calls();
  ASSERT_GE(all.size(), 3U) << o.out << o.err;
  EXPECT_LE(all.size(), 5U);
  EXPECT_EQ(all[0].scenario["about"], "apart");
  EXPECT_EQ(all[1].scenario["about"], "walls");
  // who walks up to a robot that stands counts for what is refuted for that, and for nothing else
  EXPECT_EQ(all[0].manifest, "walking_up.json");
  EXPECT_EQ(all[1].manifest, "simulation.json");
  for (std::size_t k = 2; k < all.size(); ++k) {
    EXPECT_TRUE(all[k].scenario.contains("return_within_s")) << all[k].scenario;
  }
}

// Of one robot, which needs no place of its own.
std::vector<std::string> names_of_one() {
  std::vector<std::string> all;
  for (const std::string& name : refuted_names()) {
    const std::string text = read(refuted_folder() + name + ".rta");
    const bool sites = text.find("\nsite ") != std::string::npos;
    if (!sites && std::regex_search(text, of_one())) all.push_back(name);
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(Specs, RefutedOfTwo, ::testing::ValuesIn(names_of_one()),
                         [](const auto& spec) { return spec.param; });
INSTANTIATE_TEST_SUITE_P(Specs, Refuted, ::testing::ValuesIn(refuted_names()),
                         [](const auto& spec) { return spec.param; });

// Where robots wait for each other, and none of the runs that begin there shows that they do so for
// ever.
class Parted : public Shown, public ::testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Specs, Parted,
                         ::testing::Values("by_ring", "in_aisle", "in_doorway", "stacked"),
                         [](const auto& spec) { return spec.param; });
TEST_P(Parted, NoRunShowsThatTheyWaitForEver) {
  const std::string path =
      std::string(RTAC_SOURCE_DIR) + "/tests/compiler/verify/parting/" + GetParam() + ".rta";
  const Outcome o = rtac({"verify", path, "--format", "json", "-o", "certificates"});
  EXPECT_NE(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(o.out.find("\"refuted\""), std::string::npos) << o.out;
  // but for what is proved, runs have begun there
  const bool proved = std::string(GetParam()) == "stacked";
  EXPECT_EQ(o.out.find("no run under attack has shown it") == std::string::npos, proved) << o.out;
}

TEST(RefutedSpecs, AreTwentyOrMore) {
  EXPECT_GE(refuted_names().size(), 20u);
}

std::string carrier(const std::string& kind) {
  return "robot " + kind + R"( {
  body radius 40 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
)";
}

// Who comes so near to the wall that the fence takes over never arrives at the dock.
TEST_F(Verify, ASiteWhereAHigherMonitorLetsNoneBeIsReachedByNoWay) {
  const auto page = [](const std::string& dock) {
    return "spec wall;\nzone hall = rectangle (0 m, 0 m) to (12 m, 9 m);\n" + carrier("Amr") +
           R"(fleet amr : Amr;
input called : bool max_age 1 s;
site dock(amr) = )" +
           dock + R"(;
controller pilot : advanced for Amr extern;
controller back  : safe for Amr = retreat within hall speed 0.3 m/s;
controller home  : safe for Amr = route to dock within hall speed 0.3 m/s;
monitor fence for r : Amr { "R1" always r inside hall; recover back; }
monitor call  for r : Amr { "R2" always not called; recover home; }
decision go for Amr { advanced pilot; period 50 ms; priority fence > call; }
)";
  };
  const Outcome o = verified(page("(0.35 m, 4 m)"));
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_NE(o.out.find("diagnostic 4008: `dock(amr)`, where `home` leads, lies where `fence`"),
            std::string::npos)
      << o.out;
  const std::string before = "help: the place ";
  const std::size_t at = o.err.find(before);
  ASSERT_NE(at, std::string::npos) << o.err;
  const std::size_t begin = at + before.size();
  const std::string place = o.err.substr(begin, o.err.find(" works", begin) - begin);
  EXPECT_EQ(verified(page(place)).status, exit_clean) << place;
}

// Of a second kind of robots that is led there as well.
TEST_F(Verify, ASiteOfTwoKindsIsHeldAgainstTheFencesOfBoth) {
  const auto robot = [](const std::string& kind, const std::string& fence) {
    return carrier(kind) + "fleet the_" + kind + " : " + kind + ";\n" + "controller pilot_" + kind +
           " : advanced for " + kind + " extern;\ncontroller back_" + kind + " : safe for " + kind +
           " = retreat within " + fence + " speed 0.3 m/s;\ncontroller home_" + kind +
           " : safe for " + kind + " = route to dock within hall speed 0.3 m/s;\nmonitor fence_" +
           kind + " for r : " + kind + " { \"R1\" always r inside " + fence + "; recover back_" +
           kind + "; }\nmonitor call_" + kind + " for r : " + kind +
           " { \"R2\" always not called; recover home_" + kind + "; }\ndecision go_" + kind +
           " for " + kind + " { advanced pilot_" + kind + "; period 50 ms; priority fence_" + kind +
           " > call_" + kind + "; }\n";
  };
  const Outcome o = verified(
      "spec two;\nzone hall = rectangle (0 m, 0 m) to (12 m, 9 m);\n"
      "zone part = rectangle (0 m, 0 m) to (6 m, 9 m);\ninput called : bool max_age 1 s;\n"
      "site dock = (9 m, 4 m);\n" +
      robot("Amr", "hall") + robot("Cart", "part"));
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_NE(o.err.find("`dock`, where `home_Cart` leads, lies where `fence_Cart` lets none be"),
            std::string::npos)
      << o.err;
}

// No run has to show that no way leads out of the zone that it is to stay in.
TEST_F(Verify, ASiteOutsideOfItsZoneIsReachedByNoWay) {
  const std::string text = spec_text("tests/compiler/verify/refuted/docks.rta");
  const Outcome o = verified(edited(text, "dock(left) = (1 m, 1 m)", "dock(left) = (90 m, 1 m)"),
                             {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  bool found = false;
  const Json report = Json::parse(o.out);
  for (const Json& each : report["decisions"][0]["obligations"]) {
    if (each["status"] != "refuted" || each["method"] != "diagnostic 4008") continue;
    found = true;
    EXPECT_EQ(each["obligation"], "P2b") << each;
    EXPECT_NE(each.value("because", "").find("lies outside"), std::string::npos) << each;
    EXPECT_EQ(each.value("not_shown", ""), "no way can end there, and no run has to");
  }
  EXPECT_TRUE(found) << o.out;
}

// What leaves no doubt about what was meant, but nothing to derive, refutes what it is about.
TEST_F(Verify, WhatCannotBeDerivedIsRefutedInTheTable) {
  const struct {
    std::vector<std::pair<std::string, std::string>> edits;
    std::string kind, monitor, method;
  } cases[] = {
      {{{"  recover back_off;\n", ""}}, "P2a", "walls", "diagnostic 5002"},
      {{{"period 50 ms;", "period 50 ms; jitter 60 ms;"}}, "P1a", "", "diagnostic 5005"},
      {{{"brake >= 1 m/s^2", "brake >= 0 m/s^2"}}, "satisfiable", "", "diagnostic 5005"},
      {{{"decision fly",
         "decision first for Drone { advanced pilot; period 50 ms; priority walls; }\ndecision "
         "fly"}},
       "P1b",
       "",
       "diagnostic 5011"},
  };
  for (const auto& each : cases) {
    std::string text = drone_spec();
    for (const auto& [from, to] : each.edits) text = edited(text, from, to);
    const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
    EXPECT_EQ(o.status, exit_violation) << each.method << o.out << o.err;
    const Json report = Json::parse(o.out);
    EXPECT_EQ(report["complete"], false);
    const Json& all = report["decisions"].back()["obligations"];
    ASSERT_EQ(all.size(), 1U) << o.out;
    EXPECT_EQ(all[0]["obligation"], each.kind);
    EXPECT_EQ(all[0].value("monitor", ""), each.monitor);
    EXPECT_EQ(all[0]["status"], "refuted");
    EXPECT_EQ(all[0]["method"], each.method);
    EXPECT_FALSE(fs::exists("certificates"));
  }
  // beside an error that leaves open what is meant, nobody knows
  const std::string both = edited(edited(drone_spec(), "  recover back_off;\n", ""),
                                  "clearance(d, room)", "clearance(d, rome)");
  EXPECT_EQ(verified(both).status, exit_spec_errors);
}

// Of each recovery that is too slow, in the table of the decision that it belongs to.
TEST_F(Verify, EachRecoveryThatIsTooSlowIsTold) {
  const std::string slow = edited(drone_spec(), "speed 0.3 m/s", "speed 0.01 m/s");
  const std::string two =
      edited(slow, "monitor walls",
             "controller creep : safe for Drone = retreat within room speed 0.02 m/s;\n"
             "monitor more for d : Drone { \"SR-9: in\" always d inside room; recover creep; }\n"
             "monitor walls");
  const Outcome o =
      verified(edited(two, "priority walls", "priority more > walls"), {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  const Json of_two = Json::parse(o.out);
  std::string because;
  for (const Json& each : of_two["decisions"][0]["obligations"]) {
    EXPECT_EQ(each["obligation"], "P2a") << each;  // both properties can be satisfied
    because += each.value("monitor", "") + ": " + each.value("because", "") + "\n";
  }
  EXPECT_NE(because.find("walls: `back_off` is too slow"), std::string::npos) << o.out;
  EXPECT_NE(because.find("more: `creep` is too slow"), std::string::npos) << o.out;

  const std::string golden =
      std::string(RTAC_SOURCE_DIR) + "/tests/golden/bad_5005_too_slow/spec.rta";
  const Json report = Json::parse(rtac({"verify", golden, "--format", "json"}).out);
  const std::pair<std::size_t, const char*> told[] = {{0, "`crawl` is too slow"},
                                                      {1, "`sway` is too slow"}};
  for (const auto& [n, text] : told) {
    EXPECT_NE(report["decisions"][n].dump().find(text), std::string::npos) << report;
  }
}

}  // namespace
}  // namespace rtac::driver::test
