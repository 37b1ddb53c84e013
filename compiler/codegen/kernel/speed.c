/* How fast the robot is and may become. Speeds in mm/s. */
/*= speed_weight */
/* Millionths of the scale, 1 m/s, per mm/s. */
#define WEIGHT_MMPS INT64_C(1000)
/*= fastest_mmps : estimate_type motion_type speed_cap min_of div_up */
/* The greatest speed until `us` after the sample, under the limits of whoever drives. */
static int64_t fastest_mmps(const estimate *s, const motion *m, int64_t us) {
  return min_of(speed_cap(s, m), s->speed_mmps + s->v_error_mmps +
                                     div_up(m->accel_mmps2 * div_up(us, 1000), 1000));
}
/*= speed_now : body_type fastest_mmps span_of span_unknown max_of div_up */
/* It may have slowed down since the sample as hard as it brakes. */
static span speed_now(const estimate *s, const body *b, const motion *m) {
  if (s->input != INPUT_NONE) {
    return span_unknown(s->input);
  } else {
    const int64_t fastest = fastest_mmps(s, m, s->age_us);
    /* 1: the measured speed is rounded up. What was faster than its cap is taken at its word. */
    const int64_t least = s->speed_mmps - 1 - s->v_error_mmps -
                          div_up(b->accel_mmps2 * div_up(s->age_us, 1000), 1000);
    return span_of(min_of(max_of(least, 0), fastest), fastest);
  }
}
/*= speed_reach : speed_weight fastest_mmps margin_of margin_unknown */
/* Never above `most_mmps` before the recovery acts; from then on it only brakes. */
static margin speed_reach(const estimate *s, const motion *m, int64_t horizon_us,
                          int64_t most_mmps) {
  if (s->input != INPUT_NONE) {
    return margin_unknown(s->input);
  } else {
    const int64_t spare = most_mmps - fastest_mmps(s, m, s->age_us + horizon_us);
    return margin_of(spare * WEIGHT_MMPS, spare * WEIGHT_MMPS, REASON_MARGIN);
  }
}
