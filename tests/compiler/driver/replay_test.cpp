// `rtac replay`: findings of a trace, by the generated code and by the reference interpreter.
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/compiler/driver/testing.h"

namespace rtac::driver::test {
namespace {

using nlohmann::literals::operator""_json_pointer;

const char* const door = R"(spec door;
period 10 ms;
enum  Gear { park, drive }
input open : bool;
input speed : real [m/s] in 0 m/s .. 3 m/s max_age 20 ms;
input battery : ratio in 0 % .. 100 % max_age inf;
input gear : Gear max_age inf;
param limit : real [m/s] in 0.1 m/s .. 0.5 m/s = 0.3 m/s;
monitor slow { "R7: no driving with an open door"
  always once[0 s, 20 ms] open implies speed <= limit; }
monitor charged { "R8: enough charge" always battery >= 20 % or gear == park; }
)";
const char* const ride =
    "time,open,speed,battery,gear\n"
    "0,true,0.1,0.25,drive\n"
    "0.01,false,0.5,,\n"
    "0.02,false,,0.15,park\n"
    "0.04,false,nan,,drive\n";

class Replay : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("door.rta", door);
    write("ride.csv", ride);
  }
  void TearDown() override {
    unsetenv("CC");
    InFolder::TearDown();
  }
};
using ReplayCode = Replay;

class ReplayBy : public Replay, public ::testing::WithParamInterface<std::string> {
 protected:
  static Outcome replay(std::vector<std::string> words) {
    words.insert(words.begin(), "replay");
    words.insert(words.end(), {"--engine", GetParam()});
    return rtac(words);
  }
};

// A fence that is none is told, not taken for unknown in every tick.
TEST_P(ReplayBy, FaultyZonesAreRefused) {
  const std::string bow = "polygon [(0 m, 0 m), (5 m, 5 m), (5 m, 0 m), (0 m, 5 m)]";
  const std::string none = "circle (0 m, 0 m) radius 1 m & circle (9 m, 9 m) radius 1 m";
  write("walk.csv", "time,p.x,p.y\n0,1,1\n");
  for (const auto& [zone, code] : {std::pair(bow, "error[4001]"), std::pair(none, "error[4007]")}) {
    write("walk.rta", "spec walk;\nperiod 1 s;\ninput p : point in -9 .. 9 m;\nzone fence = " +
                          zone + ";\nmonitor in { \"R1: in\" always p inside fence; }\n");
    const Outcome o = replay({"walk.rta", "walk.csv"});
    EXPECT_EQ(o.status, 1);
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find(code), std::string::npos) << o.err;
  }
}

// One line a tick that a row stands for; the margin is that of the deciding atom in its own unit.
TEST_P(ReplayBy, FindingsOfEveryTick) {
  const Outcome o = replay({"door.rta", "ride.csv"});
  EXPECT_EQ(o.status, 3) << o.err;
  EXPECT_EQ(o.err, "");
  EXPECT_EQ(o.out,
            "tick,time,slow.verdict,slow.margin,slow.unit,charged.verdict,charged.margin,"
            "charged.unit\n"
            "0,0,true,0.2,m/s,true,5,%\n"
            "1,0.01,false,-0.2,m/s,true,5,%\n"
            "2,0.02,false,-0.2,m/s,true,inf,\n"
            "4,0.04,unknown,-inf,,false,-5,%\n");
}

