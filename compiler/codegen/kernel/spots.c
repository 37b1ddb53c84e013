/* Distances in space, of places and segments: bounds from below. Coordinates within +-2^29 mm, so
 * that three squares of differences fit 62 bits. */
/*= spot_type */
/* A place in space, or a direction. */
typedef struct spot {
  int64_t x, y, z;
} spot;
/*= spot_of : spot_type vec_type */
static spot spot_of(vec p, int64_t z) {
  spot s;
  s.x = p.x;
  s.y = p.y;
  s.z = z;
  return s;
}
/*= spot_way : spot_type */
static spot spot_way(spot from, spot to) {
  spot s;
  s.x = to.x - from.x;
  s.y = to.y - from.y;
  s.z = to.z - from.z;
  return s;
}
/*= spot_dot : spot_type */
static int64_t spot_dot(spot a, spot b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/*= spot_cross : spot_type */
/* At right angles to both. */
static spot spot_cross(spot a, spot b) {
  spot s;
  s.x = a.y * b.z - a.z * b.y;
  s.y = a.z * b.x - a.x * b.z;
  s.z = a.x * b.y - a.y * b.x;
  return s;
}
/*= spot_length_up : spot_type magnitude max_of root_up */
/* The length of what may be as long as a product, from above: halved until its squares fit. */
static int64_t spot_length_up(spot n) {
  int64_t x = magnitude(n.x), y = magnitude(n.y), z = magnitude(n.z);
  int64_t by = 1;
  while (max_of(max_of(x, y), z) >= INT64_C(1) << 30) {
    x = x / 2 + 1;
    y = y / 2 + 1;
    z = z / 2 + 1;
    by *= 2;
  }
  return root_up(x * x + y * y + z * z) * by;
}
/*= spot_sized : spot_type magnitude max_of */
/* The same direction with its longest component from 2^28 on and below 2^29, but for what is cut
 * off: 2^-28 of it. No direction stays none. */
static spot spot_sized(spot n) {
  const int64_t most = max_of(max_of(magnitude(n.x), magnitude(n.y)), magnitude(n.z));
  int64_t by = 1;
  if (most >= INT64_C(1) << 29) {
    while (most / by >= INT64_C(1) << 29) {
      by *= 2;
    }
    n.x /= by;
    n.y /= by;
    n.z /= by;
  } else if (most > 0) {
    while (most * by < INT64_C(1) << 28) {
      by *= 2;
    }
    n.x *= by;
    n.y *= by;
    n.z *= by;
  }
  return n;
}
/*= shadows_apart : spot_sized spot_dot root_up min_of max_of */
/* Segments a-b and c-d are no closer to each other than their shadows on a line of any direction
 * are; 0 where these overlap. So a direction that is wrong makes the bound smaller, never larger. */
static int64_t shadows_apart(spot direction, spot a, spot b, spot c, spot d) {
  const spot n = spot_sized(direction);
  const int64_t an = spot_dot(a, n), bn = spot_dot(b, n), cn = spot_dot(c, n), dn = spot_dot(d, n);
  const int64_t gap = max_of(min_of(an, bn) - max_of(cn, dn), min_of(cn, dn) - max_of(an, bn));
  return gap <= 0 ? 0 : gap / root_up(spot_dot(n, n));
}
/*= spot_gap_lo : spot_way spot_dot root_down */
static int64_t spot_gap_lo(spot a, spot b) {
  const spot d = spot_way(a, b);
  return root_down(spot_dot(d, d));
}
/*= way_to_spot : spot_way spot_dot spot_cross spot_sized */
/* The direction of the shortest way from the segment a-b to p. */
static spot way_to_spot(spot a, spot b, spot p) {
  const spot d = spot_way(a, b);
  const spot q = spot_way(a, p);
  const int64_t along = spot_dot(q, d);
  if (along <= 0) {
    return q;
  }
  if (along >= spot_dot(d, d)) {
    return spot_way(b, p);
  }
  return spot_cross(d, spot_sized(spot_cross(q, d)));
}
/*= spot_segment_lo : way_to_spot shadows_apart */
static int64_t spot_segment_lo(spot p, spot a, spot b) {
  return shadows_apart(way_to_spot(a, b, p), a, b, p, p);
}
/*= spots_apart_lo : way_to_spot shadows_apart spot_cross max_of */
/* Of two segments. The shortest way between them is at right angles to both, or it begins or ends
 * at an end of one. */
static int64_t spots_apart_lo(spot a, spot b, spot c, spot d) {
  int64_t gap = shadows_apart(spot_cross(spot_way(a, b), spot_way(c, d)), a, b, c, d);
  gap = max_of(gap, shadows_apart(way_to_spot(a, b, c), a, b, c, d));
  gap = max_of(gap, shadows_apart(way_to_spot(a, b, d), a, b, c, d));
  gap = max_of(gap, shadows_apart(way_to_spot(c, d, a), a, b, c, d));
  return max_of(gap, shadows_apart(way_to_spot(c, d, b), a, b, c, d));
}
