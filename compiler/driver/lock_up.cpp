#include "compiler/driver/lock_up.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

namespace rtac::driver {
namespace {

struct Robot {
  bool waits = true;
  double x_m = 0, y_m = 0;
};
using Robots = std::map<std::size_t, Robot>;

// Who waits drives nowhere, and is nobody else's fault.
bool are_left_alone(const Robots& robots, std::size_t waiting, double within_m) {
  for (const auto& [i, robot] : robots) {
    if (robot.waits) continue;
    if (i < waiting) return false;
    for (const auto& [k, other] : robots) {
      const double away_m = std::hypot(robot.x_m - other.x_m, robot.y_m - other.y_m);
      if (k < waiting && away_m < within_m) return false;
    }
  }
  return true;
}

}  // namespace

bool locks_up(const std::string& trace, std::size_t waiting, const verify::LockUp& how) {
  constexpr double mm_per_m = 1000;
  bool kept = false, safe = false;
  Robots robots;
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, x, y;
    std::size_t robot = 0;
    int mode = 0;
    words >> word;
    kept = kept || line.starts_with("end not given back: ");
    // what is violated where a run begins is nothing that they have done
    safe = safe || line == "end no violation" ||
           (line.starts_with("end violation of ") && line.find(" at_us 0 ") != std::string::npos);
    if (word == "decide" && words >> robot >> mode) {
      robots[robot].waits = std::ranges::find(how.waiting, mode) != how.waiting.end();
    }
    if (word == "truth" && words >> robot >> x >> y) {
      robots[robot].x_m = std::strtod(x.c_str(), nullptr);
      robots[robot].y_m = std::strtod(y.c_str(), nullptr);
      const double within_m = static_cast<double>(how.within_mm) / mm_per_m;
      if (!are_left_alone(robots, waiting, within_m)) return false;
    }
  }
  return kept && safe && robots.size() >= waiting;
}

}  // namespace rtac::driver
