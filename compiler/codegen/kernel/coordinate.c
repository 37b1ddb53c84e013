/* Who drives under `coordinate` (language rule 12.1): of the recoveries whose monitors are engaged,
 * the one that keeps the longest prefix of the order. */
/*= ranking_type : margin_type */
/* What is known of the recoveries. Entry i * count + j is about the recovery of monitor i and the
 * property of monitor j. */
typedef struct ranking {
  const int32_t *proved; /* the compiler has shown that it keeps it; KEEPS_OWN: its own one */
  const margin *ahead;   /* of monitor j, while the recovery of monitor i drives */
  int32_t count;
} ranking;
/*= keeps_own */
enum { KEEPS_OWN = 2 };
/*= keeps_now : ranking_type keeps_own check_type verdict_of */
/* Out of what is false now only its own recovery leads. What has failed already is kept by those of
 * which it is proved alone, until its monitor lets go: so a recovery that was replaced on account of
 * it does not come back before. All else has to hold within reach of the recovery, too. */
static int32_t keeps_now(const KERNEL_monitor *monitors, const check *checks, const ranking *by,
                         int32_t i, int32_t j) {
  const int32_t at = i * by->count + j;
  if (verdict_of(checks[j].now) == VERDICT_FALSE) {
    return by->proved[at] == KEEPS_OWN;
  }
  return by->proved[at] != 0 ||
         (monitors[j].engaged == 0 && verdict_of(by->ahead[at]) == VERDICT_TRUE);
}
/*= kept_prefix : keeps_now */
/* How many monitors the recovery of monitor i keeps, from the first on. */
static int32_t kept_prefix(const KERNEL_monitor *monitors, const check *checks, const ranking *by,
                           int32_t i) {
  int32_t j = 0;
  while (j < by->count && keeps_now(monitors, checks, by, i, j)) {
    ++j;
  }
  return j;
}
/*= longest_prefix : kept_prefix */
/* The engaged monitor whose recovery keeps the longest prefix; -1: none is engaged. Of equal ones
 * the recovery that drives goes on, else the one whose first unkept monitor has most room drives,
 * else the first. */
static int32_t longest_prefix(const KERNEL_monitor *monitors, const check *checks,
                              const ranking *by, int32_t driving) {
  int32_t i, best = -1, longest = -1;
  int64_t room = 0;
  for (i = 0; i < by->count; ++i) {
    const int32_t kept = monitors[i].engaged != 0 ? kept_prefix(monitors, checks, by, i) : -1;
    const int64_t lo = kept >= 0 && kept < by->count ? by->ahead[i * by->count + kept].lo : 0;
    if (kept > longest ||
        (kept >= 0 && kept == longest && best != driving && (i == driving || lo > room))) {
      best = i;
      longest = kept;
      room = lo;
    }
  }
  return best;
}
/*= concerned : kept_prefix */
/* An idle monitor that has to speak up, as i * count + j: the recovery of monitor i does not keep
 * monitor j, and it is the one to drive; or its prefix ends there, above a monitor that is engaged
 * and would not be kept, so that without j nobody might be found who keeps that. -1: none. */
static int32_t concerned(const KERNEL_monitor *monitors, const check *checks, const ranking *by,
                         int32_t best) {
  int32_t i, j, unkept = 0;
  for (j = 0; j < by->count; ++j) {
    if (!keeps_now(monitors, checks, by, best, j)) {
      if (monitors[j].engaged == 0) {
        return best * by->count + j;
      }
      unkept = j;
    }
  }
  for (i = 0; i < by->count; ++i) {
    if (monitors[i].engaged != 0) {
      j = kept_prefix(monitors, checks, by, i);
      if (j < unkept && monitors[j].engaged == 0) {
        return i * by->count + j;
      }
    }
  }
  return -1;
}
/*= coordinate : longest_prefix concerned engage finding_of */
/* The monitor whose recovery drives; -1: none is engaged. Each round engages a monitor. */
static int32_t coordinate(KERNEL_monitor *monitors, const check *checks, const ranking *by,
                          int32_t driving) {
  int32_t best = longest_prefix(monitors, checks, by, driving);
  int32_t round;
  for (round = 1; best >= 0 && round < by->count; ++round) {
    const int32_t at = concerned(monitors, checks, by, best);
    if (at < 0) {
      break;
    } else {
      const KERNEL_finding found = finding_of(by->ahead[at]);
      engage(&monitors[at % by->count], found.reason, &found);
      best = longest_prefix(monitors, checks, by, driving);
    }
  }
  return best;
}
/*= coordinated_step : check_type monitor_step coordinate first_not_safer engage finding_of */
/* The mode of this tick, as of `mode_step`; but of several engaged monitors it is not the first
 * that drives. */
static int32_t coordinated_step(KERNEL_monitor *monitors, const check *checks, const ranking *by,
                                int32_t mode, int32_t first, int64_t elapsed, int32_t dwell,
                                int32_t surrender, int32_t may_leave) {
  int32_t k, open;
  for (k = 0; k < by->count; ++k) {
    monitor_step(&monitors[k], &checks[k], first, elapsed, dwell);
  }
  k = coordinate(monitors, checks, by, mode - 1);
  if (k >= 0) {
    return k + 1;
  }
  if (mode == 0 || surrender != 0) {
    return surrender;
  }
  open = first_not_safer(checks, by->count);
  if (open >= 0) {
    const KERNEL_finding found = finding_of(checks[open].safer);
    engage(&monitors[open], REASON_RETURNING, &found);
    return coordinate(monitors, checks, by, mode - 1) + 1;
  }
  return may_leave ? 0 : mode;
}
