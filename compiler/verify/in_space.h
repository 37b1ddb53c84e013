// Places of robots in space, in doubles, for runs that are to show something: nothing is claimed of
// them.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "compiler/analysis/outline.h"
#include "compiler/verify/proofs.h"

namespace rtac::verify {

// All in mm.
constexpr double endless_mm = 1e9;

struct At {
  analysis::outline::P p;
  double z = 0;
};

// Slabs one above the other; a zone of the plane is a single one without an end.
class Volume {
 public:
  Volume(const Subject& s, ir::ZoneIndex zone);
  // Everything within `gap` of a place lies in it, in the box around that.
  [[nodiscard]] bool clear(const At& at, double gap) const;
  // Where a retreat leads from a place in it: up or down, and then level.
  [[nodiscard]] std::vector<At> inwards(const At& from, double clear_mm) const;
  // Beside the middle of each wall, so far inside of it, half way up; and the way out from there,
  // of length 1.
  struct BesideWall {
    At at;
    analysis::outline::P outwards;
  };
  [[nodiscard]] std::vector<BesideWall> beside_walls(double off_mm) const;
  // The box around it, as far as a box around others goes.
  void narrow(analysis::outline::P& low, analysis::outline::P& high, double& floor,
              double& ceiling) const;

 private:
  struct Slab {
    analysis::outline::Outline outline;
    double floor, ceiling;
  };
  std::vector<Slab> slabs_;
};

// What a property says of places, as far as it is a matter of zones and heights alone.
struct Says {
  std::vector<std::pair<Volume, double>> zones;  // with what is asked beyond touching them
  double least_mm = -endless_mm, most_mm = endless_mm;
  [[nodiscard]] bool holds(const At& at, double body_mm, double spare_mm) const;
};
Says says_of(const Subject& s, const ir::Block& property);

// A grid in the box that all zones have in common, up to `rim_mm` from its sides.
std::vector<At> grid_of(const std::vector<Says>& all, double body_mm, double rim_mm);

}  // namespace rtac::verify
