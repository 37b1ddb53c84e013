/* Zones of many edges: a tree of square cells tells which few of them matter for a place. */
/*= zone_type @cells : edge_type */
/* A square of 2^32 mm, divided by 16 again and again; cells are closed to the south and west. A word
 * of `cells` tells of a cell, in its two highest bits, that it is
 *   0 far    the boundary is at least as far away as the lowest 28 bits say; with bit 28 set, rather
 *     sides  its edges are neighbours, the first one in the lowest 23 bits; bits 24 and 25: how many,
 *            less one. The boundary meets that of them which bits 26 and 27 tell and, with bit 23 set,
 *            the next one; places inside are on the left of both or, with bit 29, of either;
 *   1 run    its edges are neighbours, the first one in the lowest 24 bits;
 *   2 list   the lowest 24 bits lead to the numbers of its edges in `lists`;
 *   3 split  the lowest 30 bits lead to the words of its 16 parts, row by row from the south-west.
 * Its edges: those that can be nearest to some place of it; bits 24 to 27: how many, less one. Bit
 * 28: the boundary meets it; never of cells wider than those of the grid, whose places are outside.
 * Bit 29, but of sides: its south-west corner, moved as in `crosses_way`, is inside. */
typedef struct zone {
  const edge *edges;
  const uint32_t *cells, *lists;
  int32_t x, y;                              /* south-west corner of the square */
  int32_t shift, column, row, columns, rows; /* of the grid where a place near the zone starts */
  int32_t depth, leaves;                     /* most splits on the way to a cell; cells */
  int32_t exact;                             /* distances below are those of edges, in mm */
} zone;
/*= cell_type */
typedef struct cell {
  int64_t x, y; /* south-west corner */
  int32_t shift; /* 2^shift mm wide */
  uint32_t word;
} cell;
/*= cell_at @cells : cell_type zone_type vec_type */
/* The cell of a point: from its cell of the grid, or else from the whole square, to the last part. */
static cell cell_at(const zone *z, vec p) {
  const uint64_t x = (uint64_t)(p.x - z->x);
  const uint64_t y = (uint64_t)(p.y - z->y);
  const uint64_t column = (x >> z->shift) - (uint64_t)z->column;
  const uint64_t row = (y >> z->shift) - (uint64_t)z->row;
  const uint64_t columns = (uint64_t)z->columns;
  const uint64_t rows = (uint64_t)z->rows;
  const int32_t in_grid = column < columns && row < rows;
  int32_t i;
  cell c;
  c.shift = in_grid ? z->shift : 32;
  c.word = z->cells[in_grid ? row * columns + column : rows * columns];
  for (i = 0; i < z->depth && c.word >> 30 == 3; ++i) {
    c.shift -= 2;
    c.word = z->cells[(c.word & 0x3fffffff) + ((y >> c.shift & 3) << 2 | (x >> c.shift & 3))];
  }
  c.x = z->x + (int64_t)(x >> c.shift << c.shift);
  c.y = z->y + (int64_t)(y >> c.shift << c.shift);
  return c;
}
/*= cell_count @cells */
static int32_t cell_count(uint32_t word) {
  const int32_t most = word >> 30 != 0 ? 16 : (word >> 28 & 1) != 0 ? 4 : 0;
  return most == 0 ? 0 : (int32_t)(word >> 24 & (uint32_t)(most - 1)) + 1;
}
/*= cell_edge @cells : zone_type */
static const edge *cell_edge(const zone *z, uint32_t word, int32_t i) {
  const uint32_t at = (word & (word >> 30 == 0 ? 0x7fffff : 0xffffff)) + (uint32_t)i;
  return &z->edges[word >> 30 == 2 ? z->lists[at] : at];
}
/*= crosses_way @cells : edge_type */
/* Whether the edge crosses the way from (x0, y0) north or south to y, then east or west to x, all
 * doubled. Exact; these points count as moved north by less than anything else, and east by less
 * than that, so that none lies on the edge. Without branches, since nobody can predict them. */
