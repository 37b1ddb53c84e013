#include PROBE_KERNEL_TEXT

#include "kernel_probe.h"

static vec to_vec(probe_vec v) {
  return vec_of(v.x, v.y);
}
static probe_vec from_vec(vec v) {
  probe_vec p;
  p.x = v.x;
  p.y = v.y;
  return p;
}
static body to_body(const probe_body* b) {
  body to;
  to.radius_mm = b->radius_mm;
  to.speed_mmps = b->speed_mmps;
  to.position_error_mm = b->position_error_mm;
  to.velocity_error_mmps = b->velocity_error_mmps;
  to.accel_mmps2 = b->accel_mmps2;
  to.brake_mmps2 = b->brake_mmps2;
  to.brake_lag_ms = b->brake_lag_ms;
  to.brake_lag_permille = b->brake_lag_permille;
  to.hold_mm = b->hold_mm;
  to.position_age_us = b->position_age_us;
  to.velocity_age_us = b->velocity_age_us;
  to.sway_permille = b->sway_permille;
  return to;
}
static motion to_motion(const probe_motion* m) {
  motion to;
  to.speed_mmps = m->speed_mmps;
  to.accel_mmps2 = m->accel_mmps2;
  to.recovery = m->recovery;
  return to;
}
static estimate to_estimate(const probe_robot* r, int64_t now_us) {
  const body b = to_body(&r->body);
  return estimate_of(&r->position, &r->velocity, now_us, &b);
}
static reach to_reach(const probe_robot* r, int64_t now_us, int64_t horizon_us) {
  const estimate s = to_estimate(r, now_us);
  const body b = to_body(&r->body);
  const motion m = to_motion(&r->motion);
  return reach_of(&s, &b, &m, horizon_us);
}
probe_course probe_course_of(const probe_robot* r, const probe_command* sent,
                             const probe_point* proposed, int64_t now_us, int64_t horizon_us,
                             int64_t error_mmps2, int64_t latency_us) {
  const estimate s = to_estimate(r, now_us);
  const body b = to_body(&r->body);
  const order o = {r->motion.accel_mmps2, error_mmps2, latency_us};
  const course c = course_of(&s, &b, &o, sent, proposed, now_us, horizon_us);
  probe_course to;
  int32_t i;
  to.usable = c.usable;
  to.count = c.count;
  to.first = c.first;
  to.leg_mm = c.leg_mm;
  to.stop_mm = c.stop_mm;
  for (i = 0; i < c.count; ++i) {
    to.at[i] = from_vec(c.at[i]);
    to.stop[i] = from_vec(c.stop[i]);
  }
  return to;
}
static other to_other(const probe_robot* r, int64_t now_us, int64_t horizon_us) {
  other o;
  o.s = to_estimate(r, now_us);
  o.held = r->held;
  o.r = to_reach(r, now_us, horizon_us);
  return o;
}
/* The kernel's zones point to constant tables. */
typedef struct table {
  edge edges[PROBE_EDGES_MAX];
  zone z;
} table;
static const zone* to_zone(const probe_zone* z, table* t) {
  int32_t i;
  for (i = 0; i < z->count; ++i) {
    t->edges[i].ax = z->edges[i].ax;
    t->edges[i].ay = z->edges[i].ay;
    t->edges[i].bx = z->edges[i].bx;
    t->edges[i].by = z->edges[i].by;
    t->edges[i].ux_q30 = z->edges[i].ux_q30;
    t->edges[i].uy_q30 = z->edges[i].uy_q30;
  }
  t->z.edges = t->edges;
  t->z.count = z->count;
  return &t->z;
}
static probe_span from_span(span s) {
  probe_span p;
  p.lo = s.lo;
  p.hi = s.hi;
  p.input = s.input;
  return p;
}
static span to_span(probe_span p) {
  span s = span_of(p.lo, p.hi);
  s.input = p.input;
  return s;
}
static probe_span from_margin(margin m) {
  probe_span p;
  p.lo = m.lo;
  p.hi = m.hi;
  p.input = m.input;
  return p;
}
static margin to_margin(probe_span p) {
  margin m = margin_of(p.lo, p.hi, PROBE_REASON_MARGIN);
  m.input = p.input;
  return m;
}

