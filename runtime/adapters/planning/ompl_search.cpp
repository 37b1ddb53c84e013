#include "ompl_search.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <exception>
#include <memory>
#include <mutex>

namespace rtac::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Vec2 point_of(const ob::State* state) {
  const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
  return {values[0], values[1]};
}

// Judges whole legs; OMPL's own validator samples states on them and can step over a corner.
class LegValidator : public ob::MotionValidator {
 public:
  LegValidator(const ob::SpaceInformationPtr& info, const FreeSpace& space)
      : ob::MotionValidator(info), space_(space) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const bool ok = space_.leg_free(point_of(a), point_of(b));
    ok ? ++valid_ : ++invalid_;
    return ok;
  }
  // The last valid state of a leg that is not free: its beginning, the only one that is known.
  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, a);
    last_valid.second = 0;
    return false;
  }

 private:
  const FreeSpace& space_;
};

ob::SpaceInformationPtr make_info(const FreeSpace& space, const Search& search) {
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, search.lower.x);
  bounds.setLow(1, search.lower.y);
  bounds.setHigh(0, search.upper.x);
  bounds.setHigh(1, search.upper.y);
  plane->setBounds(bounds);
  auto info = std::make_shared<ob::SpaceInformation>(plane);
  info->setStateValidityChecker(
      [&space](const ob::State* state) { return space.point_free(point_of(state)); });
  info->setMotionValidator(std::make_shared<LegValidator>(info, space));
  info->setup();
  return info;
}

ob::ProblemDefinitionPtr make_problem(const ob::SpaceInformationPtr& info, const Search& search) {
  auto problem = std::make_shared<ob::ProblemDefinition>(info);
  ob::ScopedState<ob::RealVectorStateSpace> start(info), goal(info);
  start[0] = search.start.x;
  start[1] = search.start.y;
  goal[0] = search.goal.x;
  goal[1] = search.goal.y;
  problem->setStartAndGoalStates(start, goal);
  if (search.algorithm != Algorithm::rrt_connect) {
    problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(info));
  }
  return problem;
}

ob::PlannerPtr make_planner(const ob::SpaceInformationPtr& info, Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::rrt_star:
      return std::make_shared<og::RRTstar>(info);
    case Algorithm::bit_star:
      return std::make_shared<og::BITstar>(info);
    case Algorithm::rrt_connect:
      return std::make_shared<og::RRTConnect>(info);
  }
  return nullptr;
}

// OMPL draws the seeds of its generators, as they are made during a search, from one source for
// the whole process. Whoever wants the same draws again must own that source during the search.
std::mutex& seed_source() {
  static std::mutex mutex;
  return mutex;
}

bool solve(const FreeSpace& space, const Search& search, std::vector<Vec2>& points) {
  const auto info = make_info(space, search);
  const auto problem = make_problem(info, search);
  const auto planner = make_planner(info, search.algorithm);
  if (!planner) return false;
  planner->setProblemDefinition(problem);
  planner->setup();
  ob::IterationTerminationCondition limit(static_cast<unsigned>(search.iterations));
  if (planner->solve(limit) != ob::PlannerStatus::EXACT_SOLUTION) return false;
  const auto* path = problem->getSolutionPath()->as<og::PathGeometric>();
  points.clear();
  for (unsigned i = 0; i < path->getStateCount(); ++i) {
    points.push_back(point_of(path->getState(i)));
  }
  return points.size() >= 2;
}

}  // namespace

bool run_ompl(const FreeSpace& space, const Search& search, std::vector<Vec2>& points) {
  static std::once_flag silenced;
  std::call_once(silenced, [] { ompl::msg::setLogLevel(ompl::msg::LOG_NONE); });
  const std::lock_guard<std::mutex> owner(seed_source());
  try {
    // 32 bits, and zero is refused.
    ompl::RNG::setSeed(static_cast<std::uint32_t>(search.seed >> 32) | 1U);
    return solve(space, search, points);
  } catch (const std::exception&) {
    return false;  // OMPL reports bad set-ups by exceptions; here they mean: no plan
  }
}

std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t call) {
  // The finaliser of the splitmix64 generator (Steele, Lea, Flood, OOPSLA 2014).
  std::uint64_t z = seed + (call + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

}  // namespace rtac::planning
