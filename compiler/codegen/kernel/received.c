/* Zones that are received while the monitors run: pointers to tables that somebody else keeps. None,
 * 0, is unknown. Whoever filled the tables has checked them: that indices lead to edges and cells. */
/*= zone_of_outline @cells : zone_type edge_type */
/* The six numbers of an edge are its members. */
static zone zone_of_outline(const KERNEL_outline *o) {
  zone z;
  z.edges = (const edge *)(const void *)o->edges;
  z.cells = o->cells;
  z.lists = o->lists;
  z.x = o->x;
  z.y = o->y;
  z.shift = o->shift;
  z.column = o->column;
  z.row = o->row;
  z.columns = o->columns;
  z.rows = o->rows;
  z.depth = o->depth;
  z.leaves = o->leaves;
  z.exact = 0; /* its tables do not say */
  return z;
}
/*= received_clearance @cells : zone_of_outline clearance_of span_unknown */
static span received_clearance(const KERNEL_zone *received, int32_t input, span x, span y,
                               int64_t least, int64_t most) {
  if (received == 0) {
    return span_unknown(input);
  } else {
    const zone within = zone_of_outline(&received->within);
    const zone around = zone_of_outline(&received->around);
    return clearance_of(&within, &around, x, y, least, most);
  }
}
/*= received_inside @cells : zone_of_outline inside_of */
static margin received_inside(margin m, const KERNEL_zone *received, span x, span y) {
  if (received != 0) {
    const zone within = zone_of_outline(&received->within);
    const zone around = zone_of_outline(&received->around);
    return inside_of(m, &within, &around, x, y);
  }
  return m;
}
/*= bits_received @cells : zone_of_outline bits_inside */
static int32_t bits_received(int32_t bits, const KERNEL_zone *received, bounds x, bounds y) {
  if (received != 0) {
    const zone within = zone_of_outline(&received->within);
    const zone around = zone_of_outline(&received->around);
    return bits_inside(bits, &within, &around, x, y);
  }
  return bits;
}
/*= rim_type @cells : place_type */
/* What a robot is held against of a zone that is received: the outline of the zone, or of all that
 * is outside of it, and where the robot is with respect to that. */
typedef struct rim {
  const KERNEL_outline *outline; /* 0: unknown */
  place at;
  int32_t input; /* that it is received by, while it is unknown; else INPUT_NONE */
} rim;
/*= rim_of @cells : rim_type zone_of_outline place_of estimate_type */
/* Beyond the extent a robot counts as in neither of them, as with zones that are compiled in. */
static rim rim_of(const KERNEL_zone *received, int32_t input, int32_t outside, const estimate *s) {
  rim b;
  b.outline = 0;
  b.at.gap_mm = 0;
  b.at.gap_mm_hi = 0;
  b.at.inside = 0;
  b.input = input;
  if (received != 0) {
    const KERNEL_outline *const outline = outside != 0 ? &received->around : &received->within;
    const zone z = zone_of_outline(outline);
    b.outline = outline;
    b.at = place_of(&z, s->p);
    b.at.inside = outside != 0 ? b.at.inside == 0 : b.at.inside;
    b.input = INPUT_NONE;
    if (s->off_map_mm > 0) {
      b.at.inside = 0;
      b.at.gap_mm_hi += s->off_map_mm;
    }
  }
  return b;
}
/*= rim_clearance @cells : rim_type clearance_now span_unknown */
static span rim_clearance(const rim *of, const estimate *s, const body *b, const motion *m) {
  return of->outline == 0 ? span_unknown(of->input) : clearance_now(&of->at, s, b, m);
}
/*= rim_reach @cells : rim_type zone_of_outline zone_reach margin_unknown */
/* The zone is taken to stay as it is until the robot stands. */
static margin rim_reach(const rim *of, const reach *r, int64_t least_mm) {
  if (of->outline == 0) {
    return margin_unknown(of->input);
  } else {
    const zone z = zone_of_outline(of->outline);
    return zone_reach(&z, &of->at, r, least_mm);
  }
}
/*= rim_course @cells : rim_type zone_of_outline zone_course margin_unknown */
static margin rim_course(const rim *of, const course *c, int64_t least_mm) {
  if (of->outline == 0) {
    return margin_unknown(of->input);
  } else {
    const zone z = zone_of_outline(of->outline);
    return zone_course(&z, &of->at, c, least_mm);
  }
}
