// One transformer per atom: a file each. It returns nothing where the comparison speaks of its
// signals in another way than it knows.
#pragma once

#include <optional>

#include "compiler/passes/lookahead/expansion.h"

namespace rtac::passes::lookahead {

using Expanded = std::optional<ir::ValueId>;

Expanded fence(Expansion& expansion, const Atom& atom);           // inside, clearance
Expanded received(Expansion& expansion, const Atom& atom);        // of a zone that is received
Expanded separation(Expansion& expansion, const Atom& atom);      // from another robot
Expanded agent(Expansion& expansion, const Atom& atom);           // from what moves by itself
Expanded charge(Expansion& expansion, const Atom& atom);          // at least a constant
Expanded charge_for_way(Expansion& expansion, const Atom& atom);  // at least what a way takes
Expanded count(Expansion& expansion, const Atom& atom);           // of other robots
Expanded speed(Expansion& expansion, const Atom& atom);           // at most a constant
Expanded altitude(Expansion& expansion, const Atom& atom);        // at most, at least a constant

// A zone that is there at certain times; `there`: that it is, or that it is not.
ir::ValueId window(Expansion& expansion, const ir::ZoneThere& zone, bool there,
                   const SourceRange& source, ir::Block& to);

// What holds under any control, or else on the course under the commands that are known.
ir::ValueId or_course(Expansion& expansion, ir::ValueId any_control, ir::Op course,
                      const Atom& atom);

// ---- legs of the plan

// The next legs, or way-points, keep the zone's boundary away.
ir::ValueId zone_legs(Expansion& expansion, ir::ZoneIndex zone, std::int64_t least_mm,
                      const std::optional<ir::ValueId>& more, const Atom& atom);
// The next legs keep away from another robot.
ir::ValueId legs_apart(Expansion& expansion, std::int64_t least_mm,
                       const std::optional<ir::ValueId>& more, const Atom& atom);
// Whatever legs are judged rest on the declared tracking, in every disjunct: once, for all.
void on_track(const Expansion& expansion, ir::Block& ahead);

}  // namespace rtac::passes::lookahead
