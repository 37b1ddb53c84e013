// `ahead n waypoints`: the present leg and the next n, of whatever atom they are judged for.
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

ValueId zone_legs(Expansion& expansion, ZoneIndex zone, std::int64_t least_mm,
                  const std::optional<ValueId>& more, const Atom& atom) {
  const Lookahead& look = expansion.look();
  const Body& body = expansion.decision().body;
  const std::int64_t need_mm = body.radius_mm + least_mm;
  expansion.judges_waypoints(!look.points_only);
  if (look.points_only) {
    return add(atom.to, PointsInZone{zone, look.waypoints, need_mm, more}, atom.source);
  }
  // 1 mm: way-points are rounded to the nearest grid point
  return add(atom.to, LegsInZone{zone, look.waypoints, need_mm + body.tracking_mm + 1, more},
             atom.source);
}

ValueId legs_apart(Expansion& expansion, std::int64_t least_mm, const std::optional<ValueId>& more,
                   const Atom& atom) {
  const Body& body = expansion.decision().body;
  const std::int64_t need_mm = 2 * body.radius_mm + least_mm + body.tracking_mm;
  expansion.judges_waypoints(true);
  // 1 mm for the way-points of either robot
  return add(atom.to,
             LegsApart{expansion.look().waypoints, need_mm + 2,
                       expansion.monitor().recovery.kind == RecoveryKind::yield, more},
             atom.source);
}

void on_track(const Expansion& expansion, Block& ahead) {
  const SourceRange& source = expansion.monitor().lookahead_source;
  const ValueId track = add(ahead, OnTrack{expansion.decision().body.tracking_mm}, source);
  ahead.result = add(ahead, And{ahead.result, track}, source);
}

}  // namespace rtac::passes::lookahead
