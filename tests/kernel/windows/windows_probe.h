/* Openings in pairs from, until (us): those of once, then those of every week, as the kernel wants
 * them: of each kind in order and apart. */
#ifndef RTAC_TESTS_KERNEL_WINDOWS_PROBE_H
#define RTAC_TESTS_KERNEL_WINDOWS_PROBE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { PROBE_OPENINGS_MAX = 16 };
int32_t probe_open(const int64_t* openings_us, int32_t once, int32_t weekly, int64_t at_us);
/* From `from_us` to `to_us`, both included. */
int32_t probe_there(const int64_t* openings_us, int32_t once, int32_t weekly, int64_t from_us,
                    int64_t to_us);
int32_t probe_gone(const int64_t* openings_us, int32_t once, int32_t weekly, int64_t from_us,
                   int64_t to_us);

#ifdef __cplusplus
}
#endif

#endif
