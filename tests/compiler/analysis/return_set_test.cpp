// Of the monitors of a decision, the one is named that no place to hand control back is found for,
// with a number that works; all of them hand back where one retreats.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

// `near` and `far` stay in a room of 5 m; `far` retreats in the room or in a hall around it.
struct Spec {
  std::string near_ahead = "100 ms", far_ahead = "100 ms";
  std::string far_clearance = "10 cm", far_zone = "room";
  std::string near_returns = "";
};
std::string text_of(const Spec& s) {
  return R"(spec two;
zone room = rectangle (0 m, 0 m) to (5 m, 5 m);
zone hall = rectangle (-20 m, -20 m) to (20 m, 20 m);
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
controller back_off : safe for Drone = retreat within room speed 0.3 m/s;
controller come_in  : safe for Drone = retreat within )" +
         s.far_zone + R"( speed 0.3 m/s;
monitor near for d : Drone {
  "SR-1: clear of the walls" always clearance(d, room) >= 10 cm;
  ahead )" +
         s.near_ahead + "; recover back_off; " + s.near_returns + R"(
}
monitor far for d : Drone {
  "SR-2: far from them" always clearance(d, )" +
         s.far_zone + ") >= " + s.far_clearance + R"(;
  ahead )" +
         s.far_ahead + R"(; recover come_in;
}
decision fly for Drone { advanced pilot; period 50 ms; priority near > far; }
)";
}

// The text that the only report, a 5007, stands at.
std::string named(const driver::Compilation& c, const std::string& text) {
  EXPECT_EQ(c.diagnostics.all().size(), 1U) << reports(c);
  if (!has(c, Code::return_set_empty)) return "";
  const auto& d = c.diagnostics.all().front();
  return d.message + ": " + text.substr(d.range->begin, d.range->end - d.range->begin);
}
void expect_named(const Spec& faulty, const std::string& what) {
  const std::string text = text_of(faulty);
  EXPECT_EQ(named(*compiled(text), text), what);
}
void expect_works(const Spec& s) {
  const auto c = compiled(text_of(s));
  EXPECT_TRUE(c->module) << reports(*c);
}
void expect_no_error(const std::string& text) {
  const auto c = compiled(text);
  EXPECT_FALSE(c->diagnostics.has_errors()) << reports(*c);
}
std::string thousandth_more(const std::string& number) {
  return std::to_string(std::stod(number) + 0.001);
}

const std::string of_near = "monitor `near` can never hand control back: ";
const std::string of_far = "monitor `far` can never hand control back: ";

TEST(ReturnSet, TwoShortLookaheadsAreFine) {
  expect_works({});
  expect_works({.far_zone = "hall"});
}

TEST(ReturnSet, TheMonitorThatLooksTooFarAheadIsNamedAlone) {
  expect_named({.far_ahead = "2 s"}, of_far + "2 s");
  expect_named({.near_ahead = "2 s"}, of_near + "2 s");
  expect_named({.near_ahead = "2 s", .far_zone = "hall"}, of_near + "2 s");
}

// The other monitor retreats to where both hand back, and finds no such place.
TEST(ReturnSet, ALookaheadThatAnotherMonitorsRetreatHasNoRoomForIsNamed) {
  const Spec faulty{.far_ahead = "2 s", .far_zone = "hall"};
  expect_named(faulty, of_far + "2 s");
  const auto c = compiled(text_of(faulty));
  const auto& notes = c->diagnostics.all().front().notes;
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_NE(notes[1].text.find("`near`"), std::string::npos) << notes[1].text;
}

TEST(ReturnSet, BothAreNamedWhenBothLookTooFarAhead) {
  const auto c = compiled(text_of({.near_ahead = "3 s", .far_ahead = "2 s"}));
  ASSERT_EQ(c->diagnostics.all().size(), 2U) << reports(*c);
  const std::string most = number_in_help(*c, Code::return_set_empty, "at most ", "ms") + " ms";
  expect_works({.near_ahead = most, .far_ahead = most});
}

TEST(ReturnSet, AStandoffThatNoLookaheadMakesUpForIsNamedWithTheLargestThatWorks) {
  // of the hall, what the room keeps anyway costs it nothing
  expect_works({.far_clearance = "14 m", .far_zone = "hall"});
  for (const auto& [zone, clearance] :
       {std::pair<std::string, std::string>{"room", "3 m"}, {"hall", "16 m"}}) {
    const Spec faulty{.far_clearance = clearance, .far_zone = zone};
    expect_named(faulty, of_far + "clearance(d, " + zone + ") >= " + clearance);
    const std::string most =
        number_in_help(*compiled(text_of(faulty)), Code::return_set_empty, "at most ", "m works");
    expect_works({.far_clearance = most + " m", .far_zone = zone});
    EXPECT_TRUE(has(
        *without_offers(text_of({.far_clearance = thousandth_more(most) + " m", .far_zone = zone})),
        Code::return_set_empty));
  }
}

// What each monitor alone could hand back in is of no use where they have no place in common.
TEST(ReturnSet, ZonesWithoutAPlaceInCommonAreNamed) {
  const auto beside = [](const std::string& from) {
    const std::string hall = edited(text_of({.far_clearance = "0 m", .far_zone = "hall"}),
                                    "zone hall = rectangle (-20 m, -20 m)",
                                    "zone hall = rectangle (" + from + " m, -20 m)");
    return edited(hall, "near > far;", "near > far; acknowledge back_off may break far \"why\";");
  };
  const auto c = compiled(beside("6"));
  ASSERT_TRUE(has(*c, Code::return_set_empty)) << reports(*c);
  EXPECT_NE(reports(*c).find("`far` can never hand control back together with `near`"),
            std::string::npos)
      << reports(*c);
  EXPECT_TRUE(has(*without_offers(beside("4.9")), Code::return_set_empty));
  expect_no_error(beside("3"));
  // a number that works: so much more of the hall
  const auto narrow = compiled(beside("4.5"));
  const double more =
      std::stod(number_in_help(*narrow, Code::return_set_empty, "`grow(hall, ", "m)"));
  expect_no_error(beside(std::to_string(4.5 - more)));
}

TEST(ReturnSet, AConditionAboutAnotherZoneThanTheRetreatsIsNamedWithTheLargestThatWorks) {
  const auto asks = [](const std::string& clearance) {
    return Spec{.far_zone = "hall",
                .near_returns = "return when clearance(d, hall) >= " + clearance + " m;"};
  };
  // all of the room is 15 m off the walls of the hall, and its middle 17.5 m
  expect_works(asks("14"));
  expect_named(asks("18"), of_near + "clearance(d, hall) >= 18 m");
  const std::string most = number_in_help(*compiled(text_of(asks("18"))), Code::return_set_empty,
                                          "clearance of ", "m works");
  EXPECT_GT(std::stod(most), 17);
  expect_works(asks(most));
  EXPECT_TRUE(has(*without_offers(text_of(asks(thousandth_more(most)))), Code::return_set_empty));
}

}  // namespace
}  // namespace rtac::analysis::test
