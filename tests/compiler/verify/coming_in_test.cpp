// The straight way of a recovery into its zone, and who keeps its height: what is proved of them is
// found once more, and what is not true is denied.
#include "compiler/recheck/entering.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

constexpr const char* box = "rectangle (0 m, 0 m) to (9 m, 9 m)";
constexpr const char* ell =
    "rectangle (0 m, 0 m) to (9 m, 3 m) | rectangle (0 m, 0 m) to (3 m, 9 m)";

// Who is too fast is led to a room, wherever it was; a fence ranks lower.
std::string led_home(const std::string& fence, const std::string& accepted = "") {
  return R"(spec home;
zone yard = rectangle (-1 m, -1 m) to (10 m, 10 m);
zone fenced = )" +
         fence + R"(;
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
controller pilot    : advanced for Rover extern;
controller home     : safe for Rover = retreat within room speed 0.2 m/s;
controller back     : safe for Rover = retreat within fenced speed 0.2 m/s;
monitor slow for r : Rover { "SR-1" always r.speed <= 0.8 m/s; recover home; }
monitor m for r : Rover { "SR-2" always r inside fenced; recover back; }
decision go for Rover { advanced pilot; period 20 ms; priority slow > m; )" +
         accepted + " }\n";
}
// Who may leave `flat` is stopped by a recovery of the test; another monitor limits the height.
std::string at_a_height(const std::string& recovery, const std::string& property,
                        const std::string& accepted = "") {
  return R"(spec tower;
zone flat = rectangle (1 m, 1 m) to (8 m, 8 m);
zone hall = prism (rectangle (0 m, 0 m) to (9 m, 9 m)) from 0 m to 6 m;
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
controller back  : safe for Flyer )" +
         recovery + R"(;
monitor fence for r : Flyer { "SR-1" always r inside flat; ahead 400 ms; recover back; )" +
         (recovery.starts_with("= retreat") ? "" : "hold when violated \"a test\"; ") +
         R"(}
monitor m for r : Flyer { "SR-2" always )" +
         property + R"(; ahead 100 ms; recover stop; hold when violated "a test"; }
decision fly for Flyer { advanced pilot; period 50 ms; priority fence > m; )" +
         accepted + " }\n";
}

class ComingIn : public Verify {
 protected:
  static Json report_of(const std::string& text) {
    (void)verified(text, {"-o", "certificates"});
    return Json::parse(read("certificates/verification.json"));
  }
  static Json& pair_in(Json& report) {
    for (Json& o : report["decisions"][0]["obligations"]) {
      if (o["obligation"] == "C" && o.value("monitor", "") == "m") return o;
    }
    ADD_FAILURE() << report.dump(2);
    return report;
  }
  static Outcome rechecked(const Json& report) {
    write("certificates/verification.json", report.dump());
    return recheck_sealed_anew();
  }
  static void expect_denied(const Json& report, const std::string& why) {
    const Outcome o = rechecked(report);
    EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
    EXPECT_NE((o.out + o.err).find(why), std::string::npos) << o.out << o.err;
  }
  static void expect_proved(Json report) {
    EXPECT_EQ(pair_in(report)["status"], "proved") << report.dump(2);
    const Outcome o = rechecked(report);
    EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  }
  // Without the claims of that name.
  static Json without(Json report, const std::string& name) {
    Json left = Json::array();
    for (const Json& claim : pair_in(report)["claims"]) {
      if (claim["claim"] != name) left.push_back(claim);
    }
    EXPECT_LT(left.size(), pair_in(report)["claims"].size());
    pair_in(report)["claims"] = left;
    return report;
  }
  // What one specification proves of the pair, said of another one that accepts that it is broken.
  static Json said_of(const std::string& text, Json proved) {
    Json report = report_of(text);
    EXPECT_EQ(pair_in(report)["status"], "acknowledged");
    pair_in(report)["status"] = "proved";
    pair_in(report)["claims"] = pair_in(proved)["claims"];
    return report;
  }
};

TEST_F(ComingIn, StraightWaysStayInWhatIsConvex) {
  const Json report = report_of(led_home(box));
  expect_proved(report);
  expect_denied(without(report, "comes_in"), "it rests on no claim `comes_in`");
}

TEST_F(ComingIn, AWayAcrossACornerIsDenied) {
  const Json proved = report_of(led_home(box));
  const std::string accepted = "acknowledge home may break m \"a test\";";
  expect_denied(said_of(led_home(ell, accepted), proved), "lead across what is not convex");
}

Json p2a_of(Json report) {
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") return o;
  }
  return {};
}

