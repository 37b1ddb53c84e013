// What is offered where recoveries break each other has been tried, and what is acknowledged
// without need is said.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

std::string yard_with(const std::string& monitors, const std::string& clauses,
                      const std::string& energy = "idle <= 0.01 %/s",
                      const std::string& held = "held <= 60 s; detour <= 10 m") {
  return R"(spec yard;
zone yard = rectangle (0 m, 0 m) to (8 m, 8 m);
zone west = rectangle (0 m, 0 m) to (4 m, 8 m);
zone gate = rectangle (0 m, 0 m) to (1 m, 1 m);
robot Rover {
  body     radius 10 cm;
  motion   unicycle { speed <= 0.3 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 10 rad/s^2; }
  sense    position : point   error 1 cm    max_age 100 ms;
  sense    heading  : angle   error 2 deg   max_age 100 ms;
  sense    velocity : vector  error 1 cm/s  max_age 100 ms;
  sense    battery  : ratio   error 1 %     max_age 2 s;
  output   drive    : twist;
  latency  20 ms;
  energy   { drive <= 0.5 %/m; )" +
         energy + R"(; drain <= 2 %/s; charge >= 1 %/s at home; )" + held + R"(; }
}
fleet one : Rover;
site  home = (1.5 m, 1.5 m);
controller explore : advanced for Rover extern;
controller stop    : safe for Rover = brake_and_hold;
controller inwards : safe for Rover = retreat within yard speed 0.2 m/s;
controller go_west : safe for Rover = retreat within west speed 0.2 m/s;
controller go_home : safe for Rover = route to home within west speed 0.2 m/s;
monitor charged for r : Rover { "SR-1: home again" always r.battery >= energy_to(home) + 5 %; recover go_home; }
)" + monitors +
         "decision drive for Rover { advanced explore; period 100 ms; " + clauses + " }\n";
}
std::string fence(const std::string& more) {
  return "monitor fence for r : Rover { \"SR-2: in the yard\" always r inside yard; recover "
         "inwards; " +
         more + "}\n";
}
const char* const side =
    "monitor side for r : Rover { \"SR-3: in the west\" always r inside west; recover go_west; }\n";

const diag::Diagnostic* first(const driver::Compilation& c, Code code) {
  for (const auto& d : c.diagnostics.all()) {
    if (d.code == code) return &d;
  }
  return nullptr;
}
std::string help_of(const std::string& text) {
  const auto c = compiled(text);
  const auto* found = first(*c, Code::recovery_breaks);
  EXPECT_NE(found, nullptr) << reports(*c);
  return found == nullptr ? "" : found->help;
}
bool faulty(const std::string& text) {
  return without_offers(text)->diagnostics.has_errors();
}
bool offers(const std::string& help, const std::string& what) {
  return help.find(what) != std::string::npos;
}

// A rank is no way out while the fence waits for a place that nothing leads to: whoever takes over
// gives it back to wait on. To let go without more is one.
TEST(Offers, NoRankHelpsWhereAMonitorWaitsForWhatNeverComes) {
  const std::string waits = fence("return when r inside gate; ");
  const std::string help = help_of(yard_with(waits, "priority fence > charged;"));
  EXPECT_FALSE(offers(help, "priority")) << help;
  EXPECT_TRUE(offers(help, "`fence` without `return when` works")) << help;
  EXPECT_FALSE(faulty(yard_with(fence(""), "priority fence > charged;")));
  // accepted, it has no error; but whoever waits is led home, and back to wait, as often as it
  // takes
  const std::string accepted = fence("return when r inside gate; hold when violated \"staff\"; ");
  EXPECT_FALSE(faulty(yard_with(accepted, "priority charged > fence;")));
  EXPECT_FALSE(offers(help_of(yard_with(accepted, "priority fence > charged;")), "priority"));
}

