// Pushes at full effort in random directions, each held for a random number of intervals: what is
// worst is often among them, and nothing of it can fail.
#include <random>
#include <utility>

#include "trajectory.h"

namespace rtac {
namespace {

using optimize::Candidate;

class Restart {
 public:
  Restart(const ReachProblem& problem, std::mt19937_64& random)
      : problem_(problem), random_(random) {}

  // `aimed`: straight across the line, from the true state that is nearest to it and fastest.
  Candidate draw(bool aimed) {
    const Vec2 p = aimed ? problem_.normal : direction();
    const Vec2 v = aimed ? problem_.normal : direction();
    Candidate c;
    c.start = problem_.position + problem_.position_error_m * p;
    c.velocities.push_back(problem_.velocity + problem_.velocity_error_mps * v);
    const double step_mps = problem_.accel_mps2 * problem_.horizon_s / problem_.intervals;
    Vec2 push = problem_.normal;
    for (int k = 0; k < problem_.intervals; ++k) {
      if (!aimed && uniform() < turn_share) push = direction();
      c.velocities.push_back(
          optimize::clip(c.velocities.back() + step_mps * push, {}, problem_.speed_mps));
    }
    return c;
  }

 private:
  static constexpr double turn_share = 0.15;  // of the intervals begin a new push

  double uniform() { return optimize::draw_share(random_); }
  Vec2 direction() { return optimize::draw_direction(random_); }

  const ReachProblem& problem_;
  std::mt19937_64& random_;
};

}  // namespace

WorstCase worst_case_by_restarts(const ReachProblem& problem, int restarts) {
  WorstCase worst;
  if (!optimize::valid(problem)) return worst;
  std::mt19937_64 random(problem.seed);
  for (int n = 0; n < restarts; ++n) {
    WorstCase found;
    optimize::simulate(problem, Restart(problem, random).draw(n == 0), found);
    optimize::judge(problem, found);
    if (found.excursion_m > worst.excursion_m) worst = std::move(found);
  }
  worst.status = SearchStatus::stopped_early;  // nobody knows whether there is a worse one
  return worst;
}

}  // namespace rtac
