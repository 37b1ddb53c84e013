#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "rtac/optimize/worst_case.h"
#include "tests/runtime/optimize/reach.h"

namespace rtac {
namespace {

constexpr std::array<std::int32_t, 16> square_mm = {0,    0,    5000, 0,    5000, 0,    5000, 5000,
                                                    5000, 5000, 0,    5000, 0,    5000, 0,    0};
constexpr std::array<std::size_t, 2> rings = {0, 4};

ZoneView room(const std::int32_t* edges_mm, std::size_t edges, std::size_t ring_count = 1) {
  ZoneView zone;
  zone.edges_mm = edges_mm;
  zone.edge_count = edges;
  zone.ring_start = rings.data();
  zone.ring_count = ring_count;
  return zone;
}

// The drone of the surveillance study, fence and bounds as specified there.
ReachProblem drone(Vec2 position, Vec2 velocity) {
  ReachProblem q = test::problem(velocity, {1, 0});
  q.position = position;
  q.position_error_m = 0.02;
  q.velocity_error_mps = 0.02;
  q.accel_mps2 = q.brake_mps2 = 1;
  q.speed_mps = 1.5;
  q.horizon_s = 0.17;
  return q;
}

// Every wall is attacked, and the one ahead comes out as the worst.
TEST(WorstCaseInRoomTest, AttacksEveryWall) {
  const ZoneView zone = room(square_mm.data(), 4);
  const ReachProblem q = drone({3.5, 2.5}, {1.2, 0});
  const RoomWorstCase found = worst_case_in_room(q, zone);
  ASSERT_EQ(found.status, SearchStatus::converged);
  ASSERT_EQ(found.edges.size(), 4U);
  EXPECT_EQ(found.worst_edge, 1U);  // the wall x = 5
  EXPECT_LE(found.edges[1].excursion_m, 3.5 + test::disc_bound_m(q) - 5 + 1e-6);
  EXPECT_GE(found.edges[1].excursion_m, 3.5 + 0.95 * test::disc_bound_m(q) - 5);
  EXPECT_LT(found.edges[3].excursion_m, -3.4);  // the wall behind
}

// Where the disc test passes, no wall is reached; 5 % closer to the wall, one is: the look-ahead
// test covers the worst control and wastes little.
TEST(WorstCaseInRoomTest, LookAheadCoversTheWorstControl) {
  const ZoneView zone = room(square_mm.data(), 4);
  for (const double speed : {0.0, 0.5, 1.5}) {
    const double reach_m = test::disc_bound_m(drone({}, {speed, 0}));
    const RoomWorstCase safe = worst_case_in_room(drone({5 - reach_m, 2}, {speed, 0}), zone);
    EXPECT_LE(safe.edges[safe.worst_edge].excursion_m, 1e-6) << speed;
    const RoomWorstCase late = worst_case_in_room(drone({5 - 0.95 * reach_m, 2}, {speed, 0}), zone);
    EXPECT_TRUE(late.edges[late.worst_edge].violates()) << speed;
  }
}

// The excursion across the worst edge is the depth outside the room.
TEST(WorstCaseInRoomTest, ExcursionIsTheDistanceOutside) {
  const ZoneView zone = room(square_mm.data(), 4);
  const RoomWorstCase found = worst_case_in_room(drone({4.8, 2.5}, {1.5, 0}), zone);
  const WorstCase& worst = found.edges[found.worst_edge];
  EXPECT_NEAR(worst.excursion_m, -signed_clearance(zone, worst.stop_m), 1e-9);
}

// A slanted wall counts from its line, in metres across it.
TEST(WorstCaseInRoomTest, HandlesSlantedWalls) {
  constexpr std::array<std::int32_t, 12> triangle = {0, 0,    4000, 0,    4000, 0,
                                                     0, 3000, 0,    3000, 0,    0};
  const ZoneView zone = room(triangle.data(), 3);
  const ReachProblem q = drone({1, 1}, {0, 0});
  const RoomWorstCase found = worst_case_in_room(q, zone);
  ASSERT_EQ(found.status, SearchStatus::converged);
  // Distance of (1, 1) to 3x + 4y = 12 is 1.
  EXPECT_NEAR(found.edges[1].excursion_m, test::disc_bound_m(q) - 1, 1e-3);
}

// The line of an edge is no boundary where the room bends inward: refused, as is no room at all.
TEST(WorstCaseInRoomTest, RefusesRoomsThatAreNotConvex) {
  constexpr std::array<std::int32_t, 16> arrow = {0,    0,    4000, 0,    4000, 0,    1000, 1000,
                                                  1000, 1000, 0,    4000, 0,    4000, 0,    0};
  const ReachProblem q = drone({0.5, 0.5}, {0, 0});
  EXPECT_EQ(worst_case_in_room(q, room(arrow.data(), 4)).status, SearchStatus::not_convex);
  EXPECT_EQ(worst_case_in_room(q, room(square_mm.data(), 4, 2)).status, SearchStatus::not_convex);
  EXPECT_EQ(worst_case_in_room(q, ZoneView{}).status, SearchStatus::invalid_problem);
}

}  // namespace
}  // namespace rtac
