/* Legs and paths, for monitors without a robot: places one after the other and the straight ways
 * between them. Places within +-2^29 mm, as zones. */
/*= path_type */
/* A path that was received: way-points in mm, and which of them is the next. */
typedef struct path {
  const int64_t *x, *y;
  int32_t count, next;
  int32_t known; /* 0: nothing is known of it */
} path;
/*= path_seen : path_type */
/* `fresh`: its sample counts. Unknown with more than `most` way-points, with one that is not finite or
 * off the map, and with a next one that it does not have; that of a path that is done is its count. */
static path path_seen(int32_t fresh, const int64_t *x, const int64_t *y, int32_t count,
                      int32_t next, int32_t most) {
  const int64_t map_mm = INT64_C(1) << 29;
  path p;
  int32_t k;
  p.x = x;
  p.y = y;
  p.count = count;
  p.next = next;
  p.known = fresh && count >= 0 && count <= most && next >= 0 && next <= count;
  for (k = 0; p.known && k < count; ++k) {
    p.known = x[k] >= -map_mm && x[k] <= map_mm && y[k] >= -map_mm && y[k] <= map_mm;
  }
  return p;
}
/*= path_given : path_type margin_true margin_false margin_unknown */
static margin path_given(path p, int32_t input) {
  if (!p.known) {
    return margin_unknown(input);
  }
  return p.count > 0 ? margin_true() : margin_false();
}
/*= bits_given : path_type bits_type */
static int32_t bits_given(path p) {
  return !p.known ? BITS_UNKNOWN : p.count > 0 ? BITS_TRUE : BITS_FALSE;
}
/*= trail_type : vec_type */
/* Up to two places of its own, then way-points of a path. */
typedef struct trail {
  vec own[2];
  int32_t owned;
  const int64_t *x, *y;
  int32_t first, end; /* way-points from first to before end */
  int64_t room_mm;    /* a true place of its own is that near */
  int32_t input;      /* what is missing; INPUT_NONE: nothing */
} trail;
/*= trail_none : trail_type */
static trail trail_none(void) {
  trail t;
  t.owned = 0;
  t.x = 0;
  t.y = 0;
  t.first = 0;
  t.end = 0;
  t.room_mm = 0;
  t.input = INPUT_NONE;
  return t;
}
/*= trail_start : trail_type span_type quantity_missing vec_of minus dot root_up max_of */
/* A place of its own: the middle of where it may be, taken down to the grid, and how far the true
 * one is from there; 2 mm for what one place of the trail is off its middle where another one has an
 * error. */
