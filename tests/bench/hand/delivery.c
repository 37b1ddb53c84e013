#include "tests/bench/hand/delivery.h"

#include <stddef.h>

#include "tests/bench/hand/geometry.h"
#include "tests/bench/hand/switching.h"

/* The declarations of the specification, SI. The acceleration is that of any control, turning
 * included: sqrt(1.0^2 + (0.22 * 2.84)^2). A turn of 10 rad/s^2 bends this share of the stop away.
 */
static const double radius = 0.11, position_error = 0.02, velocity_error = 0.01, any_accel = 1.18,
                    brake = 1.0, brake_bend = 0.807, hold = 0.02, standoff = 0.08, tracking = 0.05,
                    speed_max = 0.22;
/* What is certain on the grid of 1 mm: for position, way-points and root; for the speed. */
static const double grid = 0.008, speed_grid = 0.004;
static const double battery_error = 0.005, drain_per_s = 0.004, reserve_now = 0.05,
                    reserve_ahead = 0.104, give_back_charge = 0.9;
static const double percent = 100, no_way = 1073.741824;
enum { HORIZON_US = 240000 };
static const double horizon = HORIZON_US * 1e-6, return_extra = 0.1, give_back_clearance = 0.05;
enum { PERIOD_US = 100000, LATENCY_US = 40000, LEASE_US = 1000000, LEGS = 2, HELD_TICKS = 10 };
enum { MOTION_AGE_US = 100000, HEADING_AGE_US = 100000, HEARD_AGE_US = 200000 };
enum { BATTERY_AGE_US = 5000000 };
enum { ANY = 0, HOLDING = HAND_MONITORS + 1 }; /* of the motions */

typedef struct estimate {
  int32_t input;       /* that is missing */
  int32_t place_input; /* the same of the position alone */
  hand_vec p, v;
  double v_error, speed, age;
} estimate;
/* Within `capsule` of p-e and within `disc` of p, body included; `centre`: disc without body. */
typedef struct reach {
  hand_vec p, e;
  double capsule, disc, centre;
} reach;
typedef struct heard {
  estimate s;
  reach r;
  int held;
} heard;
typedef struct tick {
  const hand_tables* t;
  const hand_in* in;
  int64_t now_us;
  int self; /* index of this robot, in range */
  int new_tick;
  estimate me;
  double gap; /* from the centre to the boundary now, negative outside */
  reach within;
  double moved;     /* at most, since the position was measured */
  double horizon_s; /* of `within` */
  int32_t charge_input, heading_input;
  double charge_low, charge_high;
  heard others[HAND_ROBOTS];
} tick;

static margin margin_of(double low, double high, int32_t reason) {
  const margin m = {low, high, {reason, 0, INPUT_NONE, -1}};
  return m;
}
static margin nothing_wrong(void) {
  return margin_of(HUGE_VAL, HUGE_VAL, REASON_NONE);
}
static margin unknown(int32_t input, int32_t other) {
  const margin m = {-HUGE_VAL, HUGE_VAL, {REASON_INPUT, 0, input, other}};
  return m;
}
/* Both must hold: the smaller lower end decides. */
static void add(margin* m, margin b) {
  const double high = smaller(m->high, b.high);
  if (b.low < m->low) {
    *m = b;
  }
  m->high = high;
}

/* ---- estimates ---- */

