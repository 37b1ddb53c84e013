/* Robots in space: zones with height, and how high a robot is and may come. Bodies are balls. */
/*= place_in_solid : place_type solid_type estimate_type in_solid solid_gap */
/* As place_seen. */
static place place_in_solid(const solid *z, const estimate *s) {
  const span gap = solid_gap(z, s->p, s->z);
  place at;
  at.gap_mm = gap.lo;
  at.gap_mm_hi = gap.hi;
  at.inside = in_solid(z, s->p, s->z);
  if (s->off_map_mm > 0) {
    at.inside = 0;
    at.gap_mm_hi += s->off_map_mm;
  }
  return at;
}
/*= tube_in_solid : solid_type segment_boundary_lo inside_zone min_of max_of */
/* How much farther than `need_mm` from the segment p-e the zone reaches, up, down and sideways:
 * below 0 unless each slab that the heights of the tube touch holds all of its shadow. The tube lies
 * in the upright cylinder over that shadow. */
static int64_t tube_in_solid(const solid *z, vec p, int64_t p_z, vec e, int64_t e_z,
                             int64_t need_mm) {
  const int64_t bottom = min_of(p_z, e_z) - need_mm;
  const int64_t top = max_of(p_z, e_z) + need_mm;
  int64_t held = bottom; /* up to there it lies in slabs */
  int64_t spare = SPAN_MAX;
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    const slab *k = &z->slabs[i];
    if (k->ceiling_mm > bottom && k->floor_mm < top) {
      const int64_t gap = inside_zone(k->base, p) ? segment_boundary_lo(k->base, p, e) : 0;
      spare = min_of(spare, gap - need_mm);
      /* the lowest one is to reach below it, the others to begin where the one before ends */
      spare = min_of(spare, held - k->floor_mm);
      held = k->ceiling_mm;
    }
  }
  return min_of(spare, held - top);
}
/*= solid_reach : tube_in_solid place_type margin_of margin_unknown max_of */
/* As zone_reach. The disc is a ball here. */
static margin solid_reach(const solid *z, const place *at, const reach *r, int64_t least_mm) {
  int64_t spare;
  if (r->input != INPUT_NONE) {
    return margin_unknown(r->input);
  }
  if (!at->inside) {
    spare = -at->gap_mm_hi - r->disc_mm - least_mm;
  } else {
    spare = at->gap_mm - r->disc_mm - least_mm;
    if (spare < 0 && r->capsule_mm < r->disc_mm) {
      spare = max_of(spare,
                     tube_in_solid(z, r->p, r->z, r->e, r->z_end, r->capsule_mm + least_mm));
    }
  }
  return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
}
/*= solid_course : tube_in_solid place_type course_type margin_of margin_false margin_unknown min_of */
/* As zone_course. */
static margin solid_course(const solid *z, const place *at, const course *c, int64_t least_mm) {
  const int64_t leg_mm = c->leg_mm + least_mm, stop_mm = c->stop_mm + least_mm;
  int64_t spare;
  int32_t i;
  if (c->input != INPUT_NONE) {
    return margin_unknown(c->input);
  }
  if (c->usable == 0) {
    return margin_false();
  }
  if (!at->inside) {
    spare = -at->gap_mm_hi - leg_mm;
    return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
  }
  spare = at->gap_mm - leg_mm;
  for (i = 1; i < c->count; ++i) {
    spare = min_of(spare, tube_in_solid(z, c->at[i - 1], c->z[i - 1], c->at[i], c->z[i], leg_mm));
  }
  for (i = c->first; i < c->count; ++i) {
    spare = min_of(spare, tube_in_solid(z, c->at[i], c->z[i], c->stop[i], c->stop_z[i], stop_mm));
    if (i > c->first) {
      spare = min_of(spare, tube_in_solid(z, c->stop[i - 1], c->stop_z[i - 1], c->stop[i],
                                          c->stop_z[i], stop_mm));
    }
  }
  return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
}
/*= altitude_now : estimate_type body_type motion_type moved_now span_of span_unknown */
/* How high the centre is, in mm. Beyond the extent nothing is known of it but that. */
static span altitude_now(const estimate *s, const body *b, const motion *m) {
  if (s->p_input != INPUT_NONE) {
    return span_unknown(s->p_input);
  } else {
    const int64_t error = s->p_error_mm + moved_now(s, b, m) + s->off_map_mm;
    return span_of(s->z - error, s->z + error);
  }
}
/*= altitude_reach : reach_type body_type margin_of margin_unknown min_of max_of */
/* The centre never comes above `limit_mm`, or below it: by disc or by capsule, either suffices. */
static margin altitude_reach(const reach *r, const body *b, int64_t limit_mm, int32_t above) {
  if (r->input != INPUT_NONE) {
    return margin_unknown(r->input);
  } else {
    const int64_t side = above != 0 ? 1 : -1;
    const int64_t now = (r->z - limit_mm) * side;
    const int64_t end = (r->z_end - limit_mm) * side;
    const int64_t spare = max_of(now - r->centre_mm, min_of(now, end) - r->capsule_mm + b->radius_mm);
    return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
  }
}
