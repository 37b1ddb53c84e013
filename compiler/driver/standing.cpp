#include "compiler/driver/standing.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <utility>

namespace rtac::driver {

bool stands(const std::string& trace) {
  constexpr double still_m = 1e-6;
  bool kept = false;
  std::optional<std::pair<double, double>> began;
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    kept = kept || line.starts_with("end not given back: ");
    std::istringstream words(line);
    std::string word, x, y;
    std::size_t robot = 0;
    if (!(words >> word >> robot >> x >> y) || word != "truth" || robot != 0) continue;
    const double x_m = std::strtod(x.c_str(), nullptr), y_m = std::strtod(y.c_str(), nullptr);
    if (!began) began = {x_m, y_m};
    if (std::hypot(x_m - began->first, y_m - began->second) > still_m) return false;
  }
  return kept && began;
}

}  // namespace rtac::driver
