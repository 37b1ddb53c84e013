// The only door to OMPL: plain data in, plain data out.
#pragma once

#include <cstdint>
#include <vector>

#include "free_space.h"
#include "rtac/planning/ompl_planner.h"

namespace rtac::planning {

struct Search {
  Vec2 start, goal;   // both free
  Vec2 lower, upper;  // contain both
  Algorithm algorithm = Algorithm::rrt_star;
  std::uint64_t seed = 1;
  int iterations = 0;
};

// A path of free legs from start to goal, both included; false: none within the iterations.
// Deterministic: see OmplPlanner on what that costs.
bool run_ompl(const FreeSpace& space, const Search& search, std::vector<Vec2>& points);

// A well-mixed seed for the `call`-th use of `seed`.
std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t call);

}  // namespace rtac::planning
