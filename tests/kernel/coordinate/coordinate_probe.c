#include PROBE_KERNEL_TEXT

#include "coordinate_probe.h"

enum { cells_max = probe_monitors_max * probe_monitors_max };

typedef struct scene {
  shared_monitor monitors[probe_monitors_max];
  check checks[probe_monitors_max];
  margin ahead[cells_max];
  ranking by;
} scene;

static void set_up(scene* s, const probe_choice* c) {
  int32_t k;
  for (k = 0; k < c->count; ++k) {
    s->monitors[k].engaged = c->engaged[k];
    s->checks[k].now = c->violated[k] ? margin_of(-2, -1, SHARED_REASON_MARGIN)
                                      : margin_of(-1, 1, SHARED_REASON_MARGIN);
    s->checks[k].ahead = s->checks[k].safer = s->checks[k].gives_back = s->checks[k].now;
  }
  for (k = 0; k < c->count * c->count; ++k) {
    s->ahead[k] = margin_of(c->ahead[k], c->ahead[k] + 1, SHARED_REASON_MARGIN);
  }
  s->by.proved = c->proved;
  s->by.ahead = s->ahead;
  s->by.count = c->count;
}
int32_t probe_coordinate(probe_choice* c) {
  scene s;
  int32_t k, best;
  set_up(&s, c);
  best = coordinate(s.monitors, s.checks, &s.by, c->driving);
  for (k = 0; k < c->count; ++k) {
    c->engaged[k] = s.monitors[k].engaged;
  }
  return best;
}
int32_t probe_kept_prefix(const probe_choice* c, int32_t i) {
  scene s;
  set_up(&s, c);
  return kept_prefix(s.monitors, s.checks, &s.by, i);
}
int32_t probe_keeps_now(const probe_choice* c, int32_t i, int32_t j) {
  scene s;
  set_up(&s, c);
  return keeps_now(s.monitors, s.checks, &s.by, i, j);
}