// Both numbers at once, if both are too small; and they work.
TEST(Offers, NumbersOfTheEnergyClauseAreTriedTogether) {
  const auto text = [](const std::string& held) {
    return yard_with(fence(""), "priority fence > charged;", "idle <= 0.01 %/s", held);
  };
  const std::string help = help_of(text("held <= 1 s; detour <= 1 cm"));
  const std::size_t held = help.find("`held <= "), detour = help.find("` with `detour <= ");
  ASSERT_TRUE(held != std::string::npos && detour != std::string::npos) << help;
  const std::size_t end = help.find("` works", detour);
  ASSERT_NE(end, std::string::npos) << help;
  const std::string longer = help.substr(held + 1, detour - held - 1);
  const std::size_t begin = help.find("detour", detour);
  const std::string farther = help.substr(begin, end - begin);
  EXPECT_FALSE(faulty(text(longer + "; " + farther))) << longer << farther;
  EXPECT_TRUE(faulty(text(longer + "; detour <= 1 cm")));
  EXPECT_TRUE(faulty(text("held <= 1 s; " + farther)));
}

// A reserve that no battery has is none that works.
TEST(Offers, AReserveThatNoBatteryHasIsNotOffered) {
  const auto text = [](const std::string& idle) {
    return edited(yard_with(fence(""), "priority fence > charged;", "idle <= " + idle + " %/s",
                            "held <= 1 s; detour <= 10 m"),
                  "retreat within yard speed 0.2 m/s", "retreat within yard speed 2 mm/s");
  };
  EXPECT_TRUE(offers(help_of(text("0.01")), "`held <= "));
  const std::string help = help_of(text("0.33"));
  EXPECT_FALSE(offers(help, "`held <= ")) << help;
  EXPECT_TRUE(offers(help, "`priority charged > fence;` works")) << help;
}

// A zone is offered that suits all that share the recovery: without an end it is none for a fence,
// whatever of that is acknowledged.
TEST(Offers, AZoneSuitsWhoSharesTheRecovery) {
  const std::string text = R"(spec pond;
zone room = rectangle (0 m, 0 m) to (8 m, 8 m);
zone pond = circle (5.24 m, 0.02 m) radius 0.88 m;
zone dry = room - grow(pond, 0.55 m);
robot Rover {
  body     radius 0.2 m;
  motion   unicycle { speed <= 1.07 m/s; turn <= 2.36 rad/s; accel <= 1.62 m/s^2; brake >= 1.46 m/s^2; turn_accel <= 5.1 rad/s^2; }
  sense    position : point   error 0.026 m    max_age 100 ms;
  sense    heading  : angle   error 1.19 deg   max_age 100 ms;
  sense    velocity : vector  error 0.016 m/s  max_age 100 ms;
  output   drive : twist;
  latency  10 ms;
}
fleet k1 : Rover;
controller ac  : advanced for Rover extern;
controller off : safe for Rover = loiter within dry speed 0.41 m/s;
monitor pondoff for c : Rover { "SR-1: off the pond" always distance(c, pond) >= 0.5 m; recover off; }
monitor dryin   for c : Rover { "SR-2: dry" always c inside dry; recover off; }
decision guard for Rover { advanced ac; period 200 ms; priority pondoff > dryin; acknowledge off may break dryin "x"; }
)";
  const auto c = compiled(text);
  const auto* found = first(*c, Code::recovery_elsewhere);
  ASSERT_NE(found, nullptr) << reports(*c);
  EXPECT_TRUE(offers(found->help, "is needed, and not alone: other errors are left"))
      << found->help;
}

// Nor is one that has a name of its own: the next report would ask for an end.
TEST(Offers, NoZoneWithoutAnEnd) {
  const auto c = compiled(R"(spec lake;
zone pond = polygon [(1 m, 1 m), (5 m, 3 m), (4 m, 6 m)];
zone land = complement(pond);
zone yard = rectangle (0 m, 0 m) to (20 m, 20 m);
zone bank = yard - pond;
input lost : bool max_age 1 s;
robot Cart {
  body     radius 15 cm;
  motion   unicycle { speed <= 0.8 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 8 rad/s^2; }
  sense    position : point   error 2 cm    max_age 60 ms;
  sense    heading  : angle   error 2 deg   max_age 60 ms;
  sense    velocity : vector  error 3 cm/s  max_age 40 ms;
  output   drive : twist;
  latency  30 ms;
}
fleet c : Cart;
controller job  : advanced for Cart extern;
controller back : safe for Cart = retreat within yard speed 0.3 m/s;
controller off  : safe for Cart = retreat within bank speed 0.3 m/s;
monitor found for r : Cart { "R2" always not lost; recover back; }
monitor dry for r : Cart { "R1" always r inside land and r inside yard; recover off; }
decision go for Cart { advanced job; period 50 ms; priority found > dry; }
)");
  const auto* const breaks = first(*c, Code::recovery_breaks);
  ASSERT_NE(breaks, nullptr) << reports(*c);
  EXPECT_FALSE(offers(breaks->help, "within `land`")) << breaks->help;
}