// Language, rule 4.4: whichever of several infinite ends decides, none of them has a unit.
TEST_P(ReplayBy, InfiniteMarginsHaveNoUnit) {
  write("units.rta",
        "spec units; period 1 s;\n"
        "input q : bool;\ninput x : real [m] in 0 .. 9 m;\n"
        "monitor same { \"R1\" always q iff (x >= 2 m); }\n"
        "monitor since_q { \"R2\" always x >= 2 m since q; }\n"
        "monitor each { \"R3\" always historically[0 s, 2 s](q implies x >= 2 m); }\n"
        "monitor before { \"R4\" always previously(q iff x >= 2 m); }\n"
        "monitor plain { \"R5\" always x >= 2 m; }\n");
  write("units.csv", "time,q,x\n0,1,3\n1,0,3\n2,nan,3\n3,1,nan\n4,0,1\n5,0,nan\n6,nan,nan\n");
  EXPECT_EQ(replay({"units.rta", "units.csv"}).out,
            "tick,time,same.verdict,same.margin,same.unit,since_q.verdict,since_q.margin,"
            "since_q.unit,each.verdict,each.margin,each.unit,before.verdict,before.margin,"
            "before.unit,plain.verdict,plain.margin,plain.unit\n"
            "0,0,true,1,m,true,inf,,true,1,m,false,-inf,,true,1,m\n"
            "1,1,false,-1,m,true,1,m,true,1,m,true,1,m,true,1,m\n"
            "2,2,unknown,-1,m,true,1,m,true,1,m,false,-1,m,true,1,m\n"
            "3,3,unknown,-inf,,true,inf,,unknown,-inf,,unknown,-1,m,unknown,-inf,\n"
            "4,4,true,1,m,false,-1,m,unknown,-inf,,unknown,-inf,,false,-1,m\n"
            "5,5,unknown,-inf,,false,-inf,,unknown,-inf,,true,1,m,unknown,-inf,\n"
            "6,6,unknown,-inf,,unknown,-inf,,unknown,-inf,,unknown,-inf,,unknown,-inf,\n");
}

TEST_P(ReplayBy, WithoutAViolationTheExitCodeIs0) {
  write("calm.csv", "time,open,speed,battery,gear\n0,0,0,1,park\n");
  EXPECT_EQ(replay({"door.rta", "calm.csv"}).status, 0);
}

