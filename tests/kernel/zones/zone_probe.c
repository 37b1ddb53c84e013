#include "zone_probe.h"

#include <stdlib.h>
#include <string.h>

#define MARGIN_MAX INT64_C(1000000000000000000)
#define SPAN_MAX INT64_C(1000000000000)
#define EXTENT_MM INT64_C(536870912)
#define Q30 INT64_C(1073741824)
#define WEIGHT_MM INT64_C(1000)
#define PLAN_CAPACITY PROBE_LEGS_MAX
enum { PROBE_VERDICT_FALSE, PROBE_VERDICT_UNKNOWN, PROBE_VERDICT_TRUE };
enum { PROBE_INPUT_NONE, PROBE_INPUT_PLAN };
enum {
  PROBE_REASON_NONE,
  PROBE_REASON_MARGIN,
  PROBE_REASON_LEG,
  PROBE_REASON_INPUT,
  PROBE_REASON_OVER_CAPACITY
};
typedef struct probe_plan {
  int32_t valid, count, index;
  int64_t x[PLAN_CAPACITY], y[PLAN_CAPACITY];
} probe_plan;

/* What these tests call, and what that needs: printed by print_library.cpp. */
#include PROBE_LIBRARY

struct probe_tables {
  edge* edges;
  uint32_t *words, *lists;
  zone z;
};

/* From the heap, exactly as large as they are: no access may miss them. */
static void* kept(size_t bytes) {
  void* const memory = malloc(bytes);
  if (memory == NULL) abort();
  return memory;
}
#ifdef PROBE_TREES
static uint32_t* copied(const uint32_t* words, int32_t count) {
  uint32_t* const to = (uint32_t*)kept((size_t)count * sizeof(uint32_t) + (count == 0));
  if (count > 0) memcpy(to, words, (size_t)count * sizeof(uint32_t));
  return to;
}
#endif
static void take_tree(probe_tables* t, int32_t count, const probe_tree* tree) {
#ifdef PROBE_TREES
  (void)count;
  t->words = copied(tree->words, tree->word_count);
  t->lists = copied(tree->lists, tree->list_count);
  t->z.cells = t->words;
  t->z.lists = t->lists;
  t->z.x = tree->x;
  t->z.y = tree->y;
  t->z.shift = tree->shift;
  t->z.column = tree->column;
  t->z.row = tree->row;
  t->z.columns = tree->columns;
  t->z.rows = tree->rows;
  t->z.depth = tree->depth;
  t->z.leaves = tree->leaves;
#else
  (void)tree;
  t->z.count = count;
#endif
}
int32_t probe_has_trees(void) {
#ifdef PROBE_TREES
  return 1;
#else
  return 0;
#endif
}
probe_tables* probe_tables_new(const probe_edge* edges, int32_t count, const probe_tree* tree) {
  probe_tables* const t = (probe_tables*)kept(sizeof *t);
  int32_t i;
  memset(t, 0, sizeof *t);
  t->edges = (edge*)kept((size_t)count * sizeof(edge));
  for (i = 0; i < count; ++i) {
    t->edges[i].ax = edges[i].ax;
    t->edges[i].ay = edges[i].ay;
    t->edges[i].bx = edges[i].bx;
    t->edges[i].by = edges[i].by;
    t->edges[i].ux_q30 = edges[i].ux_q30;
    t->edges[i].uy_q30 = edges[i].uy_q30;
  }
  t->z.edges = t->edges;
  take_tree(t, count, tree);
  return t;
}
void probe_tables_free(probe_tables* t) {
  free(t->edges);
  free(t->words);
  free(t->lists);
  free(t);
}

static vec to_vec(probe_place p) {
  return vec_of(p.x, p.y);
}
static box to_box(probe_box b) {
  box to;
  to.x0 = b.x0;
  to.x1 = b.x1;
  to.y0 = b.y0;
  to.y1 = b.y1;
  return to;
}

int32_t probe_inside(const probe_tables* t, probe_place p) {
  return inside_zone(&t->z, to_vec(p));
}
int64_t probe_gap_lo(const probe_tables* t, probe_place p) {
  return boundary_gap_lo(&t->z, to_vec(p));
}
int64_t probe_leg_lo(const probe_tables* t, probe_place p, probe_place e) {
  return segment_boundary_lo(&t->z, to_vec(p), to_vec(e));
}
int32_t probe_box_in(const probe_tables* t, probe_box b) {
  const box within = to_box(b);
  return box_in_zone(&t->z, &within);
}
probe_span probe_box_clearance(const probe_tables* t, probe_box b) {
  const box within = to_box(b);
  const span found = middle_clearance(&t->z, &within);
  probe_span to;
  to.lo = found.lo;
  to.hi = found.hi;
  return to;
}
int32_t probe_plan_in(const probe_tables* t, const probe_place* places, int32_t count,
                      int64_t need_mm) {
  probe_plan plan;
  int32_t i;
  memset(&plan, 0, sizeof plan);
  plan.valid = 1;
  plan.count = count;
  for (i = 0; i < count; ++i) {
    plan.x[i] = places[i].x;
    plan.y[i] = places[i].y;
  }
  return verdict_of(plan_in_zone(&t->z, &plan, need_mm));
}
int64_t probe_reach_mm(const probe_tables* t, probe_place p, probe_place e, int64_t disc_mm,
                       int64_t capsule_mm) {
  const place at = place_of(&t->z, to_vec(p));
  reach r;
  memset(&r, 0, sizeof r);
  r.input = PROBE_INPUT_NONE;
  r.p = to_vec(p);
  r.e = to_vec(e);
  r.disc_mm = disc_mm;
  r.capsule_mm = capsule_mm;
  return zone_reach(&t->z, &at, &r, 0).lo / WEIGHT_MM;
}
int64_t probe_leave_mm(const probe_tables* t, probe_place p, probe_place e, int64_t radius_mm) {
  return leave_disc_mm(&t->z, to_vec(p), to_vec(e), radius_mm);
}
probe_border probe_border_of(const probe_tables* t, probe_place p) {
  const border b = border_of(&t->z, to_vec(p));
  probe_border to;
  to.at.x = b.at.x;
  to.at.y = b.at.y;
  to.inward_q30.x = b.inward_q30.x;
  to.inward_q30.y = b.inward_q30.y;
  to.gap.lo = b.gap.lo;
  to.gap.hi = b.gap.hi;
  to.inside = b.inside;
  to.nearest = b.nearest;
  return to;
}
