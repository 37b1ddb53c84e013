// Legs and paths: what a monitor without a robot may say about them.
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

std::unique_ptr<Checked> yard(const std::string& property) {
  return check_text(
      "spec yard;\nperiod 1 s;\nframe base;\nzone room = rectangle (0 m, 0 m) to (4 m, 3 m);\n"
      "zone pit = rectangle (1 m, 1 m) to (2 m, 2 m);\n"
      "zone bubble = circle (0 m, 0 m) radius 1 m around q;\n"
      "zone hall = prism (room) from 0 m to 3 m;\n"
      "input plan, other : path[4] max_age 1 s;\ninput away : path[4] @ base;\n"
      "input p, q : point in -9 .. 9 m;\ninput hand : point @ base in -9 .. 9 m;\n"
      "input s : point3 in -9 .. 9 m;\ninput x : real [m] in 0 .. 9 m;\n"
      "monitor all { \"R0: all\" always p.x + q.x + s.x + x + hand.x <= 9 m and not (plan inside "
      "room or other inside room) and distance(away, hand) <= 1 m; }\n"
      "monitor m { \"R1: a rule\" always " +
      property + "; }\n");
}
std::string meaning(const std::string& property) {
  const auto checked = yard(property);
  return checked->spec ? dump(*checked->spec, *checked->spec->watches[1].always)
                       : checked->reports();
}
void expect_said(const std::string& property, const std::string& code, const std::string& text) {
  const std::string said = meaning(property);
  EXPECT_NE(said.find(code), std::string::npos) << property << "\n" << said;
  EXPECT_NE(said.find(text), std::string::npos) << property << "\n" << said;
}

// Of a path all of it; an empty one leads nowhere.
TEST(Ways, LieInsideZones) {
  EXPECT_EQ(meaning("plan inside room"), "(given(plan) implies (plan inside room))");
  EXPECT_EQ(meaning("leg(p, q) inside room"), "(leg((p.x, p.y), (q.x, q.y)) inside room)");
  EXPECT_EQ(meaning("leg(p, plan) inside room"), "(leg((p.x, p.y), plan) inside room)");
  EXPECT_EQ(meaning("path(p, plan) inside room"), "(path((p.x, p.y), plan) inside room)");
}
TEST(Ways, AreMadeOfTheirLegs) {
  EXPECT_EQ(meaning("path(p, q, plan) inside room"),
            "((leg((p.x, p.y), (q.x, q.y)) inside room) and (path((q.x, q.y), plan) inside room))");
  EXPECT_EQ(meaning("path(p, q, (1 m, 2 m)) inside room"),
            "((leg((p.x, p.y), (q.x, q.y)) inside room) and (leg((q.x, q.y), (1 m, 2 m)) inside "
            "room))");
}
// The complement is open: none of it is in the zone.
TEST(Ways, LieOutsideOfZones) {
  EXPECT_EQ(meaning("leg(p, q) inside complement(pit)"),
            "(leg((p.x, p.y), (q.x, q.y)) outside pit)");
  EXPECT_EQ(meaning("clearance(leg(p, q), complement(pit)) >= 1 m"),
            "((-greatest clearance(leg((p.x, p.y), (q.x, q.y)), pit)) >= 1 m)");
}
TEST(Ways, HaveAClearance) {
  EXPECT_EQ(meaning("clearance(plan, room) >= 1 m"),
            "(given(plan) implies (least clearance(plan, room) >= 1 m))");
}
TEST(Ways, HaveDistances) {
  EXPECT_EQ(meaning("distance(leg(p, q), (1 m, 1 m)) >= 1 m"),
            "(distance(leg((p.x, p.y), (q.x, q.y)), (1 m, 1 m)) >= 1 m)");
  EXPECT_EQ(meaning("distance(p, plan) < 1 m"),
            "(given(plan) and (distance((p.x, p.y), plan) < 1 m))");
  EXPECT_EQ(meaning("distance(pit, leg(p, q)) >= 1 m"),
            "(max(0 m, (-greatest clearance(leg((p.x, p.y), (q.x, q.y)), pit))) >= 1 m)");
  EXPECT_EQ(meaning("distance(plan, other) >= 1 m"),
            "(given(plan) implies (given(other) implies (distance(plan, other) >= 1 m)))");
}
TEST(Ways, StandInFunctionsAndNames) {
  EXPECT_EQ(meaning("let way = leg(p, q) in way inside room"),
            "(leg((p.x, p.y), (q.x, q.y)) inside room)");
}
TEST(Ways, HaveAnAge) {
  EXPECT_EQ(meaning("age(plan) <= 1 s"), "(age(plan) <= 1 s)");
}

