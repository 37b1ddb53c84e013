/* Monitors without a robot: what a tick sees of its inputs, conditions and quantities.
 * A margin counts halves of a millionth of its scale, one half less for a strict comparison: so the
 * negation of what holds narrowly does not, and no millionth is lost on the way. */
/*= seldom */
/* What is called in unusual ticks only stays apart from what every tick does, which then keeps no
 * registers for it. */
#if defined(__GNUC__)
#define SELDOM __attribute__((cold, noinline))
#else
#define SELDOM
#endif
/*= often */
/* What every tick calls begins where processors begin to fetch: nothing else is to decide that, such
 * as how long the functions before it are. */
#if defined(__GNUC__)
#define OFTEN __attribute__((aligned(64)))
#else
#define OFTEN
#endif
/*= usually */
/* What nearly every tick finds: it comes first in the code, so that no jump leads there. Negated
 * twice, the hint is about each part of a condition; compared with 0, gcc loses it. */
#if defined(__GNUC__)
#define USUALLY(condition) __builtin_expect(!!(condition), 1)
#else
#define USUALLY(condition) (condition)
#endif
/*= sample_good : usually */
/* The newest sample counts unless its stamp is from the future or before that of an earlier one;
 * that of one without a value is a stamp like others. */
static int32_t sample_good(int64_t stamp_us, int64_t *last_us, int64_t now_us) {
  if (!USUALLY(stamp_us <= now_us)) {
    return 0;
  }
  if (!USUALLY(stamp_us >= *last_us)) {
    return 0;
  }
  *last_us = stamp_us;
  return 1;
}
/*= sample_arrived */
/* Whether a sample has come since the last tick. It is no older than any before it: those were not
 * from the future. One that is has an age that wraps around, and is more than any period. */
static inline int32_t sample_arrived(int64_t stamp_us, int64_t since_us, int64_t now_us) {
  return (uint64_t)now_us - (uint64_t)stamp_us < (uint64_t)now_us - (uint64_t)since_us;
}
/*= tick_follows */
/* Whether this is the tick after the last one, which ended at `*until_us`: the usual case, without a
 * division. From INT64_MAX - period_us on there is no such tick. */
static inline int32_t tick_follows(int64_t *until_us, int64_t now_us, int64_t period_us) {
  if (*until_us >= INT64_MAX - period_us ||
      (uint64_t)now_us - (uint64_t)*until_us - 1 >= (uint64_t)period_us) {
    return 0;
  }
  *until_us += period_us;
  return 1;
}
/*= past_end */
/* Whether `us` after a time is past the end of time, which costs no comparison where compilers can
 * ask the sum itself; into `*sum_us` unless it is. */
#if defined(__GNUC__)
#define PAST_END(time_us, us, sum_us) __builtin_add_overflow(time_us, us, sum_us)
#else
#define PAST_END(time_us, us, sum_us) \
  ((time_us) > INT64_MAX - (us) ? 1 : (*(sum_us) = (time_us) + (us), 0))
#endif
/*= tick_due : usually past_end */
/* Whether the tick comes a period after the last one, to the microsecond: then so does its end, and
 * nothing is kept but when the next one is due. Past the end of time none is due: a clock that
 * wraps around would be taken for one that goes on. */
static inline int32_t tick_due(int64_t *due_us, int64_t now_us, int64_t period_us) {
  int64_t next_us;
  if (!USUALLY(now_us == *due_us) || PAST_END(now_us, period_us, &next_us)) {
    return 0;
  }
  *due_us = next_us;
  return 1;
}
/*= never_due */
#define NEVER_DUE INT64_MAX
/*= due_after : elapsed_us never_due */
/* When the next tick is due; NEVER_DUE, from when in 146,000 years ticks might be too many to be
 * counted. */
static int64_t due_after(const KERNEL_clock *clock, int64_t now_us, int64_t period_us) {
  if (now_us > INT64_MAX / 2 || elapsed_us(clock->origin_us, now_us) > INT64_MAX / 2) {
    return NEVER_DUE;
  }
  return now_us + period_us;
}
/*= tick_synced : later due_after */
/* Time, number and end of the last tick, when those that are kept are of the one at `*synced_us`:
 * all after it came when they were due, and the next one is due a period after the last. */
