// Places around a zone, of the plane or of space: what generated code finds of points there is held
// against exact geometry.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/differential/batch.h"

namespace rtac::differential {

struct ZoneCase {
  const char* name;
  const char* zone;
  bool on_grid;
  double scale_m;                           // of random places
  std::vector<std::vector<double>> places;  // corners, in metres
};

// A sample of so many millionths of a metre, just measured.
driver::Observed observed(std::int64_t micro, std::int64_t now_us);

// A robot's text follows the monitors of points, if any.
std::string spec_of(const ZoneCase& c, const std::string& robot = "");

// At 3,000 places, at corners, on edges and anywhere: verdicts refine the exact ones, are the same
// when they are computed alone, and are as exact where both lie on the grid; margins are below the
// exact ones by `most_on_grid_m` at most there, by `most_m` elsewhere.
void expect_conservative_and_tight(const ZoneCase& c, const std::string& spec,
                                   double most_on_grid_m, double most_m);

}  // namespace rtac::differential
