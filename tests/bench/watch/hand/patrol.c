#include "tests/bench/watch/hand/patrol.h"

enum { PERIOD_US = 10000, BATTERY_AGE_US = 5000000, POSITION_AGE_US = 200000 };
enum {
  FULL_PPM = 900000,
  RESERVE_PPM = 200000,
  BATTERY_ERROR_PPM = 5000,
  BATTERY_MAX_PPM = 1000000
};
enum { BOX_MM = 5000, APART_MM = 300, POSITION_ERROR_MM = 20, POSITION_MAX_MM = 20000 };
enum { PER_PPM = 100, PER_MM = 1000 }; /* millionths of 1 % and of 1 m */
enum { UNIT_NONE, UNIT_PERCENT, UNIT_METRE };

typedef struct interval {
  int64_t lo, hi;
} interval;

static int64_t least(int64_t a, int64_t b) {
  return a < b ? a : b;
}
static int64_t most(int64_t a, int64_t b) {
  return a > b ? a : b;
}

static int measured(int64_t at, uint32_t between, int64_t lo, int64_t hi, int64_t error,
                    interval* out) {
  out->lo = at - error;
  out->hi = at + (int64_t)between + error;
  return at >= lo && at <= hi - (int64_t)between;
}
static int placed(int64_t at, uint32_t between, interval* out) {
  return measured(at, between, -POSITION_MAX_MM, POSITION_MAX_MM, POSITION_ERROR_MM, out);
}

static hand_margin unknown(int32_t input, int32_t unit) {
  const hand_margin m = {-HAND_INFINITE, HAND_INFINITE, input, unit};
  return m;
}

/* ---- B-1 ---- */
static void charged_tick(hand_margin* s, hand_margin reserve, hand_margin full) {
  hand_margin now = *s;
  if (reserve.lo < now.lo || (reserve.lo == now.lo && now.input == HAND_NONE)) now = reserve;
  now.hi = least(s->hi, reserve.hi);
  if (full.lo > now.lo || (full.lo == now.lo && now.input == HAND_NONE)) {
    now.lo = full.lo;
    now.input = full.input;
    now.unit = full.unit;
  }
  now.hi = most(now.hi, full.hi);
  *s = now;
}
static void charged_known(hand_margin* s, interval battery) {
  hand_margin reserve, full;
  reserve.lo = (battery.lo - RESERVE_PPM) * PER_PPM;
  reserve.hi = (battery.hi - RESERVE_PPM) * PER_PPM;
  reserve.input = HAND_NONE;
  reserve.unit = UNIT_PERCENT;
  full = reserve;
  full.lo = (battery.lo - FULL_PPM) * PER_PPM;
  full.hi = (battery.hi - FULL_PPM) * PER_PPM;
  charged_tick(s, reserve, full);
}

/* ---- B-2 ---- */
static void inside(int known, interval at, hand_margin* m) {
  if (known) {
    m->lo = least(m->lo, least(at.lo, BOX_MM - at.hi) * PER_MM);
    m->hi = least(m->hi, least(at.hi, BOX_MM - at.lo) * PER_MM);
  } else {
    m->lo = -HAND_INFINITE;
    m->input = HAND_FIRST;
  }
}

/* ---- B-3 ---- */
/* Largest r with r * r <= a, for 0 <= a < 2^62, in whole numbers: these monitors and the generated
 * ones are for controllers without floating point, so neither may draw it in hardware. The power of
 * two is within a factor of sqrt(2), and each of Newton's steps makes e^2 / 2 of a relative error
 * e: 6 %, 0.2 %, 2 / 10^6, of which the last is less than 1 below 2^17. */
static uint32_t short_root(uint32_t a) { /* 0 < a < 2^30, below 30 m */
  const int half = (32 - __builtin_clz(a)) / 2;
  uint32_t r = ((UINT32_C(1) << half) + (a >> half)) / 2;
  r = (r + a / r) / 2;
  r = (r + a / r) / 2;
  return r * r > a ? r - 1 : r;
}
static int64_t root(int64_t a) {
  const uint64_t square = (uint64_t)a;
  uint64_t r;
  int half;
  if (a == 0) return 0;
  if (square >> 30 == 0) return short_root((uint32_t)square);
  half = (64 - __builtin_clzll(square)) / 2;
  r = ((UINT64_C(1) << half) + (square >> half)) / 2;
  r = (r + square / r) / 2;
  r = (r + square / r) / 2;
  r = (r + square / r) / 2;
  return (int64_t)(r * r > square ? r - 1 : r);
}
static interval squared_gap(interval a, interval b) {
  const int64_t lo = a.lo - b.hi, hi = a.hi - b.lo;
  const int64_t near = lo > 0 ? lo : hi < 0 ? -hi : 0, far = most(-lo, hi);
  const interval gap = {near * near, far * far};
  return gap;
}
static hand_margin apart(interval ax, interval ay, interval bx, interval by) {
  const interval x = squared_gap(ax, bx), y = squared_gap(ay, by);
  const int64_t near = root(x.lo + y.lo);
  int64_t far = root(x.hi + y.hi);
  hand_margin m;
  if (far * far != x.hi + y.hi) ++far;
  m.lo = (near - APART_MM) * PER_MM;
  m.hi = (far - APART_MM) * PER_MM;
  m.input = HAND_NONE;
  m.unit = UNIT_METRE;
  return m;
}

