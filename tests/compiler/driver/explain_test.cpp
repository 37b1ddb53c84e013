// `rtac explain FILE:LINE`: what was derived for a line, and what it says where there is nothing.
#include <cstdlib>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

const char* const door = R"(spec door;
period 10 ms;
enum  Gear { park, drive }
input open : bool;
input speed : real [m/s] in 0 m/s .. 3 m/s error 1 cm/s max_age 20 ms;
input gear : Gear max_age inf;
param limit : real [m/s] in 0.1 m/s .. 0.5 m/s = 0.3 m/s;
fun   below(v : real [m/s], l : real [m/s]) : bool = v - l <= 0 m/s;

monitor slow { "R7: no driving with an open door"
  always once[0 s, 20 ms] open
         implies below(speed, limit); }
monitor calm { "R8: no jerks"
  always mean[0 s, 100 ms](speed) / 3 <= 1 m/s
         and 2 * speed <= 6 m/s; }
input p : vector [m] in -100 m .. 100 m error 1 cm max_age inf;
input n : int in 0 .. 10 max_age inf;
monitor near { "R9: near" always norm(p) <= 100 m
  or n * n <= 50 or gear == park; }
scale 0.5 m/s;
assume gear == park unchecked "on the bench";
)";

class Explain : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("door.rta", door);
  }
  static std::string at(int line) {
    const Outcome o = rtac({"explain", "door.rta:" + std::to_string(line)});
    EXPECT_EQ(o.status, 0) << o.err;
    return o.out;
  }
  // What is said about one thing of a line.
  static std::string about(int line, const std::string& what) {
    const std::string all = at(line);
    const std::size_t begin = all.find("\n" + what + "\n");
    if (begin == std::string::npos) return "not there: " + what + " in\n" + all;
    const std::size_t end = all.find("\n\n", begin);
    return all.substr(begin + 1, end == std::string::npos ? end : end - begin);
  }
};

// All that is known of an input: two steps of the grid around an error of 10 steps on either side.
TEST_F(Explain, AnInput) {
  EXPECT_EQ(at(5),
            "door.rta:5: input speed : real [m/s] in 0 m/s .. 3 m/s error 1 cm/s max_age 20 ms;\n\n"
            "input speed : real [m/s]\n"
            "  range: 0 m/s .. 3 m/s; outside is unknown\n"
            "  grid: steps of 1/1000 m/s\n"
            "  rounding: outward, to the steps below and above the measurement\n"
            "  error: the interval is at most 0.021 m/s wide\n"
            "  a sample counts for 20 ms\n"
            "  bytes: 32 of input, 8 of state\n");
}

TEST_F(Explain, WhatIsDeclaredBesides) {
  EXPECT_NE(at(2).find("3 monitors\n"), std::string::npos);
  EXPECT_NE(at(3).find("values in the kernel: 0 park, 1 drive\n"), std::string::npos);
  EXPECT_NE(at(4).find("a tick without a new sample is unknown\n"), std::string::npos);
  EXPECT_NE(at(6).find("assumed: the last value holds for ever\n"), std::string::npos);
  EXPECT_NE(at(7).find("at first 0.3 m/s, may only shrink at run time\n"), std::string::npos);
  EXPECT_NE(at(16).find("input p : real [m], 2 components\n"), std::string::npos);
  EXPECT_NE(at(20).find("scale of margins: 0.5 m/s\n"), std::string::npos);
  EXPECT_NE(at(21).find("unchecked: on the bench\n"), std::string::npos);
}

// A mean of 11 values 21 steps wide is 22 wide; a third of it, on a grid three times as fine, too.
TEST_F(Explain, AQuantity) {
  EXPECT_EQ(about(14, "`mean[0 s, 100 ms](speed)`"),
            "`mean[0 s, 100 ms](speed)`\n"
            "  type: real [m/s]\n"
            "  range: -0.01 m/s .. 3.01 m/s\n"
            "  grid: steps of 1/1000 m/s\n"
            "  rounding: outward, the lower end down and the upper end up\n"
            "  error: the interval is at most 0.022 m/s wide\n"
            "  1 operation a tick of its own, 216 bytes of state\n");
  EXPECT_NE(about(14, "`mean[0 s, 100 ms](speed) / 3`").find("at most 0.007333334 m/s wide"),
            std::string::npos);
}

