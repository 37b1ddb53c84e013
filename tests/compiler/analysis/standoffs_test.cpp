// Recoveries head for places where every fence of the decision can hand back, and robots pass each
// other with the standoff: however the author writes the comparison that asks for it.
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

}  // namespace
}  // namespace rtac::analysis::test
