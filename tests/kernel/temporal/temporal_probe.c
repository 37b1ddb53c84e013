#include "temporal_probe.h"

#include <stdlib.h>
#include <string.h>

#define MARGIN_MAX INT64_C(1000000000000000000)
#define SPAN_MAX INT64_C(1000000000000)
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
#include "temporal.c"
#include "aggregate.c"
/* clang-format on */

struct probe_op {
  int32_t kind, full;
  int64_t from, to;
  KERNEL_ticks ticks;
  KERNEL_kept previous;
  KERNEL_witness witness;
  KERNEL_bond bond;
  KERNEL_slide slide;
  KERNEL_chain chain;
  KERNEL_total total;
  KERNEL_tally tally;
  KERNEL_change change;
  uint8_t* bits;
  KERNEL_kept *window, *hold, *delay;
  KERNEL_pair* pairs;
};

/* NULL when there is nothing to hold, as in generated code. */
static void* rubbish(int64_t count, size_t size) {
  void* memory;
  if (count <= 0) return NULL;
  memory = malloc((size_t)count * size);
  if (memory == NULL) abort();
  memset(memory, 0xA5, (size_t)count * size);
  return memory;
}
static KERNEL_kept* kept_ring(int64_t count) {
  return (KERNEL_kept*)rubbish(count, sizeof(KERNEL_kept));
}
static void copy_ring(void* to, const void* from, int64_t count, size_t size) {
  if (to != NULL) memcpy(to, from, (size_t)count * size);
}
static int64_t window_entries(int64_t from, int64_t to) {
  return to < 0 ? 0 : (to - from + 1) / 2 * 2;
}

/* Entries of the rings, 0: there is none. */
typedef struct sizes {
  int64_t bits, window, hold, delay, pairs;
} sizes;
static sizes sizes_of(int32_t kind, int64_t from, int64_t to, int32_t full) {
  sizes n = {0, 0, 0, 0, 0};
  if (kind == PROBE_COUNT) {
    n.bits = ((to < 0 ? from : to + 1) + 3) / 4;
  } else if (kind == PROBE_MEAN || kind == PROBE_SUM) {
    n.pairs = to + 1;
  } else if (kind == PROBE_CHANGE) {
    n.pairs = to;
  } else if (full || kind == PROBE_LEAST || kind == PROBE_GREATEST) {
    n.window = window_entries(from, to);
    n.hold = kind == PROBE_SINCE ? window_entries(1, from) : 0;
    n.delay = from;
  } else {
    n.bits = (from + 3) / 4;
  }
  return n;
}

probe_op* probe_new(int32_t kind, int64_t from, int64_t to, int32_t full) {
  probe_op* op = (probe_op*)rubbish(1, sizeof(probe_op));
  const sizes n = sizes_of(kind, from, to, full);
  op->kind = kind;
  op->full = full;
  op->from = from;
  op->to = to;
  op->bits = (uint8_t*)rubbish(n.bits, 1);
  op->window = kept_ring(n.window);
  op->hold = kept_ring(n.hold);
  op->delay = kept_ring(n.delay);
  op->pairs = (KERNEL_pair*)rubbish(n.pairs, sizeof(KERNEL_pair));
  probe_start(op);
  return op;
}
void probe_copy(probe_op* to, const probe_op* from) {
  const sizes n = sizes_of(from->kind, from->from, from->to, from->full);
  const probe_op rings = *to;
  *to = *from;
  to->bits = rings.bits;
  to->window = rings.window;
  to->hold = rings.hold;
  to->delay = rings.delay;
  to->pairs = rings.pairs;
  copy_ring(to->bits, from->bits, n.bits, 1);
  copy_ring(to->window, from->window, n.window, sizeof(KERNEL_kept));
  copy_ring(to->hold, from->hold, n.hold, sizeof(KERNEL_kept));
  copy_ring(to->delay, from->delay, n.delay, sizeof(KERNEL_kept));
  copy_ring(to->pairs, from->pairs, n.pairs, sizeof(KERNEL_pair));
}
void probe_free(probe_op* op) {
  free(op->bits);
  free(op->window);
  free(op->hold);
  free(op->delay);
  free(op->pairs);
  free(op);
}
void probe_start(probe_op* op) {
  ticks_start(&op->ticks);
}
void probe_forget(probe_op* op, int64_t tick) {
  ticks_forget(&op->ticks, tick);
}

static margin to_margin(probe_value v) {
  margin m;
  m.lo = v.lo;
  m.hi = v.hi;
  m.reason = v.reason;
  m.input = v.input;
  m.unit = v.unit;
  m.upper_unit = v.upper_unit;
  return m;
}
static probe_value from_margin(margin m) {
  probe_value v;
  v.lo = m.lo;
  v.hi = m.hi;
  v.reason = m.reason;
  v.input = m.input;
  v.unit = m.unit;
  v.upper_unit = m.upper_unit;
  return v;
}
static span to_span(probe_value v) {
  span s = span_of(v.lo, v.hi);
  s.input = v.input;
  return s;
}
static probe_value from_span(span s) {
  probe_value v;
  v.lo = s.lo;
  v.hi = s.hi;
  v.reason = REASON_NONE;
  v.input = s.input;
  v.unit = 0;
  v.upper_unit = 0;
  return v;
}

static margin step_margin(probe_op* op, margin a, margin b) {
  const KERNEL_ticks* t = &op->ticks;
  switch (op->kind * 2 + (op->full ? 1 : 0)) {
    case PROBE_ONCE * 2:
      return once_verdict(a, &op->witness, op->bits, op->from, op->to, t);
    case PROBE_ONCE * 2 + 1:
      return once_margin(a, &op->slide, op->window, op->delay, op->from, op->to, t);
    case PROBE_HISTORICALLY * 2:
      return historically_verdict(a, &op->witness, op->bits, op->from, op->to, t);
    case PROBE_HISTORICALLY * 2 + 1:
      return historically_margin(a, &op->slide, op->window, op->delay, op->from, op->to, t);
    case PROBE_SINCE * 2:
      return since_verdict(a, b, &op->bond, op->bits, op->from, op->to, t);
    case PROBE_SINCE * 2 + 1:
      return since_margin(a, b, &op->chain, op->hold, op->window, op->delay, op->from, op->to, t);
    default:
      return previously_margin(a, &op->previous, t);
  }
}
static span step_span(probe_op* op, probe_value a, span none) {
  const KERNEL_ticks* t = &op->ticks;
  const span x = to_span(a);
  switch (op->kind) {
    case PROBE_LEAST:
      return least_over(x, none, &op->slide, op->window, op->delay, op->from, op->to, t);
    case PROBE_GREATEST:
      return greatest_over(x, none, &op->slide, op->window, op->delay, op->from, op->to, t);
    case PROBE_MEAN:
      return mean_over(x, none, &op->total, op->pairs, op->from, op->to, t);
    case PROBE_SUM:
      return sum_over(x, none, &op->total, op->pairs, op->from, op->to, t);
    case PROBE_COUNT:
      return count_over(to_margin(a), &op->tally, op->bits, op->from, op->to, t);
    default:
      return change_over(x, none, &op->change, op->pairs, op->from, op->to, t);
  }
}
probe_value probe_step(probe_op* op, probe_value a, probe_value b) {
  const probe_value v = op->kind >= PROBE_LEAST
                            ? from_span(step_span(op, a, to_span(b)))
                            : from_margin(step_margin(op, to_margin(a), to_margin(b)));
  op->ticks.now += 1;
  return v;
}
probe_value probe_fill(probe_value a, int64_t least, int64_t most) {
  return from_span(span_fill(to_span(a), least, most));
}
