// One mistake, one report: what depends on something faulty is silent, and independent mistakes
// are all reported in one run.
#include <algorithm>
#include <cctype>
#include <ctime>

#include "compiler/sema/context.h"
#include "tests/compiler/sema/door.h"

namespace rtac::sema::test {
namespace {

using diag::Code;

std::vector<Code> codes_of(const Checked& checked) {
  std::vector<Code> codes;
  for (const diag::Diagnostic& each : checked.engine.all()) codes.push_back(each.code);
  return codes;
}

// A fleet under another name is missed wherever it is used, which is one mistake.
TEST(Cascades, AMisspeltFleetIsOneMistake) {
  const auto checked = check_text(R"(spec herd;
period 10 ms;
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 200 ms;
  sense velocity : vector error 2 cm/s max_age 200 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet laed : Cart;
fleet carts : Cart[2];
input gate : point in -9 .. 9 m;
monitor near { "R1: near the gate" always distance(lead, gate) <= 5 m; }
monitor apart { "R2: apart" always min(c : Cart, c != lead : distance(lead, c)) >= 50 cm; }
)");
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::unknown_robot}) << checked->reports();
}

// Agents under another name, or behind a mistake in their declaration, are missed wherever they are
// used, which is one mistake.
TEST(Cascades, MisspeltAgentsAreOneMistake) {
  const auto codes = [](const std::string& agents) {
    const auto checked =
        check_text(edited(yard(), {{"r inside free",
                                    "distance(worker, r) >= 1 m and distance(r, people[0]) >= "
                                    "1 m and forall p : people : distance(r, p) >= 2 m"}}) +
                   agents);
    return codes_of(*checked);
  };
  const std::string declared = " : radius 25 cm, speed <= 1.6 m/s error 5 cm max_age 200 ms;\n";
  EXPECT_EQ(codes("agent worker" + declared + "agent peolpe[2]" + declared),
            std::vector<Code>{Code::unknown_name});
  EXPECT_EQ(codes("agent wroker" + declared + "agent people[2]" + declared),
            std::vector<Code>{Code::unknown_name});
  EXPECT_EQ(codes("agent worker" + declared + "agent people[2 : radius 25 cm;\n"),
            std::vector<Code>{Code::unclosed_bracket});
  EXPECT_EQ(codes("agent worker [ radius 25 cm;\nagent people[2]" + declared).size(), 1U);
}

// Of an output with a mistake it is open how the robot follows its commands, of a velocity in the
// plane whether it has a height.
TEST(Cascades, AFaultyRobotIsNotHeldAgainstItsMonitors) {
  const auto codes = [](const std::string& output, const std::string& velocity) {
    return codes_of(*check_text(
        "spec s;\nrobot Quad {\n  body radius 25 cm;\n"
        "  motion point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }\n"
        "  sense position : point3 error 5 cm max_age 50 ms;\n  sense velocity : " +
        velocity + " error 5 cm/s max_age 50 ms;\n  output " + output +
        ";\n  latency 20 ms;\n}\nfleet one : Quad;\n"
        "zone shaft = prism (rectangle (0 m, 0 m) to (90 m, 90 m)) from 0 m to 90 m;\n"
        "controller go : advanced for Quad extern;\n"
        "controller back : safe for Quad = brake_and_hold;\n"
        "monitor walls for r : Quad { \"R1: in\" always r inside shaft; ahead 200 ms, command; "
        "recover back; }\n"
        "decision fly for Quad { advanced go; period 50 ms; priority walls; }\n"));
  };
  EXPECT_EQ(codes("thrust : acceleration error 10 cm/s^2", "vector3"), std::vector<Code>{});
  EXPECT_EQ(codes("thrust : accelerations error 10 cm/s^2", "vector3"),
            std::vector<Code>{Code::unknown_word});
  EXPECT_EQ(codes("thrust : acceleration error 10 cm", "vector3"),
            std::vector<Code>{Code::wrong_dimension});
  EXPECT_EQ(codes("thrust : acceleration 10 cm/s^2", "vector3").size(), 1U);
  EXPECT_EQ(codes("thrust : acceleration error 10 cm/s^2", "vector"),
            std::vector<Code>{Code::spaces_differ});
}

