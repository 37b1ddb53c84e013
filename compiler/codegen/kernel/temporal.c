/* The past: windows over the ticks of a watch. A function is called once a tick and ends after a
 * constant number of steps, whatever the window: there is no loop in this file. A window is the
 * ticks [now - to, now - from], as far as there are any; `to` < 0: since tick 0.
 * What was before `known` is not remembered. It counts as unknown, tick by tick, and is never
 * stored: no state is cleared when the past is forgotten. What works on verdicts is inline: to hand
 * a margin over in memory takes longer than all the rest of it. */
/*= ticks_state */
/* Of a watch, counted from its first step: the present tick, and the first one of those that are
 * remembered. */
typedef struct KERNEL_ticks {
  int64_t now, known;
} KERNEL_ticks;
/*= kept_state */
/* A margin or a quantity that is remembered. */
typedef struct KERNEL_kept {
  int64_t lo, hi;
  int32_t reason, input, unit, upper_unit;
} KERNEL_kept;
/*= sight_state */
/* Latest ticks, up to the end of the window, at which the operand was true (must) and not false
 * (may); -1: none. `at`: place in the ring of verdicts. */
typedef struct KERNEL_sight {
  int64_t must, may, at;
} KERNEL_sight;
/*= witness_state : sight_state kept_state */
/* why: the latest operand that was unknown. */
typedef struct KERNEL_witness {
  KERNEL_sight sight;
  KERNEL_kept why;
} KERNEL_witness;
/*= hold_state : sight_state */
/* Of `since`: the witness, and the latest ticks at which what must hold since then was not true
 * (must) and was false (may); -1: none. */
typedef struct KERNEL_hold {
  KERNEL_sight witness;
  int64_t must, may;
} KERNEL_hold;
/*= bond_state : hold_state kept_state */
typedef struct KERNEL_bond {
  KERNEL_hold hold;
  KERNEL_kept why;
} KERNEL_bond;
/*= slide_state : kept_state */
/* A sliding window in two halves of a ring: `head` joins the half that is being filled, up to `at`,
 * `full` the half before it. `halves`: filled ones, at most 2; base: where the present one starts;
 * wait: place in the ring of what is not in the window yet. */
typedef struct KERNEL_slide {
  KERNEL_kept head, full;
  int64_t at, base, wait;
  int32_t halves;
} KERNEL_slide;
/*= chain_state : slide_state */
/* Margins of `since`: `ever` is that without a window; the windows are those of the two
 * operands. */
typedef struct KERNEL_chain {
  KERNEL_kept ever;
  KERNEL_slide hold, witness;
  int64_t at;
} KERNEL_chain;
/*= ticks_start */
static void ticks_start(KERNEL_ticks *t) {
  t->now = 0;
  t->known = 0;
}
/*= ticks_forget */
/* What was before `tick`, which comes next, is unknown from now on. */
static void ticks_forget(KERNEL_ticks *t, int64_t tick) {
  t->now = tick;
  t->known = tick;
}
/*= window_start : max_of */
static int64_t window_start(const KERNEL_ticks *t, int64_t to) {
  return to < 0 ? 0 : max_of(0, t->now - to);
}
/*= forgotten_in : min_of max_of window_start */
/* How many ticks of the window are not remembered. */
static int64_t forgotten_in(const KERNEL_ticks *t, int64_t from, int64_t to) {
  return max_of(0, min_of(t->known, t->now - from + 1) - window_start(t, to));
}
/*= kept_of : margin_type atom_units */
static KERNEL_kept kept_of(margin m) {
  KERNEL_kept k;
  k.lo = m.lo;
  k.hi = m.hi;
  k.reason = m.reason;
  k.input = m.input;
  k.unit = m.unit;
  k.upper_unit = m.upper_unit;
  return k;
}
/*= margin_kept : margin_type atom_units */
static margin margin_kept(KERNEL_kept k) {
  margin m;
  m.lo = k.lo;
  m.hi = k.hi;
  m.reason = k.reason;
  m.input = k.input;
  /*? about_robots */ m.index = 0;
  /*? about_robots */ m.other = -1;
  m.unit = k.unit;
  m.upper_unit = k.upper_unit;
  return m;
}
/*= kept_join */
/* The greater or the lesser of both ends, of an older and a newer entry. What it tells is of the
 * lower end, but `upper_unit`; of equal ends the newer decides, unless the input of the older is
 * missing, which is worth telling. */
