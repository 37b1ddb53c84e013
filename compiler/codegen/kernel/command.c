/* Where a point mass can be under the commands that it is known to have and under the one that the
 * advanced controller proposes, until its recovery has stopped it. Lengths in mm, speeds in mm/s,
 * times in us, unless named otherwise. Source: the look-ahead under the commanded input of the
 * theory of this project. Beyond it: a command begins to act at any time within the latency, the
 * recovery takes over at any time from now on, and the speed saturates; what that adds is argued in
 * docs/command.md, in the order of `sail`. */
/*= order_type */
/* What is declared of commands. */
typedef struct order {
  int64_t most_mmps2;  /* the robot follows commands up to this size */
  int64_t error_mmps2; /* between true and commanded acceleration, what pushes it included */
  int64_t latency_us;
} order;
/*= course_type : vec_type */
/* The way under known commands: legs from `at[0]` on, and where it stops when the recovery takes
 * over at each of those that are still to come, `first` and later. The body stays within `leg_mm`
 * of the legs, and within `stop_mm` of the ways to the stops and of those between the stops. */
typedef struct course {
  int32_t input;  /* that is missing */
  int32_t usable; /* else any control has to be assumed */
  int32_t count, first;
  vec at[COURSE_MAX], stop[COURSE_MAX];
  /*? in_space */ int64_t z[COURSE_MAX], stop_z[COURSE_MAX];
  int64_t leg_mm, stop_mm;
} course;
/*= sailing_type : vec_type */
/* A course in the making: from where the sample was taken, um and um/s. */
typedef struct sailing {
  int64_t t_us, x_um, y_um, vx_umps, vy_umps;
  /*? in_space */ int64_t z_um, vz_umps, z; /* z: of p */
  int64_t p_error_um, v_error_umps; /* beside those of the sample */
  int64_t leg_bend_um, stop_bend_um; /* of the curved way from its chords */
  int64_t fastest_umps;              /* while the recovery may take over */
  int64_t cap_umps, brake_umps2;
  int64_t now_us; /* since the sample */
  vec p;          /* where it was taken, mm */
} sailing;
/*= command_of : root_up dot vec_of */
/* What was commanded, if the robot follows it. 2: the corner of the grid. */
static KERNEL_command command_of(const KERNEL_point *u, int64_t time_us, const order *o) {
  const int64_t most = o->most_mmps2 + 2;
  KERNEL_command c;
  c.time_us = time_us;
  c.x_mmps2 = u->x_lo;
  c.y_mmps2 = u->y_lo;
  /*? in_space */ c.z_mmps2 = u->z_lo;
  c.known = u->valid != 0 && u->x_lo >= -most && u->x_lo <= most && u->y_lo >= -most &&
            u->y_lo <= most && u->x_hi >= u->x_lo && u->x_hi <= u->x_lo + 1 &&
            u->y_hi >= u->y_lo && u->y_hi <= u->y_lo + 1 &&
            /*? in_space */ u->z_lo >= -most && u->z_lo <= most && u->z_hi >= u->z_lo &&
            /*? in_space */ u->z_hi <= u->z_lo + 1 &&
            /*? in_space */ root_up(u->x_lo * u->x_lo + u->y_lo * u->y_lo + u->z_lo * u->z_lo) <= most;
            /*? !in_space */ root_up(dot(vec_of(u->x_lo, u->y_lo), vec_of(u->x_lo, u->y_lo))) <= most;
  return c;
}
/*= keep_command : command_of */
/* The newest first. */
static void keep_command(KERNEL_command *kept, const KERNEL_point *sent, int64_t time_us,
                         const order *o) {
  int32_t i;
  for (i = COMMANDS - 1; i > 0; --i) {
    kept[i] = kept[i - 1];
  }
  kept[0] = command_of(sent, time_us, o);
}
/*= place_on_course : course_type sailing_type vec_of on_map root_up max_of */
/* The next place, and, when the recovery may take over there, where it stops. */
static void place_on_course(course *c, sailing *w) {
  /*? in_space */ const int64_t z = w->z + w->z_um / 1000;
  /*? in_space */ const int64_t speed = root_up(w->vx_umps * w->vx_umps + w->vy_umps * w->vy_umps +
  /*? in_space */                               w->vz_umps * w->vz_umps);
  /*? in_space */ const int64_t stop_z = z + w->vz_umps * speed / (2 * w->brake_umps2) / 1000;
  /*? !in_space */ const int64_t speed = root_up(w->vx_umps * w->vx_umps + w->vy_umps * w->vy_umps);
  const vec at = vec_of(w->p.x + w->x_um / 1000, w->p.y + w->y_um / 1000);
  vec stop;
  if (c->count == COURSE_MAX || at.x != on_map(at.x) || at.y != on_map(at.y)) {
    c->usable = 0;
    return;
  }
  stop = vec_of(at.x + w->vx_umps * speed / (2 * w->brake_umps2) / 1000,
                at.y + w->vy_umps * speed / (2 * w->brake_umps2) / 1000);
  if (stop.x != on_map(stop.x) || stop.y != on_map(stop.y)) {
    c->usable = 0;
    return;
  }
  /*? in_space */ if (z != on_map(z) || stop_z != on_map(stop_z)) {
  /*? in_space */   c->usable = 0;
  /*? in_space */   return;
  /*? in_space */ }
  /*? in_space */ c->z[c->count] = z;
  /*? in_space */ c->stop_z[c->count] = stop_z;
  c->at[c->count] = at;
  c->stop[c->count] = stop;
  if (w->t_us >= w->now_us) {
    w->fastest_umps = max_of(w->fastest_umps, speed);
    c->first = c->first < 0 ? c->count : c->first;
  }
  c->count += 1;
}
/*= sail : place_on_course sailing_type course_type root_up root_down div_up min_of max_of */
/* One leg under the command `u`, until `until_us`. With a = |u| h, what it changes of the velocity:
 * the speed saturates at the cap V by a projection, of which the end of the leg is one step; `over`
 * is what it takes away. The projection that goes on all the time ends within a over / V of it, and
 * on the way the velocity differs from the straight line by no more than `off`: by what it takes to
 * the cap and what is over, and by the bend along the cap. The way bends away from its chord by
 * |u| h^2 / 8; the stop v |v| / (2 b) by a^2 / (8 b) and, where it saturates, V off / b. */
