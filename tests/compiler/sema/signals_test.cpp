// What the checked specification says about monitors of signals.
#include <fstream>

#include "tests/compiler/sema/door.h"

namespace rtac::sema::test {
namespace {

// The property of `warm` after replacing a part of it; what is reported when it has a mistake.
std::string property(const std::string& written, const std::vector<Change>& more = {}) {
  std::vector<Change> changes{{"steps <= 9", "steps <= 9 and (" + written + ")"}};
  changes.insert(changes.end(), more.begin(), more.end());
  const auto checked = check_text(edited(door(), changes));
  if (!checked->spec) return checked->reports();
  const auto& both = std::get<Logic>(checked->spec->watches[2].always->node);
  return dump(*checked->spec, *both.operands[1]);
}

TEST(Signals, TheWholeSpecificationIsListed) {
  const auto checked = check_text(door());
  ASSERT_TRUE(checked->spec) << checked->reports();
  EXPECT_TRUE(checked->engine.all().empty()) << checked->reports();
  EXPECT_EQ(dump(*checked->spec), R"(spec door
period 0.01 s
enum Gear { park, drive, reverse }
input open : bool
input moving : bool
input speed : real [m/s]
  in 0 m/s .. 3 m/s
  resolution 0.001 m/s
  error 0.01 m/s
  max_age 0.1 s
input steps : int
  in 0 .. 10
  resolution 1
input p : real [m]
  components x y
  resolution 0.001 m
  max_age inf
input q : real [m]
  components x y
  resolution 0.001 m
  max_age inf
input v : real [m/s]
  components x y
  in -3 m/s .. 3 m/s
  resolution 0.001 m/s
input temps : real [K]
  components 0 1 2 3
  in 200 K .. 400 K
  resolution 0.001 K
input gear : Gear
param least in 0.1 m .. 0.5 m = 0.2 m resolution 0.001 m moves up
scale 0.5 m/s
assume speed <= 3 m/s checked by no_run
monitor no_run
  requirement "R1" "no driving with an open door"
  always ((once[0 s, 2 s] open) implies (speed <= 0.3 m/s))
monitor clear
  requirement "R2" "the two points keep apart"
  always ((norm((p.x - q.x), (p.y - q.y)) >= least) and (norm(v.x, v.y) <= 2 m/s))
monitor warm
  requirement "R3" "not too warm, not too many steps"
  always ((max(temps[0], temps[1], temps[2], temps[3]) <= 350 K) and (steps <= 9))
monitor still
  requirement "R4" "an open door stands"
  always (open implies ((not moving) and (not (gear == drive))))
)");
}

// What is asked for by its age alone is used.
TEST(Signals, TheAgeOfWhatARobotSensesUsesIt) {
  const auto checked = check_text(
      "spec s;\nperiod 100 ms;\n"
      "robot Drone {\n  body radius 8 cm;\n"
      "  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
      "  sense position : point error 2 cm max_age 50 ms;\n"
      "  sense velocity : vector error 2 cm/s max_age 50 ms;\n"
      "  output thrust : acceleration;\n  latency 20 ms;\n}\n"
      "fleet bots : Drone[2];\n"
      "monitor m { \"R1: heard\" always age(bots[0].velocity) <= 1 s; }\n");
  EXPECT_TRUE(checked->spec);
  EXPECT_EQ(checked->reports(), "");
}

// A choice between a minimum over members and another value is compared by both comparisons, so
// that one member decides; of a constant condition there is nothing to choose.
TEST(Signals, AChoiceOfMembersIsComparedByItsValues) {
  const auto meaning = [](const std::string& property) {
    const auto checked = check_text(
        "spec s;\nperiod 100 ms;\ninput p : bool;\n"
        "robot Drone {\n  body radius 8 cm;\n"
        "  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
        "  sense position : point error 2 cm max_age 50 ms;\n"
        "  sense velocity : vector error 2 cm/s max_age 50 ms;\n"
        "  sense battery : ratio error 1 % max_age 50 ms;\n"
        "  output thrust : acceleration;\n  latency 20 ms;\n}\n"
        "fleet a, b : Drone;\n"
        "monitor other { \"R0: used\" always p; }\n"
        "monitor m { \"R1: charge\" always " +
        property + "; }\n");
    return checked->spec ? dump(*checked->spec, *checked->spec->watches[1].always)
                         : checked->reports();
  };
  const std::string both = "((a.battery >= 9 %) and (b.battery >= 9 %))";
  EXPECT_EQ(meaning("(if true then min(d : Drone : d.battery) else 5 %) >= 9 %"), both);
  EXPECT_EQ(
      meaning("(if p then min(d : Drone : d.battery) else 5 %) >= 9 %"),
      "(((p and " + both + ") or ((not p) and (5 % >= 9 %))) or (" + both + " and (5 % >= 9 %)))");
}

TEST(Signals, OperatorsOfThePastKeepTheirIntervals) {
  EXPECT_EQ(property("once open"), "(once[0 s, inf] open)");
  EXPECT_EQ(property("historically[10 ms, inf] open"), "(historically[0.01 s, inf] open)");
  EXPECT_EQ(property("open since[20 ms, 1 s] moving"), "(open since[0.02 s, 1 s] moving)");
  EXPECT_EQ(property("open since moving"), "(open since[0 s, inf] moving)");
  EXPECT_EQ(property("previously open"), "(previously open)");
  EXPECT_EQ(property("open within 2 s of moving"), "(open within 2 s of moving)");
  EXPECT_EQ(property("open for 1 s"), "(open for 1 s)");
}

TEST(Signals, AggregatesHaveTheirDimensions) {
  EXPECT_EQ(property("mean[0 s, 1 s](speed) <= 1 m/s"), "(mean[0 s, 1 s](speed) <= 1 m/s)");
  EXPECT_EQ(property("rate[0 s, 1 s](speed) <= 1 m/s^2"), "(rate[0 s, 1 s](speed) <= 1 m/s^2)");
  EXPECT_EQ(property("count[0 s, 1 s](open) == 3"),
            "((count[0 s, 1 s](open) <= 3) and (count[0 s, 1 s](open) >= 3))");
  EXPECT_EQ(property("max[0 s, inf](speed) <= 1 m/s"), "(max[0 s, inf](speed) <= 1 m/s)");
  EXPECT_EQ(property("age(p) <= 1 s"), "(age(p) <= 1 s)");
}

// Values of enumerations and conditions are compared as such, whole numbers from both sides.
TEST(Signals, EqualityIsExact) {
  EXPECT_EQ(property("gear == park"), "(gear == park)");
  EXPECT_EQ(property("Gear.park != gear"), "(not (gear == park))");
  EXPECT_EQ(property("gear == gear"), "(gear == gear)");
  EXPECT_EQ(property("park == drive"), "false");
  EXPECT_EQ(property("open == moving"), "(open iff moving)");
  EXPECT_EQ(property("open != moving"), "(open xor moving)");
  EXPECT_EQ(property("steps == 3"), "((steps <= 3) and (steps >= 3))");
  EXPECT_EQ(property("steps + 1 != 3"), "(((steps + 1) < 3) or ((steps + 1) > 3))");
}

TEST(Signals, PointsAndVectorsAreTheirComponents) {
  EXPECT_EQ(property("p.x <= 1 m"), "(p.x <= 1 m)");
  EXPECT_EQ(property("distance(p, (1 m, 2 m)) <= 1 m"), "(norm((p.x - 1 m), (p.y - 2 m)) <= 1 m)");
  EXPECT_EQ(property("norm((p - q) / 1 s) <= 1 m/s"),
            "(norm(((p.x - q.x) / 1 s), ((p.y - q.y) / 1 s)) <= 1 m/s)");
  EXPECT_EQ(property("dot(-v, 2 * v) <= 1 m^2/s^2"),
            "((((-v.x) * (v.x * 2)) + ((-v.y) * (v.y * 2))) <= 1 m^2/s^2)");
  EXPECT_EQ(property("distance(if open then p else q, p + v * 1 s) <= 1 m"),
            "(norm(((if open then p.x else q.x) - (p.x + (v.x * 1 s))), ((if open then p.y else "
            "q.y) - (p.y + (v.y * 1 s)))) <= 1 m)");
}

TEST(Signals, ArraysAreTheirElements) {
  EXPECT_EQ(property("temps[2] <= 300 K"), "(temps[2] <= 300 K)");
  EXPECT_EQ(property("let t = temps in t[0] <= t[3]"), "(temps[0] <= temps[3])");
  EXPECT_EQ(property("way[1].y <= 1 m", {{"input gear", "input way : point[2]; input gear"}}),
            "(way[1].y <= 1 m)");
}

TEST(Signals, FunctionsOfConstantsAreFolded) {
  EXPECT_EQ(property("speed <= sqrt(4 m^2/s^2)"), "(speed <= 2 m/s)");
  EXPECT_EQ(property("speed <= min(2 m/s, 1 m/s) + abs(-1 m/s)"), "(speed <= 2 m/s)");
  EXPECT_EQ(property("p.x <= norm((3 m, 4 m))"), "(p.x <= 5 m)");
  EXPECT_EQ(property("steps <= sqrt(2)"), "(steps <= sqrt(2))");
  EXPECT_EQ(property("clamp(speed, 0 m/s, 1 m/s) <= 1 m/s"),
            "(min(max(speed, 0 m/s), 1 m/s) <= 1 m/s)");
}

TEST(Signals, IfChooses) {
  EXPECT_EQ(property("if open then moving else steps <= 3"),
            "((open and moving) or ((not open) and (steps <= 3)))");
  EXPECT_EQ(property("(if open then speed else 1 m/s) <= 1 m/s"),
            "((if open then speed else 1 m/s) <= 1 m/s)");
}

// A name of a function's parameter hides an input; arguments are put in as they are.
TEST(Signals, FunctionsArePutInThePlaceOfTheirCalls) {
  EXPECT_EQ(property("slow(2 * speed, 1 m/s)"), "((2 * speed) <= 1 m/s)");
  const Change more{"scale",
                    "fun near(a : point, b : point) : bool = distance(a, b) <= 1 m;\n"
                    "fun was(c : bool) : bool = once[0 s, 1 s] c;\nscale"};
  EXPECT_EQ(property("was(near(p, q))", {more}),
            "(once[0 s, 1 s] (norm((p.x - q.x), (p.y - q.y)) <= 1 m))");
  const Change half{"scale", "fun ratio_of(a : speed, b : real) : speed = a / b;\nscale"};
  EXPECT_EQ(property("ratio_of(speed, 2) <= 1 m/s", {half}), "((speed / 2) <= 1 m/s)");
}

// 0 .. 3 km/h: the unit of the upper end goes for both.
TEST(Signals, ARangeTakesTheUnitOfItsUpperEnd) {
  const auto checked = check_text(edited(door(), {{"0 .. 3 m/s", "-1.8 .. 3.6 km/h"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  EXPECT_EQ(checked->spec->inputs[2].least->value, Rational(-1, 2));
  EXPECT_EQ(checked->spec->inputs[2].most->value, 1);
}

TEST(Signals, ResolutionsSuitTheDimension) {
  const auto checked = check_text(
      edited(door(), {{"input gear",
                       "input share : ratio; input x : real; input y : real in 0 .. 1 resolution "
                       "0.01; input t : time; input gear"},
                      {"steps <= 9", "share + x * 1 % + y * 1 % + t * 1 %/s <= 9 %"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  const auto& inputs = checked->spec->inputs;
  EXPECT_EQ(inputs[8].resolution, Rational(1, 1000000));
  EXPECT_EQ(inputs[9].resolution, Rational(1, 1000000));
  EXPECT_EQ(inputs[10].resolution, Rational(1, 100));
  EXPECT_EQ(inputs[11].resolution, Rational(1, 1000000));
}

// The direction in which the parameter of `clear` tightens when the property says this.
int direction(const std::string& written) {
  const auto checked = check_text(edited(door(), {{"distance(p, q) >= least", written}}));
  EXPECT_TRUE(checked->spec) << written << "\n" << checked->reports();
  return checked->spec ? checked->spec->params[0].tightens : 9;
}

TEST(Signals, AParameterMovesWhereItTightens) {
  EXPECT_EQ(direction("p.x >= least"), 1);
  EXPECT_EQ(direction("p.x <= least"), -1);
  EXPECT_EQ(direction("least <= p.x"), 1);
  EXPECT_EQ(direction("least > p.x"), -1);
  EXPECT_EQ(direction("not (p.x <= least)"), 1);
  EXPECT_EQ(direction("(p.x >= least implies open)"), -1);
  EXPECT_EQ(direction("p.x >= 1 m - least"), -1);
  EXPECT_EQ(direction("p.x >= -2 * least"), -1);
  EXPECT_EQ(direction("p.x >= least / -2"), -1);
  EXPECT_EQ(direction("p.x >= least * least / 1 m"), 1);
  EXPECT_EQ(direction("p.x >= least * steps"), 1);
  EXPECT_EQ(direction("p.x >= abs(least)"), 1);
  EXPECT_EQ(direction("p.x >= abs(-least)"), 1);
  EXPECT_EQ(direction("once (p.x >= least)"), 1);
  EXPECT_EQ(direction("(p.x >= least since open)"), 1);
  EXPECT_EQ(direction("(open since p.x >= least)"), 1);
  EXPECT_EQ(direction("(p.x >= least within 1 s of open)"), 1);
  EXPECT_EQ(direction("(open within 1 s of p.x >= least)"), -1);
  EXPECT_EQ(direction("count[0 s, 1 s](p.x >= least) >= 3"), 1);
  EXPECT_EQ(direction("min(p.x, least) >= 0 m"), -1);
  EXPECT_EQ(direction("(if open then least else 1 m) >= p.x"), -1);
}

// Whatever a parameter decides between, and what it is equivalent to, may be looser either way.
TEST(Signals, AParameterOfAConditionTightensInNoDirection) {
  for (const char* const written :
       {"(if p.x >= least then 1 m else 2 m) >= p.y", "(open iff p.x >= least)"}) {
    const auto checked = check_text(edited(door(), {{"distance(p, q) >= least", written}}));
    EXPECT_FALSE(checked->spec) << written;
    EXPECT_NE(checked->reports().find("3032 "), std::string::npos) << checked->reports();
  }
}

// The sample lies in the range, the true value within the error of it: 0 .. 3 m/s may be below 0.
TEST(Signals, TheErrorBelongsToTheSignOfASignal) {
  const Change product{"distance(p, q) >= least", "least * speed <= 1 m^2/s"};
  EXPECT_FALSE(check_text(edited(door(), {product}))->spec);
  EXPECT_TRUE(check_text(edited(door(), {product, {"error 1 cm/s", ""}}))->spec);
}

// A signal may be called like a function: a call has brackets of its own.
TEST(Signals, MayBeCalledLikeFunctions) {
  EXPECT_EQ(property("rate <= 1 and distance <= 2",
                     {{"input gear", "input rate, distance : int; input gear"}}),
            "((rate <= 1) and (distance <= 2))");
}

TEST(Signals, RobotsAndSignalsStandSideBySide) {
  const auto checked = check_text(edited(
      yard(), {{"spec yard;",
                "spec yard; period 20 ms; input open : bool; monitor shut { \"W1: shut\" always "
                "not open; } fun ok(v : speed) : bool = v <= 1 m/s;"},
               {"r inside free", "let v = r.speed in if ok(v) then r inside free else false"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  EXPECT_EQ(checked->spec->watches.size(), 1u);
  EXPECT_EQ(dump(*checked->spec, *checked->spec->monitors[1].always),
            "(((self.speed <= 1 m/s) and (self inside free)) or ((not (self.speed <= 1 m/s)) and "
            "false))");
}

// Functions that double their argument would make an expression of 2^40 operands.
TEST(Signals, PropertiesDoNotExplode) {
  std::string functions = "fun f0(x : real) : real = x + x;\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "f" + std::to_string(i - 1);
    functions += "fun f" + std::to_string(i) + "(x : real) : real = " + before + "(x) + " + before +
                 "(x);\n";
  }
  const auto checked = check_text(
      edited(door(), {{"scale", functions + "scale"}, {"steps <= 9", "f39(steps) <= 9"}}));
  ASSERT_EQ(checked->engine.all().size(), 1u) << checked->reports();
  EXPECT_EQ(checked->engine.all()[0].code, diag::Code::limit_exceeded);
  EXPECT_NE(checked->engine.all()[0].help.find("50000"), std::string::npos);
}

TEST(Signals, FunctionsAreNotNestedTooDeeply) {
  std::string functions;
  for (int i = 5000; i > 0; --i) {
    functions +=
        "fun f" + std::to_string(i) + "(x : real) : real = f" + std::to_string(i - 1) + "(x);\n";
  }
  functions += "fun f0(x : real) : real = x;\n";
  const auto checked = check_text(
      edited(door(), {{"scale", functions + "scale"}, {"steps <= 9", "f5000(steps) <= 9"}}));
  ASSERT_FALSE(checked->engine.all().empty());
  EXPECT_EQ(checked->engine.all()[0].code, diag::Code::limit_exceeded) << checked->reports();
}

// The checker must survive whatever the parser leaves: every word of a good text missing once.
TEST(Signals, SurviveEveryMissingWord) {
  const std::string& text = door();
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(" \n", begin)) != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const auto checked = check_text(text.substr(0, begin) + text.substr(end));
    EXPECT_EQ(checked->spec.has_value(), !checked->engine.has_errors());
    begin = end;
  }
}

// What an imported file declares for several specifications need not be used by each.
TEST(Signals, OnlyTheRootFileIsWarnedOfWhatNobodyUses) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "/shared_signals.rta") << "input open, idle : bool;\n";
  Checked start;
  const FileId root =
      start.sources.add(folder + "/own.rta",
                        "spec s;\nimport \"shared_signals.rta\";\nperiod 1 s;\ninput own : bool;\n"
                        "monitor m { \"R1: open\" always open; }\n");
  const auto checked = check_file(std::move(start), root);
  ASSERT_EQ(checked->engine.all().size(), 1u) << checked->reports();
  EXPECT_EQ(checked->engine.all().front().message, "no monitor uses the input `own`");
}

}  // namespace
}  // namespace rtac::sema::test
