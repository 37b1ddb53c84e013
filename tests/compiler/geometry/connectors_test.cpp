// From a place or a part of it, what is said to see an end does, and what is said not to does not.
#include "compiler/geometry/connectors.h"

#include <gtest/gtest.h>

#include "rooms.h"

namespace rtac::geometry {
namespace {

using Sight = Connectors::Sight;
constexpr std::int32_t body_mm = 150, clearance_mm = 620;
constexpr double reach_mm = 4000;

// Whether a leg to there is sound from some part of the spot, cut into four so often.
bool some_part_sees(const Connectors& legs, const Connectors::Spot& spot, const Landing& end,
                    int times) {
  if (legs.is_sound(spot, end)) return true;
  if (times == 0) return false;
  for (const Connectors::Spot& part : legs.quarters(spot)) {
    if (some_part_sees(legs, part, end, times - 1)) return true;
  }
  return false;
}

TEST(Connectors, AnEndOutOfSightIsOutOfSightOfEveryPart) {
  std::mt19937 random(3);
  int in_sight = 0, out_of_sight = 0;
  for (int room = 0; room < rooms_count(); ++room) {
    const BakedZone zone = bake(*snap_inside(random_room(random)), 100);
    Connectors legs(zone.edges, clearance_mm, body_mm, 1);
    const double size = zone.cells.cell_mm;
    for (int i = 0; i < 200; ++i) {
      const double west =
          zone.cells.origin.x_mm + size * double(random() % unsigned(zone.cells.columns));
      const double south =
          zone.cells.origin.y_mm + size * double(random() % unsigned(zone.cells.rows));
      const auto off = [&] { return double(random() % 5000) - 2500; };
      const Landing end{west + off(), south + off(), 0};
      const Connectors::Spot spot = legs.look_around(west, south, size, reach_mm);
      // whichever edge is asked first
      std::uint32_t by =
          random() % 2 == 0 ? Connectors::nobody : std::uint32_t(random() % zone.edges.size());
      const Sight seen = legs.sight(spot, end, by);
      EXPECT_EQ(seen == Sight::from_all, legs.is_sound(spot, end));
      in_sight += seen == Sight::from_all ? 1 : 0;
      if (seen != Sight::from_none) continue;
      ++out_of_sight;
      EXPECT_FALSE(some_part_sees(legs, spot, end, 3));
      EXPECT_EQ(legs.sight(spot, end, by), Sight::from_none);  // the same one says so again
    }
  }
  EXPECT_GT(in_sight, 100);
  EXPECT_GT(out_of_sight, 100);
}

}  // namespace
}  // namespace rtac::geometry
