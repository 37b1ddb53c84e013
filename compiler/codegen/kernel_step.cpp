#include "compiler/codegen/kernel_step.h"

#include <algorithm>

#include "compiler/codegen/closing_rate.h"
#include "compiler/codegen/kernel_check.h"
#include "compiler/ir/facts.h"
#include "compiler/ir/linear.h"
#include "compiler/ir/margin_unit.h"

namespace rtac::codegen {
namespace {

using namespace ir;

class StepPrinter : public CheckPrinter {
 public:
  using CheckPrinter::CheckPrinter;

  void print() {
    print_constants();
    print_signals();
    print_view();
    print_facts();
    print_monitors();
    print_look();
    init();
    print_measure();
    print_check();
    if (d_.coordinated) print_predict();
    report();
    step();
    close();
  }

 private:
  void init() {
    out_.block("void " + name_ + "_init(" + name_ + "_state *s)", [&](Code& to) {
      to.line(std::string("int32_t k;"));
      to.line("s->clock.started = 0;");
      to.line("s->clock.origin_us = 0;");
      to.line("s->clock.last_us = 0;");
      to.line("s->clock.tick = 0;");
      to.block("for (k = 0; k < MONITORS; ++k)", [&](Code& each) {
        each.line("s->monitors[k].engaged = 0;");
        each.line("s->monitors[k].dwell = 0;");
        each.line("s->monitors[k].found.reason = " + up_ + "_REASON_NONE;");
        each.line("s->monitors[k].found.index = 0;");
        each.line("s->monitors[k].found.input = " + up_ + "_INPUT_NONE;");
        each.line("s->monitors[k].found.other = -1;");
      });
      to.comment("until the first step has found that control may be given");
      to.line("s->mode = 1;");
      to.line("s->takeover.time_us = INT64_MAX;");
      to.line("s->takeover.before = 0;");
      to.line("s->lease_end_us = INT64_MIN;");
      to.line("s->last_position_us = INT64_MIN;");
      to.line("s->last_velocity_us = INT64_MIN;");
      to.line("s->last_battery_us = INT64_MIN;");
      if (d_.body.heading_age_us) to.line("s->last_heading_us = INT64_MIN;");
      to.block("for (k = 0; k < ROBOTS; ++k)", [&](Code& each) {
        each.line("s->last_other_us[k] = INT64_MIN;");
        each.line("s->last_other_velocity_us[k] = INT64_MIN;");
        each.line("s->last_other_lease_us[k] = INT64_MIN;");
        if (d_.open_fleet) each.line("s->last_other_presence_us[k] = INT64_MIN;");
      });
      if (!d_.agents.empty()) {
        to.block("for (k = 0; k < " + num(std::int64_t(d_.agents.size())) + "; ++k)",
                 [&](Code& each) {
                   each.line("s->last_agent_us[k] = INT64_MIN;");
                   each.line("s->last_agent_present_us[k] = INT64_MIN;");
                 });
      }
      if (judges_commands(d_)) {
        to.block("for (k = 0; k < " + up_ + "_COMMANDS; ++k)", [&](Code& each) {
          each.line("s->commands[k].time_us = INT64_MIN;");
          each.line("s->commands[k].x_mmps2 = 0;");
          each.line("s->commands[k].y_mmps2 = 0;");
          if (in_space(module_)) each.line("s->commands[k].z_mmps2 = 0;");
          each.line("s->commands[k].known = 0;");
        });
      }
      if (d_.held_slots > 0) {
        to.block("for (k = 0; k < " + num(2 * d_.held_slots) + "; ++k)",
                 [&](Code& each) { each.line("s->runs[k] = 0;"); });
      }
      init_facts(to);
    });
    out_.blank();
  }

