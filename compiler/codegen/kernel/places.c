/* Measured places against zones, for monitors without a robot. A place is known within a box.
 * Coordinates within +-(2^29 + 2^27) mm, those of zones within +-2^29 mm: products of a difference
 * and of a doubled one fit 62 bits, differences of two of them 63. */
/*= box_type */
typedef struct box {
  int64_t x0, x1, y0, y1;
} box;
/*= box_sides : box_type edge_type */
/* On which sides of the line of the edge the corners of the box lie: 1 left, 2 right, 4 on it. */
static int32_t box_sides(const edge *e, const box *b) {
  const int64_t dx = e->bx - (int64_t)e->ax;
  const int64_t dy = e->by - (int64_t)e->ay;
  int32_t sides = 0;
  int32_t k;
  for (k = 0; k < 4; ++k) {
    const int64_t x = (k & 1) != 0 ? b->x1 : b->x0;
    const int64_t y = (k & 2) != 0 ? b->y1 : b->y0;
    const int64_t c = dx * (y - e->ay) - dy * (x - e->ax);
    sides |= c > 0 ? 1 : (c < 0 ? 2 : 4);
  }
  return sides;
}
/*= middle_inside @edges : zone_type box_type */
/* Even-odd rule for the middle of the box, its coordinates doubled. Exact; of places on the boundary
 * it says nothing. */
static int32_t middle_inside(const zone *z, const box *b) {
  const int64_t x = b->x0 + b->x1;
  const int64_t y = b->y0 + b->y1;
  int32_t inside = 0;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const edge *e = &z->edges[i];
    if ((2 * (int64_t)e->ay > y) != (2 * (int64_t)e->by > y)) {
      const int64_t c = (e->bx - (int64_t)e->ax) * (y - 2 * (int64_t)e->ay) -
                        (e->by - (int64_t)e->ay) * (x - 2 * (int64_t)e->ax);
      if ((e->by > e->ay) == (c > 0)) {
        inside = !inside;
      }
    }
  }
  return inside;
}
/*= box_and_edge : edge_type box_sides min_of max_of */
/* How an edge lies to the box: 0 apart from it, 1 touches it, all of its inside on one side, 2 goes
 * through it, 3 contains it. */
static int32_t box_and_edge(const edge *e, const box *b) {
  const int64_t left = min_of(e->ax, e->bx), right = max_of(e->ax, e->bx);
  const int64_t low = min_of(e->ay, e->by), high = max_of(e->ay, e->by);
  if (left > b->x1 || right < b->x0 || low > b->y1 || high < b->y0) {
    return 0;
  } else {
    const int32_t sides = box_sides(e, b);
    const int32_t meets_x = b->x0 == b->x1 || (left < b->x1 && right > b->x0);
    const int32_t meets_y = b->y0 == b->y1 || (low < b->y1 && high > b->y0);
    if (sides == 4 && left <= b->x0 && right >= b->x1 && low <= b->y0 && high >= b->y1) {
      return 3;
    }
    if (meets_x && meets_y && ((sides & 3) == 3 || sides == 4)) {
      return 2;
    }
    return sides != 1 && sides != 2;
  }
}
/*= box_in_zone @edges : box_and_edge middle_inside */
/* 1: all of the box lies in the zone, boundary included; -1: none of it does; 0: neither. Exact,
 * but that 0 may stand for 1 when a vertex of the zone lies on a box without width. */
static int32_t box_in_zone(const zone *z, const box *b) {
  int32_t touched = 0;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const int32_t lies = box_and_edge(&z->edges[i], b);
    if (lies > 1) {
      return lies == 3; /* the box is a part of the boundary */
    }
    touched = touched || lies == 1;
  }
  return middle_inside(z, b) ? 1 : (touched ? 0 : -1);
}
/*= box_in_zone @cells : box_and_edge cell_at cell_count cell_edge cell_inside vec_of */
/* 1: all of the box lies in the zone, boundary included; -1: none of it does; 0: neither. Exact,
 * but that 0 may stand for 1 when a vertex of the zone lies on a box without width. A box of at most
 * 1 mm lies in one closed cell. */
