// From declared limits (exact, SI) to the integers of a kernel, rounded to the safe side, and from
// there to the clearances that recoveries and planners need.
#pragma once

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// `period_us`: of the decision; it is the sampling period of the brake. `jitter_us`: how much later
// than due a step may come.
ir::Body body_of(const sema::RobotKind& kind, std::int64_t period_us, std::int64_t jitter_us = 0);
// The body of `d` rests so far from walls that the recoveries of `from` may be led along them.
void keep_off_walls(const sema::Spec& spec, const sema::Decision& from, const sema::RobotKind& kind,
                    ir::Decision& d);
ir::Motion any_control(const sema::RobotKind& kind);
// Limits while the named recovery means to drive at most at `speed`, with how fast it may truly be.
ir::Motion recovery_motion(const sema::RobotKind& kind, const ir::Body& body,
                           const std::string& name, const Rational& speed, std::int64_t period_us);

// Of the hold of a point mass, in rad/s, `delay_us` being that of its velocity; what it is at
// least.
Rational hold_frequency(const ir::Body& body, std::int64_t delay_us);
// How far beside its leg a robot in space may come to rest where it is stopped on it, in mm, while
// its hold is carried at `speed` in m/s.
std::int64_t stray_mm(const ir::Body& body, const Rational& speed, std::int64_t period_us);
// How fast a hold of a point mass may be for a moment, whatever turns around that errs and pushes.
std::int64_t hold_speed_mmps(const ir::Body& body, std::int64_t period_us);

// How fast a recovery may truly be that means to drive at `w_mmps`, `pushed_mmps` being how much
// faster what pushes the robot makes it (pushed_speed).
std::int64_t fastest_mmps(const ir::Body& body, std::int64_t pushed_mmps, std::int64_t period_us,
                          std::int64_t w_mmps);

// Measured clearance of the centre that lets every fence of the decision hand control back to a
// robot at rest, in spite of noise (theory: rho_ret + r_eff, plus one more position error because
// the recovery steers by measurements).
std::int64_t return_clearance_mm(const ir::Decision& decision, std::int64_t lookahead_us);
// The same from a limit of height, which counts for the centre.
inline std::int64_t return_height_mm(const ir::Decision& decision, std::int64_t lookahead_us) {
  return return_clearance_mm(decision, lookahead_us) - decision.body.radius_mm;
}
// Clearance of the centre at which a robot at rest is seen to keep the claim of an external
// recovery with that motion, in spite of noise.
std::int64_t claim_clearance_mm(const ir::Decision& decision, const ir::Motion& motion,
                                std::int64_t lookahead_us);
// Clearance of the centre at which `motion` never fails the disc test, whatever the speed.
std::int64_t cruise_clearance_mm(const ir::Decision& decision, const ir::Motion& motion,
                                 std::int64_t lookahead_us);
// Of the clearances of a recovery, what the properties keep from the boundary of its zone beyond
// touching it.
std::int64_t standoff_mm(const ir::Decision& decision, const ir::Recovery& recovery);
// How far from a leg as it sees it a robot that is led along it may be.
std::int64_t beside_leg_mm(const ir::Decision& decision, const ir::Recovery& recovery);
// Distance of centres at which a robot at full speed passes one that is HELD, standoff included.
std::int64_t pass_gap_mm(const ir::Decision& decision, std::int64_t lookahead_us,
                         std::int64_t standoff_mm);
// How far from the place that it holds a robot at rest may be measured. Wheels hold where they have
// been measured, and are measured anew.
std::int64_t off_hold_mm(const ir::Body& body);
// How far from where it truly was then the place is that a robot holds from when it came to rest.
std::int64_t latched_off_mm(const ir::Body& body, std::int64_t period_us);
// From how far between the places that they hold on robots that have to keep `apart_mm` are given
// back, wherever each of them is measured about its own.
std::int64_t given_back_mm(const ir::Decision& decision, std::int64_t lookahead_us,
                           std::int64_t apart_mm);
// How fast a robot at rest may be measured, and have been when its position was.
std::int64_t still_mmps(const ir::Body& body);
// Clearance of the centre at which a robot at rest, driven by `motion`, is seen to have a clearance
// of `least_mm` in spite of noise: what a return condition that asks for it needs.
std::int64_t shown_clearance_mm(const ir::Decision& decision, const ir::Motion& motion,
                                std::int64_t least_mm);
// How fast a robot at rest, driven by `motion`, may look: every sample shows it to be no faster, in
// spite of noise, as old as it may be. What a return condition that asks it to be slow needs.
std::int64_t shown_speed_mmps(const ir::Decision& decision, const ir::Motion& motion);
// What a full battery is seen to have left at least, in ppm, its sample being as old as it may.
std::int64_t shown_full_ppm(const ir::Body& body);

}  // namespace rtac::analysis