// A page with a zone `core` in another one, `hall`, that a recovery is led into.
std::string led_into(const std::string& hall, const std::string& core) {
  return R"(spec inset;
zone hall = )" +
         hall + R"(;
zone core = )" +
         core + R"(;
robot Rover {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 1 cm    max_age 100 ms;
  sense    velocity : vector  error 1 cm/s  max_age 100 ms;
  output   thrust   : acceleration;
  latency  20 ms;
}
fleet one : Rover;
controller pilot : advanced for Rover extern;
controller back  : safe for Rover = retreat within core speed 0.3 m/s;
monitor m for r : Rover { "SR-1" always r inside hall; recover back; }
decision go for Rover { advanced pilot; period 100 ms; priority m; }
)";
}

// Back into a part of a hall with a pillar: each straight way in stays in the hall, until the part
// begins where a wall lies between.
TEST_F(ComingIn, StraightWaysIntoAPartOfAHallAreFollowed) {
  const std::string hall =
      "rectangle (0 m, 0 m) to (7 m, 6 m) - rectangle (3 m, 2 m) to (4 m, 3 m)";
  const Json report = report_of(led_into(hall, "shrink(hall, 30 cm)"));
  EXPECT_EQ(p2a_of(report)["status"], "proved") << p2a_of(report);
  const Outcome again = rechecked(report);  // other obligations are unknown
  EXPECT_NE(again.out.find(" 0 not proved, 0 unknown;"), std::string::npos) << again.out;
  Json elsewhere = report;
  for (Json& o : elsewhere["decisions"][0]["obligations"]) {
    for (Json& claim : o["claims"]) {
      if (claim["claim"] == "comes_in") claim["cells_x_mm"] = "700";
    }
  }
  const Outcome denied = rechecked(elsewhere);
  EXPECT_EQ(denied.status, exit_violation);
  EXPECT_NE(denied.out.find("lead across what is not convex"), std::string::npos) << denied.out;
}

// Cells of a large zone are wide, and what is looked at is cut into as small parts all the same.
// From the western arm ways to the northern one lead across the corner between them.
TEST_F(ComingIn, WaysIntoAPartOfALargeFieldAreFollowed) {
  const std::string field =
      "rectangle (0 m, 0 m) to (400 m, 150 m) | rectangle (200 m, 0 m) to (400 m, 300 m)";
  const Json report = report_of(led_into(field, "shrink(hall, 2 m)"));
  EXPECT_EQ(p2a_of(report)["status"], "proved") << p2a_of(report);
  EXPECT_EQ(rechecked(report).status, exit_clean);
  Json across = report_of(led_into(field, "rectangle (210 m, 160 m) to (390 m, 290 m)"));
  EXPECT_NE(p2a_of(across)["status"], "proved") << p2a_of(across);
  for (Json& o : across["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") o = p2a_of(report);
  }
  expect_denied(across, "lead across what is not convex");
}

// From beside a corner of what the part leaves out it leads anywhere, which is far from all walls.
TEST_F(ComingIn, WaysOutOfABlockAreFollowedFromItsCorners) {
  const Json report = report_of(
      led_into("rectangle (0 m, 0 m) to (20 m, 9 m) | rectangle (10 m, 0 m) to (20 m, 16 m)",
               "hall - circle (5 m, 4.5 m) radius 1 m"));
  EXPECT_EQ(p2a_of(report)["status"], "proved") << p2a_of(report);
  EXPECT_EQ(rechecked(report).status, exit_clean);
}

// Of two rooms, where both of their places are not convex, a recovery leads into the one: each
// straight way from the other one stays in it, past the corner between them, until a robot is in
// the first; where the other one reaches beyond that it cuts a corner.
std::string into_a_wing(const std::string& other) {
  return R"(spec wings;
zone hall  = rectangle (0 m, 0 m) to (8 m, 5 m);
zone other = )" +
         other + R"(;
