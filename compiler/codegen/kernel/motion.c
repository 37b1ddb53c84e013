/* Where a robot can be. Lengths in mm, speeds in mm/s, times in us or ms as named.
 * Source: the look-ahead bounds "capsule" and "disc" of the theory of this project. */
/*= vec_type */
typedef struct vec {
  int64_t x, y;
} vec;
/*= vec_of : vec_type */
static vec vec_of(int64_t x, int64_t y) {
  vec v;
  v.x = x;
  v.y = y;
  return v;
}
/*= minus : vec_of */
static vec minus(vec a, vec b) {
  return vec_of(a.x - b.x, a.y - b.y);
}
/*= dot : vec_type */
static int64_t dot(vec a, vec b) {
  return a.x * b.x + a.y * b.y;
}
/*= cross : vec_type */
static int64_t cross(vec a, vec b) {
  return a.x * b.y - a.y * b.x;
}
/*= disturbed */
/*= calm */
/*= in_space */
/* Robots move up and down, too: lengths, speeds and accelerations are those of space. `p` and `v`
 * are what a map shows of a place and a velocity, `z` and `vz` their heights. */
/*= body_type */
/* What is declared of a kind of robot, rounded to the safe side. */
typedef struct body {
  int64_t radius_mm;
  int64_t speed_mmps; /* of any control */
  int64_t position_error_mm, velocity_error_mmps;
  int64_t accel_mmps2;  /* of any control, turning included */
  int64_t brake_mmps2;
  /*? !calm */ int64_t brake_lag_ms;        /* sampled brake: (velocity error + b (h + l)) / b */
  /*? calm */ int64_t brake_lag_ms;        /* sampled brake: (velocity error + b (h + l)) / b, or half of it */
  int64_t brake_lag_permille;  /* share of the stopping distance that a turn still bends away */
  int64_t hold_mm;             /* stays within this of its hold */
  int64_t position_age_us, velocity_age_us;
  /*? disturbed */ int64_t sway_permille; /* what pushes it lengthens and bends a stop so much */
  /*? near_agents */ int64_t net_brake_mmps2; /* against whatever pushes it */
  /*? near_agents */ int64_t still_lag_ms;    /* that the sampled brake takes longer */
} body;
/*= motion_type */
/* Limits of whoever drives: any control, or one recovery. */
typedef struct motion {
  int64_t speed_mmps, accel_mmps2;
  int32_t recovery; /* a recovery starts at the speed it finds */
} motion;
/*= estimate_type : vec_type */
typedef struct estimate {
  int32_t input;   /* input that is missing; INPUT_NONE: usable */
  int32_t p_input; /* the same of the position alone: where the robot is now takes no velocity */
  vec p, v;
  /*? in_space */ int64_t z, vz;
  int64_t p_error_mm, v_error_mmps;
  int64_t off_map_mm; /* how far beyond the extent it may be, where `p` saturates */
  int64_t speed_mmps; /* of the measured velocity, rounded up */
  int64_t age_us;     /* of the position */
} estimate;
/*= usable : elapsed_us */
/* Present, finite, neither from the future nor too old. */
static int32_t usable(const KERNEL_point *s, int64_t now_us, int64_t max_age_us) {
  return s->valid != 0 && s->stamp_us <= now_us &&
         elapsed_us(s->stamp_us, now_us) <= max_age_us && s->x_lo <= s->x_hi &&
         /*? in_space */ s->z_lo <= s->z_hi &&
         s->y_lo <= s->y_hi;
}
/*= within_speeds */
/* A velocity whose square fits. */
static int32_t within_speeds(const KERNEL_point *v) {
  return v->x_lo >= -SPEED_MAX_MMPS && v->x_hi <= SPEED_MAX_MMPS && v->y_lo >= -SPEED_MAX_MMPS &&
         /*? in_space */ v->z_lo >= -SPEED_MAX_MMPS && v->z_hi <= SPEED_MAX_MMPS &&
         v->y_hi <= SPEED_MAX_MMPS;
}
/*= on_map : clamp_of */
/* A coordinate beyond the extent saturates. */
static int64_t on_map(int64_t mm) {
  return clamp_of(mm, -EXTENT_MM, EXTENT_MM);
}
/*= off_map : on_map clamp_of magnitude */
/* How far that moves it, up to 137,000 km. */
static int64_t off_map(int64_t mm) {
  return magnitude(clamp_of(mm, -256 * EXTENT_MM, 256 * EXTENT_MM) - on_map(mm));
}
/*= lost : estimate_type */
/* Nothing is known of the robot any more. */
static void lost(estimate *s, int32_t input) {
  s->input = input;
  s->p_input = input;
}
/*= place_error_mm : body_type on_map */
/* The declared error of a position, and its width on the grid. */
static int64_t place_error_mm(const KERNEL_point *position, const body *b) {
  return b->position_error_mm + (on_map(position->x_hi) - on_map(position->x_lo)) +
         /*? in_space */ (on_map(position->z_hi) - on_map(position->z_lo)) +
         (on_map(position->y_hi) - on_map(position->y_lo));
}
/*= off_map_of : off_map */
/* How far saturation moves the corners of a position, all of them together. */
static int64_t off_map_of(const KERNEL_point *position) {
  return off_map(position->x_lo) + off_map(position->x_hi) + off_map(position->y_lo) +
         /*? in_space */ off_map(position->z_lo) + off_map(position->z_hi) +
         off_map(position->y_hi);
}
/*= velocity_error_mmps : body_type div_up magnitude min_of */
/* Velocity and position of unequal stamps: the velocity may have changed in between. */
static int64_t velocity_error_mmps(const KERNEL_point *position, const KERNEL_point *velocity,
                                   const body *b) {
  const int64_t apart_ms = div_up(magnitude(position->stamp_us - velocity->stamp_us), 1000);
  return b->velocity_error_mmps + (velocity->x_hi - velocity->x_lo) +
         (velocity->y_hi - velocity->y_lo) +
         /*? in_space */ (velocity->z_hi - velocity->z_lo) +
         min_of(div_up(b->accel_mmps2 * apart_ms, 1000), 2 * SPEED_MAX_MMPS);
}
/*= estimate_of : estimate_type body_type usable within_speeds on_map vec_of dot root_up elapsed_us place_error_mm off_map_of velocity_error_mmps */
/* A speed that the robot cannot have is unknown; 2 mm/s: the lower corner of the grid lengthens a
 * velocity by less than sqrt(2) mm/s, and the root rounds up. */
