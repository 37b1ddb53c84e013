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
                                 "a inside (b inside c)"}) {
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
  input plan : path;
  input route : path[4];
  input way : path tracking <= 1 cm;
  output drive : twist;
  latency 1 ms;
  energy { drive <= 1 %/m; charge >= 1 %/s at dock; }
}
site home = (1 m, 2 m);
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
)");
}

TEST(Print, WritesTheSpellingOfTheSpecs) {
  Parsed parsed{"controller c:safe for T=route to dock within free speed 0.15 m/s;"};
  EXPECT_EQ(print(parsed.file),
            "controller c : safe for T = route to dock within free speed 0.15 m/s;\n");
}

}  // namespace
}  // namespace rtac::syntax
