// Where a robot's centre may be: far enough from the zone's boundary and out of all discs.
#pragma once

#include "rtac/controller.h"
#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac::planning {

using Discs = FixedList<Disc, max_robots>;

class FreeSpace {
 public:
  // `zone` may be null: no walls. Zone and discs must outlive this object.
  FreeSpace(const ZoneView* zone, double clearance_m, const Discs& discs)
      : zone_(zone), clearance_m_(clearance_m), discs_(&discs) {}

  [[nodiscard]] bool point_free(Vec2 p) const { return leg_free(p, p); }
  // The whole segment, by segment distances.
  [[nodiscard]] bool leg_free(Vec2 a, Vec2 b) const;
  // The leg may use what `start` already lacks, constraint by constraint, and no more.
  [[nodiscard]] bool leg_no_worse_than(Vec2 start, Vec2 a, Vec2 b) const;
  // End of the shortest straight leg out of the forbidden band (see rtac/planning/ompl_planner.h).
  // Looks along fixed directions up to 2 m: deterministic. False: there is none.
  [[nodiscard]] bool escape(Vec2 start, Vec2& end) const;

 private:
  // Distance left until the constraint is broken, in m; infinity without a zone.
  [[nodiscard]] double wall_slack_m(Vec2 a, Vec2 b) const;

  const ZoneView* zone_;
  double clearance_m_;
  const Discs* discs_;
};

// Distance from `p` to the segment a-b, in m.
double segment_distance(Vec2 a, Vec2 b, Vec2 p);

}  // namespace rtac::planning
