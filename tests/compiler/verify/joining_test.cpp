// That control comes back is shown from everywhere: from the middle of narrow passages, too, and to
// where a robot without errors of its own is measured.

#include <cmath>

#include "compiler/recheck/zones.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class Joining : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static std::string at_the_end_of(const std::string& passage) {
    return "spec ends;\nzone hall = rectangle (0 m, 0 m) to (6 m, " + passage +
           R"() | rectangle (6 m, 0 m) to (12 m, 6 m);
robot Cart {
  body     radius 15 cm;
  motion   unicycle { speed <= 0.6 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 8 rad/s^2; }
  sense    position : point  error 2 cm   max_age 100 ms;
  sense    heading  : angle  error 2 deg  max_age 100 ms;
  sense    velocity : vector error 1 cm/s max_age 100 ms;
  output   drive : twist;
  latency  40 ms;
}
fleet cart : Cart;
controller work : advanced for Cart extern;
controller back : safe for Cart = retreat within hall speed 0.3 m/s;
monitor fence for c : Cart { "R1: in the hall" always c inside hall; ahead 200 ms; recover back; }
decision drive for Cart { advanced work; period 100 ms; priority fence; }
)";
  }
};

// No cell of it is all as clear as its middle is, and a recovery gives up no clearance.
TEST_F(Joining, FromTheMiddleOfANarrowPassageNothingLeadsBack) {
  const Outcome o = verified(at_the_end_of("70 cm"), {"--format", "json"});
  EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"refuted"}) << o.out;
  const Outcome again = rtac({"sim", "spec.rta", "--replay", "spec.trace"});
  EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
}
TEST_F(Joining, FromAWiderOneThereIsAWay) {
  const Outcome o = verified(at_the_end_of("1.1 m"), {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"proved"}) << o.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
}

// In the long aisles of a house the end is only just within the cells that are tried: the recheck
// counts as the recovery does, and no cell that is less clear by a hair.
TEST_F(Joining, ALongAisleIsLookedAlongAsFarByTheRecheck) {
  const Outcome o = verified(R"(spec rows;
zone house = rectangle (0 m, 0 m) to (20 m, 12 m);
zone beds  = rectangle (1.4 m, 1.4 m) to (18.6 m, 4.498 m) | rectangle (1.402 m, 5.902 m) to (18.6 m, 10.598 m);
zone paths = house - beds;
robot Picker {
  body     radius 130 mm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point  error 3 cm   max_age 60 ms;
  sense    velocity : vector error 3 cm/s max_age 60 ms;
  output   push : acceleration;
  latency  40 ms;
}
fleet pk : Picker;
controller pick : advanced for Picker extern;
controller back : safe for Picker = retreat within paths speed 0.2 m/s;
monitor m for p : Picker { "G1: on the paths" always p inside paths; ahead 100 ms; recover back; }
decision guard for Picker { advanced pick; period 50 ms; priority m; }
)",
                             {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(o.out, "P2b", "m"), Statuses{"proved"}) << o.out << o.err;
  const Outcome again = rtac({"verify", "--recheck", "shown"});
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

// Who is seen with less than its body takes makes straight for where it is seen to fit, and takes
// no detours: round the bend of a narrow passage no such place is in sight.
TEST(JoiningOnceMore, WhoIsSeenToBeOutsideHasToSeeWhereItFits) {
  const auto lost = [](bool bent, const Rational& fits) {
    const auto zone = geometry::Region::of_rings(
        {bent ? geometry::Ring{{0, 0},
                               {6, 0},
                               {6, 6},
                               {0, 6},
                               {0, 2},
                               {-3, 2},
                               {-3, 5},
                               {-4, 5},
                               {-4, 1},
                               {0, 1}}
              : geometry::Ring{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 2}, {-4, 2}, {-4, 1}, {0, 1}}});
    const auto found =
        recheck::without_leg(zone, {100, -4000, 0}, Rational(10, 100), Rational(10, 100), 0, fits);
    EXPECT_FALSE(std::holds_alternative<recheck::BadCells>(found));
    return std::holds_alternative<geometry::Point>(found);
  };
  EXPECT_FALSE(lost(false, Rational(3, 10)));
  EXPECT_FALSE(lost(true, Rational(3, 10)));
  EXPECT_TRUE(lost(true, Rational(7, 10)));
}