  void report() {
    use({"verdict_of", "age_of"});
    out_.comment("The record of the tick. `back`: control might have been given back.");
    out_.block(signature("static void " + id_ + "_report",
                         {"const " + view_ + " *v", "const " + name_ + "_state *s",
                          "const check *checks", "int32_t back", name_ + "_out *out"}),
               [&](Code& to) {
                 to.line("const " + name_ + "_in *in = v->in;");
                 to.line("int32_t k;");
                 to.line("out->tick = s->clock.tick;");
                 to.line("out->time_us = v->now_us;");
                 to.line("out->lease_end_us = s->lease_end_us;");
                 for (const std::string f : {"position", "velocity", "battery", "heading"}) {
                   if (f == "heading" && !d_.body.heading_age_us) continue;
                   to.line("out->" + f + "_age_us = age_of(in->" + f + ".valid, in->" + f +
                           ".stamp_us, v->now_us);");
                 }
                 violation(to);
                 to.block("for (k = 0; k < MONITORS; ++k)", [&](Code& each) {
                   each.line("out->monitors[k].now = verdict_of(checks[k].now);");
                   each.line("out->monitors[k].ahead = verdict_of(checks[k].ahead);");
                   each.line("out->monitors[k].safer = back ? verdict_of(checks[k].safer) : " +
                             up_ + "_VERDICT_UNKNOWN;");
                   each.line("out->monitors[k].engaged = s->monitors[k].engaged;");
                   each.line("out->monitors[k].margin = checks[k].ahead.lo;");
                   each.line("out->monitors[k].now_margin = checks[k].now.lo;");
                   if (mixes_units(module_)) {
                     uses_.insert("told_unit");
                     each.line("out->monitors[k].unit = told_unit(checks[k].ahead);");
                     each.line("out->monitors[k].now_unit = told_unit(checks[k].now);");
                   }
                   if (has_return_conditions(module_)) {
                     each.line("out->monitors[k].returns = verdict_of(checks[k].gives_back);");
                   }
                 });
                 to.line("out->monitor = s->mode - 1;");
                 to.block(
                     "if (s->mode == 0)",
                     [&](Code& body) {
                       body.line("out->found.reason = " + up_ + "_REASON_NONE;");
                       body.line("out->found.index = 0;");
                       body.line("out->found.input = " + up_ + "_INPUT_NONE;");
                       body.line("out->found.other = -1;");
                     },
                     "} else {");
                 to.line("  out->found = s->monitors[s->mode - 1].found;");
                 to.block(
                     "  if (s->monitors[s->mode - 1].engaged == 0)",
                     [&](Code& body) {
                       body.line("  out->found.reason = in->surrender ? " + up_ +
                                 "_REASON_SURRENDERED : " + up_ + "_REASON_RETURNING;");
                     },
                     "  }");
                 to.line("}");
               });
    out_.blank();
  }

  // Only what closes at a bounded rate tells when it can be violated at the earliest; a zone that
  // is received may be any other one at once.
  void violation(Code& to) {
    if (std::any_of(d_.monitors.begin(), d_.monitors.end(),
                    [](const Monitor& m) { return asks_for_received(m.property); })) {
      to.line("out->violation_us = -1;");
      return;
    }
    to.line("out->violation_us = INT64_MAX;");
    bool known = false;
    for (std::size_t k = 0; k < d_.monitors.size(); ++k) {
      const auto mmps = closing_mmps(d_.monitors[k].property, d_.motions[0].speed_mmps, d_.agents);
      if (!mmps) continue;
      known = true;
      use({"sooner"});
      to.line("out->violation_us = sooner(out->violation_us, checks[" + num(std::int64_t(k)) +
              "].now, " + num(*mmps) + ");");
    }
    if (!known) to.line("out->violation_us = -1;");
  }

  // The driver whose motion bounds what is within reach in `mode`.
  std::string driver(const char* mode) const {
    return "driver_of(&s->takeover, MOTIONS, " + std::string(mode) + ", seen_us, " +
           num(d_.body.latency_us) + ");";
  }

