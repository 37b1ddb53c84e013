/* Distances between points, segments and baked zones. Coordinates within +-2^29 mm, so that
 * products of two differences fit 62 bits. `_lo` bounds from below, `_hi` from above. */
/*= point_gap_lo : minus dot root_down */
static int64_t point_gap_lo(vec a, vec b) {
  const vec d = minus(a, b);
  return root_down(dot(d, d));
}
/*= quotient_lo : root_up */
/* Lower bound of a / sqrt(square), at most 2 below it while the quotient is below 2^31: both are
 * scaled up first, so that rounding the root costs little even for short segments. */
static int64_t quotient_lo(int64_t a, int64_t square) {
  int32_t bits;
  for (bits = 16; bits > 0; bits /= 2) {
    if (square < (INT64_C(1) << (62 - 2 * bits))) {
      square <<= 2 * bits;
      a <<= bits;
    }
  }
  return a / root_up(square);
}
/*= point_segment_lo : point_gap_lo minus dot cross magnitude quotient_lo */
static int64_t point_segment_lo(vec p, vec a, vec b) {
  const vec d = minus(b, a);
  const vec q = minus(p, a);
  const int64_t along = dot(q, d);
  if (along <= 0) {
    return point_gap_lo(p, a);
  }
  if (along >= dot(d, d)) {
    return point_gap_lo(p, b);
  }
  return quotient_lo(magnitude(cross(d, q)), dot(d, d));
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
/*= segment_gap_lo : cross_each_other point_segment_lo min_of */
static int64_t segment_gap_lo(vec a, vec b, vec c, vec d) {
  if (cross_each_other(a, b, c, d)) {
    return 0;
  }
  return min_of(min_of(point_segment_lo(a, c, d), point_segment_lo(b, c, d)),
                min_of(point_segment_lo(c, a, b), point_segment_lo(d, a, b)));
}
/*= edge_type */
/* One directed edge of a zone, the zone on its left. `u` is its direction in Q30. */
typedef struct edge {
  int32_t ax, ay, bx, by;
  int32_t ux_q30, uy_q30;
} edge;
/*= zone_type : edge_type */
typedef struct zone {
  const edge *edges;
  int32_t count;
} zone;
/*= inside_zone : zone_type vec_of side_of */
/* Even-odd rule with exact orientation: right for every integer point off the boundary. */
static int32_t inside_zone(const zone *z, vec p) {
  int32_t inside = 0;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const edge *e = &z->edges[i];
    if ((e->ay > p.y) != (e->by > p.y)) {
      const int32_t side = side_of(vec_of(e->ax, e->ay), vec_of(e->bx, e->by), p);
      if ((e->by > e->ay) == (side > 0)) {
        inside = !inside;
      }
    }
  }
  return inside;
}
/*= box_gap : max_of min_of vec_type */
/* Largest axis distance between the boxes of two segments: never more than their distance. */
static int64_t box_gap(vec a, vec b, vec c, vec d) {
  const int64_t x = max_of(min_of(a.x, b.x) - max_of(c.x, d.x), min_of(c.x, d.x) - max_of(a.x, b.x));
  const int64_t y = max_of(min_of(a.y, b.y) - max_of(c.y, d.y), min_of(c.y, d.y) - max_of(a.y, b.y));
  return max_of(x, y);
}
/*= point_edge_lo : edge_type vec_of minus dot magnitude point_gap_lo */
/* Whether the foot of the perpendicular lies on the edge is decided exactly; the length of the
 * perpendicular comes from the Q30 direction, whose error is below 1 mm within the extent. */
static int64_t point_edge_lo(const edge *e, vec p) {
  const vec a = vec_of(e->ax, e->ay);
  const vec b = vec_of(e->bx, e->by);
  const vec d = minus(b, a);
  const vec q = minus(p, a);
  const int64_t along = dot(q, d);
  if (along <= 0) {
    return point_gap_lo(p, a);
  }
  if (along >= dot(d, d)) {
    return point_gap_lo(p, b);
  }
  {
    const int64_t gap = magnitude(q.y * e->ux_q30 - q.x * e->uy_q30) / Q30;
    return gap > 0 ? gap - 1 : 0;
  }
}
/*= boundary_gap_lo : zone_type vec_of box_gap point_edge_lo min_of */
/* Lower bound of the distance from `p` to the boundary, within 2 mm of it. */
static int64_t boundary_gap_lo(const zone *z, vec p) {
  int64_t best = SPAN_MAX;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const edge *e = &z->edges[i];
    if (box_gap(vec_of(e->ax, e->ay), vec_of(e->bx, e->by), p, p) < best) {
      best = min_of(best, point_edge_lo(e, p));
    }
  }
  return best;
}
/*= segment_boundary_lo : zone_type vec_of box_gap cross_each_other point_edge_lo point_segment_lo min_of */
/* Lower bound of the distance from the segment p-e to the boundary; -1 when they cross. */
static int64_t segment_boundary_lo(const zone *z, vec p, vec e) {
  int64_t best = SPAN_MAX;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const edge *k = &z->edges[i];
    const vec a = vec_of(k->ax, k->ay);
    const vec b = vec_of(k->bx, k->by);
    if (box_gap(a, b, p, e) < best) {
      if (cross_each_other(p, e, a, b)) {
        return -1;
      }
      best = min_of(best, min_of(point_edge_lo(k, p), point_edge_lo(k, e)));
      best = min_of(best, min_of(point_segment_lo(a, p, e), point_segment_lo(b, p, e)));
    }
  }
  return best;
}
