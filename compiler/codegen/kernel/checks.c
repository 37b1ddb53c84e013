/* The checks of the library: what a property means now, and on everything within reach. */
/*= place_seen : place_of estimate_type */
/* Beyond the extent a robot is outside every zone, and farther from it than where it saturates. */
static place place_seen(const zone *z, const estimate *s) {
  place at = place_of(z, s->p);
  if (s->off_map_mm > 0) {
    at.inside = 0;
    at.gap_mm_hi += s->off_map_mm;
  }
  return at;
}
/*= clearance_now : place_type estimate_type body_type motion_type moved_now span_of span_unknown */
/* Signed gap between the body and the boundary, now; `at`: the place of the measured position. */
static span clearance_now(const place *at, const estimate *s, const body *b, const motion *m) {
  if (s->p_input != INPUT_NONE) {
    return span_unknown(s->p_input);
  } else {
    const int64_t error = s->p_error_mm + moved_now(s, b, m);
    if (at->inside) {
      return span_of(at->gap_mm - error - b->radius_mm, at->gap_mm_hi + error - b->radius_mm);
    }
    return span_of(-at->gap_mm_hi - error - b->radius_mm, -at->gap_mm + error - b->radius_mm);
  }
}
/*= zone_reach : zone_type place_type reach_type margin_of margin_unknown segment_boundary_lo max_of */
/* Every point within reach keeps `least_mm` to the boundary: disc or capsule, either suffices. No leg
 * is farther from it than where it begins: only a capsule that is narrower than the disc may leave
 * more. `at`: the place of its centre. */
static margin zone_reach(const zone *z, const place *at, const reach *r, int64_t least_mm) {
  int64_t spare;
  if (r->input != INPUT_NONE) {
    return margin_unknown(r->input);
  }
  if (!at->inside) {
    spare = -at->gap_mm_hi - r->disc_mm - least_mm;
  } else {
    spare = at->gap_mm - r->disc_mm - least_mm;
    if (spare < 0 && r->capsule_mm < r->disc_mm) {
      spare = max_of(spare, segment_boundary_lo(z, r->p, r->e) - r->capsule_mm - least_mm);
    }
  }
  return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
}
/*= plan_fault */
/* INPUT_NONE when the plan can be judged. */
static int32_t plan_fault(const KERNEL_plan *plan) {
  return plan->valid == 0 || plan->count < 0 || plan->count > PLAN_CAPACITY || plan->index < 0 ||
                 plan->index > plan->count
             ? INPUT_PLAN
             : INPUT_NONE;
}
/*= plan_unknown : margin_unknown */
static margin plan_unknown(const KERNEL_plan *plan) {
  margin m = margin_unknown(INPUT_PLAN);
  m.reason = plan->count > PLAN_CAPACITY ? REASON_OVER_CAPACITY : REASON_INPUT;
  return m;
}
/*= waypoint_of : vec_of on_map */
static vec waypoint_of(const KERNEL_plan *plan, int32_t i) {
  return vec_of(on_map(plan->x[i]), on_map(plan->y[i]));
}
/*= leg_margin : margin_of about_robots */
static margin leg_margin(int64_t spare_mm, int32_t reason, int32_t index) {
  margin m = margin_of(spare_mm * WEIGHT_MM, spare_mm * WEIGHT_MM, reason);
  m.index = index;
  return m;
}
/*= leg_gap : zone_type segment_boundary_lo inside_zone */
/* Lower bound of the clearance of a leg; below 0 when it leaves the zone. `inside`: whether `from`
 * lies in the zone, then whether `to` does; only a leg that may touch the boundary changes sides. */
