#include "compiler/driver/in_turns.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

namespace rtac::driver {
namespace {

// A robot, since anybody else has driven it.
struct Led {
  std::optional<int> mode;
  int taken = 0;
};

}  // namespace

int turns_taken(const std::string& trace, const std::vector<int>& modes) {
  bool kept = false;
  std::map<std::size_t, Led> robots;
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    kept = kept || line.starts_with("end not given back: ");
    std::istringstream words(line);
    std::string word;
    std::size_t at = 0;
    int mode = 0;
    if (!(words >> word >> at >> mode) || word != "decide") continue;
    Led& robot = robots[at];
    if (std::ranges::find(modes, mode) == modes.end()) {
      robot = {};
      continue;
    }
    if (robot.mode && *robot.mode != mode) ++robot.taken;
    robot.mode = mode;
  }
  if (!kept) return 0;
  int most = 0;
  for (const auto& [at, robot] : robots) most = std::max(most, robot.taken);
  return most;
}

}  // namespace rtac::driver
