/* Plane geometry in doubles, metres: what the hand-written decision step is made of. */
#ifndef RTAC_BENCH_HAND_GEOMETRY_H
#define RTAC_BENCH_HAND_GEOMETRY_H

#include <math.h>

#include "tests/bench/hand/delivery.h"

static inline double smaller(double a, double b) {
  return a < b ? a : b;
}
static inline double larger(double a, double b) {
  return a > b ? a : b;
}
static inline hand_vec minus(hand_vec a, hand_vec b) {
  const hand_vec d = {a.x - b.x, a.y - b.y};
  return d;
}
static inline double dot(hand_vec a, hand_vec b) {
  return a.x * b.x + a.y * b.y;
}
static inline double cross(hand_vec a, hand_vec b) {
  return a.x * b.y - a.y * b.x;
}
static inline double distance(hand_vec a, hand_vec b) {
  const hand_vec d = minus(a, b);
  return sqrt(dot(d, d));
}

/* A segment with what its distances need. */
typedef struct line {
  hand_vec a, d;  /* start, and from start to end */
  double inverse; /* 1 / |d|^2; 0 for a point */
} line;

static inline line line_of(hand_vec a, hand_vec b) {
  line l;
  double square;
  l.a = a;
  l.d = minus(b, a);
  square = dot(l.d, l.d);
  l.inverse = square > 0 ? 1 / square : 0;
  return l;
}
/* Square of the distance from `p` to the segment. */
static inline double point_line2(hand_vec p, const line* l) {
  const hand_vec q = minus(p, l->a);
  const double t = smaller(larger(dot(q, l->d) * l->inverse, 0), 1);
  const hand_vec r = {q.x - t * l->d.x, q.y - t * l->d.y};
  return dot(r, r);
}
static inline hand_vec end_of(const line* l) {
  const hand_vec b = {l->a.x + l->d.x, l->a.y + l->d.y};
  return b;
}
static inline int crossing(const line* k, const line* l) {
  const hand_vec from = minus(l->a, k->a);
  const hand_vec to = minus(end_of(l), k->a);
  const hand_vec back = minus(k->a, l->a);
  const hand_vec forth = minus(end_of(k), l->a);
  return cross(k->d, from) * cross(k->d, to) < 0 && cross(l->d, back) * cross(l->d, forth) < 0;
}
/* Square of the distance between two segments. */
static inline double line_line2(const line* k, const line* l) {
  if (crossing(k, l)) {
    return 0;
  }
  return smaller(smaller(point_line2(k->a, l), point_line2(end_of(k), l)),
                 smaller(point_line2(l->a, k), point_line2(end_of(l), k)));
}

/* Distance to the boundary, negative outside: both from one loop over the edges. */
static inline double signed_gap(const hand_zone* z, hand_vec p) {
  double best = HUGE_VAL;
  int inside = 0;
  int i;
  for (i = 0; i < z->count; ++i) {
    const hand_edge* e = &z->edges[i];
    const hand_vec q = {p.x - e->a.x, p.y - e->a.y};
    const double t = smaller(larger((q.x * e->d.x + q.y * e->d.y) * e->inverse, 0), 1);
    const hand_vec r = {q.x - t * e->d.x, q.y - t * e->d.y};
    best = smaller(best, dot(r, r));
    if ((e->a.y > p.y) != (e->b.y > p.y)) {
      inside ^= (e->b.y > e->a.y) == (cross(e->d, q) > 0);
    }
  }
  return inside ? sqrt(best) : -sqrt(best);
}
/* Square of the distance between the boxes of a segment and of an edge. */
static inline double box_gap2(const hand_edge* e, hand_vec low, hand_vec high) {
  const double x = larger(larger(e->low.x - high.x, low.x - e->high.x), 0);
  const double y = larger(larger(e->low.y - high.y, low.y - e->high.y), 0);
  return x * x + y * y;
}
/* Distance from a segment to the boundary; below 0 when they cross. */
static inline double line_gap(const hand_zone* z, hand_vec from, hand_vec to) {
  const line l = line_of(from, to);
  const hand_vec low = {smaller(from.x, to.x), smaller(from.y, to.y)};
  const hand_vec high = {larger(from.x, to.x), larger(from.y, to.y)};
  double best = HUGE_VAL;
  int i;
  for (i = 0; i < z->count; ++i) {
    const hand_edge* e = &z->edges[i];
    if (box_gap2(e, low, high) < best) {
      const line k = {e->a, e->d, e->inverse};
      const double square = line_line2(&l, &k);
      if (square == 0 && crossing(&l, &k)) {
        return -0.001;
      }
      best = smaller(best, square);
    }
  }
  return sqrt(best);
}

#endif