// Between shelves that are as far apart as a robot is wide, and hardly less, nobody is; its error
// shows it there no deeper than where it fits.
TEST_F(Joining, ANicheThatIsNarrowerThanTheBodyHoldsNobody) {
  for (const char* wide : {"3.38 m", "3.37 m", "3.3 m"}) {
    const Outcome o = verified(
        std::string("spec niche;\nzone hall = rectangle (0 m, 0 m) to (11 m, 8 m)\n"
                    "  - rectangle (4 m, 2 m) to (7 m, 3 m)\n"
                    "  - rectangle (4 m, ") +
            wide + ") to (7 m, 5 m);\n" + edited(a_rover, "point error 2 cm", "point error 3 cm") +
            "controller back : safe for Rover = retreat within hall speed 0.3 m/s;\n"
            "monitor fence for r : Rover { \"R1\" always r inside hall; recover back; }\n"
            "decision go for Rover { advanced drive; period 50 ms; priority fence; }\n",
        {"-o", "certificates"});
    EXPECT_EQ(o.status, exit_clean) << wide << o.out << o.err;
    EXPECT_EQ(rtac({"verify", "--recheck", "certificates"}).status, exit_clean) << wide;
  }
}

TEST(JoiningOnceMore, FindsNarrowPassagesItself) {
  const auto ends = [](const Rational& wide) {
    const auto zone =
        geometry::Region::of_rings({{{0, 0}, {12, 0}, {12, 6}, {6, 6}, {6, wide}, {0, wide}}});
    const auto found = recheck::without_way(zone, {100, 0, 0}, Rational(15, 100),
                                            Rational(482, 1000), Rational(7, 10), {});
    return std::holds_alternative<geometry::Point>(found);
  };
  EXPECT_TRUE(ends(Rational(7, 10)));
  EXPECT_FALSE(ends(Rational(11, 10)));
}

// Of very many edges distances are exact as far as the tables have room for: farther off nothing is
// seen to be as clear as it is.
TEST_F(Joining, WhereTablesEndNothingGivesControlBack) {
  const auto round_of = [](int edges, const std::string& clearance) {
    std::string ring;
    for (int i = 0; i < edges; ++i) {
      const double a = 2 * M_PI * i / edges, r = 1.1 + (i % 2 != 0 ? 0.02 : 0);
      const auto text = [](double m) { return std::to_string(std::lround(m * 1000)) + " mm"; };
      ring += (i > 0 ? ", (" : "(") + text(2.1 + r * std::cos(a)) + ", " +
              text(2.1 + r * std::sin(a)) + ")";
    }
    return "spec round;\nzone hall = polygon [" + ring + "];\n" + a_rover + R"(
controller back : safe for Rover = retreat within hall speed 0.3 m/s;
monitor fence for r : Rover { "R1" always clearance(r, hall) >= )" +
           clearance + R"(; ahead 50 ms; recover back; }
decision go for Rover { advanced drive; period 50 ms; priority fence; }
)";
  };
  Outcome o = verified(round_of(1300, "50 cm"), {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"unknown"}) << o.out;
  EXPECT_EQ(statuses(o.out, "joint return", ""), Statuses{"unknown"}) << o.out;
  o = verified(round_of(1100, "40 cm"), {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"proved"}) << o.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  Json report = Json::parse(read("shown/verification.json"));
  int cut = 0;
  for (Json& each : report["decisions"][0]["obligations"]) {
    for (Json& c : each["claims"]) {
      if (c["claim"] != "ways") continue;
      ++cut;
      const std::int64_t back = std::stoll(c["return_mm"].get<std::string>());
      EXPECT_GE(std::stoll(c["exact_mm"].get<std::string>()), back);
      c["exact_mm"] = std::to_string(back - 1);
    }
  }
  EXPECT_EQ(cut, 1);
  write("shown/verification.json", report.dump());
  fs::rename("shown", "certificates");
  o = recheck_sealed_anew();
  EXPECT_EQ(o.status, exit_violation) << o.out;
  EXPECT_NE(o.out.find("farther from the boundary than the tables are exact"), std::string::npos);
}