TEST(Cascades, IndependentMistakesAreAllReported) {
  const auto checked = check_text(edited(yard(), {{"radius 11 cm", "radius 0.2"},
                                                  {"r inside free", "r inside fre"},
                                                  {"recover give_way", "recover policy"},
                                                  {"for 1 s", "for 250 ms"}}));
  EXPECT_EQ(codes_of(*checked),
            (std::vector<Code>{Code::unit_missing, Code::wrong_role, Code::unknown_zone,
                               Code::duration_not_a_multiple}))
      << checked->reports();
  EXPECT_FALSE(checked->spec);
}

// Every use of a name that is not declared would say the same.
TEST(Cascades, AnUnknownNameIsReportedOnce) {
  const auto checked = check_text(edited(yard(), {{"zone free ", "zone fee "}}));
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::unknown_zone}) << checked->reports();
}

TEST(Cascades, AFaultyZoneIsNotFaultyAgainWhereItIsUsed) {
  const auto checked = check_text(edited(yard(), {{"(2 m, 2 m) to", "(2, 2 m) to"}}));
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::unit_missing}) << checked->reports();
}

TEST(Cascades, AFaultyLimitIsNotComparedWithAController) {
  const auto checked = check_text(edited(yard(), {{"speed <= 0.5 m/s", "speed <= 0.5 cm"}}));
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::wrong_dimension}) << checked->reports();
}

TEST(Cascades, AnUnknownKindIsReportedOnce) {
  const auto checked = check_text(edited(yard(), {{"robot Cart {", "robot Kart {"}}));
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::unknown_robot_kind}) << checked->reports();
}

TEST(Cascades, OperandsOfOneExpressionAreIndependent) {
  const auto checked = check_text(
      edited(yard(), {{"always  r inside free", "always r inside fre and r.batery >= 5 %"}}));
  EXPECT_EQ(codes_of(*checked), (std::vector<Code>{Code::unknown_zone, Code::unknown_signal}))
      << checked->reports();
}

// A choice that may not stand there is not said to be of the wrong types as well.
TEST(Cascades, AChoiceThatCannotLookAheadIsReportedOnce) {
  const auto checked = check_text(
      edited(yard(), {{"always  r inside free",
                       "always (if r.battery >= 5 % then clearance(r, free) else 1 m) >= 0 m"}}));
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::not_for_robots}) << checked->reports();
}

// A property that comes to nothing without a report is a bug of the checker, not a good property.
TEST(Cascades, AMistakeWithoutAReportIsNoticed) {
  diag::Engine engine;
  Context context(engine, syntax::Program{});
  EXPECT_FALSE(context.silent());
  context.must_have_said();
  EXPECT_TRUE(context.silent());
}

// ... and one with a report is not.
TEST(Cascades, AMistakeWithAReportIsNotSilent) {
  diag::Engine engine;
  Context context(engine, syntax::Program{});
  context.report(Finding(Code::unknown_name, SourceRange{}, "the name `x` is not declared"));
  context.must_have_said();
  EXPECT_FALSE(context.silent());
}

// A zone, a clause or an item that the parser had to drop may be what seems to be missing.
TEST(Cascades, NothingSeemsMissingAfterASyntaxError) {
  for (const Change& change :
       {Change{"zone free  = arena - box;", "zone = arena - box;"},
        Change{"recover turn_back;", "recover ;"}, Change{"radius 8 cm;", "radius ;"},
        Change{"robot Cart {", "robot {"}, Change{"period   50 ms;", "period ;"},
        Change{"(4 m, 4 m)", "(4 m, )"}}) {
    const auto checked = check_text(edited(yard(), {change}));
    EXPECT_TRUE(checked->engine.has_errors()) << change.second;
    for (const Code code : codes_of(*checked)) {
      EXPECT_LT(static_cast<int>(code), 2000) << change.second << "\n" << checked->reports();
    }
    EXPECT_FALSE(checked->spec);
  }
}

// What is there and wrong is still reported beside a syntax error.
TEST(Cascades, OtherMistakesAreReportedBesideASyntaxError) {
  const auto checked = check_text(
      edited(yard(), {{"recover turn_back;", "recover ;"}, {"latency 20 ms", "latency 20 cm"}}));
  const auto codes = codes_of(*checked);
  EXPECT_NE(std::find(codes.begin(), codes.end(), Code::wrong_dimension), codes.end())
      << checked->reports();
}