static int64_t leg_gap(const zone *z, vec from, vec to, int32_t *inside) {
  const int64_t gap = segment_boundary_lo(z, from, to);
  const int32_t before = *inside;
  if (gap <= 0) {
    *inside = inside_zone(z, to);
  }
  return gap >= 0 && (!before || !*inside) ? -1 - gap : gap;
}
/*= legs_in_zone : zone_type place_type estimate_type plan_fault plan_unknown waypoint_of leg_margin leg_gap margin_and margin_true margin_unknown */
/* The leg from here to the next way-point and the next `legs` legs keep `need_mm` + errors. */
static margin legs_in_zone(const zone *z, const place *at, const estimate *s,
                           const KERNEL_plan *plan, int32_t legs, int64_t need_mm) {
  margin worst = margin_true();
  vec from = s->p;
  int32_t k, inside;
  if (plan_fault(plan) != INPUT_NONE) {
    return plan_unknown(plan);
  }
  if (plan->index >= plan->count) {
    return worst;
  }
  if (s->input != INPUT_NONE) {
    return margin_unknown(s->input);
  }
  inside = at->inside;
  for (k = 0; k <= legs && plan->index + k < plan->count; ++k) {
    const vec to = waypoint_of(plan, plan->index + k);
    const int64_t gap = leg_gap(z, from, to, &inside);
    worst = margin_and(worst, leg_margin(gap - need_mm - s->p_error_mm, REASON_LEG, k));
    from = to;
  }
  return worst;
}
/*= on_track : estimate_type plan_fault waypoint_of leg_margin margin_true point_segment_lo */
/* Legs are grown by `tracking_mm`: the robot is assumed to be that close to the leg that it drives,
 * from the way-point that it reached last to the next one. That assumption is checked here, as a
 * fact: it is violated when the measured distance exceeds it by more than the errors of position
 * and way-points, thus for certain. To ask for a proof that it holds would need room for the error
 * twice and switch on noise alone; what the error leaves open, the legs have room for: they start
 * at the measured position and are grown by its error. Before the first way-point there is no leg
 * to have left, and a plan that is done leads nowhere; a plan that is unusable fails elsewhere. */
static margin on_track(const estimate *s, const KERNEL_plan *plan, int64_t tracking_mm) {
  if (plan_fault(plan) != INPUT_NONE || plan->index == 0 || plan->index >= plan->count ||
      s->input != INPUT_NONE) {
    return margin_true();
  } else {
    const int64_t off_mm = point_segment_lo(s->p, waypoint_of(plan, plan->index - 1),
                                            waypoint_of(plan, plan->index));
    /* 1 mm: way-points are rounded to the nearest grid point */
    return leg_margin(tracking_mm + s->p_error_mm + 1 - off_mm, REASON_TRACKING, plan->index);
  }
}
/*= points_in_zone : zone_type plan_fault plan_unknown waypoint_of leg_margin margin_and margin_true inside_zone boundary_gap_lo */
/* The next `points` way-points as points: blind between them, kept for comparison. */
static margin points_in_zone(const zone *z, const KERNEL_plan *plan, int32_t points,
                             int64_t need_mm) {
  margin worst = margin_true();
  int32_t k;
  if (plan_fault(plan) != INPUT_NONE) {
    return plan_unknown(plan);
  }
  for (k = 0; k < points && plan->index + k < plan->count; ++k) {
    const vec at = waypoint_of(plan, plan->index + k);
    const int64_t gap = boundary_gap_lo(z, at);
    worst = margin_and(worst, leg_margin((inside_zone(z, at) ? gap : -gap) - need_mm,
                                         REASON_WAYPOINT, plan->index + k));
  }
  return worst;
}
/*= may_lie_in : zone_type vec_type inside_zone boundary_gap_lo */
static int32_t may_lie_in(const zone *z, vec p) {
  return inside_zone(z, p) || boundary_gap_lo(z, p) == 0;
}
/*= touches_only : may_lie_in segment_boundary_lo */
/* A leg that touches the boundary on its way to a place of the zone may lie in it: the boundary
 * belongs to the zone. Where it comes from is judged before. */
