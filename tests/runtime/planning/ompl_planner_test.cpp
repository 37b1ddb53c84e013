#include "rtac/planning/ompl_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>
#include <vector>

#include "tests/runtime/planning/arena.h"

namespace rtac {
namespace {

constexpr double clearance_m = 0.30, leg_m = 0.4;

OmplOptions options_for(const ZoneView* zone, Algorithm algorithm) {
  OmplOptions options;
  options.lower = {0, 0};
  options.upper = {5, 5};
  options.zone = zone;
  options.clearance_m = clearance_m;
  options.algorithm = algorithm;
  options.seed = 7;
  options.iterations = 1500;
  options.leg_m = leg_m;
  return options;
}

PlanRequest from_to(Vec2 start, Vec2 goal) {
  PlanRequest request;
  request.start = start;
  request.goal = goal;
  return request;
}

bool same(const Path& a, const Path& b) {
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
                    [](Vec2 p, Vec2 q) { return p.x == q.x && p.y == q.y; });
}

class EveryAlgorithm : public testing::TestWithParam<Algorithm> {
 protected:
  const ZoneView zone_ = test::arena();
};
INSTANTIATE_TEST_SUITE_P(Algorithms, EveryAlgorithm,
                         testing::Values(Algorithm::rrt_star, Algorithm::bit_star,
                                         Algorithm::rrt_connect));

// A plan goes around the boxes: every millimetre of it keeps the clearance, no leg is too long,
// and it ends at the goal without repeating the start.
TEST_P(EveryAlgorithm, KeepsClearanceOnEveryLeg) {
  for (const bool shortcut : {true, false}) {
    OmplOptions options = options_for(&zone_, GetParam());
    options.shortcut = shortcut;
    OmplPlanner planner(options);
    const PlanRequest request = from_to({1, 0.5}, {4, 0.5});
    Path plan;
    ASSERT_TRUE(planner.plan(request, plan));
    EXPECT_EQ(plan.index, 0U);
    EXPECT_EQ(plan.points.back().x, request.goal.x);
    EXPECT_EQ(plan.points.back().y, request.goal.y);
    Vec2 from = request.start;
    for (const Vec2 to : plan.points) {
      EXPECT_GT(norm(to - from), 1e-6);
      EXPECT_LE(norm(to - from), leg_m + 1e-9);
      EXPECT_GE(test::sampled_clearance_m(zone_, from, to), clearance_m - 1e-9);
      from = to;
    }
  }
}

// The same sequence of requests gives the same plans bit for bit, whatever happens to OMPL's
// process-wide seeds in between (here: another planner that plans).
TEST_P(EveryAlgorithm, IsReproducible) {
  OmplOptions options = options_for(&zone_, GetParam());
  options.shortcut = false;
  const std::vector<PlanRequest> requests = {
      from_to({1, 0.5}, {4, 0.5}), from_to({4, 0.5}, {0.5, 4.5}), from_to({0.5, 2.5}, {2.5, 2})};
  std::vector<Path> first;
  OmplPlanner planner(options);
  for (const PlanRequest& request : requests) {
    first.emplace_back();
    ASSERT_TRUE(planner.plan(request, first.back()));
  }
  options.seed = 99;
  OmplPlanner disturber(options);
  options.seed = 7;
  OmplPlanner again(options);
  Path plan, other;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    ASSERT_TRUE(disturber.plan(requests[i], other));
    ASSERT_TRUE(again.plan(requests[i], plan));
    EXPECT_TRUE(same(plan, first[i])) << "request " << i;
    EXPECT_FALSE(same(plan, other)) << "the seed plays no part, request " << i;
  }
}

// Two calls with the same request draw different samples: a call counter joins the seed.
TEST_P(EveryAlgorithm, EachCallHasItsOwnSeed) {
  OmplOptions options = options_for(&zone_, GetParam());
  options.shortcut = false;
  OmplPlanner planner(options);
  Path first, second;
  ASSERT_TRUE(planner.plan(from_to({1, 0.5}, {4, 0.5}), first));
  ASSERT_TRUE(planner.plan(from_to({1, 0.5}, {4, 0.5}), second));
  EXPECT_FALSE(same(first, second));
}

