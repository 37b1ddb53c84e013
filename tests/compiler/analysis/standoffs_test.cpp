// Recoveries head for places where every fence of the decision can hand back, and robots pass each
// other with the standoff: however the author writes the comparison that asks for it.
#include "compiler/analysis/limits.h"
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

std::string probe() {
  return spec_text("tests/kernel/probe.rta");
}
const ir::Decision& guard(const driver::Compilation& c) {
  return c.module->decisions.at(0);
}

TEST(Standoffs, OfAFenceCountInEveryWayOfWritingIt) {
  const std::string atom = "clearance(r, floor) >= 5 cm;";
  const auto plain = compiled(edited(probe(), atom, "clearance(r, floor) >= 30 cm;"));
  ASSERT_TRUE(plain->module) << reports(*plain);
  const ir::Recovery& wanted = guard(*plain).monitors[1].recovery;
  for (const char* same :
       {"30 cm <= clearance(r, floor);", "2 * clearance(r, floor) >= 60 cm;",
        "clearance(r, floor) - 10 cm >= 20 cm;", "0 m >= 30 cm - clearance(r, floor);",
        "clearance(r, floor) / 2 >= 15 cm;"}) {
    const auto c = compiled(edited(probe(), atom, same));
    ASSERT_TRUE(c->module) << same << "\n" << reports(*c);
    const ir::Recovery& found = guard(*c).monitors[1].recovery;
    EXPECT_EQ(found.return_clearance_mm, wanted.return_clearance_mm) << same;
    EXPECT_EQ(found.route_clearance_mm, wanted.route_clearance_mm) << same;
  }
}

// Each recovery keeps what its own zone needs: a metre from the pit is none from the walls.
std::string pit_spec(const std::string& ring) {
  const std::string more =
      "\nzone pit  = rectangle (2 m, 2 m) to (3 m, 3 m);\nzone ring = " + ring +
      ";\ncontroller off : safe for Drone = retreat within ring speed 0.3 m/s;\nmonitor apart for "
      "d "
      ": Drone { \"SR-2: off\" always distance(d, pit) >= 50 cm; recover off; }\ndecision fly";
  const std::string drone = edited(drone_spec(), "clearance(d, room) >= 10 cm", "d inside room");
  return edited(edited(edited(drone, "ahead   100 ms, 2 waypoints;", ""), "\ndecision fly", more),
                "priority walls;",
                "priority walls > apart; acknowledge back_off may break apart \"why\";");
}
TEST(Standoffs, AreThoseOfTheZoneThatARecoveryMovesIn) {
  // which has the same boundary as what is asked for
  const std::string own = edited(pit_spec("room - pit"), "distance(d, pit)", "clearance(d, ring)");
  const auto c = compiled(own);
  ASSERT_TRUE(c->module) << reports(*c);
  EXPECT_EQ(standoff_mm(guard(*c), guard(*c).monitors[0].recovery), 0);
  EXPECT_EQ(standoff_mm(guard(*c), guard(*c).monitors[1].recovery), 500);
  EXPECT_EQ(guard(*c).monitors[1].recovery.return_clearance_mm,
            guard(*c).monitors[0].recovery.return_clearance_mm + 500);
  // a zone that lies so far from the pit itself
  for (const char* const far : {"50 cm", "51 cm"}) {
    const auto grown = compiled(pit_spec("room - grow(pit, " + std::string(far) + ")"));
    ASSERT_TRUE(grown->module) << far << reports(*grown);
    EXPECT_EQ(standoff_mm(guard(*grown), guard(*grown).monitors[1].recovery), 0) << far;
  }
}

// Who sets out beside a wall may be led past the pit as near: a zone that lies in what is allowed
// does not make its ways keep what is asked beyond touching.
TEST(Standoffs, OfAnotherBoundaryAreNotKept) {
  for (const char* const ring : {"room - pit", "room - grow(pit, 40 cm)"}) {
    const auto c = compiled(pit_spec(ring));
    EXPECT_FALSE(c->module);
    EXPECT_NE(reports(*c).find("5016 `off` moves within `ring`, and `apart` needs it to keep 0.5 m "
                               "from the boundary of `complement(pit)` [may come nearer to it] (a "
                               "zone all of whose places are that far off works, such as `ring - "
                               "grow(pit, 0.5 m)`)"),
              std::string::npos)
        << reports(*c);
  }
  // unless its own monitor has it that far from every boundary of the zone
  const auto far =
      compiled(edited(pit_spec("room - pit"), "always distance(d, pit) >= 50 cm",
                      "always distance(d, pit) >= 50 cm and clearance(d, ring) >= 50 cm"));
  EXPECT_TRUE(far->module) << reports(*far);
  const auto near =
      compiled(edited(pit_spec("room - pit"), "always distance(d, pit) >= 50 cm",
                      "always distance(d, pit) >= 50 cm and clearance(d, ring) >= 49 cm"));
  EXPECT_FALSE(near->module);
}