robot Rover {
  body     radius 20 cm;
  motion   unicycle { speed <= 0.8 m/s; turn <= 2 rad/s; accel <= 0.8 m/s^2; brake >= 1 m/s^2; turn_accel <= 6 rad/s^2; }
  sense    position : point   error 2 cm   max_age 100 ms;
  sense    heading  : angle   error 2 deg  max_age 100 ms;
  sense    velocity : vector  error 2 cm/s max_age 100 ms;
  output   drive : twist;
  latency  50 ms;
}
fleet one : Rover;
controller pilot : advanced for Rover extern;
controller back  : safe for Rover = retreat within hall speed 0.4 m/s;
monitor m for r : Rover { "SR-1" always r inside hall or r inside other; recover back; }
decision go for Rover { advanced pilot; period 100 ms; priority m; }
)";
}
Json& p2a_in(Json& report) {
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") return o;
  }
  ADD_FAILURE() << report.dump(2);
  return report;
}
TEST_F(ComingIn, StraightWaysFromOneSideOfAnOrToAnotherAreFollowed) {
  for (const char* const other :
       {"rectangle (4 m, 0 m) to (8 m, 9 m)", "rectangle (5 m, 2 m) to (12 m, 9 m)"}) {
    Json report = report_of(into_a_wing(other));
    EXPECT_EQ(p2a_in(report)["status"], "proved") << other;
    const Outcome again = rechecked(report);
    EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
    for (Json& claim : p2a_in(report)["claims"]) {
      if (claim["claim"] == "sides") claim["zone"] = "other";
    }
    expect_denied(report, "no such zone");
    Json& claims = p2a_in(report)["claims"];
    for (std::size_t i = claims.size(); i-- > 0;) {
      if (claims[i]["claim"] == "sides") claims.erase(i);
    }
    expect_denied(report, "it rests on no claim `sides`");
  }
}
TEST_F(ComingIn, AStraightWayOutOfBothSidesIsNotProved) {
  Json proved = report_of(into_a_wing("rectangle (5 m, 2 m) to (12 m, 9 m)"));
  Json report = report_of(
      into_a_wing("rectangle (5 m, 0 m) to (14 m, 2.5 m) | rectangle (11 m, 0 m) to (14 m, 9 m)"));
  EXPECT_EQ(p2a_in(report)["status"], "unknown");
  p2a_in(report)["status"] = "proved";
  p2a_in(report)["claims"] = p2a_in(proved)["claims"];
  expect_denied(report, "the recovery may lead out of each side");
}

// A zone with a neck, in which a body has 4 mm less than it takes: a straight leg leads through all
// the same, as much as legs lose. In there a body lies in one of the sides only if they overlap.
std::string through_a_neck(const std::string& begins) {
  return R"(spec neck;
zone left = rectangle (0.9445 m, 1.2390 m) to (4.01 m, 1.7600 m);
zone right = rectangle (4.1445 m, -0.0055 m) to (8.0555 m, 3.0055 m) | rectangle ()" +
         begins + R"(, 1.2390 m) to (4.6 m, 1.7600 m);
zone ways = rectangle (1 m, 1.295 m) to (3.82 m, 1.704 m) | rectangle (3.82 m, 1.303 m) to (4.2 m, 1.696 m) | rectangle (4.2 m, 0.05 m) to (8 m, 2.95 m);
robot Rover {
  body     radius 20 cm;
  motion   point { speed <= 0.4 m/s; accel <= 0.8 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 4 cm   max_age 100 ms;
  sense    velocity : vector  error 1 cm/s max_age 100 ms;
  output   drive : acceleration;
  latency  50 ms;
}
fleet one : Rover;
controller pilot : advanced for Rover extern;
controller back  : safe for Rover = retreat within ways speed 0.2 m/s;
monitor m for r : Rover { "SR-1" always r inside left or r inside right; recover back; }
decision go for Rover { advanced pilot; period 100 ms; priority m; }
)";
}
TEST_F(ComingIn, ThroughANeckThatIsHardlyTooNarrowALegLeadsOutOfBothSides) {
  Json proved = report_of(through_a_neck("3.2 m"));
  ASSERT_EQ(p2a_in(proved)["status"], "proved");
  Json report = report_of(through_a_neck("4.01 m"));
  EXPECT_EQ(p2a_in(report)["status"], "unknown");
  p2a_in(report)["status"] = "proved";
  p2a_in(report)["claims"] = p2a_in(proved)["claims"];
  expect_denied(report, "no side of it holds wherever the recovery drives");
}

// Off a pond, within a zone that is farther from it than is asked: whoever is outside of that keeps
// the distance that it has on its way in, and what holds besides says where a body may be at all.
std::string off_a_pond(const std::string& keep, const std::string& asked = "40 cm") {
  return R"(spec ponds;
param gap : length in 85 cm .. 1 m = 90 cm;
zone room = rectangle (-1.1 m, -3 m) to (8 m, 4 m);
zone pond = circle (4 m, 0 m) radius 1 m;
zone walls = rectangle (-1.1 m, 0.1 m) to (-0.7 m, 4 m) | rectangle (0.7 m, 0.7 m) to (0.8 m, 3 m);
zone shelf = rectangle (-1.1 m, -12 mm) to (4 m, 0 m);
zone keep = )" +
         keep + R"(;
