/* The monitors of patrol.rta as an engineer writes them by hand. */
#ifndef RTAC_BENCH_WATCH_PATROL_H
#define RTAC_BENCH_WATCH_PATROL_H

#include "tests/bench/watch/hand/clock.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HAND_CHARGED, HAND_FENCE, HAND_APART, HAND_PATROL_MONITORS };
enum { HAND_BATTERY = 2, HAND_FIRST, HAND_SECOND }; /* inputs, as a finding names them */

typedef struct hand_patrol_in {
  hand_number battery;      /* ppm */
  hand_point first, second; /* mm */
} hand_patrol_in;

/* A margin, and which input is missing when it is unknown. */
typedef struct hand_margin {
  int64_t lo, hi;
  int32_t input, unit;
} hand_margin;

typedef struct hand_patrol_state {
  hand_clock clock;
  int64_t battery_us, first_us, second_us; /* newest stamps */
  hand_margin charged;                     /* `since`, up to the tick before */
} hand_patrol_state;

typedef struct hand_patrol_out {
  int64_t tick;
  hand_finding monitors[HAND_PATROL_MONITORS];
} hand_patrol_out;

void hand_patrol_init(hand_patrol_state* s);
void hand_patrol_step(hand_patrol_state* s, const hand_patrol_in* in, int64_t now_us,
                      hand_patrol_out* out);

/* The same properties without errors, ages, missing inputs, ticks and margins. */
typedef struct naive_patrol_in {
  double battery_percent;
  double first_x_m, first_y_m, second_x_m, second_y_m;
} naive_patrol_in;
typedef struct naive_patrol_state {
  int charged;
} naive_patrol_state;

void naive_patrol_step(naive_patrol_state* s, const naive_patrol_in* in,
                       int verdicts[HAND_PATROL_MONITORS]);

#ifdef __cplusplus
}
#endif

#endif
