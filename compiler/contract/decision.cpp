// Contracts of what is printed for a decision: its start, what it measures, checks, reports, and a
// step as a whole.
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "compiler/contract/clauses.h"
#include "compiler/contract/contract.h"
#include "compiler/contract/monitors.h"
#include "compiler/support/rational.h"

namespace rtac::contract {
namespace {

using namespace sema;

// Text with $D for the name of the decision, $P for the prefix, $N for the number of monitors, $L
// for the last of them, $R and $Q for the robots likewise.
std::string filled(const DecisionFacts& f, const std::string& pattern) {
  std::string out;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern[i] != '$') {
      out += pattern[i];
      continue;
    }
    switch (pattern[++i]) {
      case 'D':
        out += f.name;
        break;
      case 'P':
        out += f.prefix;
        break;
      case 'N':
        out += std::to_string(f.monitors.size());
        break;
      case 'L':
        out += std::to_string(f.monitors.size() - 1);
        break;
      case 'R':
        out += std::to_string(f.robots);
        break;
      case 'Q':
        out += std::to_string(f.robots - 1);
        break;
      default:
        out += '$';
        break;
    }
  }
  return out;
}

// That the record has what was found, of monitor `k`.
std::string recorded(std::size_t k) {
  const std::string at = "[" + number(k) + "]";
  return "out->monitors" + at + ".now == verdict(checks" + at + ".now) &&\n  out->monitors" + at +
         ".ahead == verdict(checks" + at + ".ahead) && out->monitors" + at +
         ".engaged == s->monitors" + at + ".engaged";
}

// Turning is an acceleration, too: its square is of both.
Rational square_of_acceleration(const Motion& motion) {
  Rational square = motion.accel.value * motion.accel.value;
  if (motion.model == MotionModel::unicycle && motion.turn) {
    const Rational across = motion.speed.value * motion.turn->value;
    square += across * across;
  }
  return square;
}

std::string declared(const DecisionFacts& f) {
  const RobotKind& kind = *f.kind;
  const auto mm = [](const Quantity& q) { return number(ceil_to_int(q.value * 1000)); };
  const auto us = [](const Quantity& q) { return number(floor_to_int(q.value * 1'000'000)); };
  std::string out;
  out += "ensures declared_radius: $D_body.radius_mm >= " + mm(kind.radius) + ";\n";
  out += "ensures declared_speed: $D_body.speed_mmps >= " + mm(kind.motion.speed) +
         " && $D_motions[0].speed_mmps >= " + mm(kind.motion.speed) + ";\n";
  out += "ensures declared_brake: $D_body.brake_mmps2 <= " +
         number(floor_to_int(kind.motion.brake.value * 1000)) + ";\n";
  const std::string square = number(ceil_to_int(square_of_acceleration(kind.motion) * 1'000'000));
  for (const char* where : {"$D_body", "$D_motions[0]"}) {
    out += "ensures declared_acceleration: " + std::string(where) + ".accel_mmps2 * " + where +
           ".accel_mmps2 >= " + square + ";\n";
  }
  if (kind.position) {
    out += "ensures declared_position: $D_body.position_error_mm >= " + mm(kind.position->error) +
           " && $D_body.position_age_us <= " + us(kind.position->max_age) + ";\n";
  }
  if (kind.velocity) {
    out += "ensures declared_velocity: $D_body.velocity_error_mmps >= " + mm(kind.velocity->error) +
           " && $D_body.velocity_age_us <= " + us(kind.velocity->max_age) + ";\n";
  }
  return out;
}