// Of three fields that are left by each other's recoveries one zone in all of them is offered, and
// tried.
std::string three_fields(const std::string& in_a, const std::string& in_b,
                         const std::string& in_c) {
  return R"(spec three_fields;
zone a = rectangle (0 m, 0 m) to (20 m, 12 m);
zone b = rectangle (6 m, 0 m) to (26 m, 12 m);
zone c = rectangle (3 m, -4 m) to (23 m, 8 m);
zone for_a = )" +
         in_a + ";\nzone for_b = " + in_b + ";\nzone for_c = " + in_c + R"(;
robot Bot {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 50 ms;
  sense   velocity : vector error 2 cm/s max_age 50 ms;
  output  push : acceleration;
  latency 50 ms;
}
fleet r1 : Bot;
controller go : advanced for Bot extern;
controller ra : safe for Bot = retreat within for_a speed 0.4 m/s;
controller rb : safe for Bot = retreat within for_b speed 0.4 m/s;
controller rc : safe for Bot = retreat within for_c speed 0.4 m/s;
monitor ma for r : Bot { "R1: in field a" always r inside a; recover ra; }
monitor mb for r : Bot { "R2: in field b" always r inside b; recover rb; }
monitor mc for r : Bot { "R3: in field c" always r inside c; recover rc; }
decision drive for Bot { advanced go; period 100 ms; coordinate ma > mb > mc; }
)";
}
TEST(Offers, AZoneInAllThatIsNotKept) {
  const std::string help = help_of(three_fields("a", "b", "c"));
  const std::string before = "a recovery within a zone that is `", after = "` works";
  const std::size_t at = help.find(before), end = help.find(after, at);
  ASSERT_TRUE(at != std::string::npos && end != std::string::npos) << help;
  const std::string zone = help.substr(at + before.size(), end - at - before.size());
  const auto breaks_of_a = [](const std::string& text) {
    return reports(*compiled(text)).find("while `ra` drives") != std::string::npos;
  };
  EXPECT_FALSE(breaks_of_a(three_fields(zone, "b", "c"))) << zone;
  EXPECT_TRUE(breaks_of_a(three_fields("a & b", "b", "c")));
}

int superfluous(const std::string& clauses) {
  const auto c = compiled(yard_with(fence("") + side, clauses));
  EXPECT_FALSE(c->diagnostics.has_errors()) << reports(*c);
  int count = 0;
  for (const auto& d : c->diagnostics.all()) count += d.code == Code::acknowledge_superfluous;
  return count;
}
// The west lies in the yard.
TEST(Acknowledgements, WhatIsKeptNeedsNone) {
  EXPECT_EQ(superfluous("priority side > fence; acknowledge go_west may break fence \"slow\";"), 1);
  EXPECT_EQ(superfluous("priority side > fence;"), 0);
  // a retreat within the zone of its own monitor, too
  EXPECT_EQ(superfluous("priority side > fence; acknowledge go_west may break side \"slow\";"), 1);
}
// What is broken; what another monitor takes over from; who stands where nobody lets go; and what
// takes charge, which is bounded and not given back where a retreat ends.
TEST(Acknowledgements, WhatAcceptsSomethingIsLeft) {
  EXPECT_EQ(superfluous("priority fence > side; acknowledge inwards may break side \"why\";"), 0);
  EXPECT_EQ(superfluous("priority side > fence; acknowledge inwards may break side \"why\";"), 0);
  EXPECT_EQ(superfluous("priority side > charged; acknowledge go_west may break charged \"why\";"),
            0);
}

// ---- straight down

