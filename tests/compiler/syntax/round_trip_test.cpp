// The printed text of a tree is that tree: parsing it again gives the same, places apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/compiler/syntax/syntax_test_util.h"

namespace rtac::syntax {
namespace {

void expect_round_trip(const std::string& text) {
  Parsed first{text};
  ASSERT_EQ(first.messages(), "") << text;
  const std::string printed = print(first.file);
  Parsed second{printed};
  ASSERT_EQ(second.messages(), "") << printed;
  EXPECT_EQ(strip_places(first.tree()), strip_places(second.tree())) << printed;
  EXPECT_EQ(print(second.file), printed);
}

std::vector<std::filesystem::path> all_specs() {
  std::vector<std::filesystem::path> result;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(RTAC_SOURCE_DIR "/specs")) {
    if (entry.path().extension() == ".rta") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(RoundTrip, KeepsWindowsOfTime) {
  expect_round_trip(
      "clock utc;\nzone a = b during monday, friday 07:30 .. 16:00 or 22:00 .. 24:00;");
  expect_round_trip("zone a = b during 2026-05-01T08:00:30Z .. 2026-05-01T18:00Z;");
  expect_round_trip("zone a = b around c during 07:30 .. 16:00;\nzone d = e around bots[2 + 1];");
  expect_round_trip("input a, b : zone[64] @ gps max_age inf;\ninput c : zone;");
  expect_round_trip("input clock, during, around : bool;\nzone a = during during 07:30 .. 16:00;");
}

TEST(RoundTrip, KeepsPrisms) {
  expect_round_trip(
      "zone a = prism (b - c) from -5 m to from | rectangle (1 m, 2 m, 3 m) to (4 m, 5 m, 6 m);");
  expect_round_trip("zone from = prism (a) from -(1 m + 2 m) to --to - prism b from 0 m to c.d;");
  expect_round_trip("zone a = circle (1 m, 2 m) radius -3 m - circle (b, c) radius -(4 m - c);");
}

// `box` is a shape in front of two corners, and a name elsewhere.
TEST(RoundTrip, KeepsBoxes) {
  expect_round_trip("zone box = box (1 m, 2 m, 3 m) to (4 m, 5 m, 6 m) - box;");
  expect_round_trip(
      "zone a = grow(box (1 m, 2 m, 3 m) to (box, -b, c.z), box) & box | box\n (a, b, c) to (d, e, "
      "f);");
  expect_round_trip("zone a = box /* a */ (1 m, b, c) // b\n to (d, e, f);");
  expect_round_trip("site box(box) = (1 m, 2 m);\nfleet box, boxes : box;\nzone a = boxes(b, c);");
  expect_round_trip("fun box(x : real) : real = x;\nmonitor m { always box(1) <= box (2); }");
}

TEST(RoundTrip, KeepsTemplates) {
  expect_round_trip("controller a : safe for b = brake_and_hold;");
  expect_round_trip("controller loiter : safe for land = loiter within sequence speed 1 m/s;");
  expect_round_trip("controller a : safe for b = land;");
  // the `for` of a step is none of the speed before it
  expect_round_trip(
      "controller a : safe for b = sequence retreat within c speed d + 1 m/s for 2 s then yield "
      "within c speed d order id for e then route to f within c speed if g then 1 m/s else d;");
}

TEST(RoundTrip, HoldsForAllSpecs) {
  const auto specs = all_specs();
  ASSERT_GE(specs.size(), 6U);
  for (const auto& path : specs) {
    SCOPED_TRACE(path.filename());
    std::ifstream in{path};
    std::stringstream text;
    text << in.rdbuf();
    expect_round_trip(text.str());
  }
}

// Zones of files with all that may be said of one, and the words as names elsewhere.
TEST(RoundTrip, HoldsForZonesOfFiles) {
  expect_round_trip(
      "origin 47.3977 deg, -8.5456 deg, 432 m;\n"
      "zone a = import \"x \\\"y.geojson\" feature \"one\" flat \"why\" timeless \"why\";\n"
      "zone b = (import \"w.wkt\" in deg axes latitude longitude | import \"w.wkt\" in m) - "
      "import \"m.plan\" exclusions scheduled;\n"
      "zone c = shrink(import \"m.plan\" inclusions all exclusions, 1 m) & c;\n"
      "input origin, feature, axes, inclusions, exclusions, flat, timeless, scheduled : bool;\n"
      "monitor m { \"R\" always origin and not exclusions or p inside import \"x\" in m; }\n");
}

TEST(RoundTrip, KeepsGroupsThatNeedBrackets) {
  for (const char* expression : {"(a + b) * c",
                                 "a - (b - c)",
                                 "a / (b / c)",
                                 "(a implies b) implies c",
                                 "not (a and b)",
                                 "(not a) and b",
                                 "not (a for 1 s)",
                                 "(a for 1 s) for 2 s",
                                 "a for (x + y)",
                                 "-(a + b)",
                                 "- -a",
                                 "(a >= b) == (c >= d)",
                                 "(forall q : K : a) and b",
                                 "a and (exists q : K : b)",
                                 "a * (not b)",
                                 "(-a).b",
                                 "(a + b).c",
                                 "(rectangle (1, 2) to (3, 4)).x",
                                 "(a | b) - c",
                                 "a iff (b iff c)",
                                 "f((1 m, 2 m), (a))",
                                 "circle (1 m, 2 m) radius (a + b)",
                                 "forall q : K, q != r and q != s : a",
                                 "f()",
                                 "true and false",
                                 "a inside (b inside c)",
                                 "once a",
                                 "once[0 s, 2 s] a",
                                 "once[0 s, inf] (a and b)",
                                 "(once a) and b",
                                 "historically[1 s, 2 s] not a",
                                 "previously previously a",
                                 "not previously once a >= b",
                                 "a >= (once b)",
                                 "a since b",
                                 "a since[0 s, 1 s] b since[1 s, inf] c",
                                 "a since (b since c)",
                                 "a since (b for 1 s)",
                                 "once (a since b)",
                                 "(once a) since b",
                                 "a within 2 s of b",
                                 "a within 2 s of (b within (x + y) of c)",
                                 "a within 2 s of b within 3 s of c",
                                 "not (a within 2 s of b)",
                                 "a within 2 s of b for 1 s",
                                 "min[0 s, 1 s](x) <= max[0 s, inf](y)",
                                 "count[0 s, 1 s](open and not closed) >= 3",
                                 "min(a, b) + min[0 s, 1 s](a)",
                                 "if a then b else c",
                                 "(if a then b else c) + d",
                                 "if a then if b then c else d else if e then f else g",
                                 "1 + (if a then b else c)",
                                 "let x = 1 m in x >= y",
                                 "(let x = y in x) and z",
                                 "let x = let y = 1 in y in x",
                                 "let x = 5 in x >= 5",
                                 "temps[2] >= 3",
                                 "min(q : K : q.x) + 1 >= 3",
                                 "count(q : K, q != r : a and b) <= 2",
                                 "a[1][2].x + f(x)[0]",
                                 "(a + b)[2]",
                                 "age(speed) <= 1 s",
                                 "a for 1 s since b"}) {
    expect_round_trip(std::string("monitor m { always ") + expression + "; }");
  }
}

TEST(RoundTrip, KeepsTextsWithEscapes) {
  expect_round_trip(
      R"(monitor m { "a \"quoted\" \\ text,\n\ttab, \\n and umlauts: äöü" always a; })");
}

TEST(RoundTrip, KeepsEveryClause) {
  expect_round_trip(R"(spec s;
import "a/b.rta";
robot R {
  body radius 1 m;
  motion point { speed <= 1 m/s; brake >= 1 m/s^2; }
  sense position : point;
  sense heading : angle error 1 deg;
  sense velocity : vector max_age 1 s;
  hears other robots max_age 1 s;
  hears other robots max_age 1 s, present;
  input plan : path;
  input route : path[4];
  input way : path tracking <= 1 cm;
  output drive : twist;
  latency 1 ms;
  energy { drive <= 1 %/m; charge >= 1 %/s at dock; }
}
fleet bots : R[128];
site home = (1 m, 2 m);
site dock(bots[3]) = (1 m, 2 m);
monitor m {
  "one"
  "two"
  always a;
  always b;
  ahead 1 s unsound "why", 1 waypoint, 2 waypoints, waypoints only, points only unsound "x";
  recover c;
  return when d;
}
decision d for R { priority a > b; priority c; }
decision e for R { coordinate a > b; coordinate c; }
)");
}

// Every item of monitors without a robot.
TEST(RoundTrip, KeepsSignalsParametersAndFunctions) {
  expect_round_trip(R"(spec door;
period 10 ms;
input open, moving : bool;
input speed : real [m/s] in 0 .. 3 m/s error 1 cm/s max_age 100 ms;
input n : int in 0..10;
input p : point max_age inf;
input temps : real [K][4] in 200 K .. 400 K resolution 0.1 K;
input ratios : real[2];
input load : real [%];
input x : real in 0 .. 1 resolution 0.001;
enum Gear { park, drive, reverse }
enum One { only }
input gear : Gear;
param h : real [m] in 0.1 m .. 0.5 m = 0.2 m;
param d : length in 0.1 m .. 0.5 m = 20 cm;
fun slow(v : real [m/s], limit : real [m/s]) : bool = v <= limit;
fun zero() : real [rad/s^2] = 0 rad/s^2;
scale 0.5 m/s;
grid 0.1 mm, 1 mm/s;
frame gps, base;
zone yard @ gps = rectangle (0 m, 0 m) to (5 m, 5 m);
input at : pose of base @ gps in -5 .. 5 m, -180 .. 180 deg error 1 cm, 1 deg resolution 1 mm, 1 mrad;
input far : vector [m/s][4] @ base;
input board : real[3][4];
monitor full { "R8: margins" always far[0].x <= 1 m/s; margin full; }
assume speed <= 3 m/s checked by no_run;
assume gear == park unchecked "bench test";
monitor no_run { "R7: no driving" always once[0 s, 2 s] open implies speed <= 0.3 m/s; }
)");
}

TEST(Print, WritesTheSpellingOfTheSpecs) {
  Parsed parsed{"controller c:safe for T=route to dock within free speed 0.15 m/s;"};
  EXPECT_EQ(print(parsed.file),
            "controller c : safe for T = route to dock within free speed 0.15 m/s;\n");
}

}  // namespace
}  // namespace rtac::syntax