static void tick_synced(KERNEL_clock *clock, int64_t *until_us, int64_t *synced_us,
                        int64_t *due_us, int64_t period_us) {
  int64_t passed_us = 0;
  if (due_after(clock, *synced_us, period_us) != NEVER_DUE) {
    passed_us = (int64_t)((uint64_t)*due_us - (uint64_t)period_us - (uint64_t)*synced_us);
  }
  clock->tick += passed_us / period_us;
  *until_us = later(*until_us, passed_us);
  *synced_us += passed_us;
  *due_us = due_after(clock, *synced_us, period_us);
  clock->last_us = *synced_us;
}
/*= tick_counted */
/* The tick that follows the last one has a number. */
static inline void tick_counted(KERNEL_clock *clock, int64_t now_us) {
  clock->last_us = now_us;
  clock->tick += 1;
}
/*= tick_passed : elapsed_us */
/* Whether the last tick has passed, the number of which is not counted but found from its end. */
static int32_t tick_passed(KERNEL_clock *clock, int64_t until_us, int64_t now_us,
                           int64_t period_us) {
  if (clock->started == 0 || until_us == INT64_MAX) {
    return 1;
  }
  clock->tick = elapsed_us(clock->origin_us, until_us) / period_us;
  return now_us > until_us;
}
/*= tick_until : later */
/* The last time that counts as the present tick: as next_tick counts, to the nearest. */
static int64_t tick_until(const KERNEL_clock *clock, int64_t period_us) {
  if (clock->tick > INT64_MAX / period_us - 2) {
    return INT64_MAX;
  }
  return later(clock->origin_us, clock->tick * period_us + period_us / 2);
}
/*= before */
/* `us` before `time_us`, for us >= 0; the start of time is never passed. */
static int64_t before(int64_t time_us, int64_t us) {
  return time_us < INT64_MIN + us ? INT64_MIN : time_us - us;
}
/*= sample_young */
/* Whether a sample that is not from the future is no older than that, however long ago it was. */
static inline int32_t sample_young(int64_t stamp_us, int64_t now_us, int64_t max_age_us) {
  return (uint64_t)now_us - (uint64_t)stamp_us <= (uint64_t)max_age_us;
}
/*= number_within */
/* Whether a number was measured that makes sense, within the declared range: `at` or, between 1,
 * behind it before the next step. From below the range the difference wraps around, and is more than
 * any range. */
static inline int32_t number_within(int64_t at, int64_t between, int64_t least, int64_t most) {
  const uint64_t steps = (uint64_t)most - (uint64_t)least + 1;
  return (uint64_t)at - (uint64_t)least < steps - (uint64_t)between;
}
/*= number_inside */
/* The same at a glance: in the range, and not its last step, behind which there is none. */
static inline int32_t number_inside(int64_t at, int64_t least, int64_t most) {
  return (uint64_t)at - (uint64_t)least < (uint64_t)most - (uint64_t)least;
}
/*= steps_above */
/* How far a number lies above `least`, in steps; below it that wraps around, and is more than any
 * range. All of several are below a power of 2 when what has the bits of all of them is. */
