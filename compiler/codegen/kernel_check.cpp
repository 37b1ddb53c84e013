#include "compiler/codegen/kernel_check.h"

#include <algorithm>

#include "compiler/codegen/fleet_index.h"
#include "compiler/codegen/kernel_blocks.h"
#include "compiler/codegen/watch.h"
#include "compiler/ir/margin_unit.h"

namespace rtac::codegen {

using namespace ir;

std::string CheckPrinter::function(const Monitor& m, const char* what) const {
  return id_ + "_" + names_(m.name) + "_" + what;
}
// What a monitor finds ahead, with what it takes to steer away from it.
std::string CheckPrinter::ahead(const Monitor& m) {
  const std::string call = function(m, "ahead") + "(v)";
  if (!d_.body.heading_age_us) return call;
  use({"steered"});
  return "steered(" + call + ", v->heading)";
}
void CheckPrinter::print_monitor(const Monitor& m, BlockPrinter& blocks) {
  blocks.function(function(m, "now"), requirement(m) + ". " + m.text, m.property, out_,
                  mixes_units(m));
  blocks.function(function(m, "ahead"), "Everything within reach; recovery: " + m.recovery.name,
                  *m.ahead, out_, mixes_units(m));
  if (m.return_when) {
    blocks.function(function(m, "return"), "return when " + m.return_text, *m.return_when, out_);
  }
}

void CheckPrinter::print_monitors() {
  BlockPrinter blocks(module_, d_, names_, view_, uses_);
  for (const Monitor& m : d_.monitors) print_monitor(m, blocks);
}

void CheckPrinter::print_look() {
  use({"reach_of"});
  std::vector<std::string> parameters = {view_ + " *v", "const motion *m", "int64_t horizon_us"};
  if (pairs()) parameters.emplace_back("int32_t any_promise");
  const std::string head = signature("static void " + id_ + "_look", parameters);
  out_.comment(std::string("Sets what is within reach.") +
               (pairs() ? " Promises of a robot that goes first are relied "
                          "upon only while driving, not for starting to (any_promise 0)."
                        : ""));
  out_.block(head, [&](Code& to) {
    if (pairs()) to.line("int32_t j;");
    to.line("v->m = m;");
    to.line("v->horizon_us = horizon_us;");
    to.line("v->within = reach_of(&v->self, &BODY, m, horizon_us);");
    if (judges_commands(d_)) print_course(to);
    if (pairs()) {
      use({"other_of"});
      to.block("for (j = 0; j < ROBOTS; ++j)", [&](Code& each) {
        const std::string near = leaves_far_out(d_) ? " && !" + is_far() : "";
        each.block("if (j != v->in->self" + near + ")", [&](Code& body) {
          body.line("const " + p_ + "_other *heard = &v->in->others[j];");
          body.line("const estimate s = v->others[j].s;");
          if (d_.open_fleet) body.line("const int32_t absent = v->others[j].absent;");
          body.line(
              "v->others[j] = other_of(heard, &s, &BODY, &MOTIONS[0], horizon_us, v->now_us,");
          body.line("                        " + num(d_.lease_us) +
                    ", any_promise || heard->goes_first == 0);");
          if (d_.open_fleet) body.line("v->others[j].absent = absent;");
        });
      });
    }
  });
  out_.blank();
}

// A recovery decides by itself what it commands next: only its limits are known.
void CheckPrinter::print_course(Code& to) {
  use({"course_of"});
  to.line("v->told.input = v->self.input;");
  to.line("v->told.usable = 0;");
  to.block("if (m->recovery == 0)", [&](Code& body) {
    body.line("v->told = course_of(&v->self, &BODY, &" + id_ + "_order, v->commands,");
    body.line("                    &v->in->proposed, v->now_us, horizon_us);");
  });
}

void CheckPrinter::print_measure() {
  use({"estimate_of", "in_order", "lost"});
  out_.comment("Estimates from the inputs; a stamp or a clock that goes backwards is a fault.");
  out_.block(
      signature("static void " + id_ + "_measure",
                {view_ + " *v", name_ + "_state *s", "int64_t elapsed"}),
      [&](Code& to) {
        to.line("const " + name_ + "_in *in = v->in;");
        if (pairs()) to.line("int32_t j;");
        if (pairs() && leaves_far_out(d_)) to.line("int64_t nearest_mm2 = INT64_MAX, far_mm;");
        measure_self(to);
        measure_charge(to);
        measure_ages(to);
        if (pairs()) {
          to.block("for (j = 0; j < ROBOTS; ++j)", [&](Code& each) { measure_other(each); });
        }
        if (pairs() && leaves_far_out(d_)) measure_near(to);
        measure_agents(to);
        to.block("if (in->self < 0 || in->self >= ROBOTS)", [&](Code& body) {
          body.line("lost(&v->self, " + up_ + "_INPUT_OTHER_ROBOT); /* nobody of the fleet */");
        });
        to.block("if (elapsed < 0)", [&](Code& body) {
          body.line("lost(&v->self, " + up_ + "_INPUT_CLOCK);");
          if (uses_battery()) body.line("v->charge = span_unknown(" + up_ + "_INPUT_CLOCK);");
        });
        if (d_.held_slots > 0) {
          to.block("if (elapsed != 0 && elapsed != 1)", [&](Code& body) {
            use({"clamp_of", "min_of"});
            const std::string most = num(missed_ticks_max);
            body.comment(
                "missed ticks are unknown: what must hold without a gap starts anew, and it may "
                "have held in all of them; beyond " +
                most + " of them the past is forgotten, and it may always have held");
            body.line("const int64_t missed = clamp_of(elapsed - 1, 0, INT32_MAX);");
            body.line("int32_t k;");
            body.block("for (k = 0; k < " + num(d_.held_slots) + "; ++k)", [&](Code& each) {
              each.line("s->runs[2 * k] = 0;");
              each.line("s->runs[2 * k + 1] =");
              each.line("    missed > " + most +
                        " ? INT32_MAX : (int32_t)min_of(s->runs[2 * k + 1] + missed, INT32_MAX);");
            });
          });
        }
      });
  out_.blank();
}

// `fault` when the stamp of a valid sample lies before that of the last one.
void CheckPrinter::in_order(Code& to, const std::string& sample, const std::string& last,
                            const std::string& fault) {
  to.block("if (" + sample + ".valid && !in_order(" + sample + ".stamp_us, v->now_us, &s->" + last +
               "))",
           [&](Code& body) { body.line(fault); });
}

void CheckPrinter::measure_self(Code& to) {
  to.line("v->self = estimate_of(&in->position, &in->velocity, v->now_us, &BODY);");
  in_order(to, "in->position", "last_position_us", "lost(&v->self, " + up_ + "_INPUT_POSITION);");
  in_order(to, "in->velocity", "last_velocity_us", "v->self.input = " + up_ + "_INPUT_VELOCITY;");
  for (const ZoneIndex zone : own_places()) {
    // once a tick: every horizon and every driver starts from the same place
    const char* const seen = module_[zone].has_height() ? "place_in_solid" : "place_seen";
    use({seen});
    to.line("v->" + place_symbol(module_[zone], names_) + " = " + std::string(seen) + "(&" +
            zone_symbol(module_[zone], names_) + ", &v->self);");
  }
  if (!d_.body.heading_age_us) return;
  use({"heading_fault"});
  to.line("v->heading = heading_fault(&in->heading, v->now_us, " + num(*d_.body.heading_age_us) +
          ");");
  in_order(to, "in->heading", "last_heading_us", "v->heading = " + up_ + "_INPUT_HEADING;");
}

void CheckPrinter::measure_charge(Code& to) {
  if (!uses_battery()) {
    use({"span_of"});
    to.line("v->charge = span_of(0, 0);");
    return;
  }
  use({"charge_now", "span_unknown"});
  to.line("v->charge = charge_now(&in->battery, v->now_us, " + num(d_.body.battery_age_us) + ", " +
          num(d_.body.battery_error_ppm) + ", " + num(d_.body.drain_ppm_per_s) + ");");
  in_order(to, "in->battery", "last_battery_us",
           "v->charge = span_unknown(" + up_ + "_INPUT_BATTERY);");
}

// After the stamps have been compared with those of earlier samples.
void CheckPrinter::measure_ages(Code& to) {
  for (const Sensed signal : aged()) {
    use({"sensed_age"});
    const std::string word = word_of(signal);
    to.line("v->age_of_" + word + " = sensed_age(in->" + word + ".valid, in->" + word +
            ".stamp_us, v->now_us, s->last_" + word + "_us,");
    to.line("    " + up_ + "_INPUT_" + upper(word) + ");");
  }
}

void CheckPrinter::measure_other(Code& to) {
  use({"promise_kept"});
  const std::string missing = up_ + "_INPUT_OTHER_ROBOT";
  const std::string fault = "lost(&v->others[j].s, " + missing + ");";
  const bool close_later = leaves_far_out(d_);
  to.line("const " + p_ + "_other *o = &in->others[j];");
  if (close_later) {
    to.line("v->others[j].off_mm = -1;");
    to.line("v->others[j].s.p_input = v->others[j].s.input = " + up_ + "_INPUT_NONE;");
  } else {
    to.line("v->others[j].s = " + heard());
  }
  if (d_.open_fleet) {
    use({"is_absent", "says_absent"});
    to.line("v->others[j].absent = says_absent(o, v->now_us, " + num(d_.body.hears_age_us) +
            ", &s->last_other_presence_us[j]);");
  }
  in_order(to, "o->position", "last_other_us[j]", fault);
  in_order(to, "o->velocity", "last_other_velocity_us[j]",
           "v->others[j].s.input = " + missing + ";");
  to.block("if (o->position.valid &&\n          !promise_kept(o->lease_end_us, v->now_us, " +
               num(d_.lease_us) + ", &s->last_other_lease_us[j]))",
           [&](Code& body) { body.line(fault); });
  if (!close_later) return;
  use({"nearer_of"});
  const std::string there = d_.open_fleet ? " && !v->others[j].absent" : "";
  to.block("if (j != in->self" + there + ")", [&](Code& body) {
    body.line("nearest_mm2 = nearer_of(&v->others[j], o, &v->self, &" + id_ +
              "_heard_body, v->now_us, nearest_mm2);");
  });
}

// The estimate of robot number j.
std::string CheckPrinter::heard() const {
  return "estimate_of(&o->position, &o->velocity, v->now_us, &" + id_ + "_heard_body);";
}

std::string CheckPrinter::is_far() {
  use({"is_far"});
  return "is_far(&v->others[j])";
}

// A closer look at those that are not far off; what the stamps of their samples said stands.
void CheckPrinter::measure_near(Code& to) {
  use({"far_from"});
  const std::string missing = up_ + "_INPUT_OTHER_ROBOT", none = up_ + "_INPUT_NONE";
  std::int64_t accel_mmps2 = 0;
  for (const Motion& m : d_.motions) accel_mmps2 = std::max(accel_mmps2, m.accel_mmps2);
  to.line("far_mm = far_from(nearest_mm2, &v->self, &BODY, " + num(accel_mmps2) + ", " +
          num(*std::max_element(horizons_.begin(), horizons_.end()) + d_.return_extra_us) + ", " +
          num(d_.heard_reach_mm) + ", " + num(separation_.value_or(0)) + ");");
  to.block("for (j = 0; j < ROBOTS; ++j)", [&](Code& each) {
    each.line("const " + p_ + "_other *o = &in->others[j];");
    each.line("const int32_t p_input = v->others[j].s.p_input, input = v->others[j].s.input;");
    each.line("v->others[j].far = v->others[j].off_mm >= far_mm;");
    each.block("if (!v->others[j].far)", [&](Code& body) {
      body.line("v->others[j].s = " + heard());
      body.block("if (p_input != " + none + ")",
                 [&](Code& lost) { lost.line("lost(&v->others[j].s, " + missing + ");"); });
      body.block("if (input != " + none + ")",
                 [&](Code& lost) { lost.line("v->others[j].s.input = " + missing + ";"); });
    });
  });
}

// Whatever tick it is: they count from the moment on at which they are seen.
void CheckPrinter::measure_agents(Code& to) {
  if (d_.agents.empty()) return;
  use({"agent_of"});
  const WatchKernel kernel = kernel_of_facts(module_, d_, names_);
  const WatchNames members = watch_names(kernel.watch);
  for (std::size_t k = 0; k < d_.agents.size(); ++k) {
    const Agent& agent = d_.agents[k];
    const std::string at = num(std::int64_t(k)), kind = id_ + "_agents[" + at + "]";
    const std::string seen = "in->facts." + members.samples[agent.seen] + ".";
    wrapped(to, "v->agents[" + at + "] = agent_of(&" + kind + ", " + seen + "x, " + seen + "y, " +
                    seen + "between, " + seen + "valid, " + seen +
                    "stamp_us, v->now_us, &s->last_agent_us[" + at + "], " +
                    kernel.numbers[agent.seen] + ");");
    if (agent.in_space) {
      use({"agent_at_height"});
      wrapped(to, "v->agents[" + at + "] = agent_at_height(v->agents[" + at + "], " + seen + "z, " +
                      seen + "between, " + kernel.numbers[agent.seen] + ");");
    }
    if (!agent.present) continue;
    use({"agent_gone"});
    const std::string said = "in->facts." + members.samples[*agent.present] + ".";
    wrapped(to, "v->agents[" + at + "].absent = agent_gone(" + said + "value, " + said + "valid, " +
                    said + "stamp_us, v->now_us, " + num(agent.age_us) +
                    ", &s->last_agent_present_us[" + at + "]);");
  }
}

namespace {

bool reads_battery(const Block& block) {
  return std::any_of(block.values.begin(), block.values.end(), [](const Value& v) {
    if (const Block* others = body_of(v.op)) return reads_battery(*others);
    const auto* age = std::get_if<SensedAge>(&v.op);
    if (age != nullptr && age->signal == Sensed::battery) return true;
    return std::holds_alternative<Battery>(v.op) || std::holds_alternative<EnergyReach>(v.op) ||
           std::holds_alternative<ChargeReach>(v.op);
  });
}

}  // namespace

bool CheckPrinter::uses_battery() const {
  const auto& facts = d_.facts.monitors;
  if (std::any_of(facts.begin(), facts.end(),
                  [](const PlainMonitor& fact) { return reads_battery(fact.property); })) {
    return true;
  }
  return std::any_of(d_.monitors.begin(), d_.monitors.end(), [](const Monitor& m) {
    return reads_battery(m.property) || (m.ahead && reads_battery(*m.ahead)) ||
           (m.return_when && reads_battery(*m.return_when));
  });
}

template <class Each>
void CheckPrinter::for_monitors(std::size_t horizon, const Each& each) const {
  for (std::size_t k = 0; k < d_.monitors.size(); ++k) {
    if (horizon_of(d_.monitors[k]) == horizon) {
      each(d_.monitors[k], "checks[" + num(std::int64_t(k)) + "]");
    }
  }
}

// `v` sees with one horizon at a time; the last one stays, under the motion of whoever drives.
void CheckPrinter::print_horizon(std::size_t horizon, Code& to) {
  const std::string us = id_ + "_horizons_us[" + num(std::int64_t(horizon)) + "]";
  to.block(
      "if (back)",
      [&](Code& body) {
        body.line("v->legs = 1;");
        body.line(id_ + "_look(v, &MOTIONS[0], " + us + " + " + num(d_.return_extra_us) +
                  (pairs() ? ", 0);" : ");"));
        for_monitors(horizon, [&](const Monitor& m, const std::string& at) {
          body.line(at + ".safer = " + ahead(m) + ";");
        });
      },
      "} else {");
  for_monitors(horizon, [&](const Monitor&, const std::string& at) {
    to.line("  " + at + ".safer = margin_unknown(" + up_ + "_INPUT_NONE);");
  });
  to.line("}");
  to.line("v->legs = mode == 0;");
  to.line(id_ + "_look(v, &MOTIONS[v->driver], " + us + (pairs() ? ", 1);" : ");"));
  for_monitors(horizon, [&](const Monitor& m, const std::string& at) {
    to.line(at + ".now = " + function(m, "now") + "(v);");
    to.line(at + ".ahead = " + ahead(m) + ";");
    to.line(at +
            ".gives_back = " + (m.return_when ? function(m, "return") + "(v);" : "margin_true();"));
  });
}

// Where no recovery is faster than who drives, what was found under his motion is as good: then a
// tick costs no more than one that does not coordinate.
void CheckPrinter::print_predict() {
  use({"margin_type", "faster_of"});
  out_.comment(
      "What every monitor finds ahead, row by row under the motion of each recovery, if it is "
      "faster than who drives, and of his else.");
  out_.block(
      signature("static void " + id_ + "_predict",
                {view_ + " *v", "const check *checks", "margin *ahead"}),
      [&](Code& to) {
        to.line("int32_t i, j;");
        to.block("for (i = 0; i < MONITORS; ++i, ahead += MONITORS)", [&](Code& each) {
          each.line("const int32_t driver =");
          each.line("    v->driver > MONITORS ? v->driver : faster_of(MOTIONS, v->driver, i + 1);");
          each.block("for (j = 0; j < MONITORS; ++j)",
                     [&](Code& body) { body.line("ahead[j] = checks[j].ahead;"); });
          each.block("if (driver != v->driver)", [&](Code& body) { predict_row(body); });
        });
      });
  out_.blank();
}

void CheckPrinter::predict_row(Code& to) {
  for (std::size_t h = 0; h < horizons_.size(); ++h) {
    to.line(id_ + "_look(v, &MOTIONS[driver], " + id_ + "_horizons_us[" + num(std::int64_t(h)) +
            (pairs() ? "], 1);" : "]);"));
    for_monitors(h, [&](const Monitor& m, const std::string& at) {
      const std::string entry = at.substr(at.find('['));
      to.line("ahead" + entry + " = " + this->ahead(m) + ";");
    });
  }
}

void CheckPrinter::print_check() {
  use({"check_type", "margin_unknown"});
  for (const Monitor& m : d_.monitors) {
    if (!m.return_when) use({"margin_true"});
  }
  out_.comment(
      "What every monitor finds: now, ahead under the motion of whoever drives, and, "
      "when control might be given back, with the longer horizon under any control.");
  out_.block(signature("static void " + id_ + "_check",
                       {view_ + " *v", "int32_t mode", "int32_t back", "check *checks"}),
             [&](Code& to) {
               for (std::size_t h = 0; h < horizons_.size(); ++h) print_horizon(h, to);
             });
  out_.blank();
}

}  // namespace rtac::codegen
