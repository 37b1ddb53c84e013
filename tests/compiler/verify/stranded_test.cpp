// Places in space from which a recovery leads nowhere: a run that begins there shows it.
#include <cmath>

#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

class Stranded : public Verify {
 protected:
  void SetUp() override {
    Verify::SetUp();
    ::setenv("RTAC_SIM", RTAC_SIM_PROGRAM, 1);
  }
  static std::string page(const std::string& zone, const std::string& monitor) {
    return "spec racks;\nzone free = prism (" + zone + ") from 0 m to 30 m;\n" +
           "zone wing = rectangle (0 m, 0 m) to (8 m, 6 m);\ninput closed : bool max_age 500 "
           "ms;\n" +
           a_quad +
           "controller back : safe for Quad = retreat within free speed 1 m/s;\n"
           "monitor m for r : Quad { \"R1\" always " +
           monitor + " }\ndecision fly for Quad { advanced policy; period 50 ms; priority m; }\n";
  }
  // P2b, by a run that is played again; what was said.
  static std::string expect_shown(const std::string& text, const std::string& because) {
    const Outcome o = verified(text, {"--format", "json", "-o", "shown"});
    EXPECT_EQ(o.status, exit_violation) << o.out << o.err;
    EXPECT_EQ(statuses(o.out, "P2b", "m"), Statuses{"refuted"}) << o.out;
    EXPECT_NE(o.out.find(because), std::string::npos) << o.out;
    const Outcome again = rtac({"sim", "spec.rta", "--replay", "shown/violation.trace"});
    EXPECT_EQ(again.status, exit_violation) << again.out << again.err;
    return o.out;
  }
};

const std::string hall = "rectangle (0 m, 0 m) to (40 m, 30 m)";

TEST_F(Stranded, BetweenRacksNothingIsInSight) {
  const auto racks = [](const std::string& high) {
    return hall + " - (rectangle (5 m, 5 m) to (35 m, 7 m) | rectangle (5 m, " + high +
           " m) to (35 m, 14 m))";
  };
  const std::string monitor = "r inside free; recover back;";
  expect_shown(page(racks("9"), monitor), "to where a place to return is in sight");
  const Outcome wide = verified(page(racks("13.5"), monitor));
  EXPECT_EQ(wide.status, exit_clean) << wide.out << wide.err;
}

// Who is clear enough of its own zone is led nowhere else, also where inputs ask for another one.
TEST_F(Stranded, InAZoneThatInputsCloseNothingLeadsOut) {
  const std::string monitor = "closed implies distance(r, wing) >= 20 cm; recover back;";
  expect_shown(page(hall, monitor), "needs it to stay in `complement(wing)`");
}

// A ward of 10 m, with a station in its middle that leaves 1 m beside it: in the middle of that
// the cart is as clear as nowhere on its ways over cells, and where it is measured exactly it
// stays. Inputs that ask for nothing leave it alone; what is offered leaves the passage out.
TEST_F(Stranded, InAPassageThatIsNarrowerThanItsClearanceOfReturnItStands) {
  const std::string text = R"(spec cart;
zone ward = rectangle (0 m, 0 m) to (10 m, 10 m);
zone free = ward - rectangle (4 m, 5 m) to (6 m, 9 m);
input estop : bool max_age 300 ms;
input load : real [kg] in 0 kg .. 20 kg max_age 300 ms;
robot Cart {
  body radius 30 cm;
  motion point { speed <= 0.8 m/s; accel <= 0.8 m/s^2; brake >= 0.8 m/s^2; }
  sense position : point error 2 cm max_age 80 ms;
  sense velocity : vector error 2 cm/s max_age 80 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet cart : Cart;
controller nav : advanced for Cart extern;
controller stop : safe for Cart = brake_and_hold;
controller back : safe for Cart = retreat within free speed 0.3 m/s;
monitor halt for c : Cart { "R1: stands at an emergency stop, and under a load" always (estop or load >= 5 kg) implies c.speed <= 0.1 m/s; recover stop; }
monitor m for c : Cart { "R2: stays in the ward" always c inside free; recover back; }
decision drive for Cart { advanced nav; period 50 ms; priority halt > m; }
)";
  const std::string said = expect_shown(text, "no way over its cells leads to where control");
  EXPECT_NE(read("shown/violation.trace").find("end not given back: cart"), std::string::npos);
  const std::string before = "`grow(shrink(free, ";
  const std::size_t at = said.find(before);
  ASSERT_NE(at, std::string::npos) << said;
  const std::string by = said.substr(at + before.size(), said.find(" m)", at) - at - before.size());
  const std::string wide =
      "zone wide = grow(shrink(free, " + by + " m), " + by + " m);\ninput estop";
  const Outcome without = verified(
      edited(edited(edited(text, "within free", "within wide"), "c inside free", "c inside wide"),
             "input estop", wide));
  EXPECT_EQ(without.status, exit_clean) << without.out << without.err;
}

