/* Arithmetic of intervals on the grid, in whole steps, both ends among the values. It is the same
 * for quantities with margins (span) and for verdicts alone (bounds). Results are rounded outward. */
/*= ends_type */
typedef struct ends {
  int64_t lo, hi;
} ends;
/*= ends_of : ends_type */
static inline ends ends_of(int64_t lo, int64_t hi) {
  ends e;
  e.lo = lo;
  e.hi = hi;
  return e;
}
/*= ends_product : ends_of min_of max_of */
static inline ends ends_product(ends a, ends b) {
  return ends_of(min_of(min_of(a.lo * b.lo, a.lo * b.hi), min_of(a.hi * b.lo, a.hi * b.hi)),
                 max_of(max_of(a.lo * b.lo, a.lo * b.hi), max_of(a.hi * b.lo, a.hi * b.hi)));
}
/*= least_square : ends_type */
static inline int64_t least_square(ends a) {
  const int64_t least = a.lo > 0 ? a.lo : (a.hi < 0 ? -a.hi : 0);
  return least * least;
}
/*= most_square : ends_type max_of */
static inline int64_t most_square(ends a) {
  const int64_t most = max_of(-a.lo, a.hi);
  return most * most;
}
/*= ends_square : least_square most_square ends_of */
static inline ends ends_square(ends a) {
  return ends_of(least_square(a), most_square(a));
}
/*= ends_squares : ends_square ends_of */
/* a^2 + b^2. */
static inline ends ends_squares(ends a, ends b) {
  const ends x = ends_square(a);
  const ends y = ends_square(b);
  return ends_of(x.lo + y.lo, x.hi + y.hi);
}
/*= ends_root : root_down root_up ends_of max_of */
/* What is below 0 within its error counts as 0. */
static inline ends ends_root(ends a) {
  return ends_of(root_down(max_of(a.lo, 0)), root_up(max_of(a.hi, 0)));
}
/*= ends_scaled : ends_of min_of max_of */
/* a * num / den, den > 0. */
static inline ends ends_scaled(ends a, int64_t num, int64_t den) {
  const int64_t p = min_of(a.lo * num, a.hi * num);
  const int64_t q = max_of(a.lo * num, a.hi * num);
  return ends_of(p / den - (p % den < 0 ? 1 : 0), q / den + (q % den > 0 ? 1 : 0));
}