static trail trail_start(trail t, span x, span y) {
  int32_t known;
  const span missing = quantity_missing(x, y, &known);
  if (!known) {
    t.input = t.input != INPUT_NONE ? t.input : missing.input;
  } else {
    const vec p = vec_of(x.lo + (x.hi - x.lo) / 2, y.lo + (y.hi - y.lo) / 2);
    const vec half = minus(vec_of(x.hi, y.hi), p);
    t.own[t.owned] = p;
    t.owned += 1;
    const int32_t is_cell = x.hi - x.lo <= 1 && y.hi - y.lo <= 1;
    t.room_mm = max_of(t.room_mm, root_up(dot(half, half)) + (is_cell ? 0 : 2));
  }
  return t;
}
/*= trail_then : trail_type path_type min_of */
/* Then way-points of the path from `first` on, at most so many. */
static trail trail_then(trail t, path p, int32_t first, int32_t most, int32_t input) {
  if (!p.known) {
    t.input = t.input != INPUT_NONE ? t.input : input;
  } else {
    t.x = p.x;
    t.y = p.y;
    t.first = first;
    t.end = first + (int32_t)min_of(most, p.count - first);
  }
  return t;
}
/*= trail_of_place : trail_none trail_start */
static trail trail_of_place(span x, span y) {
  return trail_start(trail_none(), x, y);
}
/*= trail_of_leg : trail_none trail_start */
static trail trail_of_leg(span x, span y, span to_x, span to_y) {
  return trail_start(trail_start(trail_none(), x, y), to_x, to_y);
}
/*= trail_of_path : trail_none trail_then */
static trail trail_of_path(path p, int32_t input) {
  return trail_then(trail_none(), p, 0, INT32_MAX, input);
}
/*= trail_ahead : trail_of_place trail_then */
/* From a place to the next way-points of the path, at most so many; the place alone behind the last. */
static trail trail_ahead(span x, span y, path p, int32_t most, int32_t input) {
  return trail_then(trail_of_place(x, y), p, p.next, most, input);
}
/*= trail_places : trail_type */
static int32_t trail_places(const trail *t) {
  return t->owned + t->end - t->first;
}
/*= trail_place : trail_type vec_of */
static vec trail_place(const trail *t, int32_t k) {
  const int32_t i = t->first + k - t->owned;
  return k < t->owned ? t->own[k] : vec_of(t->x[i], t->y[i]);
}
/*= signed_gap : place_of span_of */
/* Distance of a place from the boundary, negative outside; `turned`: negative inside. */
static span signed_gap(const zone *z, vec p, int32_t turned) {
  const place at = place_of(z, p);
  return (at.inside != 0) != (turned != 0) ? span_of(at.gap_mm, at.gap_mm_hi)
                                           : span_of(-at.gap_mm_hi, -at.gap_mm);
}
/*= part_of_way : vec_type vec_of */
/* k of 2048 parts of the way from a to b, less than 1 mm from there in x and in y. */
static vec part_of_way(vec a, vec b, int32_t k) {
  return vec_of(a.x + (b.x - a.x) * k / 2048, a.y + (b.y - a.y) * k / 2048);
}
/*= half_down */
static int64_t half_down(int64_t a) {
  return (a - (a & 1)) / 2;
}
/*= stretch_type */
/* Of a way, between two of its 2048 parts: what is known of the distances there from below. */
typedef struct stretch {
  int32_t from, to;
  int64_t lo_from, lo_to; /* of its ends */
  int64_t least;          /* of all of it */
} stretch;
/*= stretch_of : stretch_type half_down */
/* A distance changes by no more than the way does, `length` for 2048 parts. 2 mm: ends are rounded to
 * the grid. */
static stretch stretch_of(int32_t from, int64_t lo_from, int32_t to, int64_t lo_to,
                          int64_t length) {
  stretch s;
  s.from = from;
  s.to = to;
  s.lo_from = lo_from;
  s.lo_to = lo_to;
  s.least = half_down(lo_from + lo_to - length * (to - from) / 2048 - 1) - 2;
  return s;
}
/*= crossing_gap : signed_gap part_of_way stretch_of minus dot root_up span_of min_of */
/* The least signed distance of the places of a leg which is not all on the right side. The stretch that
 * may be least is divided, time and again: 32 times, or until it is known to 8 mm. */
static span crossing_gap(const zone *z, vec a, vec b, int32_t turned) {
  const vec d = minus(b, a);
  const int64_t length = root_up(dot(d, d));
  const span start = signed_gap(z, a, turned), end = signed_gap(z, b, turned);
  span least = span_of(start.lo, min_of(start.hi, end.hi));
  stretch all[33];
  int32_t count = 1;
  int32_t low = 0;
  int32_t k;
  all[0] = stretch_of(0, start.lo, 2048, end.lo, length);
  while (count < 33 && all[low].to - all[low].from > 1 && least.hi - all[low].least > 8) {
    const stretch s = all[low];
    const int32_t middle = (s.from + s.to) / 2;
    const span at = signed_gap(z, part_of_way(a, b, middle), turned);
    least.hi = min_of(least.hi, at.hi + 2);
    all[low] = stretch_of(s.from, s.lo_from, middle, at.lo, length);
    all[count] = stretch_of(middle, at.lo, s.to, s.lo_to, length);
    count += 1;
    for (low = 0, k = 1; k < count; ++k) {
      low = all[k].least < all[low].least ? k : low;
    }
  }
  least.lo = all[low].least;
  return least;
}
/*= leg_clearance : segment_boundary_lo inside_zone leg_gap_hi crossing_gap span_of min_of */
/* The least signed distance of the places of a leg. A lower bound of 1 mm or more of its distance
 * from the boundary says that it does not touch it. */