// An unknown name in one item is reported beside a mistake of syntax in another one, unless the
// faulty item may declare it.
TEST(Cascades, UnknownNamesAreReportedBesideASyntaxError) {
  const std::string head = "spec s;\nperiod 1 s;\n";
  const std::string uses = "monitor m { \"R1: x\" always x >= 1 m and y >= 1 m; }\n";
  const auto dropped = check_text(head + "input x real [m] in 0 .. 9 m error;\n" + uses);
  EXPECT_EQ(codes_of(*dropped), (std::vector<Code>{Code::unexpected_token, Code::unknown_name}))
      << dropped->reports();
  EXPECT_EQ(dropped->sources.text(*dropped->engine.all()[1].range), "y");
}

// The name that is declared is not there, and is used: nothing else is said about it.
TEST(Cascades, ADeclarationWithoutItsNameIsOneMistake) {
  const std::string head = "spec s;\nperiod 1 s;\ninput open : bool;\n";
  const std::string uses = "monitor m { \"R1: x\" always x >= 1 m and open; }\n";
  for (const std::string item :
       {"input ( : real [m];\n", "input 1 : real [m];\n", "1 x : real [m] in 0 .. 9 m;\n",
        "input open, ( : real [m];\n", "param ; : length in 0 m .. 1 m = 1 m;\n"}) {
    const auto checked = check_text(head + item + uses);
    EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::unexpected_token})
        << item << checked->reports();
  }
  const auto glued = check_text(head +
                                "fun slowv : speed) : bool = v <= 1 m/s;\n"
                                "monitor m { \"R1: x\" always slow(1 m/s); }\n"
                                "monitor n { \"R2: x\" always open and not slow(2 m/s); }\n");
  EXPECT_EQ(codes_of(*glued), std::vector<Code>{Code::unexpected_token}) << glued->reports();
}

// Which of two declarations is meant is open.
TEST(Cascades, ANameThatIsDeclaredTwiceIsOneMistake) {
  const std::string head = "spec s;\nperiod 1 s;\ninput x : real [m] in 0 .. 9 m;\n";
  const std::string more = "monitor n { \"R2: x\" always x >= 1 m; }\n";
  for (const std::string item :
       {"input x : bool;\nmonitor m { \"R1: x\" always x; }\n",
        "zone x = rectangle (0 m, 0 m) to (1 m, 1 m);\ninput p : point;\n"
        "monitor m { \"R1: x\" always p inside x; }\n",
        "fun x(v : speed) : bool = v <= 1 m/s;\nmonitor m { \"R1: x\" always x(1 m/s); }\n",
        "enum x { a, b }\ninput y : x;\nmonitor m { \"R1: x\" always y == a; }\n"}) {
    const auto checked = check_text(head + item + more);
    EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::duplicate_name})
        << item << checked->reports();
  }
}

// Whether it has a height is not known of a robot that is damaged where it says so.
TEST(Cascades, AnUnclearPositionIsNotHeldAgainstZonesWithHeight) {
  const std::string text = R"(spec hall;
zone hall = prism (rectangle (0 m, 0 m) to (9 m, 9 m)) from 0 m to 8 m;
robot Quad {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense position : point3 error 2 cm max_age 60 ms;
  sense velocity : vector3 error 3 cm/s max_age 60 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet quad : Quad;
controller pilot : advanced for Quad extern;
controller down : safe for Quad = land to 1 m speed 0.3 m/s;
controller back : safe for Quad = retreat within hall speed 0.3 m/s;
monitor walls for d : Quad { "SR-1: in" always d inside hall; recover back; }
monitor low for d : Quad { "SR-2: low" always d.position.z <= 7 m; recover down; }
decision fly for Quad { advanced pilot; period 50 ms; priority walls > low; }
)";
  ASSERT_EQ(codes_of(*check_text(text)), std::vector<Code>{});
  for (const Change& change :
       {Change{"position : point3", "position :"}, Change{"position : point3", "position : x"},
        Change{"error 2 cm", "error error 2 cm"}, Change{"robot Quad", "robot"},
        Change{"robot Quad", "1 Quad"}, Change{"robot Quad", "robot Quod"},
        Change{"m/s^2; }", "m/s^2; } }"}}) {
    const auto checked = check_text(edited(text, {change}));
    EXPECT_EQ(checked->engine.all().size(), 1u) << change.second << "\n" << checked->reports();
  }
}