TEST_F(Explain, AConditionHasAScaleAndTheErrorOfItsMargin) {
  const std::string text = about(15, "`2 * speed <= 6 m/s`");
  EXPECT_NE(text.find("scale: margins count millionths of 0.5 m/s\n"), std::string::npos) << text;
  EXPECT_NE(text.find("at most 0.042 m/s wide\n"), std::string::npos) << text;
}

// Why a margin of the past is infinite: Booleans have none, whatever the window.
TEST_F(Explain, WhatIsAskedOfThePastSaysWhyItsMarginIsInfinite) {
  write("door.rta",
        "spec s; period 1 s; input p : bool; input q : bool; input x : real [m] in 0 .. 9 m;\n"
        "monitor a { \"R\" always once[0 s, 2 s] p; margin full; }\n"
        "monitor b { \"R\" always p since[0 s, 2000 s] q; }\n"
        "monitor c { \"R\" always historically[0 s, 2000 s] x >= 1 m; }\n"
        "monitor d { \"R\" always historically[0 s, 2000 s] x >= 1 m; margin full; }\n"
        "monitor e { \"R\" always once[0 s, 2 s] historically[0 s, 2000 s] x >= 1 m; }\n");
  const auto margin = [](int line, const std::string& what) {
    const std::string all = about(line, what);
    const std::size_t begin = all.find("  margin: ");
    return begin == std::string::npos ? ""
                                      : all.substr(begin + 2, all.find('\n', begin) - begin - 2);
  };
  const std::string of_booleans = "margin: infinite, of Booleans there are verdicts alone";
  EXPECT_EQ(margin(2, "`once[0 s, 2 s] p`"), of_booleans);
  EXPECT_EQ(margin(3, "`p since[0 s, 2000 s] q`"), of_booleans);
  EXPECT_EQ(margin(4, "`historically[0 s, 2000 s] x >= 1 m`"),
            "margin: infinite, of a window this long the verdict alone is kept; `margin full;` in "
            "the monitor keeps it");
  EXPECT_EQ(margin(5, "`historically[0 s, 2000 s] x >= 1 m`"), "");
  EXPECT_EQ(margin(6, "`once[0 s, 2 s] historically[0 s, 2000 s] x >= 1 m`"),
            "margin: infinite, that of the longer window in it is; `margin full;` in the monitor "
            "keeps it");
}

// A comparison that a number is made of gives no unit to the margin.
TEST_F(Explain, TheBoundOfAMarginIsInItsUnits) {
  write("door.rta",
        "spec s; period 1 s; input v : vector [m/s] in -5 .. 5 m/s; input x : real [m];\n"
        "monitor a { \"R\" always count[0 s, 2 s](norm(v) <= 1 m/s) >= 2; }\n"
        "monitor b { \"R\" always (if norm(v) <= 1 m/s then 0.2 else 0.6) >= 0.5; }\n"
        "monitor c { \"R\" always norm(v) <= 1 m/s or once[0 s, 1 s] not x >= 1 m; }\n");
  EXPECT_NE(at(2).find(" when it is more than 3 away from 0"), std::string::npos) << at(2);
  EXPECT_NE(at(3).find(" when it is more than 0.4 away from 0"), std::string::npos) << at(3);
  const std::string both = at(4).substr(at(4).find(" more than "), 60);
  EXPECT_NE(both.find(" m/s, or "), std::string::npos) << both;
  EXPECT_NE(both.find(" m away from 0"), std::string::npos) << both;
}

TEST_F(Explain, TypesOfWholeNumbersStayWhole) {
  const std::string text = about(19, "`n * n`");
  EXPECT_NE(text.find("  type: int\n  range: 0 .. 100\n"), std::string::npos) << text;
}

// Of a norm the error is that of the vector, 21 mm on either axis: 29.7 mm, rounded outward.
TEST_F(Explain, RootsAreRoundedOutward) {
  const std::string text = about(18, "`norm(p)`");
  EXPECT_NE(text.find("at most 0.031 m wide\n"), std::string::npos) << text;
  EXPECT_NE(text.find("rounding: outward"), std::string::npos) << text;
}