std::string start_contract(const DecisionFacts& f) {
  std::string out = "== $P_$D_init\nrequires \\valid(s);\nassigns *s;\n" +
                    joined("ensures", state(f)) + declared(f);
  out += "-- loop 1\nloop invariant 0 <= k <= $N;\n";
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    const std::string at = "s->monitors[" + number(k) + "]";
    out += "loop invariant k > " + number(k) + " ==> " + at + ".engaged == 0 && " + at +
           ".dwell == 0;\n";
  }
  out += "loop assigns k, s->monitors[0 .. $L];\nloop variant $N - k;\n";
  out +=
      "-- loop 2\nloop invariant 0 <= k <= $R;\nloop assigns k, s->last_other_us[0 .. $Q], "
      "s->last_other_velocity_us[0 .. $Q],\n  s->last_other_lease_us[0 .. $Q];\n"
      "loop variant $R - k;\n";
  if (f.runs > 0) {
    const std::string runs = number(2 * f.runs);
    out += "-- loop 3\nloop invariant 0 <= k <= " + runs + ";\nloop assigns k, s->runs[0 .. " +
           runs + " - 1];\nloop variant " + runs + " - k;\n";
  }
  return out;
}

// Robot by robot, which are so few that each is named.
std::string look_loop(const DecisionFacts& f) {
  if (!f.has_company) return "";
  std::string out = "-- loop 1\nloop invariant 0 <= j <= $R;\n";
  for (std::size_t i = 0; i < f.robots; ++i) {
    const std::string k = number(i), other = "v->others[" + k + "]";
    out += "loop invariant estimate_ok(" + other + ".s);\nloop invariant j > " + k +
           " && v->in->self != " + k + " ==> other_ok(" + other +
           ", $D_body, $D_motions[0], v->horizon_us);\n";
  }
  return out + "loop assigns j, v->others[0 .. $Q];\nloop variant $R - j;\n";
}

std::string look_contract(const DecisionFacts& f) {
  return "== $D_look\nrequires \\valid(v) && \\valid_read(v->in) && \\valid_read(m) && "
         "\\separated(v, m) && \\separated(v, v->in);\n"
         "requires motion_ok(*m) && 0 <= horizon_us <= 100000000;\n" +
         joined("requires", measured(f)) +
         "assigns v->m \\from m;\nassigns v->horizon_us, v->within" +
         (f.has_company ? ", v->others[0 .. $Q]" : "") +
         ";\nensures v->m == m && v->horizon_us == horizon_us;\n" + joined("ensures", looked(f)) +
         look_loop(f);
}

// Of the others, and of what has to hold for a time, when ticks were missed.
std::string measure_loops(const DecisionFacts& f) {
  std::string out;
  if (f.has_company) {
    out += "-- loop 1\nloop invariant 0 <= j <= $R;\n";
    for (std::size_t i = 0; i < f.robots; ++i) {
      const std::string k = number(i);
      out += "loop invariant j > " + k + " ==> estimate_ok(v->others[" + k + "].s);\n";
    }
    out +=
        "loop assigns j, v->others[0 .. $Q], s->last_other_us[0 .. $Q],\n  "
        "s->last_other_velocity_us[0 .. $Q], s->last_other_lease_us[0 .. $Q];\n"
        "loop variant $R - j;\n";
  }
  if (f.runs == 0) return out;
  const std::string runs = number(f.runs);
  return out + "-- loop " + (f.has_company ? "2" : "1") + "\nloop invariant 0 <= k <= " + runs +
         ";\nloop assigns k, s->runs[0 .. " + number(2 * f.runs) + " - 1];\nloop variant " + runs +
         " - k;\n";
}