static void sail(course *c, sailing *w, const KERNEL_command *u, int64_t until_us) {
  const int64_t h_us = until_us - w->t_us;
  /*? in_space */ const int64_t size = root_up(u->x_mmps2 * u->x_mmps2 + u->y_mmps2 * u->y_mmps2 +
  /*? in_space */                              u->z_mmps2 * u->z_mmps2);
  /*? !in_space */ const int64_t size = root_up(u->x_mmps2 * u->x_mmps2 + u->y_mmps2 * u->y_mmps2);
  const int64_t gained = div_up(size * h_us, 1000);
  const int64_t cap = w->cap_umps;
  int64_t vx, vy, speed, over, off = 0;
  /*? in_space */ int64_t vz;
  if (h_us <= 0 || c->usable == 0) {
    return;
  }
  if (gained > GAINED_MAX_UMPS) {
    c->usable = 0; /* squares would not fit */
    return;
  }
  vx = w->vx_umps + u->x_mmps2 * h_us / 1000;
  vy = w->vy_umps + u->y_mmps2 * h_us / 1000;
  /*? in_space */ vz = w->vz_umps + u->z_mmps2 * h_us / 1000;
  /*? in_space */ speed = root_up(vx * vx + vy * vy + vz * vz);
  /*? !in_space */ speed = root_up(vx * vx + vy * vy);
  over = max_of(0, speed - cap);
  if (over > 0) {
    /*? in_space */ const int64_t was = root_down(w->vx_umps * w->vx_umps + w->vy_umps * w->vy_umps +
    /*? in_space */                               w->vz_umps * w->vz_umps);
    /*? in_space */ const int64_t below = max_of(0, cap - was);
    /*? !in_space */ const int64_t below =
    /*? !in_space */     max_of(0, cap - root_down(w->vx_umps * w->vx_umps + w->vy_umps * w->vy_umps));
    const int64_t bend = div_up(gained * gained, cap);
    off = min_of(over, below + bend) + div_up(bend, 4) + 2;
    vx = vx * cap / speed;
    vy = vy * cap / speed;
    /*? in_space */ vz = vz * cap / speed;
  }
  /*? in_space */ w->z_um += (w->vz_umps + vz) * h_us / 2000000;
  /*? in_space */ w->vz_umps = vz;
  w->x_um += (w->vx_umps + vx) * h_us / 2000000;
  w->y_um += (w->vy_umps + vy) * h_us / 2000000;
  w->vx_umps = vx;
  w->vy_umps = vy;
  w->t_us = until_us;
  /*? in_space */ w->v_error_umps += 2; /* of the third axis */
  /*? in_space */ w->p_error_um += 2;
  /* 4: the divisions above */
  w->v_error_umps += div_up(gained * over, cap) + 4;
  w->p_error_um += div_up(off * h_us, 1000000) + 4;
  w->leg_bend_um = max_of(w->leg_bend_um, div_up(gained * h_us, 8000000));
  w->stop_bend_um =
      max_of(w->stop_bend_um,
             div_up(gained * h_us, 8000000) + div_up(gained * gained, 8 * w->brake_umps2) +
                 div_up(cap * off, w->brake_umps2));
  place_on_course(c, w);
}
/*= sail_on : sail */
/* The same, with a place for now. */
static void sail_on(course *c, sailing *w, const KERNEL_command *u, int64_t until_us) {
  if (w->t_us < w->now_us && w->now_us < until_us) {
    sail(c, w, u, w->now_us);
  }
  sail(c, w, u, until_us);
}
/*= oldest_command */
/* Which of the kept commands surely acts when the sample is taken; COMMANDS: none is known to. All
 * later ones have to be known, too. */