static KERNEL_kept kept_join(KERNEL_kept a, KERNEL_kept b, int32_t greatest) {
  const int32_t lower = greatest ? b.lo > a.lo : b.lo < a.lo;
  const int32_t upper = greatest ? b.hi >= a.hi : b.hi <= a.hi;
  KERNEL_kept k = lower || (b.lo == a.lo && a.input == INPUT_NONE) ? b : a;
  k.hi = upper ? b.hi : a.hi;
  k.upper_unit = upper ? b.upper_unit : a.upper_unit;
  return k;
}
/*= bits_of : margin_type */
/* What is known of a condition: bit 0, it is true; bit 1, it is not false. */
static int32_t bits_of(margin m) {
  return (m.lo >= 0 ? 1 : 0) + (m.hi >= 0 ? 2 : 0);
}
/*= bits_not */
static int32_t bits_not(int32_t bits) {
  return (bits & 1 ? 0 : 2) + (bits & 2 ? 0 : 1);
}
/*= bits_at */
static int32_t bits_at(const uint8_t *ring, int64_t at) {
  return (ring[at / 4] >> (at % 4 * 2)) & 3;
}
/*= bits_put */
static void bits_put(uint8_t *ring, int64_t at, int32_t bits) {
  const int32_t shift = (int32_t)(at % 4 * 2);
  ring[at / 4] = (uint8_t)((ring[at / 4] & ~(3 << shift)) | (bits << shift));
}
/*= next_place */
static int64_t next_place(int64_t at, int64_t size) {
  return at + 1 == size ? 0 : at + 1;
}
/*= bits_delay : bits_at bits_put next_place */
/* What was put in `ticks` ticks ago; arbitrary until then. */
static int32_t bits_delay(int32_t bits, uint8_t *ring, int64_t ticks, int64_t *at) {
  int32_t then = bits;
  if (ticks > 0) {
    then = bits_at(ring, *at);
    bits_put(ring, *at, bits);
    *at = next_place(*at, ticks);
  }
  return then;
}
/*= kept_delay : next_place */
static KERNEL_kept kept_delay(KERNEL_kept k, KERNEL_kept *ring, int64_t ticks, int64_t *at) {
  KERNEL_kept then = k;
  if (ticks > 0) {
    then = ring[*at];
    ring[*at] = k;
    *at = next_place(*at, ticks);
  }
  return then;
}
/*= margin_bits : bits_of margin_of atom_units */
/* A verdict as a margin: it is infinite, in the units of the present operand `x`. Its reason is
 * that of x when x says the same, else that of `why`. */
static margin margin_bits(int32_t bits, margin x, const KERNEL_kept *why) {
  margin m = margin_of(bits & 1 ? MARGIN_MAX : -MARGIN_MAX, bits & 2 ? MARGIN_MAX : -MARGIN_MAX,
                       bits == 3 ? REASON_NONE : REASON_MARGIN);
  m.unit = x.unit;
  m.upper_unit = x.upper_unit;
  if (bits != 3 && bits == bits_of(x)) {
    m.reason = x.reason;
    m.input = x.input;
  } else if (bits == 2) {
    m.reason = why->reason;
    m.input = why->input;
  }
  return m;
}
/*= why_known : bits_of kept_of margin_unknown */
/* Keeps the latest operand that was unknown. */
static void why_known(KERNEL_kept *why, margin x, const KERNEL_ticks *t) {
  if (t->now == t->known) {
    *why = kept_of(margin_unknown(INPUT_CLOCK));
  }
  if (bits_of(x) == 2) {
    *why = kept_of(x);
  }
}
/*= sight_start */
static void sight_start(KERNEL_sight *s) {
  s->must = -1;
  s->may = -1;
  s->at = 0;
}
/*= sight_look : bits_delay min_of max_of */
/* Brings the witness up to the end of the window, and returns the latest tick at which the operand
 * may have been true. Only the latest matters: it is the last one to leave the window. */