// Of two ends of a range and an error that do not suit the unit of the type, one is told.
TEST(Cascades, AUnitThatDoesNotSuitTheRangeIsOneMistake) {
  const auto checked = check_text(
      "spec s;\nperiod 1 s;\ninput v : real [ms] in 0 .. 3 m/s error 1 cm/s;\n"
      "monitor m { \"R1: v\" always v <= 2 m/s; }\n");
  EXPECT_EQ(codes_of(*checked), std::vector<Code>{Code::wrong_dimension}) << checked->reports();
}

// The type of an input that was mended by a guess may be another one, its name is not.
TEST(Cascades, ADamagedDeclarationIsNotHeldAgainstItsUses) {
  const std::string head = "spec s;\nperiod 1 s;\n";
  const std::string more = "monitor n { \"R2: z\" always z <= 1 s; }\ninput z : real [m];\n";
  for (const std::string item :
       {"input x : real m in 0 .. 9 m;\nmonitor m { \"R1: x\" always x >= 1 m; }\n",
        "param x : length = 3;\nmonitor m { \"R1: x\" always x >= 1 m; }\n",
        "enum G { a b c }\ninput g : G;\nmonitor m { \"R1: x\" always g == b or g == c; }\n",
        "fun f(v length) : bool = v ? 1;\nmonitor m { \"R1: x\" always f(1 m, 2); }\n",
        "monitor m { \"R1: x\" always (z >> 1 m; }\n"}) {
    const auto checked = check_text(head + item + more);
    const auto codes = codes_of(*checked);
    ASSERT_EQ(codes.size(), 2U) << item << checked->reports();
    EXPECT_LT(static_cast<int>(codes[0]), 2000) << checked->reports();
    EXPECT_EQ(codes[1], Code::dimensions_differ) << checked->reports();
  }
}

// A priority that is missing or names nothing may have meant any monitor.
TEST(Cascades, AnUnclearPriorityLeavesNoMonitorUnused) {
  for (const Change& change : {Change{"priority ceiling;", ""}, Change{"> fence >", "> xyz >"}}) {
    const auto checked = check_text(edited(yard(), {change}));
    EXPECT_EQ(checked->engine.all().size(), 1u) << checked->reports();
  }
}

// A circle through many zones is reported once, by its first steps.
TEST(Cascades, ALongCircleIsShownByItsFirstSteps) {
  std::string text = "spec a;\n";
  for (int i = 0; i < 100; ++i) {
    text += "zone z" + std::to_string(i) + " = z" + std::to_string((i + 1) % 100) + ";\n";
  }
  const auto checked = check_text(text);
  ASSERT_EQ(checked->engine.all().size(), 1u) << checked->reports();
  const auto& notes = checked->engine.all().front().notes;
  ASSERT_EQ(notes.size(), 6u);
  EXPECT_EQ(notes[4].text, "by way of `z5` and 94 more");
}

// The checker must survive whatever the parser leaves: every line of a good text missing once.
TEST(Cascades, SurvivesEveryMissingLine) {
  const std::string& text = yard();
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = text.find('\n', begin) + 1;
    const auto checked = check_text(text.substr(0, begin) + text.substr(end));
    EXPECT_EQ(checked->spec.has_value(), !checked->engine.has_errors());
    begin = end;
  }
}

// The end of the word or sign at `begin`.
std::size_t end_of_token(const std::string& text, std::size_t begin) {
  const auto is_word = [&](std::size_t i) {
    return std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_' ||
           text[i] == '.';
  };
  std::size_t end = begin + 1;
  if (text[begin] == '"') return text.find('"', end) + 1;
  if (is_word(begin)) {
    while (is_word(end)) ++end;
  }
  while (text[end] == '=' || text[end] == '.') ++end;
  return end;
}

