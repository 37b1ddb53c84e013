/* The decision step of specs/robot_delivery as an engineer would write it by hand: C99, doubles,
 * SI units, one pass over the same checks and tables as the generated kernel. It is what the
 * benchmark measures the generated code against, and nothing else uses it. */
#ifndef RTAC_BENCH_HAND_DELIVERY_H
#define RTAC_BENCH_HAND_DELIVERY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { HAND_ROBOTS = 2, HAND_MONITORS = 3, HAND_EDGES = 128, HAND_PLAN_CAPACITY = 64 };
enum { HAND_COLLISION = 0, HAND_GEOFENCE = 1, HAND_BATTERY = 2 };
/* Numbered as in the decision record. */
enum { HAND_FALSE = 0, HAND_UNKNOWN = 1, HAND_TRUE = 2 };
enum { HAND_FREE = 0, HAND_AWAY_ONLY = 1, HAND_HOLD = 2 };

typedef struct hand_vec {
  double x, y;
} hand_vec;

/* One edge of the zone: from a to b, the zone on its left. */
typedef struct hand_edge {
  hand_vec a, d;  /* d: from a to b */
  double inverse; /* 1 / |d|^2 */
  hand_vec b, low, high;
} hand_edge;
typedef struct hand_zone {
  int count;
  hand_edge edges[HAND_EDGES];
} hand_zone;

/* Charge for the way to the dock, at most, ppm per square cell; below 0: no body fits there. */
typedef struct hand_cells {
  const int32_t* ppm;
  double origin_x, origin_y, cells_per_m;
  int32_t columns, rows;
  hand_vec dock;
  double per_m; /* of the driving alone, 1: a full battery */
} hand_cells;
/* Limits of whoever drives: any control, the recoveries by priority, and at last a robot that is
 * bound by its promise to stay. A recovery starts at the speed it finds. */
typedef struct hand_motion {
  double speed, accel;
  int32_t recovery;
} hand_motion;
typedef struct hand_tables {
  hand_motion motions[HAND_MONITORS + 2];
  hand_zone zone;
  hand_cells to_dock[HAND_ROBOTS];
} hand_tables;

typedef struct hand_point {
  hand_vec value;
  int64_t stamp_us;
  int32_t valid;
} hand_point;
typedef struct hand_scalar {
  double value; /* of the charge, 1: full; of the heading, rad */
  int64_t stamp_us;
  int32_t valid;
} hand_scalar;
typedef struct hand_plan {
  const hand_vec* points;
  int32_t valid, count, index;
} hand_plan;
typedef struct hand_other {
  hand_point position, velocity;
  int64_t lease_end_us;
  int32_t goes_first;
  hand_plan plan;
} hand_other;
typedef struct hand_in {
  int32_t self, holding, surrender;
  hand_point position, velocity;
  hand_scalar battery, heading;
  hand_plan plan;
  hand_other others[HAND_ROBOTS];
} hand_in;

typedef struct hand_finding {
  int32_t reason, index, input, other;
} hand_finding;
typedef struct hand_monitor {
  int32_t engaged, dwell;
  hand_finding found;
} hand_monitor;
typedef struct hand_state {
  int32_t started, mode;
  int64_t origin_us, last_us, tick;
  hand_monitor monitors[HAND_MONITORS];
  int64_t takeover_us;     /* when the present driver took over */
  int32_t takeover_before; /* the fastest one that drove before it */
  int64_t lease_end_us;
  int64_t last_position_us, last_velocity_us, last_battery_us, last_heading_us;
  int64_t last_other_us[HAND_ROBOTS], last_other_velocity_us[HAND_ROBOTS];
  int64_t last_other_lease_us[HAND_ROBOTS];
  int32_t clear_ticks, maybe_clear_ticks; /* that the clearance of the return condition has held */
} hand_state;

typedef struct hand_result {
  int32_t now, ahead, safer, engaged;
  double margin; /* m, or % of a full battery */
} hand_result;
typedef struct hand_out {
  int64_t tick, time_us, lease_end_us;
  int32_t mode, previous_mode, monitor, gate;
  hand_finding found;
  int64_t position_age_us, velocity_age_us, battery_age_us, heading_age_us;
  int64_t violation_us; /* at the earliest, of a property of lengths; -1: not known */
  hand_result monitors[HAND_MONITORS];
} hand_out;

/* `edges_mm`: ax, ay, bx, by per edge. */
void hand_zone_init(hand_zone* z, const int32_t* edges_mm, int32_t count);
void hand_init(hand_state* s);
void hand_step(const hand_tables* t, hand_state* s, const hand_in* in, int64_t now_us,
               hand_out* out);

#ifdef __cplusplus
}
#endif

#endif