int64_t probe_div_up(int64_t a, int64_t b) {
  return div_up(a, b);
}
int64_t probe_root_down(int64_t a) {
  return root_down(a);
}
int64_t probe_root_up(int64_t a) {
  return root_up(a);
}
int64_t probe_point_segment_lo(probe_vec p, probe_vec a, probe_vec b) {
  return point_segment_lo(to_vec(p), to_vec(a), to_vec(b));
}
int64_t probe_segment_gap_lo(probe_vec a, probe_vec b, probe_vec c, probe_vec d) {
  return segment_gap_lo(to_vec(a), to_vec(b), to_vec(c), to_vec(d));
}
int32_t probe_inside(const probe_zone* z, probe_vec p) {
  table t;
  return inside_zone(to_zone(z, &t), to_vec(p));
}
int64_t probe_boundary_gap_lo(const probe_zone* z, probe_vec p) {
  table t;
  return boundary_gap_lo(to_zone(z, &t), to_vec(p));
}
int64_t probe_segment_boundary_lo(const probe_zone* z, probe_vec p, probe_vec e) {
  table t;
  return segment_boundary_lo(to_zone(z, &t), to_vec(p), to_vec(e));
}

probe_reach probe_reach_of(const probe_robot* r, int64_t now_us, int64_t horizon_us) {
  const reach from = to_reach(r, now_us, horizon_us);
  probe_reach to;
  to.input = from.input;
  to.p = from_vec(from.p);
  to.e = from_vec(from.e);
  to.capsule_mm = from.capsule_mm;
  to.disc_mm = from.disc_mm;
  to.centre_mm = from.centre_mm;
  return to;
}
probe_span probe_clearance(const probe_zone* z, const probe_robot* r, int64_t now_us) {
  table t;
  const estimate s = to_estimate(r, now_us);
  const body b = to_body(&r->body);
  const motion m = to_motion(&r->motion);
  const place at = place_of(to_zone(z, &t), s.p);
  return from_span(clearance_now(&at, &s, &b, &m));
}
probe_span probe_distance(const probe_robot* r, const probe_robot* o, int64_t now_us) {
  const estimate s = to_estimate(r, now_us);
  const other heard = to_other(o, now_us, 0);
  const body b = to_body(&r->body);
  const motion m = to_motion(&r->motion);
  const motion any = to_motion(&o->motion);
  return from_span(distance_now(&s, &heard, &b, &m, &any, 1));
}
probe_span probe_zone_ahead(const probe_zone* z, const probe_robot* r, int64_t now_us,
                            int64_t horizon_us, int64_t least_mm) {
  table t;
  const reach within = to_reach(r, now_us, horizon_us);
  const place at = place_of(to_zone(z, &t), within.p);
  return from_margin(zone_reach(&t.z, &at, &within, least_mm));
}
probe_span probe_pair_ahead(const probe_robot* r, const probe_robot* o, int64_t now_us,
                            int64_t horizon_us, int64_t least_mm) {
  const reach within = to_reach(r, now_us, horizon_us);
  const other heard = to_other(o, now_us, horizon_us);
  const body b = to_body(&r->body);
  return from_margin(pair_reach(&within, &heard, &b, least_mm, 1));
}
probe_span probe_legs(const probe_zone* z, const probe_robot* r, const probe_plan* plan,
                      int64_t now_us, int32_t legs, int64_t need_mm) {
  table t;
  const estimate s = to_estimate(r, now_us);
  const place at = place_of(to_zone(z, &t), s.p);
  return from_margin(legs_in_zone(&t.z, &at, &s, plan, legs, need_mm));
}
probe_span probe_plan_legs(const probe_zone* z, const probe_plan* plan, int64_t need_mm) {
  table t;
  return from_margin(plan_in_zone(to_zone(z, &t), plan, need_mm));
}
probe_span probe_way(int32_t self, probe_vec at, int64_t radius_mm) {
  return from_span(cells_span(&cells_to_dock[self], to_vec(at), radius_mm));
}
probe_span probe_charge(const probe_scalar* battery, int64_t now_us, int64_t max_age_us,
                        int64_t error_ppm, int64_t drain_ppm_per_s) {
  return from_span(charge_now(battery, now_us, max_age_us, error_ppm, drain_ppm_per_s));
}
probe_span probe_energy_ahead(int32_t self, const probe_robot* r, probe_span charge, int64_t now_us,
                              int64_t horizon_us, int64_t reserve_ppm, int64_t drain_ppm_per_s) {
  const reach within = to_reach(r, now_us, horizon_us);
  return from_margin(energy_reach(&cells_to_dock[self], &within, to_span(charge), reserve_ppm,
                                  drain_ppm_per_s, horizon_us));
}
int32_t probe_promise_kept(int64_t end_us, int64_t now_us, int64_t lease_us, int64_t* last_us) {
  return promise_kept(end_us, now_us, lease_us, last_us);
}
int32_t probe_relied_upon(int64_t end_us, int64_t now_us, int64_t horizon_us, int64_t lease_us) {
  const probe_other heard = {.lease_end_us = end_us};
  const probe_robot at_rest = {.body = {.brake_mmps2 = 1}};
  const estimate s = to_estimate(&at_rest, now_us);
  const body b = to_body(&at_rest.body);
  const motion m = to_motion(&at_rest.motion);
  return other_of(&heard, &s, &b, &m, horizon_us, now_us, lease_us, 1).held;
}
probe_span probe_held_for(probe_span operand, int32_t* runs, int32_t ticks, int32_t new_tick) {
  return from_margin(held_for(to_margin(operand), runs, ticks, new_tick));
}
probe_span probe_at_least(probe_span a, probe_span b, int64_t strict) {
  return from_margin(margin_at_least(to_span(a), to_span(b), WEIGHT_MM, strict));
}
probe_span probe_both(probe_span a, probe_span b) {
  return from_margin(margin_and(to_margin(a), to_margin(b)));
}
probe_span probe_one(probe_span a, probe_span b) {
  return from_margin(margin_or(to_margin(a), to_margin(b)));
}