static int32_t crosses_way(const edge *e, int64_t x0, int64_t y0, int64_t x, int64_t y) {
  const int64_t ax = 2 * (int64_t)e->ax, ay = 2 * (int64_t)e->ay;
  const int64_t bx = 2 * (int64_t)e->bx, by = 2 * (int64_t)e->by;
  const int64_t dx = e->bx - (int64_t)e->ax, dy = e->by - (int64_t)e->ay;
  const int64_t left = 1 - ((dx > 0) | ((dx == 0) & (dy < 0))); /* from this product on */
  const int32_t start = dx * (y0 - ay) - dy * (x0 - ax) >= left;
  const int32_t turn = dx * (y - ay) - dy * (x0 - ax) >= left;
  const int32_t end = dx * (y - ay) - dy * (x - ax) >= left;
  return (((ax > x0) ^ (bx > x0)) & (start ^ turn)) ^ (((ay > y) ^ (by > y)) & (turn ^ end));
}
/*= may_cross_way @cells : edge_type */
/* 0: the ends of the edge lie on one side of both lines that the way runs along, so that it does not
 * cross it. */
static int32_t may_cross_way(const edge *e, int64_t x0, int64_t y) {
  return ((2 * (int64_t)e->ax > x0) ^ (2 * (int64_t)e->bx > x0)) |
         ((2 * (int64_t)e->ay > y) ^ (2 * (int64_t)e->by > y));
}
/*= on_left @cells : edge_type */
/* Whether a place, coordinates doubled, is on the left of the edge's line. */
static int32_t on_left(const edge *e, int64_t x, int64_t y) {
  const int64_t dx = e->bx - (int64_t)e->ax, dy = e->by - (int64_t)e->ay;
  return dx * (y - 2 * (int64_t)e->ay) > dy * (x - 2 * (int64_t)e->ax);
}
/*= inside_by_sides @cells : zone_type on_left */
static int32_t inside_by_sides(const zone *z, uint32_t word, int64_t x, int64_t y) {
  const edge *const e = &z->edges[(word & 0x7fffff) + (word >> 26 & 3)];
  const int32_t first = on_left(e, x, y);
  const int32_t second = on_left(e + (word >> 23 & 1), x, y);
  return (word >> 29 & 1) != 0 ? first | second : first & second;
}
/*= inside_by_way @cells : cell_type cell_count cell_edge may_cross_way crosses_way */
/* The corner of the cell is inside, or not, and each edge on the way from there changes it. Most edges
 * are far from crossing it: the few others are gathered first, without branches. */
static int32_t inside_by_way(const zone *z, const cell *c, int64_t x, int64_t y) {
  int32_t inside = (int32_t)(c->word >> 29 & 1);
  const edge *met[16];
  int32_t count = 0;
  int32_t i;
  for (i = 0; i < cell_count(c->word); ++i) {
    const edge *const e = cell_edge(z, c->word, i);
    met[count] = e;
    count += may_cross_way(e, 2 * c->x, y);
  }
  for (i = 0; i < count; ++i) {
    inside ^= crosses_way(met[i], 2 * c->x, 2 * c->y, x, y);
  }
  return inside;
}
/*= cell_inside @cells : inside_by_sides inside_by_way */
/* Whether a place of the cell, coordinates doubled, is inside. Of places on the boundary it says
 * nothing. */
static int32_t cell_inside(const zone *z, const cell *c, int64_t x, int64_t y) {
  if ((c->word >> 28 & 1) == 0) {
    return (int32_t)(c->word >> 29 & 1);
  }
  return c->word >> 30 == 0 ? inside_by_sides(z, c->word, x, y) : inside_by_way(z, c, x, y);
}
/*= inside_zone @cells : cell_at cell_inside */
static int32_t inside_zone(const zone *z, vec p) {
  const cell c = cell_at(z, p);
  return cell_inside(z, &c, 2 * p.x, 2 * p.y);
}
/*= cell_gap @cells : cell_type cell_count cell_edge nearest_none near_edge nearest_mm nearest_mm_hi span_of */
/* Bounds of the distance from a place of the cell to the boundary: 2 mm apart, or 3 of edges or over
 * distances of hundreds of km; more in cells that are far from it. */
