/* Integer arithmetic with a stated rounding direction. Demands round up, supplies round down. */
/*= div_up */
/* Smallest integer >= a / b, for a >= 0 and b > 0. */
static int64_t div_up(int64_t a, int64_t b) {
  return (a + b - 1) / b;
}
/*= min_of */
static int64_t min_of(int64_t a, int64_t b) {
  return a < b ? a : b;
}
/*= max_of */
static int64_t max_of(int64_t a, int64_t b) {
  return a > b ? a : b;
}
/*= clamp_of : min_of max_of */
static int64_t clamp_of(int64_t a, int64_t low, int64_t high) {
  return max_of(low, min_of(a, high));
}
/*= magnitude */
static int64_t magnitude(int64_t a) {
  return a < 0 ? -a : a;
}
/*= elapsed_us */
/* Time from `from` to a later `to`, at most INT64_MAX: stamps may be anything. */
static int64_t elapsed_us(int64_t from, int64_t to) {
  const uint64_t us = (uint64_t)to - (uint64_t)from;
  return us < (uint64_t)INT64_MAX ? (int64_t)us : INT64_MAX;
}
/*= age_of : elapsed_us */
/* For the record; -1: there is nothing, or it is from the future. */
static int64_t age_of(int32_t valid, int64_t stamp_us, int64_t now_us) {
  return valid != 0 && stamp_us <= now_us ? elapsed_us(stamp_us, now_us) : -1;
}
/*= later */
/* `us` after `time_us`, for us >= 0; the end of time is never passed. */
static int64_t later(int64_t time_us, int64_t us) {
  return time_us > INT64_MAX - us ? INT64_MAX : time_us + us;
}
/*= root_down */
/* Largest r with r * r <= a, for 0 <= a < 2^62: digit by digit, two bits a round, from the first
 * digit that is not 0. */
static int64_t root_down(int64_t a) {
  int64_t rest = a;
  int64_t root = 0;
  int64_t bit = 1;
  int32_t i;
  for (i = 32; i > 1; i /= 2) {
    if (rest >> i != 0) {
      rest >>= i;
      bit <<= i;
    }
  }
  rest = a;
  for (i = 0; i < 31 && bit != 0; ++i) {
    const int64_t trial = root + bit;
    const int32_t fits = rest >= trial;
    rest -= fits ? trial : 0;
    root = (root >> 1) + (fits ? bit : 0);
    bit >>= 2;
  }
  return root;
}
/*= root_up : root_down */
static int64_t root_up(int64_t a) {
  const int64_t root = root_down(a);
  return root * root == a ? root : root + 1;
}
