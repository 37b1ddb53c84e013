/* Margins: intervals that contain the true margin, with what decided them.
 * Unit: millionths of the scale of the dimension (1 m, 1 %), so that connectives can compare. */
/*= atom_units */
/* Margins of several units: each tells that of the atom that decides its lower end, and its upper
 * one; 0: a truth value, which has none. */
/*= about_robots */
/* Margins of what robots do tell the way-point or leg, and the other robot. */
/*= margin_type */
typedef struct margin {
  int64_t lo, hi;
  int32_t reason; /* why it is not true, if it is not */
  int32_t input;  /* input that failed */
  /*? about_robots */ int32_t index; /* way-point or leg */
  /*? about_robots */ int32_t other; /* robot that it is about, -1: none */
  /*? atom_units */ int32_t unit, upper_unit; /* of the atoms that decide its ends */
} margin;
/*= margin_of : margin_type */
static margin margin_of(int64_t lo, int64_t hi, int32_t reason) {
  margin m;
  m.lo = lo;
  m.hi = hi;
  m.reason = reason;
  m.input = INPUT_NONE;
  /*? about_robots */ m.index = 0;
  /*? about_robots */ m.other = -1;
  /*? atom_units */ m.unit = 0;
  /*? atom_units */ m.upper_unit = 0;
  return m;
}
/*= told_unit : margin_type atom_units */
/* That of the lower end as applications are told it: what is infinite for them has none. */
static int32_t told_unit(margin m) {
  const int64_t most = INT64_C(1000000000000000);
  return m.lo > -most && m.lo < most ? m.unit : 0;
}
/*= in_unit : margin_type atom_units */
/* The margin of one atom; connectives keep the unit of the one that decides. */
static inline margin in_unit(margin m, int32_t unit) {
  m.unit = unit;
  m.upper_unit = unit;
  return m;
}
/*= margin_true : margin_of */
/* Nothing to object. */
static margin margin_true(void) {
  return margin_of(MARGIN_MAX, MARGIN_MAX, REASON_NONE);
}
/*= margin_false : margin_of */
static margin margin_false(void) {
  return margin_of(-MARGIN_MAX, -MARGIN_MAX, REASON_MARGIN);
}
/*= margin_unknown : margin_of */
static margin margin_unknown(int32_t input) {
  margin m = margin_of(-MARGIN_MAX, MARGIN_MAX, REASON_INPUT);
  m.input = input;
  return m;
}
/*= margin_and : margin_type min_of */
/* The smaller lower end decides. */
static margin margin_and(margin a, margin b) {
  margin m = b.lo < a.lo ? b : a;
  m.hi = min_of(a.hi, b.hi);
  return m;
}
/*= margin_or : margin_type max_of */
static margin margin_or(margin a, margin b) {
  margin m = b.lo > a.lo ? b : a;
  m.hi = max_of(a.hi, b.hi);
  return m;
}
/*= margin_not : margin_type */
static margin margin_not(margin a) {
  margin m = a;
  m.lo = -a.hi - 1;
  m.hi = -a.lo - 1;
  return m;
}
/*= verdict_of : margin_type */
static int32_t verdict_of(margin m) {
  if (m.lo >= 0) {
    return VERDICT_TRUE;
  }
  return m.hi < 0 ? VERDICT_FALSE : VERDICT_UNKNOWN;
}
/*= reason_of : margin_type */
/* An undecided margin of good inputs is undecided because of the declared errors. */
static int32_t reason_of(margin m) {
  return m.reason == REASON_MARGIN && m.lo < 0 && m.hi >= 0 ? REASON_WITHIN_ERROR : m.reason;
}
/*= open_ends */
/* What is measured between two steps of its grid lies strictly between them: both ends of its
 * interval are open, and stay so in what is compared. Any other end counts as closed, which is less
 * certain. */
/*= span_type */
/* A quantity on its grid, as an interval that contains the true value. `input` names the input
 * that is missing, INPUT_NONE when all were good. */