static int32_t oldest_command(const KERNEL_command *kept, int64_t now_us, int64_t age_us,
                              int64_t latency_us) {
  int32_t i;
  for (i = 0; i < COMMANDS; ++i) {
    if (kept[i].known == 0) {
      return COMMANDS;
    }
    if (elapsed_us(kept[i].time_us, now_us) >= age_us + latency_us) {
      return i;
    }
  }
  return COMMANDS;
}
/*= sail_commands : sail_on oldest_command sailing_type course_type root_up div_up min_of max_of elapsed_us */
/* Each command takes over from the one before halfway through the latency, half a latency from when
 * it really does: in between the velocity goes wrong by their difference. */
static void sail_commands(course *c, sailing *w, const KERNEL_command *kept,
                          const KERNEL_command *proposed, const order *o, int64_t now_us,
                          int64_t end_us) {
  int32_t k = oldest_command(kept, now_us, w->now_us, o->latency_us);
  if (k == COMMANDS) {
    c->usable = 0;
    return;
  }
  for (; k >= 0; --k) {
    const KERNEL_command *next = k > 0 ? &kept[k - 1] : proposed;
    const int64_t since_us = min_of(elapsed_us(next->time_us, now_us), w->now_us + o->latency_us);
    const int64_t until_us = w->now_us - since_us + o->latency_us / 2;
    const int64_t dx = next->x_mmps2 - kept[k].x_mmps2, dy = next->y_mmps2 - kept[k].y_mmps2;
    /*? in_space */ const int64_t dz = next->z_mmps2 - kept[k].z_mmps2;
    sail_on(c, w, &kept[k], min_of(until_us, end_us));
    /*? in_space */ w->v_error_umps +=
    /*? in_space */     div_up(root_up(dx * dx + dy * dy + dz * dz) * div_up(o->latency_us + 1, 2), 1000);
    /*? !in_space */ w->v_error_umps += div_up(root_up(dx * dx + dy * dy) * div_up(o->latency_us + 1, 2), 1000);
  }
  sail_on(c, w, proposed, w->t_us + (end_us - w->t_us) / 2);
  sail_on(c, w, proposed, end_us);
}
/*= sideways @in_space : spot_of spot_way spot_dot spot_cross spot_length_up root_up root_down div_up max_of course_type */
/* Between two places and their stops lies nothing that is farther from the ways to the stops and
 * from the one between them than this: twice how far the four lie off one line. */
static int64_t sideways(const course *c, int32_t i) {
  const spot from = spot_of(c->at[i - 1], c->z[i - 1]);
  const spot d = spot_way(from, spot_of(c->stop[i], c->stop_z[i]));
  const spot e = spot_way(from, spot_of(c->at[i], c->z[i]));
  const spot f = spot_way(from, spot_of(c->stop[i - 1], c->stop_z[i - 1]));
  const int64_t length = root_down(spot_dot(d, d));
  if (length == 0) {
    return 2 * max_of(root_up(spot_dot(e, e)), root_up(spot_dot(f, f)));
  }
  return 2 * max_of(div_up(spot_length_up(spot_cross(d, e)), length),
                    div_up(spot_length_up(spot_cross(d, f)), length));
}
/*= sideways @plane : vec_of minus cross dot root_up root_down div_up max_of magnitude course_type */
/* Between two places and their stops lies nothing that is farther from the ways to the stops and
 * from the one between them than this: twice how far the four lie off one line. */
