// A place where all monitors give control back may be a few millimetres wide: it is found, and what
// is said to be missing is what works.
#include <gtest/gtest.h>

#include "testing.h"

namespace rtac::driver::test {
namespace {

class CommonPlace : public Verify {
 protected:
  // Two halls that overlap by so many millimetres, from 12 m on backwards, the one behind grown.
  static std::string halls(long overlap_mm, long grown_mm) {
    return "spec halls;\n"
           "zone west = rectangle (0 m, 0 m) to (12 m, 10 m);\n"
           "zone behind = rectangle (" +
           std::to_string(12'000 - overlap_mm) +
           " mm, 0 m) to (24 m, 10 m);\nzone east = grow(behind, " + std::to_string(grown_mm) +
           " mm);\n" + a_rover +
           R"(controller stop : safe for Rover = brake_and_hold;
monitor in_west for r : Rover { "R1" always r inside west; recover stop; hold when violated "a test"; }
monitor in_east for r : Rover { "R2" always r inside east; recover stop; hold when violated "a test"; }
decision d for Rover { advanced drive; period 50 ms; priority in_west > in_east; }
)";
  }
  static std::string joint(long overlap_mm, long grown_mm) {
    const Outcome o =
        verified(halls(overlap_mm, grown_mm), {"--format", "json", "-o", "certificates"});
    return statuses(o.out, "joint return", "").front();
  }
  // How much wider the one has to be, as it is said.
  static long missing_mm(long overlap_mm) {
    const Outcome o = verified(halls(overlap_mm, 1));
    const std::string said = o.out + o.err, before = "`grow(east, ";
    const auto at = said.find(before);
    EXPECT_NE(at, std::string::npos) << said;
    return 1 + std::lround(1000 * std::atof(said.c_str() + at + before.size()));
  }
};

TEST_F(CommonPlace, WhatIsSaidToBeMissingIsWhatWorks) {
  for (const long overlap_mm : {300, 500, 801}) {
    const long more_mm = missing_mm(overlap_mm);
    EXPECT_EQ(joint(overlap_mm, more_mm), "proved") << overlap_mm << " and " << more_mm;
    EXPECT_EQ(joint(overlap_mm, more_mm - 10), "refuted") << overlap_mm << " and " << more_mm;
  }
}

// Two robots that have to be apart: how far they can be is asked of what is left of the zone,
// whatever box it fills.
TEST_F(CommonPlace, HowFarTwoCanBeApartDoesNotDependOnTheAxes) {
  const auto two_in = [](const std::string& cell, const std::string& position,
                         const std::string& velocity) {
    const Outcome o = verified("spec cells;\nzone cell = " + cell +
                                   ";\nrobot Bot {\n  sense position : " + position +
                                   " error 3 cm max_age 100 ms;\n  sense velocity : " + velocity +
                                   R"( error 4 cm/s max_age 100 ms;
  body radius 30 cm;
  motion point { speed <= 1 m/s; accel <= 1.5 m/s^2; brake >= 1.5 m/s^2; }
  hears other robots max_age 100 ms;
  output thrust : acceleration;
  latency 80 ms;
}
fleet a, b : Bot;
controller drive : advanced for Bot extern;
controller stop : safe for Bot = brake_and_hold;
controller stay : safe for Bot = brake_and_hold;
monitor walls for r : Bot { "R1" always r inside cell; recover stop; hold when violated "a test"; }
monitor apart for r : Bot {
  "R2" always forall q : Bot, q != r : distance(r, q) >= 40 cm;
  recover stay; hold when violated "a test";
}
decision d for Bot { advanced drive; period 100 ms; priority apart > walls; }
)",
                               {"--format", "json"});
    return statuses(o.out, "joint return", "").front();
  };
  const auto square = [&](const std::string& half) {
    return two_in("polygon [(0 m, -" + half + " m), (" + half + " m, 0 m), (0 m, " + half +
                      " m), (-" + half + " m, 0 m)]",
                  "point", "vector");
  };
  EXPECT_EQ(square("2.6"), "refuted");
  // so far apart, and still held by each other's reach
  EXPECT_EQ(square("4"), "unknown");
  EXPECT_EQ(square("4.6"), "proved");
  const auto prism = [&](const std::string& side) {
    return two_in("prism (rectangle (0 m, 0 m) to (" + side + " m, " + side + " m)) from 0 m to " +
                      side + " m",
                  "point3", "vector3");
  };
  EXPECT_EQ(prism("3.7"), "refuted");
  EXPECT_EQ(prism("7"), "proved");
}

