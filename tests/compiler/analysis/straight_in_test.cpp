// From outside of its zone a recovery makes straight for it: what it keeps on that way, and what it
// keeps of heights.
#include "compiler/analysis/straight_in.h"

#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using Messages = std::vector<std::string>;

// A corridor round a corner, and a room at the end of it.
std::string corner(const std::string& monitors, const std::string& order,
                   const std::string& corridor =
                       "rectangle (0 m, 0 m) to (9 m, 3 m) | rectangle (0 m, 0 m) to (3 m, 9 m)") {
  return R"(spec corner;
zone yard = rectangle (-1 m, -1 m) to (10 m, 10 m);
zone corridor = )" +
         corridor + R"(;
zone room = rectangle (0 m, 6 m) to (3 m, 9 m);
robot Rover {
  body     radius 10 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 1 cm    max_age 20 ms;
  sense    velocity : vector  error 1 cm/s  max_age 20 ms;
  output   thrust   : acceleration;
  latency  20 ms;
}
fleet one : Rover;
input calm : bool max_age 1 s;
param margin : length in -0.1 m .. 0.3 m = -0.1 m;
controller pilot  : advanced for Rover extern;
controller indoors : safe for Rover = retreat within corridor speed 0.2 m/s;
controller homeward : safe for Rover = retreat within room speed 0.2 m/s;
controller loose  : safe for Rover = retreat within yard speed 0.2 m/s;
monitor fence for r : Rover { "SR-1: in the corridor" always r inside corridor; recover indoors; }
)" + monitors +
         "decision drive for Rover { advanced pilot; period 20 ms; " + order + " }\n";
}

Messages errors(const std::string& text) {
  const auto c = compiled(text);
  Messages all;
  for (const auto& d : c->diagnostics.all()) {
    if (diag::info(d.code).severity == diag::Severity::error) all.push_back(d.message);
  }
  return all;
}
const Messages breaks = {"while `homeward` drives, `fence` may become false, and ranks lower"};

TEST(StraightIn, ACornerMayBeCutFromOutsideOfItsZone) {
  const std::string slow =
      "monitor slow for r : Rover { \"SR-2\" always r.speed <= 0.8 m/s; recover homeward; }\n";
  EXPECT_EQ(errors(corner(slow, "priority slow > fence;")), breaks);
  // whoever ranks higher takes over
  EXPECT_EQ(errors(corner(slow, "priority fence > slow;")), Messages{});
  // straight ways stay in what is convex
  EXPECT_EQ(errors(corner(slow, "priority slow > fence;", "rectangle (0 m, 0 m) to (9 m, 9 m)")),
            Messages{});
}

TEST(StraightIn, WhoIsKeptInTheZoneComesFromNowhereElse) {
  const std::string in_room =
      "monitor there for r : Rover { \"SR-2\" always r inside room; recover homeward; }\n";
  EXPECT_EQ(errors(corner(in_room, "priority there > fence;")), Messages{});
  // what somebody is accepted to break keeps nobody in it
  const std::string out =
      in_room +
      "monitor slow for r : Rover { \"SR-3\" always r.speed <= 0.8 m/s; recover indoors; }\n";
  EXPECT_EQ(errors(corner(out,
                          "priority slow > there > fence; "
                          "acknowledge indoors may break there \"a test\";")),
            breaks);
}

// It may be false already when the recovery takes over: nobody has looked far enough ahead.
TEST(StraightIn, WhatIsLookedAtTooLateKeepsNobodyThere) {
  const std::string late =
      "monitor there for r : Rover { \"SR-2\" always r inside room; ahead 10 ms unsound \"a "
      "test\"; "
      "recover homeward; }\n";
  EXPECT_EQ(errors(corner(late, "priority there > fence;")), breaks);
}

// A parameter may be less strict now than it may become.
TEST(StraightIn, AParameterThatAllowsToBeOutsideKeepsNobodyThere) {
  const std::string lax =
      "monitor there for r : Rover { \"SR-2\" always clearance(r, room) >= margin; "
      "recover homeward; }\n";
  EXPECT_EQ(errors(corner(lax, "priority there > fence;")), breaks);
}

// What a parameter has become too strict for is outside of what holds: its way leads in, and no
// farther out.
TEST(StraightIn, AParameterThatBecameStricterIsNotLeftOnTheWayIn) {
  const std::string tight =
      "zone nook = rectangle (0.6 m, 6.6 m) to (2.4 m, 8.4 m);\n"
      "controller deep : safe for Rover = retreat within nook speed 0.2 m/s;\n"
      "monitor there for r : Rover { \"SR-2\" always clearance(r, corridor) - margin >= 0.2 m; "
      "recover deep; }\n";
  const std::string bitten =
      "rectangle (0 m, 0 m) to (9 m, 9 m) - circle (9.001 m, 0 m) radius 2 m";
  EXPECT_EQ(errors(corner(tight, "priority fence > there;", bitten)), Messages{});
  const std::string leads_out = "on its way into `nook` from (";
  const Messages around = errors(corner(tight, "priority fence > there;"));
  ASSERT_EQ(around.size(), 1u);
  EXPECT_EQ(around[0].substr(0, leads_out.size()), leads_out);
}