static int32_t touches_only(const zone *z, vec from, vec to) {
  return segment_boundary_lo(z, from, to) == 0 && may_lie_in(z, to);
}
/*= plan_in_zone : zone_type plan_fault plan_unknown waypoint_of leg_margin leg_gap leg_gap_hi touches_only inside_zone margin_and margin_true */
/* Every way-point and every leg of a proposed plan lies in the zone. `need_mm` covers the rounding
 * of the way-points; a leg outside may be farther from the zone than `leg_gap` says. */
static margin plan_in_zone(const zone *z, const KERNEL_plan *plan, int64_t need_mm) {
  margin worst = margin_true();
  int32_t k, inside;
  if (plan_fault(plan) != INPUT_NONE) {
    return plan_unknown(plan);
  }
  inside = plan->count > 0 && inside_zone(z, waypoint_of(plan, 0));
  for (k = 0; k < plan->count; ++k) {
    const vec to = waypoint_of(plan, k);
    const vec from = k > 0 ? waypoint_of(plan, k - 1) : to;
    const int64_t gap = leg_gap(z, from, to, &inside);
    const int64_t least = gap < -1 ? -leg_gap_hi(z, -1 - gap, to) : gap;
    margin leg = leg_margin(least - need_mm, REASON_LEG, k);
    if (gap >= 0 || (gap == -1 && touches_only(z, from, to))) {
      leg.hi = (leg_gap_hi(z, gap, to) + need_mm) * WEIGHT_MM;
    }
    worst = margin_and(worst, leg);
  }
  return worst;
}
/*= other_type : estimate_type reach_type */
/* Another robot as it was heard. */
typedef struct other {
  estimate s;
  reach r;      /* under any control */
  int32_t held; /* its promise outlasts the horizon, and may be relied upon */
  /*? is_absent */ int32_t absent; /* it says so itself, and the message is fresh */
  /*? is_far */ int64_t off_mm; /* along the longer axis; -1: not seen well enough to tell */
  /*? is_far */ int32_t far;    /* no margin depends on it, and nothing else of it is known */
} other;
/*= is_absent : other_type */
static int32_t is_absent(const other *o) {
  return o->absent;
}
/*= is_far : other_type */
static int32_t is_far(const other *o) {
  return o->far;
}
/*= nearer_of : other_type estimate_type body_type usable within_speeds vec_of minus dot magnitude max_of min_of */
/* How far off another robot is, where nothing is wrong with what was heard of it and it is as exact
 * as the grid: only then its errors are known without a closer look. Returns the squared distance of
 * the nearest such robot, that of those before being `nearest_mm2`. */