static int64_t sideways(const course *c, int32_t i) {
  const vec d = minus(c->stop[i], c->at[i - 1]);
  const vec e = minus(c->at[i], c->at[i - 1]), f = minus(c->stop[i - 1], c->at[i - 1]);
  const int64_t length = root_down(dot(d, d));
  if (length == 0) {
    return 2 * max_of(root_up(dot(e, e)), root_up(dot(f, f)));
  }
  return 2 * div_up(max_of(magnitude(cross(d, e)), magnitude(cross(d, f))), length);
}
/*= course_room : course_type sailing_type estimate_type body_type order_type sideways div_up min_of max_of */
/* How wide the course is, with all errors until `end_us`, the body and the tube of the brake. */
static void course_room(course *c, const sailing *w, const estimate *s, const body *b,
                        const order *o, int64_t end_us) {
  const int64_t t_ms = div_up(end_us, 1000);
  const int64_t v_error = s->v_error_mmps + div_up(w->v_error_umps, 1000);
  const int64_t drift = v_error + div_up(o->error_mmps2 * t_ms, 1000);
  const int64_t fastest = div_up(w->fastest_umps, 1000);
  const int64_t s1 = min_of(b->speed_mmps, fastest + drift);
  const int64_t ideal = div_up(s1 * s1, 2 * b->brake_mmps2);
  const int64_t tube = div_up(s1 * b->brake_lag_ms, 1000) +
                       /*? disturbed */ div_up(ideal * b->sway_permille, 1000) +
                       div_up(ideal * b->brake_lag_permille, 1000) + b->hold_mm;
  /* 3: two millimetres of the corners of places, one of the estimate */
  /*? in_space */ int64_t off = s->p_error_mm + div_up(w->p_error_um, 1000) + div_up(v_error * t_ms, 1000) +
  /*? in_space */               div_up(o->error_mmps2 * t_ms * t_ms, 2000000) + b->radius_mm + 3;
  /*? !in_space */ const int64_t off = s->p_error_mm + div_up(w->p_error_um, 1000) + div_up(v_error * t_ms, 1000) +
  /*? !in_space */                     div_up(o->error_mmps2 * t_ms * t_ms, 2000000) + b->radius_mm + 3;
  int64_t between = 0;
  int32_t i;
  for (i = c->first + 1; i < c->count; ++i) {
    between = max_of(between, sideways(c, i));
  }
  /*? in_space */ off += 2; /* of a third axis of those corners */
  c->leg_mm = off + div_up(w->leg_bend_um, 1000);
  c->stop_mm = off + div_up(w->stop_bend_um, 1000) + between + tube +
               div_up((fastest + s1) * drift, 2 * b->brake_mmps2);
}
/*= course_of : course_type sailing_type estimate_type body_type order_type command_of sail_commands place_on_course course_room root_up */
/* The course under `proposed` until the recovery takes over, at the latest `horizon_us` from now. */
static course course_of(const estimate *s, const body *b, const order *o,
                        const KERNEL_command *kept, const KERNEL_point *proposal, int64_t now_us,
                        int64_t horizon_us) {
  const KERNEL_command proposed = command_of(proposal, now_us, o);
  const int64_t end_us = s->age_us + horizon_us;
  sailing w;
  course c;
  c.input = s->input;
  c.usable = s->input == INPUT_NONE && proposed.known != 0;
  c.count = 0;
  c.first = -1;
  c.leg_mm = 0;
  c.stop_mm = 0;
  if (c.usable == 0) {
    return c;
  }
  w.t_us = 0;
  w.x_um = 0;
  w.y_um = 0;
  w.cap_umps = 1000 * b->speed_mmps;
  w.brake_umps2 = 1000 * b->brake_mmps2;
  w.vx_umps = 1000 * s->v.x;
  w.vy_umps = 1000 * s->v.y;
  /*? in_space */ w.z_um = 0;
  /*? in_space */ w.vz_umps = 1000 * s->vz;
  /*? in_space */ w.z = s->z;
  if (s->speed_mmps > b->speed_mmps) { /* the true velocity is no larger, and nearer to this one */
    w.vx_umps = w.vx_umps * b->speed_mmps / s->speed_mmps;
    w.vy_umps = w.vy_umps * b->speed_mmps / s->speed_mmps;
    /*? in_space */ w.vz_umps = w.vz_umps * b->speed_mmps / s->speed_mmps;
  }
  w.p_error_um = 0;
  w.v_error_umps = 2;
  w.leg_bend_um = 0;
  w.stop_bend_um = 0;
  w.fastest_umps = 0;
  w.now_us = s->age_us;
  w.p = s->p;
  place_on_course(&c, &w);
  sail_commands(&c, &w, kept, &proposed, o, now_us, end_us);
  if (c.usable != 0) {
    course_room(&c, &w, s, b, o, end_us);
  }
  return c;
}
/*= zone_course : zone_type place_type course_type margin_of margin_false margin_unknown segment_boundary_lo min_of */
/* Everything on the course keeps `least_mm` to the boundary. `at`: the place of its beginning. */
static margin zone_course(const zone *z, const place *at, const course *c, int64_t least_mm) {
  int64_t spare;
  int32_t i;
  if (c->input != INPUT_NONE) {
    return margin_unknown(c->input);
  }
  if (c->usable == 0) {
    return margin_false();
  }
  if (!at->inside) {
    spare = -at->gap_mm_hi - c->leg_mm - least_mm;
    return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
  }
  spare = at->gap_mm - c->leg_mm;
  for (i = 1; i < c->count; ++i) {
    spare = min_of(spare, segment_boundary_lo(z, c->at[i - 1], c->at[i]) - c->leg_mm);
  }
  for (i = c->first; i < c->count; ++i) {
    spare = min_of(spare, segment_boundary_lo(z, c->at[i], c->stop[i]) - c->stop_mm);
    if (i > c->first) {
      spare = min_of(spare, segment_boundary_lo(z, c->stop[i - 1], c->stop[i]) - c->stop_mm);
    }
  }
  spare -= least_mm;
  return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
}
/*= leg_apart @in_space : other_type spot_type spot_of spot_segment_lo spots_apart_lo max_of */
/* Spare gap between what is within `room_mm` of a leg and everything within reach of a robot. */
static int64_t leg_apart(spot from, spot to, int64_t room_mm, const other *o, const body *b) {
  const int64_t still = o->s.p_error_mm + b->hold_mm + b->radius_mm;
  const spot p = spot_of(o->s.p, o->s.z), e = spot_of(o->r.e, o->r.z_end);
  int64_t spare = spot_segment_lo(p, from, to) - room_mm - (o->held != 0 ? still : o->r.disc_mm);
  if (o->held == 0) {
    spare = max_of(spare, spots_apart_lo(from, to, p, e) - room_mm - o->r.capsule_mm);
  }
  return spare;
}
/*= leg_apart @plane : other_type vec_type point_segment_lo segment_gap_lo max_of */
/* Spare gap between what is within `room_mm` of a leg and everything within reach of a robot. */
static int64_t leg_apart(vec from, vec to, int64_t room_mm, const other *o, const body *b) {
  const int64_t still = o->s.p_error_mm + b->hold_mm + b->radius_mm;
  int64_t spare = point_segment_lo(o->s.p, from, to) - room_mm -
                  (o->held != 0 ? still : o->r.disc_mm);
  if (o->held == 0) {
    spare = max_of(spare, segment_gap_lo(from, to, o->r.p, o->r.e) - room_mm - o->r.capsule_mm);
  }
  return spare;
}
/*= pair_course : leg_apart other_type course_type margin_of margin_false margin_unknown about_robots min_of */
/* Everything on the course keeps `least_mm` to everything within reach of another robot. */
static margin pair_course(const course *c, const other *o, const body *b, int64_t least_mm,
                          int32_t index) {
  int64_t spare = SPAN_MAX / WEIGHT_MM;
  int32_t i;
  margin m;
  if (c->input != INPUT_NONE) {
    return margin_unknown(c->input);
  }
  if (o->s.input != INPUT_NONE) {
    m = margin_unknown(INPUT_OTHER_ROBOT);
  } else if (c->usable == 0) {
    m = margin_false();
  } else {
    for (i = 0; i < c->count; ++i) {
      const int32_t before = i > 0 ? i - 1 : 0;
      const int32_t stop = i > c->first ? i - 1 : i;
      /*? in_space */ const spot from = spot_of(c->at[before], c->z[before]), at = spot_of(c->at[i], c->z[i]);
      /*? in_space */ const spot rest = spot_of(c->stop[i], c->stop_z[i]);
      /*? in_space */ const spot first = spot_of(c->stop[stop], c->stop_z[stop]);
      /*? !in_space */ const vec from = c->at[before], at = c->at[i], rest = c->stop[i], first = c->stop[stop];
      spare = min_of(spare, leg_apart(from, at, c->leg_mm, o, b));
      if (i >= c->first) {
        spare = min_of(spare, leg_apart(at, rest, c->stop_mm, o, b));
        spare = min_of(spare, leg_apart(first, rest, c->stop_mm, o, b));
      }
    }
    spare -= least_mm;
    m = margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
  }
  m.other = index;
  return m;
}
