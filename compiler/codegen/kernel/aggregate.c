/* Aggregates of a quantity over a window of ticks. As in temporal.c, a function is called once a
 * tick and has no loop; `none` is what a tick that is not remembered counts as. An unknown
 * quantity comes as its declared range, when it has one: then only its bounds are wide. Without
 * one, the result is unknown as long as it is in the window. */
/*= pair_state */
/* A quantity in a ring; lo > hi: it was unknown. */
typedef struct KERNEL_pair {
  int64_t lo, hi;
} KERNEL_pair;
/*= total_state */
/* Running sums over a window, unknown: ticks of it that are; at: place in the ring; why: the latest
 * input that was missing. */
typedef struct KERNEL_total {
  int64_t lo, hi, unknown, at;
  int32_t why;
} KERNEL_total;
/*= change_state */
/* at: place in the ring; why: the latest input that was missing. */
typedef struct KERNEL_change {
  int64_t at;
  int32_t why;
} KERNEL_change;
/*= tally_state */
/* Ticks of a window at which the operand was true (must) and not false (may). */
typedef struct KERNEL_tally {
  int64_t must, may, at;
} KERNEL_tally;
/*= span_bounds : bounds_known span_of span_unknown open_ends */
/* For what works on spans. */
static span span_bounds(bounds a) {
  span s = span_unknown(INPUT_CLOCK);
  if (bounds_known(a)) {
    s = span_of(a.lo, a.hi);
    s.lo_open = a.lo_open;
    s.hi_open = a.hi_open;
  }
  return s;
}
/*= bounds_span : bounds_of bounds_nothing span_type open_ends */
static bounds bounds_span(span a) {
  bounds b = bounds_nothing();
  if (a.input == INPUT_NONE) {
    b = bounds_of(a.lo, a.hi);
    b.lo_open = a.lo_open;
    b.hi_open = a.hi_open;
  }
  return b;
}
/*= kept_of_span : span_type lower_end upper_end */
static KERNEL_kept kept_of_span(span s) {
  KERNEL_kept k;
  k.lo = lower_end(s);
  k.hi = upper_end(s);
  k.reason = REASON_NONE;
  k.input = s.input;
  k.unit = 0;
  k.upper_unit = 0;
  return k;
}
/*= span_kept : span_unknown span_between */
/* An unknown is unknown on both sides, whatever else was in the window. */
static span span_kept(KERNEL_kept k) {
  span s = k.input == INPUT_NONE ? span_between(k.lo, k.hi) : span_unknown(k.input);
  return s;
}
/*= span_fill : span_of */
/* An unknown quantity lies in its declared range. */
static span span_fill(span a, int64_t least, int64_t most) {
  return a.input == INPUT_NONE ? a : span_of(least, most);
}
/*= span_forgotten : span_unknown */
static span span_forgotten(void) {
  return span_unknown(INPUT_CLOCK);
}
/*= least_over : window_join kept_of_span span_kept span_unknown */
/* `none`: what an unknown tick counts as. One that is unknown without bounds makes the result
 * unknown: it decides, because its lower end is less than that of any quantity. */
static span least_over(span x, span none, KERNEL_slide *s, KERNEL_kept *ring, KERNEL_kept *delay,
                       int64_t from, int64_t to, const KERNEL_ticks *t) {
  return span_kept(window_join(kept_of_span(x), kept_of_span(span_unknown(INPUT_CLOCK)),
                               kept_of_span(none), s, ring, delay, from, to, 0, t));
}
/*= greatest_over : least_over span_negate */
static span greatest_over(span x, span none, KERNEL_slide *s, KERNEL_kept *ring,
                          KERNEL_kept *delay, int64_t from, int64_t to, const KERNEL_ticks *t) {
  return span_negate(
      least_over(span_negate(x), span_negate(none), s, ring, delay, from, to, t));
}
/*= pair_of : span_type */
static KERNEL_pair pair_of(span x) {
  KERNEL_pair p;
  p.lo = x.input == INPUT_NONE ? x.lo : 1;
  p.hi = x.input == INPUT_NONE ? x.hi : 0;
  return p;
}
/*= total_add */
/* Takes an entry into the running sums (sign 1) or out of them (-1). */
static void total_add(KERNEL_total *s, KERNEL_pair p, int64_t sign) {
  if (p.lo > p.hi) {
    s->unknown += sign;
  } else {
    s->lo += sign * p.lo;
    s->hi += sign * p.hi;
  }
}
/*= total_start */
static void total_start(KERNEL_total *s) {
  s->lo = 0;
  s->hi = 0;
  s->unknown = 0;
  s->at = 0;
  s->why = INPUT_CLOCK;
}
/*= sum_over : pair_of total_add total_start forgotten_in next_place span_of span_unknown */
/* The ring holds the ticks [now - to, now], and the window slides over it: what enters was put in
 * `from` ticks ago, what leaves is overwritten. `to` is finite. Nothing overflows when
 * |x| * (to - from + 1) < 2^62, for x and for `none` when that is bounded. */