std::string landing(const std::string& zone, const std::string& property) {
  return R"(spec hall;
zone all  = prism (rectangle (0 m, 0 m) to (9 m, 9 m)) from 0 m to 12 m;
zone area = )" +
         zone + R"(;
robot Quad {
  body     radius 20 cm;
  motion   point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense    position : point3   error 2 cm    max_age 50 ms;
  sense    velocity : vector3  error 2 cm/s  max_age 50 ms;
  output   thrust : acceleration;
  latency  20 ms;
}
fleet quad : Quad;
controller pilot : advanced for Quad extern;
controller back  : safe for Quad = retreat within area speed 0.3 m/s;
controller down  : safe for Quad = land to 1 m speed 0.3 m/s;
monitor walls for q : Quad { "SR-1: in the hall" always q inside all; recover down; hold when violated "it lands"; }
monitor part  for q : Quad { "SR-2: in the area" always )" +
         property + R"(; recover back; }
decision fly for Quad { advanced pilot; period 50 ms; priority walls > part; }
)";
}
std::string stack(const std::string& below, const std::string& above) {
  return "prism (rectangle (0 m, 0 m) to (" + below +
         " m, 9 m)) from 0 m to 4 m | prism (rectangle (0 m, 0 m) to (" + above +
         " m, 9 m)) from 4 m to 12 m";
}

// Down through what gets no narrower, and no farther than the property lets it.
TEST(Landing, KeepsAZoneThatGetsNoNarrowerDownwards) {
  EXPECT_FALSE(faulty(landing(stack("9", "5"), "q inside area")));
  EXPECT_TRUE(faulty(landing(stack("5", "9"), "q inside area")));
  const std::string whole = "prism (rectangle (0 m, 0 m) to (9 m, 9 m)) from 0 m to 12 m";
  EXPECT_FALSE(faulty(landing(whole, "clearance(q, area) >= 30 cm")));
  EXPECT_TRUE(faulty(landing(whole, "clearance(q, area) >= 80 cm")));
}

// In space, too, what is left of the zone is offered, and works.
TEST(Offers, WhatIsAsFarOffAsIsAskedInSpace) {
  const std::string page = R"(spec air;
zone plot     = box (0 m, 0 m, 0 m) to (60 m, 40 m, 30 m);
zone building = box (25 m, 15 m, 0 m) to (35 m, 25 m, 12 m);
zone sky      = plot - building;
zone clear    = sky - grow(building, 2 m);
robot Drone {
  body     radius 40 cm;
  motion   point { speed <= 4 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense    position : point3  error 10 cm   max_age 100 ms;
  sense    velocity : vector3 error 10 cm/s max_age 100 ms;
  output   thrust : acceleration;
  latency  50 ms;
}
fleet d1 : Drone;
controller fly  : advanced for Drone extern;
controller back : safe for Drone = retreat within sky speed 1 m/s;
monitor house for d : Drone { "R1: off the building" always distance(d, building) >= 2 m; ahead 200 ms; recover back; }
monitor fence for d : Drone { "R2: in the plot" always d inside plot; ahead 200 ms; recover back; }
decision drive for Drone { advanced fly; period 100 ms; priority house > fence; }
)";
  const auto c = compiled(page);
  EXPECT_FALSE(c->module);
  EXPECT_NE(reports(*c).find("works, such as `sky - grow(building, 2 m)`"), std::string::npos)
      << reports(*c);
  const auto mended = compiled(edited(page, "within sky", "within clear"));
  EXPECT_TRUE(mended->module) << reports(*mended);
}