static int64_t sight_look(int32_t bits, KERNEL_sight *s, uint8_t *ring, int64_t from,
                          const KERNEL_ticks *t) {
  const int64_t end = t->now - from;
  const int32_t then = bits_delay(bits, ring, from, &s->at);
  if (end >= t->known) {
    s->must = then & 1 ? end : s->must;
    s->may = then & 2 ? end : s->may;
  }
  return max_of(s->may, min_of(t->known - 1, end));
}
/*= once_within : sight_start sight_look window_start */
static inline int32_t once_within(int32_t x, KERNEL_sight *s, uint8_t *ring, int64_t from,
                                  int64_t to, const KERNEL_ticks *t) {
  const int64_t start = window_start(t, to);
  int64_t may;
  if (t->now == t->known) {
    sight_start(s);
  }
  may = sight_look(x, s, ring, from, t);
  return (s->must >= start ? 1 : 0) + (may >= start ? 2 : 0);
}
/*= historically_within : once_within bits_not */
/* Never otherwise. */
static inline int32_t historically_within(int32_t x, KERNEL_sight *s, uint8_t *ring, int64_t from,
                                          int64_t to, const KERNEL_ticks *t) {
  return bits_not(once_within(bits_not(x), s, ring, from, to, t));
}
/*= since_within : sight_start sight_look window_start max_of */
/* `hold` at every tick after the latest `x` of the window: at the tick of x itself it need not, so
 * a witness counts from the latest break on. An earlier x is no better: it has left the window
 * sooner, and there are more ticks to hold. */
static inline int32_t since_within(int32_t hold, int32_t x, KERNEL_hold *s, uint8_t *ring,
                                   int64_t from, int64_t to, const KERNEL_ticks *t) {
  const int64_t start = window_start(t, to);
  int64_t may;
  if (t->now == t->known) {
    sight_start(&s->witness);
    s->must = -1; /* a sure witness is never among what is forgotten */
    s->may = -1;
  }
  s->must = hold & 1 ? s->must : t->now;
  s->may = hold & 2 ? s->may : t->now;
  may = sight_look(x, &s->witness, ring, from, t);
  return (s->witness.must >= max_of(start, s->must) ? 1 : 0) +
         (may >= max_of(start, s->may) ? 2 : 0);
}
/*= once_verdict : once_within bits_of why_known margin_bits */
static inline margin once_verdict(margin x, KERNEL_witness *s, uint8_t *ring, int64_t from,
                                  int64_t to, const KERNEL_ticks *t) {
  why_known(&s->why, x, t);
  return margin_bits(once_within(bits_of(x), &s->sight, ring, from, to, t), x, &s->why);
}
/*= historically_verdict : historically_within bits_of why_known margin_bits */
static inline margin historically_verdict(margin x, KERNEL_witness *s, uint8_t *ring,
                                          int64_t from, int64_t to, const KERNEL_ticks *t) {
  why_known(&s->why, x, t);
  return margin_bits(historically_within(bits_of(x), &s->sight, ring, from, to, t), x, &s->why);
}
/*= since_verdict : since_within bits_of why_known margin_bits */
static inline margin since_verdict(margin hold, margin x, KERNEL_bond *s, uint8_t *ring,
                                   int64_t from, int64_t to, const KERNEL_ticks *t) {
  const int32_t bits = bits_of(hold);
  int32_t found;
  why_known(&s->why, bits == 2 ? hold : x, t);
  found = since_within(bits, bits_of(x), &s->hold, ring, from, to, t);
  return margin_bits(found, found == bits ? hold : x, &s->why);
}
/*= once_ever */
/* Without a window the verdict so far is all that there is to remember. */
static inline int32_t once_ever(int32_t x, int32_t *so_far) {
  *so_far = *so_far | x;
  return *so_far;
}
/*= historically_ever */
static inline int32_t historically_ever(int32_t x, int32_t *so_far) {
  *so_far = *so_far & x;
  return *so_far;
}
/*= since_ever */
static inline int32_t since_ever(int32_t hold, int32_t x, int32_t *so_far) {
  *so_far = (*so_far & hold) | x;
  return *so_far;
}
/*= previously_bits */
static inline int32_t previously_bits(int32_t x, int32_t *before) {
  const int32_t then = *before;
  *before = x;
  return then;
}
/*= slide_join : kept_join */
/* Joins the latest `ticks` entries, with `x` the newest one. The window covers what is filled of
 * the present half, all of the half before, and the rest of the one before that, which the
 * present half overwrites entry by entry. Of that rest the joins with everything after it are
 * needed, from the first entry on; they were made from the last entry on, one a tick, while the
 * half before was filled. So the ring is `ticks` entries, or one less when odd, and a tick takes
 * four joins: two stacks that change roles every half window, neither of which is ever turned
 * over at once. */