std::string measure_contract(const DecisionFacts& f) {
  const auto us = [](const Quantity& q) { return number(floor_to_int(q.value * 1'000'000)); };
  std::string out =
      "== $D_measure\n"
      "requires \\valid(v) && \\valid(s) && \\valid_read(v->in) && "
      "\\separated(v, s, v->in) && elapsed > INT64_MIN;\n" +
      joined("requires", state(f)) +
      "assigns v->self, v->charge, s->last_position_us, s->last_velocity_us";
  for (const std::string& zone : f.zones) out += ", v->at_" + zone;
  if (f.has_heading) out += ",\n  v->heading, s->last_heading_us";
  if (f.has_energy) out += ",\n  s->last_battery_us";
  if (f.has_company) {
    out +=
        ",\n  v->others[0 .. $Q], s->last_other_us[0 .. $Q], s->last_other_velocity_us[0 .. $Q], "
        "s->last_other_lease_us[0 .. $Q]";
  }
  if (f.runs > 0) out += ",\n  s->runs[0 .. " + number(2 * f.runs) + " - 1]";
  out += ";\n" + joined("ensures", measured(f)) + joined("ensures", state(f));
  out +=
      "ensures elapsed < 0 ==> v->self.input != INPUT_NONE && v->self.p_input != INPUT_NONE;\n"
      "ensures v->in->self < 0 || v->in->self >= $R ==> v->self.input != INPUT_NONE && "
      "v->self.p_input != INPUT_NONE;\n";
  if (!f.kind->position || !f.kind->velocity) return out + measure_loops(f);
  out += "ensures ages: v->self.input == INPUT_NONE ==> fresh(v->in->position, v->now_us, " +
         us(f.kind->position->max_age) + ") &&\n  fresh(v->in->velocity, v->now_us, " +
         us(f.kind->velocity->max_age) + ");\n";
  out +=
      "ensures sensed: v->self.input == INPUT_NONE && v->self.off_map_mm == 0 ==>\n"
      "  v->self.age_us == v->now_us - v->in->position.stamp_us &&\n"
      "  v->self.p.x == v->in->position.x_lo && v->self.p.y == v->in->position.y_lo &&\n"
      "  v->self.p_error_mm >= " +
      number(ceil_to_int(f.kind->position->error.value * 1000)) +
      " + (v->in->position.x_hi - v->in->position.x_lo) +\n"
      "    (v->in->position.y_hi - v->in->position.y_lo);\n";
  return out + measure_loops(f);
}

std::string report_contract(const DecisionFacts& f) {
  // Each check by itself, too: provers lose their time over parts of an array.
  Clauses each;
  std::string which;
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    each.push_back("\\valid_read(checks + " + number(k) + ")");
    which += (k == 0 ? "k == " : " || k == ") + number(k);
  }
  std::string out =
      "== $D_report\n"
      "requires \\valid_read(v) && \\valid_read(v->in) && \\valid_read(s) && "
      "\\valid_read(checks + (0 .. $L)) && \\valid(out);\n"
      "requires \\separated(out, v) && \\separated(out, v->in) && \\separated(out, s) && "
      "\\separated(out, checks + (0 .. $L));\n" +
      joined("requires", each) + joined("requires", state(f)) + joined("requires", checks(f)) +
      "assigns out->tick, out->time_us, out->lease_end_us, out->position_age_us, "
      "out->velocity_age_us, out->battery_age_us,\n  " +
      (f.has_heading ? "out->heading_age_us, " : "") +
      "out->violation_us, out->monitors[0 .. $L], out->monitor, out->found;\n"
      "ensures out->monitor == s->mode - 1;\n";
  for (std::size_t k = 0; k < f.monitors.size(); ++k) out += "ensures " + recorded(k) + ";\n";
  out +=
      "-- loop 1\nloop invariant 0 <= k <= $N;\nloop invariant s->mode == \\at(s->mode, Pre);\n" +
      joined("loop invariant", checks(f)) + joined("loop invariant", state(f));
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    out += "loop invariant k > " + number(k) + " ==> " + recorded(k) + ";\n";
  }
  return out +
         "loop assigns k, out->monitors[0 .. $L];\nloop variant $N - k;\n"
         "-- before out->monitors[k].now\nassert " +
         which + ";\nassert \\valid_read(checks + k);\n";
}

