/* Who drives: engaged sets, priority and return, from what the monitors found. */
#ifndef RTAC_BENCH_HAND_SWITCHING_H
#define RTAC_BENCH_HAND_SWITCHING_H

#include "tests/bench/hand/delivery.h"

enum {
  REASON_NONE = 0,
  REASON_MARGIN = 1,
  REASON_LEG = 3,
  REASON_VIOLATED = 4,
  REASON_WITHIN_ERROR = 5,
  REASON_INPUT = 6,
  REASON_RETURNING = 7,
  REASON_STARTING = 8,
  REASON_OVER_CAPACITY = 9,
  REASON_SURRENDERED = 10,
  REASON_TRACKING = 11
};
enum {
  INPUT_NONE = 0,
  INPUT_POSITION = 1,
  INPUT_VELOCITY = 2,
  INPUT_HEADING = 3,
  INPUT_BATTERY = 4,
  INPUT_PLAN = 5,
  INPUT_OTHER_ROBOT = 6,
  INPUT_CLOCK = 7
};
/* An engaged monitor lets go when it could for more than this many ticks. */
enum { DWELL_TICKS = 1 };

typedef struct margin {
  double low, high;
  hand_finding found;
} margin;
typedef struct check {
  margin now, ahead, safer, gives_back;
} check;

static inline int32_t verdict_of(const margin* m) {
  return m->low >= 0 ? HAND_TRUE : (m->high < 0 ? HAND_FALSE : HAND_UNKNOWN);
}
static inline hand_finding finding_of(const margin* m) {
  hand_finding f = m->found;
  if (f.reason == REASON_MARGIN && m->low < 0 && m->high >= 0) {
    f.reason = REASON_WITHIN_ERROR;
  }
  return f;
}
static inline void engage(hand_monitor* m, int32_t reason, hand_finding found) {
  m->engaged = 1;
  m->dwell = 0;
  m->found = found;
  m->found.reason = reason;
}
static inline int32_t engaging_reason(const check* c, int missed) {
  const int32_t now = verdict_of(&c->now);
  const int32_t reason = finding_of(&c->ahead).reason;
  if (now == HAND_FALSE) {
    return REASON_VIOLATED;
  }
  if (missed || reason == REASON_INPUT) {
    return REASON_INPUT;
  }
  return now == HAND_UNKNOWN && finding_of(&c->now).reason == REASON_WITHIN_ERROR
             ? REASON_WITHIN_ERROR
             : reason;
}
static inline void start_monitor(hand_monitor* m, const check* c) {
  m->engaged = 0;
  if (verdict_of(&c->safer) != HAND_TRUE) {
    const hand_finding safer = finding_of(&c->safer);
    int32_t reason = safer.reason == REASON_INPUT ? REASON_INPUT : REASON_STARTING;
    if (verdict_of(&c->now) == HAND_FALSE) {
      reason = REASON_VIOLATED;
    }
    engage(m, reason, safer);
  }
}
/* An engaged monitor; ticks that were missed count as unknown. */
static inline void keep_engaged(hand_monitor* m, const check* c, int64_t elapsed) {
  const int back = verdict_of(&c->safer) == HAND_TRUE && verdict_of(&c->gives_back) == HAND_TRUE;
  if (verdict_of(&c->now) == HAND_FALSE) {
    m->dwell = 0;
    m->found = finding_of(&c->ahead);
    m->found.reason = REASON_VIOLATED;
  } else if (!back || elapsed > 1) {
    m->dwell = 0;
    m->found = finding_of(&c->safer);
    if (m->found.reason != REASON_INPUT) {
      m->found.reason = REASON_RETURNING;
    }
  } else if (elapsed > 0) {
    m->dwell += 1;
    m->found.reason = REASON_RETURNING;
    if (m->dwell > DWELL_TICKS) {
      m->engaged = 0;
      m->found.reason = REASON_NONE;
    }
  }
}
static inline void step_monitor(hand_monitor* m, const check* c, int first, int64_t elapsed) {
  if (first) {
    start_monitor(m, c);
  } else if (m->engaged) {
    keep_engaged(m, c, elapsed);
  } else if (elapsed > 1 || verdict_of(&c->ahead) != HAND_TRUE ||
             verdict_of(&c->now) == HAND_FALSE) {
    hand_finding found = finding_of(&c->ahead);
    if (elapsed > 1 && found.input == INPUT_NONE) {
      found.input = INPUT_CLOCK;
    }
    engage(m, engaging_reason(c, elapsed > 1), found);
  }
}
static inline int first_engaged(const hand_state* s) {
  int k;
  for (k = 0; k < HAND_MONITORS; ++k) {
    if (s->monitors[k].engaged) {
      return k;
    }
  }
  return -1;
}
static inline int first_not_safer(const check* checks) {
  int k;
  for (k = 0; k < HAND_MONITORS; ++k) {
    if (verdict_of(&checks[k].safer) != HAND_TRUE) {
      return k;
    }
  }
  return -1;
}
/* The way to the charger never leaves the fence: it goes on, as long as that is not false. */
static inline int drives_on(const hand_state* s, const check* checks) {
  return s->mode == HAND_BATTERY + 1 && s->monitors[HAND_BATTERY].engaged &&
         !s->monitors[HAND_COLLISION].engaged &&
         (!s->monitors[HAND_GEOFENCE].engaged ||
          verdict_of(&checks[HAND_GEOFENCE].now) != HAND_FALSE);
}
/* The mode of this tick. When no monitor is engaged but one could not yet hand over, that one
 * takes over, so that somebody works on it. */
static inline int32_t next_mode(hand_state* s, const check* checks, int first, int64_t elapsed,
                                int surrender, int may_leave) {
  int k, open;
  for (k = 0; k < HAND_MONITORS; ++k) {
    step_monitor(&s->monitors[k], &checks[k], first, elapsed);
  }
  if (!first && (elapsed == 0 || elapsed == 1) && drives_on(s, checks)) {
    return s->mode;
  }
  k = first_engaged(s);
  if (k >= 0) {
    return k + 1;
  }
  if (s->mode == 0) {
    return surrender ? 1 : 0;
  }
  if (surrender) {
    return 1;
  }
  open = first_not_safer(checks);
  if (open >= 0) {
    engage(&s->monitors[open], REASON_RETURNING, finding_of(&checks[open].safer));
    return open + 1;
  }
  return may_leave ? 0 : s->mode;
}

#endif