// A monitor is explained on each of its lines, with its cost.
TEST_F(Explain, AMonitorOnAllOfItsLines) {
  const std::string summary = rtac({"check", "door.rta"}).out;
  EXPECT_NE(summary.find("monitor slow: 10 operations a tick, remembers 56 bytes"),
            std::string::npos)
      << summary;
  for (const int line : {10, 11, 12}) {
    EXPECT_EQ(about(line, "monitor slow"),
              "monitor slow\n  R7: no driving with an open door\n"
              "  rounding: an exact margin is decided when it is more than 0.001 m/s away from 0\n"
              "  10 operations a tick\n  remembers 56 bytes\n");
  }
}

// What is equal is computed once, and the second place says for which line.
TEST_F(Explain, AValueThatIsShared) {
  const std::string text = about(15, "`speed`");
  EXPECT_NE(text.find("range: -0.01 m/s .. 3.01 m/s\n"), std::string::npos) << text;
  EXPECT_NE(text.find("computed once, for line 14\n"), std::string::npos) << text;
}

TEST_F(Explain, TheBodyOfAFunctionInTheMonitorThatCallsIt) {
  const std::string text = about(8, "`v - l`");
  EXPECT_NE(text.find("in monitor slow\n"), std::string::npos) << text;
  EXPECT_NE(text.find("range: -0.51 m/s .. 2.91 m/s\n"), std::string::npos) << text;
}

// The drone of the examples with what it is judged by now: its gap, an input, the age of a sample.
class ExplainDecision : public Explain {
 protected:
  void SetUp() override {
    Explain::SetUp();
    write("drone.rta",
          driver::test::read(fs::path(RTAC_SOURCE_DIR) / "compiler/docs/examples/drone.rta"));
    write("door.rta",
          "spec yard;\nimport \"drone.rta\";\ninput permit : bool max_age 1 s;\n"
          "monitor walls for d : Drone {\n  \"SR-1: in, with a permit\"\n"
          "  always clearance(d, room) >= 10 cm and\n"
          "         once[0 s, 1 s] permit;\n"
          "  recover back_off;\n}\n"
          "decision fly for Drone { advanced pilot; period 50 ms; priority walls; }\n");
  }
};
TEST_F(ExplainDecision, WhatAMonitorTakesAndRemembers) {
  const std::string all = at(6);
  EXPECT_NE(all.find("judged now: 7 operations a tick, remembers 88 bytes\n"), std::string::npos)
      << all;
}
// Twice: 2 cm of error, 50 ms at 1 m/s and what may have been added to it, the grid; 3 mm of
// bounds.
TEST_F(ExplainDecision, AQuantityOfARobot) {
  EXPECT_EQ(about(6, "`clearance(d, room)`"),
            "`clearance(d, room)`\n"
            "  type: real [m]\n"
            "  range: -2147483.648 m .. 2147483.648 m\n"
            "  grid: steps of 1 mm\n"
            "  rounding: outward, the lower end down and the upper end up\n"
            "  error: the interval is at most 0.161 m wide\n"
            "  1 operation a tick of its own\n");
}
TEST_F(ExplainDecision, AConditionOfARobotHasAScale) {
  const std::string text = about(6, "`clearance(d, room) >= 10 cm`");
  EXPECT_NE(text.find("scale: margins count millionths of 1 m\n"), std::string::npos) << text;
}
TEST_F(ExplainDecision, WhatIsJudgedNow) {
  const std::string text = about(7, "`once[0 s, 1 s] permit`");
  EXPECT_NE(text.find("56 bytes of state\n  judged now, whatever lies ahead"), std::string::npos)
      << text;
}
TEST_F(ExplainDecision, AnInputOfADecision) {
  const std::string text = about(3, "input permit : bool, of decision fly");
  EXPECT_NE(text.find("bytes: 32 of input, 8 of state"), std::string::npos) << text;
}

TEST_F(Explain, TheColumnOfAMessageMayStay) {
  EXPECT_EQ(rtac({"explain", "door.rta:5:7"}).out, at(5));
}