static inline uint64_t steps_above(int64_t at, int64_t least) {
  return (uint64_t)at - (uint64_t)least;
}
/*= bounds_measured : bounds_of */
/* What is measured, widened by the declared error. */
static inline bounds bounds_measured(int64_t at, int64_t between, int64_t error) {
  bounds seen = bounds_of(at - error, at + between + error);
  seen.lo_open = (int32_t)between;
  seen.hi_open = (int32_t)between;
  return seen;
}
/*= bounds_number : number_within bounds_measured bounds_nothing */
static inline bounds bounds_number(int64_t at, int64_t between, int32_t fresh, int64_t least,
                                   int64_t most, int64_t error) {
  if (fresh == 0) {
    return bounds_nothing();
  }
  return number_within(at, between, least, most) ? bounds_measured(at, between, error)
                                                 : bounds_nothing();
}
/*= bits_truth : bits_type */
static inline int32_t bits_truth(int64_t at, int64_t between, int32_t fresh) {
  if (fresh != 0 && between == 0) {
    if (at == 0) {
      return BITS_FALSE;
    }
    if (at == 1) {
      return BITS_TRUE;
    }
  }
  return BITS_UNKNOWN;
}
/*= age_known : elapsed_us */
/* Time since the stamp of the newest sample; -1 when it has no value, or beyond 35 years. */
static inline int64_t age_known(int64_t stamp_us, int32_t whole, int64_t now_us) {
  const int64_t age_us = whole ? elapsed_us(stamp_us, now_us) : -1;
  return age_us > AGE_MAX_US ? -1 : age_us;
}
/*= bounds_age : age_known bounds_of bounds_nothing */
static inline bounds bounds_age(int64_t stamp_us, int32_t whole, int64_t now_us) {
  const int64_t age_us = age_known(stamp_us, whole, now_us);
  return age_us < 0 ? bounds_nothing() : bounds_of(age_us, age_us);
}
/*= age_span : age_known span_of span_unknown */
static inline span age_span(int64_t stamp_us, int32_t whole, int64_t now_us, int32_t input) {
  const int64_t age_us = age_known(stamp_us, whole, now_us);
  return age_us < 0 ? span_unknown(input) : span_of(age_us, age_us);
}
/*= number_of : span_of span_unknown open_ends */
/* The same for margins: unknown for the lack of `input`. Each question is a branch of its own,
 * hardly ever taken: beside all that follows, that is less work than one comparison of all. */
static inline span number_of(int64_t at, int64_t between, int32_t fresh, int64_t least,
                             int64_t most, int64_t error, int32_t input) {
  span seen;
  if (fresh == 0) {
    return span_unknown(input);
  }
  if (at < least) {
    return span_unknown(input);
  }
  if (at > most - between) {
    return span_unknown(input);
  }
  seen = span_of(at - error, at + between + error);
  seen.lo_open = (int32_t)between;
  seen.hi_open = (int32_t)between;
  return seen;
}
/*= truth_of : bits_truth margin_true margin_false margin_unknown */
static inline margin truth_of(int64_t at, int64_t between, int32_t fresh, int32_t input) {
  const int32_t bits = bits_truth(at, between, fresh);
  if (bits == BITS_UNKNOWN) {
    return margin_unknown(input);
  }
  return bits == BITS_TRUE ? margin_true() : margin_false();
}
/*= tighter : min_of max_of */
/* The tightest value of its range that a parameter was ever given; it tightens upwards when `up`. */
static int64_t tighter(int64_t so_far, int64_t given, int64_t least, int64_t most, int32_t up) {
  if (given < least || given > most) {
    return so_far;
  }
  return up ? max_of(so_far, given) : min_of(so_far, given);
}
/*= both : margin_type atom_units min_of */
/* The smaller end decides; of equal ones that whose input is missing, which is worth telling. */
static margin both(margin a, margin b) {
  margin m = b.lo < a.lo || (b.lo == a.lo && a.input == INPUT_NONE) ? b : a;
  m.hi = min_of(a.hi, b.hi);
  m.upper_unit = b.hi < a.hi ? b.upper_unit : a.upper_unit;
  return m;
}
/*= either : margin_type atom_units max_of */
static margin either(margin a, margin b) {
  margin m = b.lo > a.lo || (b.lo == a.lo && a.input == INPUT_NONE) ? b : a;
  m.hi = max_of(a.hi, b.hi);
  m.upper_unit = b.hi > a.hi ? b.upper_unit : a.upper_unit;
  return m;
}
/*= opposite : margin_not atom_units */
static margin opposite(margin a) {
  margin m = margin_not(a);
  m.unit = a.upper_unit;
  m.upper_unit = a.unit;
  m.reason = a.input != INPUT_NONE ? REASON_INPUT : REASON_MARGIN;
  return m;
}
/*= span_amid : span_of open_ends */
/* A constant that is on no grid, as 45 deg: strictly between two steps. */
static span span_amid(int64_t below, int64_t above) {
  span s = span_of(below, above);
  s.lo_open = 1;
  s.hi_open = 1;
  return s;
}
/*= at_least : margin_unknown in_unit span_type open_ends */
/* a >= b, or a > b when `strict`; `weight`: millionths of the scale in one step of the grid. What is
 * more than an open end is strictly more, and what is less is strictly less. */
