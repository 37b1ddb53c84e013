/* Opens what the kernel asks of zones to tests. A C file of its own, so that the same tests run
 * against the library of the kernel, with sanitizers, and with seeded mistakes. Lengths in mm. */
#ifndef RTAC_TESTS_KERNEL_ZONES_ZONE_PROBE_H
#define RTAC_TESTS_KERNEL_ZONES_ZONE_PROBE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct probe_place {
  int64_t x, y;
} probe_place;
typedef struct probe_box {
  int64_t x0, x1, y0, y1;
} probe_box;
typedef struct probe_span {
  int64_t lo, hi;
} probe_span;
/* The boundary as a place sees it: a place of it and a unit vector inwards. */
typedef struct probe_border {
  probe_place at, inward_q30;
  probe_span gap;
  int32_t inside, nearest;
} probe_border;
typedef struct probe_edge {
  int32_t ax, ay, bx, by, ux_q30, uy_q30;
} probe_edge;
/* The tree of cells; numbers as in the kernel's zone. */
typedef struct probe_tree {
  const uint32_t *words, *lists;
  int32_t word_count, list_count;
  int32_t x, y, shift, column, row, columns, rows, depth, leaves;
} probe_tree;
typedef struct probe_tables probe_tables;

enum { PROBE_FALSE, PROBE_UNKNOWN, PROBE_TRUE };
enum { PROBE_LEGS_MAX = 8 };

/* Kernels with a zone of many edges have trees; small ones have edges alone. */
int32_t probe_has_trees(void);
/* Copies the tables. */
probe_tables* probe_tables_new(const probe_edge* edges, int32_t count, const probe_tree* tree);
void probe_tables_free(probe_tables* t);

int32_t probe_inside(const probe_tables* t, probe_place p);
int64_t probe_gap_lo(const probe_tables* t, probe_place p);
/* -1: the leg crosses the boundary. */
int64_t probe_leg_lo(const probe_tables* t, probe_place p, probe_place e);
/* 1: the box lies in the zone; -1: out of it; 0: neither, or it is not known. */
int32_t probe_box_in(const probe_tables* t, probe_box b);
/* Signed distances from the boundary that places of the box have. */
probe_span probe_box_clearance(const probe_tables* t, probe_box b);
/* Verdict of a plan that keeps `need_mm` to the boundary. */
int32_t probe_plan_in(const probe_tables* t, const probe_place* places, int32_t count,
                      int64_t need_mm);
/* Margin of a robot at rest, or under way from p to e: `disc_mm` about p, `capsule_mm` about the
 * leg; either suffices. */
int64_t probe_reach_mm(const probe_tables* t, probe_place p, probe_place e, int64_t disc_mm,
                       int64_t capsule_mm);
/* How far a disc, or for radius 0 a place, may move from p to e; INT64_MAX: all the way. */
int64_t probe_leave_mm(const probe_tables* t, probe_place p, probe_place e, int64_t radius_mm);
probe_border probe_border_of(const probe_tables* t, probe_place p);

#ifdef __cplusplus
}
#endif

#endif