static int usable(const hand_point* s, int64_t now_us, int64_t max_age_us) {
  return s->valid && s->stamp_us <= now_us && now_us - s->stamp_us <= max_age_us;
}
/* Not faster than the robot can be. */
static int in_range(hand_vec v) {
  const double most = speed_max + velocity_error + speed_grid;
  return dot(v, v) <= most * most;
}
static estimate estimate_of(const hand_point* position, const hand_point* velocity, int64_t now_us,
                            int64_t max_age_us) {
  estimate s = {INPUT_NONE, INPUT_NONE, {0, 0}, {0, 0}, 0, 0, 0};
  if (!usable(position, now_us, max_age_us)) {
    s.input = s.place_input = INPUT_POSITION;
    return s;
  }
  s.p = position->value;
  s.age = (double)(now_us - position->stamp_us) * 1e-6;
  if (!usable(velocity, now_us, max_age_us) || !in_range(velocity->value)) {
    s.input = INPUT_VELOCITY;
  } else {
    /* the velocity may have changed between the two stamps */
    const double apart = fabs((double)(position->stamp_us - velocity->stamp_us)) * 1e-6;
    s.v = velocity->value;
    s.v_error = velocity_error + any_accel * apart;
    s.speed = sqrt(dot(s.v, s.v));
  }
  return s;
}
static double speed_cap(const estimate* s, const hand_motion* m) {
  return m->recovery ? larger(m->speed, s->speed + s->v_error) : m->speed;
}
/* Longest way in `time` from `speed` with `cap`. */
static double travel(double speed, double time, double cap, double accel) {
  if (accel * time <= cap - speed) {
    return speed * time + accel * time * time / 2;
  }
  return cap * time - (cap - speed) * (cap - speed) / (2 * accel);
}
/* Without a velocity, at the declared speed. */
static double moved_since(const estimate* s, const hand_motion* m) {
  const double cap = speed_cap(s, m);
  if (s->input != INPUT_NONE) {
    return speed_max * s->age;
  }
  return travel(smaller(cap, s->speed + s->v_error), s->age, cap, m->accel);
}
/* The bounds "capsule" and "disc" on everything within reach until the recovery has stopped. */
static reach reach_of(const estimate* s, const hand_motion* m, double horizon_s) {
  const double t = s->age + horizon_s;
  const double accel = m->accel;
  const double cap = speed_cap(s, m);
  const double s0 = smaller(cap, s->speed + s->v_error);
  const double s1 = smaller(cap, s0 + accel * t);
  const double stop = s1 * s1 / (2 * brake);
  const double tube = radius + stop * brake_bend + hold;
  const double along = t + s->speed / (2 * brake);
  reach r;
  r.p = s->p;
  r.e.x = s->p.x + s->v.x * along;
  r.e.y = s->p.y + s->v.y * along;
  r.capsule = position_error + s->v_error * t + accel * t * t / 2 +
              (s->speed + s1) * (s->v_error + accel * t) / (2 * brake) + tube;
  r.centre = position_error + travel(s0, t, cap, accel) + stop + tube - radius;
  r.disc = r.centre + radius;
  return r;
}

/* ---- geofence ---- */

