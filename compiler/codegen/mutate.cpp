#include "compiler/codegen/mutate.h"

#include <algorithm>
#include <variant>

namespace rtac::codegen {
namespace {

using namespace ir;

// What a bound of the sampled brake takes `us` for; the brake of a body whose speed is commanded
// has no such part.
void forget_delay(Decision& d, std::int64_t us) {
  const std::int64_t share = d.body.brake_lag_ms < d.body.brake_late_ms ? 2 : 1;
  d.body.brake_lag_ms = std::max<std::int64_t>(0, d.body.brake_lag_ms - us / share / 1000);
}

void no_latency(Decision& d) {
  forget_delay(d, d.body.latency_us);
  d.body.latency_us = 0;
}
void no_sample_age(Decision& d) {
  forget_delay(d, d.body.velocity_age_us);
}
void no_position_error(Decision& d) {
  d.body.hold_mm = std::max<std::int64_t>(0, d.body.hold_mm - 2 * d.body.position_error_mm);
  d.body.position_error_mm = 0;
}
void no_velocity_error(Decision& d) {
  forget_delay(d, 1'000'000 * d.body.velocity_error_mmps / d.body.brake_mmps2);
  // of a hold of 2 rad/s: 2 e / omega, and 0.28 / omega of the 2 e at which it may be latched
  const std::int64_t held_mm = 1'280 * d.body.velocity_error_mmps / 1'000;
  d.body.hold_mm = std::max<std::int64_t>(0, d.body.hold_mm - held_mm);
  d.body.velocity_error_mmps = 0;
}
void no_noise(Decision& d) {
  no_position_error(d);
  no_velocity_error(d);
}
void no_disturbance(Decision& d) {
  const std::int64_t pushed_mmps2 = d.body.disturbance_mmps2;
  for (Motion& m : d.motions)
    m.accel_mmps2 = std::max<std::int64_t>(1, m.accel_mmps2 - pushed_mmps2);
  d.body.accel_mmps2 = d.motions[0].accel_mmps2;
  // of a hold of 2 rad/s: d / omega^2
  d.body.hold_mm = std::max<std::int64_t>(0, d.body.hold_mm - pushed_mmps2 / 4);
  d.body.disturbance_mmps2 = 0;
}
void no_radius(Decision& d) {
  d.body.radius_mm = 0;
}
void no_tube(Decision& d) {
  d.body.brake_lag_ms = d.body.brake_lag_permille = d.body.hold_mm = 0;
}
void no_acceleration(Decision& d) {
  d.body.accel_mmps2 = d.motions[0].accel_mmps2 = 1;
}
void strong_brake(Decision& d) {
  d.body.brake_mmps2 *= 2;
}

void agents_stand(Decision& d) {
  for (Agent& agent : d.agents) agent.speed_mmps = 0;
}

void one_is_enough(Block& block) {
  for (Value& value : block.values) {
    if (Block* const body = body_of(value.op)) one_is_enough(*body);
    if (const auto* const both = std::get_if<And>(&value.op)) {
      value.op = Or{both->a, both->b};
    } else if (auto* const others = std::get_if<ForOthers>(&value.op)) {
      others->universal = false;
    }
  }
}
// Of the look-ahead.
void or_for_and(Decision& d) {
  for (Monitor& m : d.monitors) {
    if (m.ahead) one_is_enough(*m.ahead);
  }
}

void unchecked(Recovery& r) {
  r.claims = false;
}

bool has_ages(const Decision& d) {
  return d.body.position_age_us > 0 || d.body.velocity_age_us > 0;
}
bool is_pushed(const Decision& d) {
  return d.body.disturbance_mmps2 > 0;
}
bool has_several(const Decision& d) {
  return d.monitors.size() > 1;
}

const TextEdit no_age{"t_us = s->age_us + horizon_us;", "t_us = horizon_us;"};

}  // namespace

// A table.
// NOLINTNEXTLINE(readability-function-size)
const std::vector<Mutant>& mutants() {
  static const std::vector<Mutant> all = {
      {"half-look-ahead",
       "half of the time until a recovery acts is enough",
       nullptr,
       {{"t_us = s->age_us + horizon_us;", "t_us = (s->age_us + horizon_us) / 2;"}}},
      {"no-look-ahead",
       "a recovery acts at once, on measurements of now",
       nullptr,
       {{"t_us = s->age_us + horizon_us;", "t_us = 0 * horizon_us;"}}},
      {"no-latency", "commands act at once", no_latency, {}},
      {"no-sample-age", "measurements are of now", no_sample_age, {no_age}, nullptr, has_ages},
      {"no-position-error", "places are measured exactly", no_position_error, {}},
      {"no-velocity-error", "velocities are measured exactly", no_velocity_error, {}},
      {"no-noise", "everything is measured exactly", no_noise, {}},
      {"equal-stamps",
       "position and velocity are of one moment",
       nullptr,
       {{"div_up(b->accel_mmps2 * apart_ms, 1000)", "0 * apart_ms"}},
       nullptr,
       has_ages},
      {"no-stopping-distance",
       "a robot stops at once",
       nullptr,
       {{"stop = braked_mm(s1, s1, b)", "stop = 0"},
        {"t_us + stopping_us(s, b)", "t_us"},
        {"by_accel + braked_mm(s->speed_mmps + s1, drift, b)", "by_accel + 0 * drift"}}},
      {"strong-brake", "it brakes twice as hard as is declared", strong_brake, {}},
      {"no-tube", "the brake follows its ideal path", no_tube, {}},
      {"no-disturbance", "nothing pushes the robot", no_disturbance, {}, nullptr, is_pushed},
      {"no-radius", "robots are points", no_radius, {}},
      {"no-acceleration", "the speed stays what it is", no_acceleration, {}},
      {"measured-speed-is-the-most",
       "nobody gets faster than it is measured",
       nullptr,
       {{"s1 = min_of(cap, s0 + div_up(m->accel_mmps2 * t_ms, 1000))", "s1 = s0"}}},
      {"or-for-and", "one of several conditions is enough", or_for_and, {}},
      {"lowest-priority-drives",
       "the least important of the engaged monitors drives",
       nullptr,
       {{"    if (monitors[k].engaged != 0) {\n      return k;",
         "    if (monitors[count - 1 - k].engaged != 0) {\n      return count - 1 - k;"}},
       nullptr,
       has_several},
      {"never-gives-way",
       "a recovery keeps every monitor that ranks higher",
       nullptr,
       {{"(keeps[j] != 1 || ", "(keeps[j] < 0 && "}}},
      {"shortest-prefix-drives",
       "of several recoveries the one that keeps least of the order may drive",
       nullptr,
       {{"kept > longest ||", "(kept >= 0 && (longest < 0 || kept < longest)) ||"}}},
      {"points-only",
       "way-points are reached without passing what lies between",
       nullptr,
       {{"segment_boundary_lo(z, from, to)", "segment_boundary_lo(z, to, to)"}}},
      {"no-message-age",
       "what others say is of now",
       nullptr,
       {{"  o.r = reach_of(s, b, any, horizon_us);",
         "  o.s.age_us = 0;\n  o.r = reach_of(&o.s, b, any, horizon_us);"}}},
      {"others-stand",
       "every other robot stays where it was heard",
       nullptr,
       {{"o.held = may_use && horizon_us <= lease_us && in->lease_end_us >= later(now_us, "
         "horizon_us);",
         "o.held = 1;"}}},
      {"agents-stand", "what moves by itself stands still", agents_stand, {}},
      {"no-agent-age",
       "agents are where they were seen",
       nullptr,
       {{"until_ms = a->age_ms + r->still_ms", "until_ms = r->still_ms"}}},
      {"open-gate",
       "a recovery may always move",
       nullptr,
       {{"if (pair_spare(r, &others[j], b) < least_mm) {", "if (0) {"}}},
      {"level-flight",
       "robots in space stay at their height",
       nullptr,
       {{"min_of(p_z, e_z) - need_mm", "p_z"},
        {"max_of(p_z, e_z) + need_mm", "p_z"},
        {"spot_of(r->e, r->z_end)", "spot_of(r->e, r->z)"},
        {"spot_of(o->r.e, o->r.z_end)", "spot_of(o->r.e, o->r.z)"}}},
      {"no-lead",
       "zones with times stay as they are now",
       nullptr,
       {{"later(now_us, ahead_us)) ? margin_true()",
         "later(now_us, 0 * ahead_us)) ? margin_true()"}}},
      {"unchecked-claim", "an external recovery does what it claims", nullptr, {}, unchecked},
      {"stale-charge",
       "a measured charge does not fall",
       nullptr,
       {{"drain_ppm_per_s * div_up(age_us, 1000)", "0 * div_up(age_us, 1000)"}}},
  };
  return all;
}

const Mutant* find_mutant(const std::string& name) {
  const auto& all = mutants();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Mutant& m) { return name == m.name; });
  return found == all.end() ? nullptr : &*found;
}

