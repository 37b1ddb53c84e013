#include "rtac/planning/certified_planner.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/runtime/planning/arena.h"

namespace rtac {
namespace {

constexpr double clearance_m = 0.30;

class CertifiedPlannerTest : public testing::Test {
 protected:
  CertifiedOptions options() const {
    CertifiedOptions result;
    result.lower = {0, 0};
    result.upper = {5, 5};
    result.zone = &zone_;
    result.clearance_m = clearance_m;
    result.seed = 3;
    return result;
  }
  Vec2 draw() {
    // Not std::uniform_real_distribution: its values differ between libraries.
    const auto unit = [this] { return double(random_() >> 11) * 0x1p-53; };
    return {5 * unit(), 5 * unit()};
  }

  const ZoneView zone_ = test::arena();
  std::mt19937_64 random_{42};
  Path plan_;
};

// Completeness: any two places with enough clearance are connected in this arena, and the planner
// finds the way every time; what it returns keeps the clearance on every millimetre.
TEST_F(CertifiedPlannerTest, PlansBetweenAllFreePlaces) {
  CertifiedPlanner planner(options());
  int planned = 0;
  while (planned < 300) {
    PlanRequest request;
    request.start = draw();
    request.goal = draw();
    if (signed_clearance(zone_, request.start) < clearance_m + 1e-3) continue;
    if (signed_clearance(zone_, request.goal) < clearance_m + 1e-3) continue;
    ASSERT_TRUE(planner.plan(request, plan_)) << request.start.x << ", " << request.start.y
                                              << " -> " << request.goal.x << ", " << request.goal.y;
    Vec2 from = request.start;
    for (const Vec2 to : plan_.points) {
      ASSERT_GE(test::sampled_clearance_m(zone_, from, to), clearance_m - 1e-9);
      from = to;
    }
    ++planned;
  }
}

// Wherever a robot comes to stand inside the arena, it finds a way out of the band.
TEST_F(CertifiedPlannerTest, EscapesFromEverywhere) {
  CertifiedPlanner planner(options());
  for (int n = 0; n < 200;) {
    PlanRequest request;
    request.start = draw();
    request.goal = {4, 2};
    const double own_m = signed_clearance(zone_, request.start);
    if (own_m < 0.01) continue;
    // Between the boxes (1.6, 3) and (2, 3) two boundaries face each other: no straight way out.
    if (norm(request.start - Vec2{1.8, 3}) < 0.35) continue;
    ASSERT_TRUE(planner.plan(request, plan_)) << request.start.x << ", " << request.start.y;
    EXPECT_GE(test::sampled_clearance_m(zone_, request.start, plan_.points[0]),
              std::min(own_m, clearance_m) - 1e-6);
    ++n;
  }
}

// A passage with 2 cm to spare, between a standing robot and the east wall.
TEST_F(CertifiedPlannerTest, FindsANarrowPassage) {
  CertifiedPlanner planner(options());
  PlanRequest request;
  request.start = {4.5, 0.5};
  request.goal = {4.5, 4.5};
  // Closes x from 3.0 to 4.68; the way west of the box [2,3] x [3,4] is closed by two more.
  ASSERT_TRUE(request.obstacles.push({{3.84, 3.0}, 0.84}));
  ASSERT_TRUE(request.obstacles.push({{0.5, 2.5}, 0.6}));
  ASSERT_TRUE(request.obstacles.push({{2.3, 2.5}, 0.7}));
  ASSERT_TRUE(planner.plan(request, plan_));
  EXPECT_TRUE(certify(zone_, clearance_m, request, plan_));
  Vec2 from = request.start;
  for (const Vec2 to : plan_.points) {
    if (from.y < 3 && to.y >= 3) {
      EXPECT_NEAR(from.x + (3 - from.y) / (to.y - from.y) * (to.x - from.x), 4.69, 0.011);
    }
    from = to;
  }
}

// A goal that is walled in by robots ends in false, with and without hope at the outset.
TEST_F(CertifiedPlannerTest, RefusesWhatCannotBeReached) {
  CertifiedPlanner planner(options());
  PlanRequest request;
  request.start = {0.5, 0.5};
  request.goal = {2.5, 0.5};  // inside a box
  EXPECT_FALSE(planner.plan(request, plan_));
  request.goal = {4.2, 0.6};
  for (const Vec2 centre : {Vec2{3.4, 0.8}, Vec2{3.9, 1.4}, Vec2{4.6, 1.4}}) {
    ASSERT_TRUE(request.obstacles.push({centre, 0.42}));
  }
  EXPECT_FALSE(planner.plan(request, plan_));
}

// The check must be able to fail: each kind of bad plan is refused.
TEST_F(CertifiedPlannerTest, CertifyRefusesBadPlans) {
  PlanRequest request;
  request.start = {1, 0.5};
  request.goal = {4, 0.5};
  const auto certified = [&](std::initializer_list<Vec2> points) {
    Path plan;
    for (const Vec2 p : points) EXPECT_TRUE(plan.points.push(p));
    return certify(zone_, clearance_m, request, plan);
  };
  EXPECT_TRUE(certified({{1.0, 1.4}, {4.0, 1.4}, {4, 0.5}}));
  EXPECT_FALSE(certified({{4, 0.5}})) << "through the box";
  EXPECT_FALSE(certified({{1.0, 1.29}, {4.0, 1.29}, {4, 0.5}})) << "1 cm too close, on a leg only";
  EXPECT_FALSE(certified({{1.0, 1.4}, {4.0, 1.4}})) << "ends elsewhere";
  EXPECT_FALSE(certified({})) << "empty";
  ASSERT_TRUE(request.obstacles.push({{2.5, 1.8}, 0.5}));
  EXPECT_FALSE(certified({{1.0, 1.4}, {4.0, 1.4}, {4, 0.5}})) << "through a robot";
}

// In the band the plan may only leave it: sliding along the wall is refused, and so is approaching.
TEST_F(CertifiedPlannerTest, CertifyAllowsOnlyTheWayOut) {
  PlanRequest request;
  request.start = {4.8, 1};
  request.goal = {4, 3};
  const auto certified = [&](std::initializer_list<Vec2> points) {
    Path plan;
    for (const Vec2 p : points) EXPECT_TRUE(plan.points.push(p));
    return certify(zone_, clearance_m, request, plan);
  };
  EXPECT_TRUE(certified({{4.6, 1}, {4, 3}}));
  EXPECT_TRUE(certified({{4.75, 1}, {4.6, 1}, {4, 3}})) << "the same leg in two parts";
  EXPECT_FALSE(certified({{4.8, 2}, {4.6, 2}, {4, 3}})) << "along the wall first";
  EXPECT_FALSE(certified({{4.9, 1}, {4.6, 1}, {4, 3}})) << "closer first";
}

// Restarts and seeds do not break reproducibility.
TEST_F(CertifiedPlannerTest, IsReproducible) {
  CertifiedPlanner a(options()), b(options());
  Path other;
  for (int i = 0; i < 5; ++i) {
    PlanRequest request;
    request.start = {1, 0.5 + 0.1 * i};
    request.goal = {4, 0.5};
    ASSERT_TRUE(a.plan(request, plan_));
    ASSERT_TRUE(b.plan(request, other));
    ASSERT_EQ(plan_.points.size(), other.points.size());
    for (std::size_t k = 0; k < other.points.size(); ++k) {
      EXPECT_EQ(plan_.points[k].x, other.points[k].x);
      EXPECT_EQ(plan_.points[k].y, other.points[k].y);
    }
  }
}

}  // namespace
}  // namespace rtac