static margin clearance_now(const tick* v, double least) {
  if (v->me.place_input != INPUT_NONE) {
    return unknown(v->me.place_input, -1);
  } else {
    const double error = position_error + v->moved;
    const double gap = v->gap - radius - least;
    return margin_of(gap - error, gap + error, REASON_MARGIN);
  }
}
static margin fence_reach(const tick* v) {
  double spare;
  if (v->me.input != INPUT_NONE) {
    return unknown(v->me.input, -1);
  }
  spare = v->gap - v->within.disc;
  if (spare < 0 && v->gap >= 0) {
    const double capsule = line_gap(&v->t->zone, v->within.p, v->within.e) - v->within.capsule;
    spare = larger(spare, capsule);
  }
  return margin_of(spare, spare, REASON_MARGIN);
}
static int bad_plan(const hand_plan* p) {
  return !p->valid || p->count < 0 || p->count > HAND_PLAN_CAPACITY || p->index < 0 ||
         p->index > p->count;
}
static margin plan_unknown(const hand_plan* p) {
  margin m = unknown(INPUT_PLAN, -1);
  if (p->count > HAND_PLAN_CAPACITY) {
    m.found.reason = REASON_OVER_CAPACITY;
  }
  return m;
}
static margin legs_in_fence(const tick* v) {
  const hand_plan* plan = &v->in->plan;
  const hand_zone* z = &v->t->zone;
  margin worst = nothing_wrong();
  hand_vec from = v->me.p;
  int inside = v->gap >= 0;
  int k;
  if (bad_plan(plan)) {
    return plan_unknown(plan);
  }
  if (plan->index == plan->count) {
    return worst;
  }
  if (v->me.input != INPUT_NONE) {
    return unknown(v->me.input, -1);
  }
  for (k = 0; k <= LEGS && plan->index + k < plan->count; ++k) {
    const hand_vec to = plan->points[plan->index + k];
    const double gap = line_gap(z, from, to);
    const double spare = (gap >= 0 && !inside ? -gap : gap) - radius - position_error - tracking;
    if (spare < worst.low) {
      worst = margin_of(spare, spare, REASON_LEG);
      worst.found.index = k;
    }
    if (gap <= 0) { /* only a leg that meets the boundary changes sides */
      inside = signed_gap(z, to) >= 0;
    }
    from = to;
  }
  return worst;
}
/* Legs rest on the robot being near the one that it drives: for certain it is not. */
static margin on_track(const tick* v) {
  const hand_plan* plan = &v->in->plan;
  if (bad_plan(plan) || plan->index == 0 || plan->index == plan->count ||
      v->me.input != INPUT_NONE) {
    return nothing_wrong();
  } else {
    const line leg = line_of(plan->points[plan->index - 1], plan->points[plan->index]);
    const double spare = tracking + position_error + grid - sqrt(point_line2(v->me.p, &leg));
    margin m = margin_of(spare, spare, REASON_TRACKING);
    m.found.index = plan->index;
    return m;
  }
}
static margin fence_ahead(const tick* v, int legs) {
  margin m = fence_reach(v);
  if (legs) {
    add(&m, legs_in_fence(v));
    add(&m, on_track(v));
  }
  return m;
}
/* clearance >= 5 cm for 1 s */
static margin fence_gives_back(const tick* v, hand_state* s) {
  margin m = clearance_now(v, give_back_clearance);
  int32_t* runs[2];
  int i;
  runs[0] = &s->clear_ticks;
  runs[1] = &s->maybe_clear_ticks;
  for (i = 0; i < 2; ++i) {
    if ((i == 0 ? m.low : m.high) < 0) {
      *runs[i] = 0;
    } else if (v->new_tick && *runs[i] <= HELD_TICKS) {
      *runs[i] += 1;
    }
  }
  if (s->clear_ticks <= HELD_TICKS) {
    m.low = smaller(m.low, -1e-9);
  }
  if (s->maybe_clear_ticks <= HELD_TICKS) {
    m.high = smaller(m.high, -1e-9);
  }
  return m;
}

/* ---- separation ---- */

