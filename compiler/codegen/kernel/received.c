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
  z.exact = 0; /* no legs are held against it */
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
