/* What every hand-written monitor begins with: which tick is it, is a sample fit to be used. */
#ifndef RTAC_BENCH_WATCH_CLOCK_H
#define RTAC_BENCH_WATCH_CLOCK_H

#include <stdint.h>

enum { HAND_FALSE, HAND_UNKNOWN, HAND_TRUE };
enum { HAND_NO_REASON = 0, HAND_MARGIN = 1, HAND_WITHIN_ERROR = 5, HAND_INPUT = 6 };
enum { HAND_NONE = 0, HAND_CLOCK = 1 };
enum { HAND_MISSED_MAX = 4 }; /* ticks that may be missed before the past is forgotten */

#define HAND_INFINITE INT64_C(500000000000000000)

/* The samples that generated code has: steps of the grid, none of them above what was measured, and
 * a bit for each number that lies strictly between its step and the next. */
typedef struct hand_number {
  int64_t stamp_us;
  int32_t valid;
  uint32_t between;
  int64_t value;
} hand_number;
typedef struct hand_point {
  int64_t stamp_us;
  int32_t valid;
  uint32_t between;
  int64_t x, y;
} hand_point;

typedef struct hand_finding {
  int32_t verdict, reason, input, unit;
  int64_t lo, hi; /* millionths of the unit */
} hand_finding;

typedef struct hand_clock {
  int32_t started;
  int64_t origin_us, last_us, tick;
} hand_clock;

/* Ticks since the last step, counted to the nearest; < 1: there is none to judge. */
static inline int64_t hand_elapsed(hand_clock* c, int64_t now_us, int64_t period_us) {
  int64_t tick, elapsed;
  if (!c->started) {
    c->started = 1;
    c->origin_us = now_us;
    c->last_us = now_us;
    c->tick = 0;
    return 1;
  }
  if (now_us < c->last_us) return -1;
  c->last_us = now_us;
  tick = (now_us - c->origin_us + (period_us - 1) / 2) / period_us;
  elapsed = tick - c->tick;
  c->tick = tick;
  return elapsed;
}

/* Neither from the future nor before an earlier one, whether it has a value or not. */
static inline int hand_good(int64_t stamp_us, int64_t* last_us, int64_t now_us) {
  if (stamp_us > now_us || stamp_us < *last_us) return 0;
  *last_us = stamp_us;
  return 1;
}

#endif
