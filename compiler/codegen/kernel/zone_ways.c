/* Ways in zones: how far a leg leads before it leaves, and where the boundary is nearest. For
 * recoveries and applications; decisions ask for none of it. Places within the extent. */
/*= part_q31 */
/* 2^31 num / den rounded down, for 0 <= num <= den < 2^62: a digit at a time, so that nothing
 * overflows. */
static int64_t part_q31(int64_t num, int64_t den) {
  int64_t part = 0;
  int32_t i;
  if (num >= den) {
    return INT64_C(1) << 31;
  }
  for (i = 0; i < 31; ++i) {
    num *= 2;
    part *= 2;
    if (num >= den) {
      num -= den;
      part += 1;
    }
  }
  return part;
}
/*= meeting_mm : edge_type vec_of minus dot cross magnitude min_of max_of box_gap part_q31 */
/* Where the leg p-e first touches the edge: as far from p, or less than 3 mm nearer; INT64_MAX: it
 * does not, which is exact. `length`: of the leg, rounded down.
 * The place is that part of the leg which start / (start - end) says, and start - end is the cross
 * product of two differences: below 2^62. Rounding takes 1 mm for the length, 2^30.5 / 2^31 mm for
 * the part, and 1 mm for their product. */
static int64_t meeting_mm(const edge *k, vec p, vec e, int64_t length) {
  const vec a = vec_of(k->ax, k->ay);
  const vec b = vec_of(k->bx, k->by);
  const vec d = minus(e, p);
  const vec g = minus(b, a);
  const int64_t start = cross(g, minus(p, a));
  const int64_t end = cross(g, minus(e, a));
  const int64_t a_side = cross(d, minus(a, p));
  const int64_t b_side = cross(d, minus(b, p));
  int64_t part;
  if (box_gap(a, b, p, e) > 0 || (start > 0 && end > 0) || (start < 0 && end < 0) ||
      (a_side > 0 && b_side > 0) || (a_side < 0 && b_side < 0)) {
    return INT64_MAX;
  }
  if (start == 0 && end == 0) { /* on one line, where boxes that touch mean that they do */
    const int64_t first = min_of(dot(minus(a, p), d), dot(minus(b, p), d));
    part = first <= 0 ? 0 : part_q31(first, dot(d, d));
  } else {
    part = part_q31(magnitude(start), magnitude(start) + magnitude(end));
  }
  return part * length >> 31;
}
/*= leave_mm @edges : zone_type inside_zone meeting_mm point_gap_lo min_of */
/* How far from p the leg p-e first touches the boundary, less than 3 mm short of it and never
 * beyond; 0 from outside; INT64_MAX: all of the leg lies inside. */
static int64_t leave_mm(const zone *z, vec p, vec e) {
  const int64_t length = point_gap_lo(p, e);
  int64_t first = INT64_MAX;
  int32_t i;
  if (!inside_zone(z, p)) {
    return 0;
  }
  for (i = 0; i < z->count; ++i) {
    first = min_of(first, meeting_mm(&z->edges[i], p, e, length));
  }
  return first;
}
/*= leave_mm @cells : cell_at cell_count cell_edge next_cell inside_zone meeting_mm point_gap_lo min_of */
/* How far from p the leg p-e first touches the boundary, less than 3 mm short of it and never
 * beyond; 0 from outside; INT64_MAX: all of the leg lies inside. Where it touches, the edge is one
 * of the cell there, or of the cell before. An edge that is touched in a later cell is no end: what
 * comes before it has to be looked at, up to 5 mm more for what was rounded. */