TEST(Ways, AreNoQuantities) {
  expect_said("plan >= 1 m", "3006", "a path");
  expect_said("leg(p, q) >= 1 m", "3006", "a leg");
}
TEST(Ways, AreMadeOfPoints) {
  expect_said("leg(p, x) inside room", "3012", "`leg` takes points");
  expect_said("leg(p) inside room", "3013", "`leg` takes 2 arguments");
  expect_said("path(p) inside room", "3013", "`path` takes two arguments or more");
  expect_said("leg(plan, p) inside room", "3012", "a path");
  expect_said("leg(p, path(p, q)) inside room", "3012", "list the places one by one");
}
TEST(Ways, AreNoZones) {
  expect_said("p inside leg(p, q)", "3019", "write `distance(p, leg(p, q)) <= 1 m`");
  expect_said("clearance(p, path(p, plan)) >= 1 m", "3019", "a leg or a path is no zone");
  expect_said("p inside plan", "2011", "write `distance(p, plan) <= 1 m`");
  expect_said("p inside grow(leg(p, q), 1 m)", "3019", "a leg or a path is no zone");
}
TEST(Ways, HaveNoElements) {
  expect_said("plan[0] inside room", "3033", "`plan inside Z`, or `leg(p, plan)`");
}
TEST(Ways, LieInThePlane) {
  expect_said("leg(s, p) inside room", "3040", "write `s.xy`");
  expect_said("leg(p, q) inside hall", "3040", "height");
}
TEST(Ways, LieInOneFrame) {
  expect_said("leg(p, hand) inside room", "3039", "base");
  expect_said("leg(p, away) inside room", "3039", "base");
  expect_said("distance(away, p) >= 1 m", "3039", "base");
}
TEST(Ways, AreHeldAgainstZonesThatStay) {
  expect_said("plan inside bubble", "3043", "a zone that moves");
}
// The least of what may be endless is not always that.
TEST(Ways, OfAPathThatMayBeEmptyAreComparedWhereTheyStand) {
  expect_said("min(distance(plan, p), x) >= 1 m", "7002",
              "is endlessly far from everything while it is empty");
}

// The body of a robot is no point; its centre is, in the plane that of a robot in space.
TEST(Ways, LeadBetweenCentres) {
  const auto said = [](const std::string& property, const std::string& point) {
    const auto checked = check_text(
        "spec s;\nperiod 1 s;\nrobot Quad {\n  body radius 30 cm;\n"
        "  motion point { speed <= 2 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
        "  sense position : " +
        point + " error 2 cm max_age 100 ms;\n  sense velocity : " +
        (point == "point" ? "vector" : "vector3") +
        " error 2 cm/s max_age 100 ms;\n  output move : acceleration;\n  latency 10 ms;\n}\n"
        "fleet quad : Quad;\ninput plan : path[8] max_age 1 s;\n"
        "monitor m { \"R\" always " +
        property + "; }\n");
    return checked->spec ? "" : checked->reports();
  };
  EXPECT_NE(said("distance(plan, quad) >= 1 m", "point3").find("write `quad.position.xy`"),
            std::string::npos);
  EXPECT_EQ(said("distance(plan, quad.position.xy) >= 1 m", "point3"), "");
  EXPECT_NE(said("distance(plan, quad.position) >= 1 m", "point3").find("`quad.position.xy`"),
            std::string::npos);
  EXPECT_NE(said("distance(leg(quad, plan), (0 m, 0 m)) >= 1 m", "point3")
                .find("write `quad.position.xy`, the place of its centre"),
            std::string::npos);
  EXPECT_NE(said("distance(leg(quad, plan), (0 m, 0 m)) >= 1 m", "point")
                .find("write `quad.position`, the place of its centre"),
            std::string::npos);
  EXPECT_NE(said("distance(plan, (1 m, 1 m, 1 m)) >= 1 m", "point").find("the third coordinate"),
            std::string::npos);
}