// Lines of a contract that are there where a table says what drives on.
std::string only_driven_on(std::string text) {
  constexpr const char* mark = "/*? drives_on */ ";
  for (std::size_t at = 0; at != std::string::npos; at = text.find('\n', at)) {
    at += at == 0 ? 0 : 1;
    text.insert(at, mark);
  }
  return text + "\n";
}
// Names for what a contract says of a monitor and of who drives, at one place of the step.
struct Places {
  std::string engaged, now, mode, before;
};
// While a monitor is engaged, a recovery drives; that of one that ranks lower only if it has driven
// before and the table says that it is shown to keep it, and it is not false. Row by row, since
// provers find no index of a table in what they know of all of it.
Clauses driven_while_engaged(const DecisionFacts& f, std::size_t k, const Places& at) {
  Clauses out{at.engaged + " != 0 ==> 1 <= " + at.mode};
  for (std::size_t row = k + 1; row < f.monitors.size(); ++row) {
    out.push_back(at.engaged + " != 0 && " + at.mode + " == " + number(row + 1) + " ==>\n  " +
                  at.before + " == " + number(row + 1) + " && $D_keeps[" +
                  number(row * f.monitors.size() + k) + "] == 1 && " + at.now +
                  " != VERDICT_FALSE");
  }
  return out;
}

std::string step_contract(const DecisionFacts& f) {
  const std::string last_pair = number(f.monitors.size() * f.monitors.size() - 1);
  std::string out = "== $P_$D_step\n" + granted(f) +
                    "requires \\valid(s) && \\valid_read(in) && \\valid(out) && "
                    "\\separated(s, in, out);\n" +
                    "/*? drives_on */ requires \\separated(s, $D_keeps + (0 .. " + last_pair +
                    ")) && \\separated(out, $D_keeps + (0 .. " + last_pair + "));\n" +
                    joined("requires", state(f)) + "assigns *s, *out;\n" +
                    joined("ensures", state(f)) +
                    "ensures out->mode == s->mode && out->monitor == out->mode - 1;\n"
                    "ensures surrendered: in->surrender != 0 ==> out->mode != 0;\n";
  Clauses found, rules;
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    const std::string at = "out->monitors[" + number(k) + "]", far = number(horizon_of(f, k));
    const std::string driver = "$D_motions[v.driver]", longer = far + " + " + number(f.period_us);
    out += "/*? !drives_on */ ensures priority: " + at +
           ".engaged != 0 ==> 1 <= out->mode <= " + number(k + 1) + ";\n";
    // what the arbitration proves of pairs stands in the table
    for (const std::string& each : driven_while_engaged(
             f, k, {at + ".engaged", at + ".now", "out->mode", "out->previous_mode"})) {
      out += only_driven_on("ensures priority: " + each + ";");
    }
    // The first step asks the longer look-ahead alone, which leaves no room for a violation.
    out += "ensures advanced: out->mode == 0 ==> " + at +
           ".engaged == 0 &&\n  (\\old(s->clock.started) != 0 ==> " + at +
           ".now != VERDICT_FALSE);\n";
    found.push_back("s->mode == 0 ==> " + looked_well(k));
    rules.push_back("rule_5_" + f.monitors[k].name + ": s->mode == 0 ==>\n  (" +
                    claimed_ahead(f, k, {driver, far, "\\true"}) + ") ||\n  (" +
                    claimed_ahead(f, k, {"$D_motions[0]", longer, "\\true", false}) + ")");
  }
  std::string ranked;
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    const std::string check = "checks[" + number(k) + "]", now = "verdict(" + check + ".now)";
    ranked += only_driven_on("assert now_of(&" + check + ") == " + now + ";");
    for (const std::string& each : driven_while_engaged(
             f, k, {"s->monitors[" + number(k) + "].engaged", now, "s->mode", "before"})) {
      ranked += only_driven_on("assert " + each + ";");
    }
  }
  // What is claimed of a plan is led past each write by saying that it is the same one.
  const Clauses kept = plan_kept(f, "in->plan");
  const std::string same = kept.empty() ? "" : joined("assert", {kept.back()});
  std::string claims = "-- before s->mode = mode_step(\n" + joined("assert", kept) +
                       "-- before if (first ||\n" + same + ranked + joined("assert", found) +
                       "-- before out->previous_mode\n" + same + joined("assert", found) +
                       joined("assert", rules);
  // There `v` is the structure itself.
  for (std::size_t at = claims.find("v->"); at != std::string::npos; at = claims.find("v->", at)) {
    claims.replace(at, 3, "v.");
  }
  return out + claims;
}