robot Rover {
  body     radius 20 cm;
  motion   point { speed <= 0.5 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense    position : point   error 1 cm    max_age 20 ms;
  sense    velocity : vector  error 1 cm/s  max_age 20 ms;
  output   thrust   : acceleration;
  latency  5 ms;
}
fleet one : Rover;
controller pilot : advanced for Rover extern;
controller back  : safe for Rover = retreat within keep speed 0.3 m/s;
monitor m for r : Rover { "SR-1" always r inside room and distance(r, )" +
         std::string(keep.find("walls") == std::string::npos ? "pond" : "walls") + R"() >= )" +
         asked + R"(; recover back; }
decision go for Rover { advanced pilot; period 20 ms; priority m; }
)";
}

// Who keeps half a metre off is not in the pocket behind a wall, which a lesser distance leaves
// room for: from there the way leads through the wall.
TEST_F(ComingIn, WhereADistanceIsKeptNobodyIsInWhatIsTooNarrowForIt) {
  const auto behind_a_wall = [](const std::string& off) {
    return R"(spec pocket;
zone hall = rectangle (0 m, 0 m) to (6 m, 6 m) - rectangle (5 m, 0 m) to (5.2 m, 3 m);
zone core = rectangle (1.2 m, 3.7 m) to (4 m, 5.2 m);
robot Rover {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 1 cm    max_age 20 ms;
  sense    velocity : vector  error 1 cm/s  max_age 20 ms;
  output   thrust   : acceleration;
  latency  20 ms;
}
fleet one : Rover;
controller pilot : advanced for Rover extern;
controller back  : safe for Rover = retreat within core speed 0.3 m/s;
monitor m for r : Rover { "SR-1" always clearance(r, hall) >= )" +
           off + R"(; recover back; }
decision go for Rover { advanced pilot; period 20 ms; priority m; }
)";
  };
  const Json proved = report_of(behind_a_wall("50 cm"));
  EXPECT_EQ(p2a_of(proved)["status"], "proved") << p2a_of(proved);
  EXPECT_EQ(rechecked(proved).status, exit_clean);
  Json nearer = report_of(behind_a_wall("5 cm"));
  EXPECT_EQ(p2a_of(nearer)["status"], "unknown");  // nothing but a run refutes it
  for (Json& o : nearer["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") o = p2a_of(proved);
  }
  expect_denied(nearer, "lead across what is not convex");
}

// Around what is kept off, the zone of the ways leaves a wider margin: who is in that makes
// straight for the zone. What is told to work does.
TEST_F(ComingIn, WhoBeginsInsideHasNoStraightWay) {
  const auto page = [](const std::string& fence) {
    return R"(spec pit;
zone room = rectangle (0 m, 0 m) to (12 m, 9 m);
zone pit  = rectangle (8 m, 5 m) to (9 m, 6 m);
zone free = room - grow(pit, 30 cm);
robot Cart {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 50 ms;
  sense    velocity : vector  error 2 cm/s  max_age 50 ms;
  output   thrust : acceleration;
  latency  20 ms;
}
fleet one : Cart;
site dock = (3 m, 3 m);
controller pilot : advanced for Cart extern;
controller home  : safe for Cart = route to dock within free speed 0.3 m/s;
monitor walls for r : Cart { "SR-1" always r inside )" +
           fence + R"(; recover home; }
monitor deep  for r : Cart { "SR-2" always distance(r, pit) >= 10 cm; recover home; }
decision go for Cart { advanced pilot; period 50 ms; priority walls > deep; }
)";
  };
  const Outcome o = verified(page("room"), {"--attack", "1"});
  EXPECT_EQ(o.status, exit_inconclusive) << o.out << o.err;
  EXPECT_NE(o.out.find("what works: a monitor that keeps robots inside `free` works\n"),
            std::string::npos)
      << o.out;
  const Outcome inside = verified(page("free"), {"-o", "certificates"});
  EXPECT_EQ(inside.status, exit_clean) << inside.out << inside.err;
  EXPECT_EQ(recheck_sealed_anew().status, exit_clean);
}