// The others are neither printed nor do they count.
TEST_P(ReplayBy, OneMonitorAlone) {
  write("slow.csv", "time,open,speed,battery,gear\n0,1,1,1,park\n");
  const Outcome o = replay({"door.rta", "slow.csv", "--monitor", "charged"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(o.out, "tick,time,charged.verdict,charged.margin,charged.unit\n0,0,true,inf,\n");
}

// More rows than ticks: what arrives in between is seen at the next tick.
TEST_P(ReplayBy, RowsBetweenTicksCarrySamples) {
  write("dense.csv", "time,open,speed,battery,gear\n0,1,0,1,park\n0.004,,0.4,,\n0.01,0,,,\n");
  const Outcome o = replay({"door.rta", "dense.csv", "--monitor", "slow"});
  EXPECT_EQ(o.out,
            "tick,time,slow.verdict,slow.margin,slow.unit\n0,0,true,0.3,m/s\n"
            "1,0.01,false,-0.1,m/s\n");
}

// Rule 4.1: a comparison of constants has a margin, and a minimum with it is no more than that.
TEST_P(ReplayBy, ComparisonsOfConstantsHaveMargins) {
  write("fixed.rta",
        "spec fixed; period 100 ms; input p : bool; input x : real [m] in 0 .. 9 m;\n"
        "monitor a { \"R1\" always x >= 1 m and 2 m > 1.5 m; }\n"
        "monitor b { \"R2\" always once[0 s, 1 s] (3 m > 1 m and p); }\n"
        "monitor c { \"R3\" always if p then x >= 1 m else 2 m > 1.5 m; }\n"
        "monitor d { \"R4\" always not (1 m > 1 m) and x >= 1 m; }\n"
        "monitor e { \"R5\" always x >= 9 m or 1 m <= 1 m / 3; }\n"
        "monitor f { \"R6\" always x >= 1 m and 1e30 m > 1 m; }\n");
  write("fixed.csv", "time,p,x\n0,1,8\n0.1,0,8\n");
  const Outcome o = replay({"fixed.rta", "fixed.csv"});
  const std::string rest = ",true,0,m,false,-0.666667,m,true,7,m\n";
  const std::string rows =
      "\n0,0,true,0.5,m,true,2,m,true,7,m" + rest + "1,0.1,true,0.5,m,true,2,m,true,0.5,m" + rest;
  EXPECT_NE(o.out.find(rows), std::string::npos) << o.out << o.err;
}

// Rule 7.6: what a robot would refuse is no trace of it.
TEST_P(ReplayBy, AnInvalidZoneIsRefusedWithItsVertex) {
  write("fence.rta",
        "spec f; period 1 s;\n"
        "input fence : zone[4] max_age inf;\n"
        "input p : point;\n"
        "monitor m { \"R1\" always p inside fence; }\n");
  const auto replayed = [&](const std::string& cell) {
    write("zones.csv",
          "time,fence,p.x,p.y\n0,\"POLYGON ((0 0, 9 0, 9 9, 0 0))\",8,1\n1," + cell + ",8,1\n");
    return replay({"fence.rta", "zones.csv"});
  };
  const Outcome good = replayed("");
  EXPECT_EQ(good.status, 0) << good.err;
  EXPECT_NE(good.out.find("\n1,1,true"), std::string::npos) << good.out;
  for (const auto& [cell, why] : std::vector<std::pair<std::string, std::string>>{
           {"\"POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))\"", "the outer ring, vertex 1: starts an edge"},
           {"\"POLYGON ((0 0, 2 0, 3 1, 2 2, 0 2, 0 0))\"", "has 5 vertices, 4 are the most"},
           {"\"POLYGON ((0 0, 2 0, 3 1))\"", "column 10, position 3: the ring is open"},
           {"\"POLYGON ((0 0, 0.0001 0, 0 0.0001, 0 0))\"", "nothing left on the grid"},
           {"5", "`fence` is refused"}}) {
    const Outcome bad = replayed(cell);
    EXPECT_EQ(bad.status, 2) << cell;
    EXPECT_EQ(bad.out, "");
    EXPECT_NE(bad.err.find("error[9004]: `fence` is refused"), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find(" --> zones.csv:3:3\n"), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find(why), std::string::npos) << bad.err;
  }
}

// Of a robot that no decision is about only what monitors use is needed; what else is known of it
// may be there.
TEST_P(ReplayBy, OtherColumnsOfARobotAreIgnored) {
  write("tower.rta",
        "spec tower; period 1 s;\n"
        "robot Rover {\n"
        "  body radius 10 cm;\n"
        "  motion point { speed <= 0.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
        "  sense position : point error 1 cm max_age 2 s;\n"
        "  sense velocity : vector error 1 cm/s max_age 1 s;\n"
        "  sense battery : ratio error 1 % max_age 3 s;\n"
        "  output push : acceleration;\n"
        "  latency 20 ms;\n"
        "}\n"
        "fleet one, two : Rover;\n"
        "monitor alive { \"R1\" always one.battery >= 20 %; }\n");
  write("bare.csv", "time,one.battery\n0,0.5\n");
  write("wide.csv", "time,one.battery,one.velocity.x,two.position.y\n0,0.5,0.1,\n");
  write("wrong.csv", "time,one.battery,one.speed\n0,0.5,0.1\n");
  write("empty.csv", "time,one.velocity.x\n0,0.1\n");
  const Outcome bare = replay({"tower.rta", "bare.csv"});
  EXPECT_NE(bare.out.find("true,29,%"), std::string::npos) << bare.out << bare.err;
  const Outcome wide = replay({"tower.rta", "wide.csv"});
  EXPECT_EQ(wide.out, bare.out) << wide.err;
  EXPECT_NE(replay({"tower.rta", "wrong.csv"}).err.find("no input is called `one.speed`"),
            std::string::npos);
  EXPECT_NE(replay({"tower.rta", "empty.csv"}).err.find("the column `one.battery` is missing"),
            std::string::npos);
}

TEST_P(ReplayBy, AFaultInTheLastRowLeavesNothingOnStandardOutput) {
  std::string trace = "time,open,speed,battery,gear\n";
  for (int i = 0; i < 200000; ++i) trace += std::to_string(i) + ",1,0,1,park\n";
  write("long.csv", trace + "200000,1,fast,1,park\n");
  const Outcome o = replay({"door.rta", "long.csv"});
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.out, "");
  EXPECT_NE(o.err.find("`fast` is no value of `speed`\n      --> long.csv:200002:10\n"),
            std::string::npos)
      << o.err;
}

TEST_P(ReplayBy, LongOutputIsComplete) {
  std::string trace = "time,open,speed,battery,gear\n";
  for (int i = 0; i < 100000; ++i) trace += std::to_string(i) + ",1,0,1,park\n";
  write("long.csv", trace);
  const Outcome o = replay({"door.rta", "long.csv"});
  EXPECT_EQ(o.status, 0) << o.err;
  EXPECT_EQ(std::count(o.out.begin(), o.out.end(), '\n'), 100001);
  EXPECT_GT(o.out.size(), std::size_t{2} << 20);
}

// Also where no tables are made: no robot could run it.
TEST_P(ReplayBy, ZonesBeyondTheGridAreRefused) {
  const auto refused = [&](const std::string& zone, const std::string& type) {
    write("far.rta", "spec far; period 1 s;\nzone z = " + zone + ";\ninput p : " + type +
                         " in -99 .. 99 m;\nmonitor kept { \"R1\" always p inside z; }\n");
    write("far.csv", type == "point" ? "time,p.x,p.y\n0,1,1\n" : "time,p.x,p.y,p.z\n0,1,1,1\n");
    const Outcome o = replay({"far.rta", "far.csv"});
    return o.status == 1 &&
           o.err.find("error[4009]: the zone reaches beyond the grid of 1 mm") != std::string::npos;
  };
  EXPECT_TRUE(refused("rectangle (0 m, 0 m) to (600 km, 1 km)", "point"));
  EXPECT_TRUE(refused("prism (rectangle (0 m, 0 m) to (600 km, 1 km)) from 0 m to 9 m", "point3"));
  EXPECT_TRUE(refused("prism (rectangle (0 m, 0 m) to (1 km, 1 km)) from 0 m to 600 km", "point3"));
  EXPECT_FALSE(refused(
      "rectangle (0 m, 0 m) to (600 km, 1 km) & rectangle (0 m, 0 m) to (9 m, 9 m)", "point"));
}

INSTANTIATE_TEST_SUITE_P(Engines, ReplayBy, ::testing::Values("kernel", "interp"),
                         [](const auto& engine) { return engine.param; });

TEST_F(ReplayCode, bad_trace) {
  write("faulty.csv", "time,open,sped\n");
  const Outcome o = rtac({"replay", "door.rta", "faulty.csv", "--engine", "interp"});
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.out, "");
  EXPECT_EQ(o.err,
            "error[9004]: no input is called `sped`\n"
            " --> faulty.csv:1:11\n"
            "  |\n"
            "1 | time,open,sped\n"
            "  |           ^^^^\n"
            "  |\n"
            "help: did you mean `speed`?\n\n1 error\n");
}

