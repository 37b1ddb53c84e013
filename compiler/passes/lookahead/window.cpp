// Zones that are there at certain times: what holds from when the robot was seen until the recovery
// has acted and, where to stand still does not do, has led out (theory, two robots: time window).
#include "compiler/passes/lookahead/atoms.h"

namespace rtac::passes::lookahead {

using namespace ir;

ValueId window(Expansion& expansion, const ZoneThere& zone, bool there, const SourceRange& source,
               Block& to) {
  const Recovery& recovery = expansion.monitor().recovery;
  const ValueId holds = there ? add(to, ThereThroughout{zone.schedule, recovery.leave_us}, source)
                              : add(to, GoneThroughout{zone.schedule, recovery.leave_us}, source);
  if (recovery.kind != RecoveryKind::route) return holds;  // accepted as it is, or an error
  // From wherever it stops the recovery has to know a way.
  expansion.decides_in(Unit::mm);
  const ValueId has_way = add(to, ZoneReach{recovery.zone, recovery.leave_least_mm}, source);
  return add(to, And{holds, has_way}, source);
}

}  // namespace rtac::passes::lookahead
