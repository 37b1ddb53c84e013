#include "compiler/driver/standing.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <sstream>

namespace rtac::driver {
namespace {

// Of a line `truth`: where it is, and which way it looks.
struct Pose {
  double x_m, y_m, heading_rad, height_m;
};
std::optional<Pose> pose_of(std::istringstream& words) {
  std::array<double, 8> all{};  // x, y, both speeds, heading, charge, height, climb
  for (double& each : all) {
    std::string word;
    if (!(words >> word)) return std::nullopt;
    each = std::strtod(word.c_str(), nullptr);
  }
  return Pose{all[0], all[1], all[4], all[6]};
}
bool is_same(const Pose& a, const Pose& b) {
  constexpr double hardly = 1e-6;  // m, rad
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) <= hardly &&
         std::abs(a.heading_rad - b.heading_rad) <= hardly &&
         std::abs(a.height_m - b.height_m) <= hardly;
}

}  // namespace

bool stands(const std::string& trace, const std::string& robot) {
  bool kept = false;
  std::optional<Pose> began;
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    kept = kept || line.starts_with("end not given back: " + robot + " ");
    std::istringstream words(line);
    std::string word;
    std::size_t index = 0;
    if (!(words >> word >> index) || word != "truth" || index != 0) continue;
    const std::optional<Pose> now = pose_of(words);
    if (!now) return false;
    if (!began) began = now;
    if (!is_same(*began, *now)) return false;
  }
  return kept && began;
}

}  // namespace rtac::driver