TEST_F(Explain, ALineWithoutAnythingNamesTheNearestOnes) {
  for (const auto& [place, help] : std::vector<std::pair<std::string, std::string>>{
           {"door.rta:1", "line 2 is the nearest that has something"},
           {"door.rta:9", "lines 8 and 10 are the nearest that have something"},
           {"none.rta:1", "no line of it has something"}}) {
    write("none.rta", "spec none;\n");
    const Outcome o = rtac({"explain", place});
    EXPECT_EQ(o.status, 2) << place;
    EXPECT_EQ(o.out, "");
    EXPECT_EQ(o.err, "error[9001]: nothing is derived for `" + place + "`\nhelp: " + help +
                         "\n\n1 error\n");
  }
}

TEST_F(Explain, OneOperationIsOne) {
  write("one.rta", "spec s;\nperiod 1 s;\ninput p : bool;\nmonitor m { \"R: r\" always p; }\n");
  const std::string summary = rtac({"check", "one.rta"}).out;
  EXPECT_NE(summary.find("monitor m: 1 operation a tick,"), std::string::npos) << summary;
}

TEST_F(Explain, ALineThatIsNotThere) {
  for (const std::string line : {"0", "22", "4294967299", "99999999999999999999"}) {
    const Outcome o = rtac({"explain", "door.rta:" + line});
    EXPECT_EQ(o.status, 2) << line;
    EXPECT_NE(o.err.find("there is no line " + line + " in"), std::string::npos) << o.err;
    EXPECT_NE(o.err.find("its lines are 1 to 21"), std::string::npos) << o.err;
  }
}

// A part is explained as it is in what imports it.
class ExplainPart : public Explain {
 protected:
  void SetUp() override {
    Explain::SetUp();
    write("parts/limits.rta", "fun slow(v : real [m/s]) : bool =\n  v <= 1 m/s;\n");
    write("main.rta",
          "spec s; period 1 s; import \"parts/limits.rta\";\n"
          "input v : real [m/s] in 0 .. 5 m/s;\n"
          "monitor m { \"R: r\" always v + 0 m/s <= 1 m/s and slow(v + 0 m/s); }\n");
  }
};

TEST_F(ExplainPart, InWhatImportsIt) {
  const Outcome o = rtac({"explain", "parts/../parts/limits.rta:2", "--in", "main.rta"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out.substr(0, o.out.find("  type")),
            "parts/limits.rta:2: v <= 1 m/s;\n\n`v <= 1 m/s`\n  in monitor m\n");
  const Outcome main = rtac({"explain", "main.rta:2", "--in=main.rta"});
  EXPECT_EQ(main.out, rtac({"explain", "main.rta:2"}).out);
}

TEST_F(ExplainPart, WithoutItSaysWhatWorks) {
  const Outcome o = rtac({"explain", "parts/limits.rta:2"});
  EXPECT_EQ(o.status, 1);
  EXPECT_NE(o.err.find("error[1017]"), std::string::npos) << o.err;
  EXPECT_NE(o.err.find("note: a file that others import has none: `rtac explain "
                       "parts/limits.rta:2 --in MAIN.rta` works, where MAIN.rta is"),
            std::string::npos)
      << o.err;
  EXPECT_NE(o.err.find("help: insert `spec my_spec;`"), std::string::npos) << o.err;
  const std::string check = rtac({"check", "parts/limits.rta"}).err;
  EXPECT_NE(check.find("`rtac check MAIN.rta` works"), std::string::npos) << check;
  write("nothing.rta", "// nothing\n");
  EXPECT_EQ(rtac({"check", "nothing.rta"}).err.find("note:"), std::string::npos);
  write("nameless.rta", "spec ;\nperiod 1 s;\n");
  EXPECT_EQ(rtac({"check", "nameless.rta"}).err.find("note:"), std::string::npos);
}

TEST_F(ExplainPart, OfAnotherSpecification) {
  const Outcome other = rtac({"explain", "door.rta:2", "--in", "main.rta"});
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.err,
            "error[9001]: `door.rta` is no part of `main.rta`\n"
            "help: it imports `parts/limits.rta`\n\n1 error\n");
  const Outcome alone = rtac({"explain", "main.rta:2", "--in", "door.rta"});
  EXPECT_NE(alone.err.find("help: `door.rta` imports nothing\n"), std::string::npos) << alone.err;
  const Outcome page = rtac({"explain", "3001", "--in", "main.rta"});
  EXPECT_EQ(page.status, 2);
  EXPECT_NE(page.err.find("`--in` names what imports the file of a line, and `3001` is none"),
            std::string::npos)
      << page.err;
}