static int64_t leave_mm(const zone *z, vec p, vec e) {
  const int64_t length = point_gap_lo(p, e);
  int64_t first = INT64_MAX;
  vec at = p;
  int32_t more = 1;
  int32_t i, k;
  if (!inside_zone(z, p)) {
    return 0;
  }
  for (i = 0; i < z->leaves && more; ++i) {
    const cell c = cell_at(z, at);
    for (k = 0; k < cell_count(c.word); ++k) {
      first = min_of(first, meeting_mm(cell_edge(z, c.word, k), p, e, length));
    }
    more = next_cell(&c, p, e, &at) && point_gap_lo(p, at) - 5 <= first;
  }
  return more ? 0 : first;
}
/*= nearest_quotient */
/* a / b to the nearest integer, for b > 0 and |a| + b below 2^63. */
static int64_t nearest_quotient(int64_t a, int64_t b) {
  return a < 0 ? -((b / 2 - a) / b) : (a + b / 2) / b;
}
/*= point_along : vec_of minus nearest_quotient */
/* The grid point nearest to the place that is `mm` along p-e, which is `length` mm long. */
static vec point_along(vec p, vec e, int64_t length, int64_t mm) {
  const vec d = minus(e, p);
  return vec_of(p.x + nearest_quotient(d.x * mm, length), p.y + nearest_quotient(d.y * mm, length));
}
/*= leave_disc_mm : zone_type leave_mm inside_zone boundary_gap_lo segment_boundary_lo point_along minus dot root_up max_of */
/* How far a disc may move along p-e: up to there its middle keeps `radius` mm to the boundary, and
 * before 2 mm more there is a place where it does not keep radius + 5 mm. 0: it does not at p;
 * INT64_MAX: it does all the way. Beyond exact distances it may end sooner.
 * By halving, at most 31 times. A place of the leg up to `low` - 1 is within sqrt(1/2) mm of the leg
 * to the grid point at `low` (its length is rounded up, which takes 1 mm of the way): 1 mm more
 * clearance there suffices. The clearance that a leg is known to keep is at most 3 mm too small. */
