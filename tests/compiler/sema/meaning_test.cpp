// What the checked specification says about forms that the yard does not use.
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

// The property of `fence` after replacing it.
std::string property(const std::string& written) {
  const auto checked = check_text(edited(yard(), {{"r inside free", written}}));
  if (!checked->spec) return checked->reports();
  return dump(*checked->spec, *checked->spec->monitors[1].always);
}

std::string zone(const std::string& written) {
  const auto checked =
      check_text(edited(yard(), {{"rectangle (2 m, 2 m) to (3 m, 3 m)", written}}));
  if (!checked->spec) return checked->reports();
  return dump(*checked->spec, *checked->spec->zones[1].value);
}

TEST(Meaning, PropertiesKeepTheirStructure) {
  EXPECT_EQ(property("not (r inside box)"), "(not (self inside box))");
  EXPECT_EQ(property("r inside free and r.speed <= 36 km/h or true"),
            "(((self inside free) and (self.speed <= 10 m/s)) or true)");
  EXPECT_EQ(property("r inside box implies r.battery > 20 %"),
            "((self inside box) implies (self.battery > 20 %))");
  EXPECT_EQ(property("(r inside box) iff (r.speed < 1 m/s)"),
            "((self inside box) iff (self.speed < 1 m/s))");
  EXPECT_EQ(property("(r inside box) xor (r.speed < 1 m/s)"),
            "((self inside box) xor (self.speed < 1 m/s))");
}

TEST(Meaning, ConstantsAreFoldedExactly) {
  EXPECT_EQ(property("clearance(r, free) >= 1 m - 2 * 35 cm"), "(clearance(self, free) >= 0.3 m)");
  EXPECT_EQ(property("clearance(r, free) >= 0.5 m/s * 200 ms"), "(clearance(self, free) >= 0.1 m)");
  EXPECT_EQ(property("clearance(r, free) >= -(1 m / 4)"), "(clearance(self, free) >= -0.25 m)");
}

TEST(Meaning, ArithmeticOfSignalsHasItsDimension) {
  EXPECT_EQ(property("clearance(r, free) >= r.speed * 100 ms"),
            "(clearance(self, free) >= (self.speed * 0.1 s))");
  EXPECT_EQ(property("-clearance(r, box) <= 0 m"), "((-clearance(self, box)) <= 0 m)");
  EXPECT_EQ(property("r.battery / 2 >= 10 %"), "((self.battery / 2) >= 10 %)");
}

// How old a sample is says nothing of where the robot will be: it is judged now.
TEST(Meaning, MeasurementsOfTheRobotHaveAnAge) {
  EXPECT_EQ(property("age(r.position) <= 50 ms"), "(age(self.position) <= 0.05 s)");
  EXPECT_EQ(property("once[0 s, 1 s] age(r.battery) <= age(r.velocity)"),
            "(once[0 s, 1 s] (age(self.battery) <= age(self.velocity)))");
}

// The gap from what lies outside of a zone is what it is clear of its boundary.
TEST(Meaning, ADistanceIsFromAnyZone) {
  EXPECT_EQ(property("distance(r, complement(box)) >= 1 m"), property("clearance(r, box) >= 1 m"));
  EXPECT_EQ(property("distance(r, grow(box, 1 m)) >= 1 m"),
            property("clearance(r, complement(grow(box, 1 m))) >= 1 m"));
}

TEST(Meaning, QuantifiersSpeakOfTheOtherRobot) {
  EXPECT_EQ(property("exists q : Cart, r != q : distance(q, r) <= 1 m and q.speed <= 1 m/s"),
            "(exists other : ((distance(self, other) <= 1 m) and (other.speed <= 1 m/s)))");
}

// A comparison of the nearest is one of all, of the farthest one of some; sums and signs count.
TEST(Meaning, MinimaOverRobotsAreComparedOneByOne) {
  const std::string gap = "(q : Cart, q != r : distance(r, q))";
  EXPECT_EQ(property("min" + gap + " >= 1 m"), "(forall other : (distance(self, other) >= 1 m))");
  EXPECT_EQ(property("min" + gap + " <= 1 m"), "(exists other : (distance(self, other) <= 1 m))");
  EXPECT_EQ(property("max" + gap + " >= 1 m"), "(exists other : (distance(self, other) >= 1 m))");
  EXPECT_EQ(property("max" + gap + " < 1 m"), "(forall other : (distance(self, other) < 1 m))");
  EXPECT_EQ(property("1 m >= min" + gap), "(exists other : (1 m >= distance(self, other)))");
  EXPECT_EQ(property("1 m - 2 * min" + gap + " <= 3 m"),
            "(forall other : ((1 m - (2 * distance(self, other))) <= 3 m))");
}