// Nor counts a cell that is a millimetre less clear than is asked; of an outline between the lines
// of the grid that is the one that a robot has.
TEST(JoiningOnceMore, GoalsAreAsClearAsIsAskedOnTheGrid) {
  const auto leads_to = [](const Rational& left, const Rational& goal) {
    const auto zone = geometry::Region::of_rings({{{left, left}, {4, left}, {4, 4}, {left, 4}}});
    const auto found = recheck::without_way(zone, {100, left > 0 ? 1 : 0, left > 0 ? 1 : 0},
                                            Rational(15, 100), Rational(3, 10), goal, {});
    return std::holds_alternative<std::monostate>(found);
  };
  EXPECT_TRUE(leads_to(0, Rational(1900, 1000)));
  EXPECT_FALSE(leads_to(0, Rational(1901, 1000)));
  // from 1 mm on in the tables
  EXPECT_TRUE(leads_to(Rational(2, 10000), Rational(1900, 1000)));
  EXPECT_FALSE(leads_to(Rational(2, 10000), Rational(1901, 1000)));
}

// Cells along the middle of its corners have no neighbour that is clearer, and a leg leads straight
// out of them.
TEST_F(Joining, OutOfTheCornersOfARhombusALegLeadsStraight) {
  const std::string rhombus =
      edited(at_the_end_of("6 m"),
             "rectangle (0 m, 0 m) to (6 m, 6 m) | rectangle (6 m, 0 m) to (12 m, 6 m)",
             "polygon [(0 m, 0 m), (10 m, 2 m), (12 m, 12 m), (2 m, 10 m)]");
  const Outcome o = verified(rhombus, {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"proved"}) << o.out;
  EXPECT_NE(o.out.find(" s in all"), std::string::npos) << o.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  write("s.json", R"({"duration_s": 60, "return_within_s": 55, "runs": 24, "seed": 500})");
  const Outcome run = rtac({"sim", "spec.rta", "--scenario", "s.json"});
  EXPECT_EQ(run.status, exit_clean) << run.out << run.err;
}
// A cart that gives control back where it has almost all of the room that there is.
std::string a_hall_with(const std::string& error, const std::string& ahead) {
  return edited(edited(R"(spec rim;
zone hall = rectangle (0 m, 0 m) to (20 m, 12 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 1.2 m  max_age 60 ms;
  sense   velocity : vector error 2 cm/s max_age 60 ms;
  output  push : acceleration;
  latency 30 ms;
}
fleet c : Cart;
controller nav  : advanced for Cart extern;
controller back : safe for Cart = retreat within hall speed 0.4 m/s;
monitor fence for r : Cart { "R1: in the hall" always r inside hall; ahead 0.1 s; recover back; }
decision drive for Cart { advanced nav; period 50 ms; priority fence; }
)",
                       "error 1.2 m", error),
                "ahead 0.1 s", "ahead " + ahead);
}