// Two rooms that lie across the grid, and a passage between them from which a leg leads on: who
// brakes for a minute before that, or turns for as long, stands meanwhile for 30 s and longer.
TEST_F(Stranded, WhoIsYetToSetOutIsNotSaidToStand) {
  const auto rooms = [](const std::string& motion, const std::string& recovery) {
    const bool turns = motion.starts_with("unicycle");
    return R"(spec cart;
zone free = polygon [(5.000 m, 5.000 m), (8.825 m, 6.169 m), (8.401 m, 7.556 m), (10.314 m, 8.141 m), (10.738 m, 6.754 m), (14.563 m, 7.924 m), (13.394 m, 11.749 m), (9.568 m, 10.579 m), (9.992 m, 9.193 m), (8.080 m, 8.608 m), (7.656 m, 9.995 m), (3.831 m, 8.825 m)];
robot Cart {
  body radius 30 cm;
  motion )" +
           motion +
           R"(
  sense position : point error 2 cm max_age 80 ms;
)" + (turns ? "  sense heading : angle error 1 deg max_age 80 ms;\n" : "") +
           R"(  sense velocity : vector error 2 cm/s max_age 80 ms;
  output move : )" +
           (turns ? "twist" : "acceleration") + R"(;
  latency 30 ms;
}
fleet cart : Cart;
controller nav : advanced for Cart extern;
controller back : safe for Cart = )" +
           recovery + R"(;
monitor m for c : Cart { "R2: stays in the ward" always c inside free; recover back; }
decision drive for Cart { advanced nav; period 50 ms; priority m; }
)";
  };
  const std::string retreat = "retreat within free speed 0.3 m/s";
  const std::string pages[] = {
      rooms("point { speed <= 0.8 m/s; accel <= 0.8 m/s^2; brake >= 0.8 m/s^2; }",
            "sequence brake_and_hold for 60 s then " + retreat),
      rooms("unicycle { speed <= 0.3 m/s; accel <= 0.8 m/s^2; brake >= 0.8 m/s^2; turn <= 0.04 "
            "rad/s; }",
            retreat)};
  for (const std::string& page : pages) {
    const Outcome o = verified(page, {"--format", "json"});
    EXPECT_EQ(statuses(o.out, "P2b", "m"), Statuses{"unknown"}) << o.out << o.err;
  }
}

// Its `return when` asks for what it does not lead to.
TEST_F(Stranded, AboveTheHeightThatLetsItGoItIsLedNoLower) {
  expect_shown(page(hall, "r inside free; recover back; return when r.position.z <= 20 m;"),
               "`return when` of `m` holds where `back` leads");
  const std::string lower = "r inside free; recover back; return when r.position.z <= 29.5 m;";
  const Outcome o = verified(page(hall, lower));
  EXPECT_EQ(o.status, exit_clean) << o.out << o.err;
}

TEST_F(Stranded, ALandingAboveTheHeightThatLetsItGoIsToldHowHighThatHasToBe) {
  const auto landing = [](const std::string& limit) {
    return "spec high;\n" + a_quad +
           "controller down : safe for Quad = land to 10 m speed 0.8 m/s;\n"
           "monitor m for r : Quad { \"R1\" always r.position.z <= 25 m; recover down; "
           "return when r.position.z <= " +
           limit + "; }\ndecision fly for Quad { advanced policy; period 50 ms; priority m; }\n";
  };
  const std::string before = "a limit of ", after = " m in `return when` works";
  const Outcome o = verified(landing("5 m"));
  const std::size_t at = o.out.find(before), end = o.out.find(after);
  ASSERT_NE(end, std::string::npos) << o.out;
  const double works = std::stod(o.out.substr(at + before.size()));
  expect_shown(landing("5 m"), "it ends at 10 m");
  EXPECT_EQ(verified(landing(std::to_string(works) + " m")).status, exit_clean) << works;
  const double beyond = std::round(950 * works) / 1000;
  const Outcome less = verified(landing(std::to_string(beyond) + " m"));
  EXPECT_EQ(less.status, exit_inconclusive) << less.out;
}

// A run waits for as long as a condition has to hold.
TEST_F(Stranded, WhatHasToHoldForMinutesIsWaitedFor) {
  const std::string either = "(r.position.z <= 20 m or r.position.z >= 19 m) for 5 min";
  const Outcome o = verified(page(hall, "r inside free; recover back; return when " + either + ";"),
                             {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2b", "m"), Statuses{"unknown"}) << o.out;
}

}  // namespace
}  // namespace rtac::driver::test