// What lies near a cell is led out of there without a permit, and nothing is asked of the way; who
// keeps what is asked is in the zone already. It is not where the zone is nearer than that.
TEST_F(ComingIn, WhereAnotherSideAllowsAPlaceNothingIsAskedOfTheWayOutOfIt) {
  const auto page = [](const std::string& open, const std::string& asked) {
    return R"(spec cell;
input permit : bool max_age 1 s;
zone hall = rectangle (0 m, 0 m) to (30 m, 18 m);
zone cell = rectangle (22 m, 6 m) to (28 m, 12 m);
zone open = )" +
           open + R"(;
robot Cart {
  body     radius 25 cm;
  motion   point { speed <= 1 m/s; accel <= 1.5 m/s^2; brake >= 1.5 m/s^2; }
  sense    position : point  error 2 cm   max_age 50 ms;
  sense    velocity : vector error 2 cm/s max_age 50 ms;
  output   thrust   : acceleration;
  latency  20 ms;
}
fleet one : Cart;
controller nav  : advanced for Cart extern;
controller back : safe for Cart = retreat within open speed 0.3 m/s;
monitor keep for r : Cart { "SR-1" always permit or )" +
           asked + R"(; recover back; }
monitor walls for r : Cart { "SR-2" always r inside hall; recover back; }
decision go for Cart { advanced nav; period 50 ms; priority keep > walls; }
)";
  };
  const std::string off = "distance(r, cell) >= 50 cm", out = "r inside complement(cell)";
  const Json outside = report_of(page("hall - cell", out));
  EXPECT_EQ(p2a_of(outside)["status"], "proved") << p2a_of(outside);
  EXPECT_EQ(rechecked(outside).status, exit_clean);
  const Json proved = report_of(page("hall - grow(cell, 50 cm)", off));
  EXPECT_EQ(p2a_of(proved)["status"], "proved") << p2a_of(proved);
  EXPECT_EQ(rechecked(proved).status, exit_clean);
  Json nearer = report_of(page("hall - grow(cell, 40 cm)", off));
  EXPECT_EQ(p2a_of(nearer)["status"], "unknown") << p2a_of(nearer);
  for (Json& o : nearer["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a" && o["monitor"] == "keep") o = p2a_of(proved);
  }
  expect_denied(nearer, "it is not contained");
}

// A body that may stick out of a fence may be anywhere in a notch of it, in space as well.
TEST_F(ComingIn, WhoMayStickOutOfTheFenceMayCrossWhatLiesBetween) {
  const auto page = [](const std::string& least, const std::string& permit) {
    return R"(spec prongs;
input permit : bool max_age 1 s;
zone pen = rectangle (2 m, 1 m) to (12 m, 5 m) | rectangle (2 m, 5 m) to (2.4 m, 16 m) | rectangle (8 m, 5 m) to (12 m, 16 m);
zone core = rectangle (2 m, 1 m) to (12 m, 5 m) | rectangle (2 m, 5 m) to (2.4 m, 5.5 m) | rectangle (8 m, 5 m) to (12 m, 16 m);
robot Flyer {
  body     radius 25 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point3  error 2 cm   max_age 50 ms;
  sense    velocity : vector3 error 2 cm/s max_age 50 ms;
  output   thrust   : acceleration;
  latency  20 ms;
}
fleet one : Flyer;
controller nav  : advanced for Flyer extern;
controller back : safe for Flyer = retreat within core speed 0.3 m/s;
monitor keep for r : Flyer { "SR-1" always )" +
           permit + "clearance(r, pen) >= " + least + R"(; recover back; }
decision go for Flyer { advanced nav; period 50 ms; priority keep; }
)";
  };
  for (const char* const permit : {"", "permit or "}) {
    const Json proved = report_of(page("0 m", permit));
    ASSERT_EQ(p2a_of(proved)["status"], "proved") << p2a_of(proved);
    Json out = report_of(page("-0.4 m", permit));
    EXPECT_EQ(p2a_of(out)["status"], "unknown") << p2a_of(out);
    for (Json& o : out["decisions"][0]["obligations"]) {
      if (o["obligation"] == "P2a") o = p2a_of(proved);
    }
    expect_denied(out, "lead across what is not convex");
  }
}