TEST(Meaning, ACountOfRobotsIsAWholeNumber) {
  EXPECT_EQ(property("count(q : Cart, q != r : distance(r, q) <= 1 m) <= 2"),
            "(count(other : (distance(self, other) <= 1 m)) <= 2)");
  EXPECT_EQ(property("count(q : Cart, q != r : distance(r, q) <= 1 m) == 2"),
            "((count(other : (distance(self, other) <= 1 m)) <= 2) and "
            "(count(other : (distance(self, other) <= 1 m)) >= 2))");
}

TEST(Meaning, RobotsOfANumberedFleetAreCalledByTheirNumber) {
  const auto checked =
      check_text(edited(yard(), {{"c1, c2 : Cart", "c1, c2 : Cart; fleet more : Cart[2]"},
                                 {"site  dock(c2)",
                                  "site dock(more[0]) = (1 m, 1 m); site "
                                  "dock(more[1]) = (1 m, 2 m); site  dock(c2)"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  ASSERT_EQ(checked->spec->robots.size(), 5u);
  EXPECT_EQ(checked->spec->robots[3].name, "more[1]");
}

TEST(Meaning, ASiteForAllRobotsNeedsNoRobot) {
  EXPECT_EQ(property("r.battery >= energy_to(home)"), "(self.battery >= energy_to(home(self)))");
  EXPECT_EQ(property("r.battery >= energy_to(home(r))"), "(self.battery >= energy_to(home(self)))");
}

// The only robot of its kind may be called by its name.
TEST(Meaning, TheOnlyRobotOfAKindIsTheMonitoredOne) {
  const auto checked = check_text(edited(yard(), {{"c1, c2 : Cart", "c1 : Cart"},
                                                  {"site  dock(c2) = (4 m, 4 m);", ""},
                                                  {"energy_to(dock(r))", "energy_to(dock(c1))"}}));
  EXPECT_TRUE(checked->spec) << checked->reports();
}

TEST(Meaning, ZonesOfPropertiesHaveNoName) {
  const auto checked =
      check_text(edited(yard(), {{"r inside free", "r inside grow(arena & free, 10 cm)"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  const Spec& spec = *checked->spec;
  ASSERT_EQ(spec.zones.size(), 5u);
  EXPECT_EQ(spec.zones[3].name, "");
  EXPECT_EQ(dump(spec, *spec.zones[3].value), "grow((arena & free), 0.1)");
  EXPECT_EQ(dump(spec, *spec.zones[4].value), "shrink(free, 0.26)");
}

TEST(Meaning, RectanglesTakeCornersInAnyOrder) {
  const std::string corners = "polygon [(2, 2), (3, 2), (3, 3), (2, 3)]";
  EXPECT_EQ(zone("rectangle (3 m, 3 m) to (2 m, 2 m)"), corners);
  EXPECT_EQ(zone("rectangle (2 m, 3 m) to (3 m, 2 m)"), corners);
  EXPECT_EQ(zone("rectangle (3 m, 2 m) to (200 cm, 3000 mm)"), corners);
}

// Orientation and validity are for geometry to judge: the vertices stay as written.
TEST(Meaning, PolygonsStayAsWritten) {
  EXPECT_EQ(zone("polygon [(2 m, 2 m), (2 m, 3 m), (3 m, 3 m)] hole [(2.1 m, 2.5 m), (2.2 m, 2.5 "
                 "m), (2.2 m, 2.6 m)] hole [(1 m, 1 m)]"),
            "polygon [(2, 2), (2, 3), (3, 3)] hole [(2.1, 2.5), (2.2, 2.5), (2.2, 2.6)] hole "
            "[(1, 1)]");
}

TEST(Meaning, ZonesMayBeComposed) {
  EXPECT_EQ(zone("circle (2 m, 2 m) radius 30 cm | grow(arena, 1 m) & shrink(arena, 5 cm)"),
            "(circle (2, 2) radius 0.3 | (grow(arena, 1) & shrink(arena, 0.05)))");
}

TEST(Meaning, AComplementIsOfAnyZone) {
  EXPECT_EQ(zone("complement(arena)"), "complement(arena)");
  EXPECT_EQ(zone("complement(grow(arena, 1 m) - arena) & arena"),
            "(complement((grow(arena, 1) - arena)) & arena)");
}

// A vertex keeps the place where it is written, so that geometry can point to it.
TEST(Meaning, VerticesKnowTheirPlaces) {
  const auto checked = check_text(edited(
      yard(),
      {{"rectangle (2 m, 2 m) to (3 m, 3 m)", "polygon [(2 m, 2 m), (3 m, 2 m), (3 m, 3 m)]"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  const auto& ring = std::get<ZonePolygon>(checked->spec->zones[1].value->node).outer;
  ASSERT_EQ(ring.point_ranges.size(), 3u);
  EXPECT_EQ(checked->sources.text(ring.point_ranges[1]), "(3 m, 2 m)");
}

struct Requirement {
  const char* written;
  const char* id;
  const char* text;
};

TEST(Meaning, ARequirementMayHaveAnId) {
  for (const Requirement& each :
       {Requirement{"SR-3: two robots: apart", "SR-3", "two robots: apart"},
        Requirement{"stay inside", "", "stay inside"},
        Requirement{"stay inside: always", "", "stay inside: always"},
        Requirement{": odd", "", ": odd"}, Requirement{"  R7:  spaced  ", "R7", "spaced"}}) {
    const auto checked =
        check_text(edited(yard(), {{"R2: carts stay in the free area", each.written}}));
    ASSERT_TRUE(checked->spec) << checked->reports();
    EXPECT_EQ(checked->spec->monitors[1].requirement_id, each.id);
    EXPECT_EQ(checked->spec->monitors[1].requirement_text, each.text);
  }
}

TEST(Meaning, ALookAheadKeepsItsTerms) {
  const auto checked = check_text(edited(
      yard(), {{"ahead   300 ms, 3 waypoints",
                "ahead 30 ms unsound \"slow\", 3 waypoints, points only unsound \"sparse\""}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  const Ahead& ahead = checked->spec->monitors[1].ahead;
  EXPECT_EQ(ahead.duration->value, Rational(3, 100));
  EXPECT_EQ(ahead.duration_unsound, "slow");
  EXPECT_EQ(ahead.waypoints, 3);
  EXPECT_TRUE(ahead.points_only);
  EXPECT_FALSE(ahead.waypoints_only);
  EXPECT_EQ(ahead.unsound_reason, "sparse");
  EXPECT_EQ(checked->sources.text(ahead.range),
            "30 ms unsound \"slow\", 3 waypoints, points only unsound \"sparse\"");
}

// What is offered instead of an unsound look-ahead judges legs only where there are any.
TEST(Meaning, ALookAheadOfNoPlanIsOfferedNoWaypoints) {
  const std::string rover = R"(spec yard;
zone room = rectangle (0 m, 0 m) to (9 m, 9 m);
robot Rover {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 50 ms;
  sense velocity : vector error 2 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet one : Rover;
controller drive : advanced for Rover extern;
controller back : safe for Rover = retreat within room speed 0.3 m/s;
monitor fence for r : Rover { "R1" always r inside room; ahead 10 ms unsound "study"; recover back; }
decision go for Rover { advanced drive; period 50 ms; priority fence; }
)";
  const std::vector<Change> plan = {
      {"output thrust", "input plan : path[8] tracking <= 5 cm;\n  output thrust"}};
  for (const bool plans : {false, true}) {
    const auto checked = check_text(plans ? edited(rover, plan) : rover);
    ASSERT_TRUE(checked->spec) << checked->reports();
    EXPECT_NE(checked->reports().find("5010"), std::string::npos);
    EXPECT_EQ(checked->reports().find("2 waypoints") != std::string::npos, plans);
  }
}

TEST(Meaning, ALookAheadMayBeLeftOut) {
  const auto checked = check_text(edited(yard(), {{"  ahead   300 ms, 3 waypoints;\n", ""}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  const Ahead& ahead = checked->spec->monitors[1].ahead;
  EXPECT_FALSE(ahead.duration);
  EXPECT_EQ(ahead.waypoints, 0);
  EXPECT_EQ(checked->sources.text(ahead.range), "fence");
}

// Messages point to the text, so each part must know its place.
TEST(Meaning, PartsKnowTheirPlaces) {
  const auto checked = check_text(yard());
  ASSERT_TRUE(checked->spec);
  const Spec& spec = *checked->spec;
  const auto text = [&](const SourceRange& range) { return checked->sources.text(range); };
  EXPECT_EQ(text(spec.name_range), "yard");
  EXPECT_EQ(text(spec.kinds[0].radius.range), "11 cm");
  EXPECT_EQ(text(spec.kinds[0].motion.brake.range), "2 m/s^2");
  EXPECT_EQ(text(spec.monitors[1].always_range), "r inside free");
  EXPECT_EQ(text(spec.monitors[1].recover_range), "turn_back");
  EXPECT_EQ(text(spec.decisions[0].period->range), "100 ms");
  EXPECT_EQ(text(spec.sites[0].places[1].range), "site  dock(c2) = (4 m, 4 m);");
}

}  // namespace
}  // namespace rtac::sema::test
