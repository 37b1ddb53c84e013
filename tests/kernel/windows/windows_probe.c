/* Opens the static functions about times to tests. */
#include "windows_probe.h"

#include WINDOWS_KERNEL_TEXT

static schedule schedule_of(const int64_t* openings_us, int32_t once, int32_t weekly) {
  static opening all[PROBE_OPENINGS_MAX];
  schedule s;
  int32_t k;
  for (k = 0; k < once + weekly; ++k) {
    all[k].from_us = openings_us[2 * k];
    all[k].until_us = openings_us[2 * k + 1];
  }
  s.openings = all;
  s.once = once;
  s.weekly = weekly;
  return s;
}

int32_t probe_open(const int64_t* openings_us, int32_t once, int32_t weekly, int64_t at_us) {
  const schedule s = schedule_of(openings_us, once, weekly);
  return is_open(&s, at_us);
}
int32_t probe_there(const int64_t* openings_us, int32_t once, int32_t weekly, int64_t from_us,
                    int64_t to_us) {
  const schedule s = schedule_of(openings_us, once, weekly);
  return there_from(&s, from_us, to_us);
}
int32_t probe_gone(const int64_t* openings_us, int32_t once, int32_t weekly, int64_t from_us,
                   int64_t to_us) {
  const schedule s = schedule_of(openings_us, once, weekly);
  return gone_from(&s, from_us, to_us);
}