static probe_robot declared(const body* b, const motion* any) {
  probe_robot r;
  const probe_point none = {0, 0, 0, 0, 0, 1};
  r.position = none;
  r.velocity = none;
  r.body.radius_mm = b->radius_mm;
  r.body.speed_mmps = b->speed_mmps;
  r.body.position_error_mm = b->position_error_mm;
  r.body.velocity_error_mmps = b->velocity_error_mmps;
  r.body.accel_mmps2 = b->accel_mmps2;
  r.body.brake_mmps2 = b->brake_mmps2;
  r.body.brake_lag_ms = b->brake_lag_ms;
  r.body.brake_lag_permille = b->brake_lag_permille;
  r.body.hold_mm = b->hold_mm;
  r.body.position_age_us = b->position_age_us;
  r.body.velocity_age_us = b->velocity_age_us;
  r.body.sway_permille = b->sway_permille;
  r.motion.speed_mmps = any->speed_mmps;
  r.motion.accel_mmps2 = any->accel_mmps2;
  r.motion.recovery = any->recovery;
  r.held = 0;
  return r;
}
probe_robot probe_cart(void) {
  return declared(&guard_body, &guard_motions[0]);
}
probe_robot probe_kite(void) {
  return declared(&pilot_body, &pilot_motions[0]);
}
probe_robot probe_leaf(void) {
  return declared(&drift_body, &drift_motions[0]);
}
probe_robot probe_swift(void) {
  return declared(&flit_body, &flit_motions[0]);
}
probe_robot probe_drone(void) {
  return declared(&hover_body, &hover_motions[0]);
}
int32_t probe_floor(probe_zone* z) {
  int32_t i;
  z->count = zone_floor.count;
  for (i = 0; i < z->count; ++i) {
    const edge* e = &zone_floor.edges[i];
    z->edges[i].ax = e->ax;
    z->edges[i].ay = e->ay;
    z->edges[i].bx = e->bx;
    z->edges[i].by = e->by;
    z->edges[i].ux_q30 = e->ux_q30;
    z->edges[i].uy_q30 = e->uy_q30;
  }
  return z->count;
}