static margin distance_now(const tick* v, int j) {
  const heard* o = &v->others[j];
  if (v->me.place_input != INPUT_NONE || o->s.place_input != INPUT_NONE) {
    return unknown(v->me.place_input != INPUT_NONE ? v->me.place_input : INPUT_OTHER_ROBOT, j);
  } else {
    const double theirs = o->held ? hold : moved_since(&o->s, &v->t->motions[ANY]);
    const double error = 2 * position_error + v->moved + theirs;
    const double gap = distance(v->me.p, o->s.p) - 2 * radius - standoff;
    margin m = margin_of(gap - error, gap + error, REASON_MARGIN);
    m.found.other = j;
    return m;
  }
}
/* Spare gap between everything within reach of two robots: disc or capsule for either. */
static double pair_spare(const reach* r, const heard* o) {
  const double axis = o->held ? position_error + hold + radius : o->r.disc;
  const line mine = line_of(r->p, r->e);
  double spare =
      larger(distance(r->p, o->s.p) - r->disc, sqrt(point_line2(o->s.p, &mine)) - r->capsule) -
      axis;
  if (!o->held) {
    const line theirs = line_of(o->r.p, o->r.e);
    const double by_disc = sqrt(point_line2(r->p, &theirs)) - r->disc;
    const double by_capsule = sqrt(line_line2(&mine, &theirs)) - r->capsule;
    spare = larger(spare, larger(by_disc, by_capsule) - o->r.capsule);
  }
  return spare - standoff;
}
static margin pair_reach(const tick* v, int j) {
  margin m;
  double spare;
  if (v->me.input != INPUT_NONE) {
    return unknown(v->me.input, -1);
  }
  if (v->others[j].s.input != INPUT_NONE) {
    return unknown(INPUT_OTHER_ROBOT, j);
  }
  spare = pair_spare(&v->within, &v->others[j]);
  m = margin_of(spare, spare, REASON_MARGIN);
  m.found.other = j;
  return m;
}
/* Square of the distance of a leg to the next legs of a robot that goes first. */
static double their_legs2(const line* leg, hand_vec start, const hand_plan* theirs) {
  double best = HUGE_VAL;
  int k;
  for (k = 0; k <= LEGS && theirs->index + k < theirs->count; ++k) {
    const hand_vec end = theirs->points[theirs->index + k];
    const line other = line_of(start, end);
    best = smaller(best, line_line2(leg, &other));
    start = end;
  }
  return best;
}
/* The next legs keep away from a robot that is HELD, and from those of one that goes first. */
static margin legs_apart(const tick* v, int j) {
  const hand_plan* plan = &v->in->plan;
  const hand_plan* theirs = &v->in->others[j].plan;
  const heard* o = &v->others[j];
  const double need = 2 * (radius + position_error) + standoff + tracking;
  margin worst = nothing_wrong();
  hand_vec from = v->me.p;
  int k;
  if (bad_plan(plan)) {
    return plan_unknown(plan);
  }
  if (plan->index == plan->count || (!o->held && !v->in->others[j].goes_first)) {
    return worst;
  }
  if (v->me.input != INPUT_NONE) {
    return unknown(v->me.input, -1);
  }
  if (o->s.input != INPUT_NONE || (!o->held && bad_plan(theirs))) {
    return unknown(INPUT_OTHER_ROBOT, j);
  }
  for (k = 0; k <= LEGS && plan->index + k < plan->count; ++k) {
    const hand_vec to = plan->points[plan->index + k];
    const line leg = line_of(from, to);
    const double spare = o->held ? sqrt(point_line2(o->s.p, &leg)) - need - hold
                                 : sqrt(their_legs2(&leg, o->s.p, theirs)) - need - tracking;
    if (spare < worst.low) {
      worst = margin_of(spare, spare, REASON_LEG);
      worst.found.index = k;
    }
    from = to;
  }
  worst.found.other = j;
  return worst;
}
static margin apart_now(const tick* v) {
  margin m = nothing_wrong();
  int j;
  for (j = 0; j < HAND_ROBOTS; ++j) {
    if (j != v->self) {
      add(&m, distance_now(v, j));
    }
  }
  return m;
}
static margin apart_ahead(const tick* v, int legs) {
  margin m = nothing_wrong();
  int j;
  for (j = 0; j < HAND_ROBOTS; ++j) {
    if (j != v->self) {
      add(&m, pair_reach(v, j));
      if (legs) {
        add(&m, legs_apart(v, j));
      }
    }
  }
  if (legs) {
    add(&m, on_track(v));
  }
  return m;
}

/* ---- battery ---- */

/* Cell of a coordinate, -1 or `count` beyond the table. */
static int cell_of(double at, double origin, double cells_per_m, int count) {
  const double i = floor((at - origin) * cells_per_m);
  return (int)smaller(larger(i, -1), count);
}
/* Least and most charge for the way to the dock from within `r` of the centre: straight, and by the
 * cells. */