static margin at_least(span a, span b, int64_t weight, int64_t strict, int32_t unit) {
  const int32_t missing = a.input != INPUT_NONE ? a.input : b.input;
  margin m = margin_unknown(missing);
  if (missing == INPUT_NONE) {
    m.lo = (a.lo - b.hi) * 2 * weight - (strict & ~(a.lo_open | b.hi_open));
    m.hi = (a.hi - b.lo) * 2 * weight - (strict | a.hi_open | b.lo_open);
    m.reason = REASON_MARGIN;
  }
  return in_unit(m, unit);
}
/*= weighed */
/* steps * num / den millionths as a margin, rounded up or down: not negative when steps > 0, or = 0
 * and not strict. */
static int64_t weighed(int64_t steps, int64_t num, int64_t den, int64_t strict, int64_t up) {
  const int64_t product = steps * num;
  const int64_t whole = product / den - (product % den < 0 ? 1 : 0);
  return product % den == 0 ? 2 * whole - strict : 2 * whole + up;
}
/*= at_least_wide : margin_of margin_unknown in_unit span_type open_ends weighed min_of max_of */
/* The same when a step is num / den millionths, or margins may be too large to be told: then the
 * lower end is less, and the upper end more, than the true ones. */
static margin at_least_wide(span a, span b, int64_t num, int64_t den, int64_t strict,
                            int32_t unit) {
  const int64_t most = (MARGIN_MAX / 2 - 2) / num;
  const int64_t least_gap = a.lo - b.hi;
  const int64_t most_gap = a.hi - b.lo;
  const int32_t missing = a.input != INPUT_NONE ? a.input : b.input;
  margin m = margin_unknown(missing);
  if (missing == INPUT_NONE) {
    const int64_t above = strict & ~(a.lo_open | b.hi_open);
    const int64_t below = strict | a.hi_open | b.lo_open;
    m.lo = least_gap < -most ? -MARGIN_MAX : weighed(min_of(least_gap, most), num, den, above, 0);
    m.hi = most_gap > most ? MARGIN_MAX : weighed(max_of(most_gap, -most), num, den, below, 1);
    m.reason = REASON_MARGIN;
  }
  return in_unit(m, unit);
}
/*= is_value : span_type margin_true margin_false margin_unknown */
static margin is_value(span a, int64_t value) {
  if (a.input != INPUT_NONE || (a.lo != a.hi && a.lo <= value && value <= a.hi)) {
    return margin_unknown(a.input);
  }
  return a.lo == value && a.hi == value ? margin_true() : margin_false();
}
/*= same_value : is_value */
static margin same_value(span a, span b) {
  if (b.input != INPUT_NONE || b.lo != b.hi) {
    return margin_unknown(b.input);
  }
  return is_value(a, b.lo);
}
/*= quantity_missing : span_type span_unknown */
/* What two operands make when one of them is unknown; `*known` is set when neither is. */
static span quantity_missing(span a, span b, int32_t *known) {
  *known = a.input == INPUT_NONE && b.input == INPUT_NONE;
  return span_unknown(a.input != INPUT_NONE ? a.input : b.input);
}
/*= sum_of : quantity_missing span_of open_ends */
static span sum_of(span a, span b) {
  int32_t known;
  span sum = quantity_missing(a, b, &known);
  if (known) {
    sum = span_of(a.lo + b.lo, a.hi + b.hi);
    sum.lo_open = a.lo_open | b.lo_open;
    sum.hi_open = a.hi_open | b.hi_open;
  }
  return sum;
}
/*= span_within : span_of ends_type */
static inline span span_within(ends a) {
  return span_of(a.lo, a.hi);
}
/*= product_of : quantity_missing ends_product span_ends span_within */
static inline span product_of(span a, span b) {
  int32_t known;
  const span missing = quantity_missing(a, b, &known);
  return known ? span_within(ends_product(span_ends(a), span_ends(b))) : missing;
}
/*= absolute_of : span_between lower_end upper_end magnitude min_of max_of span_type */
static span absolute_of(span a) {
  const int64_t lower = lower_end(a);
  const int64_t upper = upper_end(a);
  const int64_t one = magnitude(lower);
  const int64_t two = magnitude(upper);
  if (a.input != INPUT_NONE) {
    return a;
  }
  return span_between(lower <= 0 && upper >= 0 ? 0 : min_of(one, two), max_of(one, two));
}
/*= square_of : ends_square span_ends span_within */
static inline span square_of(span a) {
  return a.input != INPUT_NONE ? a : span_within(ends_square(span_ends(a)));
}
/*= smaller_of : quantity_missing span_between lower_end upper_end min_of */
static span smaller_of(span a, span b) {
  int32_t known;
  const span missing = quantity_missing(a, b, &known);
  return known ? span_between(min_of(lower_end(a), lower_end(b)), min_of(upper_end(a), upper_end(b)))
               : missing;
}
/*= greater_of : quantity_missing span_between lower_end upper_end max_of */
static span greater_of(span a, span b) {
  int32_t known;
  const span missing = quantity_missing(a, b, &known);
  return known ? span_between(max_of(lower_end(a), lower_end(b)), max_of(upper_end(a), upper_end(b)))
               : missing;
}
/*= root_of : ends_root span_ends span_within */
static inline span root_of(span a) {
  return a.input != INPUT_NONE ? a : span_within(ends_root(span_ends(a)));
}
/*= norm_of : quantity_missing ends_squares ends_root span_ends span_within */
static inline span norm_of(span a, span b) {
  int32_t known;
  const span missing = quantity_missing(a, b, &known);
  return known ? span_within(ends_root(ends_squares(span_ends(a), span_ends(b)))) : missing;
}
/*= chosen : quantity_missing span_between lower_end upper_end min_of max_of verdict_of */
/* a where the condition is true, b where it is false, anything of both where it is unknown. */
static span chosen(margin condition, span a, span b) {
  const int32_t verdict = verdict_of(condition);
  int32_t known;
  const span missing = quantity_missing(a, b, &known);
  if (verdict == VERDICT_TRUE) {
    return a;
  }
  if (verdict == VERDICT_FALSE) {
    return b;
  }
  return known ? span_between(min_of(lower_end(a), lower_end(b)), max_of(upper_end(a), upper_end(b)))
               : missing;
}
/*= millionths */
/* Of one end of a margin, up to a whole one. What is infinite becomes MARGIN_MAX / 2, and so does the
 * negation of that. */
