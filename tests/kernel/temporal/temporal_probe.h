/* The kernel's operators of the past, one instance at a time, for the tests: their memory comes
 * from the heap, exactly as much as they ask for and full of rubbish. */
#ifndef TESTS_KERNEL_TEMPORAL_PROBE_H
#define TESTS_KERNEL_TEMPORAL_PROBE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  PROBE_PREVIOUSLY,
  PROBE_ONCE,
  PROBE_HISTORICALLY,
  PROBE_SINCE,
  PROBE_LEAST,
  PROBE_GREATEST,
  PROBE_MEAN,
  PROBE_SUM,
  PROBE_COUNT,
  PROBE_CHANGE
};
enum { PROBE_MARGIN_MAX_LOG10 = 18, PROBE_SPAN_MAX_LOG10 = 12 };
enum { PROBE_REASON_NONE, PROBE_REASON_MARGIN, PROBE_REASON_INPUT = 6 };
enum { PROBE_INPUT_NONE, PROBE_INPUT_CLOCK = 7, PROBE_INPUT_FIRST = 8 };

/* A margin or a quantity, as the kernel has it. */
typedef struct probe_value {
  int64_t lo, hi;
  int32_t reason, unit, input, upper_unit;
} probe_value;

typedef struct probe_op probe_op;
/* The window is [now - to, now - from], to < 0: for ever; full: margins instead of verdicts. */
probe_op* probe_new(int32_t kind, int64_t from, int64_t to, int32_t full);
void probe_free(probe_op* op);
/* Makes `to`, of the same kind and window, what `from` is. */
void probe_copy(probe_op* to, const probe_op* from);
/* The next step is tick 0, or that tick with everything before it forgotten. */
void probe_start(probe_op* op);
void probe_forget(probe_op* op, int64_t tick);
/* One tick. b: second operand of `since`; of an aggregate, what a forgotten tick counts as. */
probe_value probe_step(probe_op* op, probe_value a, probe_value b);
/* An unknown quantity as its declared range. */
probe_value probe_fill(probe_value a, int64_t least, int64_t most);

#ifdef __cplusplus
}
#endif

#endif
