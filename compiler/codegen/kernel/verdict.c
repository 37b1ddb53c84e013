/* Verdicts without margins. Of a condition two bits are known, of a quantity its bounds; what is
 * unknown needs no name then, nor has a comparison a unit. Verdicts are those of the margins, bit by
 * bit: a margin is not negative exactly when its bit is set. */
/*= bits_type */
/* Bit 0: it is true; bit 1: it is not false. */
enum { BITS_FALSE = 0, BITS_UNKNOWN = 2, BITS_TRUE = 3 };
/*= bounds_type */
/* A quantity on its grid, between bounds that no quantity reaches when nothing is known of it. So a
 * comparison with an unknown needs no case of its own: it is not true, and not false. What is
 * measured between two steps of the grid lies strictly between them: such bounds are open. What is
 * called bounds_... takes any quantities, and makes nothing of nothing; what is called known_... is
 * asked only about those of which something is known. */
typedef struct bounds {
  int64_t lo, hi;
  int32_t lo_open, hi_open; /* 1: it is never that bound itself */
} bounds;
/*= bounds_of : bounds_type */
static inline bounds bounds_of(int64_t lo, int64_t hi) {
  bounds b;
  b.lo = lo;
  b.hi = hi;
  b.lo_open = 0;
  b.hi_open = 0;
  return b;
}
/*= bounds_nothing : bounds_of */
static inline bounds bounds_nothing(void) {
  return bounds_of(-INT64_MAX, INT64_MAX);
}
/*= bounds_amid : bounds_of */
/* A constant that is on no grid, as 45 deg: strictly between two steps. */
static inline bounds bounds_amid(int64_t below, int64_t above) {
  bounds b = bounds_of(below, above);
  b.lo_open = 1;
  b.hi_open = 1;
  return b;
}
/*= bounds_between_steps : bounds_type */
/* Whether what was measured, and widened by `error`, lies between two steps. */
static inline int32_t bounds_between_steps(bounds measured, int64_t error) {
  return measured.lo + error < measured.hi - error;
}
/*= bounds_known : bounds_type */
static inline int32_t bounds_known(bounds a) {
  return a.lo > -INT64_MAX;
}
/*= bounds_ends : bounds_type ends_of */
static inline ends bounds_ends(bounds a) {
  return ends_of(a.lo, a.hi);
}
/*= bounds_within : ends_type bounds_of */
static inline bounds bounds_within(ends a) {
  return bounds_of(a.lo, a.hi);
}
/*= lower_half : bounds_type */
/* In half steps, an open bound half a step inside: such bounds are in the order of what they bound. */
static inline int64_t lower_half(bounds a) {
  return 2 * a.lo + a.lo_open;
}
/*= upper_half : bounds_type */
static inline int64_t upper_half(bounds a) {
  return 2 * a.hi - a.hi_open;
}
/*= bounds_between : bounds_of */
static inline bounds bounds_between(int64_t lower, int64_t upper) {
  bounds b = bounds_of((lower - (lower & 1)) / 2, (upper + (upper & 1)) / 2);
  b.lo_open = lower % 2 != 0;
  b.hi_open = upper % 2 != 0;
  return b;
}
/*= bounds_negative : bounds_of */
static inline bounds bounds_negative(bounds a) {
  bounds b = bounds_of(-a.hi, -a.lo);
  b.lo_open = a.hi_open;
  b.hi_open = a.lo_open;
  return b;
}
/*= known_sum : bounds_of */
static inline bounds known_sum(bounds a, bounds b) {
  bounds sum = bounds_of(a.lo + b.lo, a.hi + b.hi);
  sum.lo_open = a.lo_open | b.lo_open;
  sum.hi_open = a.hi_open | b.hi_open;
  return sum;
}
/*= known_scaled : ends_scaled bounds_ends bounds_within */
static inline bounds known_scaled(bounds a, int64_t num, int64_t den) {
  bounds b = bounds_within(ends_scaled(bounds_ends(a), num, den));
  b.lo_open = num > 0 ? a.lo_open : 0;
  b.hi_open = num > 0 ? a.hi_open : 0;
  return b;
}
/*= known_product : ends_product bounds_ends bounds_within */
static inline bounds known_product(bounds a, bounds b) {
  return bounds_within(ends_product(bounds_ends(a), bounds_ends(b)));
}
/*= known_square : ends_square bounds_ends bounds_within */
static inline bounds known_square(bounds a) {
  return bounds_within(ends_square(bounds_ends(a)));
}
/*= known_squares : ends_squares bounds_ends bounds_within */
static inline bounds known_squares(bounds a, bounds b) {
  return bounds_within(ends_squares(bounds_ends(a), bounds_ends(b)));
}
/*= known_squares_least : least_square bounds_ends */
/* One end of a^2 + b^2 by itself: the other one is seldom asked for. */
static inline int64_t known_squares_least(bounds a, bounds b) {
  return least_square(bounds_ends(a)) + least_square(bounds_ends(b));
}
/*= known_squares_most : most_square bounds_ends */
static inline int64_t known_squares_most(bounds a, bounds b) {
  return most_square(bounds_ends(a)) + most_square(bounds_ends(b));
}
/*= known_root : ends_root bounds_ends bounds_within */
static inline bounds known_root(bounds a) {
  return bounds_within(ends_root(bounds_ends(a)));
}
/*= known_size : lower_half upper_half bounds_between max_of */
static inline bounds known_size(bounds a) {
  const int64_t lower = lower_half(a);
  const int64_t upper = upper_half(a);
  return bounds_between(lower > 0 ? lower : (upper < 0 ? -upper : 0), max_of(-lower, upper));
}
/*= known_least : lower_half upper_half bounds_between min_of */
static inline bounds known_least(bounds a, bounds b) {
  return bounds_between(min_of(lower_half(a), lower_half(b)), min_of(upper_half(a), upper_half(b)));
}
/*= known_greatest : lower_half upper_half bounds_between max_of */
static inline bounds known_greatest(bounds a, bounds b) {
  return bounds_between(max_of(lower_half(a), lower_half(b)), max_of(upper_half(a), upper_half(b)));
}
/*= bounds_sum : known_sum bounds_known bounds_nothing */
static inline bounds bounds_sum(bounds a, bounds b) {
  return bounds_known(a) && bounds_known(b) ? known_sum(a, b) : bounds_nothing();
}
/*= bounds_scaled : known_scaled bounds_known */
static inline bounds bounds_scaled(bounds a, int64_t num, int64_t den) {
  return bounds_known(a) ? known_scaled(a, num, den) : a;
}
/*= bounds_product : known_product bounds_known bounds_nothing */
static inline bounds bounds_product(bounds a, bounds b) {
  return bounds_known(a) && bounds_known(b) ? known_product(a, b) : bounds_nothing();
}
/*= bounds_square : known_square bounds_known */
static inline bounds bounds_square(bounds a) {
  return bounds_known(a) ? known_square(a) : a;
}
/*= bounds_squares : known_squares bounds_known bounds_nothing */
static inline bounds bounds_squares(bounds a, bounds b) {
  return bounds_known(a) && bounds_known(b) ? known_squares(a, b) : bounds_nothing();
}
/*= bounds_root : known_root bounds_known */
static inline bounds bounds_root(bounds a) {
  return bounds_known(a) ? known_root(a) : a;
}
/*= bounds_size : known_size bounds_known */
static inline bounds bounds_size(bounds a) {
  return bounds_known(a) ? known_size(a) : a;
}
/*= bounds_least : known_least bounds_known bounds_nothing */
static inline bounds bounds_least(bounds a, bounds b) {
  return bounds_known(a) && bounds_known(b) ? known_least(a, b) : bounds_nothing();
}
/*= bounds_greatest : known_greatest bounds_known bounds_nothing */
static inline bounds bounds_greatest(bounds a, bounds b) {
  return bounds_known(a) && bounds_known(b) ? known_greatest(a, b) : bounds_nothing();
}
/*= bounds_chosen : lower_half upper_half bounds_between bounds_known bounds_nothing bits_type min_of max_of */
/* a where the condition is true, b where it is false, anything of both where it is unknown. */
static inline bounds bounds_chosen(int32_t condition, bounds a, bounds b) {
  if (condition == BITS_TRUE) {
    return a;
  }
  if (condition == BITS_FALSE) {
    return b;
  }
  return bounds_known(a) && bounds_known(b)
             ? bounds_between(min_of(lower_half(a), lower_half(b)),
                              max_of(upper_half(a), upper_half(b)))
             : bounds_nothing();
}
/*= bits_same : bounds_type bits_type */
static inline int32_t bits_same(bounds a, bounds b) {
  if (b.lo != b.hi) {
    return BITS_UNKNOWN;
  }
  if (a.lo == b.lo && a.hi == b.lo) {
    return BITS_TRUE;
  }
  return a.lo <= b.lo && b.lo <= a.hi ? BITS_UNKNOWN : BITS_FALSE;
}