// ---- heights

std::string tower(const std::string& rest) {
  return R"(spec tower;
zone flat = rectangle (1 m, 1 m) to (8 m, 8 m);
zone hall = prism (rectangle (0 m, 0 m) to (9 m, 9 m)) from 0 m to 4 m
          | prism (rectangle (0 m, 0 m) to (9 m, 5 m)) from 4 m to 8 m;
zone low_hall = prism (rectangle (0 m, 0 m) to (9 m, 9 m)) from 0 m to 4 m;
robot Flyer {
  body     radius 15 cm;
  motion   point { speed <= 1 m/s; accel <= 1.5 m/s^2; brake >= 1 m/s^2; }
  sense    position : point3   error 2 cm    max_age 60 ms;
  sense    velocity : vector3  error 3 cm/s  max_age 40 ms;
  output   thrust : acceleration;
  latency  30 ms;
}
fleet one : Flyer;
controller pilot : advanced for Flyer extern;
controller stop  : safe for Flyer = brake_and_hold;
controller level : safe for Flyer = retreat within flat speed 0.3 m/s;
controller down  : safe for Flyer = land to 1 m speed 0.3 m/s;
controller bought : safe for Flyer extern keeps inside flat speed <= 0.6 m/s;
)" + rest;
}
std::string drives(const std::string& controller) {
  return "monitor fence for r : Flyer { \"SR-1\" always r inside flat; ahead 100 ms; recover " +
         controller + "; " + (controller == "level" ? "" : "hold when violated \"a test\"; ") +
         "}\n";
}
std::string judged(const std::string& property) {
  return "monitor high for r : Flyer { \"SR-2\" always " + property +
         "; recover stop; hold when violated \"a test\"; }\n";
}
const std::string order =
    "decision fly for Flyer { advanced pilot; period 50 ms; priority fence > high; }\n";
Messages broken_by(const std::string& controller, const std::string& property) {
  return errors(tower(drives(controller) + judged(property) + order));
}
Messages breaks_height(const std::string& controller) {
  return {"while `" + controller + "` drives, `high` may become false, and ranks lower"};
}

TEST(Heights, WhatMovesInAZoneOfThePlaneKeepsItsHeight) {
  EXPECT_EQ(broken_by("level", "r.position.z <= 5 m"), Messages{});
  EXPECT_EQ(broken_by("level", "r inside low_hall"), Messages{});
  // which does not help where the fence gets narrower
  EXPECT_EQ(broken_by("level", "r inside hall"), breaks_height("level"));
}

TEST(Heights, NobodyClaimsTheHeightOfWhatIsExternal) {
  EXPECT_EQ(broken_by("bought", "r.position.z <= 5 m"), breaks_height("bought"));
  EXPECT_EQ(broken_by("bought", "r inside low_hall"), breaks_height("bought"));
  const std::string own =
      "monitor fence for r : Flyer { \"SR-1\" always r inside flat and r.position.z <= 5 m; "
      "ahead 100 ms; recover bought; hold when violated \"a test\"; }\n"
      "decision fly for Flyer { advanced pilot; period 50 ms; priority fence; }\n";
  EXPECT_EQ(errors(tower(own)),
            Messages{"`bought` moves within `flat`, and `fence` needs it to stay in the heights up "
                     "to 5 m"});
}

// Stopped on its way it comes to rest beside its leg, above it as well: of a limit of height the
// clearance of its zone says nothing.
TEST(Heights, ALimitIsKeptOffAsWallsOfThePlaneAre) {
  const auto hold_mm = [](const std::string& zone, const std::string& more) {
    const auto c = compiled(
        tower("controller back : safe for Flyer = retreat within " + zone +
              " speed 0.9 m/s;\nzone tall = prism (flat) from 0 m to 9 m;\n"
              "monitor cage for r : Flyer { \"SR-1\" always r inside " +
              zone + more +
              "; recover back; }\n"
              "decision fly for Flyer { advanced pilot; period 50 ms; priority cage; }\n"));
    return c->module ? c->module->decisions.front().body.hold_mm : 0;
  };
  const std::int64_t flat_mm = hold_mm("flat", ""), tall_mm = hold_mm("tall", "");
  EXPECT_GT(tall_mm, 0);
  EXPECT_LT(tall_mm, flat_mm);
  EXPECT_EQ(hold_mm("tall", " and r.position.z <= 9 m"), flat_mm);
}

// It comes to rest some centimetres beside where it lands.
TEST(Heights, ALandingStraysFromItsEnd) {
  EXPECT_EQ(broken_by("down", "r.position.z >= 1 m"), breaks_height("down"));
  EXPECT_EQ(broken_by("down", "r.position.z >= 0.4 m"), Messages{});
}

}  // namespace
}  // namespace rtac::analysis::test