static span cell_gap(const zone *z, const cell *c, vec p) {
  nearest n = nearest_none();
  int32_t i;
  if (cell_count(c->word) == 0) {
    const int64_t far = c->word & 0xfffffff; /* in words no more than that */
    return span_of(far, far + (far == 0xfffffff ? INT64_C(1) << 32 : (INT64_C(2) << c->shift) + 1));
  }
  for (i = 0; i < cell_count(c->word); ++i) {
    near_edge(cell_edge(z, c->word, i), p, &n);
  }
  return span_of(nearest_mm(&n), nearest_mm_hi(&n));
}
/*= boundary_gap @cells : cell_at cell_gap */
static span boundary_gap(const zone *z, vec p) {
  const cell c = cell_at(z, p);
  return cell_gap(z, &c, p);
}
/*= boundary_gap_lo @cells : boundary_gap */
static int64_t boundary_gap_lo(const zone *z, vec p) {
  return boundary_gap(z, p).lo;
}
/*= place_of @cells : place_type cell_at cell_gap cell_inside */
static place place_of(const zone *z, vec p) {
  const cell c = cell_at(z, p);
  const span gap = cell_gap(z, &c, p);
  place at;
  at.gap_mm = gap.lo;
  at.gap_mm_hi = gap.hi;
  at.inside = cell_inside(z, &c, 2 * p.x, 2 * p.y);
  return at;
}
/*= next_cell @cells : cell_type minus vec_of magnitude clamp_of */
/* Moves `at` to a place of the next cell that the segment p-e enters; 0: it ends in this one. Where
 * it leaves this one is rounded towards p, and kept beside this one: at a corner, the next step leads
 * on. Each step leaves a cell for good. */
static int32_t next_cell(const cell *c, vec p, vec e, vec *at) {
  const vec d = minus(e, p);
  const int64_t x1 = c->x + (INT64_C(1) << c->shift);
  const int64_t y1 = c->y + (INT64_C(1) << c->shift);
  /* where it would pass the lines of the sides that it runs towards, from p */
  const vec q = minus(vec_of(d.x > 0 ? x1 : c->x, d.y > 0 ? y1 : c->y), p);
  const int32_t by_x = d.x > 0 ? e.x >= x1 : e.x < c->x;
  const int32_t by_y = d.y > 0 ? e.y >= y1 : e.y < c->y;
  if (!by_x && !by_y) {
    return 0;
  }
  if (by_x && (!by_y || magnitude(q.x) * magnitude(d.y) <= magnitude(q.y) * magnitude(d.x))) {
    at->x = d.x > 0 ? x1 : c->x - 1;
    at->y = clamp_of(p.y + d.y * magnitude(q.x) / magnitude(d.x), c->y, y1 - 1);
  } else {
    at->x = clamp_of(p.x + d.x * magnitude(q.y) / magnitude(d.y), c->x, x1 - 1);
    at->y = d.y > 0 ? y1 : c->y - 1;
  }
  return 1;
}
/*= segment_boundary_lo @cells : cell_at cell_count cell_edge next_cell segment_near_edge segment_of nearest_none nearest_mm min_of */
/* Lower bound of the distance from the segment p-e to the boundary; -1 when they cross. The edges
 * that are nearest to its places are those of the cells that it passes. */
static int64_t segment_boundary_lo(const zone *z, vec p, vec e) {
  segment s = segment_of(p, e);
  nearest n = nearest_none();
  vec at = p;
  int32_t more = 1;
  int32_t i, k;
  for (i = 0; i < z->leaves && more; ++i) {
    const cell c = cell_at(z, at);
    if (cell_count(c.word) == 0) {
      n.mm = min_of(n.mm, c.word & 0xfffffff);
    }
    for (k = 0; k < cell_count(c.word); ++k) {
      if (!segment_near_edge(&s, cell_edge(z, c.word, k), &n)) {
        return -1;
      }
    }
    more = next_cell(&c, p, e, &at);
  }
  return more ? 0 : nearest_mm(&n);
}
/*= leg_gap_hi @cells : zone_type boundary_gap max_of */
/* Upper bound of the distance of a leg from the boundary; `gap`: the lower one, `to`: its end. */
static int64_t leg_gap_hi(const zone *z, int64_t gap, vec to) {
  return gap < z->exact ? gap + 3 : max_of(gap + 3, boundary_gap(z, to).hi);
}