TEST_F(Explain, AFileThatIsNotThere) {
  const Outcome o = rtac({"explain", "missing.rta:3"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("error[9002]: cannot read `missing.rta`"), std::string::npos) << o.err;
}

TEST_F(Explain, AFaultySpecificationIsReportedAsByCheck) {
  write("faulty.rta", "spec s;\nperiod 1 s;\ninput p : bool;\nmonitor m { \"R: r\" always q; }\n");
  const Outcome o = rtac({"explain", "faulty.rta:3"});
  EXPECT_EQ(o.status, 1);
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err, rtac({"check", "faulty.rta"}).err);
}

// ---- robots -------------------------------------------------------------------------------------

// An operand that comes onto the grid of the other one keeps its own range and error.
TEST_F(Explain, OperandsOnOneGridKeepTheirOwnRanges) {
  write("door.rta",
        "spec s; period 1 s; input x : real [m] in -9 .. 9 m error 3 mm resolution 1 cm;\n"
        "input y : real [m] in 0 .. 2 m resolution 1 mm; input z : real [m] in 0 .. 4 m;\n"
        "monitor a { \"R\" always x >= y; }\n"
        "monitor b { \"R\" always min(z, y, x) >= 1 m; }\n");
  EXPECT_NE(about(3, "`x`").find("range: -9.01 m .. 9.01 m\n"), std::string::npos) << at(3);
  EXPECT_NE(about(3, "`y`").find("range: 0 m .. 2 m\n"), std::string::npos) << at(3);
  EXPECT_NE(about(4, "`x`").find("range: -9.01 m .. 9.01 m\n"), std::string::npos) << at(4);
  EXPECT_NE(about(4, "`min(z, y, x)`").find("range: -9.01 m .. 2 m\n"), std::string::npos) << at(4);
}

class ExplainRobot : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("fence.rta", drone_spec());
  }
  // Explains the first line that has the text.
  static std::string at(const std::string& text) {
    const std::string spec = drone_spec();
    const std::size_t place = spec.find(text);
    EXPECT_NE(place, std::string::npos) << text;
    const auto line = 1 + std::count(spec.begin(), spec.begin() + std::ptrdiff_t(place), '\n');
    const Outcome o = rtac({"explain", "fence.rta:" + std::to_string(line)});
    EXPECT_EQ(o.status, 0) << o.err;
    return o.out;
  }
};

// The numbers are those of `check`.
TEST_F(ExplainRobot, AMonitorHasItsLookAheadAndClearances) {
  const std::string summary = rtac({"check", "fence.rta"}).out;
  const std::string text = at("ahead   100 ms");
  const auto number = [](const std::string& from, const std::string& words) {
    const std::size_t begin = from.find(words);
    if (begin == std::string::npos) return "not there: " + words + " in\n" + from;
    const std::size_t start = begin + words.size();
    return from.substr(start, from.find_first_of(" \n,;", start) - start);
  };
  EXPECT_EQ(number(text, "looks "), number(summary, "looks "));
  EXPECT_EQ(number(text, "horizon "), number(summary, " ahead, "));
  EXPECT_EQ(number(text, "full speed takes a clearance of "),
            number(summary, "full speed needs a clearance of "));
  EXPECT_EQ(number(text, "control returns at a clearance of "),
            number(summary, "control returns at "));
  EXPECT_NE(text.find("recovery back_off: retreats within room"), std::string::npos) << text;
}

TEST_F(ExplainRobot, AZoneHasItsTables) {
  const std::string text = at("zone room");
  EXPECT_NE(text.find("widest place: clearance "), std::string::npos) << text;
  EXPECT_NE(text.find("tables: "), std::string::npos) << text;
}

TEST_F(ExplainRobot, LimitsAreThoseOfTheKernel) {
  EXPECT_NE(at("latency").find("part of every horizon"), std::string::npos);
  EXPECT_NE(at("body").find("radius: "), std::string::npos);
  EXPECT_NE(at("always  clearance").find("`clearance(d, room)`\n  type: real [m]\n  range: "),
            std::string::npos);
}