// Beside a wall a leg may run along it, and lose nothing but what steering leaves beside it: who
// turns sluggishly, or by a heading that is old, swung into it from where it had come to rest.
TEST(Standoffs, OfWhereItRestsLeaveRoomToSteerAlongAWall) {
  const std::string cart = R"(spec cart;
zone hall = rectangle (0 m, 0 m) to (12 m, 12 m);
robot Cart {
  body     radius 15 cm;
  motion   unicycle { speed <= 0.8 m/s; turn <= 2 rad/s; accel <= 1 m/s^2; brake >= 1 m/s^2; turn_accel <= 8 rad/s^2; }
  sense    position : point   error 2 cm    max_age 60 ms;
  sense    heading  : angle   error 1 deg   max_age 60 ms;
  sense    velocity : vector  error 2 cm/s  max_age 40 ms;
  output   drive : twist;
  latency  30 ms;
}
fleet cart : Cart;
controller work : advanced for Cart extern;
controller back : safe for Cart = retreat within hall speed 0.2 m/s;
monitor walls for r : Cart { "S-1: in" always r inside hall; recover back; }
decision move for Cart { advanced work; period 50 ms; priority walls; }
)";
  const auto plain = compiled(cart);
  ASSERT_TRUE(plain->module) << reports(*plain);
  EXPECT_EQ(guard(*plain).motions[1].beside_mm, 50);
  EXPECT_EQ(guard(*plain).body.hold_mm, 10);
  for (const auto& [written, worse] : {std::pair{"turn_accel <= 8", "turn_accel <= 0.5"},
                                       std::pair{"1 deg   max_age 60 ms", "1 deg max_age 2 s"}}) {
    const auto c = compiled(edited(cart, written, worse));
    ASSERT_TRUE(c->module) << worse << "\n" << reports(*c);
    const std::int64_t beside_mm = guard(*c).motions[1].beside_mm;
    EXPECT_GT(beside_mm, 70) << worse;
    EXPECT_EQ(guard(*c).body.hold_mm, beside_mm - 40) << worse;
  }
}

TEST(Standoffs, OfASeparationCountInEveryWayOfWritingIt) {
  const std::string atom = "distance(r, q) >= 20 cm;";
  const auto plain = compiled(probe());
  ASSERT_TRUE(plain->module) << reports(*plain);
  for (const char* same : {"20 cm <= distance(r, q);", "distance(r, q) - 20 cm >= 0 m;"}) {
    const auto c = compiled(edited(probe(), atom, same));
    ASSERT_TRUE(c->module) << same << "\n" << reports(*c);
    EXPECT_EQ(guard(*c).monitors[0].recovery.pass_gap_mm,
              guard(*plain).monitors[0].recovery.pass_gap_mm)
        << same;
  }
}

// A slower recovery takes more energy for the same way: the price must cover whoever drives it,
// whatever the order of the monitors.
TEST(Prices, OfAWayCoverTheDearestRecoveryThatDrivesIt) {
  const std::string fast = "= route to dock within floor speed 0.3 m/s;";
  const std::string slow = "= route to dock within floor speed 0.1 m/s;";
  const auto all_slow = compiled(edited(probe(), fast, slow));
  ASSERT_TRUE(all_slow->module) << reports(*all_slow);
  const auto both = compiled(edited(probe(), "= retreat within floor speed 0.2 m/s;", slow));
  ASSERT_TRUE(both->module) << reports(*both);
  const auto& prices = both->module->sites.at(0).places.at(0).cost_ppm;
  const auto& least = all_slow->module->sites.at(0).places.at(0).cost_ppm;
  ASSERT_EQ(prices.size(), least.size());
  for (std::size_t i = 0; i < prices.size(); ++i) ASSERT_GE(prices[i], least[i]) << "cell " << i;
}

// Nobody drives it, and a property asks for it: as much as when somebody does, or no way at all
// where it is too slow for anybody to come along.
TEST(Prices, OfAWayThatNobodyDrivesAreKnownAsWell) {
  const auto page = [](const std::string& recovery, const std::string& mmps) {
    return R"(spec plug;
zone hall = rectangle (0 m, 0 m) to (20 m, 10 m);
robot Bot {
  body    radius 30 cm;
  motion  point { speed <= 1 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }
  sense   position : point  error 2 cm   max_age 80 ms;
  sense   velocity : vector error 2 cm/s max_age 80 ms;
  sense   battery  : ratio  error 1 %    max_age 2 s;
  output  push : acceleration;
  latency 30 ms;
  energy  { drive <= 0.5 %/m; idle <= 0.02 %/s; drain <= 0.3 %/s; charge >= 1 %/s at plug; held <= 60 s; detour <= 5 m; }
}
fleet b : Bot;
site plug = (3 m, 5 m);
controller go   : advanced for Bot extern;
controller home : safe for Bot = route to plug within hall speed )" +
           mmps + R"( mm/s;
controller stop : safe for Bot = brake_and_hold;
monitor charge for r : Bot { "R1" always r.battery >= energy_to(plug) + 5 %; recover )" +
           recovery + R"(; }
decision drive for Bot { advanced go; period 100 ms; priority charge; acknowledge )" +
           recovery + " may break charge \"staff\"; }\n";
  };
  const auto prices = [&](const std::string& recovery, const std::string& mmps) {
    const auto c = without_offers(page(recovery, mmps));
    EXPECT_TRUE(c->module) << reports(*c);
    return c->module ? c->module->sites.at(0).places.at(0).cost_ppm : std::vector<std::int32_t>{};
  };
  const auto driven = prices("home", "400");
  ASSERT_FALSE(driven.empty());
  EXPECT_EQ(prices("stop", "400"), driven);
  const auto slow = prices("stop", "20");
  EXPECT_EQ(slow.size(), driven.size());
  EXPECT_EQ(std::ranges::count(slow, ir::no_way), std::ssize(slow));
}

}  // namespace
}  // namespace rtac::analysis::test
