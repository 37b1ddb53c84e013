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

static int measured(int64_t at, uint32_t between) {
  return at >= -POSITION_MAX_MM && at <= POSITION_MAX_MM - (int64_t)between;
}
static int arrived(const hand_point* p, int64_t since_us, int64_t now_us) {
  return p->stamp_us > since_us && p->stamp_us <= now_us && p->valid;
}
static uint32_t x_between(const hand_point* p) {
  return p->between & 1;
}
static uint32_t y_between(const hand_point* p) {
  return p->between >> 1 & 1;
}

/* Of what lies between two steps neither limit is met by accident: both are steps. */
static int32_t in_box(int64_t at, uint32_t between) {
  return at >= 0 && at <= BOX_MM - (int64_t)between ? HAND_TRUE : HAND_FALSE;
}
static int32_t both(int32_t a, int32_t b) {
  return a < b ? a : b;
}
void hand_fence_step(hand_single_state* s, const hand_point* first, int64_t now_us,
                     int32_t verdict[1]) {
  int64_t since_us;
  int32_t x, y;
  verdict[0] = HAND_UNKNOWN;
  if (!begin(s, now_us, &since_us) || !arrived(first, since_us, now_us)) return;
  x = measured(first->x, x_between(first)) ? in_box(first->x, x_between(first)) : HAND_UNKNOWN;
  y = measured(first->y, y_between(first)) ? in_box(first->y, y_between(first)) : HAND_UNKNOWN;
  verdict[0] = both(x, y);
}

/* Least and greatest square of a difference. */
static void squared(int64_t a, uint32_t a_between, int64_t b, uint32_t b_between, int64_t* near,
                    int64_t* far) {
  const int64_t lo = a - b - (int64_t)b_between, hi = a + (int64_t)a_between - b;
  const int64_t least = lo > 0 ? lo : hi < 0 ? -hi : 0, most = -lo > hi ? -lo : hi;
  *near += least * least;
  *far += most * most;
}
static int placed(const hand_point* p) {
  return measured(p->x, x_between(p)) && measured(p->y, y_between(p));
}
void hand_apart_step(hand_single_state* s, const hand_pair* in, int64_t now_us,
                     int32_t verdict[1]) {
  const hand_point *a = &in->first, *b = &in->second;
  int64_t since_us, near = 0, far = 0;
  verdict[0] = HAND_UNKNOWN;
  if (!begin(s, now_us, &since_us) || !arrived(a, since_us, now_us) ||
      !arrived(b, since_us, now_us) || !placed(a) || !placed(b)) {
    return;
  }
  squared(a->x, x_between(a), b->x, x_between(b), &near, &far);
  squared(a->y, y_between(a), b->y, y_between(b), &near, &far);
  if (near >= (int64_t)APART_MM * APART_MM) {
    verdict[0] = HAND_TRUE;
  } else if (far <= (int64_t)(APART_MM - 1) * (APART_MM - 1)) {
    verdict[0] = HAND_FALSE;
  }
}