// Tools find the cell in the trace, also where it is behind much that was not kept.
TEST_F(ReplayCode, FaultsOfATraceHaveAPlaceForTools) {
  std::string rows = "time,open,speed,battery,gear\n";
  while (rows.size() < 200'000) rows += std::to_string(rows.size()) + ",1,0,1,park\n";
  const auto line = 1 + std::count(rows.begin(), rows.end(), '\n');
  write("long.csv", rows + std::to_string(rows.size()) + ", \xC2\xB5,0,1,park\n");
  const auto report = [](const std::string& format) {
    const Outcome o = rtac({"replay", "door.rta", "long.csv", "--engine", "interp", format});
    EXPECT_EQ(o.status, 2);
    return nlohmann::json::parse(o.err);
  };
  const auto place = [&](std::size_t column) -> nlohmann::json {
    return {{"line", line}, {"column", column}, {"offset", rows.size() + column - 1}};
  };
  const nlohmann::json json = report("--format=json")[0];
  EXPECT_EQ(json["message"], "`\xC2\xB5` is no value of `open`");
  const nlohmann::json location = {{"file", "long.csv"}, {"begin", place(9)}, {"end", place(11)}};
  EXPECT_EQ(json["location"], location);
  const nlohmann::json log = report("--format=sarif");
  const nlohmann::json physical =
      log["/runs/0/invocations/0/toolExecutionNotifications/0"
          "/locations/0/physicalLocation"_json_pointer];
  const nlohmann::json region = {
      {"startLine", line}, {"startColumn", 9}, {"endLine", line}, {"endColumn", 10}};
  EXPECT_EQ(physical["artifactLocation"]["uri"], "long.csv");
  EXPECT_EQ(physical["region"], region);
}

TEST_P(ReplayBy, OfATraceWithoutARowThereAreNoFindings) {
  write("none.csv", "time,open,speed,battery,gear\n");
  const Outcome o = replay({"door.rta", "none.csv"});
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.out, "");
  EXPECT_NE(o.err.find("error[9004]: the trace ends without a row\n --> none.csv:2:1\n"),
            std::string::npos)
      << o.err;
}