// The bytes of the state are those that a compiler finds in the generated struct.
TEST_F(ExplainRobot, BytesAreThoseOfTheStruct) {
  ASSERT_EQ(rtac({"build", "fence.rta", "-o", "out"}).status, 0);
  write("size.c",
        "#include <stdio.h>\n#include \"out/fence_kernel.h\"\n"
        "int main(void) { printf(\"state: %u bytes\", (unsigned)sizeof(fence_study_fly_state)); }");
  ASSERT_EQ(std::system("cc -o size size.c && ./size > size.txt"), 0);
  const std::string text = at("decision fly");
  EXPECT_NE(text.find(read("size.txt") + " a robot\n"), std::string::npos)
      << text << read("size.txt");
}

// Robots that only monitors without a robot speak of: what counts there, and what does not.
TEST_F(Explain, ARobotWithoutADecision) {
  write("door.rta",
        "spec tower;\nperiod 100 ms;\n"
        "robot Rover {\n"
        "  body radius 10 cm;\n"
        "  motion point { speed <= 0.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
        "  sense position : point error 1 cm max_age 100 ms;\n"
        "  sense velocity : vector error 1 cm/s max_age 100 ms;\n"
        "  output push : acceleration;\n"
        "  latency 20 ms;\n"
        "}\n"
        "fleet one, two : Rover;\n"
        "fleet more : Rover[9];\n"
        "zone yard = rectangle (0 m, 0 m) to (9 m, 9 m);\n"
        "monitor apart { \"R1: apart\" always distance(one, two) >= 10 cm; }\n"
        "monitor in { \"R2: in\" always forall r : Rover, r != one : r inside yard; }\n");
  EXPECT_EQ(about(3, "robot Rover"),
            "robot Rover\n"
            "  no decision: monitors without a robot judge where it is and how it moves\n");
  EXPECT_NE(at(4).find("radius: 0.1 m\n  gaps between bodies are those of the centres"),
            std::string::npos);
  EXPECT_NE(at(5).find("more than 0.5 m/s along one of the axes"), std::string::npos);
  EXPECT_EQ(about(6, "sense position"),
            "sense position\n  error 0.01 m\n  unknown when older than 100 ms\n"
            "  inputs: one.position, two.position, more[0].position, more[1].position, "
            "more[2].position, more[3].position and 5 more\n");
  EXPECT_NE(at(7).find("no monitor speaks of it\n"), std::string::npos);
  EXPECT_NE(at(9).find("latency: 20 ms\n  a decision alone makes use of it\n"), std::string::npos);
  EXPECT_NE(at(11).find("robot two : Rover\n  no decision: "), std::string::npos);
  EXPECT_NE(at(12).find("fleet more : Rover, 9 robots\n  no decision: "), std::string::npos);
}

// Robots whose plans alone are judged: what is declared of them does not count there.
TEST_F(Explain, ARobotWithADecisionOnPlans) {
  const std::string robot =
      "spec yard;\n"
      "zone room = rectangle (0 m, 0 m) to (9 m, 9 m);\n"
      "robot Rover {\n"
      "  body radius 10 cm;\n"
      "  motion point { speed <= 0.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
      "  sense position : point error 1 cm max_age 100 ms;\n"
      "  sense velocity : vector error 1 cm/s max_age 100 ms;\n"
      "  input plan : path[16] tracking <= 10 cm;\n"
      "  output push : acceleration;\n"
      "  latency 20 ms;\n"
      "}\n"
      "fleet one : Rover;\n"
      "controller dreamer : advanced for Rover extern;\n"
      "controller careful : safe for Rover extern;\n"
      "monitor ok for r : Rover { \"R1: in\" always r.plan inside shrink(room, 20 cm); }\n"
      "decision choose for Rover { advanced dreamer; safe careful; on plan; priority ok; }\n";
  write("door.rta", robot);
  EXPECT_NE(at(3).find("decision choose judges the lines of its plans"), std::string::npos);
  EXPECT_EQ(
      about(4, "radius: 0.1 m"),
      "radius: 0.1 m\n  decision choose does not count it: what a body needs beside the lines "
      "of a plan its zones leave, as `shrink(zone, length)` does\n");
  EXPECT_NE(at(5).find("does not count it: a plan says where it leads"), std::string::npos);
  EXPECT_NE(at(6).find("decision choose does not count it: it judges plans"), std::string::npos);
  EXPECT_NE(at(7).find("decision choose does not count it"), std::string::npos);
  EXPECT_NE(at(8).find("it does not count `tracking`"), std::string::npos);
  EXPECT_NE(at(10).find("decision choose does not count it\n"), std::string::npos);
  EXPECT_NE(at(12).find("decision choose judges its plans\n"), std::string::npos);
  write("door.rta",
        robot +
            "period 100 ms;\nmonitor near { \"R2: near\" always distance(one, (1 m, 1 m)) >= 1 "
            "m; }\n");
  EXPECT_NE(at(4).find("in monitors without a robot gaps between bodies"), std::string::npos);
  EXPECT_NE(at(6).find("inputs: one.position\n"), std::string::npos);
}

