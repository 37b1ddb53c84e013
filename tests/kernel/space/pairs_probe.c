#include PROBE_KERNEL_TEXT

#include "pairs_probe.h"

static spot at(const int64_t* mm) {
  return spot_of(vec_of(mm[0], mm[1]), mm[2]);
}
int64_t probe_spot_gap(const int64_t* a, const int64_t* b) {
  return spot_gap_lo(at(a), at(b));
}
int64_t probe_spot_segment(const int64_t* p, const int64_t* a, const int64_t* b) {
  return spot_segment_lo(at(p), at(a), at(b));
}
int64_t probe_spots_apart(const int64_t* a, const int64_t* b, const int64_t* c, const int64_t* d) {
  return spots_apart_lo(at(a), at(b), at(c), at(d));
}