TEST_F(ReplayCode, no_kernel) {
  setenv("CC", "no-such-compiler -O0", 1);
  const Outcome o = rtac({"replay", "door.rta", "ride.csv"});
  EXPECT_EQ(o.status, 2);
  EXPECT_EQ(o.out, "");
  EXPECT_NE(o.err.find("error[9005]: the C compiler `no-such-compiler` cannot be started"),
            std::string::npos)
      << o.err;
  setenv("CC", "false", 1);
  EXPECT_NE(rtac({"replay", "door.rta", "ride.csv"}).err.find("`false` does not compile"),
            std::string::npos);
}

// What is shown of a margin is never more than there is.
TEST_F(Replay, TheInterpreterRoundsMarginsDown) {
  write("far.rta",
        "spec far; period 1 s; input x : real [m] in 0 .. 1000 km;\n"
        "monitor third { \"R1\" always x / 3 >= 0 m; }\n"
        "monitor above { \"R2\" always x / 3 <= 0 m; }\n"
        "monitor far { \"R3\" always x >= 0.3 m; }\n");
  write("far.csv", "time,x\n0,2\n1,0.000002\n2,999999.9990000001\n");
  const Outcome o = rtac({"replay", "far.rta", "far.csv", "--engine", "interp"});
  EXPECT_EQ(o.out,
            "tick,time,third.verdict,third.margin,third.unit,above.verdict,above.margin,"
            "above.unit,far.verdict,far.margin,far.unit\n"
            "0,0,true,0.666666,m,false,-0.666667,m,true,1.7,m\n"
            "1,1,true,0.000000666666,m,false,-0.000000666667,m,false,-0.299998,m\n"
            "2,2,true,333333.333,m,false,-333333.333001,m,true,999999.699,m\n")
      << o.err;
}

// Language, rule 4.4: to the side on which less is known, so that a verdict never follows from it.
TEST_F(Replay, TheKernelCutsFarMargins) {
  write("vast.rta",
        "spec vast; period 1 s;\n"
        "input x : real [m] in -1e12 m .. 1e12 m resolution 1 m;\n"
        "monitor above { \"R1\" always x >= 0 m; }\n"
        "monitor below { \"R2\" always x <= 0 m; }\n");
  write("vast.csv", "time,x\n0,499999999999\n1,600000000000\n2,-600000000000\n");
  const std::string head =
      "tick,time,above.verdict,above.margin,above.unit,below.verdict,below.margin,below.unit\n"
      "0,0,true,499999999999,m,false,-499999999999,m\n";
  EXPECT_EQ(rtac({"replay", "vast.rta", "vast.csv"}).out,
            head +
                "1,1,true,499999999999,m,false,-inf,\n"
                "2,2,false,-inf,,true,499999999999,m\n");
  EXPECT_EQ(rtac({"replay", "vast.rta", "vast.csv", "--engine", "interp"}).out,
            head +
                "1,1,true,600000000000,m,false,-600000000000,m\n"
                "2,2,false,-600000000000,m,true,600000000000,m\n");
}