static int32_t box_in_zone(const zone *z, const box *b) {
  const cell c = cell_at(z, vec_of(b->x0, b->y0));
  int32_t touched = 0;
  int32_t i;
  for (i = 0; i < cell_count(c.word); ++i) {
    const int32_t lies = box_and_edge(cell_edge(z, c.word, i), b);
    if (lies > 1) {
      return lies == 3; /* the box is a part of the boundary */
    }
    touched = touched || lies == 1;
  }
  return cell_inside(z, &c, b->x0 + b->x1, b->y0 + b->y1) ? 1 : (touched ? 0 : -1);
}
/*= middle_clearance : zone_type box_type vec_of minus dot span_of place_of root_up */
/* Signed distance from the boundary of every place of the box: that of its middle, taken down to the
 * grid, and how far the box reaches from there. Places with an error e are at most e sqrt(2) from the
 * measured one, and that is somewhere off the middle: the two together are longer than what the box
 * reaches by less than 1 mm, which a box of at most 2 mm rounds away. */
static span middle_clearance(const zone *z, const box *b) {
  const vec p = vec_of(b->x0 + (b->x1 - b->x0) / 2, b->y0 + (b->y1 - b->y0) / 2);
  const vec half = minus(vec_of(b->x1, b->y1), p);
  const int64_t room = root_up(dot(half, half)) + (half.x > 1 || half.y > 1);
  const place at = place_of(z, p);
  return at.inside ? span_of(at.gap_mm - room, at.gap_mm_hi + room)
                   : span_of(-at.gap_mm_hi - room, -at.gap_mm + room);
}
/*= cell_in_zone : box_in_zone */
/* The same of a place that was measured without error: it lies in one cell of the grid at most. What
 * is known of a place with an error is how far from its middle it may be. */
static int32_t cell_in_zone(const zone *z, const box *b) {
  return b->x1 - b->x0 <= 1 && b->y1 - b->y0 <= 1 ? box_in_zone(z, b) : 0;
}
/*= box_of : box_type span_type */
static box box_of(span x, span y) {
  box b;
  b.x0 = x.lo;
  b.x1 = x.hi;
  b.y0 = y.lo;
  b.y1 = y.hi;
  return b;
}
/*= clearance_of : cell_in_zone middle_clearance box_of quantity_missing span_of min_of max_of */
/* Signed distance of a place from the boundary of a zone that contains `within` and lies in
 * `around`; `least`, `most`: what it can be at all. */
static span clearance_of(const zone *within, const zone *around, span x, span y, int64_t least,
                         int64_t most) {
  int32_t known;
  const span missing = quantity_missing(x, y, &known);
  if (!known) {
    return missing;
  } else {
    const box b = box_of(x, y);
    span c = middle_clearance(within, &b);
    c.hi = min_of(middle_clearance(around, &b).hi, most);
    c.lo = max_of(c.lo, cell_in_zone(within, &b) > 0 ? 0 : least);
    return c;
  }
}
/*= bits_inside : cell_in_zone box_of span_bounds bounds_known bits_type */
/* The verdict of inside_of; `bits`: that of `m`. */
static int32_t bits_inside(int32_t bits, const zone *within, const zone *around, bounds x, bounds y) {
  if (bits == BITS_UNKNOWN && bounds_known(x) && bounds_known(y)) {
    const box b = box_of(span_bounds(x), span_bounds(y));
    if (cell_in_zone(within, &b) > 0) {
      return BITS_TRUE;
    }
    if (cell_in_zone(around, &b) < 0) {
      return BITS_FALSE;
    }
  }
  return bits;
}
/*= inside_of : cell_in_zone box_of margin_type span_type min_of max_of */
/* `m`: the margin of the clearance of a place that is at least 0. Its bounds are some mm wide;
 * whether a place without error is in the zone is known better. */
static margin inside_of(margin m, const zone *within, const zone *around, span x, span y) {
  if (x.input == INPUT_NONE && y.input == INPUT_NONE) {
    const box b = box_of(x, y);
    if (cell_in_zone(within, &b) > 0) {
      m.lo = max_of(m.lo, 0);
    }
    if (cell_in_zone(around, &b) < 0) {
      m.hi = min_of(m.hi, -1);
    }
  }
  return m;
}