// An enclosed goal ends in false after bounded effort, not in a search without end.
TEST_P(EveryAlgorithm, UnreachableGoalFailsQuickly) {
  PlanRequest request = from_to({0.5, 0.5}, {4, 4.4});
  for (const Vec2 centre : {Vec2{3.5, 4.5}, Vec2{3.6, 4.0}, Vec2{4.0, 3.8}, Vec2{4.4, 4.0},
                            Vec2{4.5, 4.5}, Vec2{4, 4.9}}) {
    ASSERT_TRUE(request.obstacles.push({centre, 0.3}));
  }
  OmplPlanner planner(options_for(&zone_, GetParam()));
  Path plan;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(planner.plan(request, plan));
  // Three orders of magnitude above what it takes, so that a loaded machine does not matter.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

class OmplPlannerTest : public testing::Test {
 protected:
  const ZoneView zone_ = test::arena();
  Path plan_;
};

// Robots that stand are kept clear by whole legs as well.
TEST_F(OmplPlannerTest, StaysOutOfObstacleDiscs) {
  OmplPlanner planner(options_for(&zone_, Algorithm::rrt_star));
  PlanRequest request = from_to({0.5, 1.5}, {4.5, 1.6});
  const Disc robot{{2.5, 1.6}, 0.25};
  ASSERT_TRUE(request.obstacles.push(robot));
  ASSERT_TRUE(planner.plan(request, plan_));
  Vec2 from = request.start;
  for (const Vec2 to : plan_.points) {
    for (int i = 0; i <= 100; ++i) {
      EXPECT_GE(norm(from + (i / 100.0) * (to - from) - robot.centre), robot.radius_m - 1e-9);
    }
    from = to;
  }
}

// A goal that is too close to a wall or a robot, outside the arena, or not a number has no plan.
TEST_F(OmplPlannerTest, RefusesInvalidGoals) {
  OmplPlanner planner(options_for(&zone_, Algorithm::rrt_star));
  for (const Vec2 goal : {Vec2{2.5, 0.5}, Vec2{4.8, 2.5}, Vec2{6, 2}, Vec2{1.8, 3.0},
                          Vec2{std::numeric_limits<double>::quiet_NaN(), 1}}) {
    EXPECT_FALSE(planner.plan(from_to({1, 1}, goal), plan_)) << goal.x << ", " << goal.y;
  }
  PlanRequest occupied = from_to({1, 1}, {4, 2});
  ASSERT_TRUE(occupied.obstacles.push({{4.1, 2}, 0.3}));
  EXPECT_FALSE(planner.plan(occupied, plan_));
}

// A start inside the forbidden band leaves it along a leg that never gets closer than the start.
TEST_F(OmplPlannerTest, EscapesFromTheForbiddenBand) {
  OmplPlanner planner(options_for(&zone_, Algorithm::rrt_star));
  const Vec2 start{1.80, 2.5};  // 0.20 m from the box at x = 1.6
  ASSERT_TRUE(planner.plan(from_to(start, {0.5, 2.5}), plan_));
  const Vec2 first = plan_.points[0];
  EXPECT_GE(test::sampled_clearance_m(zone_, start, first), 0.20 - 1e-9);
  EXPECT_GE(signed_clearance(zone_, first), clearance_m);
  EXPECT_LT(norm(first - start), 0.2);
  for (std::size_t i = 1; i < plan_.points.size(); ++i) {
    EXPECT_GE(test::sampled_clearance_m(zone_, plan_.points[i - 1], plan_.points[i]),
              clearance_m - 1e-9);
  }
}

// The way out of one band must not lead into another: between a wall and a robot there may be none.
TEST_F(OmplPlannerTest, NoEscapeThroughARobot) {
  OmplPlanner planner(options_for(&zone_, Algorithm::rrt_star));
  PlanRequest request = from_to({0.1, 0.1}, {4, 4.5});
  ASSERT_TRUE(request.obstacles.push({{0.6, 0.6}, 0.65}));
  ASSERT_TRUE(request.obstacles.push({{0.1, 0.9}, 0.75}));
  ASSERT_TRUE(request.obstacles.push({{0.9, 0.1}, 0.75}));
  EXPECT_FALSE(planner.plan(request, plan_));
}

// Without a zone the planner is ignorant of walls: the taut path is the straight line, in equal
// legs, right through a box.
TEST_F(OmplPlannerTest, WithoutZoneGoesStraight) {
  OmplPlanner planner(options_for(nullptr, Algorithm::rrt_star));
  ASSERT_TRUE(planner.plan(from_to({0.5, 0.5}, {4.5, 0.5}), plan_));
  ASSERT_EQ(plan_.points.size(), 10U);
  for (std::size_t i = 0; i < plan_.points.size(); ++i) {
    EXPECT_NEAR(plan_.points[i].x, 0.5 + 0.4 * double(i + 1), 1e-9);
    EXPECT_NEAR(plan_.points[i].y, 0.5, 1e-12);
  }
}

// A path that does not fit into the list is no plan, rather than a truncated one.
TEST_F(OmplPlannerTest, RefusesMoreThanMaxWaypoints) {
  OmplOptions options = options_for(nullptr, Algorithm::rrt_star);
  options.leg_m = 4.0 / max_waypoints;
  OmplPlanner fits(options);
  EXPECT_TRUE(fits.plan(from_to({0.5, 0.5}, {4.5, 0.5}), plan_));
  EXPECT_EQ(plan_.points.size(), max_waypoints);
  options.leg_m = 4.0 / (max_waypoints + 1);
  OmplPlanner too_fine(options);
  EXPECT_FALSE(too_fine.plan(from_to({0.5, 0.5}, {4.5, 0.5}), plan_));
  options.leg_m = 1e-300;
  OmplPlanner absurd(options);
  EXPECT_FALSE(absurd.plan(from_to({0.5, 0.5}, {4.5, 0.5}), plan_));
}

// Pulling taut gives nearly the shortest way: around one corner of the box on the south wall.
TEST_F(OmplPlannerTest, ShortcutIsNearlyShortest) {
  OmplOptions options = options_for(&zone_, Algorithm::rrt_connect);
  OmplPlanner taut(options);
  ASSERT_TRUE(taut.plan(from_to({1, 1.2}, {4, 1.2}), plan_));
  double length = norm(plan_.points[0] - Vec2{1, 1.2});
  for (std::size_t i = 1; i < plan_.points.size(); ++i) {
    length += norm(plan_.points[i] - plan_.points[i - 1]);
  }
  EXPECT_LT(length, 3.15);  // straight: 3.0; over the tops of the two rounded corners: 3.02
}

// A robot that is where it should go has a plan: the goal alone.
TEST_F(OmplPlannerTest, PlansToWhereItStands) {
  for (const bool shortcut : {true, false}) {
    OmplOptions options = options_for(&zone_, Algorithm::rrt_star);
    options.shortcut = shortcut;
    OmplPlanner planner(options);
    ASSERT_TRUE(planner.plan(from_to({1, 1}, {1, 1}), plan_));
    ASSERT_EQ(plan_.points.size(), 1U);
    EXPECT_EQ(plan_.points[0].x, 1);
  }
}

// OMPL's seeds are shared by the whole process: planning in several threads must not mix them up.
TEST_F(OmplPlannerTest, IsReproducibleInSeveralThreads) {
  OmplOptions options = options_for(&zone_, Algorithm::rrt_connect);
  options.shortcut = false;
  const auto run = [&options](std::vector<Path>& plans) {
    OmplPlanner planner(options);
    for (Path& plan : plans) EXPECT_TRUE(planner.plan(from_to({1, 0.5}, {4, 0.5}), plan));
  };
  std::vector<Path> alone(400), first(400), second(400);
  run(alone);
  std::thread one([&] { run(first); }), two([&] { run(second); });
  one.join();
  two.join();
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_TRUE(same(alone[i], first[i]) && same(alone[i], second[i])) << "plan " << i;
  }
}

// OMPL would report every search on the console of the application.
TEST_F(OmplPlannerTest, IsSilent) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  OmplPlanner planner(options_for(&zone_, Algorithm::rrt_star));
  EXPECT_TRUE(planner.plan(from_to({1, 0.5}, {4, 0.5}), plan_));
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace rtac
