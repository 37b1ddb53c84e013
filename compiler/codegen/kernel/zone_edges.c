/* Zones of a few edges: every check looks at all of them. */
/*= zone_type @edges : edge_type */
typedef struct zone {
  const edge *edges;
  int32_t count;
} zone;
/*= inside_zone @edges : zone_type vec_of side_of */
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
/*= boundary_gap @edges : zone_type span_of vec_of box_gap near_edge nearer nearest_none nearest_mm nearest_mm_hi */
/* Bounds of the distance from `p` to the boundary: 2 mm apart, or 3 of edges or over distances of
 * hundreds of km. */
static span boundary_gap(const zone *z, vec p) {
  nearest n = nearest_none();
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const edge *e = &z->edges[i];
    if (nearer(box_gap(vec_of(e->ax, e->ay), vec_of(e->bx, e->by), p, p), &n)) {
      near_edge(e, p, &n);
    }
  }
  return span_of(nearest_mm(&n), nearest_mm_hi(&n));
}
/*= boundary_gap_lo @edges : boundary_gap */
static int64_t boundary_gap_lo(const zone *z, vec p) {
  return boundary_gap(z, p).lo;
}
/*= place_of @edges : place_type zone_type vec_type inside_zone boundary_gap */
static place place_of(const zone *z, vec p) {
  const span gap = boundary_gap(z, p);
  place at;
  at.gap_mm = gap.lo;
  at.gap_mm_hi = gap.hi;
  at.inside = inside_zone(z, p);
  return at;
}
/*= segment_boundary_lo @edges : zone_type segment_near_edge nearest_none nearest_mm segment_of */
/* Lower bound of the distance from the segment p-e to the boundary; -1 when they cross. */
static int64_t segment_boundary_lo(const zone *z, vec p, vec e) {
  segment s = segment_of(p, e);
  nearest n = nearest_none();
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    if (!segment_near_edge(&s, &z->edges[i], &n)) {
      return -1;
    }
  }
  return nearest_mm(&n);
}
/*= leg_gap_hi @edges : zone_type */
/* Upper bound of the distance of a leg from the boundary; `gap`: the lower one. */
static int64_t leg_gap_hi(const zone *z, int64_t gap, vec to) {
  (void)z;
  (void)to;
  return gap + 3;
}
