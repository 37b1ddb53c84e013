/* The tables of the generated kernel, for the hand-written step: both look up the same numbers. */
#ifndef RTAC_BENCH_TABLES_H
#define RTAC_BENCH_TABLES_H

#include "tests/bench/hand/delivery.h"

#ifdef __cplusplus
extern "C" {
#endif

void bench_tables_init(hand_tables* t);

#ifdef __cplusplus
}
#endif

#endif