// ... and every word of it missing once. What a missing word does to syntax is no mistake in names
// or types as well.
TEST(Cascades, AMissingWordIsNoMistakeInSyntaxAndMeaning) {
  for (const std::string& text : {yard(), door()}) {
    std::size_t begin = 0;
    while ((begin = text.find_first_not_of(" \n", begin)) != std::string::npos) {
      const std::size_t end = end_of_token(text, begin);
      const auto checked = check_text(text.substr(0, begin) + " " + text.substr(end));
      EXPECT_EQ(checked->spec.has_value(), !checked->engine.has_errors());
      const auto codes = codes_of(*checked);
      const auto of_syntax = std::count_if(codes.begin(), codes.end(),
                                           [](Code code) { return static_cast<int>(code) < 2000; });
      EXPECT_TRUE(of_syntax == 0 || codes.size() == 1)
          << "without `" << text.substr(begin, end - begin) << "` at " << begin << "\n"
          << checked->reports();
      begin = end;
    }
  }
}

// How far zones are apart is no matter of a robot, called by name or through a function; what it
// would be compared with is not to blame.
TEST(Cascades, ADistanceOfZonesInARobotsMonitorIsOneMistake) {
  for (const char* const gap : {"gap()", "distance(pad, hut)"}) {
    const auto checked = check_text(std::string(R"(spec herd;
period 10 ms;
robot Cart {
  body radius 20 cm;
  motion point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense position : point error 2 cm max_age 200 ms;
  sense velocity : vector error 2 cm/s max_age 200 ms;
  output push : acceleration;
  latency 20 ms;
}
fleet lead : Cart;
zone pad = rectangle (0 m, 0 m) to (2 m, 2 m);
zone hut = rectangle (5 m, 0 m) to (9 m, 2 m);
fun gap() : length = distance(pad, hut);
monitor apart for r : Cart { "R1: apart" always )") +
                                    gap + " >= 1 m or r inside pad; }\n");
    EXPECT_EQ(checked->engine.error_count(), 1) << checked->reports();
    EXPECT_EQ(codes_of(*checked).front(), Code::wrong_argument) << checked->reports();
  }
}

// ... and every word of it replaced by a sign or a number.
TEST(Cascades, AnotherWordIsNoMistakeInSyntaxAndMeaning) {
  for (const std::string& text : {yard(), door()}) {
    for (const char* const other : {" ( ", " 1 ", " ; "}) {
      std::size_t begin = 0;
      while ((begin = text.find_first_not_of(" \n", begin)) != std::string::npos) {
        const std::size_t end = end_of_token(text, begin);
        const auto checked = check_text(text.substr(0, begin) + other + text.substr(end));
        const auto codes = codes_of(*checked);
        const auto of_syntax = std::count_if(
            codes.begin(), codes.end(), [](Code code) { return static_cast<int>(code) < 2000; });
        EXPECT_TRUE(of_syntax == 0 || of_syntax == std::ssize(codes))
            << "`" << other << "` for `" << text.substr(begin, end - begin) << "` at " << begin
            << "\n"
            << checked->reports();
        begin = end;
      }
    }
  }
}

// Of this process: a test must not fail because others keep the machine busy.
double seconds_since(std::clock_t start) {
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Time grows with the number of mistakes, not with its square: 30,000 would take minutes.
TEST(Cascades, AFloodOfMistakesEndsSoon) {
  constexpr int count = 30'000;
  std::string text = "spec flood;\nperiod 10 ms;\ninput door_is_open : bool;\n";
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    text += "monitor m" + number + " { \"R\" always unknown" + number + "; }\n";
  }
  const std::clock_t start = std::clock();
  const auto checked = check_text(text);
  EXPECT_EQ(checked->engine.error_count(), count);
  EXPECT_LT(seconds_since(start), 60);
}

// ... and not with the number of names that may be meant either.
TEST(Cascades, AFloodOfMistakesAmongManyNamesEndsSoon) {
  constexpr int count = 20'000;
  std::string text = "spec flood;\nperiod 10 ms;\n";
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    text += "input door_" + number + "_is_open : bool;\n";
    text += "monitor m" + number + " { \"R\" always dor_" + number + "_is_open; }\n";
  }
  const std::clock_t start = std::clock();
  const auto checked = check_text(text);
  EXPECT_EQ(checked->engine.error_count(), count);
  EXPECT_EQ(checked->engine.all().front().help, "did you mean `door_0_is_open`?");
  EXPECT_LT(seconds_since(start), 30);
}

}  // namespace
}  // namespace rtac::sema::test