// The clearest cells of the hall have 5.9 m: control that is given back there, or a little short of
// it, is given back; the certificate and the recheck agree to the millimetre where all edges run
// along the axes.
TEST_F(Joining, UpToTheRimOfTheClearestCellsControlComesBack) {
  for (const auto& [error, ahead, clearance] :
       {std::tuple("1.292 m", "100 ms", "5897"), std::tuple("1.293 m", "98 ms", "5900")}) {
    const Outcome o = verified(a_hall_with(std::string("error ") + error, ahead), {"-o", "shown"});
    EXPECT_EQ(o.status, exit_clean) << error << o.out << o.err;
    EXPECT_EQ(recheck_sealed_anew("shown").status, exit_clean) << error;
    Json report = Json::parse(read("shown/verification.json"));
    bool any = false;
    for (Json& obligation : report["decisions"][0]["obligations"]) {
      for (Json& claim : obligation["claims"]) {
        if (claim["claim"] != "ways") continue;
        any = true;
        EXPECT_EQ(claim["return_mm"], clearance);
        claim["return_mm"] = "5901";
      }
    }
    EXPECT_TRUE(any);
    write("shown/verification.json", report.dump());
    EXPECT_EQ(recheck_sealed_anew("shown").status, exit_violation) << error;
  }
}
// Round about, the recheck knows the clearances of cells to 4 mm only: the report does not claim
// what the recheck would not find.
TEST_F(Joining, OnTheRimOfARoundZoneItIsNotKnown) {
  const auto hall = [](const std::string& error) {
    return edited(edited(a_hall_with("error 1.2 m", "100 ms"),
                         "rectangle (0 m, 0 m) to (20 m, 12 m)", "circle (0 m, 0 m) radius 6 m"),
                  "error 1.2 m", "error " + error);
  };
  const Outcome rim = verified(hall("1.28 m"), {"--format", "json"});
  EXPECT_EQ(statuses(rim.out, "P2b", "fence"), Statuses{"unknown"}) << rim.out;
  EXPECT_NE(rim.out.find("to be seen by the recheck it takes 5.853 m"), std::string::npos);
  const Outcome o = verified(hall("1.278 m"), {"-o", "shown"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
  EXPECT_EQ(recheck_sealed_anew("shown").status, exit_clean);
}
// Along walls that slant between corners on the grid it knows them to the millimetre: what the
// report claims with nothing to spare, it finds.
TEST_F(Joining, OnTheRimOfASlantingZoneItIsKnown) {
  const auto yard = [](const std::string& kept) {
    return R"(spec rim;
zone yard = polygon [(0 m, 0 m), (9 m, -3 m), (13 m, 5 m), (4 m, 7 m)];
robot Bot {
  body radius 30 cm;
  motion point { speed <= 0.6 m/s; accel <= 0.8 m/s^2; brake >= 1.2 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output push : acceleration;
  latency 50 ms;
}
fleet bot : Bot;
controller run : advanced for Bot extern;
controller back : safe for Bot = retreat within yard speed 0.4 m/s;
monitor walls for r : Bot { "R1: off the walls" always clearance(r, yard) >= )" +
           kept + R"(; recover back; }
decision drive for Bot { advanced run; period 50 ms; priority walls; }
)";
  };
  const Outcome o = verified(yard("3372 mm"), {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(o.out, "P2b", "walls"), Statuses{"proved"}) << o.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  const Outcome rim = verified(yard("3373 mm"), {"--format", "json"});
  EXPECT_EQ(statuses(rim.out, "P2b", "walls"), Statuses{"unknown"}) << rim.out;
}
// Cells of tens of metres touch its boundary all round, and hold no way; a leg leads straight in.
TEST_F(Joining, InAConvexZoneOfManyKilometresLegsLeadStraight) {
  const std::string octagon =
      "polygon [(0 m, 3000 m), (3000 m, 0 m), (7000 m, 0 m), (10000 m, 3000 m), (10000 m, 7000 m), "
      "(7000 m, 10000 m), (3000 m, 10000 m), (0 m, 7000 m)]";
  const std::string wide =
      edited(at_the_end_of("6 m"),
             "rectangle (0 m, 0 m) to (6 m, 6 m) | rectangle (6 m, 0 m) to (12 m, 6 m)", octagon);
  const Outcome o = verified(wide, {"--format", "json", "-o", "shown"});
  EXPECT_EQ(statuses(o.out, "P2b", "fence"), Statuses{"proved"}) << o.out;
  EXPECT_EQ(rtac({"verify", "--recheck", "shown"}).status, exit_clean);
  // beside a lake nobody knows, and no run begins outside of the zone
  const Outcome lake =
      verified(edited(wide, octagon, octagon + " - rectangle (4000 m, 4000 m) to (5000 m, 5000 m)"),
               {"--format", "json"});
  EXPECT_EQ(statuses(lake.out, "P2b", "fence"), Statuses{"unknown"}) << lake.out;
}
TEST(JoiningOnceMore, FindsLegsOutOfCornersItself) {
  const auto ends = [](const geometry::Ring& ring, const Rational& back) {
    const auto found = recheck::without_way(geometry::Region::of_rings({ring}), {100, 0, 0},
                                            Rational(30, 100), Rational(482, 1000), back, {});
    return std::holds_alternative<geometry::Point>(found);
  };
  const geometry::Ring rhombus = {{0, 0}, {10, 2}, {12, 12}, {2, 10}};
  EXPECT_FALSE(ends(rhombus, Rational(62, 100)));
  EXPECT_TRUE(ends(rhombus, 6));  // nowhere is that much
  // round the bend of a passage along the diagonal nothing is in sight
  const geometry::Ring bent = {
      {0, 0}, {Rational(13, 10), 0}, {7, Rational(57, 10)}, {13, 0}, {18, 0}, {18, 5}, {7, 7}};
  EXPECT_TRUE(ends(bent, Rational(62, 100)));
}

// It rests where the decision, which sees a millimetre more or less, gives control back.
TEST_F(Joining, WithoutErrorsOfTheSensorsControlComesBackAsWell) {
  write("spec.rta", R"(spec exact;
zone yard = rectangle (0 m, 0 m) to (6 m, 6 m);
robot Bot {
  body radius 10 cm;
  motion point { speed <= 2 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense position : point error 0 cm max_age 10 ms;
  sense velocity : vector error 0 cm/s max_age 10 ms;
  output thrust : acceleration;
  latency 5 ms;
}
fleet bot : Bot;
controller drive : advanced for Bot extern;
controller back : safe for Bot = retreat within yard speed 0.5 m/s;
monitor fence for b : Bot { "R1: in the yard" always b inside yard; recover back; }
decision step for Bot { advanced drive; period 20 ms; priority fence; }
)");
  write("s.json", R"({"duration_s": 60, "return_within_s": 15, "runs": 24, "seed": 500})");
  const Outcome o = rtac({"sim", "spec.rta", "--scenario", "s.json"});
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

// A lane with an angle leaves most of the box around it empty, where nobody has to be led in from;
// and a monitor that asks for no clearance of its own is led in from as near as it lets robots be.
TEST_F(Joining, AnAngledLaneIsLedIntoFromWhereRobotsCanBe) {
  const auto lane = [](const std::string& asked) {
    return R"(spec bend;
zone lane = rectangle (0 m, 0 m) to (30 m, 4 m) | rectangle (26 m, 0 m) to (30 m, 22 m);
robot Tugger {
  body     radius 60 cm;
  motion   unicycle { speed <= 1.5 m/s; turn <= 1 rad/s; accel <= 0.6 m/s^2; brake >= 1.2 m/s^2; turn_accel <= 3 rad/s^2; }
  sense    position : point   error 4 cm    max_age 100 ms;
  sense    heading  : angle   error 1 deg   max_age 100 ms;
  sense    velocity : vector  error 3 cm/s  max_age 100 ms;
  output   drive    : twist;
  latency  50 ms;
}
fleet tug : Tugger;
controller nav  : advanced for Tugger extern;
controller back : safe for Tugger = retreat within lane speed 0.4 m/s;
monitor walls for t : Tugger { "R1: in the lane" always )" +
           asked + R"(; recover back; }
monitor slow  for t : Tugger { "R2: slow" always t.speed <= 0.8 m/s; recover back; }
decision go for Tugger { advanced nav; period 50 ms; priority walls > slow; }
)";
  };
  for (const std::string asked : {"t inside lane", "clearance(t, lane) >= 20 cm"}) {
    const Outcome o = verified(lane(asked), {"--format", "json", "-o", "proofs"});
    EXPECT_EQ(statuses(o.out, "P2b", "walls"), Statuses{"proved"}) << asked << o.out;
    EXPECT_EQ(statuses(o.out, "P2b", "slow"), Statuses{"proved"}) << asked << o.out;
    const Outcome again = recheck_sealed_anew("proofs");
    EXPECT_EQ(again.status, exit_clean) << asked << again.out << again.err;
  }
}

}  // namespace
}  // namespace rtac::driver::test
