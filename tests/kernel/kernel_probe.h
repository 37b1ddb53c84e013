/* Opens the static functions of a generated kernel to tests. A C file of its own, so that the same
 * tests run against the kernel as generated, with sanitizers, and with seeded mistakes.
 * Units as in the kernel: mm, mm/s, us, ppm; margins in millionths of 1 m or 1 %. */
#ifndef RTAC_TESTS_KERNEL_KERNEL_PROBE_H
#define RTAC_TESTS_KERNEL_KERNEL_PROBE_H

#include "probe_kernel.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct probe_vec {
  int64_t x, y;
} probe_vec;
typedef struct probe_edge {
  int32_t ax, ay, bx, by, ux_q30, uy_q30;
} probe_edge;
enum { PROBE_EDGES_MAX = 64 };
typedef struct probe_zone {
  probe_edge edges[PROBE_EDGES_MAX];
  int32_t count;
} probe_zone;
typedef struct probe_body {
  int64_t radius_mm, speed_mmps, position_error_mm, velocity_error_mmps, accel_mmps2, brake_mmps2;
  int64_t brake_lag_ms, brake_lag_permille, hold_mm, position_age_us, velocity_age_us,
      sway_permille;
} probe_body;
typedef struct probe_motion {
  int64_t speed_mmps, accel_mmps2;
  int32_t recovery;
} probe_motion;
/* One robot: what it measured, what is declared of it, who drives it. */
typedef struct probe_robot {
  probe_point position, velocity;
  probe_body body;
  probe_motion motion;
  int32_t held;
} probe_robot;
typedef struct probe_reach {
  int32_t input;
  probe_vec p, e;
  int64_t capsule_mm, disc_mm, centre_mm;
} probe_reach;
/* The way under commands: what was sent, the newest first, and what is proposed. */
enum { PROBE_COURSE_MAX = PROBE_COMMANDS + 4 };
typedef struct probe_course {
  int32_t usable, count, first;
  probe_vec at[PROBE_COURSE_MAX], stop[PROBE_COURSE_MAX];
  int64_t leg_mm, stop_mm;
} probe_course;
typedef struct probe_span {
  int64_t lo, hi;
  int32_t input;
} probe_span;

int64_t probe_div_up(int64_t a, int64_t b);
int64_t probe_root_down(int64_t a);
int64_t probe_root_up(int64_t a);
int64_t probe_point_segment_lo(probe_vec p, probe_vec a, probe_vec b);
int64_t probe_segment_gap_lo(probe_vec a, probe_vec b, probe_vec c, probe_vec d);
int32_t probe_inside(const probe_zone* z, probe_vec p);
int64_t probe_boundary_gap_lo(const probe_zone* z, probe_vec p);
int64_t probe_segment_boundary_lo(const probe_zone* z, probe_vec p, probe_vec e);

probe_reach probe_reach_of(const probe_robot* r, int64_t now_us, int64_t horizon_us);
probe_course probe_course_of(const probe_robot* r, const probe_command* sent,
                             const probe_point* proposed, int64_t now_us, int64_t horizon_us,
                             int64_t error_mmps2, int64_t latency_us);
probe_span probe_clearance(const probe_zone* z, const probe_robot* r, int64_t now_us);
/* Gap between the bodies, and the look-ahead margin for `least_mm`. */
probe_span probe_distance(const probe_robot* r, const probe_robot* other, int64_t now_us);
probe_span probe_zone_ahead(const probe_zone* z, const probe_robot* r, int64_t now_us,
                            int64_t horizon_us, int64_t least_mm);
probe_span probe_pair_ahead(const probe_robot* r, const probe_robot* other, int64_t now_us,
                            int64_t horizon_us, int64_t least_mm);
probe_span probe_legs(const probe_zone* z, const probe_robot* r, const probe_plan* plan,
                      int64_t now_us, int32_t legs, int64_t need_mm);
probe_span probe_plan_legs(const probe_zone* z, const probe_plan* plan, int64_t need_mm);
/* Charge on the way to the dock of cart `self`: at a place, and the look-ahead from a robot. */
probe_span probe_way(int32_t self, probe_vec at, int64_t radius_mm);
probe_span probe_charge(const probe_scalar* battery, int64_t now_us, int64_t max_age_us,
                        int64_t error_ppm, int64_t drain_ppm_per_s);
probe_span probe_energy_ahead(int32_t self, const probe_robot* r, probe_span charge, int64_t now_us,
                              int64_t horizon_us, int64_t reserve_ppm, int64_t drain_ppm_per_s);
/* Whether what is said about a promise keeps to what was said before, and whether it is relied upon
 * at all. */
int32_t probe_promise_kept(int64_t end_us, int64_t now_us, int64_t lease_us, int64_t* last_us);
int32_t probe_relied_upon(int64_t end_us, int64_t now_us, int64_t horizon_us, int64_t lease_us);
/* margin `operand` for `ticks`, with its two runs */
probe_span probe_held_for(probe_span operand, int32_t* runs, int32_t ticks, int32_t new_tick);
probe_span probe_at_least(probe_span a, probe_span b, int64_t strict);
probe_span probe_both(probe_span a, probe_span b);
probe_span probe_one(probe_span a, probe_span b);

/* What was declared in probe.rta, as the kernel has it. */
probe_robot probe_cart(void);
probe_robot probe_kite(void);
probe_robot probe_drone(void);
probe_robot probe_leaf(void);
probe_robot probe_swift(void);
int32_t probe_floor(probe_zone* z);

#ifdef __cplusplus
}
#endif

#endif
