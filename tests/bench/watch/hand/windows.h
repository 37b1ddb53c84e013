/* once[0, 1000] and since[300, 1000], in ticks of 1 ms, as an engineer writes them by hand. */
#ifndef RTAC_BENCH_WATCH_WINDOWS_H
#define RTAC_BENCH_WATCH_WINDOWS_H

#include "tests/bench/watch/hand/clock.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HAND_WINDOW_FROM = 300, HAND_WINDOW_TO = 1000 };
enum { HAND_CALM = 2, HAND_ALARM = 3 }; /* inputs of since */
enum { HAND_ONCE_ALARM = 2 };           /* input of once */

typedef struct hand_window_out {
  int64_t tick;
  hand_finding finding;
} hand_window_out;

typedef struct hand_once_state {
  hand_clock clock;
  int64_t judged_us; /* the last tick */
  int64_t alarm_us;  /* newest stamp */
  int64_t must, may; /* latest ticks with an alarm, and perhaps with one */
  int32_t why;       /* input that was missing last */
} hand_once_state;

void hand_once_init(hand_once_state* s);
void hand_once_step(hand_once_state* s, const hand_number* alarm, int64_t now_us,
                    hand_window_out* out);

typedef struct hand_since_state {
  hand_clock clock;
  int64_t judged_us; /* the last tick */
  int64_t calm_us, alarm_us;
  int64_t must, may;             /* as above, of alarms that are in the window */
  int64_t must_break, may_break; /* latest ticks that were not surely calm, and surely not */
  int32_t why;
  int32_t at;                     /* place in the ring */
  uint8_t ring[HAND_WINDOW_FROM]; /* alarms that are not in the window yet */
} hand_since_state;

void hand_since_init(hand_since_state* s);
void hand_since_step(hand_since_state* s, const hand_number* calm, const hand_number* alarm,
                     int64_t now_us, hand_window_out* out);

#ifdef __cplusplus
}
#endif

#endif