// Zones that others are made of have no tables, and still lie somewhere.
TEST_F(Explain, AZoneThatNoMonitorAsksFor) {
  write("door.rta",
        "spec yard;\nperiod 1 s;\n"
        "zone lab = rectangle (0 m, 0 m) to (9 m, 9 m);\n"
        "zone far = complement(lab);\n"
        "zone hall = lab | rectangle (3 m, 3 m) to (20.5 m, 5 m);\n"
        "zone shop = prism (hall) from 1 m to 4 m;\n"
        "zone school = rectangle (0 m, 0 m) to (9 m, 9 m) during monday 08:00 .. 12:00;\n"
        "clock utc;\n"
        "input open : bool;\nmonitor m { \"R1: open\" always open; }\n");
  const std::string without = "  no monitor asks for it: modules have no table of it\n";
  EXPECT_EQ(about(3, "zone lab"),
            "zone lab\n  4 vertices, x from 0 m to 9 m, y from 0 m to 9 m\n" + without);
  EXPECT_EQ(about(4, "zone far"),
            "zone far\n  every place within 536 km of (0 m, 0 m) that lab does not have\n"
            "  it takes no table of its own\n");
  EXPECT_EQ(about(5, "zone hall"),
            "zone hall\n  8 vertices, x from 0 m to 20.5 m, y from 0 m to 9 m\n" + without);
  EXPECT_EQ(
      about(6, "zone shop"),
      "zone shop\n  8 vertices, x from 0 m to 20.5 m, y from 0 m to 9 m, z from 1 m to 4 m\n" +
          without);
  EXPECT_EQ(about(7, "zone school"),
            "zone school\n  4 vertices, x from 0 m to 9 m, y from 0 m to 9 m\n" + without);
}

TEST_F(Explain, AZoneThatMonitorsWithoutARobotAskFor) {
  write("door.rta",
        "spec yard;\nperiod 1 s;\n"
        "zone lab = rectangle (0 m, 0 m) to (9 m, 9 m);\n"
        "zone hut = rectangle (20 m, 0 m) to (29 m, 9 m);\n"
        "zone far = complement(hut);\n"
        "input p : point in -90 .. 90 m;\n"
        "input noise : length in 0 .. 9 m;\n"
        "monitor m { \"R1: in the lab\" always p inside far; }\n"
        "monitor n { \"R2: apart\" always distance(lab, hut) >= noise; }\n");
  EXPECT_EQ(at(5).find("no monitor asks"), std::string::npos) << at(5);
  EXPECT_NE(about(3, "zone lab").find("ask how far it is from others"), std::string::npos);
}

// The windows of a zone, on each of its lines, whether a monitor speaks of it or not.
TEST_F(Explain, AZoneThatIsThereAtCertainTimes) {
  write("door.rta",
        "spec fair;\nperiod 1 s;\nclock utc;\n"
        "zone school = rectangle (0 m, 0 m) to (9 m, 9 m)\n"
        "  during monday, friday 08:00 .. 12:00\n"
        "    or 2026-05-01T08:00Z .. 2026-05-01T18:00Z;\n"
        "input open : bool;\nmonitor m { \"R1: open\" always open; }\n");
  for (const int line : {4, 5, 6}) {
    EXPECT_EQ(about(line, "zone school is there at certain times"),
              "zone school is there at certain times\n"
              "  monday, friday 08:00:00 .. 12:00:00, UTC\n"
              "  2026-05-01T08:00:00Z .. 2026-05-01T18:00:00Z, UTC\n"
              "  outside of that it is empty: nothing is inside, and it is far from all\n");
  }
}

}  // namespace
}  // namespace rtac::driver::test