static void tell(const hand_margin* m, hand_finding* f) {
  f->unit = m->unit;
  f->lo = m->lo;
  f->hi = m->hi;
  f->input = HAND_NONE;
  f->reason = HAND_NO_REASON;
  if (m->lo >= 0) {
    f->verdict = HAND_TRUE;
  } else if (m->hi < 0) {
    f->verdict = HAND_FALSE;
    f->reason = HAND_MARGIN;
  } else {
    f->verdict = HAND_UNKNOWN;
    f->reason = m->input != HAND_NONE ? HAND_INPUT : HAND_WITHIN_ERROR;
    f->input = m->input;
  }
}

void hand_patrol_init(hand_patrol_state* s) {
  s->clock.started = 0;
  s->battery_us = s->first_us = s->second_us = INT64_MIN;
  s->charged.lo = s->charged.hi = -HAND_INFINITE;
  s->charged.input = HAND_NONE;
  s->charged.unit = UNIT_NONE;
}

/* 0: there is no tick to judge. */
static int catch_up(hand_patrol_state* s, int64_t now_us) {
  const int64_t elapsed = hand_elapsed(&s->clock, now_us, PERIOD_US);
  int64_t k;
  if (elapsed < 1) return 0;
  if (elapsed > HAND_MISSED_MAX + 1) {
    s->charged = unknown(HAND_CLOCK, UNIT_NONE);
  } else {
    for (k = 1; k < elapsed; ++k) {
      charged_tick(&s->charged, unknown(HAND_CLOCK, UNIT_PERCENT),
                   unknown(HAND_CLOCK, UNIT_PERCENT));
    }
  }
  return 1;
}

void hand_patrol_step(hand_patrol_state* s, const hand_patrol_in* in, int64_t now_us,
                      hand_patrol_out* out) {
  interval battery = {0, 0}, ax = {0, 0}, ay = {0, 0}, bx = {0, 0}, by = {0, 0};
  hand_margin fence = {HAND_INFINITE, HAND_INFINITE, HAND_NONE, UNIT_METRE};
  hand_margin pair;
  int first, second, first_y, second_y;
  if (!catch_up(s, now_us)) {
    const hand_margin none = unknown(HAND_CLOCK, UNIT_NONE);
    tell(&none, &out->monitors[HAND_CHARGED]);
    tell(&none, &out->monitors[HAND_FENCE]);
    tell(&none, &out->monitors[HAND_APART]);
    out->tick = s->clock.tick;
    return;
  }
  out->tick = s->clock.tick;
  if (hand_good(in->battery.stamp_us, &s->battery_us, now_us) &&
      now_us - in->battery.stamp_us <= BATTERY_AGE_US && in->battery.valid &&
      measured(in->battery.value, in->battery.between & 1, 0, BATTERY_MAX_PPM, BATTERY_ERROR_PPM,
               &battery)) {
    charged_known(&s->charged, battery);
  } else {
    charged_tick(&s->charged, unknown(HAND_BATTERY, UNIT_PERCENT),
                 unknown(HAND_BATTERY, UNIT_PERCENT));
  }
  tell(&s->charged, &out->monitors[HAND_CHARGED]);

  first = hand_good(in->first.stamp_us, &s->first_us, now_us) &&
          now_us - in->first.stamp_us <= POSITION_AGE_US && in->first.valid;
  first_y = first && placed(in->first.y, in->first.between >> 1 & 1, &ay);
  first = first && placed(in->first.x, in->first.between & 1, &ax);
  inside(first, ax, &fence);
  inside(first_y, ay, &fence);
  tell(&fence, &out->monitors[HAND_FENCE]);

  second = hand_good(in->second.stamp_us, &s->second_us, now_us) &&
           now_us - in->second.stamp_us <= POSITION_AGE_US && in->second.valid;
  second_y = second && placed(in->second.y, in->second.between >> 1 & 1, &by);
  second = second && placed(in->second.x, in->second.between & 1, &bx);
  if (first && first_y && second && second_y) {
    pair = apart(ax, ay, bx, by);
  } else { /* the input that is named first, axis by axis */
    pair = unknown(!first || (second && !first_y) ? HAND_FIRST : HAND_SECOND, UNIT_METRE);
  }
  tell(&pair, &out->monitors[HAND_APART]);
}

void naive_patrol_step(naive_patrol_state* s, const naive_patrol_in* in,
                       int verdicts[HAND_PATROL_MONITORS]) {
  const double dx_m = in->first_x_m - in->second_x_m, dy_m = in->first_y_m - in->second_y_m;
  s->charged = in->battery_percent >= 90 || (s->charged && in->battery_percent >= 20);
  verdicts[HAND_CHARGED] = s->charged;
  verdicts[HAND_FENCE] =
      in->first_x_m >= 0 && in->first_x_m <= 5 && in->first_y_m >= 0 && in->first_y_m <= 5;
  verdicts[HAND_APART] = dx_m * dx_m + dy_m * dy_m >= 0.3 * 0.3;
}
