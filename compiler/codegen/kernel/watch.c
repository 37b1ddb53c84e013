/* Monitors without a robot: what a tick sees of its inputs, conditions and quantities.
 * A margin counts halves of a millionth of its scale, one half less for a strict comparison: so the
 * negation of what holds narrowly does not, and no millionth is lost on the way. */
/*= sample_good */
/* The newest sample counts unless its stamp is from the future or before that of an earlier one;
 * that of one without a value is a stamp like others. */
static int32_t sample_good(const KERNEL_signal *s, int64_t *last_us, int64_t now_us) {
  if (s->stamp_us > now_us) {
    return 0;
  }
  if (s->stamp_us < *last_us) {
    return 0;
  }
  *last_us = s->stamp_us;
  return 1;
}
/*= sample_arrived */
/* Whether a sample has come since the last tick. It is no older than any before it: those were not
 * from the future. */
static inline int32_t sample_arrived(const KERNEL_signal *s, int64_t since_us, int64_t now_us) {
  if (s->stamp_us <= since_us) {
    return 0;
  }
  return s->stamp_us <= now_us;
}
/*= tick_follows */
/* Whether this is the tick after the last one, which ended at `*until_us`: the usual case, without a
 * division. Beyond INT64_MAX - period_us there is no such tick. */
static inline int32_t tick_follows(KERNEL_clock *clock, int64_t *until_us, int64_t now_us,
                                   int64_t period_us) {
  if (*until_us > INT64_MAX - period_us ||
      (uint64_t)now_us - (uint64_t)*until_us - 1 >= (uint64_t)period_us) {
    return 0;
  }
  clock->last_us = now_us;
  clock->tick += 1;
  *until_us += period_us;
  return 1;
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
/*= number_within */
/* Whether a number was measured that makes sense, within the declared range. Each question is a
 * branch of its own, hardly ever taken: that is less work than their conjunction. */
static inline int32_t number_within(const KERNEL_signal *s, int64_t least, int64_t most) {
  if (s->lo < least) {
    return 0;
  }
  if (s->hi > most) {
    return 0;
  }
  if (s->lo > s->hi) {
    return 0;
  }
  return 1;
}
/*= bounds_measured : bounds_of */
/* What is measured, widened by the declared error. */
static inline bounds bounds_measured(const KERNEL_signal *s, int64_t error) {
  bounds seen = bounds_of(s->lo - error, s->hi + error);
  seen.lo_open = s->lo < s->hi;
  seen.hi_open = s->lo < s->hi;
  return seen;
}
/*= bounds_number : number_within bounds_measured bounds_nothing */
static inline bounds bounds_number(const KERNEL_signal *s, int32_t fresh, int64_t least,
                                   int64_t most, int64_t error) {
  if (fresh == 0) {
    return bounds_nothing();
  }
  if (s->valid == 0) {
    return bounds_nothing();
  }
  return number_within(s, least, most) ? bounds_measured(s, error) : bounds_nothing();
}
/*= bits_truth : bits_type */
static inline int32_t bits_truth(const KERNEL_signal *s, int32_t fresh) {
  if (fresh != 0 && s->valid != 0 && s->lo == s->hi) {
    if (s->lo == 0) {
      return BITS_FALSE;
    }
    if (s->lo == 1) {
      return BITS_TRUE;
    }
  }
  return BITS_UNKNOWN;
}
/*= age_known : elapsed_us */
/* Time since the stamp of the newest sample; -1 when there is none, or beyond 35 years. */
static inline int64_t age_known(const KERNEL_signal *s, int32_t good, int64_t now_us) {
  const int64_t age_us = good && s->valid != 0 ? elapsed_us(s->stamp_us, now_us) : -1;
  return age_us > AGE_MAX_US ? -1 : age_us;
}
/*= bounds_age : age_known bounds_of bounds_nothing */
static inline bounds bounds_age(const KERNEL_signal *s, int32_t good, int64_t now_us) {
  const int64_t age_us = age_known(s, good, now_us);
  return age_us < 0 ? bounds_nothing() : bounds_of(age_us, age_us);
}
/*= age_span : age_known span_of span_unknown */
static inline span age_span(const KERNEL_signal *s, int32_t good, int64_t now_us, int32_t input) {
  const int64_t age_us = age_known(s, good, now_us);
  return age_us < 0 ? span_unknown(input) : span_of(age_us, age_us);
}
/*= number_of : span_of span_unknown open_ends */
/* The same for margins: unknown for the lack of `input`. */
static inline span number_of(const KERNEL_signal *s, int32_t fresh, int64_t least, int64_t most,
                             int64_t error, int32_t input) {
  span seen;
  if (fresh == 0) {
    return span_unknown(input);
  }
  if (s->valid == 0) {
    return span_unknown(input);
  }
  if (s->lo < least) {
    return span_unknown(input);
  }
  if (s->hi > most) {
    return span_unknown(input);
  }
  if (s->lo > s->hi) {
    return span_unknown(input);
  }
  seen = span_of(s->lo - error, s->hi + error);
  seen.lo_open = s->lo < s->hi;
  seen.hi_open = s->lo < s->hi;
  return seen;
}
/*= truth_of : bits_truth margin_true margin_false margin_unknown */
static inline margin truth_of(const KERNEL_signal *s, int32_t fresh, int32_t input) {
  const int32_t bits = bits_truth(s, fresh);
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
