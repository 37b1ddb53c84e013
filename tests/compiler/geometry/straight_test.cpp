// From wherever a leg is shown to lead straight to the end of a way a retreat finds one, and no
// longer one.
#include "compiler/geometry/straight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rooms.h"
#include "rtac/safe/grid_route.h"
#include "testing.h"
#include "zone_view.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t body_mm = 150, goal_mm = 620;

class Clear : public safe::PlaceTest {
 public:
  bool accepts(Vec2 /*place*/, double clearance_m) const override {
    return clearance_m >= 1e-3 * goal_mm;
  }
};

class Yard {
 public:
  explicit Yard(const Region& region)
      : zone_(bake(*snap_inside(region), 100)),
        legs_(zone_.edges, zone_.cells, body_mm, goal_mm),
        view_(zone_),
        route_(*view_) {}

  // Cells with places of a body of which no leg is known.
  int unknown() {
    int count = 0;
    for (std::size_t at = 0; at < zone_.cells.clearance_mm_lo.size(); ++at) {
      if (zone_.cells.clearance_mm_lo[at] >= 0 && !legs_.longest_from(at)) ++count;
    }
    return count;
  }
  // Of random places of bodies: those from which a leg is promised that the recovery does not find,
  // or only a longer one.
  int broken(int places) {
    const CellGrid& cells = zone_.cells;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0, 1);
    int broken = 0;
    for (int i = 0; i < places; ++i) {
      const double column = part(random) * cells.columns, row = part(random) * cells.rows;
      const Vec2 p{1e-3 * (cells.origin.x_mm + column * cells.cell_mm),
                   1e-3 * (cells.origin.y_mm + row * cells.cell_mm)};
      const double here_m = signed_clearance(*view_, p);
      if (here_m < 1e-3 * body_mm || here_m >= 1e-3 * goal_mm) continue;
      const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns) +
                      static_cast<std::size_t>(column);
      Path way;
      safe::RouteQuery query;
      query.start = p;
      const bool found = route_.straight_to_place(query, Clear(), here_m - 2e-3, way);
      const double leg_mm = found ? 1e3 * norm(way.points[0] - p) : 0;
      if (found && leg_mm > legs_.farthest_from(at)) ++broken;
      const auto promised = legs_.longest_from(at);
      if (promised && (!found || leg_mm > *promised)) ++broken;
    }
    return broken;
  }

 private:
  BakedZone zone_;
  StraightLegs legs_;
  View view_;
  safe::GridRoute route_;
};

Region polygon(const std::vector<std::pair<int, int>>& corners_mm) {
  Ring ring;
  for (const auto& [x, y] : corners_mm) ring.push_back({Rational(x, 1000), Rational(y, 1000)});
  return Region::of_rings({ring});
}

TEST(Straight, OutOfTheCornersOfAConvexYard) {
  for (const auto& corners :
       {std::vector<std::pair<int, int>>{{0, 0}, {10000, 2000}, {12000, 12000}, {2000, 10000}},
        {{0, 0}, {6300, 2100}, {11200, 6600}, {4900, 4500}},
        {{0, 0}, {9000, 3000}, {3000, 9000}}}) {
    Yard yard(polygon(corners));
    EXPECT_EQ(yard.unknown(), 0);
    EXPECT_EQ(yard.broken(3000), 0);
  }
}

// Round a corner nothing is in sight, and at the end of a long passage what is farther than the
// cells that are tried.
TEST(Straight, NotRoundACornerNorOutOfALongPassage) {
  Yard hall(
      box(0, 0, 8000, 900).unite(box(7000, 0, 8000, 6000)).unite(box(4000, 5000, 8000, 8000)));
  EXPECT_GT(hall.unknown(), 0);
  EXPECT_EQ(hall.broken(3000), 0);
  Yard passage(box(0, 0, 90000, 700).unite(box(90000, -3000, 96000, 3000)));
  EXPECT_GT(passage.unknown(), 0);
}

TEST(Straight, OfRandomRoomsTheRecoveryFindsWhatIsPromised) {
  std::mt19937 random(11);
  for (int i = 0; i < rooms_count(); ++i) EXPECT_EQ(Yard(random_room(random)).broken(800), 0) << i;
}

}  // namespace
}  // namespace rtac::geometry