std::string declared(const std::string& input) {
  const auto checked = check_text("spec s;\nperiod 1 s;\n" + input +
                                  "\ninput p : point in 0 .. 1 m;\n"
                                  "monitor m { \"R\" always distance(plan, p) >= 1 m; }\n");
  return checked->spec ? "" : checked->reports();
}
TEST(Ways, ArriveWithAFixedMemory) {
  EXPECT_EQ(declared("input plan : path[64] max_age inf;"), "");
  EXPECT_NE(declared("input plan : path max_age inf;").find("`path[16]`"), std::string::npos);
  EXPECT_NE(declared("input plan : path[65] max_age inf;").find("64"), std::string::npos);
  EXPECT_NE(declared("input plan : path[0] max_age inf;").find("1 to 64"), std::string::npos);
  EXPECT_EQ(declared("input plan : path [8] max_age inf;"), "");
  EXPECT_NE(declared("input plan : path[4][2] max_age inf;").find("one path, not several"),
            std::string::npos);
  EXPECT_NE(declared("input plan : path[m] max_age inf;").find("write how many way-points"),
            std::string::npos);
  EXPECT_NE(declared("input plan : path[8 m] max_age inf;").find("write `8`"), std::string::npos);
  EXPECT_NE(declared("param n : int in 1 .. 8 = 4;\ninput plan : path[n] max_age inf;")
                .find("`n` is a `param`"),
            std::string::npos);
}
// Way-points are what they are.
TEST(Ways, ArriveWithoutErrors) {
  EXPECT_NE(declared("input plan : path[4] error 1 cm;").find("has no effect"), std::string::npos);
  EXPECT_NE(declared("input plan : path[4] in 0 .. 1 m;").find("has no effect"), std::string::npos);
}
// One that is listed twice over is copied for each leg of the other one.
TEST(Ways, OfManyLegsAreTooMany) {
  std::string way = "path(p";
  for (int k = 0; k < 400; ++k) way += ", (1 m, " + std::to_string(k % 9) + " m)";
  way += ")";
  expect_said("distance(" + way + ", " + way + ") >= 1 m", "3030", "too large");
  EXPECT_EQ(meaning(way + " inside room").find("3030"), std::string::npos);
}
TEST(Ways, AreNoParameters) {
  const auto checked = check_text(
      "spec s;\nperiod 1 s;\nfun f(way : path[4]) : bool = way inside rectangle (0 m, 0 m) to (1 "
      "m, "
      "1 m);\ninput plan : path[4];\nmonitor m { \"R\" always f(plan); }\n");
  EXPECT_NE(checked->reports().find("only an input is of type `path`"), std::string::npos)
      << checked->reports();
  const auto used = check_text(
      "spec s;\nperiod 1 s;\ninput plan : path[4];\ninput p : point in 0 .. 1 m;\n"
      "fun f(q : point) : bool = distance(plan, q) >= 1 m;\nmonitor m { \"R\" always f(p); }\n");
  EXPECT_NE(used->reports().find("no argument is a path: pass what is made of it"),
            std::string::npos)
      << used->reports();
}

}  // namespace
}  // namespace rtac::sema::test