TEST_F(Replay, TheFilesOfTheKernelAreRemoved) {
  fs::create_directories("temporary");
  setenv("TMPDIR", fs::absolute("temporary").c_str(), 1);
  EXPECT_EQ(rtac({"replay", "door.rta", "ride.csv"}).status, 3);
  unsetenv("TMPDIR");
  EXPECT_TRUE(fs::is_empty("temporary"));
}

TEST_F(Replay, WhatCannotBeReplayedIsAUsageError) {
  write("none.rta", "spec none;");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"replay", "door.rta"}, "no trace is given"},
      {{"replay", "-", "-"}, "cannot both come from standard input"},
      {{"replay", "door.rta", "missing.csv"}, "cannot read `missing.csv`"},
      {{"replay", "door.rta", "."}, "cannot read `.`: it is a directory"},
      {{"replay", "door.rta", "ride.csv", "--engine", "magic"}, "unknown engine `magic`"},
      {{"replay", "door.rta", "ride.csv", "--monitor", "slo"}, "did you mean `slow`?"},
      {{"replay", "door.rta", "ride.csv", "-o", "x"}, "`rtac replay` has no flag `-o`"},
      {{"check", "door.rta", "--engine", "interp"}, "`rtac check` has no flag `--engine`"},
      {{"replay", "none.rta", "ride.csv", "--engine", "interp"}, "has no monitor"},
  };
  for (const auto& [words, message] : cases) {
    const Outcome o = rtac(words);
    EXPECT_EQ(o.status, 2) << message;
    EXPECT_EQ(o.out, "");
    EXPECT_NE(o.err.find(message), std::string::npos) << o.err;
  }
}

TEST_F(Replay, AFaultySpecificationIsReportedAsByCheck) {
  write("faulty.rta", "spec s; period 1 s; input p : bool; monitor m { \"R: r\" always q; }");
  const Outcome o = rtac({"replay", "faulty.rta", "ride.csv"});
  EXPECT_EQ(o.status, 1);
  EXPECT_EQ(o.err, rtac({"check", "faulty.rta"}).err);
}

// ---- the other commands -------------------------------------------------------------------------

