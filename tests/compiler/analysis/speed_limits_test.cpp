// Limits of speed: recoveries keep them, control comes back, and the numbers that are offered work.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

std::string text_of(const std::string& limit, const std::string& recovery,
                    const std::string& more = "") {
  return R"(spec yard;
zone room = rectangle (0 m, 0 m) to (6 m, 4 m);
robot Drone {
  body     radius 8 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point   error 2 cm    max_age 50 ms;
  sense    velocity : vector  error 2 cm/s  max_age 50 ms;
  output   thrust : acceleration;
  latency  20 ms;
}
fleet d1 : Drone;
controller pilot    : advanced for Drone extern;
controller back_off : safe for Drone = retreat within room speed )" +
         recovery + R"(;
monitor calm for d : Drone { "SR-1: calm" always d.speed <= )" +
         limit + R"(; recover back_off; }
decision fly for Drone { advanced pilot; period 50 ms; priority calm; )" +
         more + "}\n";
}
std::string said(const std::string& text) {
  const auto c = compiled(text);
  EXPECT_TRUE(has(*c, Code::speed_limit_unkept)) << reports(*c);
  return c->diagnostics.all().empty() ? "" : c->diagnostics.all().front().message;
}
void expect_works(const std::string& text) {
  const auto c = compiled(text);
  EXPECT_TRUE(c->diagnostics.all().empty()) << reports(*c);
}

// It is as much faster as the error that it measures its speed with, and overshoots by 2 mm/s.
TEST(SpeedLimits, ARecoveryKeepsThem) {
  expect_works(text_of("0.5 m/s", "0.478 m/s"));
  EXPECT_EQ(said(text_of("0.5 m/s", "0.479 m/s")),
            "the recovery `back_off` drives at up to 0.501 m/s, and `calm` allows 0.5 m/s");
  expect_works(text_of("0.5 m/s", "0.479 m/s", "acknowledge back_off may break calm \"a test\"; "));
}

// It cannot be looked ahead at, which is said of it; no other limit is named in its place.
TEST(SpeedLimits, OneThatIsAParameterIsAMatterOfItsOwn) {
  const std::string text = text_of("creep or (fog and d.speed <= 0.8 m/s)", "0.5 m/s");
  const std::string declared =
      "param creep : speed in 0.5 m/s .. 0.9 m/s = 0.6 m/s;\ninput fog : bool max_age 1 s;\nfleet";
  const auto c = compiled(std::string(text).replace(text.find("fleet"), 5, declared));
  EXPECT_TRUE(has(*c, Code::atom_without_transformer)) << reports(*c);
  EXPECT_FALSE(has(*c, Code::speed_limit_unkept)) << reports(*c);
}

// Twice the error, the grid, and 1 m/s^2 over ages, period, look-ahead and latency.
TEST(SpeedLimits, ARobotAtRestMayHandControlBack) {
  const std::string message = said(text_of("0.2 m/s", "0.1 m/s"));
  EXPECT_EQ(message,
            "monitor `calm` can never hand control back: from rest the robot may reach 0.269 m/s "
            "before a recovery acts");
  expect_works(text_of("0.269 m/s", "0.1 m/s"));
  said(text_of("0.268 m/s", "0.1 m/s"));
}

// A cart that turns at 2 m/s with 2 rad/s speeds up by 1 m/s^2 all the same, and no number of the
// look-ahead is told as one of the cart.
TEST(SpeedLimits, OfWheelsTheLookAheadCountsTurningLikeSpeedingUp) {
  std::string text = edited(text_of("0.2 m/s", "0.1 m/s"), "output   thrust : acceleration;",
                            "output   thrust : twist;\n"
                            "  sense    heading  : angle   error 1 deg   max_age 50 ms;");
  text = edited(text, "point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }",
                "unicycle { speed <= 2 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; "
                "turn_accel <= 8 rad/s^2; }");
  const std::string message = said(text);
  EXPECT_EQ(message.find("the robot may reach"), std::string::npos) << message;
  EXPECT_NE(message.find("never hand control back: from rest the look-ahead takes it for up to "),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("as it counts turning like speeding up"), std::string::npos) << message;
}

// One that is as high as the declared speed is no limit (7004), and no help.
TEST(SpeedLimits, NoneIsOfferedThatFindsNothing) {
  const std::string wide = edited(text_of("0.9 m/s", "0.8 m/s"), "(6 m, 4 m)", "(30 m, 30 m)");
  const std::string noisy = edited(wide, "error 2 cm/s", "error 0.4 m/s");
  EXPECT_EQ(said(noisy),
            "monitor `calm` can never hand control back: from rest the robot may reach 1 m/s "
            "before a recovery acts");
  const std::string help = reports(*compiled(noisy));
  EXPECT_EQ(help.find("a limit of"), std::string::npos) << help;
  EXPECT_NE(help.find("for control to return, "), std::string::npos) << help;
}

