/* Who drives: engaged sets, priority, preemption, return, separation gate, HELD leases.
 * Mode 0 is the advanced controller, mode k + 1 the recovery of monitor k; monitor 0 ranks first. */
/*= check_type : margin_type */
/* What one monitor found in this tick. */
typedef struct check {
  margin now;        /* the property */
  margin ahead;      /* everything within reach under the motion of whoever drives */
  margin safer;      /* the same with a longer horizon, under any control */
  margin gives_back; /* the author's return condition */
} check;
/*= in_order */
/* Stamps must not go backwards. One from the future is refused by its age; it is not remembered,
 * lest a single one shuts out every later sample. */
static int32_t in_order(int64_t stamp_us, int64_t now_us, int64_t *last_us) {
  if (stamp_us < *last_us) {
    return 0;
  }
  if (stamp_us <= now_us) {
    *last_us = stamp_us;
  }
  return 1;
}
/*= says_absent : in_order elapsed_us */
/* Absence is asserted, never inferred from silence: by a message that is fresh and in order. */
static int32_t says_absent(const KERNEL_other *in, int64_t now_us, int64_t max_age_us,
                           int64_t *last_us) {
  return in->presence_us != INT64_MIN && in_order(in->presence_us, now_us, last_us) &&
         in->presence_us <= now_us && elapsed_us(in->presence_us, now_us) <= max_age_us &&
         in->present == 0;
}
/*= promise_kept : later min_of max_of */
/* A promise to stay is not taken back while it lasts; who does that is not to be believed until its
 * last good promise has passed. None is believed beyond `lease_us` from now: one that was given
 * while `now_us` was read and the messages came in may reach a little further, and an endless one,
 * which would be a breach, is worth no more and shuts nobody out for good. */
static int32_t promise_kept(int64_t end_us, int64_t now_us, int64_t lease_us, int64_t *last_us) {
  if (end_us < *last_us && *last_us > now_us) {
    return 0;
  }
  *last_us = max_of(*last_us, min_of(end_us, later(now_us, lease_us)));
  return 1;
}
/*= next_tick : elapsed_us */
/* Ticks since the last step: 0 within the same tick, -1 when the clock went backwards. Ticks are
 * counted from the first step, to the nearest, so that a timer may jitter by half a period; but a
 * gap beyond `longest_us`, which the look-ahead covers, has missed a tick, whatever the count. */
static int64_t next_tick(KERNEL_clock *clock, int64_t now_us, int64_t period_us,
                         int64_t longest_us) {
  int64_t tick, elapsed, gap_us;
  if (clock->started == 0) {
    clock->started = 1;
    clock->origin_us = now_us;
    clock->last_us = now_us;
    clock->tick = 0;
    return 1;
  }
  if (now_us < clock->last_us) {
    return -1;
  }
  gap_us = elapsed_us(clock->last_us, now_us);
  clock->last_us = now_us;
  tick = elapsed_us(clock->origin_us, now_us) / period_us;
  if (elapsed_us(clock->origin_us, now_us) % period_us > period_us / 2) {
    tick += 1;
  }
  elapsed = tick - clock->tick;
  clock->tick = tick;
  return gap_us > longest_us && elapsed < 2 ? 2 : elapsed;
}
/*= sooner : margin_type min_of */
/* The earlier of `us` and of the time that a property of lengths lasts at least, when its margin
 * closes at `mmps` at most; 0: it may be violated already; -1: not known. */
