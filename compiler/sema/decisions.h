// Decisions: which controllers, when, and the order of the monitors.
#pragma once

#include "compiler/sema/context.h"

namespace rtac::sema {

// Most monitors of one decision: the runtime's decision record has this many places.
inline constexpr int max_priority = 16;

// Needs everything else. Also says which monitors no decision uses.
void check_decisions(Context& context);
// Of what has no errors: a decision that no robot has.
void warn_without_robots(Context& context);

// What the trigger of a decision (period or plan) asks of its monitors; see triggers.cpp.
void check_monitors_of(Context& context, const Decision& decision);

}  // namespace rtac::sema