// Two halls, and a lane between them that is too narrow for the ways of the recovery. A grid that
// happens to lie well is not enough: what is offered works by the walls, too. Nor need walls be
// moved: the halls without the lane work, and with what is wider than it they do not.
TEST(Offers, AWidthOfALaneThatWorks) {
  const std::string page = R"(spec halls;
zone west = rectangle (0 m, 0 m) to (6 m, 5 m);
zone east = rectangle (9 m, 0 m) to (15 m, 5 m);
zone lane = rectangle (6 m, 2 m) to (9 m, 3.2 m);
zone free = west | lane | east;
robot Mower {
  body     radius 30 cm;
  motion   unicycle { speed <= 0.8 m/s; turn <= 1.5 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 6 rad/s^2; }
  sense    position : point   error 3 cm    max_age 100 ms;
  sense    heading  : angle   error 2 deg   max_age 100 ms;
  sense    velocity : vector  error 3 cm/s  max_age 100 ms;
  output   drive : twist;
  latency  50 ms;
}
fleet m1 : Mower;
controller mow  : advanced for Mower extern;
controller back : safe for Mower = retreat within free speed 0.3 m/s;
monitor fence for r : Mower { "R1: in the halls" always r inside free; ahead 200 ms; recover back; }
decision drive for Mower { advanced mow; period 100 ms; priority fence; }
)";
  const auto c = compiled(page);
  const std::string said = reports(*c);
  const auto offered = [&](const std::string& before) {
    const std::size_t at = said.find(before);
    EXPECT_NE(at, std::string::npos) << said;
    return said.substr(at + before.size(), said.find(" m)", at) - at - before.size());
  };
  const auto within = [&](const std::string& zone) {
    return without_offers(
        edited(edited(edited(page, "inside free", "inside other"), "within free", "within other"),
               "robot Mower", "zone other = " + zone + ";\nrobot Mower"));
  };
  const std::string by = offered(" `grow(free, ");
  const auto wider = within("grow(free, " + by + " m)");
  EXPECT_TRUE(wider->diagnostics.all().empty()) << by << reports(*wider);
  const auto opened = [&](double m) {
    const std::string text = std::to_string(m) + " m";
    return within("grow(shrink(free, " + text + "), " + text + ")");
  };
  const double without = std::stod(offered("(`grow(shrink(free, "));
  EXPECT_TRUE(opened(without)->diagnostics.all().empty()) << reports(*opened(without));
  EXPECT_FALSE(opened(0.95 * without)->diagnostics.all().empty()) << without;
}

// A landing on something low is offered so high that it keeps a floor, and breaks no ceiling.
TEST(Offers, ALandingIsSoHighThatItKeepsAFloor) {
  const auto page = [](const std::string& height, const std::string& limit) {
    return R"(spec lands;
input link : bool max_age 1 s;
robot Quad {
  body radius 30 cm;
  motion point { speed <= 3 m/s; accel <= 2 m/s^2; brake >= 2 m/s^2; }
  sense position : point3 error 5 cm max_age 50 ms;
  sense velocity : vector3 error 5 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 20 ms;
}
fleet q : Quad;
controller policy : advanced for Quad extern;
controller down : safe for Quad = land to )" +
           height + R"( speed 0.5 m/s;
controller stay : safe for Quad = brake_and_hold;
monitor radio for r : Quad { "R1" always link; recover down; }
monitor limit for r : Quad { "R2" always r.position.z )" +
           limit + R"(; recover stay; hold when violated "a pilot"; }
decision fly for Quad { advanced policy; period 50 ms; priority radio > limit; }
)";
  };
  const auto low = compiled(page("1 m", ">= 5 m"));
  ASSERT_TRUE(has(*low, diag::Code::recovery_breaks)) << reports(*low);
  EXPECT_NE(reports(*low).find("`land to 5.83 m` works"), std::string::npos) << reports(*low);
  EXPECT_TRUE(compiled(page("5.83 m", ">= 5 m"))->diagnostics.all().empty());
  EXPECT_TRUE(has(*compiled(page("5.53 m", ">= 5 m")), diag::Code::recovery_breaks));
  EXPECT_TRUE(compiled(page("-1 m", "<= 10 m"))->diagnostics.all().empty());
}

