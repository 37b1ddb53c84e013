// How far it is to a goal for a body of a given size, around everything that stands: the measure of
// progress, and nothing else.
#pragma once

#include <vector>

#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac::sim {

class DistanceField {
 public:
  // Over the cells of `zone` that leave the centre a clearance of `clearance_m` somewhere; the
  // zone's tables must outlive the field.
  DistanceField(const ZoneView& zone, Vec2 goal, double clearance_m);
  // Along cell centres, 8-connected, plus the way to the centre of the own cell; the straight
  // distance where no way is known.
  [[nodiscard]] double distance_m(Vec2 from) const;

 private:
  [[nodiscard]] int cell_of(Vec2 p) const;  // -1: outside
  [[nodiscard]] Vec2 centre(int cell) const;

  ZoneView zone_;
  Vec2 goal_;
  std::vector<double> value_m_;
};

}  // namespace rtac::sim
