// What happens to a path after the search: pulled taut, then cut into legs.
#pragma once

#include <vector>

#include "free_space.h"
#include "rtac/types.h"

namespace rtac::planning {

double path_length(const std::vector<Vec2>& points);

// The shortest way over points on the path, every leg free. Never longer than the path (up to
// rounding); deterministic. Before: a path of free legs. After: the same ends, fewer corners.
std::vector<Vec2> pull_taut(const FreeSpace& space, const std::vector<Vec2>& points);

// Writes points[1..] to `path`, splitting legs longer than `leg_m` (<= 0: none) into equal parts.
// False: more than max_waypoints are needed.
bool write_path(const std::vector<Vec2>& points, double leg_m, Path& path);

}  // namespace rtac::planning