static int64_t leave_disc_mm(const zone *z, vec p, vec e, int64_t radius) {
  const vec d = minus(e, p);
  const int64_t length = root_up(dot(d, d));
  int64_t low = 0;
  int64_t high = length;
  int32_t i;
  if (radius <= 0) {
    return leave_mm(z, p, e);
  }
  if (!inside_zone(z, p) || boundary_gap_lo(z, p) < radius) {
    return 0;
  }
  if (segment_boundary_lo(z, p, e) >= radius) {
    return INT64_MAX;
  }
  for (i = 0; i < 31 && high - low > 1; ++i) {
    const int64_t middle = low + (high - low) / 2;
    if (segment_boundary_lo(z, p, point_along(p, e, length, middle)) > radius) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return max_of(low - 1, 0);
}
/*= closest_type : edge_type vec_type */
/* The edge whose line is nearest beside it, and the nearest vertex. */
typedef struct closest {
  const edge *line;
  int64_t across_q30; /* from `line` */
  vec vertex;
  int64_t square;    /* of the distance from `vertex` */
  const edge *end;   /* one that ends at the place itself, */
  vec normals;       /* the inward normals of all that do: their sum, Q30, */
  int32_t ends;      /* and how many they are */
} closest;
/*= closest_none : closest_type vec_of */
static closest closest_none(void) {
  closest c;
  c.line = 0;
  c.across_q30 = INT64_MAX;
  c.vertex = vec_of(0, 0);
  c.square = INT64_MAX;
  c.end = 0;
  c.normals = vec_of(0, 0);
  c.ends = 0;
  return c;
}
/*= close_vertex : closest_type vec_of minus dot */
static void close_vertex(const edge *k, vec v, vec p, closest *c) {
  const vec q = minus(p, v);
  const int64_t square = dot(q, q);
  if (square < c->square) {
    c->square = square;
    c->vertex = v;
  }
  if (square == 0) {
    c->normals = vec_of(c->normals.x - k->uy_q30, c->normals.y + k->ux_q30);
    c->end = k;
    c->ends += 1;
  }
}
/*= close_edge : close_vertex vec_of minus dot magnitude */
/* As near_edge, which knows no places. */
static void close_edge(const edge *k, vec p, closest *c) {
  const vec a = vec_of(k->ax, k->ay);
  const vec b = vec_of(k->bx, k->by);
  const vec d = minus(b, a);
  const vec q = minus(p, a);
  const int64_t along = dot(q, d);
  if (along <= 0) {
    close_vertex(k, a, p, c);
  } else if (along >= dot(d, d)) {
    close_vertex(k, b, p, c);
  } else {
    const int64_t across_q30 = magnitude(q.y * k->ux_q30 - q.x * k->uy_q30);
    if (across_q30 < c->across_q30) {
      c->across_q30 = across_q30;
      c->line = k;
    }
  }
}
/*= line_is_closer : closest_type root_down */
/* In 1/256 mm up to 8 km, so that of two places some mm apart the nearer one is taken. */
static int32_t line_is_closer(const closest *c) {
  if (c->line == 0) {
    return 0;
  }
  if (c->square >> 46 == 0) {
    return c->across_q30 >> 22 <= root_down(c->square * 65536);
  }
  return c->square == INT64_MAX || c->across_q30 >> 30 <= root_down(c->square);
}
/*= unit_q30 : segment_of draw_length vec_of */
/* The unit vector along r, each component within 3 of 2^30; (0, 0) of none. */
static vec unit_q30(vec r) {
  segment s = segment_of(vec_of(0, 0), r);
  if (s.square == 0) {
    return r;
  }
  draw_length(&s);
  return vec_of(r.x * (INT64_C(1) << (30 + s.bits)) / s.root,
                r.y * (INT64_C(1) << (30 + s.bits)) / s.root);
}
/*= inward_at_end : closest_type unit_q30 vec_of */
/* From a vertex: between the normals of its edges. Where parts touch they may cancel each other;
 * then it is one of them. */
static vec inward_at_end(const closest *c) {
  const vec sum = vec_of(c->normals.x / c->ends, c->normals.y / c->ends);
  return sum.x == 0 && sum.y == 0 ? vec_of(-(int64_t)c->end->uy_q30, c->end->ux_q30)
                                  : unit_q30(sum);
}
/*= border_type : vec_type span_type */
/* The boundary as a place sees it. `at`: a place of it, rounded to the grid; `inward_q30`: a unit
 * vector, from outside towards `at`, inside away from it, on the boundary into the zone. */
typedef struct border {
  vec at, inward_q30;
  span gap; /* bounds of the distance from the boundary */
  int32_t inside;
  int32_t nearest; /* whether `at` is the nearest one; else it is one in some direction */
} border;
/*= foot_on : edge_type vec_of nearest_quotient clamp_of min_of max_of */
/* The foot of the perpendicular from p, to the grid: within 1 mm of it for p and ends of the edge up
 * to 10 km apart, and 3 mm for all others. From p against the normal (-uy, ux), as far as p is
 * across in halves of a millimetre: 1/4 mm, then sqrt(1/2) mm for the grid; the direction is off by
 * 2^-31 in each component, which turns and shortens by as little. The box of the edge holds the foot,
 * so that clamping takes nothing. */
static vec foot_on(const edge *k, vec p) {
  const int64_t across_q30 =
      (p.y - k->ay) * (int64_t)k->ux_q30 - (p.x - k->ax) * (int64_t)k->uy_q30;
  const int64_t halves = nearest_quotient(across_q30, Q30 / 2);
  return vec_of(clamp_of(p.x + nearest_quotient(halves * k->uy_q30, 2 * Q30), min_of(k->ax, k->bx),
                         max_of(k->ax, k->bx)),
                clamp_of(p.y - nearest_quotient(halves * k->ux_q30, 2 * Q30), min_of(k->ay, k->by),
                         max_of(k->ay, k->by)));
}
/*= look_at_border : border_type closest_type line_is_closer foot_on inward_at_end unit_q30 side_of minus vec_of */
/* `inside`: that of p. Beside an edge the direction is that of its normal, at a vertex that from or
 * to p; on a vertex it lies between the normals of the edges there. */
static void look_at_border(const closest *c, vec p, border *b) {
  if (line_is_closer(c)) {
    const edge *k = c->line;
    const int32_t side = side_of(vec_of(k->ax, k->ay), vec_of(k->bx, k->by), p);
    const int32_t turned = side != 0 && (side > 0) != (b->inside != 0);
    b->at = foot_on(k, p);
    b->inward_q30 = turned ? vec_of(k->uy_q30, -(int64_t)k->ux_q30)
                           : vec_of(-(int64_t)k->uy_q30, k->ux_q30);
  } else {
    b->at = c->vertex;
    b->inward_q30 = c->ends > 0 ? inward_at_end(c)
                                : unit_q30(b->inside ? minus(p, c->vertex) : minus(c->vertex, p));
  }
}
/*= border_of @edges : zone_type look_at_border closest_none close_edge inside_zone boundary_gap */
static border border_of(const zone *z, vec p) {
  closest c = closest_none();
  border b;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    close_edge(&z->edges[i], p, &c);
  }
  b.inside = inside_zone(z, p);
  b.gap = boundary_gap(z, p);
  b.nearest = 1;
  look_at_border(&c, p, &b);
  return b;
}
/*= border_of @cells : cell_at cell_count cell_edge cell_gap cell_inside next_cell look_at_border closest_none close_edge unit_q30 minus vec_of */
/* Of a place in a far cell the boundary is looked for on the way to the first vertex: in the first
 * cell on it that has edges, which is that of the vertex at the latest. Straight on to `at` leads
 * to the boundary; inside, where distances are no shorter than the bound, any direction does. */