TEST_F(ComingIn, AWiderBerthThanIsAskedKeepsADistance) {
  for (const char* const by : {"42 cm", "50 cm", "1 m"}) {
    const Json report = report_of(off_a_pond("room - grow(pond, " + std::string(by) + ")"));
    EXPECT_EQ(p2a_of(report)["status"], "proved") << by << p2a_of(report);
    EXPECT_EQ(rechecked(report).status, exit_clean) << by;
  }
}
// Round corners of an offset of several zones at once are not those of each of them alone.
TEST_F(ComingIn, AnOffsetOfSeveralZonesKeepsTheDistanceFromEach) {
  const auto page = [](const std::string& by) {
    return R"(spec museum;
zone hall = rectangle (0 m, 0 m) to (20 m, 15 m);
zone vase = circle (7 m, 7 m) radius 0.8 m;
zone statue = rectangle (13 m, 6 m) to (14 m, 9 m);
zone walk = hall - grow(vase | statue, )" +
           by + R"();
robot Guide {
  body     radius 28 cm;
  motion   point { speed <= 0.9 m/s; accel <= 0.8 m/s^2; brake >= 0.8 m/s^2; }
  sense    position : point  error 3 cm   max_age 100 ms;
  sense    velocity : vector error 2 cm/s max_age 100 ms;
  output   thrust   : acceleration;
  latency  50 ms;
}
fleet one : Guide;
controller tour : advanced for Guide extern;
controller back : safe for Guide = retreat within walk speed 0.3 m/s;
monitor off for r : Guide { "SR-1" always r inside hall and distance(r, vase) >= 40 cm and distance(r, statue) >= 40 cm; recover back; }
decision go for Guide { advanced tour; period 100 ms; priority off; }
)";
  };
  const Json proved = report_of(page("40 cm"));
  EXPECT_EQ(p2a_of(proved)["status"], "proved") << p2a_of(proved);
  EXPECT_EQ(rechecked(proved).status, exit_clean);
  Json nearer = report_of(page("39 cm"));
  EXPECT_NE(p2a_of(nearer)["status"], "proved") << p2a_of(nearer);
  for (Json& o : nearer["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") o = p2a_of(proved);
  }
  expect_denied(nearer, "it is not contained");
}
// With each of its values: who keeps the largest is in the zone, which is as far off as that or as
// most of them, and who keeps less is led in.
TEST_F(ComingIn, TheDistanceThatAParameterAsksForIsKept) {
  const Json within = report_of(off_a_pond("room - grow(pond, 1 m)", "gap"));
  EXPECT_EQ(p2a_of(within)["status"], "proved") << p2a_of(within);
  EXPECT_EQ(rechecked(within).status, exit_clean);
  const Json proved = report_of(off_a_pond("room - grow(pond, 1.2 m)", "gap"));
  EXPECT_EQ(p2a_of(proved)["status"], "proved") << p2a_of(proved);
  EXPECT_EQ(rechecked(proved).status, exit_clean);
  Json beside = report_of(off_a_pond("room - grow(pond, 1 m) - shelf", "gap"));
  EXPECT_EQ(p2a_of(beside)["status"], "unknown") << p2a_of(beside);
  for (Json& o : beside["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") o = p2a_of(within);
  }
  expect_denied(beside, "lead across what is not convex");
}
// Beside walls the zone leaves out what a robot strays, and is as far from the pond as is asked and
// no farther: with less clearance in the zone it may be led past the pond with no more.
TEST_F(ComingIn, WhatStraysHasToFitBesideWallsThatTheZoneLeavesOut) {
  const auto statuses_of = [](const std::string& off, const std::string& asked) {
    const std::string text = off_a_pond("shrink(room, 12 cm) - grow(pond, " + off + ")", asked);
    return p2a_of(report_of(edited(edited(text, "error 1 cm ", "error 5 cm "), "error 1 cm/s",
                                   "error 8 cm/s")))["status"];
  };
  for (const char* const asked : {"1 m", "gap"}) {
    EXPECT_EQ(statuses_of("1 m", asked), "unknown") << asked;
    EXPECT_EQ(statuses_of("1.3 m", asked), "proved") << asked;
  }
}
// Beside a shelf that only the zone leaves out, legs keep no more of the clearance in it than
// little, and pass a wall nearer than is asked.
TEST_F(ComingIn, WhatOnlyTheZoneLeavesOutIsNoBerth) {
  const Json proved = report_of(off_a_pond("room - grow(pond, 42 cm)"));
  const std::string beside = off_a_pond("room - grow(pond, 42 cm) - shelf");
  Json report = report_of(beside);
  EXPECT_EQ(p2a_of(report)["status"], "unknown") << p2a_of(report);
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") o = p2a_of(proved);
  }
  const Outcome denied = rechecked(report);
  EXPECT_EQ(denied.status, exit_violation);
  EXPECT_NE(denied.out.find("lead across what is not convex"), std::string::npos) << denied.out;
  EXPECT_NE(p2a_of(report_of(off_a_pond("room - grow(walls, 42 cm) - shelf")))["status"], "proved");
}