// Of what several monitors ask for the highest landing keeps all. Below them it would take turns
// with what leads up again for as long as the link is lost: such an order is not offered.
TEST(Offers, ALandingIsHighEnoughForAllThatItWouldLeave) {
  const auto page = [](const std::string& height, const std::string& recovers) {
    return R"(spec greenhouse;
zone farm  = box (0 m, 0 m, 0 m) to (80 m, 60 m, 30 m);
zone green = box (30 m, 20 m, 0 m) to (50 m, 40 m, 6 m);
zone air   = farm - grow(green, 4 m);
input link : bool max_age 1 s;
robot Quad {
  body radius 40 cm;
  motion point { speed <= 4 m/s; accel <= 3 m/s^2; brake >= 3 m/s^2; }
  sense position : point3 error 10 cm max_age 50 ms;
  sense velocity : vector3 error 8 cm/s max_age 50 ms;
  output thrust : acceleration;
  latency 30 ms;
}
fleet q : Quad;
controller survey : advanced for Quad extern;
controller down : safe for Quad = land to )" +
           height + R"( speed 0.6 m/s;
controller back : safe for Quad = retreat within air speed 1 m/s;
controller stay : safe for Quad = brake_and_hold;
monitor linked for d : Quad { "R1" always link; recover down; }
monitor glass for d : Quad { "R2" always distance(d, green) >= 3 m; recover )" +
           recovers + R"(; }
monitor fence for d : Quad { "R3" always d inside farm; recover )" +
           recovers + R"(; }
decision fly for Quad { advanced survey; period 50 ms; priority linked > glass > fence; }
)";
  };
  const std::string low = reports(*compiled(page("1 m", "back")));
  const std::string before = "`land to ";
  const std::size_t at = low.find(before);
  ASSERT_NE(at, std::string::npos) << low;
  const double works = std::stod(low.substr(at + before.size()));
  const auto breaks = [&](double metres) {
    return has(*compiled(page(std::to_string(metres) + " m", "back")), diag::Code::recovery_breaks);
  };
  EXPECT_FALSE(breaks(works)) << low;
  EXPECT_TRUE(breaks(0.95 * works)) << low;
  EXPECT_EQ(low.find("`priority glass"), std::string::npos) << low;
  // who only stands leads nowhere from where it came down
  const std::string standing =
      edited(edited(page("1 m", "stay"), "3 m; recover stay;",
                    "3 m; recover stay; hold when violated \"a pilot\";"),
             "farm; recover stay;", "farm; recover stay; hold when violated \"a pilot\";");
  EXPECT_NE(reports(*compiled(standing)).find("`priority glass > fence > linked;` works"),
            std::string::npos)
      << reports(*compiled(standing));
}

// Where neither of two errors alone is too much, both are told, each by the same share.
TEST(Offers, ErrorsThatAreTooMuchTogetherAreToldTogether) {
  const auto cart = [](double place_m, double speed_mps) {
    return R"(spec bags;
zone apron = rectangle (0 m, 0 m) to (20 m, 20 m);
site dock = (5 m, 10 m);
robot Cart {
  body     radius 60 cm;
  motion   point { speed <= 2.5 m/s; accel <= 1.2 m/s^2; brake >= 1.5 m/s^2; }
  sense    position : point  error )" +
           std::to_string(place_m) + R"( m max_age 80 ms;
  sense    velocity : vector error )" +
           std::to_string(speed_mps) + R"( m/s max_age 80 ms;
  sense    battery  : ratio  error 1 % max_age 5 s;
  output   push : acceleration;
  latency  50 ms;
  energy   { drive <= 0.1 %/m; idle <= 0.005 %/s; drain <= 0.3 %/s; charge >= 0.5 %/s at dock; held <= 300 s; detour <= 20 m; }
}
fleet b : Cart;
controller bags   : advanced for Cart extern;
controller charge : safe for Cart = route to dock within apron speed 0.5 m/s;
monitor power for c : Cart { "R1" always c.battery >= energy_to(dock) + 5 %; ahead 100 ms; recover charge; return when c.battery >= 80 %; }
decision guard for Cart { advanced bags; period 100 ms; priority power; }
)";
  };
  const auto c = compiled(cart(0.05, 0.04));
  const auto of = [&](const std::string& what, const std::string& unit) {
    return std::stod(
        number_in_help(*c, Code::site_not_returnable, "of the " + what + " of at most ", unit));
  };
  const double place = of("position", "m"), speed = of("velocity", "m/s");
  EXPECT_TRUE(without_offers(cart(place, speed))->module) << place << " " << speed;
  EXPECT_FALSE(without_offers(cart(1.05 * place, 1.05 * speed))->module) << reports(*c);
}

}  // namespace
}  // namespace rtac::analysis::test