  void step() {
    use({"next_tick", "first_not_safer", "driver_of", "later"});
    if (!d_.coordinated) use({"mode_step"});
    if (pairs() || !d_.coordinated) use({"first_engaged"});
    const std::string head = signature(
        "void " + name_ + "_step",
        {name_ + "_state *s", "const " + name_ + "_in *in", "int64_t now_us", name_ + "_out *out"});
    out_.block(head, [&](Code& to) {
      begin_tick(to);
      to.line(id_ + "_check(&v, before, back, checks);");
      choose(to);
      to.block("if (first || s->mode != before)", [&](Code& body) {
        body.line("s->takeover.before = first ? 0 : v.driver;");
        // the latest time seen: a clock that goes backwards neither dates this back nor shortens a
        // promise
        body.line("s->takeover.time_us = s->clock.last_us;");
      });
      to.line("out->previous_mode = first ? s->mode : before;");
      to.line("out->mode = s->mode;");
      if (gated())
        to.comment("a promise to stay binds; whoever moves is gated by the separation test");
      to.line("out->gate = " + up_ + "_GATE_FREE;");
      if (gated()) gate(to);
      if (pairs()) lease(to);
      if (d_.body.heading_age_us) {
        to.comment("nobody steers: a recovery can only stop");
        to.block("if (s->mode != 0 && v.heading != " + up_ + "_INPUT_NONE)",
                 [&](Code& body) { body.line("out->gate = " + up_ + "_GATE_HOLD;"); });
      }
      to.line(id_ + "_report(&v, s, checks, back, out);");
    });
    out_.blank();
  }

  // Who drives.
  void choose(Code& to) {
    const std::string dwell = num(d_.dwell_ticks) + ",";
    const std::string rest = "in->surrender ? " + num(surrender_mode(d_)) + " : 0, may_leave);";
    if (!d_.coordinated) {
      const bool keeps = !d_.keeps.empty();
      if (keeps) use({"drives_on"});
      to.line("s->mode = mode_step(s->monitors, checks, " +
              (keeps ? id_ + "_keeps, " : std::string()) + "MONITORS, before, first, elapsed, " +
              dwell);
      to.line("                    " + rest);
      return;
    }
    use({"coordinated_step", "kept_prefix", "ranking_type"});
    to.line(id_ + "_predict(&v, checks, ahead);");
    to.line("s->mode = coordinated_step(s->monitors, checks, &by, before, first, elapsed, " +
            dwell);
    to.line("                           " + rest);
    to.comment("of a recovery: how many monitors it keeps, from the first on");
    to.line("out->keeps = s->mode == 0 ? MONITORS");
    to.line("                          : kept_prefix(s->monitors, checks, &by, s->mode - 1);");
  }

  // `elapsed`: of the look-ahead, for which a gap that it does not cover has missed a tick,
  // whatever the count. `ticks`: of the past of facts, which counts as that of monitors without a
  // robot does.
  void count_ticks(Code& to) {
    const std::string call = "next_tick(&s->clock, now_us, " + num(d_.period_us) + ", ";
    std::int64_t gap_us = INT64_MAX;
    for (const Monitor& m : d_.monitors) gap_us = std::min(gap_us, m.lookahead.gap_us);
    const std::string longest = num(gap_us);
    if (!has_signals(d_)) {
      to.line("const int64_t elapsed = " + call + longest + ");");
      return;
    }
    to.line("const int32_t late = first == 0 && now_us > s->clock.last_us &&");
    to.line("                     elapsed_us(s->clock.last_us, now_us) > " + longest + ";");
    to.line("const int64_t ticks = " + call + "INT64_MAX);");
    to.comment("a gap that the look-ahead does not cover has missed a tick, whatever the count");
    to.line("const int64_t elapsed = late != 0 && ticks < 2 ? 2 : ticks;");
  }