static KERNEL_kept slide_join(KERNEL_kept x, KERNEL_slide *s, KERNEL_kept *ring, int64_t ticks,
                              int32_t greatest) {
  const int64_t half = ticks / 2;
  const int64_t rest = s->at + 1 - ticks % 2;
  const int64_t back = half - 1 - s->at;
  KERNEL_kept *present, *before, all;
  if (half == 0) {
    return x;
  }
  present = ring + s->base;
  before = ring + (half - s->base);
  s->head = s->at == 0 ? x : kept_join(s->head, x, greatest);
  all = s->halves > 0 ? kept_join(s->full, s->head, greatest) : s->head;
  if (s->halves > 1 && rest < half) {
    all = kept_join(present[rest], all, greatest);
  }
  if (s->halves > 0 && s->at > 0) {
    before[back] = kept_join(before[back], before[back + 1], greatest);
  }
  present[s->at] = x;
  s->at += 1;
  if (s->at == half) {
    s->full = s->head;
    s->base = half - s->base;
    s->at = 0;
    s->halves = s->halves < 2 ? s->halves + 1 : 2;
  }
  return all;
}
/*= ever_join : kept_join */
/* Joins all entries so far. */
static KERNEL_kept ever_join(KERNEL_kept x, KERNEL_slide *s, int32_t greatest) {
  s->head = s->halves == 0 ? x : kept_join(s->head, x, greatest);
  s->halves = 1;
  return s->head;
}
/*= window_join : slide_join ever_join kept_join kept_delay forgotten_in */
/* `empty`: the result when there is no tick in the window; forgotten: what a tick that is not
 * remembered counts as. */