// On a side of an `or` a limit counts where nothing else of it holds.
std::string choice_text(const std::string& property, const std::string& recovery) {
  const std::string zones =
      "zone slow = rectangle (1 m, 1 m) to (2 m, 2 m);\n"
      "zone fast = rectangle (3 m, 0 m) to (6 m, 4 m);\n" +
      std::string(property.starts_with("permit") ? "input permit : bool max_age 1 s;\n" : "") +
      "robot Drone {";
  const std::string text = edited(text_of("0.2 m/s", "0.1 m/s"), "robot Drone {", zones);
  return edited(edited(text, "d.speed <= 0.2 m/s", property), "retreat within room speed 0.1 m/s",
                recovery);
}
TEST(SpeedLimits, OfAChoiceCountWhereNothingElseHolds) {
  expect_works(choice_text("permit or d.speed <= 0.2 m/s", "retreat within room speed 0.179 m/s"));
  EXPECT_EQ(said(choice_text("permit or d.speed <= 0.2 m/s", "retreat within room speed 0.3 m/s")),
            "the recovery `back_off` drives at up to 0.321 m/s, and `calm` allows 0.2 m/s where "
            "nothing else of the `or` holds");
  // it stays where it may be fast
  expect_works(
      choice_text("d inside fast or d.speed <= 0.2 m/s", "retreat within fast speed 0.5 m/s"));
  said(choice_text("d inside fast or d.speed <= 0.2 m/s", "retreat within room speed 0.5 m/s"));
  // both sides are limits
  said(choice_text("permit and d.speed <= 0.2 m/s", "retreat within room speed 0.1 m/s"));
  said(
      choice_text("d.speed <= 0.1 m/s or d.speed <= 0.2 m/s", "retreat within room speed 0.1 m/s"));
}

// A robot that holds its place moves, too, as errors and pushes move it.
TEST(SpeedLimits, CountForAHold) {
  expect_works(choice_text("permit or d.speed <= 0.2 m/s", "brake_and_hold"));
  EXPECT_NE(said(choice_text("permit or d.speed <= 0.03 m/s", "brake_and_hold")), "");
}

// What is implied is looked ahead as the comparison that it stands for, and is a limit like it.
TEST(SpeedLimits, AreWrittenWithImpliesAndNot) {
  const std::string slow = "retreat within room speed 0.378 m/s";
  expect_works(choice_text("distance(d, slow) <= 30 cm implies d.speed <= 0.4 m/s", slow));
  expect_works(choice_text("distance(d, slow) >= 0 m or d.speed <= 0.4 m/s", slow));
  said(choice_text("distance(d, slow) <= 30 cm implies d.speed <= 0.4 m/s",
                   "retreat within room speed 0.5 m/s"));
  EXPECT_EQ(said(choice_text("not d.speed >= 0.2 m/s", "retreat within room speed 0.1 m/s")),
            "monitor `calm` can never hand control back: from rest the robot may reach 0.269 m/s "
            "before a recovery acts");
  const auto c = compiled(choice_text("d inside slow implies d.speed <= 0.4 m/s", slow));
  EXPECT_NE(reports(*c).find("`distance(r, slow) >= 0 m` works"), std::string::npos) << reports(*c);
}

// No parameter: the strictest limit that it may become is offered, and works.
TEST(SpeedLimits, AreConstants) {
  const std::string param = "param cap : speed in 0.5 m/s .. 0.9 m/s = 0.9 m/s;\nrobot Drone {";
  const auto c = compiled(edited(text_of("cap", "0.478 m/s"), "robot Drone {", param));
  EXPECT_TRUE(has(*c, Code::atom_without_transformer)) << reports(*c);
  EXPECT_NE(reports(*c).find("`r.speed <= 0.5 m/s` works, the strictest"), std::string::npos)
      << reports(*c);
  expect_works(text_of("0.5 m/s", "0.478 m/s"));
}

// It is beside a charge, which nobody shows to be kept: no number of it is blamed.
TEST(SpeedLimits, OneThatIsKeptIsNotBlamed) {
  std::string text = text_of("0.8 m/s and d.battery >= 20 % or permit", "0.3 m/s");
  for (const auto& [from, to] :
       {std::pair("  output ", "  sense battery : ratio error 1 % max_age 2 s;\n  output "),
        std::pair(
            "\n}\nfleet d1 : Drone;",
            "\n  energy { drive <= 0.15 %/m; idle <= 0.01 %/s; drain <= 0.3 %/s; charge >= 0.4 "
            "%/s at home; held <= 100 s; detour <= 10 m; }\n}\nfleet d1 : Drone;\n"
            "site home = (3 m, 3 m);\ninput permit : bool max_age 1 s;")}) {
    text = edited(text, from, to);
  }
  const auto c = compiled(text);
  ASSERT_EQ(c->diagnostics.all().size(), 1U) << reports(*c);
  EXPECT_EQ(
      c->diagnostics.all().front().message,
      "the recovery `back_off` drives at up to 0.321 m/s, and `calm` is not shown to allow that");
  const std::string way = "acknowledge back_off may break calm \"why\"";
  EXPECT_EQ(c->diagnostics.all().front().help, "`" + way + "` works");
  expect_works(edited(text, "priority calm; ", "priority calm; " + way + "; "));
}

// Nothing is faster than the declared speed.
TEST(SpeedLimits, TheDeclaredSpeedIsNeverExceeded) {
  const auto c = compiled(text_of("1 m/s", "1 m/s"));
  ASSERT_EQ(c->diagnostics.all().size(), 1U) << reports(*c);
  EXPECT_TRUE(has(*c, Code::monitor_vacuous)) << reports(*c);
}

}  // namespace
}  // namespace rtac::analysis::test