std::string mutant_names() {
  std::string names;
  for (const Mutant& m : mutants()) {
    names += (names.empty() ? "`" : ", `") + std::string(m.name) + "`";
  }
  return names;
}

bool may_matter(const Mutant& mutant, const Module& module) {
  return mutant.matters == nullptr || std::ranges::any_of(module.decisions, [&](const Decision& d) {
           return !d.on_plan && mutant.matters(d);
         });
}

void mutate(const Mutant& mutant, Recovery& recovery) {
  if (mutant.of_recovery == nullptr) return;
  mutant.of_recovery(recovery);
  for (Recovery& step : recovery.steps) mutate(mutant, step);
}

void mutate(const Mutant& mutant, Module& module) {
  for (Decision& d : module.decisions) {
    if (d.on_plan) continue;
    if (mutant.edit != nullptr) mutant.edit(d);
    for (Monitor& m : d.monitors) mutate(mutant, m.recovery);
  }
}

std::string mutate(const Mutant& mutant, std::string kernel_source) {
  for (const TextEdit& edit : mutant.text) {
    const std::string from = edit.from, to = edit.to;
    for (std::size_t at = kernel_source.find(from); at != std::string::npos;
         at = kernel_source.find(from, at + to.size())) {
      kernel_source.replace(at, from.size(), to);
    }
  }
  return kernel_source;
}

std::string mark_of(const Mutant& mutant) {
  return std::string("--mutate ") + mutant.name + ", DELIBERATELY UNSOUND: it believes that " +
         mutant.about;
}

}  // namespace rtac::codegen
