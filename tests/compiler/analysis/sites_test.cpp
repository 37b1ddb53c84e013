// 5022 sites_too_near: places of a site at which two robots are nearer to each other than they may
// be; the distance that is offered works, and 5 % less does not.
#include "tests/compiler/analysis/testing.h"

namespace rtac::analysis::test {
namespace {

using diag::Code;

std::string docks(const std::string& second, const std::string& apart = "30 cm") {
  return R"(spec docks;
zone hall = rectangle (0 m, 0 m) to (20 m, 14 m);
robot Cart {
  body    radius 30 cm;
  motion  point { speed <= 0.9 m/s; accel <= 1 m/s^2; brake >= 1.2 m/s^2; }
  sense   position : point  error 2 cm   max_age 100 ms;
  sense   velocity : vector error 2 cm/s max_age 100 ms;
  sense   battery  : ratio  error 1 %    max_age 2 s;
  hears   other robots max_age 150 ms;
  output  push : acceleration;
  latency 50 ms;
  energy  { drive <= 0.3 %/m; idle <= 0.01 %/s; drain <= 0.4 %/s; charge >= 1 %/s at dock; held <= 60 s; detour <= 12 m; }
}
fleet a, b : Cart;
site dock(a) = (2 m, 2 m);
site dock(b) = ()" +
         second + R"(, 2 m);
controller job  : advanced for Cart extern;
controller give : safe for Cart = yield within hall speed 0.3 m/s order id;
controller home : safe for Cart = route to dock within hall speed 0.4 m/s;
monitor apart  for r : Cart { "R0" always forall q : Cart, q != r : distance(r, q) >= )" +
         apart + R"(; recover give; hold when violated "x"; }
monitor charge for r : Cart { "R2" always r.battery >= energy_to(dock(r)) + 5 %; recover home; return when r.battery >= 80 %; }
decision drive for Cart { advanced job; period 100 ms; priority apart > charge; acknowledge give may break charge "held"; }
)";
}
int too_near(const driver::Compilation& c) {
  int count = 0;
  for (const auto& d : c.diagnostics.all()) count += d.code == Code::sites_too_near;
  return count;
}

TEST(Sites, PlacesAreAsFarApartAsTwoRobotsMayBe) {
  const auto c = compiled(docks("2.7 m"));
  ASSERT_EQ(too_near(*c), 1) << reports(*c);
  const std::string apart = number_in_help(*c, Code::sites_too_near, "at least ", "m apart");
  EXPECT_EQ(apart, "0.9");
  const auto at = [](double apart_m) { return docks(std::to_string(2 + apart_m) + " m"); };
  EXPECT_EQ(too_near(*compiled(at(0.9))), 0);
  EXPECT_EQ(too_near(*compiled(at(0.95 * 0.9))), 1);
}
// Bodies do not lie in each other, whatever is asked.
TEST(Sites, BodiesTakeRoom) {
  EXPECT_EQ(too_near(*compiled(docks("2.5 m", "0 m"))), 1);
  EXPECT_EQ(too_near(*compiled(docks("2.6 m", "0 m"))), 0);
}
// Who shares a place takes turns there.
TEST(Sites, APlaceMayBeShared) {
  EXPECT_EQ(too_near(*compiled(docks("2 m"))), 0);
}

}  // namespace
}  // namespace rtac::analysis::test
