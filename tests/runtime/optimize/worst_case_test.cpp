#include "rtac/optimize/worst_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/runtime/optimize/reach.h"

namespace rtac {
namespace {

using test::problem;

// Replayed from its controls alone, a result is admissible and does what it claims.
void expect_admissible(const ReachProblem& q, const WorstCase& w) {
  ASSERT_EQ(w.status, SearchStatus::converged);
  ASSERT_EQ(w.controls_mps2.size(), std::size_t(q.intervals));
  ASSERT_EQ(w.positions_m.size(), w.controls_mps2.size() + 1);
  ASSERT_EQ(w.velocities_mps.size(), w.controls_mps2.size() + 1);
  const test::Replay r = test::replay(q, w);
  EXPECT_LE(norm(w.positions_m[0] - q.position), q.position_error_m * (1 + 1e-9));
  EXPECT_LE(norm(w.velocities_mps[0] - q.velocity), q.velocity_error_mps * (1 + 1e-9));
  EXPECT_LE(r.accel_max_mps2, q.accel_mps2 * (1 + 1e-9));
  EXPECT_LE(r.speed_max_mps, q.speed_mps * (1 + 1e-9));
  EXPECT_NEAR(r.excursion_m, w.excursion_m, 1e-4);
  EXPECT_NEAR(norm(r.end - w.stop_m), 0, 1e-4);
}

// Without noise and cap the worst control pushes straight at the wall: exactly Mitsch's distance.
TEST(WorstCaseTest, MeetsTheBoundOfMitsch) {
  for (const double speed : {0.0, 0.2, 1.5}) {
    const ReachProblem q = problem({speed, 0}, {1, 0});
    const WorstCase w = worst_case(q);
    expect_admissible(q, w);
    const double bound = test::mitsch_bound_m(speed, q.accel_mps2, q.brake_mps2, q.horizon_s);
    EXPECT_NEAR(bound, test::disc_bound_m(q), 1e-12);
    EXPECT_LE(w.excursion_m, bound + 1e-6);
    EXPECT_GE(w.excursion_m, 0.95 * bound);
  }
}

// With the cap active the disc bound is met up to the interval in which the cap is reached.
TEST(WorstCaseTest, MeetsTheDiscBoundWithACappedSpeed) {
  for (const double cap : {1.2, 1.5, 2.0}) {
    ReachProblem q = problem({0.72, 0.96}, {0.6, 0.8});
    q.speed_mps = cap;
    const WorstCase w = worst_case(q);
    expect_admissible(q, w);
    EXPECT_LE(w.excursion_m, test::disc_bound_m(q) + 1e-6) << cap;
    EXPECT_GE(w.excursion_m, 0.95 * test::disc_bound_m(q)) << cap;
  }
}

// With noise and saturation, whatever the direction of motion: never beyond either sound bound, and
// close enough to the smaller one that the search is worth something.
TEST(WorstCaseTest, StaysWithinBothBoundsUnderNoise) {
  for (int i = 0; i < 8; ++i) {
    const double angle = i * 0.7853981633974483;
    for (const double speed : {0.05, 0.8, 1.5}) {
      ReachProblem q = problem({speed * std::cos(angle), speed * std::sin(angle)}, {0, -1});
      q.position_error_m = 0.02;
      q.velocity_error_mps = 0.05;
      q.speed_mps = 1.5;
      const WorstCase w = worst_case(q);
      expect_admissible(q, w);
      EXPECT_LE(w.excursion_m, test::disc_bound_m(q) + 1e-6);
      EXPECT_LE(w.excursion_m, test::capsule_bound_m(q) + 1e-6);
      if (q.velocity.y < -0.99 * speed) {
        EXPECT_GE(w.excursion_m, 0.6 * std::min(test::disc_bound_m(q), test::capsule_bound_m(q)));
      }
    }
  }
}

// The true start is a decision variable: the adversary uses the whole measurement error.
TEST(WorstCaseTest, UsesTheMeasurementError) {
  ReachProblem q = problem({0.5, 0}, {1, 0});
  const double exact = worst_case(q).excursion_m;
  q.position_error_m = 0.1;
  EXPECT_NEAR(worst_case(q).excursion_m, exact + 0.1, 1e-5);
  q.velocity_error_mps = 0.2;
  const WorstCase w = worst_case(q);
  expect_admissible(q, w);
  EXPECT_NEAR(w.excursion_m, test::disc_bound_m(q), 1e-5);
}

// A robot that drives away fast was nearest to the wall at the beginning: braking later hides that.
TEST(WorstCaseTest, FindsTheWorstMomentToBrake) {
  const ReachProblem q = problem({-1.5, 0}, {1, 0});
  const WorstCase w = worst_case(q);
  expect_admissible(q, w);
  EXPECT_EQ(w.brake_at, 0U);
  EXPECT_NEAR(w.excursion_m, 0, 1e-9);
}

// From rest |v| has a kink: the search must still leave it in the right direction.
TEST(WorstCaseTest, LeavesRest) {
  for (const Vec2 normal : {Vec2{1, 0}, Vec2{-0.6, 0.8}, Vec2{0, -1}}) {
    const ReachProblem q = problem({0, 0}, normal);
    EXPECT_NEAR(worst_case(q).excursion_m, test::disc_bound_m(q), 1e-5);
  }
}

// The trap of theory, horizon: a look-ahead over the period alone forgets the age of the sample,
// and the adversary must find the breach of 0.18 m and more.
TEST(WorstCaseTest, RefutesALookAheadWithoutTheSampleAge) {
  ReachProblem q = problem({1.5, 0}, {1, 0});
  q.accel_mps2 = q.brake_mps2 = 1;
  q.horizon_s = 0.2;
  const double believed_m = test::disc_bound_m(q);
  q.horizon_s = 0.2 + 0.2;  // what acts in truth
  q.offset_m = q.position.x + believed_m;
  const WorstCase w = worst_case(q);
  EXPECT_TRUE(w.violates());
  EXPECT_GT(w.excursion_m, 0.18);
}

// Without Ipopt: never beyond what is possible, and close to it straight ahead.
TEST(WorstCaseTest, RestartsFindAdmissibleMotionsToo) {
  for (const double angle : {0.0, 1.0, 3.0}) {
    ReachProblem q = problem({0.8 * std::cos(angle), 0.8 * std::sin(angle)}, {1, 0});
    q.position_error_m = 0.02;
    q.velocity_error_mps = 0.05;
    q.speed_mps = 1.2;
    WorstCase w = worst_case_by_restarts(q, 60);
    EXPECT_EQ(w.status, SearchStatus::stopped_early);
    w.status = SearchStatus::converged;
    expect_admissible(q, w);
    EXPECT_LE(w.excursion_m, test::disc_bound_m(q) + 1e-6);
    EXPECT_GE(w.excursion_m, 0.95 * worst_case(q).excursion_m);
  }
  ReachProblem bad = problem({1, 0}, {1, 0});
  bad.brake_mps2 = 0;
  EXPECT_EQ(worst_case_by_restarts(bad, 60).status, SearchStatus::invalid_problem);
}

// The same seed gives the same bits.
TEST(WorstCaseTest, IsReproducible) {
  ReachProblem q = problem({0.3, 0.4}, {1, 0});
  q.position_error_m = 0.02;
  q.velocity_error_mps = 0.05;
  q.speed_mps = 1;
  q.starts = 6;
  const WorstCase a = worst_case(q), b = worst_case(q);
  EXPECT_EQ(a.excursion_m, b.excursion_m);
  for (std::size_t k = 0; k < a.controls_mps2.size(); ++k) {
    EXPECT_EQ(a.controls_mps2[k].x, b.controls_mps2[k].x);
    EXPECT_EQ(a.controls_mps2[k].y, b.controls_mps2[k].y);
  }
}

// Measured slightly above the cap: legal with noise, as long as some true velocity fits.
TEST(WorstCaseTest, MeasuredSpeedMayExceedTheCapByItsError) {
  ReachProblem q = problem({1.04, 0}, {1, 0});
  q.speed_mps = 1;
  q.velocity_error_mps = 0.05;
  const WorstCase w = worst_case(q);
  expect_admissible(q, w);
  EXPECT_GE(w.excursion_m, 0.95 * test::disc_bound_m(q));
  q.velocity.x = 1.06;
  EXPECT_EQ(worst_case(q).status, SearchStatus::invalid_problem);
}

// A problem that means nothing is refused, not searched.
TEST(WorstCaseTest, RefusesInvalidProblems) {
  const ReachProblem good = problem({1, 0}, {1, 0});
  std::vector<ReachProblem> bad(7, good);
  bad[0].brake_mps2 = 0;
  bad[1].horizon_s = -1;
  bad[2].normal = {1, 1};
  bad[3].position.x = std::numeric_limits<double>::quiet_NaN();
  bad[4].intervals = 0;
  bad[5].position_error_m = -0.1;
  bad[6].accel_mps2 = std::numeric_limits<double>::infinity();
  for (const ReachProblem& q : bad) {
    const WorstCase w = worst_case(q);
    EXPECT_EQ(w.status, SearchStatus::invalid_problem);
    EXPECT_FALSE(w.violates());
    EXPECT_TRUE(w.controls_mps2.empty());
  }
}

// Ipopt's banner and tables have no place on the console of an application.
TEST(WorstCaseTest, IsSilent) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  EXPECT_EQ(worst_case(problem({1, 0}, {1, 0})).status, SearchStatus::converged);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace rtac