// Table of the zone that a plan has to lie in; empty: the monitor says something else, or that of a
// zone whose table is not named by its line.
std::string zone_of_plan(const Spec& spec, const SourceManager& sources, const Monitor& monitor) {
  const auto* const inside = std::get_if<PlanInside>(&monitor.always->node);
  if (inside == nullptr) return "";
  const Zone& zone = spec[inside->zone];
  if (!zone.name.empty()) return zone.name;
  if (std::holds_alternative<ZoneComplement>(zone.value->node)) return "";
  const SourceRange& range = zone.value->range;
  return "zone_of_line_" + number(std::size_t{sources.position(range.file, range.begin).line});
}

// Of a decision on plans: what each monitor finds, and who decides. 1 mm is for rounded way-points.
std::string plan_contracts(const DecisionFacts& f, const SourceManager& sources) {
  std::string out, ensured, carried;
  for (std::size_t i = 0; i < f.monitors.size(); ++i) {
    const std::string& name = f.monitors[i].name;
    const std::string zone = zone_of_plan(*f.spec, sources, (*f.spec)[f.decision->priority[i]]);
    out += "== $D_" + name + "_now\n" + (zone.empty() ? "!! plans\n" : "") +
           "requires \\valid_read(v);\nassigns \\nothing;\nensures margin_ok(\\result);\n";
    if (zone.empty()) continue;
    out += "ensures \\result.lo >= 0 ==> plan_keeps(&zone_" + zone + ", v, 1);\n";
    ensured +=
        "ensures " + name + ": out->mode == 0 ==> plan_keeps(&zone_" + zone + ", plan, 1);\n";
    carried += "loop invariant out->mode == 0 && k < " + number(i) + " ==> found[" + number(i) +
               "].lo >= 0;\n";
  }
  return out +
         "== $P_$D_judge\nrequires \\valid_read(plan) && \\valid(out) && \\separated(plan, out);\n"
         "assigns *out;\nensures 0 <= out->mode <= $N && out->monitor == out->mode - 1;\n"
         "ensures advanced: out->mode == 0 ==> \\forall integer j; 0 <= j < $N ==>\n"
         "  out->monitors[j].engaged == 0 && out->monitors[j].now == VERDICT_TRUE;\n" +
         ensured +
         "-- loop 1\nloop invariant -1 <= k <= $L;\n"
         "loop invariant 0 <= out->mode <= $N && out->monitor == out->mode - 1;\n"
         "loop invariant out->mode == 0 ==> \\forall integer j; k < j < $N ==>\n"
         "  out->monitors[j].engaged == 0 && out->monitors[j].now == VERDICT_TRUE;\n" +
         carried + "loop assigns k, *out;\nloop variant k + 1;\n";
}

}  // namespace

Contracts contracts_of(const Spec& spec, const SourceManager& sources, const std::string& prefix) {
  Contracts contracts;
  std::set<std::size_t> counts;
  for (const Decision& decision : spec.decisions) {
    const DecisionFacts f = facts_of(spec, decision, prefix);
    if (decision.on_plan) {
      contracts.text += filled(f, plan_contracts(f, sources));
      continue;
    }
    for (const MonitorClaims& m : f.monitors) {
      if (!m.gap.empty()) contracts.gaps.push_back(m.gap);
    }
    if (spec[decision.kind].in_space) {
      contracts.gaps.push_back("decision `" + decision.name + "` is for robots in space");
    }
    const std::string given = joined("requires", pointers(f)) + joined("requires", looked(f));
    contracts.text += filled(f, monitor_contracts(f, given) + look_contract(f) + start_contract(f) +
                                    measure_contract(f) + check_contract(f) + report_contract(f) +
                                    step_contract(f));
    counts.insert(f.monitors.size());
  }
  // Each monitor is named, which takes one number of them.
  contracts.text += counts.size() == 1
                        ? switching_contract(*counts.begin())
                        : std::string(counts.empty() ? "" : "== mode_step\n!! several\n");
  return contracts;
}

}  // namespace rtac::contract
