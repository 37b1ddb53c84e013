/* One property of the patrol by itself, verdicts alone, as the peer of the benchmark has it, of the
 * inputs that generated code has: what a check costs that notices missing, late and broken samples.
 * A sample must come every tick. */
#ifndef RTAC_BENCH_WATCH_SINGLE_H
#define RTAC_BENCH_WATCH_SINGLE_H

#include "tests/bench/watch/hand/clock.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct hand_pair {
  hand_point first, second;
} hand_pair;
typedef struct hand_single_state {
  hand_clock clock;
  int64_t judged_us; /* time of the last tick */
} hand_single_state;

void hand_single_init(hand_single_state* s);
void hand_fence_step(hand_single_state* s, const hand_point* first, int64_t now_us,
                     int32_t verdict[1]);
void hand_apart_step(hand_single_state* s, const hand_pair* in, int64_t now_us, int32_t verdict[1]);

#ifdef __cplusplus
}
#endif

#endif