typedef struct span {
  int64_t lo, hi;
  int32_t input;
  int32_t other;
  /*? open_ends */ int32_t lo_open, hi_open; /* 1: it is never that end itself */
} span;
/*= span_of : span_type */
static span span_of(int64_t lo, int64_t hi) {
  span s;
  s.lo = lo;
  s.hi = hi;
  s.input = INPUT_NONE;
  s.other = -1;
  /*? open_ends */ s.lo_open = 0;
  /*? open_ends */ s.hi_open = 0;
  return s;
}
/*= span_unknown : span_of */
static span span_unknown(int32_t input) {
  span s = span_of(-SPAN_MAX, SPAN_MAX);
  s.input = input;
  return s;
}
/*= lower_end : span_type open_ends */
/* In half steps, an open end half a step inside: such ends are in the order of what they bound. */
static int64_t lower_end(span a) {
  return 2 * a.lo + a.lo_open;
}
/*= upper_end : span_type open_ends */
static int64_t upper_end(span a) {
  return 2 * a.hi - a.hi_open;
}
/*= span_between : span_of bounds_between open_ends */
static span span_between(int64_t lower, int64_t upper) {
  const bounds b = bounds_between(lower, upper);
  span s = span_of(b.lo, b.hi);
  s.lo_open = b.lo_open;
  s.hi_open = b.hi_open;
  return s;
}
/*= span_add : span_type */
static span span_add(span a, span b) {
  span s = a.input != INPUT_NONE ? a : b;
  s.lo = a.lo + b.lo;
  s.hi = a.hi + b.hi;
  s.other = a.other >= 0 ? a.other : b.other;
  /*? open_ends */ s.lo_open = 0;
  /*? open_ends */ s.hi_open = 0;
  return s;
}
/*= span_negate : span_type */
static span span_negate(span a) {
  span s = a;
  s.lo = -a.hi;
  s.hi = -a.lo;
  /*? open_ends */ s.lo_open = a.hi_open;
  /*? open_ends */ s.hi_open = a.lo_open;
  return s;
}
/*= span_ends : span_type ends_of */
static inline ends span_ends(span a) {
  return ends_of(a.lo, a.hi);
}
/*= span_scale : span_ends ends_scaled */
/* An unknown stays what it is: its ends are no measurements, and need not fit the product. */
static span span_scale(span a, int64_t num, int64_t den) {
  span s = a;
  if (a.input == INPUT_NONE) {
    const ends scaled = ends_scaled(span_ends(a), num, den);
    s.lo = scaled.lo;
    s.hi = scaled.hi;
    /*? open_ends */ s.lo_open = num > 0 ? a.lo_open : 0;
    /*? open_ends */ s.hi_open = num > 0 ? a.hi_open : 0;
  }
  return s;
}
/*= span_count : span_type margin_type about_robots */
/* One more robot that is counted: for the lower end when it surely satisfies the condition, for the
 * upper one unless it surely fails. What leaves it open is kept; the ends are numbers all the same. */
static span span_count(span count, margin m) {
  count.lo += m.lo >= 0;
  count.hi += m.hi >= 0;
  if (m.lo < 0 && m.hi >= 0 && m.input != INPUT_NONE) {
    count.input = m.input;
    count.other = m.other;
  }
  return count;
}
/*= count_at_least : span_type margin_of about_robots */
/* a >= b, or a > b when `strict`, of numbers of robots: one of them is the scale. */
static margin count_at_least(span a, span b, int64_t strict) {
  const int32_t input = a.input != INPUT_NONE ? a.input : b.input;
  margin m = margin_of((a.lo - b.hi) * 1000000 - strict, (a.hi - b.lo) * 1000000 - strict,
                       REASON_MARGIN);
  if (m.lo < 0 && m.hi >= 0 && input != INPUT_NONE) {
    m.reason = REASON_INPUT;
    m.input = input;
    m.other = a.other >= 0 ? a.other : b.other;
  }
  return m;
}
/*= margin_at_least : span_type margin_of margin_unknown about_robots */
/* a >= b, or a > b when `strict`; `weight` turns grid units into millionths of the scale. */
static margin margin_at_least(span a, span b, int64_t weight, int64_t strict) {
  margin m;
  if (a.input != INPUT_NONE) {
    m = margin_unknown(a.input);
    m.other = a.other;
    return m;
  }
  if (b.input != INPUT_NONE) {
    m = margin_unknown(b.input);
    m.other = b.other;
    return m;
  }
  m = margin_of((a.lo - b.hi) * weight - strict, (a.hi - b.lo) * weight - strict, REASON_MARGIN);
  m.other = a.other >= 0 ? a.other : b.other;
  return m;
}
