#include "angle_probe.h"

#define MARGIN_MAX INT64_C(1000000000000000000)
#define SPAN_MAX INT64_C(4611686018427387903)
enum { VERDICT_FALSE, VERDICT_UNKNOWN, VERDICT_TRUE };
enum { REASON_NONE, REASON_MARGIN, REASON_WITHIN_ERROR = 5, REASON_INPUT };
enum { INPUT_NONE, INPUT_CLOCK = 7 };
enum { UNIT_NONE };

/* Each uses those before. */
/* clang-format off */
#include "arith.c"
#include "ends.c"
#include "verdict.c"
#include "margin.c"
#include "angle.c"
/* clang-format on */

static probe_span shown(span s) {
  probe_span out;
  out.lo = s.lo;
  out.hi = s.hi;
  out.known = s.input == INPUT_NONE;
  return out;
}

probe_span probe_phase(int64_t lo, int64_t hi, int64_t least, int64_t most) {
  return shown(phase_of(span_of(lo, hi), least, most));
}
probe_span probe_sine(int64_t lo, int64_t hi) {
  return shown(sine_of(span_of(lo, hi)));
}
probe_span probe_cosine(int64_t lo, int64_t hi) {
  return shown(cosine_of(span_of(lo, hi)));
}
probe_span probe_unknown(int32_t cosine) {
  const span phase = phase_of(span_unknown(INPUT_CLOCK), INT64_C(1) << 40, INT64_C(1) << 40);
  return shown(cosine ? cosine_of(phase) : sine_of(phase));
}