// By other code.
TEST_F(CommonPlace, ANarrowOneIsFoundAgain) {
  ASSERT_EQ(joint(500, missing_mm(500)), "proved");
  const Outcome o = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// A height that is asked for unless inputs say something else keeps nobody from being given back
// higher up, where inputs say so, and no other monitor asks for them.
TEST_F(CommonPlace, AHeightBesideWhatInputsSayIsNotAskedFor) {
  const auto quad = [](const std::string& low) {
    return R"(spec roof;
zone plot     = rectangle (0 m, 0 m) to (50 m, 40 m);
zone building = rectangle (15 m, 10 m) to (35 m, 30 m);
zone air      = prism (plot - building) from 0 m to 40 m | prism (plot) from 25 m to 40 m;
input wind : speed in 0 .. 30 m/s error 0.5 m/s max_age 2 s;
robot Quad {
  body    radius 50 cm;
  motion  point { speed <= 3 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; disturbance <= 0.5 m/s^2; }
  sense   position : point3  error 10 cm   max_age 50 ms;
  sense   velocity : vector3 error 5 cm/s  max_age 50 ms;
  output  thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller wash : advanced for Quad extern;
controller down : safe for Quad = land to 2 m speed 0.6 m/s;
controller back : safe for Quad = retreat within air speed 0.6 m/s;
monitor calm  for r : Quad { "R1: low in wind" always )" +
           low + R"(; recover down; hold when violated "it comes down"; }
monitor shell for r : Quad { "R2: in the air space" always clearance(r, air) >= 50 cm; recover back; }
decision fly for Quad { advanced wash; period 50 ms; priority calm > shell; acknowledge down may break shell "a test"; }
)";
  };
  const auto joint = [&](const std::string& text) {
    const Outcome o = verified(text, {"--format", "json", "-o", "proofs"});
    return statuses(o.out, "joint return", "");
  };
  EXPECT_EQ(joint(quad("r.position.z <= 4 m")), Statuses{"refuted"});
  for (const std::string low : {"wind <= 9 m/s or r.position.z <= 4 m",
                                "max[0 s, 10 s](wind) <= 9 m/s or r.position.z <= 4 m"}) {
    EXPECT_EQ(joint(quad(low)), Statuses{"proved"}) << low;
    const Outcome again = recheck_sealed_anew("proofs");
    EXPECT_EQ(again.status, exit_clean) << low << again.out << again.err;
  }
  // in a wind of 10 m/s it is not
  std::string fly = read("proofs/verification.json");
  const std::string at = "wind.0=";
  std::size_t from = fly.rfind(at) + at.size();
  write("proofs/verification.json", fly.replace(from, fly.find('"', from) - from, "10"));
  const Outcome denied = recheck_sealed_anew("proofs");
  EXPECT_EQ(denied.status, exit_violation) << denied.out;
  EXPECT_NE(denied.out.find("with those inputs"), std::string::npos) << denied.out;
  // both speak of it: with little wind the one asks for no place, and the other one has its own
  const std::string both =
      edited(quad("wind <= 9 m/s or r.position.z <= 4 m"), "always clearance(r, air) >= 50 cm",
             "always clearance(r, air) >= 50 cm or wind >= 20 m/s");
  EXPECT_EQ(joint(both), Statuses{"proved"});
  const Outcome again = recheck_sealed_anew("proofs");
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

// A ball beside the edge of a roof has more room than what is as high and as wide: that there is no
// place in both zones is not said of the one that there is.
TEST_F(CommonPlace, OneBesideAnEdgeIsNotDenied) {
  const std::string page =
      "spec edge;\n"
      "zone yard = prism (rectangle (-20 m, -20 m) to (20 m, 20 m)) from -20 m to 20 m;\n"
      "zone hut = prism (rectangle (-10 m, -10 m) to (0 m, 10 m)) from -19 m to 3 m;\n"
      "zone open = yard - hut;\n"
      "zone cage = prism (rectangle (-0.071 m, -0.333 m) to (0.595 m, 0.333 m))"
      " from 2.929 m to 3.595 m;\n" +
      edited(edited(a_quad, "30 cm", "20 cm"), "speed <= 3", "speed <= 1") +
      "controller off : safe for Quad = brake_and_hold;\n"
      "monitor m for r : Quad { \"R1\" always r inside open and r inside cage; recover off;"
      " hold when violated \"a test\"; }\n"
      "decision fly for Quad { advanced policy; period 50 ms; priority m; }\n";
  const Outcome o = verified(page, {"--format", "json", "--attack", "1"});
  EXPECT_EQ(statuses(o.out, "satisfiable", "m"), Statuses{"unknown"}) << o.out << o.err;
  EXPECT_NE(o.out.find("no place was found so clear"), std::string::npos) << o.out;
}

}  // namespace
}  // namespace rtac::driver::test