static estimate estimate_of(const KERNEL_point *position, const KERNEL_point *velocity,
                            int64_t now_us, const body *b) {
  estimate s;
  s.p_input = usable(position, now_us, b->position_age_us) ? INPUT_NONE : INPUT_POSITION;
  s.input = s.p_input;
  if (s.input == INPUT_NONE &&
      (!usable(velocity, now_us, b->velocity_age_us) || !within_speeds(velocity))) {
    s.input = INPUT_VELOCITY;
  }
  s.p = vec_of(0, 0);
  s.v = vec_of(0, 0);
  /*? in_space */ s.z = 0;
  /*? in_space */ s.vz = 0;
  s.p_error_mm = 0;
  s.off_map_mm = 0;
  s.v_error_mmps = 0;
  s.speed_mmps = 0;
  s.age_us = 0;
  if (s.p_input == INPUT_NONE) {
    s.p = vec_of(on_map(position->x_lo), on_map(position->y_lo));
    /*? in_space */ s.z = on_map(position->z_lo);
    s.p_error_mm = place_error_mm(position, b);
    s.off_map_mm = off_map_of(position);
    s.age_us = elapsed_us(position->stamp_us, now_us);
  }
  if (s.input == INPUT_NONE) {
    s.v = vec_of(velocity->x_lo, velocity->y_lo);
    s.v_error_mmps = velocity_error_mmps(position, velocity, b);
    /*? in_space */ s.vz = velocity->z_lo;
    /*? in_space */ /* one step of the grid more than in the plane, which is in the body's speed */
    /*? in_space */ s.speed_mmps = root_up(dot(s.v, s.v) + s.vz * s.vz);
    /*? !in_space */ s.speed_mmps = root_up(dot(s.v, s.v));
    if (s.speed_mmps > b->speed_mmps + b->velocity_error_mmps + 2) {
      s.input = INPUT_VELOCITY;
    }
  }
  return s;
}
/*= reach_type : vec_type */
/* Everything that the robot can touch until its recovery has stopped it: within `capsule_mm` of
 * the segment p-e, and within `disc_mm` of p. The body is included. */
typedef struct reach {
  int32_t input;
  vec p, e;
  /*? in_space */ int64_t z, z_end; /* heights of p and e */
  int64_t capsule_mm, disc_mm;
  int64_t centre_mm; /* the disc without the body */
  /*? near_agents */ int64_t still_ms; /* from the decision on, until it stands */
} reach;
/*= travel_of : motion_type div_up */
/* Longest way in `t_ms` from speed `s0` under the limits `m` with cap `cap`. */
static int64_t travel_of(int64_t s0, int64_t t_ms, int64_t cap, const motion *m) {
  if (m->accel_mmps2 * t_ms <= (cap - s0) * 1000) {
    return div_up(s0 * t_ms, 1000) + div_up(m->accel_mmps2 * t_ms * t_ms, 2000000);
  }
  return div_up(cap * t_ms, 1000) - (cap - s0) * (cap - s0) / (2 * m->accel_mmps2);
}
/*= speed_cap : motion_type estimate_type max_of */
static int64_t speed_cap(const estimate *s, const motion *m) {
  return m->recovery != 0 ? max_of(m->speed_mmps, s->speed_mmps + s->v_error_mmps)
                          : m->speed_mmps;
}
/*= moved_of : estimate_type motion_type speed_cap travel_of div_up min_of */
/* Longest way since the sample was taken. */
static int64_t moved_of(const estimate *s, const motion *m) {
  const int64_t cap = speed_cap(s, m);
  return travel_of(min_of(cap, s->speed_mmps + s->v_error_mmps), div_up(s->age_us, 1000), cap, m);
}
/*= moved_now : estimate_type body_type motion_type moved_of div_up */
/* The same where the velocity may be missing: then no more than the declared speed is known. */
static int64_t moved_now(const estimate *s, const body *b, const motion *m) {
  return s->input == INPUT_NONE ? moved_of(s, m)
                                : div_up(b->speed_mmps * div_up(s->age_us, 1000), 1000);
}
/*= braked_mm : body_type div_up */
/* `v * w` over twice the brake: with v = w the way of a stop from that speed. */
static int64_t braked_mm(int64_t v, int64_t w, const body *b) {
  return div_up(v * w, 2 * b->brake_mmps2);
}
/*= tube_mm : body_type div_up */
/* The tube around the ideal way of a stop of `stop` mm from `s1` mm/s, see the brake of the theory;
 * the body is included. */