// An arm of a hall, of which its zone leaves so much out along one wall. Where no body fits beside
// the zone, one may be in it with little clearance, and led round the corner of the hall with no
// more.
TEST_F(ComingIn, WhoHasLittleClearanceInItsZoneMayLoseThatOfTheFence) {
  const auto beside = [](const std::string& wall) {
    return R"(spec arm;
zone hall = rectangle (0 m, 1.3 m) to (4 m, 4 m) | rectangle (3.5 m, )" +
           wall + R"() to (7 m, 1.5 m);
zone core = rectangle (0 m, 1.3 m) to (4 m, 4 m) | rectangle (3.5 m, 1 m) to (7 m, 1.5 m);
robot Rover {
  body     radius 10 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 5 mm    max_age 20 ms;
  sense    velocity : vector  error 1 cm/s  max_age 20 ms;
  output   thrust   : acceleration;
  latency  20 ms;
}
fleet one : Rover;
controller pilot : advanced for Rover extern;
controller back  : safe for Rover = retreat within core speed 0.2 m/s;
monitor m for r : Rover { "SR-1" always r inside hall; ahead 200 ms; recover back; }
decision go for Rover { advanced pilot; period 20 ms; priority m; }
)";
  };
  const Json same = report_of(beside("1 m")), report = report_of(beside("0.92 m"));
  EXPECT_EQ(p2a_of(same)["status"], "proved") << p2a_of(same);
  EXPECT_EQ(p2a_of(report)["status"], "unknown") << p2a_of(report);
  Json forged = report;
  for (Json& o : forged["decisions"][0]["obligations"]) {
    if (o["obligation"] == "P2a") o = p2a_of(same);
  }
  const Outcome denied = rechecked(forged);
  EXPECT_EQ(denied.status, exit_violation);
  EXPECT_NE(denied.out.find("lead across what is not convex"), std::string::npos) << denied.out;
}

TEST_F(ComingIn, WhoKeepsItsHeightKeepsAZoneThatHasSome) {
  const Json report =
      report_of(at_a_height("= retreat within flat speed 0.3 m/s", "r inside hall"));
  expect_proved(report);
  expect_denied(without(report, "level"), "it rests on no claim `level`");
}

TEST_F(ComingIn, ALandingThatStraysBelowItsLimitIsDenied) {
  const std::string below = "r.position.z >= 1 m";
  const Json proved = report_of(at_a_height("= land to 2 m speed 0.3 m/s", below));
  expect_proved(proved);
  expect_denied(said_of(at_a_height("= land to 1 m speed 0.3 m/s", below,
                                    "acknowledge back may break m \"a test\";"),
                        proved),
                "may go beyond a height");
}

TEST_F(ComingIn, TheHeightOfWhatIsExternalIsDenied) {
  const std::string below = "r.position.z <= 5 m";
  const Json proved = report_of(at_a_height("= retreat within flat speed 0.3 m/s", below));
  expect_proved(proved);
  const std::string accepted = "acknowledge back may break m \"a test\";";
  const std::string bought = "extern keeps inside flat speed <= 0.6 m/s";
  expect_denied(said_of(at_a_height(bought, below, accepted), proved), "may go beyond a height");
}

// The one looks farther ahead than the other, which alone limits the height.
TEST_F(ComingIn, EachLimitOfHeightIsLookedAtAsFarAsItsMonitorLooks) {
  const Json report = report_of(at_a_height("= land to 1 m speed 0.3 m/s", "r.position.z <= 7 m"));
  for (const Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] == "joint return") {
      EXPECT_EQ(o["status"], "proved") << o;
    }
  }
  expect_proved(report);
}

// Near the ceiling it comes to rest as near to it.
TEST_F(ComingIn, WhoKeepsItsHeightIsNotGivenBackNearACeiling) {
  std::string text = at_a_height("= retreat within flat speed 0.3 m/s", "r inside hall");
  const std::string stands = "recover stop; hold when violated \"a test\";";
  text.replace(text.rfind(stands), stands.size(), "recover back;");
  Json report = report_of(text);
  int found = 0;
  for (Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] == "joint return") {
      EXPECT_EQ(o["status"], "proved") << o;
    }
    if (o["obligation"] != "P2b" || o.value("monitor", "") != "m") continue;
    ++found;
    EXPECT_EQ(o["status"], "unknown") << o;
    EXPECT_NE(o["because"].get<std::string>().find("near the floor or the ceiling of `hall`"),
              std::string::npos);
  }
  EXPECT_EQ(found, 1);
}

// A spring that asks for more than the brake has drives past the ends of its legs.
TEST_F(ComingIn, WhoFallsBehindItsHoldKeepsNothing) {
  std::string text = at_a_height("= retreat within flat speed 0.9 m/s", "r inside hall");
  const Json proved = report_of(text);
  const std::string brake = "brake >= 1 m/s^2";
  text.replace(text.find(brake), brake.size(), "brake >= 0.3 m/s^2");
  Json report = report_of(text);
  for (Json& o : report["decisions"][0]["obligations"]) {
    const std::string kind = o["obligation"], of = o.value("monitor", "");
    const bool moves = (kind == "P2a" && of == "fence") || (kind == "C" && of == "m");
    if (!moves) continue;
    EXPECT_EQ(o["status"], "unknown") << o;
    EXPECT_NE(o["because"].get<std::string>().find("its brake is strong enough"),
              std::string::npos);
  }
  Json copied = proved;
  pair_in(report)["status"] = "proved";
  pair_in(report)["claims"] = pair_in(copied)["claims"];
  expect_denied(report, "its brake is too weak to follow the hold");
}

