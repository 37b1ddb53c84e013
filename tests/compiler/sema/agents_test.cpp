// What moves by itself, in the checked specification.
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

// The property of `fence` after replacing it.
std::string property(const std::string& written) {
  const std::string text =
      edited(yard(), {{"r inside free", written}}) +
      "agent worker : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n"
      "agent people[3] : radius 30 cm, speed <= 2 m/s error 5 cm max_age 200 ms, present;\n";
  const auto checked = check_text(text);
  if (!checked->spec) return checked->reports();
  return dump(*checked->spec, *checked->spec->monitors[1].always);
}

TEST(Agents, AreNamedOneByOne) {
  EXPECT_EQ(property("distance(r, worker) >= 1 m"), "(distance(self, worker) >= 1 m)");
  EXPECT_EQ(property("distance(people[2], r) > 30 cm"), "(distance(self, people[2]) > 0.3 m)");
}

// Only monitors of robots speak of them; others have the place as an input of its own.
TEST(Agents, AreNotKnownToMonitorsWithoutARobot) {
  const auto said = [](const std::string& property) {
    const auto checked = check_text(
        "spec s;\nperiod 1 s;\ninput one : point in 0 .. 9 m;\n"
        "agent child : radius 20 cm, speed <= 1 m/s error 5 cm max_age 1 s;\n"
        "agent more[2] : radius 20 cm, speed <= 1 m/s error 5 cm max_age 1 s;\n"
        "monitor m { \"R\" always " +
        property + "; }\n");
    return checked->reports();
  };
  EXPECT_NE(said("distance(one, child) >= 1 m").find("`input child_at : point"), std::string::npos);
  EXPECT_NE(said("distance(one, more[1]) >= 1 m").find("`distance(r, more[0]) >= 1 m`"),
            std::string::npos);
  EXPECT_NE(said("forall p : more : distance(one, p) >= 1 m").find("monitors of robots go through"),
            std::string::npos);
}

TEST(Agents, AreQuantifiedOneByOne) {
  EXPECT_EQ(property("forall p : people : distance(r, p) >= 1 m"),
            "(((distance(self, people[0]) >= 1 m) and (distance(self, people[1]) >= 1 m)) and "
            "(distance(self, people[2]) >= 1 m))");
  EXPECT_EQ(property("exists p : worker : distance(p, r) >= 1 m"),
            "(distance(self, worker) >= 1 m)");
  EXPECT_EQ(property("forall p : people : exists w : worker : distance(r, w) >= 1 m or true"),
            property("forall p : people : distance(r, worker) >= 1 m or true"));
}

// Robots and agents in one property: each quantifier has its own.
TEST(Agents, StandBesideRobots) {
  EXPECT_EQ(
      property("(forall q : Cart, q != r : distance(r, q) >= 1 m) and distance(r, worker) >= "
               "1 m"),
      "((forall other : (distance(self, other) >= 1 m)) and (distance(self, worker) >= 1 m))");
}

TEST(Agents, HaveTheInputsThatStandForThem) {
  const auto checked = check_text(
      edited(yard(), {{"r inside free", "forall p : people : distance(r, p) >= 1 m"}}) +
      "agent people[2] : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms, present;\n");
  ASSERT_TRUE(checked->spec) << checked->reports();
  std::string names;
  for (const Input& input : checked->spec->inputs) {
    if (!input.agent) continue;
    names += input.name + " ";
    ASSERT_TRUE(input.max_age);
    EXPECT_EQ(input.max_age->value, Rational(1, 5));
  }
  EXPECT_EQ(names, "people[0].position people[0].present people[1].position people[1].present ");
  EXPECT_EQ(checked->spec->agents[1].radius.value, Rational(1, 4));
  EXPECT_EQ(checked->spec->agents[1].speed.value, Rational(8, 5));
}

// The type of its position says whether it has a height; there are two such types.
TEST(Agents, MayHaveAHeight) {
  const auto declared = [](const std::string& type) {
    return check_text(yard() + "agent bird : " + type +
                      "radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n"
                      "agent birds[2] : " +
                      type + "radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n");
  };
  const auto flat = declared("point, "), high = declared("point3, "), none = declared("pose, ");
  ASSERT_TRUE(flat->spec) << flat->reports();
  ASSERT_TRUE(high->spec) << high->reports();
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_FALSE(flat->spec->agents[k].in_space);
    EXPECT_TRUE(high->spec->agents[k].in_space);
    EXPECT_EQ((*high->spec)[high->spec->agents[k].seen].components.size(), 3U);
    EXPECT_EQ((*flat->spec)[flat->spec->agents[k].seen].components.size(), 2U);
  }
  EXPECT_FALSE(none->spec);
  EXPECT_NE(none->reports().find("`point3`"), std::string::npos) << none->reports();
}

// A robot of the plane has no height to hold against it.
TEST(Agents, InSpaceAreForRobotsInSpace) {
  const auto checked = check_text(
      edited(yard(), {{"r inside free", "distance(r, bird) >= 1 m"}}) +
      "agent bird : point3, radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n");
  EXPECT_FALSE(checked->spec);
  EXPECT_NE(checked->reports().find("moves in space"), std::string::npos) << checked->reports();
}

}  // namespace
}  // namespace rtac::sema::test
