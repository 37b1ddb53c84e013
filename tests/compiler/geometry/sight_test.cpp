// Where the nearest places with room are in sight, a retreat in space finds a leg to one.
#include "compiler/geometry/sight.h"

#include <gtest/gtest.h>

#include "rooms.h"
#include "rtac/safe/space.h"
#include "testing.h"
#include "zone_view.h"

namespace rtac::geometry {
namespace {

constexpr SightQuery flyer{.aim_mm = 687, .clearance_mm = 420, .body_mm = 130};

class Looking : public safe::RetreatInSpace {
 public:
  using Legs = Carried::Legs;
  using RetreatInSpace::look;
  using RetreatInSpace::RetreatInSpace;
};

// In a zone of the plane the robot keeps its height.
safe::Setting setting_of(const ZoneView& zone, const SightQuery& query) {
  safe::Setting s;
  s.limits.speed_mps = 1, s.limits.accel_mps2 = 1.5, s.limits.brake_mps2 = 1;
  s.limits.radius_m = 0.15, s.limits.latency_us = 30'000;
  s.period_us = 50'000, s.speed_mps = 0.3, s.zone = &zone;
  s.route_clearance_m = 1e-3 * query.clearance_mm, s.return_clearance_m = 1e-3 * query.aim_mm;
  return s;
}

Sight sight_in(const Region& region, std::int32_t cell_mm = 100) {
  const BakedZone zone = bake(*snap_inside(region), cell_mm);
  return sight(zone.edges, zone.cells, flyer);
}

// From wherever there is little room a look finds a leg.
void expect_legs(const BakedZone& zone, int count) {
  const View view(zone);
  Looking retreat(setting_of(*view, flyer));
  std::mt19937 random(5);
  const CellGrid& cells = zone.cells;
  std::uniform_real_distribution<double> x(0, cells.columns * cells.cell_mm);
  std::uniform_real_distribution<double> y(0, cells.rows * cells.cell_mm);
  for (int looked = 0; looked < count;) {
    const Vec2 p{1e-3 * (cells.origin.x_mm + x(random)), 1e-3 * (cells.origin.y_mm + y(random))};
    const double now_m = signed_clearance(*view, p);
    if (now_m < 1e-3 * flyer.body_mm || now_m >= 1e-3 * flyer.aim_mm) continue;
    ++looked;
    Looking::Legs legs;
    retreat.look(0, {p.x, p.y, 2}, legs);
    ASSERT_FALSE(legs.empty()) << "from " << p.x << ", " << p.y;
    const Vec3 end = legs[legs.size() - 1];
    EXPECT_GE(signed_clearance(*view, {end.x, end.y}), 1e-3 * flyer.aim_mm - 1e-6);
    const double floor_m = std::min(now_m, 1e-3 * flyer.clearance_mm) - 2e-3;
    EXPECT_TRUE(keeps_clearance(*view, p, {end.x, end.y}, floor_m - 1e-9));
  }
}
void expect_all_see(const Region& region, std::int32_t cell_mm = 100) {
  const BakedZone zone = bake(*snap_inside(region), cell_mm);
  const Sight found = sight(zone.edges, zone.cells, flyer);
  ASSERT_EQ(found.how, Sight::How::clear) << found.place.x_mm << ", " << found.place.y_mm;
  expect_legs(zone, 2000);
}

TEST(Sight, AroundACornerAndAPillar) {
  const Region hall = box(0, 0, 9000, 9000).unite(box(9000, 0, 14'000, 4000));
  expect_all_see(hall);
  expect_all_see(hall.subtract(box(4000, 4000, 5000, 5000)));
}
TEST(Sight, BetweenSlantingWalls) {
  expect_all_see(polygon({mm(0, 0), mm(9000, 700), mm(8200, 7000), mm(4700, 5300), mm(500, 6700)}));
}
TEST(Sight, WithWideCells) {
  expect_all_see(box(0, 0, 24'000, 18'000).subtract(box(9730, 7370, 14'110, 9330)), 310);
}

TEST(Sight, InRandomRooms) {
  std::mt19937 random(23);
  int shown = 0;
  for (int i = 0; i < rooms_count(); ++i) {
    const BakedZone zone = bake(*snap_inside(random_room(random)), 100);
    if (sight(zone.edges, zone.cells, flyer).how != Sight::How::clear) continue;
    ++shown;
    expect_legs(zone, 200);
    if (HasFatalFailure()) FAIL() << "room " << i;
  }
  EXPECT_GT(shown, rooms_count() / 8);
}

// In a wing that is too narrow to return, and behind a wall that is thinner than the wing is wide.
TEST(Sight, NotAroundTwoCorners) {
  const Region hall = box(0, 0, 9000, 9000);
  const Sight narrow = sight_in(hall.unite(box(9000, 0, 14'000, 1000)));
  ASSERT_EQ(narrow.how, Sight::How::hidden);
  EXPECT_GT(narrow.place.x_mm, 9000);
  const Sight behind =
      sight_in(hall.unite(box(9050, 0, 10'000, 9000)).unite(box(9000, 0, 9050, 1000)));
  ASSERT_EQ(behind.how, Sight::How::hidden);
  EXPECT_GT(behind.place.x_mm, 9000);
}

}  // namespace
}  // namespace rtac::geometry
