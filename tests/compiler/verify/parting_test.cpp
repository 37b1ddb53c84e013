// That one of two robots finds a way out of the other's, of zones in which most pairs of cells look
// alike: shown at all, and once more from the specification.
#include "compiler/recheck/parting.h"

#include <random>

#include "tests/compiler/geometry/rooms.h"
#include "tests/compiler/verify/testing.h"

namespace rtac::driver::test {
namespace {

using geometry::box;
using geometry::Region;

using Places = std::vector<double>;  // both of a meeting; none: robots part everywhere

// Of zones whose south-western corner is at (0 m, 0 m).
Places meeting(const Region& zone, const recheck::PartingLimits& limits) {
  const auto found = recheck::without_parting(zone, {100, 0, 0}, limits);
  EXPECT_FALSE(std::holds_alternative<recheck::BadCells>(found));
  const auto& places = std::get<recheck::Meeting>(found);
  if (!places) return {};
  return {places->first.x.get_d(), places->first.y.get_d(), places->second.x.get_d(),
          places->second.y.get_d()};
}
// What looks alike is looked at once, and nothing is found otherwise than pair by pair.
Places the_same_alone(const Region& zone, recheck::PartingLimits limits) {
  const Places found = meeting(zone, limits);
  limits.each_alone = true;
  EXPECT_EQ(found, meeting(zone, limits));
  return found;
}
constexpr recheck::PartingLimits cart{0.2, 0.1, 0.22, 0.7, 0.76};

TEST(PartingOnceMore, IsTheSamePairByPairAmongPillars) {
  Region hall = box(0, 0, 12'000, 5000);
  for (const long x : {2000, 5000, 8000}) hall = hall.subtract(box(x, 2000, x + 1000, 3000));
  EXPECT_EQ(the_same_alone(hall, cart), Places{});
  const Places stuck = the_same_alone(hall.unite(box(9200, 4900, 9900, 6500)), cart);
  ASSERT_FALSE(stuck.empty());
  EXPECT_GT(stuck[0], 8.5);
  EXPECT_GT(stuck[1], 4);
}
TEST(PartingOnceMore, IsTheSamePairByPairInRandomRooms) {
  std::mt19937 random(29);
  const auto upto = [&](int most) { return static_cast<int>(random() % unsigned(most)); };
  int shown = 0;
  for (int i = 0; i < geometry::rooms_count() / 2; ++i) {
    const Region room = geometry::random_room(random);
    const double body = 0.04 + 1e-3 * upto(40), apart = 0.3 + 1e-3 * upto(300);
    const recheck::PartingLimits limits{0.12 + 1e-3 * upto(100), body, 2 * body, apart,
                                        apart + 1e-3 * upto(80)};
    if (std::holds_alternative<recheck::BadCells>(
            recheck::without_parting(room, {100, 0, 0}, limits))) {
      continue;  // what is left of it begins elsewhere
    }
    if (the_same_alone(room, limits).empty()) ++shown;
    if (HasFailure()) FAIL() << "room " << i;
  }
  EXPECT_GT(shown, 0);
}

// Two rooms and a corridor, of which a row of cells in the middle is a little clearer than ways ask
// for. What robots know of it may be less, once some corner of the zone is rounded to millimetres.
TEST(PartingOnceMore, CountsOnNoMoreClearanceThanRobotsKnow) {
  constexpr recheck::PartingLimits lean{0.198, 0.2, 0.4, 0.7, 0.76};
  const Region rooms =
      box(0, 0, 3000, 3000).unite(box(6000, 0, 9000, 3000)).unite(box(3000, 1300, 6000, 1800));
  EXPECT_EQ(meeting(rooms, lean), Places{});
  const Region notched = rooms.unite(geometry::polygon({geometry::mm(9000, 2000),
                                                        {Rational(18'081, 2000), Rational(21, 10)},
                                                        geometry::mm(9000, 2200)}));
  EXPECT_FALSE(meeting(notched, lean).empty());
  // and of what is clearer nothing is left open
  recheck::PartingLimits narrow = lean;
  narrow.route = 0.19;
  EXPECT_EQ(meeting(notched, narrow), Places{});
}

class PartingInABasin : public Verify {
 protected:
  static std::string ferries(const std::string& basin) {
    return "spec ferries;\nzone basin = " + basin + R"(;
robot Ferry {
  body    radius 3 m;
  motion  point { speed <= 3 m/s; accel <= 0.5 m/s^2; brake >= 0.5 m/s^2; }
  sense   position : point  error 20 cm   max_age 200 ms;
  sense   velocity : vector error 5 cm/s max_age 200 ms;
  hears   other robots max_age 500 ms;
  output  push : acceleration;
  latency 100 ms;
}
fleet north, south : Ferry;
controller pilot : advanced for Ferry extern;
controller give  : safe for Ferry = yield within basin speed 0.8 m/s order id;
controller back  : safe for Ferry = retreat within basin speed 0.8 m/s;
monitor apart for f : Ferry { "SR-1: apart" always forall g : Ferry, g != f : distance(f, g) >= 5 m; ahead 400 ms; recover give; }
monitor shore for f : Ferry { "SR-2: off the quays" always clearance(f, basin) >= 2 m; ahead 400 ms; recover back; }
decision steer for Ferry { advanced pilot; period 200 ms; priority apart > shore; }
)";
  }
};

const std::string basin = "rectangle (0 m, 0 m) to (260 m, 190 m)";
// Between two moles.
const std::string dead_end = basin +
                             " - rectangle (230 m, 140 m) to (260 m, 141 m)"
                             " - rectangle (230 m, 165 m) to (260 m, 166 m)";

TEST_F(PartingInABasin, OfTwoFerriesOneFindsAWay) {
  const Outcome o = verified(ferries(basin), {"--format", "json", "-o", "certificates"});
  EXPECT_EQ(statuses(o.out, "P2b", "apart"), Statuses{"proved"}) << o.out << o.err;
  const Outcome again = rtac({"verify", "--recheck", "certificates"});
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
  // what is said of it is not believed of one with a dead end
  write("certificates/sources/spec.rta", ferries(dead_end));
  const Outcome forged = recheck_sealed_anew();
  EXPECT_EQ(forged.status, exit_violation);
  EXPECT_NE((forged.out + forged.err).find("may not get out of each other's way"),
            std::string::npos)
      << forged.out << forged.err;
}
// Measured up to 200 ms before it is told, every 200 ms.
TEST_F(PartingInABasin, WhoNeverHearsInTimeMayWaitForEver) {
  const auto hears = [](const std::string& ms) {
    return edited(ferries(basin), "hears   other robots max_age 500",
                  "hears   other robots max_age " + ms);
  };
  const Outcome late = verified(hears("399"), {"--format", "json"});
  EXPECT_EQ(statuses(late.out, "P2b", "apart"), Statuses{"unknown"}) << late.out << late.err;
  EXPECT_NE(late.out.find("`hears other robots max_age 400 ms`"), std::string::npos) << late.out;
  const Outcome o = verified(hears("400"), {"--format", "json", "-o", "certificates"});
  EXPECT_EQ(statuses(o.out, "P2b", "apart"), Statuses{"proved"}) << o.out << o.err;
  write("certificates/sources/spec.rta", hears("399"));
  const Outcome forged = recheck_sealed_anew();
  EXPECT_EQ(forged.status, exit_violation);
  EXPECT_NE((forged.out + forged.err).find("may never hear where the other one is in time"),
            std::string::npos)
      << forged.out << forged.err;
}
TEST_F(PartingInABasin, TheDeadEndIsNamed) {
  const Outcome o = verified(ferries(dead_end), {"--format", "json"});
  EXPECT_EQ(statuses(o.out, "P2b", "apart"), Statuses{"unknown"}) << o.out << o.err;
  EXPECT_NE(o.out.find("robots that hold near (2"), std::string::npos) << o.out;
}

// Cells across the aisle from each other lie exactly as far apart as robots have to be to be given
// back: whether that is a little less in doubles makes no difference.
TEST_F(Verify, RobotsAcrossAnAisleThatAreGivenBackNeedNotPart) {
  const std::string text = R"(spec racks;
zone hall  = rectangle (0 m, 0 m) to (30 m, 20 m);
zone racks = rectangle (5 m, 4 m) to (25 m, 6 m) | rectangle (5 m, 10 m) to (25 m, 12 m);
zone drivable = hall - racks;
robot Amr {
  body     radius 40 cm;
  motion   unicycle { speed <= 1.2 m/s; turn <= 2 rad/s; accel <= 0.8 m/s^2; brake >= 1 m/s^2; turn_accel <= 5 rad/s^2; }
  sense    position : point   error 3 cm   max_age 100 ms;
  sense    heading  : angle   error 1 deg  max_age 100 ms;
  sense    velocity : vector  error 2 cm/s max_age 100 ms;
  sense    battery  : ratio   error 1 %    max_age 2 s;
  hears    other robots       max_age 200 ms;
  output   drive : twist;
  latency  40 ms;
  energy   { drive <= 0.1 %/m; idle <= 0.005 %/s; drain <= 0.15 %/s; charge >= 0.5 %/s at dock; held <= 60 s; detour <= 10 m; }
}
fleet a, b : Amr;
site dock(a) = (2 m, 18 m);
site dock(b) = (28 m, 18 m);
controller nav  : advanced for Amr extern;
controller aside : safe for Amr = yield within drivable speed 0.3 m/s order id;
controller back : safe for Amr = retreat within drivable speed 0.4 m/s;
controller home : safe for Amr = route to dock within drivable speed 0.5 m/s;
monitor apart for r : Amr { "SR-1: AMRs keep 30 cm apart" always forall q : Amr, q != r : distance(r, q) >= 0.133 m; recover aside; }
monitor fence for r : Amr { "SR-2: off the racks" always r inside drivable; recover back; }
monitor charge for r : Amr { "SR-3: reaches its dock" always r.battery >= energy_to(dock(r)) + 10 %; recover home; return when r.battery >= 80 %; }
decision drive for Amr { advanced nav; period 50 ms; priority apart > fence > charge;
  acknowledge aside may break charge "waiting is in held"; }
)";
  const Outcome o = verified(text, {"--format", "json", "-o", "certificates"});
  ASSERT_EQ(statuses(o.out, "P2b", "apart"), Statuses{"proved"}) << o.out << o.err;
  const Outcome again = recheck_sealed_anew();
  EXPECT_EQ(again.status, exit_clean) << again.out << again.err;
}

}  // namespace
}  // namespace rtac::driver::test