static int64_t millionths(int64_t end) {
  return (end + (end & 1)) / 2;
}
/*= finding_judged : verdict_of millionths atom_units */
static inline KERNEL_finding_of finding_judged(margin m) {
  KERNEL_finding_of f;
  f.verdict = verdict_of(m);
  f.reason = REASON_NONE;
  f.input = INPUT_NONE;
  f.unit = m.unit;
  f.lo = millionths(m.lo);
  f.hi = millionths(m.hi);
  if (f.verdict == VERDICT_FALSE) {
    f.reason = REASON_MARGIN;
  } else if (f.verdict == VERDICT_UNKNOWN) {
    f.reason = m.input != INPUT_NONE ? REASON_INPUT : REASON_WITHIN_ERROR;
    f.input = m.input;
  }
  return f;
}
/*= whole_millionths */
/* Rounded down, so that the sign stays; what is infinite stays so. */
static int64_t whole_millionths(int64_t end) {
  if (end <= -MARGIN_MAX) {
    return -MARGIN_MAX;
  }
  if (end >= MARGIN_MAX - 1) {
    return MARGIN_MAX;
  }
  return end >= 0 ? end / 2 : -((1 - end) / 2);
}
/*= fact_margin : margin_type whole_millionths */
/* What a decision makes of a fact: a margin as those of its other atoms. */
static margin fact_margin(margin m) {
  margin f = m;
  f.lo = whole_millionths(m.lo);
  f.hi = whole_millionths(m.hi);
  f.reason = m.input != INPUT_NONE ? REASON_INPUT : REASON_MARGIN;
  /*? about_robots */ f.index = 0;
  /*? about_robots */ f.other = -1;
  return f;
}
/*= half_millionths */
static int64_t half_millionths(int64_t end) {
  if (end <= -(MARGIN_MAX / 2)) {
    return -MARGIN_MAX;
  }
  return end >= MARGIN_MAX / 2 ? MARGIN_MAX : 2 * end;
}
/*= halves_of : margin_type half_millionths */
/* What a fact makes of what is said about the other robots. */
static margin halves_of(margin m) {
  margin h = m;
  h.lo = half_millionths(m.lo);
  h.hi = half_millionths(m.hi);
  return h;
}
