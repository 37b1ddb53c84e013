// Distances in space as the kernel of pairs.rta finds them. Coordinates in mm, three each.
#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
int64_t probe_spot_gap(const int64_t* a, const int64_t* b);
int64_t probe_spot_segment(const int64_t* p, const int64_t* a, const int64_t* b);
int64_t probe_spots_apart(const int64_t* a, const int64_t* b, const int64_t* c, const int64_t* d);
#ifdef __cplusplus
}
#endif