static int64_t tube_mm(const body *b, int64_t s1, int64_t stop) {
  return b->radius_mm + div_up(s1 * b->brake_lag_ms, 1000) +
         /*? disturbed */ div_up(stop * b->sway_permille, 1000) +
         div_up(stop * b->brake_lag_permille, 1000) + b->hold_mm;
}
/*= aside_mm : estimate_type body_type motion_type div_up braked_mm */
/* How far the course may bend off the measured velocity, for `t_ms` and until it stands, when it
 * brakes from `s1` mm/s: what the velocity's error and the acceleration make of it. */
static int64_t aside_mm(const estimate *s, const body *b, const motion *m, int64_t t_ms,
                        int64_t s1) {
  const int64_t drift = s->v_error_mmps + div_up(m->accel_mmps2 * t_ms, 1000);
  const int64_t by_error = div_up(s->v_error_mmps * t_ms, 1000);
  const int64_t by_accel = div_up(m->accel_mmps2 * t_ms * t_ms, 2000000);
  return by_error + by_accel + braked_mm(s->speed_mmps + s1, drift, b);
}
/*= stopping_us : estimate_type body_type div_up */
/* The way of a stop from the measured speed, as time at that speed. */
static int64_t stopping_us(const estimate *s, const body *b) {
  return div_up(s->speed_mmps * 1000000, 2 * b->brake_mmps2);
}
/*= straight_on : estimate_type vec_of */
/* Where the measured velocity leads in `us`; the division towards zero moves it by less than 1 mm
 * per axis. */
static vec straight_on(const estimate *s, int64_t us) {
  return vec_of(s->p.x + s->v.x * us / 1000000, s->p.y + s->v.y * us / 1000000);
}
/*= reach_of : reach_type estimate_type body_type motion_type speed_cap travel_of div_up min_of on_map braked_mm tube_mm aside_mm stopping_us straight_on */
static reach reach_of(const estimate *s, const body *b, const motion *m, int64_t horizon_us) {
  reach r;
  const int64_t t_us = s->age_us + horizon_us;
  const int64_t t_ms = div_up(t_us, 1000);
  const int64_t cap = speed_cap(s, m);
  const int64_t s0 = min_of(cap, s->speed_mmps + s->v_error_mmps);
  const int64_t s1 = min_of(cap, s0 + div_up(m->accel_mmps2 * t_ms, 1000));
  const int64_t stop = braked_mm(s1, s1, b);
  const int64_t tube = tube_mm(b, s1, stop);
  const int64_t along_us = t_us + stopping_us(s, b);
  r.input = s->input;
  r.p = s->p;
  r.e = straight_on(s, along_us);
  /*? in_space */ r.z = s->z;
  /*? in_space */ r.z_end = s->z + s->vz * along_us / 1000000;
  /*? in_space */ r.e.x = r.z_end == on_map(r.z_end) ? r.e.x : EXTENT_MM + 1; /* off the map, too */
  /* 2 mm: for the rounded end point */
  r.capsule_mm = s->p_error_mm + aside_mm(s, b, m, t_ms, s1) + 2 + tube;
  r.disc_mm = s->p_error_mm + travel_of(s0, t_ms, cap, m) + stop + tube;
  r.centre_mm = r.disc_mm - b->radius_mm;
  /*? near_agents */ r.still_ms =
  /*? near_agents */     div_up(horizon_us, 1000) + div_up(1000 * s1, b->net_brake_mmps2) + b->still_lag_ms;
  if (r.e.x != on_map(r.e.x) || r.e.y != on_map(r.e.y)) {
    /*? in_space */ r.z_end = r.z;
    r.e = r.p; /* off the map, where products do not fit: the disc has to do */
    r.capsule_mm = r.disc_mm;
  }
  return r;
}
