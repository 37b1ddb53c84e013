/* Measured places against zones with height, for monitors without a robot. A place is known within a
 * brick. Coordinates and heights as in places.c, so that sums of three squares are below 2^62. */
/*= slab_type : zone_type */
/* A zone of the plane, from one height to another; both belong to it. */
typedef struct slab {
  const zone *base;
  int32_t floor_mm, ceiling_mm;
} slab;
/*= solid_type : slab_type */
/* Slabs from below to above, whose insides are apart. */
typedef struct solid {
  const slab *slabs;
  int32_t count;
} solid;
/*= brick_type : box_type */
typedef struct brick {
  box base;
  int64_t z0, z1;
} brick;
/*= in_solid : solid_type inside_zone */
/* Right for every integer place off the boundary. */
static int32_t in_solid(const solid *s, vec p, int64_t z) {
  int32_t i;
  for (i = 0; i < s->count; ++i) {
    const slab *k = &s->slabs[i];
    if (k->floor_mm <= z && z <= k->ceiling_mm && inside_zone(k->base, p)) {
      return 1;
    }
  }
  return 0;
}
/*= solid_gap : solid_type span_of inside_zone boundary_gap root_down root_up min_of max_of */
/* Bounds of the distance to the boundary, 4 mm apart where those of its slabs are 3: to the walls of
 * every slab, and to floors and ceilings straight below and above, where a slab and its neighbour
 * differ. What is nearest of those elsewhere is their edge, where a wall begins; there it does not
 * matter on which side of the wall the place counts. No place is 1,720 km away from a wall. */
static span solid_gap(const solid *s, vec p, int64_t z) {
  int64_t least = INT64_MAX; /* squares */
  int64_t most = INT64_MAX;
  int64_t top = 0;   /* the ceiling of the slab before */
  int32_t below = 0; /* the place is in that slab, but for its height */
  int32_t i;
  for (i = 0; i < s->count; ++i) {
    const slab *k = &s->slabs[i];
    const int32_t inside = inside_zone(k->base, p);
    const int32_t joined = below && top == k->floor_mm;
    const int64_t up = max_of(max_of(k->floor_mm - z, z - k->ceiling_mm), 0);
    if (below && !joined) {
      least = min_of(least, (z - top) * (z - top));
      most = min_of(most, (z - top) * (z - top));
    }
    if (inside != joined) {
      least = min_of(least, (z - k->floor_mm) * (z - k->floor_mm));
      most = min_of(most, (z - k->floor_mm) * (z - k->floor_mm));
    }
    if (up * up < least) {
      const span across = boundary_gap(k->base, p);
      const int64_t far = min_of(across.hi, INT64_C(1720000000));
      least = min_of(least, across.lo * across.lo + up * up);
      most = min_of(most, far * far + up * up);
    }
    top = k->ceiling_mm;
    below = inside;
  }
  if (below) {
    least = min_of(least, (z - top) * (z - top));
    most = min_of(most, (z - top) * (z - top));
  }
  return span_of(root_down(least), root_up(most));
}
/*= brick_clearance : brick_type vec_of minus dot span_of in_solid solid_gap root_up */
/* As middle_clearance. What a measured place is off the middle, in two directions across that in which
 * the brick may be long, and its error come to 2 mm more than the brick reaches; of a cell, where
 * they are at most 2 mm together, to nothing. */
static span brick_clearance(const solid *s, const brick *b) {
  const vec p = vec_of(b->base.x0 + (b->base.x1 - b->base.x0) / 2,
                       b->base.y0 + (b->base.y1 - b->base.y0) / 2);
  const int64_t z = b->z0 + (b->z1 - b->z0) / 2;
  const vec half = minus(vec_of(b->base.x1, b->base.y1), p);
  const int64_t square = dot(half, half) + (b->z1 - z) * (b->z1 - z);
  const int32_t is_cell = b->base.x1 - b->base.x0 <= 1 && b->base.y1 - b->base.y0 <= 1 &&
                          b->z1 - b->z0 <= 1;
  const int64_t room = root_up(square) + (is_cell ? 0 : 2);
  const span gap = solid_gap(s, p, z);
  return in_solid(s, p, z) ? span_of(gap.lo - room, gap.hi + room)
                           : span_of(-gap.hi - room, -gap.lo + room);
}
/*= cell_in_solid : solid_type brick_type box_in_zone */
/* As cell_in_zone: 1: all of the cell lies in the solid, -1: none of it, 0: neither, or not a cell. */
static int32_t cell_in_solid(const solid *s, const brick *b) {
  int32_t met = 0;
  int32_t i;
  if (b->base.x1 - b->base.x0 > 1 || b->base.y1 - b->base.y0 > 1 || b->z1 - b->z0 > 1) {
    return 0;
  }
  for (i = 0; i < s->count; ++i) {
    const slab *k = &s->slabs[i];
    if (k->floor_mm <= b->z1 && k->ceiling_mm >= b->z0) {
      const int32_t in = box_in_zone(k->base, &b->base);
      if (in > 0 && k->floor_mm <= b->z0 && k->ceiling_mm >= b->z1) {
        return 1;
      }
      met = met || in >= 0;
    }
  }
  return met ? 0 : -1;
}
/*= brick_of : brick_type box_of */
static brick brick_of(span x, span y, span z) {
  brick b;
  b.base = box_of(x, y);
  b.z0 = z.lo;
  b.z1 = z.hi;
  return b;
}
/*= clearance_in_space : cell_in_solid brick_clearance brick_of quantity_missing span_of min_of max_of */
/* As clearance_of. */
static span clearance_in_space(const solid *within, const solid *around, span x, span y, span z,
                               int64_t least, int64_t most) {
  int32_t plane_known, known;
  const span plane = quantity_missing(x, y, &plane_known);
  const span missing = quantity_missing(plane_known ? x : plane, z, &known);
  if (!known) {
    return missing;
  } else {
    const brick b = brick_of(x, y, z);
    span c = brick_clearance(within, &b);
    c.hi = min_of(brick_clearance(around, &b).hi, most);
    c.lo = max_of(c.lo, cell_in_solid(within, &b) > 0 ? 0 : least);
    return c;
  }
}
/*= bits_in_space : cell_in_solid brick_of span_bounds bounds_known bits_type */
/* As bits_inside. */
static int32_t bits_in_space(int32_t bits, const solid *within, const solid *around, bounds x,
                             bounds y, bounds z) {
  if (bits == BITS_UNKNOWN && bounds_known(x) && bounds_known(y) && bounds_known(z)) {
    const brick b = brick_of(span_bounds(x), span_bounds(y), span_bounds(z));
    if (cell_in_solid(within, &b) > 0) {
      return BITS_TRUE;
    }
    if (cell_in_solid(around, &b) < 0) {
      return BITS_FALSE;
    }
  }
  return bits;
}
/*= inside_in_space : cell_in_solid brick_of margin_type span_type min_of max_of */
/* As inside_of. */
static margin inside_in_space(margin m, const solid *within, const solid *around, span x, span y,
                              span z) {
  if (x.input == INPUT_NONE && y.input == INPUT_NONE && z.input == INPUT_NONE) {
    const brick b = brick_of(x, y, z);
    if (cell_in_solid(within, &b) > 0) {
      m.lo = max_of(m.lo, 0);
    }
    if (cell_in_solid(around, &b) < 0) {
      m.hi = min_of(m.hi, -1);
    }
  }
  return m;
}