static KERNEL_kept window_join(KERNEL_kept x, KERNEL_kept empty, KERNEL_kept forgotten,
                               KERNEL_slide *s, KERNEL_kept *ring, KERNEL_kept *delay,
                               int64_t from, int64_t to, int32_t greatest, const KERNEL_ticks *t) {
  const int64_t end = t->now - from;
  KERNEL_kept all;
  if (t->now == t->known) {
    s->at = 0;
    s->base = 0;
    s->wait = 0;
    s->halves = 0;
  }
  all = kept_delay(x, delay, from, &s->wait);
  if (end < t->known) {
    return end < 0 ? empty : forgotten;
  }
  all = to < 0 ? ever_join(all, s, greatest) : slide_join(all, s, ring, to - from + 1, greatest);
  return forgotten_in(t, from, to) > 0 ? kept_join(forgotten, all, greatest) : all;
}
/*= once_margin : window_join kept_of margin_kept margin_false margin_unknown */
static margin once_margin(margin x, KERNEL_slide *s, KERNEL_kept *ring, KERNEL_kept *delay,
                          int64_t from, int64_t to, const KERNEL_ticks *t) {
  return margin_kept(window_join(kept_of(x), kept_of(margin_false()),
                                 kept_of(margin_unknown(INPUT_CLOCK)), s, ring, delay, from, to, 1,
                                 t));
}
/*= historically_margin : window_join kept_of margin_kept margin_true margin_unknown */
static margin historically_margin(margin x, KERNEL_slide *s, KERNEL_kept *ring,
                                  KERNEL_kept *delay, int64_t from, int64_t to,
                                  const KERNEL_ticks *t) {
  return margin_kept(window_join(kept_of(x), kept_of(margin_true()),
                                 kept_of(margin_unknown(INPUT_CLOCK)), s, ring, delay, from, to, 0,
                                 t));
}
/*= kept_true : kept_of margin_true */
static KERNEL_kept kept_true(void) {
  return kept_of(margin_true());
}
/*= kept_false : kept_of margin_false */
static KERNEL_kept kept_false(void) {
  return kept_of(margin_false());
}
/*= kept_forgotten : kept_of margin_unknown */
static KERNEL_kept kept_forgotten(void) {
  return kept_of(margin_unknown(INPUT_CLOCK));
}
/*= once_margin_ever : kept_join kept_of margin_kept */
/* Without a window the margin so far is all that there is to remember. */
static inline margin once_margin_ever(margin x, KERNEL_kept *so_far) {
  *so_far = kept_join(*so_far, kept_of(x), 1);
  return margin_kept(*so_far);
}
/*= historically_margin_ever : kept_join kept_of margin_kept */
static inline margin historically_margin_ever(margin x, KERNEL_kept *so_far) {
  *so_far = kept_join(*so_far, kept_of(x), 0);
  return margin_kept(*so_far);
}
/*= since_margin_ever : kept_join kept_of margin_kept */
static inline margin since_margin_ever(margin hold, margin x, KERNEL_kept *so_far) {
  *so_far = kept_join(kept_join(*so_far, kept_of(hold), 0), kept_of(x), 1);
  return margin_kept(*so_far);
}
/*= since_margin : window_join kept_join kept_delay kept_of margin_kept margin_false margin_true margin_unknown */
/* With h the margin of `hold` and m that of x, the margin is the greatest over j in [i - b, i - a]
 * of min(m(j), least h over (j, i]). Splitting (j, i] at c = i - a makes that the smaller one of
 * the least h over (c, i], which is `kept`, and of S(c), the same without a delay.
 * And S(c) = min(U, M), with U over all j up to c and M the greatest m over [c - (b - a), c].
 * It is not more: each j of the window counts in both. It is not less: let U be reached at j.
 * If j is in the window, S(c) >= U. If it is earlier, let M be reached at k > j: the least h over
 * (k, c] is no less than that over (j, c], as there are fewer ticks, so S(c) >= min(M, U).
 * Both ends of a margin are such numbers. */
static margin since_margin(margin hold, margin x, KERNEL_chain *s, KERNEL_kept *holds,
                           KERNEL_kept *witnesses, KERNEL_kept *delay, int64_t from, int64_t to,
                           const KERNEL_ticks *t) {
  const KERNEL_kept forgotten = kept_of(margin_unknown(INPUT_CLOCK));
  const KERNEL_kept never = kept_of(margin_false());
  KERNEL_kept m = kept_of(x);
  KERNEL_kept kept = kept_of(hold);
  if (t->now == t->known) {
    s->at = 0;
    s->ever = t->known > 0 ? forgotten : never;
  }
  s->ever = kept_join(kept_join(s->ever, kept, 0), m, 1);
  if (to >= 0) {
    m = window_join(m, never, forgotten, &s->witness, witnesses, 0, 0, to - from, 1, t);
    m = kept_join(m, s->ever, 0);
  } else {
    m = s->ever;
  }
  if (from == 0) {
    return margin_kept(m);
  }
  kept = window_join(kept, kept_of(margin_true()), forgotten, &s->hold, holds, 0, 0, from - 1, 0,
                     t);
  m = kept_delay(m, delay, from, &s->at);
  if (t->now - from < t->known) {
    m = t->now < from ? never : forgotten;
  }
  return margin_kept(kept_join(m, kept, 0));
}
/*= previously_margin : margin_kept kept_of margin_false margin_unknown */
static margin previously_margin(margin x, KERNEL_kept *s, const KERNEL_ticks *t) {
  margin m = margin_kept(*s);
  if (t->now == t->known) {
    m = t->known > 0 ? margin_unknown(INPUT_CLOCK) : margin_false();
  }
  *s = kept_of(x);
  return m;
}