static border border_of(const zone *z, vec p) {
  const vec vertex = vec_of(z->edges[0].ax, z->edges[0].ay);
  cell c = cell_at(z, p);
  closest near = closest_none();
  vec at = p;
  border b;
  int32_t i;
  b.inside = cell_inside(z, &c, 2 * p.x, 2 * p.y);
  b.gap = cell_gap(z, &c, p);
  b.nearest = cell_count(c.word) > 0;
  for (i = 0; i < z->leaves && cell_count(c.word) == 0; ++i) {
    if (next_cell(&c, p, vertex, &at)) {
      c = cell_at(z, at);
    }
  }
  for (i = 0; i < cell_count(c.word); ++i) {
    close_edge(cell_edge(z, c.word, i), at, &near);
  }
  look_at_border(&near, at, &b);
  if (!b.nearest) {
    b.inward_q30 = unit_q30(b.inside ? minus(p, b.at) : minus(b.at, p));
  }
  return b;
}
/*= zone_of_area @cells : zone_type edge_type */
/* The six numbers of an edge are its members. */
static zone zone_of_area(const KERNEL_area *a) {
  zone z;
  z.edges = (const edge *)(const void *)a->edges;
  z.cells = a->cells;
  z.lists = a->lists;
  z.x = a->x;
  z.y = a->y;
  z.shift = a->shift;
  z.column = a->column;
  z.row = a->row;
  z.columns = a->columns;
  z.rows = a->rows;
  z.depth = a->depth;
  z.leaves = a->leaves;
  z.exact = a->exact;
  return z;
}
/*= area_leave @cells : zone_of_area leave_disc_mm vec_of on_map */
int64_t KERNEL_leave_mm(const KERNEL_area *area, int64_t x, int64_t y, int64_t to_x, int64_t to_y,
                        int64_t radius_mm) {
  const zone z = zone_of_area(area);
  if (on_map(x) != x || on_map(y) != y) {
    return 0; /* outside every zone */
  }
  return leave_disc_mm(&z, vec_of(x, y), vec_of(on_map(to_x), on_map(to_y)), radius_mm);
}
/*= area_border @cells : zone_of_area border_of vec_of on_map */
void KERNEL_border_of(const KERNEL_area *area, int64_t x, int64_t y, KERNEL_border *to) {
  const zone z = zone_of_area(area);
  const border b = border_of(&z, vec_of(on_map(x), on_map(y)));
  to->x = b.at.x;
  to->y = b.at.y;
  to->inward_x_q30 = b.inward_q30.x;
  to->inward_y_q30 = b.inward_q30.y;
  to->gap_mm_lo = b.gap.lo;
  to->gap_mm_hi = b.gap.hi;
  to->inside = b.inside;
  to->nearest = b.nearest;
}