// Where two places that a body may be in overlap it may be in both.
TEST(ComingInOnceMore, PlacesThatOverlapAreAllLookedAt) {
  const auto box_of = [](long left, long low, long right, long top) {
    return geometry::Region::of_rings({{{left, low}, {right, low}, {right, top}, {left, top}}});
  };
  const auto room = box_of(4, 1, 8, 2), all = box_of(0, 0, 12, 12);
  const auto pillar =
      geometry::Region::of_rings({all.rings().front(), {{5, 3}, {5, 7}, {7, 7}, {7, 3}}});
  const auto leads_across = [&](const geometry::Region& fence, std::size_t starts) {
    recheck::EnteringLimits limits{0.3, 0.3, 0.3, 0.3, 0.3, 0.002};
    limits.starts.assign(starts, all);
    const auto found = recheck::enters_beyond(room, {100, 4000, 1000}, fence, limits);
    const auto* const from = std::get_if<std::optional<geometry::Point>>(&found);
    return from != nullptr && from->has_value();
  };
  EXPECT_FALSE(leads_across(all, 2));
  EXPECT_TRUE(leads_across(pillar, 1));
  EXPECT_TRUE(leads_across(pillar, 2));
}

// What its own monitor gives a robot counts while somebody is accepted to break it for no other
// one.
TEST_F(ComingIn, WhatAnotherMayBreakIsNoStandoff) {
  const std::string text = "spec off;\n" + std::string(R"(
zone hall = rectangle (0 m, 0 m) to (10 m, 10 m);
zone pit = rectangle (4 m, 4 m) to (6 m, 6 m);
zone yard = hall - pit;
)") + a_rover + R"(
controller back : safe for Rover = retreat within yard speed 0.3 m/s;
controller halt : safe for Rover = retreat within hall speed 0.3 m/s;
monitor out for r : Rover { "SR-1" always clearance(r, yard) >= 30 cm; recover back; }
monitor m for r : Rover { "SR-2" always clearance(r, hall) >= 30 cm; recover halt; }
decision go for Rover { advanced drive; period 50 ms; priority out > m; }
)";
  Json report = report_of(text);
  expect_proved(report);
  const std::string accepted =
      edited(text, "out > m;", "out > m; acknowledge halt may break out \"x\";");
  const Json open = report_of(accepted);
  for (const Json& o : open["decisions"][0]["obligations"]) {
    if (o["obligation"] == "C" && o["monitor"] == "m") {
      EXPECT_EQ(o["status"], "unknown") << o;
    }
  }
  report = report_of(text);
  write("certificates/sources/spec.rta", accepted);
  expect_denied(report, "nothing says that `back` keeps so far from `hall`");
}

// Straight down to above the trees, whatever lies between them; not to where they are.
TEST_F(ComingIn, ALandingEndsAboveWhatIsNarrowerBelow) {
  const auto page = [](const std::string& height) {
    return R"(spec orchard;
zone orchard = prism (rectangle (0 m, 0 m) to (60 m, 40 m)) from 0 m to 40 m - prism (rectangle (20 m, 10 m) to (40 m, 30 m)) from 0 m to 6 m;
robot Quad {
  body    radius 30 cm;
  motion  point { speed <= 3 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense   position : point3  error 5 cm   max_age 50 ms;
  sense   velocity : vector3 error 5 cm/s max_age 50 ms;
  output  thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller back   : safe for Quad = retreat within orchard speed 0.6 m/s;
controller down   : safe for Quad = land to )" +
           height + R"( speed 0.5 m/s;
monitor roof  for r : Quad { "R1: below 20 m" always r.position.z <= 20 m; recover down; }
monitor trees for r : Quad { "R2: off the trees" always r inside orchard; recover back; }
decision fly for Quad { advanced policy; period 50 ms; priority roof > trees; }
)";
  };
  const Json report = report_of(page("7 m"));
  int pairs = 0;
  for (const Json& o : report["decisions"][0]["obligations"]) {
    if (o["obligation"] != "C") continue;
    ++pairs;
    EXPECT_EQ(o["status"], "proved") << o;
  }
  EXPECT_EQ(pairs, 2);
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_inconclusive) << again.out << again.err;  // switching
  EXPECT_NE(again.out.find(" 0 not proved"), std::string::npos) << again.out;
  for (const char* height : {"5 m", "6.1 m"}) {
    write("certificates/sources/spec.rta", page(height));
    expect_denied(report, "the way down of `down` need not lie in `orchard`");
  }
}

}  // namespace
}  // namespace rtac::driver::test
