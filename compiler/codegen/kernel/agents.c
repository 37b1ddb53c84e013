/* What moves by itself and obeys no decision: it may do anything up to a speed, until the robot
 * stands. Source: the theory of this project, two robots: uncooperative agents. */
/*= near_agents */
/*= agents_in_space */
/* Some of them have heights; the others are near whatever their heights are. */
/*= agent_kind_type */
/* What is declared of an agent, rounded to the safe side. */
typedef struct agent_kind {
  int64_t radius_mm, error_mm, speed_mmps, age_us;
} agent_kind;
/*= agent_type : vec_type near_agents */
/* An agent as it was seen: its centre within `error_mm` of p, and never faster than
 * `speed_mmps`. */
typedef struct agent {
  int32_t input;  /* that is missing; INPUT_NONE: usable */
  int32_t absent; /* it is known not to be there */
  vec p;
  /*? agents_in_space */ int32_t has_height;
  /*? agents_in_space */ int64_t z;
  int64_t radius_mm, error_mm, speed_mmps;
  int64_t age_ms; /* of the sample */
} agent;
/*= agent_of : agent_type agent_kind_type vec_of in_order elapsed_us div_up */
/* From a sample of its place: steps of 1 mm at or below each coordinate, a bit of `between` for each
 * that lies above. What is no number is out of range. `input`: its number in findings. */
static agent agent_of(const agent_kind *k, int64_t x, int64_t y, uint32_t between, int32_t valid,
                      int64_t stamp_us, int64_t now_us, int64_t *last_us, int32_t input) {
  agent a;
  const int32_t good = valid != 0 && in_order(stamp_us, now_us, last_us) && stamp_us <= now_us &&
                       elapsed_us(stamp_us, now_us) <= k->age_us && x >= -AGENT_MAX_MM &&
                       x <= AGENT_MAX_MM && y >= -AGENT_MAX_MM && y <= AGENT_MAX_MM;
  a.input = good ? INPUT_NONE : input;
  a.absent = 0;
  a.p = good ? vec_of(x, y) : vec_of(0, 0);
  /*? agents_in_space */ a.has_height = 0;
  /*? agents_in_space */ a.z = 0;
  a.radius_mm = k->radius_mm;
  a.error_mm = k->error_mm + (between & 1U) + (between >> 1 & 1U);
  a.speed_mmps = k->speed_mmps;
  a.age_ms = good ? div_up(elapsed_us(stamp_us, now_us), 1000) : 0;
  return a;
}
/*= agent_at_height : agent_type */
/* The same agent, with the third coordinate of that sample. */
static agent agent_at_height(agent a, int64_t z, uint32_t between, int32_t input) {
  const int32_t good = z >= -AGENT_MAX_MM && z <= AGENT_MAX_MM;
  a.input = a.input != INPUT_NONE || good ? a.input : input;
  a.has_height = 1;
  a.z = good ? z : 0;
  a.error_mm += between >> 2 & 1U;
  return a;
}
/*= agent_gone : in_order elapsed_us */
/* Absence is asserted, never inferred from silence: by a sample that is fresh and in order. */
static int32_t agent_gone(int64_t present, int32_t valid, int64_t stamp_us, int64_t now_us,
                          int64_t max_age_us, int64_t *last_us) {
  return valid != 0 && in_order(stamp_us, now_us, last_us) && stamp_us <= now_us &&
         elapsed_us(stamp_us, now_us) <= max_age_us && present == 0;
}
/*= agent_distance : agent_type estimate_type body_type motion_type moved_now span_of span_unknown minus dot root_down div_up */
/* The gap between the bodies, now; farther than anything where the agent is absent. */
static span agent_distance(const agent *a, const estimate *s, const body *b, const motion *m) {
  if (a->absent != 0) {
    return span_of(AGENT_FAR_MM, AGENT_FAR_MM);
  }
  if (s->p_input != INPUT_NONE) {
    return span_unknown(s->p_input);
  }
  if (a->input != INPUT_NONE) {
    return span_unknown(a->input);
  } else {
    const vec d = minus(s->p, a->p);
    /*? agents_in_space */ const int64_t up_mm = a->has_height != 0 ? s->z - a->z : 0;
    /*? agents_in_space */ const int64_t centres = root_down(dot(d, d) + up_mm * up_mm);
    /*? !agents_in_space */ const int64_t centres = root_down(dot(d, d));
    const int64_t bodies = centres - b->radius_mm - a->radius_mm;
    const int64_t error = s->p_error_mm + moved_now(s, b, m) + a->error_mm +
                          div_up(a->speed_mmps * a->age_ms, 1000);
    return span_of(bodies - error, bodies + 1 + error);
  }
}
/*= agent_spare @agents_level : agent_type reach_type point_gap_lo point_segment_lo max_of div_up */
/* Spare gap between all that is within reach of the robot and all that the agent may reach until
 * the robot stands; disc or capsule. */
static int64_t agent_spare(const agent *a, const reach *r) {
  const int64_t until_ms = a->age_ms + r->still_ms;
  const int64_t around = a->radius_mm + a->error_mm + div_up(a->speed_mmps * until_ms, 1000);
  const int64_t disc = point_gap_lo(r->p, a->p) - r->disc_mm;
  return max_of(disc, point_segment_lo(a->p, r->p, r->e) - r->capsule_mm) - around;
}
/*= agent_spare @agents_in_space : agent_type reach_type point_gap_lo point_segment_lo spot_of spot_gap_lo spot_segment_lo max_of div_up */
/* The same; in space, of a ball, or on the map. */
static int64_t agent_spare(const agent *a, const reach *r) {
  const int64_t until_ms = a->age_ms + r->still_ms;
  const int64_t around = a->radius_mm + a->error_mm + div_up(a->speed_mmps * until_ms, 1000);
  const spot at = spot_of(a->p, a->z), p = spot_of(r->p, r->z), e = spot_of(r->e, r->z_end);
  const int64_t gap = a->has_height != 0 ? spot_gap_lo(p, at) : point_gap_lo(r->p, a->p);
  const int64_t leg =
      a->has_height != 0 ? spot_segment_lo(at, p, e) : point_segment_lo(a->p, r->p, r->e);
  return max_of(gap - r->disc_mm, leg - r->capsule_mm) - around;
}
/*= agent_reach : agent_spare margin_of margin_true margin_unknown */
static margin agent_reach(const agent *a, const reach *r, int64_t least_mm) {
  if (a->absent != 0) {
    return margin_true();
  }
  if (r->input != INPUT_NONE || a->input != INPUT_NONE) {
    return margin_unknown(r->input != INPUT_NONE ? r->input : a->input);
  } else {
    const int64_t spare = agent_spare(a, r) - least_mm;
    return margin_of(spare * WEIGHT_MM, spare * WEIGHT_MM, REASON_MARGIN);
  }
}
/*= agent_gate : agent_spare */
/* A recovery moves only while the test holds: an agent makes no way. */
static int32_t agent_gate(int32_t gate, const agent *a, const reach *r, int64_t least_mm) {
  if (a->absent != 0) {
    return gate;
  }
  return r->input != INPUT_NONE || a->input != INPUT_NONE || agent_spare(a, r) < least_mm
             ? GATE_HOLD
             : gate;
}
