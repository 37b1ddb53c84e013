#include "tests/bench/watch/hand/windows.h"

#include <string.h>

enum { PERIOD_US = 1000 };
enum { NO = 0, MAYBE = 2, YES = 3 }; /* bit 0: surely, bit 1: perhaps */

/* A new sample every tick, or the condition is unknown. */
static int truth(const hand_number* s, int64_t* last_us, int64_t since_us, int64_t now_us) {
  if (!hand_good(s->stamp_us, last_us, now_us) || s->stamp_us <= since_us) return MAYBE;
  if (!s->valid || s->between) return MAYBE;
  return s->value == 1 ? YES : s->value == 0 ? NO : MAYBE;
}

static void tell(int must, int may, int32_t missing, hand_finding* f) {
  f->unit = 0;
  f->lo = must ? HAND_INFINITE : -HAND_INFINITE;
  f->hi = may ? HAND_INFINITE : -HAND_INFINITE;
  f->verdict = must ? HAND_TRUE : may ? HAND_UNKNOWN : HAND_FALSE;
  f->reason = must ? HAND_NO_REASON : may ? HAND_INPUT : HAND_MARGIN;
  f->input = f->verdict == HAND_UNKNOWN ? missing : HAND_NONE;
}

/* Samples are new when they are stamped after it. */
static int64_t since_when(int first, int64_t elapsed, int64_t before_us, int64_t now_us) {
  return first || elapsed > 1 ? now_us - PERIOD_US : before_us;
}

/* ---- once ---- */
void hand_once_init(hand_once_state* s) {
  s->clock.started = 0;
  s->judged_us = 0;
  s->alarm_us = INT64_MIN;
  s->must = s->may = -1;
  s->why = HAND_CLOCK;
}
void hand_once_step(hand_once_state* s, const hand_number* alarm, int64_t now_us,
                    hand_window_out* out) {
  const int first = !s->clock.started;
  const int64_t before_us = s->judged_us;
  const int64_t elapsed = hand_elapsed(&s->clock, now_us, PERIOD_US);
  const int64_t tick = s->clock.tick, start = tick > HAND_WINDOW_TO ? tick - HAND_WINDOW_TO : 0;
  int now;
  out->tick = tick;
  if (elapsed < 1) {
    tell(0, 1, HAND_CLOCK, &out->finding);
    return;
  }
  if (elapsed > 1) { /* whatever was missed may have been an alarm */
    if (elapsed > HAND_MISSED_MAX + 1) s->must = -1;
    s->may = tick - 1;
    s->why = HAND_CLOCK;
  }
  s->judged_us = now_us;
  now = truth(alarm, &s->alarm_us, since_when(first, elapsed, before_us, now_us), now_us);
  if (now == MAYBE) s->why = HAND_ONCE_ALARM;
  if (now == YES) s->must = tick;
  if (now != NO) s->may = tick;
  tell(s->must >= start, s->may >= start, s->why, &out->finding);
}

/* ---- since ---- */
void hand_since_init(hand_since_state* s) {
  memset(s->ring, NO, sizeof s->ring);
  s->clock.started = 0;
  s->judged_us = 0;
  s->calm_us = s->alarm_us = INT64_MIN;
  s->must = s->may = s->must_break = s->may_break = -1;
  s->why = HAND_CLOCK;
  s->at = 0;
}
static void since_tick(hand_since_state* s, int64_t tick, int calm, int alarm) {
  const int64_t end = tick - HAND_WINDOW_FROM;
  const int then = s->ring[s->at];
  s->ring[s->at] = (uint8_t)alarm;
  s->at = s->at + 1 == HAND_WINDOW_FROM ? 0 : s->at + 1;
  if (calm != YES) s->must_break = tick;
  if (calm == NO) s->may_break = tick;
  if (then == YES) s->must = end;
  if (then != NO) s->may = end;
}
static void since_missed(hand_since_state* s, int64_t elapsed) {
  const int64_t tick = s->clock.tick;
  int64_t k;
  s->why = HAND_CLOCK;
  if (elapsed > HAND_MISSED_MAX + 1) {
    memset(s->ring, MAYBE, sizeof s->ring);
    s->must = s->must_break = s->may_break = -1;
    s->may = tick - 1 - HAND_WINDOW_FROM;
    s->at = 0;
    return;
  }
  for (k = tick - elapsed + 1; k < tick; ++k) since_tick(s, k, MAYBE, MAYBE);
}
void hand_since_step(hand_since_state* s, const hand_number* calm, const hand_number* alarm,
                     int64_t now_us, hand_window_out* out) {
  const int first = !s->clock.started;
  const int64_t before_us = s->judged_us;
  const int64_t elapsed = hand_elapsed(&s->clock, now_us, PERIOD_US);
  const int64_t tick = s->clock.tick, start = tick > HAND_WINDOW_TO ? tick - HAND_WINDOW_TO : 0;
  int64_t fresh_us;
  int is_calm, is_alarm;
  out->tick = tick;
  if (elapsed < 1) {
    tell(0, 1, HAND_CLOCK, &out->finding);
    return;
  }
  if (elapsed > 1) since_missed(s, elapsed);
  fresh_us = since_when(first, elapsed, before_us, now_us);
  s->judged_us = now_us;
  is_calm = truth(calm, &s->calm_us, fresh_us, now_us);
  is_alarm = truth(alarm, &s->alarm_us, fresh_us, now_us);
  if (is_alarm == MAYBE) s->why = HAND_ALARM;
  if (is_calm == MAYBE) s->why = HAND_CALM;
  since_tick(s, tick, is_calm, is_alarm);
  tell(s->must >= start && s->must >= s->must_break, s->may >= start && s->may >= s->may_break,
       s->why, &out->finding);
}
