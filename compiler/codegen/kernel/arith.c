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
  return to < from || (from < 0 && to > INT64_MAX + from) ? INT64_MAX : to - from;
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
/*= root_seed */
/* The root of `top`, 2^14 to 2^16, times 2^8: a parabola that is within 0.6 % of it. */
static uint32_t root_seed(uint32_t top) {
  const uint64_t square = (uint64_t)top * top >> 16;
  return (uint32_t)(16987 + ((uint64_t)top * 68966 >> 16) - (square * 20750 >> 16));
}
/*= root_small : root_seed */
/* As root_down, for 0 <= a < 2^30, in half the time: lengths are mostly below 30 m. */
static inline uint32_t root_small(uint32_t a) {
  uint32_t n = a;
  uint32_t half = 1;
  uint32_t root;
  if (n >> 14 == 0) {
    n <<= 16;
    half += 8;
  }
  if (n >> 22 == 0) {
    n <<= 8;
    half += 4;
  }
  if (n >> 26 == 0) {
    n <<= 4;
    half += 2;
  }
  if (n >> 28 == 0) {
    n <<= 2;
    half += 1;
  }
  root = (root_seed(n >> 14) >> half) + 1;
  root = (root + a / root) / 2;
  return root * root > a ? root - 1 : root;
}
/*= root_large : root_seed */
/* The same of any other. */
static int64_t root_large(uint64_t square) {
  uint64_t n = square;
  uint64_t root;
  int32_t half = 0;
  int32_t i;
  for (i = 16; i > 1; i /= 2) {
    if (n >> (62 - i) == 0) {
      n <<= i;
      half += i / 2;
    }
  }
  root = (((uint64_t)root_seed((uint32_t)(n >> 46)) << 15) >> half) + 1;
  root = (root + square / root) / 2;
  root = (root + square / root) / 2;
  return (int64_t)(root * root > square ? root - 1 : root);
}
/*= root_down : root_small root_large */
/* Largest r with r * r <= a, for 0 <= a < 2^62. a = n / 4^half, with n in [2^60, 2^62) or, of small
 * ones, in [2^28, 2^30); what the leading digits of n give is within 0.6 %. Newton's step makes
 * e^2 / 2 of a relative error e, and is never below the root: one step is less than 1 above roots
 * up to 2^15, two above all of them. */
static inline int64_t root_down(int64_t a) {
  const uint64_t square = (uint64_t)a;
  return square >> 30 == 0 ? (int64_t)root_small((uint32_t)square) : root_large(square);
}
/*= root_up : root_down */
static int64_t root_up(int64_t a) {
  const int64_t root = root_down(a);
  return root * root == a ? root : root + 1;
}