static void way_home(const tick* v, double r, double* least, double* most) {
  const hand_cells* c = &v->t->to_dock[v->self];
  const int x0 = cell_of(v->me.p.x - r, c->origin_x, c->cells_per_m, c->columns);
  const int x1 = cell_of(v->me.p.x + r, c->origin_x, c->cells_per_m, c->columns);
  const int y0 = cell_of(v->me.p.y - r, c->origin_y, c->cells_per_m, c->rows);
  const int y1 = cell_of(v->me.p.y + r, c->origin_y, c->cells_per_m, c->rows);
  const double away = distance(v->me.p, c->dock) - r;
  int32_t high = -1;
  int x, y;
  for (y = y0 < 0 ? 0 : y0; y <= y1 && y < c->rows; ++y) {
    const int32_t* row = &c->ppm[y * c->columns];
    for (x = x0 < 0 ? 0 : x0; x <= x1 && x < c->columns; ++x) {
      high = row[x] > high ? row[x] : high;
    }
  }
  *most = high < 0 ? no_way : high * 1e-6;
  *least = smaller(larger(away, 0) * c->per_m, *most);
}
static void measure_battery(tick* v) {
  const hand_scalar* b = &v->in->battery;
  if (!b->valid || b->stamp_us > v->now_us || v->now_us - b->stamp_us > BATTERY_AGE_US ||
      b->value < -battery_error || b->value > 1 + battery_error) {
    v->charge_input = INPUT_BATTERY;
  } else {
    v->charge_input = INPUT_NONE;
    v->charge_low =
        b->value - battery_error - drain_per_s * (double)(v->now_us - b->stamp_us) * 1e-6;
    v->charge_high = b->value + battery_error;
  }
}
static margin battery_now(const tick* v) {
  double least, most;
  if (v->charge_input != INPUT_NONE || v->me.place_input != INPUT_NONE) {
    return unknown(v->charge_input != INPUT_NONE ? v->charge_input : v->me.place_input, -1);
  }
  way_home(v, position_error + v->moved, &least, &most);
  return margin_of(percent * (v->charge_low - most - reserve_now),
                   percent * (v->charge_high - least - reserve_now), REASON_MARGIN);
}
static margin battery_ahead(const tick* v) {
  double least, most, spare;
  if (v->me.input != INPUT_NONE || v->charge_input != INPUT_NONE) {
    return unknown(v->me.input != INPUT_NONE ? v->me.input : v->charge_input, -1);
  }
  way_home(v, v->within.centre, &least, &most);
  spare = percent * (v->charge_low - most - reserve_ahead - drain_per_s * v->horizon_s);
  return margin_of(spare, spare, REASON_MARGIN);
}
static margin battery_gives_back(const tick* v) {
  if (v->charge_input != INPUT_NONE) {
    return unknown(v->charge_input, -1);
  }
  return margin_of(percent * (v->charge_low - give_back_charge),
                   percent * (v->charge_high - give_back_charge), REASON_MARGIN);
}

/* ---- heading ---- */

static int32_t heading_input(const hand_scalar* h, int64_t now_us) {
  return h->valid && h->stamp_us <= now_us && now_us - h->stamp_us <= HEADING_AGE_US
             ? INPUT_NONE
             : INPUT_HEADING;
}
/* Nobody steers without it. */
static margin steered(const tick* v, margin ahead) {
  if (v->heading_input != INPUT_NONE) {
    add(&ahead, unknown(v->heading_input, -1));
  }
  return ahead;
}

/* ---- the step ---- */

/* What is within reach under the motion of `driver`. A promise of a robot that goes
 * first is not relied upon for starting (`any_promise` 0). */