  // What the tick knows, and whose motion it is judged with.
  void begin_tick(Code& to) {
    to.line("const int32_t first = s->clock.started == 0;");
    if (judges_commands(d_)) to.line("const int64_t sent_us = s->clock.last_us;");
    count_ticks(to);
    to.line(
        "const int32_t may_leave = now_us >= s->lease_end_us; /* no promise to stay binds it */");
    to.line("const int32_t back = first || s->mode != 0; /* control might be given back */");
    to.line("const int32_t before = s->mode; /* who has driven until now */");
    to.line("int64_t seen_us; /* when the robot was where it was seen */");
    to.line("check checks[MONITORS];");
    if (d_.coordinated) {
      to.line("margin ahead[MONITORS * MONITORS];");
      to.line("const ranking by = {" + id_ + "_keeps, ahead, MONITORS};");
    }
    to.line(view_ + " v;");
    to.line("v.in = in;");
    to.line("v.now_us = now_us;");
    to.line("v.me = in->self > 0 && in->self < ROBOTS ? in->self : 0;");
    to.line("v.new_tick = elapsed > 0;");
    if (judges_commands(d_)) {
      use({"keep_command"});
      to.comment("what followed from the last step acts since then, or will soon");
      to.block("if (!first)", [&](Code& body) {
        body.line("keep_command(s->commands, &in->sent, sent_us, &" + id_ + "_order);");
      });
      to.line("v.commands = s->commands;");
    }
    to.line(d_.held_slots > 0 ? "v.runs = s->runs;" : "v.runs = 0;");
    to.line(id_ + "_measure(&v, s, elapsed);");
    to.line("seen_us = v.self.input == " + up_ +
            "_INPUT_NONE ? in->position.stamp_us : INT64_MIN;");
    to.line("v.driver = " + driver("before"));
    // its own promise binds: it moves under nobody's control, and need not fear who passes
    if (pairs()) {
      to.block("if (before != 0 && in->holding && s->lease_end_us >= later(now_us, " +
                   num(*std::max_element(horizons_.begin(), horizons_.end())) + "))",
               [&](Code& body) { body.line("v.driver = MONITORS + 1; /* holding */"); });
    }
    if (!has_signals(d_)) return;
    if (facts_of_robot()) {
      to.line(id_ + "_look(&v, &MOTIONS[v.driver], " + id_ + "_horizons_us[0]" +
              (pairs() ? ", 1);" : ");"));
    }
    to.line(id_ + "_facts_judge(&v, s, first, ticks);");
    hold_against_received(to);
  }

  // Whoever moves is gated by the separation test, with the horizon of the monitor that looks
  // furthest; `v` holds that look already when it is the last one of the check.
  void gate(Code& to) {
    if (pairs() && separation_) use({"gate_of"});
    to.block(
        "if (s->mode != 0 && may_leave)",
        [&](Code& body) {
          // a prediction may have looked elsewhere since
          const bool seen = !d_.coordinated && separation_horizon() + 1 == horizons_.size();
          body.line("const int32_t driver = " + driver("s->mode"));
          const std::string look = id_ + "_look(&v, &MOTIONS[driver], " + id_ + "_horizons_us[" +
                                   num(std::int64_t(separation_horizon())) +
                                   (pairs() ? "], 1);" : "]);");
          if (seen) {
            body.block("if (driver != v.driver)", [&](Code& again) { again.line(look); });
          } else {
            body.line(look);
          }
          if (pairs() && separation_) {
            body.line("out->gate = gate_of(&v.within, v.others, ROBOTS, in->self, &BODY, " +
                      num(*separation_) + ");");
          }
          for (const auto& [agent, least_mm] : gaps_) {
            use({"agent_gate"});
            body.line("out->gate = agent_gate(out->gate, &v.agents[" +
                      num(static_cast<std::uint32_t>(agent)) + "], &v.within, " + num(least_mm) +
                      ");");
          }
        },
        "} else if (s->mode != 0) {");
    to.line("  out->gate = " + up_ + "_GATE_HOLD;");
    to.line("}");
  }

  // The promise is renewed while the recovery holds and has a reason to.
  void lease(Code& to) {
    to.block(
        "if (s->mode != 0 && s->mode == before && in->holding &&\n      "
        "(in->surrender || first_engaged(s->monitors, MONITORS) >= 0 ||\n       "
        "first_not_safer(checks, MONITORS) >= 0))",
        [&](Code& body) {
          body.line("s->lease_end_us = later(s->clock.last_us, " + num(d_.lease_us) + ");");
        });
  }
};

}  // namespace

void print_step(const Module& module, const Decision& decision, const Names& names,
                std::set<std::string>& uses, Code& out) {
  StepPrinter(module, decision, names, uses, out).print();
}

}  // namespace rtac::codegen
