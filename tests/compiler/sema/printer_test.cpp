// The canonical text of a checked specification: quantities in SI, properties fully bracketed.
#include "tests/compiler/sema/helpers.h"

namespace rtac::sema::test {
namespace {

TEST(SpecPrinter, ListsTheWholeSpecification) {
  const auto checked = check_text(yard());
  ASSERT_TRUE(checked->spec) << checked->reports();
  EXPECT_TRUE(checked->engine.all().empty()) << checked->reports();
  EXPECT_EQ(dump(*checked->spec), R"(spec yard
zone arena = polygon [(0, 0), (5, 0), (5, 5), (0, 5)]
zone box = polygon [(2, 2), (3, 2), (3, 3), (2, 3)]
zone free = (arena - box)
kind Cart
  radius 0.11 m
  motion unicycle speed 0.5 m/s accel 1 m/s^2 brake 2 m/s^2 turn 2 rad/s turn_accel 10 rad/s^2
  sense position error 0.02 m max_age 0.2 s
  sense heading error 0.0349066 rad max_age 0.15 s
  sense velocity error 0.01 m/s max_age 0.2 s
  sense battery error 0.5 % max_age 5 s
  hears max_age 0.25 s
  plan capacity 64 tracking 0.1 m
  output drive : twist
  latency 0.04 s
  energy drive 0.4 %/m idle 0.01 %/s drain 0.2 %/s charge 1 %/s at dock held 60 s detour 3 m
kind Drone
  radius 0.08 m
  motion point speed 1 m/s accel 3 m/s^2 brake 3 m/s^2
  sense position error 0.03 m max_age 0.05 s
  sense velocity error 0.03 m/s max_age 0.05 s
  output thrust : acceleration
  latency 0.02 s
robot c1 : Cart
robot c2 : Cart
robot d1 : Drone
site dock(c1) = (1, 1)
site dock(c2) = (4, 4)
site home = (1, 4)
controller policy : advanced for Cart = extern
controller planner : advanced for Cart = extern
controller careful : safe for Cart = extern
controller give_way : safe for Cart = yield within free speed 0.1 m/s order id
controller turn_back : safe for Cart = retreat within free speed 0.1 m/s
controller go_charge : safe for Cart = route to dock within free speed 0.2 m/s
controller pilot : advanced for Drone = extern
controller back_off : safe for Drone = retreat within arena speed 0.3 m/s
monitor apart for Cart
  requirement "R1" "carts keep apart"
  always (forall other : (distance(self, other) >= 0.08 m))
  ahead 0.2 s, 2 waypoints
  recover give_way
monitor fence for Cart
  requirement "R2" "carts stay in the free area"
  always (self inside free)
  ahead 0.3 s, 3 waypoints
  recover turn_back
  return when ((clearance(self, free) >= 0.05 m) for 1 s)
monitor charge for Cart
  requirement "R3" "carts reach their dock"
  always (self.battery >= (energy_to(dock(self)) + 5 %))
  ahead 0.2 s
  recover go_charge
  return when (self.battery >= 90 %)
monitor plan_ok for Cart
  requirement "R4" "plans keep 15 cm"
  always (self.plan inside shrink(free, 0.26))
  ahead derived duration
monitor ceiling for Drone
  requirement "R5" "the drone stays 20 cm inside"
  always (clearance(self, arena) >= 0.2 m)
  ahead 0.1 s
  recover back_off
decision drive for Cart
  advanced policy
  period 0.1 s
  priority apart > fence > charge
  acknowledge give_way may break charge "the reserve covers it"
decision planning for Cart
  advanced planner
  safe careful
  on plan
  priority plan_ok
decision fly for Drone
  advanced pilot
  period 0.05 s
  priority ceiling
)");
}

// The order of declarations has no meaning: what is used first may be declared last.
TEST(SpecPrinter, OrderOfDeclarationsDoesNotMatter) {
  std::string text = yard();
  const std::size_t begin = text.find("zone arena");
  const std::size_t end = text.find("controller policy");
  const std::string declarations = text.substr(begin, end - begin);
  const auto first = check_text(text);
  const auto last = check_text(text.erase(begin, end - begin) + declarations);
  ASSERT_TRUE(first->spec && last->spec) << last->reports();
  EXPECT_EQ(dump(*first->spec), dump(*last->spec));
}

TEST(SpecPrinter, EscapesTexts) {
  const auto checked =
      check_text(edited(yard(), {{"R1: carts keep apart", R"(R1: say \"apart\")"}}));
  ASSERT_TRUE(checked->spec) << checked->reports();
  EXPECT_NE(dump(*checked->spec).find(R"(requirement "R1" "say \"apart\"")"), std::string::npos);
}

}  // namespace
}  // namespace rtac::sema::test