TEST_F(ReplayCode, too_many_bytes) {
  const Outcome refused = rtac({"build", "door.rta", "-o", "out", "--max-bytes", "1"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("error[9007]"), std::string::npos) << refused.err;
  EXPECT_FALSE(fs::exists("out"));
  EXPECT_EQ(rtac({"build", "door.rta", "-o", "out", "--max-bytes", "100000"}).status, 0);
  EXPECT_EQ(rtac({"check", "door.rta", "--max-bytes", "4k"}).status, 2);
}

// What points are held against takes memory, too: 24 bytes an edge.
TEST_F(Replay, TablesOfZonesCountAsMemory) {
  write("place.rta",
        "spec place; period 1 s; zone room = rectangle (0 m, 0 m) to (5 m, 5 m);\n"
        "input p : point in -9 .. 9 m; monitor m { \"R: in\" always p inside room; }\n");
  EXPECT_EQ(rtac({"check", "place.rta", "--max-bytes", "144"}).status, 0);
  const Outcome refused = rtac({"check", "place.rta", "--max-bytes", "143"});
  EXPECT_NE(refused.err.find("and the tables of their zones remember 144 bytes"), std::string::npos)
      << refused.err;
}

// Without a limit the machine of whoever runs it would be it.
TEST_F(Replay, MonitorsThatFillTheMemoryAreRefusedByDefault) {
  write("big.rta",
        "spec big; period 1 ms; input x : real in 0 .. 9;\n"
        "monitor m { \"R1: x\" always min[0 s, 1000 h](x) >= 3; }");
  write("big.csv", "time,x\n0,1\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "big.rta"}, {"replay", "big.rta", "big.csv"}}) {
    const Outcome o = rtac(words);
    EXPECT_EQ(o.status, 1);
    EXPECT_NE(o.err.find("remember 115200000160 bytes; at most 268435456 are allowed"),
              std::string::npos)
        << o.err;
  }
  EXPECT_EQ(rtac({"check", "big.rta", "--max-bytes", "115200000160"}).status, 0);
}

// So are those of robots, of which each remembers its own.
TEST_F(Replay, MonitorsOfARobotThatFillTheMemoryAreRefused) {
  const std::string longer = edited(drone_spec(), "clearance(d, room) >= 10 cm;",
                                    "d inside room and min[0 s, 1000 h](x) >= 3;");
  write("fence.rta", longer + "input x : real in 0 .. 9 max_age 1 s;\n");
  const Outcome o = rtac({"check", "fence.rta"});
  EXPECT_EQ(o.status, 1);
  EXPECT_NE(o.err.find("error[9007]: the monitors of one robot in `fly` remember "),
            std::string::npos)
      << o.err;
  EXPECT_EQ(rtac({"check", "fence.rta", "--max-bytes", "10000000000"}).status, 0);
}

// More than any address space has.
TEST_F(Replay, MemoryThatIsNotThereIsNoBug) {
  std::string text = "spec vast; period 1 ms; input x : real in 0 .. 9;\n";
  for (const char* const name : {"a", "b", "c", "d", "e"}) {
    text.append("monitor ").append(name) += " { \"R1: x\" always min[0 s, 300000 h](x) >= 3; }\n";
  }
  write("vast.rta", text);
  write("vast.csv", "time,x\n0,1\n");
  const Outcome o = rtac({"replay", "vast.rta", "vast.csv", "--max-bytes", "172800000000544"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("remember 172800000000544 bytes, which this machine cannot give"),
            std::string::npos)
      << o.err;
}

// A page is there for every code; should one be missing, the program says so.
TEST_F(ReplayCode, no_page) {
  for (const std::string word : {"9004", "E9004", "error[9004]", "bad_trace"}) {
    const Outcome o = rtac({"explain", word});
    if (o.status == 0) {
      EXPECT_NE(o.out.find("bad_trace"), std::string::npos) << o.out;
    } else {
      EXPECT_NE(o.err.find("error[9006]: no page about 9004"), std::string::npos) << o.err;
    }
  }
  const Outcome o = rtac({"explain", "bad_trase"});
  EXPECT_EQ(o.status, 2);
  EXPECT_NE(o.err.find("did you mean `bad_trace`?"), std::string::npos) << o.err;
}

TEST_F(Replay, FmtRewritesTheFilesThatNeedIt) {
  EXPECT_EQ(rtac({"fmt", "door.rta"}).status, 0);
  const std::string formatted = read("door.rta");
  EXPECT_NE(formatted, door);
  const Outcome good = rtac({"fmt", "--check", "door.rta"});
  EXPECT_EQ(good.status, 0);
  EXPECT_EQ(good.out, "");
  write("other.rta", door);
  const Outcome bad = rtac({"fmt", "--check", "door.rta", "other.rta"});
  EXPECT_EQ(bad.status, 1);
  EXPECT_EQ(bad.out, "other.rta\n");
  EXPECT_EQ(read("other.rta"), door);
}

// One of two files has a mistake: neither is written.
TEST_F(Replay, FmtChangesNothingWhenAFileHasMistakes) {
  write("faulty.rta", "spec s; period 1 s");
  const Outcome o = rtac({"fmt", "door.rta", "faulty.rta"});
  EXPECT_EQ(o.status, 1);
  EXPECT_NE(o.err.find("faulty.rta:1:"), std::string::npos) << o.err;
  EXPECT_EQ(read("door.rta"), door);
  EXPECT_EQ(rtac({"fmt", "missing.rta"}).status, 2);
}

TEST_F(Replay, SarifHoldsTheSameReports) {
  write("faulty.rta", "spec s; period 1 s; input p : bool; monitor m { \"R: r\" always q; }");
  const Outcome o = rtac({"check", "faulty.rta", "--format", "sarif"});
  EXPECT_EQ(o.status, 1);
  EXPECT_NE(o.err.find("\"version\": \"2.1.0\""), std::string::npos);
  EXPECT_NE(o.err.find("faulty.rta"), std::string::npos);
}

}  // namespace
}  // namespace rtac::driver::test
