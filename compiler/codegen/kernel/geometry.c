/* Distances between points, segments and baked zones. Coordinates within +-2^29 mm, so that
 * products of two differences fit 62 bits. `_lo` bounds from below, `_hi` from above. */
/*= point_gap_lo : minus dot root_down */
static int64_t point_gap_lo(vec a, vec b) {
  const vec d = minus(a, b);
  return root_down(dot(d, d));
}
/*= segment_type : vec_type */
/* A segment, and the smallest distance from its line so far: `across` over its length. */
typedef struct segment {
  vec a, b, d;
  int64_t square; /* of its length */
  int64_t across;
  int64_t root;   /* of `square` shifted by 2 * `bits`, rounded up; 0: not drawn yet */
  int32_t bits;
} segment;
/*= segment_of : segment_type minus dot */
static segment segment_of(vec a, vec b) {
  segment s;
  s.a = a;
  s.b = b;
  s.d = minus(b, a);
  s.square = dot(s.d, s.d);
  s.across = INT64_MAX;
  s.root = 0;
  s.bits = 0;
  return s;
}
/*= draw_length : segment_type root_up */
/* For lower bounds of across / length, at most 2 below it while the quotient is below 2^31: both
 * are scaled up first, so that rounding the root costs little even for short segments. */
static void draw_length(segment *s) {
  int64_t square = s->square;
  int32_t bits;
  for (bits = 16; bits > 0; bits /= 2) {
    if (square < (INT64_C(1) << (62 - 2 * bits))) {
      square <<= 2 * bits;
      s->bits += bits;
    }
  }
  s->root = root_up(square);
}
/*= across_lo : segment_type draw_length */
static int64_t across_lo(segment *s) {
  if (s->root == 0) {
    draw_length(s);
  }
  return (s->across << s->bits) / s->root;
}
/*= near_point : segment_type minus dot cross magnitude min_of */
/* Takes the distance from `p` into account: to an end in `square`, to the line in `across`. Roots
 * and quotients round down, which commutes with the minimum: they are left for the end. */
static void near_point(segment *s, vec p, int64_t *square) {
  const vec q = minus(p, s->a);
  const int64_t along = dot(q, s->d);
  if (along <= 0) {
    *square = min_of(*square, dot(q, q));
  } else if (along >= s->square) {
    const vec r = minus(p, s->b);
    *square = min_of(*square, dot(r, r));
  } else {
    s->across = min_of(s->across, magnitude(cross(s->d, q)));
  }
}
/*= root_below : root_down */
/* The smaller of `least` and of the root of `square`, which is drawn only if it is smaller. */
static int64_t root_below(int64_t square, int64_t least) {
  return least > INT32_MAX || square < least * least ? root_down(square) : least;
}
/*= point_segment_lo : segment_of near_point across_lo root_down */
static int64_t point_segment_lo(vec p, vec a, vec b) {
  segment s = segment_of(a, b);
  int64_t square = INT64_MAX;
  near_point(&s, p, &square);
  return square < INT64_MAX ? root_down(square) : across_lo(&s);
}
/*= side_of : minus cross */
/* 1 left of a-b, -1 right of it, 0 on its line. Exact. */
static int32_t side_of(vec a, vec b, vec p) {
  const int64_t c = cross(minus(b, a), minus(p, a));
  return c > 0 ? 1 : (c < 0 ? -1 : 0);
}
/*= cross_each_other : side_of */
/* True for proper crossings; touching is found by the distances of the end points. */
static int32_t cross_each_other(vec a, vec b, vec c, vec d) {
  return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}