static span leg_clearance(const zone *z, vec a, vec b, int32_t turned) {
  const int64_t gap = segment_boundary_lo(z, a, b);
  if (gap >= 1 && (inside_zone(z, a) != 0) != (turned != 0)) {
    const int64_t hi = leg_gap_hi(z, gap, b);
    /* farther off than the tables know, places along it tell more */
    return span_of(gap, hi > gap + 3 ? min_of(hi, crossing_gap(z, a, b, turned).hi) : hi);
  } else {
    span least = crossing_gap(z, a, b, turned);
    least.hi = min_of(least.hi, gap >= 1 ? -gap : gap < 0 ? 0 : leg_gap_hi(z, gap, b));
    return least;
  }
}
/*= trail_least : trail_type trail_places trail_place leg_clearance span_of min_of */
/* Of all its legs; of one place the way from there to itself. */
static span trail_least(const zone *z, const trail *t, int32_t turned) {
  const int32_t places = trail_places(t);
  span least = leg_clearance(z, trail_place(t, 0), trail_place(t, places > 1 ? 1 : 0), turned);
  int32_t k;
  for (k = 2; k < places; ++k) {
    const span leg = leg_clearance(z, trail_place(t, k - 1), trail_place(t, k), turned);
    least.lo = min_of(least.lo, leg.lo);
    least.hi = min_of(least.hi, leg.hi);
  }
  return span_of(least.lo - t->room_mm, least.hi + t->room_mm);
}
/*= trail_unknown : trail_type trail_places span_unknown */
/* Nothing is said of a trail without a place: who asks asks first whether there is one. */
static int32_t trail_unknown(const trail *t, span *missing) {
  *missing = span_unknown(t->input != INPUT_NONE ? t->input : INPUT_CLOCK);
  return t->input != INPUT_NONE || trail_places(t) == 0;
}
/*= trail_clearance : trail_unknown trail_least span_of min_of */
/* The least clearance of its places in a zone that contains `within` and lies in `around`; or the
 * greatest, which is the least on the other side turned round. `most`: what it can be at all. */
static span trail_clearance(const zone *within, const zone *around, trail t, int32_t greatest,
                            int64_t most) {
  span missing;
  if (trail_unknown(&t, &missing)) {
    return missing;
  } else {
    span c = trail_least(greatest ? around : within, &t, greatest);
    if (within != around) {
      c.hi = trail_least(greatest ? within : around, &t, greatest).hi;
    }
    return greatest ? span_of(-c.hi, min_of(-c.lo, most)) : span_of(c.lo, min_of(c.hi, most));
  }
}
/*= ends_on : edge_type vec_of side_of box_gap */
/* Whether an end of the edge lies on the leg from a to b. */
static int32_t ends_on(const edge *e, vec a, vec b) {
  const vec p = vec_of(e->ax, e->ay), q = vec_of(e->bx, e->by);
  return (box_gap(p, p, a, b) <= 0 && side_of(a, b, p) == 0) ||
         (box_gap(q, q, a, b) <= 0 && side_of(a, b, q) == 0);
}
/*= vertex_on_leg @edges : zone_type ends_on */
static int32_t vertex_on_leg(const zone *z, vec a, vec b) {
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    if (ends_on(&z->edges[i], a, b)) {
      return 1;
    }
  }
  return 0;
}
/*= vertex_on_leg @cells : cell_at cell_count cell_edge next_cell ends_on */
/* The edges of a vertex on the leg are those of a cell that it passes. */
static int32_t vertex_on_leg(const zone *z, vec a, vec b) {
  vec at = a;
  int32_t more = 1;
  int32_t i, k;
  for (i = 0; i < z->leaves && more; ++i) {
    const cell c = cell_at(z, at);
    for (k = 0; k < cell_count(c.word); ++k) {
      if (ends_on(cell_edge(z, c.word, k), a, b)) {
        return 1;
      }
    }
    more = next_cell(&c, a, b, &at);
  }
  return more;
}
/*= trail_crosses : trail_type trail_unknown trail_places trail_place segment_boundary_lo vertex_on_leg */
/* Whether one of its legs crosses the boundary, for certain: then it meets the zone and, `leaving`, a
 * part of it is outside. Where a vertex lies on the leg, two parts of the zone may touch there, and
 * the leg lead from one into the other. */
static int32_t trail_crosses(const zone *z, const trail *t, int32_t leaving) {
  span missing;
  int32_t k;
  if (trail_unknown(t, &missing) || t->room_mm > 0) {
    return 0;
  }
  for (k = 1; k < trail_places(t); ++k) {
    const vec from = trail_place(t, k - 1), to = trail_place(t, k);
    if (segment_boundary_lo(z, from, to) < 0 && (!leaving || !vertex_on_leg(z, from, to))) {
      return 1;
    }
  }
  return 0;
}
/*= trail_inside : trail_crosses margin_type min_of */
/* `m`: the margin of its clearance. Bounds of distances are some mm wide; a leg that crosses the
 * boundary leaves the zone, or enters it, however little. */
