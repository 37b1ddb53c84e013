// What recoveries ask of a zone takes as long for 10,000 edges as for 100: a hundred times as much
// when every edge is looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

#include "quay_100/quay.h"
#include "quay_10000/quay.h"
#include "tests/runtime/zones/places.h"

namespace rtac {
namespace {

// The best of several runs, in seconds a question: places and short legs about the boundary.
double seconds(const ZoneView& zone, int questions) {
  test::Places places(zone, 7);
  std::vector<Vec2> asked;
  for (int i = 0; i < questions; ++i) asked.push_back(places.near(2));
  double best = std::numeric_limits<double>::infinity(), sum = 0;
  for (int run = 0; run < 7; ++run) {
    const auto from = std::chrono::steady_clock::now();
    for (const Vec2 p : asked) {
      const Vec2 at = nearest_boundary(zone, p);
      sum += signed_clearance(zone, p) + at.x;
      if (signed_clearance(zone, p) > 0) sum += distance_to_leave(zone, p, p + Vec2{1, 1});
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
    best = std::min(best, took.count() / questions);
  }
  EXPECT_NE(sum, 0);
  return best;
}

TEST(QuayCost, DoesNotGrowWithTheEdges) {
  const ZoneView &few = quay_100::quay_zone(), &many = quay_10000::quay_zone();
  ASSERT_GT(many.edge_count, 90 * few.edge_count);
  const double of_few = seconds(few, 500), of_many = seconds(many, 500);
  RecordProperty("ratio_10000_to_100", std::to_string(of_many / of_few));
  EXPECT_LT(of_many, 4 * of_few);  // most is the memory that more places touch
  EXPECT_GT(seconds(test::without_tree(many), 20), 20 * of_many);
}

}  // namespace
}  // namespace rtac