static int64_t sooner(int64_t us, margin now, int64_t mmps) {
  if (us < 0 || now.input != INPUT_NONE) {
    return -1;
  }
  return now.lo <= 0 ? 0 : min_of(us, min_of(now.lo, SPAN_MAX) * 1000 / mmps);
}
/*= engage */
static void engage(KERNEL_monitor *m, int32_t reason, const KERNEL_finding *found) {
  m->engaged = 1;
  m->dwell = 0;
  m->found = *found;
  m->found.reason = reason;
}
/*= finding_of : margin_type reason_of about_robots */
static KERNEL_finding finding_of(margin m) {
  KERNEL_finding f;
  f.reason = reason_of(m);
  f.index = m.index;
  f.input = m.input;
  f.other = m.other;
  return f;
}
/*= engaging_reason : check_type finding_of verdict_of reason_of */
static int32_t engaging_reason(const check *c, int32_t missed) {
  const int32_t now = verdict_of(c->now);
  const int32_t reason = reason_of(c->ahead);
  if (now == VERDICT_FALSE) {
    return REASON_VIOLATED;
  }
  if (missed || reason == REASON_INPUT) {
    return REASON_INPUT;
  }
  return now == VERDICT_UNKNOWN && reason_of(c->now) == REASON_WITHIN_ERROR ? REASON_WITHIN_ERROR
                                                                            : reason;
}
/*= monitor_step : check_type engage engaging_reason finding_of verdict_of */
/* Engages when the look-ahead fails or the property is false, and for ticks that were missed or lie
 * in the past: they count as unknown. Disengages when the derived and the author's return conditions
 * have held for `dwell` ticks. `elapsed`: ticks since the last step. */
static void monitor_step(KERNEL_monitor *m, const check *c, int32_t first, int64_t elapsed,
                         int32_t dwell) {
  const int32_t back = verdict_of(c->safer) == VERDICT_TRUE &&
                       verdict_of(c->gives_back) == VERDICT_TRUE;
  const int32_t violated = verdict_of(c->now) == VERDICT_FALSE;
  const int32_t missed = elapsed > 1 || elapsed < 0;
  KERNEL_finding ahead = finding_of(c->ahead);
  const KERNEL_finding safer = finding_of(c->safer);
  if (missed && ahead.input == INPUT_NONE) {
    ahead.input = INPUT_CLOCK;
  }
  if (first) {
    m->engaged = 0;
    if (verdict_of(c->safer) != VERDICT_TRUE) {
      engage(m, violated ? REASON_VIOLATED
                         : (safer.reason == REASON_INPUT ? REASON_INPUT : REASON_STARTING),
             &safer);
    }
  } else if (m->engaged == 0) {
    if (violated || missed || verdict_of(c->ahead) != VERDICT_TRUE) {
      engage(m, engaging_reason(c, missed), &ahead);
    }
  } else if (violated) {
    m->dwell = 0;
    m->found = ahead;
    m->found.reason = REASON_VIOLATED;
  } else if (!back || missed) {
    m->dwell = 0;
    m->found = safer;
    m->found.reason = safer.reason == REASON_INPUT ? REASON_INPUT : REASON_RETURNING;
  } else if (elapsed > 0) {
    m->dwell += 1;
    m->found.reason = REASON_RETURNING;
    if (m->dwell > dwell) {
      m->engaged = 0;
      m->found.reason = REASON_NONE;
    }
  }
}
/*= first_engaged */
static int32_t first_engaged(const KERNEL_monitor *monitors, int32_t count) {
  int32_t k;
  for (k = 0; k < count; ++k) {
    if (monitors[k].engaged != 0) {
      return k;
    }
  }
  return -1;
}
/*= first_not_safer : check_type verdict_of */
static int32_t first_not_safer(const check *checks, int32_t count) {
  int32_t k;
  for (k = 0; k < count; ++k) {
    if (verdict_of(checks[k].safer) != VERDICT_TRUE) {
      return k;
    }
  }
  return -1;
}
/*= drives_on : check_type verdict_of */
/* Whether a recovery that drives goes on, though a monitor that ranks higher is engaged: its own
 * monitor is, too, and it is shown to keep each such monitor (1 in `keeps`, its row), none of which
 * is false. */
static int32_t drives_on(const KERNEL_monitor *monitors, const check *checks, const int32_t *keeps,
                         int32_t own) {
  int32_t j;
  for (j = 0; j < own; ++j) {
    if (monitors[j].engaged != 0 && (keeps[j] != 1 || verdict_of(checks[j].now) == VERDICT_FALSE)) {
      return 0;
    }
  }
  return monitors[own].engaged != 0;
}
/*= mode_step : check_type monitor_step first_engaged first_not_safer engage finding_of */
/* The mode of this tick. `may_leave`: no lease promises that the robot stays. `surrender`: the mode
 * that the advanced side asks for because it gives control up, else 0. When no monitor is
 * engaged but one could not yet hand over, that one takes over, so that somebody works on it. */
