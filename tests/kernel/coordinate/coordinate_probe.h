/* Calls the choice of a coordinated kernel with anything. */
#ifndef COORDINATE_PROBE_H
#define COORDINATE_PROBE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { probe_monitors_max = 6 };
/* Row: a recovery, column: a monitor. `proved` 2: its own one. `ahead`: lower ends; not negative:
 * it holds. `violated`: the property is false now. */
typedef struct probe_choice {
  int32_t count, driving;
  int32_t engaged[probe_monitors_max], violated[probe_monitors_max];
  int32_t proved[probe_monitors_max * probe_monitors_max];
  int64_t ahead[probe_monitors_max * probe_monitors_max];
} probe_choice;

/* The monitor whose recovery drives, -1: none; what is engaged then is left in `c`. */
int32_t probe_coordinate(probe_choice* c);
/* How many monitors the recovery of monitor i keeps, from the first on. */
int32_t probe_kept_prefix(const probe_choice* c, int32_t i);
int32_t probe_keeps_now(const probe_choice* c, int32_t i, int32_t j);

#ifdef __cplusplus
}
#endif
#endif