/*= segment_gap_lo : cross_each_other segment_of near_point across_lo min_of root_below */
static int64_t segment_gap_lo(vec a, vec b, vec c, vec d) {
  segment s = segment_of(a, b);
  segment t = segment_of(c, d);
  int64_t square = INT64_MAX;
  int64_t best = SPAN_MAX;
  if (cross_each_other(a, b, c, d)) {
    return 0;
  }
  near_point(&t, a, &square);
  near_point(&t, b, &square);
  near_point(&s, c, &square);
  near_point(&s, d, &square);
  if (s.across < INT64_MAX) {
    best = min_of(best, across_lo(&s));
  }
  if (t.across < INT64_MAX) {
    best = min_of(best, across_lo(&t));
  }
  return square < INT64_MAX ? root_below(square, best) : best;
}
/*= edge_type */
/* One directed edge of a zone, the zone on its left. `u` is its direction in Q30. */
typedef struct edge {
  int32_t ax, ay, bx, by;
  int32_t ux_q30, uy_q30;
} edge;
/*= box_gap : max_of min_of vec_type */
/* Largest axis distance between the boxes of two segments: never more than their distance. */
static int64_t box_gap(vec a, vec b, vec c, vec d) {
  const int64_t x = max_of(min_of(a.x, b.x) - max_of(c.x, d.x), min_of(c.x, d.x) - max_of(a.x, b.x));
  const int64_t y = max_of(min_of(a.y, b.y) - max_of(c.y, d.y), min_of(c.y, d.y) - max_of(a.y, b.y));
  return max_of(x, y);
}
/*= nearest_type */
/* The smallest of several distances: of those known in mm, and of those known as squares. */
typedef struct nearest {
  int64_t mm, square;
  int64_t wide; /* 0: `mm` is at most 2 mm below that distance; else 3 */
} nearest;
/*= nearest_none : nearest_type */
static nearest nearest_none(void) {
  nearest n;
  n.mm = SPAN_MAX;
  n.square = INT64_MAX;
  n.wide = 0;
  return n;
}
/*= nearer : nearest_type max_of */
/* Whether `gap` is below the smallest distance so far, its root rounded down. */
static int32_t nearer(int64_t gap, const nearest *n) {
  const int64_t next = max_of(gap, -1) + 1;
  return gap < n->mm && next * next <= n->square;
}
/*= nearest_mm : nearest_type root_below */
static int64_t nearest_mm(const nearest *n) {
  return n->square < INT64_MAX ? root_below(n->square, n->mm) : n->mm;
}
/*= nearest_mm_hi : nearest_mm */
/* A root is less than 1 mm below. */
static int64_t nearest_mm_hi(const nearest *n) {
  const int64_t mm = nearest_mm(n);
  return mm + (n->wide == 0 || mm < n->mm ? 2 : 3);
}
/*= near_edge : edge_type nearest_type vec_of minus dot magnitude min_of max_of */
/* Whether the foot of the perpendicular lies on the edge is decided exactly. Its length comes from
 * the Q30 direction u, whose components are within 1/2 of their true values: of a difference v from
 * a place of the edge's line, the product is within (|vx| + |vy|) / 2 of the true one. That is taken
 * off; then, with the rounding of the quotient, the bound is less than 1 + (|vx| + |vy| + 1) / 2^30 mm
 * below the length: 2 mm for |vx| + |vy| < 2^30. From the nearer end that is so unless the edge is
 * more than 1,000 km long or p as far away; never more than 3 mm. */
static void near_edge(const edge *e, vec p, nearest *n) {
  const vec a = vec_of(e->ax, e->ay);
  const vec b = vec_of(e->bx, e->by);
  const vec d = minus(b, a);
  const vec q = minus(p, a);
  const int64_t along = dot(q, d);
  const int64_t square = dot(d, d);
  const vec r = minus(p, b);
  if (along <= 0) {
    n->square = min_of(n->square, dot(q, q));
  } else if (along >= square) {
    n->square = min_of(n->square, dot(r, r));
  } else {
    const vec v = along < square - along ? q : r;
    const int64_t spread = magnitude(v.x) + magnitude(v.y);
    const int64_t across = magnitude(v.y * e->ux_q30 - v.x * e->uy_q30) - (spread + 1) / 2;
    const int64_t gap = max_of(across, 0) / Q30;
    n->wide = gap < n->mm ? spread / Q30 : n->wide;
    n->mm = min_of(n->mm, gap);
  }
}
/*= segment_near_edge : edge_type segment_type vec_of box_gap cross_each_other near_edge nearer nearest_type near_point across_lo min_of */
/* Takes an edge of the boundary into account; 0: the segment crosses it. */
static int32_t segment_near_edge(segment *s, const edge *k, nearest *n) {
  const vec a = vec_of(k->ax, k->ay);
  const vec b = vec_of(k->bx, k->by);
  if (nearer(box_gap(a, b, s->a, s->b), n)) {
    if (cross_each_other(s->a, s->b, a, b)) {
      return 0;
    }
    near_edge(k, s->a, n);
    near_edge(k, s->b, n);
    s->across = INT64_MAX;
    near_point(s, a, &n->square);
    near_point(s, b, &n->square);
    if (s->across < INT64_MAX) {
      n->mm = min_of(n->mm, across_lo(s));
    }
  }
  return 1;
}
/*= place_type */
/* Where a point is with respect to a zone. */
typedef struct place {
  int64_t gap_mm, gap_mm_hi; /* to the boundary: bounds */
  int32_t inside;
} place;
