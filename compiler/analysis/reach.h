// The look-ahead bounds in integers, as the kernel computes them, for use at compile time: how
// much clearance a state needs. Units: mm, mm/s, us. Source: theory, "Look-ahead against any
// control over T" (disc), "The brake is a closed-loop claim".
#pragma once

#include <cstdint>

#include "compiler/ir/module.h"

namespace rtac::analysis {

// Longest time from the stamp of a sample until a recovery acts: sample age, look-ahead, latency.
std::int64_t horizon_us_max(const ir::Body& body, std::int64_t lookahead_us);

// By how much a velocity may have changed between its stamp and that of the position, in mm/s: the
// one sample may be new while the other is as old as it may be (theory, unequal stamps).
std::int64_t apart_mmps(const ir::Body& body);

// Longest way within `t_us` that a measured speed leaves possible.
std::int64_t way_mm(const ir::Body& body, const ir::Motion& motion, std::int64_t measured_mmps,
                    std::int64_t t_us);

// Distance that a robot can cover, body and stop included, seen from its measured position:
// passing the disc test needs this much measured clearance of the centre.
// `measured_mmps`: |v| as measured; `t_us`: horizon from the stamp on.
std::int64_t disc_mm(const ir::Body& body, const ir::Motion& motion, std::int64_t measured_mmps,
                     std::int64_t t_us);

// How far a robot that stands may get until it is held, and while it is, whatever pushes it and is
// measured of it.
std::int64_t standing_mm(const ir::Body& body, std::int64_t period_us);

}  // namespace rtac::analysis