static margin trail_inside(margin m, const zone *z, trail t, int32_t outside) {
  if (m.lo < 0 && m.hi >= 0 && trail_crosses(z, &t, !outside)) {
    m.hi = min_of(m.hi, -1);
  }
  return m;
}
/*= bits_trail : trail_crosses bits_type */
/* The verdict of trail_inside; `bits`: that of `m`. */
static int32_t bits_trail(int32_t bits, const zone *z, trail t, int32_t outside) {
  return bits == BITS_UNKNOWN && trail_crosses(z, &t, !outside) ? BITS_FALSE : bits;
}
/*= received_trail @cells : zone_of_outline trail_clearance span_unknown */
static span received_trail(const KERNEL_zone *received, int32_t input, trail t, int32_t greatest,
                           int64_t most) {
  if (received == 0) {
    return span_unknown(input);
  } else {
    const zone within = zone_of_outline(&received->within);
    const zone around = zone_of_outline(&received->around);
    return trail_clearance(&within, &around, t, greatest, most);
  }
}
/*= received_trail_inside @cells : zone_of_outline trail_inside */
static margin received_trail_inside(margin m, const KERNEL_zone *received, int32_t outside,
                                    trail t) {
  if (received != 0) {
    const zone z = zone_of_outline(outside ? &received->within : &received->around);
    return trail_inside(m, &z, t, outside);
  }
  return m;
}
/*= bits_received_trail @cells : zone_of_outline bits_trail */
static int32_t bits_received_trail(int32_t bits, const KERNEL_zone *received, int32_t outside,
                                   trail t) {
  if (received != 0) {
    const zone z = zone_of_outline(outside ? &received->within : &received->around);
    return bits_trail(bits, &z, t, outside);
  }
  return bits;
}
/*= legs_apart_mm : cross_each_other segment_of near_point across_lo min_of root_down root_up span_of */
/* The distance between two legs: of ends exactly, to 1 mm; across a leg less than 3 mm above the lower
 * bound. */
static span legs_apart_mm(vec a, vec b, vec c, vec d) {
  segment s = segment_of(a, b);
  segment t = segment_of(c, d);
  int64_t square = INT64_MAX;
  span gap = span_of(SPAN_MAX, SPAN_MAX);
  if (cross_each_other(a, b, c, d)) {
    return span_of(0, 0);
  }
  near_point(&t, a, &square);
  near_point(&t, b, &square);
  near_point(&s, c, &square);
  near_point(&s, d, &square);
  if (s.across < INT64_MAX) {
    gap.lo = min_of(gap.lo, across_lo(&s));
  }
  if (t.across < INT64_MAX) {
    gap.lo = min_of(gap.lo, across_lo(&t));
  }
  gap.hi = gap.lo < SPAN_MAX ? gap.lo + 3 : gap.hi;
  if (square < INT64_MAX) {
    gap.lo = min_of(gap.lo, root_down(square));
    gap.hi = min_of(gap.hi, root_up(square));
  }
  return gap;
}
/*= trails_apart : trail_type trail_unknown trail_places trail_place legs_apart_mm span_of max_of min_of */
/* The least distance between places of both. */
static span trails_apart(trail a, trail b) {
  span missing;
  if (trail_unknown(&a, &missing) || trail_unknown(&b, &missing)) {
    return missing;
  } else {
    const int32_t last_a = trail_places(&a) - 1, last_b = trail_places(&b) - 1;
    const int64_t room = a.room_mm + b.room_mm;
    span gap = span_of(SPAN_MAX, SPAN_MAX);
    int32_t i, k;
    for (i = 0; i == 0 || i < last_a; ++i) {
      const vec from = trail_place(&a, i), to = trail_place(&a, i < last_a ? i + 1 : i);
      for (k = 0; k == 0 || k < last_b; ++k) {
        const vec start = trail_place(&b, k), end = trail_place(&b, k < last_b ? k + 1 : k);
        const span legs = legs_apart_mm(from, to, start, end);
        gap.lo = min_of(gap.lo, legs.lo);
        gap.hi = min_of(gap.hi, legs.hi);
      }
    }
    return span_of(max_of(gap.lo - room, 0), gap.hi + room);
  }
}