static void look(tick* v, int driver, double horizon_s, int any_promise) {
  const int64_t horizon_us = (int64_t)(horizon_s * 1e6 + 0.5);
  int j;
  v->horizon_s = horizon_s;
  v->within = reach_of(&v->me, &v->t->motions[driver], horizon_s);
  v->moved = moved_since(&v->me, &v->t->motions[driver]);
  for (j = 0; j < HAND_ROBOTS; ++j) {
    if (j != v->self) {
      const hand_other* o = &v->in->others[j];
      v->others[j].held = horizon_us <= LEASE_US && o->lease_end_us >= v->now_us + horizon_us &&
                          (any_promise || !o->goes_first);
      v->others[j].r = reach_of(&v->others[j].s, &v->t->motions[ANY], horizon_s);
    }
  }
}
static int32_t gate_of(const tick* v) {
  int32_t gate = HAND_FREE;
  int j;
  for (j = 0; j < HAND_ROBOTS; ++j) {
    if (j != v->self) {
      if (v->me.input != INPUT_NONE || v->others[j].s.input != INPUT_NONE) {
        return HAND_HOLD;
      }
      if (pair_spare(&v->within, &v->others[j]) < 0) {
        if (!v->others[j].held) {
          return HAND_HOLD;
        }
        gate = HAND_AWAY_ONLY;
      }
    }
  }
  return gate;
}
static int in_order(int64_t stamp_us, int64_t now_us, int64_t* last_us) {
  if (stamp_us < *last_us) {
    return 0;
  }
  if (stamp_us <= now_us) {
    *last_us = stamp_us;
  }
  return 1;
}
static int promise_kept(int64_t end_us, int64_t now_us, int64_t* last_us) {
  const int64_t believed_us = end_us > now_us + LEASE_US ? now_us + LEASE_US : end_us;
  if (end_us<*last_us&& * last_us> now_us) {
    return 0;
  }
  if (believed_us > *last_us) {
    *last_us = believed_us;
  }
  return 1;
}
static int64_t next_tick(hand_state* s, int64_t now_us) {
  int64_t count, elapsed, gap_us;
  if (!s->started) {
    s->started = 1;
    s->origin_us = s->last_us = now_us;
    s->tick = 0;
    return 1;
  }
  if (now_us < s->last_us) {
    return -1;
  }
  gap_us = now_us - s->last_us;
  s->last_us = now_us;
  count = (now_us - s->origin_us + PERIOD_US / 2 - 1) / PERIOD_US;
  elapsed = count - s->tick;
  s->tick = count;
  return gap_us > HORIZON_US && elapsed < 2 ? 2 : elapsed;
}
static void measure(tick* v, hand_state* s, int64_t elapsed) {
  const hand_in* in = v->in;
  int j;
  v->me = estimate_of(&in->position, &in->velocity, v->now_us, MOTION_AGE_US);
  if (in->position.valid && !in_order(in->position.stamp_us, v->now_us, &s->last_position_us)) {
    v->me.input = v->me.place_input = INPUT_POSITION;
  }
  if (in->velocity.valid && !in_order(in->velocity.stamp_us, v->now_us, &s->last_velocity_us)) {
    v->me.input = INPUT_VELOCITY;
  }
  measure_battery(v);
  if (in->battery.valid && !in_order(in->battery.stamp_us, v->now_us, &s->last_battery_us)) {
    v->charge_input = INPUT_BATTERY;
  }
  v->heading_input = heading_input(&in->heading, v->now_us);
  if (in->heading.valid && !in_order(in->heading.stamp_us, v->now_us, &s->last_heading_us)) {
    v->heading_input = INPUT_HEADING;
  }
  for (j = 0; j < HAND_ROBOTS; ++j) {
    const hand_other* o = &in->others[j];
    if (j != v->self) {
      v->others[j].s = estimate_of(&o->position, &o->velocity, v->now_us, HEARD_AGE_US);
      if (o->position.valid && !in_order(o->position.stamp_us, v->now_us, &s->last_other_us[j])) {
        v->others[j].s.input = v->others[j].s.place_input = INPUT_OTHER_ROBOT;
      }
      if (o->velocity.valid &&
          !in_order(o->velocity.stamp_us, v->now_us, &s->last_other_velocity_us[j])) {
        v->others[j].s.input = INPUT_OTHER_ROBOT;
      }
      if (o->position.valid &&
          !promise_kept(o->lease_end_us, v->now_us, &s->last_other_lease_us[j])) {
        v->others[j].s.input = v->others[j].s.place_input = INPUT_OTHER_ROBOT;
      }
    }
  }
  if (elapsed < 0) {
    v->me.input = v->me.place_input = v->charge_input = INPUT_CLOCK;
  }
  if (elapsed < 0 || elapsed > 1) {
    s->clear_ticks = 0;
  }
  v->gap = v->me.place_input == INPUT_NONE ? signed_gap(&v->t->zone, v->me.p) : 0;
}
static void check_all(tick* v, hand_state* s, int driver, int back, check* checks) {
  if (back) {
    look(v, ANY, horizon + return_extra, 0);
    checks[HAND_COLLISION].safer = steered(v, apart_ahead(v, 1));
    checks[HAND_GEOFENCE].safer = steered(v, fence_ahead(v, 1));
    checks[HAND_BATTERY].safer = steered(v, battery_ahead(v));
  } else {
    int k;
    for (k = 0; k < HAND_MONITORS; ++k) {
      checks[k].safer = unknown(INPUT_NONE, -1);
    }
  }
  look(v, driver, horizon, 1);
  checks[HAND_COLLISION].now = apart_now(v);
  checks[HAND_COLLISION].ahead = steered(v, apart_ahead(v, s->mode == 0));
  checks[HAND_COLLISION].gives_back = nothing_wrong();
  checks[HAND_GEOFENCE].now = clearance_now(v, 0);
  checks[HAND_GEOFENCE].ahead = steered(v, fence_ahead(v, s->mode == 0));
  checks[HAND_GEOFENCE].gives_back = fence_gives_back(v, s);
  checks[HAND_BATTERY].now = battery_now(v);
  checks[HAND_BATTERY].ahead = steered(v, battery_ahead(v));
  checks[HAND_BATTERY].gives_back = battery_gives_back(v);
}
/* Whose motion bounds what happened since the position was measured and will happen. */
static int driver_of(const hand_tables* t, const hand_state* s, int mode, int64_t seen_us) {
  const int before = s->takeover_before;
  if (seen_us >= s->takeover_us + LATENCY_US || mode == before) {
    return mode;
  }
  if (t->motions[mode].recovery != t->motions[before].recovery) {
    return t->motions[mode].recovery ? before : mode;
  }
  return t->motions[mode].speed >= t->motions[before].speed ? mode : before;
}
static int64_t age_of(int32_t valid, int64_t stamp_us, int64_t now_us) {
  return valid && stamp_us <= now_us ? now_us - stamp_us : -1;
}
/* The earliest violation when the margin shrinks at `speed`. */
static int64_t sooner(int64_t us, const margin* now, double speed) {
  if (us < 0 || now->found.input != INPUT_NONE) {
    return -1;
  }
  return now->low <= 0 ? 0 : (int64_t)smaller((double)us, now->low / speed * 1e6);
}
static void report(const tick* v, const hand_state* s, const check* checks, hand_out* out) {
  const hand_in* in = v->in;
  const hand_finding none = {REASON_NONE, 0, INPUT_NONE, -1};
  int k;
  out->tick = s->tick;
  out->time_us = v->now_us;
  out->mode = s->mode;
  out->lease_end_us = s->lease_end_us;
  out->position_age_us = age_of(in->position.valid, in->position.stamp_us, v->now_us);
  out->velocity_age_us = age_of(in->velocity.valid, in->velocity.stamp_us, v->now_us);
  out->battery_age_us = age_of(in->battery.valid, in->battery.stamp_us, v->now_us);
  out->heading_age_us = age_of(in->heading.valid, in->heading.stamp_us, v->now_us);
  out->violation_us = sooner(INT64_C(1) << 52, &checks[HAND_COLLISION].now, 2 * speed_max);
  out->violation_us = sooner(out->violation_us, &checks[HAND_GEOFENCE].now, speed_max);
  for (k = 0; k < HAND_MONITORS; ++k) {
    out->monitors[k].now = verdict_of(&checks[k].now);
    out->monitors[k].ahead = verdict_of(&checks[k].ahead);
    out->monitors[k].safer = verdict_of(&checks[k].safer);
    out->monitors[k].engaged = s->monitors[k].engaged;
    out->monitors[k].margin = checks[k].ahead.low;
  }
  out->monitor = s->mode - 1;
  out->found = none;
  if (s->mode != 0) {
    out->found = s->monitors[s->mode - 1].found;
    if (!s->monitors[s->mode - 1].engaged) {
      out->found.reason = in->surrender ? REASON_SURRENDERED : REASON_RETURNING;
    }
  }
}

