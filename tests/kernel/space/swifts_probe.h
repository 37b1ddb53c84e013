// The course of a robot in space under one command, as the kernel of swifts.rta finds it.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
typedef struct probe_way {
  int32_t usable, count, first;
  int64_t leg_mm, stop_mm;
  int64_t at[16][3], stop[16][3]; /* mm */
} probe_way;
/* At rest in the origin but for its velocity, mm/s; mm/s^2. Errors of 20 mm and 20 mm/s. */
probe_way probe_way_of(const int64_t* velocity, const int64_t* sent, const int64_t* proposed);
#ifdef __cplusplus
}
#endif
