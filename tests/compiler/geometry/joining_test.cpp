// From wherever a way is shown to begin the search of recoveries begins one, and no longer one.
#include "compiler/geometry/joining.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rooms.h"
#include "rtac/safe/grid_route.h"
#include "testing.h"
#include "zone_view.h"

namespace rtac::geometry {
namespace {

constexpr std::int32_t route_mm = 354, body_mm = 150;

class Clear : public safe::PlaceTest {
 public:
  explicit Clear(double least_m) : least_m_(least_m) {}
  bool accepts(Vec2 /*place*/, double clearance_m) const override {
    return clearance_m >= least_m_;
  }

 private:
  double least_m_;
};

class Room {
 public:
  explicit Room(const Region& region) : zone_(bake(*snap_inside(region), 100)) {}

  [[nodiscard]] Joins shown(bool as_clear_as_here) const {
    return joins(zone_.edges, zone_.cells,
                 {.route_mm = route_mm,
                  .body_mm = body_mm,
                  .as_clear_as_here = as_clear_as_here,
                  .return_mm = 900,
                  .reach_mm = 480,
                  .rest_mm = std::vector<std::int64_t>(zone_.cells.clearance_mm_lo.size(), 0)});
  }
  static bool any(const Joins& found) { return std::ranges::count(found.apart, true) > 0; }

  // Places of bodies from where the search finds no cell to begin at, though one is promised.
  int without_a_start(const Joins& found, bool as_clear_as_here, int places = 3000) const {
    const View zone(zone_);
    safe::GridRoute route(*zone);
    const CellGrid& cells = zone_.cells;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(0, cells.columns * cells.cell_mm);
    std::uniform_real_distribution<double> y(0, cells.rows * cells.cell_mm);
    int missing = 0;
    for (int i = 0; i < places; ++i) {
      const double off_x = x(random), off_y = y(random);
      const Vec2 p{1e-3 * (cells.origin.x_mm + off_x), 1e-3 * (cells.origin.y_mm + off_y)};
      const double here_m = signed_clearance(*zone, p);
      if (here_m < 1e-3 * body_mm) continue;
      const auto cell = static_cast<std::size_t>(off_y / cells.cell_mm) *
                            static_cast<std::size_t>(cells.columns) +
                        static_cast<std::size_t>(off_x / cells.cell_mm);
      if (found.apart[cell] || (as_clear_as_here && here_m >= 0.9)) continue;
      const double least_m = as_clear_as_here ? std::min(1e-3 * route_mm, here_m) : 1e-3 * route_mm;
      Path way;
      if (!route.to_place({least_m, p, {}, {}}, Clear(least_m), way)) {
        ++missing;
      } else if (norm(way.points[0] - p) > 1e-3 * double(found.longest_mm) + 0.1) {
        ++missing;
      }
    }
    return missing;
  }

 private:
  BakedZone zone_;
};

TEST(Joining, FromEverywhereInAHall) {
  const Room hall(box(0, 0, 7000, 6000).subtract(box(3000, 2500, 4000, 3500)));
  for (const bool as_clear : {true, false}) {
    const Joins found = hall.shown(as_clear);
    EXPECT_FALSE(Room::any(found));
    EXPECT_LT(found.longest_mm, 900);
    EXPECT_EQ(hall.without_a_start(found, as_clear), 0);
  }
}

// Whoever stands in the middle between two walls is farther from them than all of any cell there.
TEST(Joining, NotFromTheMiddleOfANarrowPassage) {
  const Room dead_end(box(0, 0, 20000, 700).unite(box(19900, 0, 26000, 6000)));
  EXPECT_TRUE(Room::any(dead_end.shown(true)));
  EXPECT_TRUE(Room::any(dead_end.shown(false)));
  const Room wide(box(0, 0, 20000, 1000).unite(box(19900, 0, 26000, 6000)));
  EXPECT_FALSE(Room::any(wide.shown(true)));
  EXPECT_FALSE(Room::any(wide.shown(false)));
}

// Of thousands of edges few are near a cell, and no others are looked at.
TEST(Joining, WithinAnOutlineOfThousandsOfVertices) {
  constexpr int vertices = 5000;
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * 3.14159265358979 * i / vertices;
    const double radius_mm = 9'000 + 300 * std::sin(30 * angle);
    ring.push_back({Rational(std::lround(radius_mm * std::cos(angle)), 1000),
                    Rational(std::lround(radius_mm * std::sin(angle)), 1000)});
  }
  const Room wavy(Region::of_rings({ring}));
  const Joins found = wavy.shown(true);
  EXPECT_FALSE(Room::any(found));
  EXPECT_EQ(wavy.without_a_start(found, true, 300), 0);
}

TEST(Joining, OfRandomRoomsTheSearchFindsWhatIsPromised) {
  std::mt19937 random(11);
  int all_of_it = 0;
  for (int i = 0; i < rooms_count(); ++i) {
    const Room room(random_room(random));
    for (const bool as_clear : {true, false}) {
      const Joins found = room.shown(as_clear);
      EXPECT_EQ(room.without_a_start(found, as_clear, 800), 0) << "room " << i;
      all_of_it += Room::any(found) ? 0 : 1;
    }
  }
  EXPECT_GT(all_of_it, 0);
}

}  // namespace
}  // namespace rtac::geometry