void hand_step(const hand_tables* t, hand_state* s, const hand_in* in, int64_t now_us,
               hand_out* out) {
  const int first = !s->started;
  const int64_t elapsed = next_tick(s, now_us);
  const int may_leave = now_us >= s->lease_end_us;
  const int before = s->mode;
  int64_t seen_us;
  int driver, gating;
  check checks[HAND_MONITORS];
  tick v;
  v.t = t;
  v.in = in;
  v.now_us = now_us;
  v.self = in->self > 0 && in->self < HAND_ROBOTS ? in->self : 0;
  v.new_tick = elapsed > 0;
  measure(&v, s, elapsed);
  seen_us = v.me.input == INPUT_NONE ? in->position.stamp_us : INT64_MIN;
  driver = driver_of(t, s, before, seen_us);
  if (before != 0 && in->holding && s->lease_end_us >= now_us + HORIZON_US) {
    driver = HOLDING;
  }
  check_all(&v, s, driver, first || before != 0, checks);
  s->mode = next_mode(s, checks, first, elapsed, in->surrender, may_leave);
  if (first || s->mode != before) {
    s->takeover_before = first ? 0 : driver;
    s->takeover_us = now_us;
  }
  out->previous_mode = first ? s->mode : before;
  out->gate = HAND_FREE;
  if (s->mode != 0 && !may_leave) {
    out->gate = HAND_HOLD;
  } else if (s->mode != 0) {
    gating = driver_of(t, s, s->mode, seen_us);
    if (gating != driver) { /* else what is within reach is known already */
      look(&v, gating, horizon, 1);
    }
    out->gate = gate_of(&v);
  }
  if (s->mode != 0 && v.heading_input != INPUT_NONE) {
    out->gate = HAND_HOLD;
  }
  if (s->mode != 0 && s->mode == before && in->holding &&
      (in->surrender || first_engaged(s) >= 0 || first_not_safer(checks) >= 0)) {
    s->lease_end_us = now_us + LEASE_US;
  }
  report(&v, s, checks, out);
}

