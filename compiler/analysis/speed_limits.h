// Limits of speed: whether recoveries keep them, and whether control can come back.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/decided.h"
#include "compiler/analysis/trials.h"
#include "compiler/diagnostics/engine.h"

namespace rtac::analysis {

// What the kernel may take a robot at rest for, until a recovery would act: control returns at rest
// where a limit of speed is no lower.
std::int64_t fastest_from_rest(const ir::Decision& decision, std::int64_t lookahead_us);

// The same of a point mass that holds its place, which pushes and errors that turn around keep
// moving: it is surely given back below no less.
std::int64_t fastest_from_hold(const ir::Decision& decision, std::int64_t lookahead_us);

// What is said of that, in mm/s. The look-ahead bounds changes of the velocity alone: of wheels,
// each of which is a turn or a change of the speed, that is more than they can speed up by.
std::string from_rest_text(const sema::RobotKind& kind, std::int64_t mmps);

// How fast the recovery of monitor `k` may truly be while it drives: a point mass follows the speed
// that it measures, is wrong about that by the error of its velocity, and overshoots by its delays.
std::int64_t fastest_while_driving(const ir::Decision& decision, std::size_t k);

// Whether a robot that has come to rest fulfils the property of a monitor wherever it is, and is
// given back: as it asks for no more than to be slow, or one side of its `or` does.
bool holds_at_rest(const ir::Decision& decision, const ir::Monitor& monitor);

// Whether one that is braked and held fulfils it from when it stands on, whoever comes near: its
// true speed is what counts, and not what it might reach once it was given back.
bool holds_held(const ir::Decision& decision, const ir::Monitor& monitor);

// What makes that so, and `fault` go: a limit that is higher, or other numbers that have been
// tried.
std::vector<std::string> held_that_works(const Decided& of, std::size_t k, const Fault& fault);

// Whether what it says of agents is kept whoever comes near, and whatever recovery drives that
// obeys the separation gate: while that moves the gate keeps them as far off as is asked, and where
// it is held it is as slow as another side of each `or` asks. So is one that speaks of no agent.
bool is_slow_beside_agents(const ir::Decision& decision, const ir::Monitor& monitor);

// Whether it is given back, too, whatever keeps it moving while it holds its place.
bool holds_in_hold(const ir::Decision& decision, const ir::Monitor& monitor);

// Whether it fulfils the property of `monitor` wherever it is while the recovery of monitor `k`
// drives, and is given back wherever that has come to rest.
bool holds_while_driving(const ir::Decision& decision, std::size_t k, const ir::Monitor& monitor);

// Whether it fulfils the property there, though it may not be given back.
bool holds_standing(const ir::Monitor& monitor);

// The lowest limit of speed that a property may ask for, on whichever of its sides; none: the
// highest number.
std::int64_t least_limit_mmps(const ir::Block& property);

// Whether the recovery of one monitor keeps the limits of speed of another one, acknowledged or
// not.
bool keeps_speed_limits(const Decided& of, std::size_t driving, std::size_t judged);

// 5033, of each comparison that asks for at most some speed.
std::vector<diag::Diagnostic> unkept_speed_limits(const Decided& of);
// The 5033 of a limit that gives control back nowhere, whatever the recovery does.
bool is_too_fast_at_rest(const diag::Diagnostic& report);

}  // namespace rtac::analysis