static int64_t nearer_of(other *o, const KERNEL_other *in, const estimate *self, const body *b,
                         int64_t now_us, int64_t nearest_mm2) {
  const KERNEL_point *p = &in->position;
  const KERNEL_point *v = &in->velocity;
  const int64_t most_mmps = b->speed_mmps + b->velocity_error_mmps + 2; /* see estimate_of */
  /*? in_space */ int64_t up_mm;
  vec u, d;
  if (o->s.input != INPUT_NONE || !usable(p, now_us, b->position_age_us) ||
      !usable(v, now_us, b->velocity_age_us) || !within_speeds(v) || p->x_hi - p->x_lo > 1 ||
      p->y_hi - p->y_lo > 1 || p->x_lo < -EXTENT_MM || p->x_hi > EXTENT_MM ||
      p->y_lo < -EXTENT_MM || p->y_hi > EXTENT_MM) {
    return nearest_mm2;
  }
  u = vec_of(v->x_lo, v->y_lo);
  d = minus(vec_of(p->x_lo, p->y_lo), self->p);
  /*? in_space */ if (p->z_hi - p->z_lo > 1 || p->z_lo < -EXTENT_MM || p->z_hi > EXTENT_MM ||
  /*? in_space */     dot(u, u) + v->z_lo * v->z_lo > most_mmps * most_mmps) {
  /*? !in_space */ if (dot(u, u) > most_mmps * most_mmps) {
    return nearest_mm2;
  }
  /*? in_space */ up_mm = p->z_lo - self->z;
  /*? in_space */ o->off_mm = max_of(max_of(magnitude(d.x), magnitude(d.y)), magnitude(up_mm));
  /*? in_space */ return min_of(nearest_mm2, dot(d, d) + up_mm * up_mm);
  /*? !in_space */ o->off_mm = max_of(magnitude(d.x), magnitude(d.y));
  /*? !in_space */ return min_of(nearest_mm2, dot(d, d));
}
/*= far_from : reach_of estimate_type body_type motion_type max_of root_up */
/* How far off a robot has to be for its margins to be larger than those of the nearest one, and than
 * `least_mm`, whatever their errors and whatever both do: a margin of distance is no larger than the
 * distance of the centres, and smaller by no more than both may cover. `heard_mm`: the other one's
 * reach, at its greatest speed and age; 10: what is rounded. */
static int64_t far_from(int64_t nearest_mm2, const estimate *self, const body *b,
                        int64_t accel_mmps2, int64_t horizon_us, int64_t heard_mm,
                        int64_t least_mm) {
  motion fastest;
  reach widest;
  if (self->input != INPUT_NONE || nearest_mm2 == INT64_MAX) {
    return INT64_MAX;
  }
  fastest.speed_mmps = max_of(b->speed_mmps, self->speed_mmps + self->v_error_mmps);
  fastest.accel_mmps2 = accel_mmps2;
  fastest.recovery = 0;
  widest = reach_of(self, b, &fastest, horizon_us);
  return max_of(root_up(nearest_mm2), least_mm) + widest.disc_mm + heard_mm + 10;
}
/*= distance_now : other_type body_type motion_type moved_now span_of span_unknown minus dot root_down */
static span distance_now(const estimate *s, const other *o, const body *b, const motion *m,
                         const motion *any, int32_t index) {
  span gap;
  if (s->p_input != INPUT_NONE) {
    return span_unknown(s->p_input);
  }
  if (o->s.p_input != INPUT_NONE) {
    gap = span_unknown(INPUT_OTHER_ROBOT);
  } else {
    const vec d = minus(s->p, o->s.p);
    const int64_t error = s->p_error_mm + moved_now(s, b, m) + o->s.p_error_mm +
                          (o->held != 0 ? b->hold_mm : moved_now(&o->s, b, any));
    /*? in_space */ const int64_t up_mm = s->z - o->s.z;
    /*? in_space */ const int64_t centre = root_down(dot(d, d) + up_mm * up_mm);
    /*? !in_space */ const int64_t centre = root_down(dot(d, d));
    gap = span_of(centre - error - 2 * b->radius_mm, centre + 1 + error - 2 * b->radius_mm);
  }
  gap.other = index;
  return gap;
}
/*= pair_spare @plane : other_type body_type point_gap_lo point_segment_lo segment_gap_lo max_of */
/* Spare gap between everything within reach of two robots; disc or capsule for either. No leg is
 * farther from anything than where it begins: only a capsule that is narrower than the disc may leave
 * more. */
static int64_t pair_spare(const reach *r, const other *o, const body *b) {
  const int64_t still = o->s.p_error_mm + b->hold_mm + b->radius_mm;
  const int64_t axis = o->held != 0 ? still : o->r.disc_mm;
  const int32_t narrow = r->capsule_mm < r->disc_mm;
  int64_t spare = point_gap_lo(r->p, o->s.p) - r->disc_mm - axis;
  if (narrow) {
    spare = max_of(spare, point_segment_lo(o->s.p, r->p, r->e) - r->capsule_mm - axis);
  }
  if (o->held == 0 && o->r.capsule_mm < o->r.disc_mm) {
    spare = max_of(spare,
                   point_segment_lo(r->p, o->r.p, o->r.e) - r->disc_mm - o->r.capsule_mm);
    if (narrow) {
      spare = max_of(spare,
                     segment_gap_lo(r->p, r->e, o->r.p, o->r.e) - r->capsule_mm - o->r.capsule_mm);
    }
  }
  return spare;
}
/*= pair_spare @in_space : other_type body_type spot_of spot_gap_lo spot_segment_lo spots_apart_lo max_of */
/* Spare gap between everything within reach of two robots in space; disc, here a ball, or capsule
 * for either, where that is narrower. */
static int64_t pair_spare(const reach *r, const other *o, const body *b) {
  const int64_t still = o->s.p_error_mm + b->hold_mm + b->radius_mm;
  const int64_t axis = o->held != 0 ? still : o->r.disc_mm;
  const spot p = spot_of(r->p, r->z), e = spot_of(r->e, r->z_end);
  const spot q = spot_of(o->s.p, o->s.z), f = spot_of(o->r.e, o->r.z_end);
  const int32_t narrow = r->capsule_mm < r->disc_mm;
  int64_t spare = spot_gap_lo(p, q) - r->disc_mm - axis;
  if (narrow) {
    spare = max_of(spare, spot_segment_lo(q, p, e) - r->capsule_mm - axis);
  }
  if (o->held == 0 && o->r.capsule_mm < o->r.disc_mm) {
    spare = max_of(spare, spot_segment_lo(p, q, f) - r->disc_mm - o->r.capsule_mm);
    if (narrow) {
      spare = max_of(spare, spots_apart_lo(p, e, q, f) - r->capsule_mm - o->r.capsule_mm);
    }
  }
  return spare;
}
/*= pair_reach : pair_spare margin_of margin_unknown about_robots */
static margin pair_reach(const reach *r, const other *o, const body *b, int64_t least_mm,
                         int32_t index) {
  margin m;
  if (r->input != INPUT_NONE) {
    return margin_unknown(r->input);
  }
  if (o->s.input != INPUT_NONE) {
    m = margin_unknown(INPUT_OTHER_ROBOT);
  } else {
    const int64_t spare = pair_spare(r, o, b) - least_mm;
    m = margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
  }
  m.other = index;
  return m;
}
/*= legs_apart : other_type plan_fault plan_unknown waypoint_of leg_margin margin_and margin_true margin_unknown segment_gap_lo point_segment_lo about_robots */
/* The next legs keep away from a robot that is HELD, and from the next legs of a robot that goes
 * first. `need_mm`: bodies, standoff and the tracking of one robot; the other's comes on top. */
static margin legs_apart(const estimate *s, const KERNEL_plan *plan, const other *o,
                         const KERNEL_plan *theirs, int32_t legs, int64_t need_mm, int64_t hold_mm,
                         int64_t tracking_mm, int32_t goes_first, int32_t index) {
  margin worst = margin_true();
  vec from = s->p;
  int32_t k, j;
  if (plan_fault(plan) != INPUT_NONE) {
    return plan_unknown(plan);
  }
  if (plan->index >= plan->count || (o->held == 0 && !goes_first)) {
    return worst;
  }
  if (s->input != INPUT_NONE) {
    return margin_unknown(s->input);
  }
  if (o->s.input != INPUT_NONE || (o->held == 0 && plan_fault(theirs) != INPUT_NONE)) {
    worst = margin_unknown(INPUT_OTHER_ROBOT);
    worst.other = index;
    return worst;
  }
  for (k = 0; k <= legs && plan->index + k < plan->count; ++k) {
    const vec to = waypoint_of(plan, plan->index + k);
    const int64_t errors = s->p_error_mm + o->s.p_error_mm;
    if (o->held != 0) {
      const int64_t gap = point_segment_lo(o->s.p, from, to);
      worst = margin_and(worst, leg_margin(gap - need_mm - errors - hold_mm, REASON_LEG, k));
    } else {
      vec start = o->s.p;
      for (j = 0; j <= legs && theirs->index + j < theirs->count; ++j) {
        const vec end = waypoint_of(theirs, theirs->index + j);
        const int64_t gap = segment_gap_lo(from, to, start, end);
        worst = margin_and(worst, leg_margin(gap - need_mm - errors - tracking_mm, REASON_LEG, k));
        start = end;
      }
    }
    from = to;
  }
  worst.other = index;
  return worst;
}
/*= cells_type */
/* Per square cell, row by row from the south-west: an upper bound, over the whole cell, of what
 * the way to the site takes. NO_BODY: no body fits there; NO_WAY: no way that is known. And the
 * site, with what the driving alone takes: no way is shorter than the straight one. */
typedef struct cells {
  const int32_t *value;
  int32_t origin_x, origin_y, cell_mm, columns, rows;
  int32_t site_x, site_y, drive_ppm_per_m;
} cells;
/*= cell_index : clamp_of */
static int32_t cell_index(int64_t at, int32_t origin, int32_t cell_mm, int32_t count) {
  const int64_t offset = at - origin;
  const int64_t i = offset < 0 ? -1 : offset / cell_mm;
  return (int32_t)clamp_of(i, -1, count);
}
/*= way_lo : cells_type vec_type minus dot root_down vec_of max_of */
/* Lower bound of what the way takes from within `radius_mm` of `p`. The cells are no help: they
 * bound the way from above, and how far above they do not say. */
static int64_t way_lo(const cells *c, vec p, int64_t radius_mm) {
  const vec d = minus(p, vec_of(c->site_x, c->site_y));
  return max_of(root_down(dot(d, d)) - radius_mm, 0) * c->drive_ppm_per_m / 1000;
}
/*= cells_span : cells_type way_lo cell_index min_of max_of span_of */
/* What the way takes from within `radius_mm` of `p`: at most the largest value over the cells there
 * that a body fits into; no way when there is none, or none in the table. */
static span cells_span(const cells *c, vec p, int64_t radius_mm) {
  const int32_t x0 = cell_index(p.x - radius_mm, c->origin_x, c->cell_mm, c->columns);
  const int32_t x1 = cell_index(p.x + radius_mm, c->origin_x, c->cell_mm, c->columns);
  const int32_t y0 = cell_index(p.y - radius_mm, c->origin_y, c->cell_mm, c->rows);
  const int32_t y1 = cell_index(p.y + radius_mm, c->origin_y, c->cell_mm, c->rows);
  int64_t hi = -1;
  int32_t x, y;
  for (y = y0 > 0 ? y0 : 0; y <= y1 && y < c->rows; ++y) {
    for (x = x0 > 0 ? x0 : 0; x <= x1 && x < c->columns; ++x) {
      hi = max_of(hi, c->value[y * c->columns + x]); /* NO_BODY is below all others */
    }
  }
  hi = hi < 0 ? NO_WAY : hi;
  return span_of(min_of(way_lo(c, p, radius_mm), hi), hi);
}
/*= sensed_age : span_of span_unknown elapsed_us */
/* Time since the newest sample, us; unknown when it holds no numbers, or its stamp lies in the
 * future or before `last_us`, the latest one of all samples. */
static span sensed_age(int32_t valid, int64_t stamp_us, int64_t now_us, int64_t last_us,
                       int32_t input) {
  const int64_t age_us =
      valid != 0 && stamp_us >= last_us && stamp_us <= now_us ? elapsed_us(stamp_us, now_us) : -1;
  return age_us < 0 || age_us > AGE_MAX_US ? span_unknown(input) : span_of(age_us, age_us);
}
/*= charge_now : span_of span_unknown div_up elapsed_us */
/* Charge left now, in ppm: a sample of some age, drained since. Beyond empty and full by more than
 * the error (and 1 ppm of the grid) it is unknown. The upper end leaves out what a charger may have
 * added since: while it charges, `violated` may last as long as a sample. */
static span charge_now(const KERNEL_scalar *battery, int64_t now_us, int64_t max_age_us,
                       int64_t error_ppm, int64_t drain_ppm_per_s) {
  const int64_t age_us = elapsed_us(battery->stamp_us, now_us);
  if (battery->valid == 0 || battery->stamp_us > now_us || age_us > max_age_us ||
      battery->lo > battery->hi || battery->lo < -error_ppm - 1 ||
      battery->hi > 1000000 + error_ppm + 1) {
    return span_unknown(INPUT_BATTERY);
  }
  return span_of(battery->lo - error_ppm - div_up(drain_ppm_per_s * div_up(age_us, 1000), 1000),
                 battery->hi + error_ppm);
}
/*= energy_now : cells_span estimate_type body_type motion_type moved_now span_unknown */
static span energy_now(const cells *c, const estimate *s, const body *b, const motion *m) {
  return s->p_input != INPUT_NONE ? span_unknown(s->p_input)
                                  : cells_span(c, s->p, s->p_error_mm + moved_now(s, b, m));
}
/*= energy_reach : cells_span reach_type margin_of margin_unknown div_up span_type */
/* From everywhere within reach the charge suffices for the way, `reserve_ppm` included. */
static margin energy_reach(const cells *c, const reach *r, span charge, int64_t reserve_ppm,
                           int64_t drain_ppm_per_s, int64_t horizon_us) {
  if (r->input != INPUT_NONE) {
    return margin_unknown(r->input);
  }
  if (charge.input != INPUT_NONE) {
    return margin_unknown(charge.input);
  } else {
    const span way = cells_span(c, r->p, r->centre_mm);
    const int64_t spare = charge.lo - way.hi - reserve_ppm -
                          div_up(drain_ppm_per_s * div_up(horizon_us, 1000), 1000);
    return margin_of(spare * WEIGHT_PPM, spare * WEIGHT_PPM, REASON_MARGIN);
  }
}
/*= charge_reach : span_type margin_of margin_unknown div_up */
/* The charge stays at `least_ppm` or above until the horizon. */
static margin charge_reach(span charge, int64_t least_ppm, int64_t drain_ppm_per_s,
                           int64_t horizon_us) {
  if (charge.input != INPUT_NONE) {
    return margin_unknown(charge.input);
  } else {
    const int64_t spare =
        charge.lo - least_ppm - div_up(drain_ppm_per_s * div_up(horizon_us, 1000), 1000);
    return margin_of(spare * WEIGHT_PPM, spare * WEIGHT_PPM, REASON_MARGIN);
  }
}
/*= heading_fault : elapsed_us */
/* INPUT_NONE when the robot knows where it looks to. */
static int32_t heading_fault(const KERNEL_scalar *heading, int64_t now_us, int64_t max_age_us) {
  return heading->valid == 0 || heading->lo > heading->hi || heading->stamp_us > now_us ||
                 elapsed_us(heading->stamp_us, now_us) > max_age_us
             ? INPUT_HEADING
             : INPUT_NONE;
}
/*= steered : margin_and margin_unknown */
/* No bound of the look-ahead depends on the heading, but without it nobody steers the robot: what
 * lies ahead is unknown, unless it is known to fail anyway. */
static margin steered(margin ahead, int32_t fault) {
  return fault == INPUT_NONE ? ahead : margin_and(ahead, margin_unknown(fault));
}
/*= held_for : margin_type margin_of */
/* `operand for n ticks`: runs of ticks, the present one included, on which it was true (run[0]) and
 * on which it was not false (run[1]). Nothing is granted before n ticks have passed. */
static margin held_for(margin operand, int32_t *run, int32_t ticks, int32_t new_tick) {
  margin m = operand;
  int32_t i;
  for (i = 0; i < 2; ++i) {
    if ((i == 0 ? operand.lo : operand.hi) < 0) {
      run[i] = 0;
    } else if (new_tick != 0 && run[i] <= ticks) {
      run[i] += 1;
    }
  }
  m.lo = run[0] > ticks || operand.lo < 0 ? operand.lo : -1;
  m.hi = run[1] > ticks || operand.hi < 0 ? operand.hi : -1;
  return m;
}