void hand_init(hand_state* s) {
  const hand_finding none = {REASON_NONE, 0, INPUT_NONE, -1};
  int k;
  s->started = 0;
  s->origin_us = s->last_us = s->tick = 0;
  for (k = 0; k < HAND_MONITORS; ++k) {
    s->monitors[k].engaged = s->monitors[k].dwell = 0;
    s->monitors[k].found = none;
  }
  s->mode = 1;
  s->takeover_us = INT64_MAX / 2;
  s->takeover_before = 0;
  s->lease_end_us = INT64_MIN;
  s->last_position_us = s->last_velocity_us = s->last_battery_us = INT64_MIN;
  s->last_heading_us = INT64_MIN;
  for (k = 0; k < HAND_ROBOTS; ++k) {
    s->last_other_us[k] = s->last_other_velocity_us[k] = INT64_MIN;
    s->last_other_lease_us[k] = INT64_MIN;
  }
  s->clear_ticks = s->maybe_clear_ticks = 0;
}

void hand_zone_init(hand_zone* z, const int32_t* edges_mm, int32_t count) {
  int32_t i;
  z->count = count < HAND_EDGES ? count : HAND_EDGES;
  for (i = 0; i < z->count; ++i) {
    const int32_t* mm = &edges_mm[4 * i];
    hand_edge* e = &z->edges[i];
    e->a.x = mm[0] * 1e-3;
    e->a.y = mm[1] * 1e-3;
    e->b.x = mm[2] * 1e-3;
    e->b.y = mm[3] * 1e-3;
    e->d = minus(e->b, e->a);
    e->inverse = 1 / dot(e->d, e->d);
    e->low.x = smaller(e->a.x, e->b.x);
    e->low.y = smaller(e->a.y, e->b.y);
    e->high.x = larger(e->a.x, e->b.x);
    e->high.y = larger(e->a.y, e->b.y);
  }
}
