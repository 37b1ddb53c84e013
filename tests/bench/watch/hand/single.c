#include "tests/bench/watch/hand/single.h"

enum { PERIOD_US = 10000, BOX_MM = 5000, APART_MM = 300, POSITION_MAX_MM = 20000 };

void hand_single_init(hand_single_state* s) {
  s->clock.started = 0;
  s->judged_us = 0;
}

/* 0: there is no tick to judge. The usual tick comes a period after the last one, more or less. */
static int begin(hand_single_state* s, int64_t now_us, int64_t* since_us) {
  const int first = !s->clock.started;
  int64_t elapsed;
  *since_us = s->judged_us;
  if (!first && now_us - s->clock.last_us == PERIOD_US) {
    s->clock.last_us = now_us;
    s->clock.tick += 1;
  } else {
    elapsed = hand_elapsed(&s->clock, now_us, PERIOD_US);
    if (elapsed < 1) return 0;
    if (first || elapsed > 1) *since_us = now_us - PERIOD_US;
  }
  s->judged_us = now_us;
  return 1;
}

static int measured(const hand_signal* s) {
  return s->valid && s->lo <= s->hi && s->lo >= -POSITION_MAX_MM && s->hi <= POSITION_MAX_MM;
}
static int arrived(const hand_point* p, int64_t since_us, int64_t now_us) {
  return p->x.stamp_us > since_us && p->x.stamp_us <= now_us;
}

/* What lies between two steps of the grid is never one of them. */
static int32_t in_box(const hand_signal* s) {
  const int64_t open = s->lo < s->hi;
  if (s->lo >= 0 && s->hi <= BOX_MM) return HAND_TRUE;
  return s->hi - open >= 0 && s->lo + open <= BOX_MM ? HAND_UNKNOWN : HAND_FALSE;
}
static int32_t both(int32_t a, int32_t b) {
  return a < b ? a : b;
}
void hand_fence_step(hand_single_state* s, const hand_point* first, int64_t now_us,
                     int32_t verdict[1]) {
  int64_t since_us;
  verdict[0] = HAND_UNKNOWN;
  if (!begin(s, now_us, &since_us) || !arrived(first, since_us, now_us)) return;
  verdict[0] =
      both(measured(&first->x) ? in_box(&first->x) : HAND_UNKNOWN,
           first->y.stamp_us == first->x.stamp_us && measured(&first->y) ? in_box(&first->y)
                                                                         : HAND_UNKNOWN);
}

/* Least and greatest square of a difference. */
static void squared(const hand_signal* a, const hand_signal* b, int64_t* near, int64_t* far) {
  const int64_t lo = a->lo - b->hi, hi = a->hi - b->lo;
  const int64_t least = lo > 0 ? lo : hi < 0 ? -hi : 0, most = -lo > hi ? -lo : hi;
  *near += least * least;
  *far += most * most;
}
void hand_apart_step(hand_single_state* s, const hand_pair* in, int64_t now_us,
                     int32_t verdict[1]) {
  const hand_point *a = &in->first, *b = &in->second;
  int64_t since_us, near = 0, far = 0;
  verdict[0] = HAND_UNKNOWN;
  if (!begin(s, now_us, &since_us) || !arrived(a, since_us, now_us) ||
      !arrived(b, since_us, now_us)) {
    return;
  }
  if (a->y.stamp_us != a->x.stamp_us || b->y.stamp_us != b->x.stamp_us || !measured(&a->x) ||
      !measured(&a->y) || !measured(&b->x) || !measured(&b->y)) {
    return;
  }
  squared(&a->x, &b->x, &near, &far);
  squared(&a->y, &b->y, &near, &far);
  if (near >= (int64_t)APART_MM * APART_MM) {
    verdict[0] = HAND_TRUE;
  } else if (far <= (int64_t)(APART_MM - 1) * (APART_MM - 1)) {
    verdict[0] = HAND_FALSE;
  }
}
