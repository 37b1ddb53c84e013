// Language rules 10 and 12.1 on what a verification.json says: which recoveries keep what, and
// whether some of them lead round in a circle.
#pragma once

#include "compiler/recheck/written.h"

namespace rtac::recheck {

// It speaks of inputs, or of zones that come and go: its own recovery is the answer to that.
bool answers_to_inputs(const sema::Expr& property);
// Of that something has to hold, whatever the robot does.
bool asks_by_inputs(const sema::Expr& property);
// Proved of the recovery by itself, and not because another one takes over; or it is its own.
bool shown_to_keep(const sema::Spec& spec, const sema::Decision& d, const Part& part,
                   const sema::Monitor& driving, const sema::Monitor& judged);
// Rule 10: its recovery drives on though the other one, which ranks higher, is engaged. That is
// said of zones, heights and speed alone.
bool drives_on(const sema::Spec& spec, const sema::Decision& d, const Part& part,
               const sema::Monitor& driving, const sema::Monitor& judged);
// Among the monitor and those above it, does a circle of recoveries that are not shown to keep the
// next one's monitor start from it, or is one led to from it?
bool in_circle(const sema::Spec& spec, const sema::Decision& d, const Part& part,
               const sema::Monitor& judged);

}  // namespace rtac::recheck