/*? !drives_on */ static int32_t mode_step(KERNEL_monitor *monitors, const check *checks, int32_t count,
/*? !drives_on */                          int32_t mode, int32_t first, int64_t elapsed, int32_t dwell,
/*? !drives_on */                          int32_t surrender, int32_t may_leave) {
/*? drives_on */ static int32_t mode_step(KERNEL_monitor *monitors, const check *checks,
/*? drives_on */                          const int32_t *keeps, int32_t count, int32_t mode,
/*? drives_on */                          int32_t first, int64_t elapsed, int32_t dwell,
/*? drives_on */                          int32_t surrender, int32_t may_leave) {
  int32_t k, open;
  for (k = 0; k < count; ++k) {
    monitor_step(&monitors[k], &checks[k], first, elapsed, dwell);
  }
  k = first_engaged(monitors, count);
  /*? drives_on */ if (k >= 0 && mode > 0 && first == 0 && elapsed >= 0 && elapsed <= 1 &&
  /*? drives_on */     drives_on(monitors, checks, keeps + (mode - 1) * count, mode - 1)) {
  /*? drives_on */   return mode;
  /*? drives_on */ }
  if (k >= 0) {
    return k + 1;
  }
  if (mode == 0) {
    return surrender;
  }
  if (surrender != 0) {
    return surrender;
  }
  open = first_not_safer(checks, count);
  if (open >= 0) {
    const KERNEL_finding found = finding_of(checks[open].safer);
    engage(&monitors[open], REASON_RETURNING, &found);
    return open + 1;
  }
  return may_leave ? 0 : mode;
}
/*= faster_of : motion_type */
/* The driver of two that may move faster; any control before every recovery. */
static int32_t faster_of(const motion *motions, int32_t a, int32_t b) {
  if (motions[a].recovery != motions[b].recovery) {
    return motions[a].recovery == 0 ? a : b;
  }
  return motions[a].speed_mmps >= motions[b].speed_mmps ? a : b;
}
/*= driver_of : motion_type faster_of later */
/* Whose motion bounds what happened since a sample and will happen: an older sample may show the
 * robot before the present driver took over, and the driver before it may have sped up since. */
static int32_t driver_of(const KERNEL_takeover *t, const motion *motions, int32_t mode,
                         int64_t stamp_us, int64_t latency_us) {
  return stamp_us >= later(t->time_us, latency_us) ? mode : faster_of(motions, mode, t->before);
}
/*= other_of : other_type body_type motion_type reach_of later */
/* `may_use`: a promise of this robot may be relied upon, for `lease_us` from now at most. */
static other other_of(const KERNEL_other *in, const estimate *s, const body *b, const motion *any,
                      int64_t horizon_us, int64_t now_us, int64_t lease_us, int32_t may_use) {
  other o;
  /*? is_absent */ o.absent = 0;
  /*? is_far */ o.off_mm = -1;
  /*? is_far */ o.far = 0;
  o.s = *s;
  o.held = may_use && horizon_us <= lease_us && in->lease_end_us >= later(now_us, horizon_us);
  o.r = reach_of(s, b, any, horizon_us);
  return o;
}
/*= gate_of : other_type pair_spare */
/* What the separation test allows a moving recovery: it stands still unless the test holds, or
 * fails only against robots that are HELD (then it may go, away from them). */
static int32_t gate_of(const reach *r, const other *others, int32_t count, int32_t self,
                       const body *b, int64_t least_mm) {
  int32_t gate = GATE_FREE;
  int32_t j;
  for (j = 0; j < count; ++j) {
    /*? is_absent */ if (others[j].absent != 0) {
    /*? is_absent */   continue;
    /*? is_absent */ }
    /*? is_far */ if (others[j].far != 0) {
    /*? is_far */   continue;
    /*? is_far */ }
    if (j != self) {
      if (r->input != INPUT_NONE || others[j].s.input != INPUT_NONE) {
        return GATE_HOLD;
      }
      if (pair_spare(r, &others[j], b) < least_mm) {
        if (others[j].held == 0) {
          return GATE_HOLD;
        }
        gate = GATE_AWAY_ONLY;
      }
    }
  }
  return gate;
}