static span sum_over(span x, span none, KERNEL_total *s, KERNEL_pair *ring, int64_t from,
                     int64_t to, const KERNEL_ticks *t) {
  const int64_t lost = forgotten_in(t, from, to);
  if (t->now == t->known) {
    total_start(s);
  }
  if (x.input != INPUT_NONE) {
    s->why = x.input;
  }
  if (t->now - to > t->known) {
    total_add(s, ring[s->at], -1);
  }
  ring[s->at] = pair_of(x);
  if (t->now - from >= t->known) {
    total_add(s, ring[s->at >= from ? s->at - from : s->at - from + to + 1], 1);
  }
  s->at = next_place(s->at, to + 1);
  if (s->unknown > 0 || (lost > 0 && none.input != INPUT_NONE)) {
    return span_unknown(s->why);
  }
  return lost > 0 ? span_of(s->lo + lost * none.lo, s->hi + lost * none.hi)
                  : span_of(s->lo, s->hi);
}
/*= mean_over : sum_over window_start span_scale span_unknown */
/* Over the ticks that there are, rounded outward. */
static span mean_over(span x, span none, KERNEL_total *s, KERNEL_pair *ring, int64_t from,
                      int64_t to, const KERNEL_ticks *t) {
  const int64_t ticks = t->now - from + 1 - window_start(t, to);
  const span sum = sum_over(x, none, s, ring, from, to, t);
  return ticks > 0 ? span_scale(sum, 1, ticks) : span_unknown(INPUT_CLOCK);
}
/*= count_bits : bits_at bits_put forgotten_in next_place span_of */
/* How many ticks of the window the operand was true: at least, and at most. The ring holds
 * [now - to, now], or what has not entered a window without an end. */
static span count_bits(int32_t x, KERNEL_tally *s, uint8_t *ring, int64_t from, int64_t to,
                       const KERNEL_ticks *t) {
  const int64_t size = to < 0 ? from : to + 1;
  int32_t bits = x;
  int32_t left = 0;
  if (t->now == t->known) {
    s->must = 0;
    s->may = 0;
    s->at = 0;
  }
  if (size > 0) {
    const int32_t oldest = bits_at(ring, s->at);
    bits_put(ring, s->at, bits);
    if (to < 0) {
      bits = oldest;
    } else {
      bits = bits_at(ring, s->at >= from ? s->at - from : s->at - from + size);
      left = t->now - to > t->known ? oldest : 0;
    }
    s->at = next_place(s->at, size);
  }
  if (t->now - from < t->known) {
    bits = 0;
  }
  s->must += (bits & 1) - (left & 1);
  s->may += (bits >> 1) - (left >> 1);
  return span_of(s->must, s->may + forgotten_in(t, from, to));
}
/*= count_over : count_bits bits_of */
static span count_over(margin x, KERNEL_tally *s, uint8_t *ring, int64_t from, int64_t to,
                       const KERNEL_ticks *t) {
  return count_bits(bits_of(x), s, ring, from, to, t);
}
/*= change_at : span_of span_unknown */
/* The quantity at an earlier tick. */
static span change_at(KERNEL_pair p, span none, int64_t tick, int32_t why,
                      const KERNEL_ticks *t) {
  if (tick < t->known) {
    return tick < 0 ? span_unknown(INPUT_CLOCK) : none;
  }
  return p.lo > p.hi ? span_unknown(why) : span_of(p.lo, p.hi);
}
/*= change_over : change_at pair_of next_place span_add span_negate */
/* By how much x grew from tick now - to to tick now - from, for 0 <= from < to; exact, so that
 * it is divided, and rounded, but once. The ring holds [now - to, now - 1]. |x| < 2^61. */
static span change_over(span x, span none, KERNEL_change *s, KERNEL_pair *ring, int64_t from,
                        int64_t to, const KERNEL_ticks *t) {
  KERNEL_pair first, last;
  if (t->now == t->known) {
    s->at = 0;
    s->why = INPUT_CLOCK;
  }
  if (x.input != INPUT_NONE) {
    s->why = x.input;
  }
  first = ring[s->at];
  ring[s->at] = pair_of(x);
  last = ring[s->at >= from ? s->at - from : s->at - from + to];
  s->at = next_place(s->at, to);
  return span_add(change_at(last, none, t->now - from, s->why, t),
                  span_negate(change_at(first, none, t->now - to, s->why, t)));
}
