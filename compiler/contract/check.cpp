// The contract of what checks every monitor, with the assertions by which it is proved.
#include "compiler/contract/clauses.h"

namespace rtac::contract {
namespace {

// What `check` writes does not change what is claimed of a view, unless sets in it are: then every
// claim is one of the view before, which no write has to be led past.
std::string of_before(const DecisionFacts& f, const std::string& claim) {
  return f.has_company ? claim : "\\at(" + claim + ", Pre)";
}

std::string now_clause(const DecisionFacts& f, std::size_t i) {
  return "checks[" + number(i) + "].now.lo >= 0 ==>\n  " +
         of_before(f, claimed_now(f, i, "$D_motions[v->driver]"));
}
std::string ahead_clause(const DecisionFacts& f, std::size_t i) {
  const Within within{"$D_motions[v->driver]", number(horizon_of(f, i)), "mode == 0"};
  return "checks[" + number(i) + "].ahead.lo >= 0 ==>\n  " +
         of_before(f, claimed_ahead(f, i, within));
}
std::string safer_clause(const DecisionFacts& f, std::size_t i) {
  const std::string longer = number(horizon_of(f, i)) + " + " + number(f.period_us);
  return "checks[" + number(i) + "].safer.lo >= 0 ==> back != 0 &&\n  " +
         of_before(f, claimed_ahead(f, i, {"$D_motions[0]", longer, "\\true", false}));
}

// What holds before every line of `check` that writes: tables and the plan are as they were.
Clauses untouched(const DecisionFacts& f) {
  Clauses all;
  for (std::size_t k = 0; k <= f.monitors.size(); ++k) {
    const std::string at = "$D_motions[" + number(k) + "]";
    all.push_back("motion_ok(" + at + ")");
    all.push_back(at + " == \\at(" + at + ", Pre)");
  }
  const Clauses plan = plan_kept(f, "v->in->plan");
  all.insert(all.end(), plan.begin(), plan.end());
  return all;
}

// Provers lead a fact past one write at a time, so each is said again after it. Only for one
// monitor: what is written for several takes more than they have time for.
std::string check_steps(const DecisionFacts& f) {
  if (f.has_company || f.monitors.size() != 1) return "";
  const std::string start = joined("assert", untouched(f));
  const auto found = [](const char* what) {
    return std::string("assert margin_ok(checks[0].") + what + ");\n";
  };
  const std::string reached =
      "assert motion_ok(*v->m);\n"
      "assert reach_is(v->within, v->self, $D_body, *v->m, v->horizon_us);\n";
  const std::string far = number(horizon_of(f, 0)), driver = "$D_motions[v->driver]";
  std::string held = found("safer"), claims = "assert " + safer_clause(f, 0) + ";\n";
  std::string out = "-- before if (back)\n" + start;
  out += "-- before v->legs = mode\n" + start + held + claims;
  out += "-- before checks[0].now =\n" + start + reached + held + claims;
  held += found("now");
  claims += "assert " + now_clause(f, 0) + ";\n";
  out += "-- before checks[0].ahead =\n" + start + reached + held + claims;
  held += found("ahead");
  // The claim of the monitor's function, in its words and then in those of the view before.
  out += "-- before checks[0].gives_back =\n" + start + reached + held +
         "assert v->horizon_us == " + far + " && *v->m == \\at($D_motions[v->driver], Pre);\n" +
         "assert checks[0].ahead.lo >= 0 ==> " +
         claimed_ahead(f, 0, {"*v->m", "v->horizon_us", "\\false"}) + ";\n" +
         "assert checks[0].ahead.lo >= 0 ==>\n  \\at(" +
         claimed_ahead(f, 0, {driver, far, "\\false"}) + ", Pre);\n" +
         "assert legs: checks[0].ahead.lo >= 0 && v->legs != 0 ==>\n  \\at(" +
         claimed_ahead(f, 0, {driver, far, "\\true"}) + ", Pre);\n";
  claims += "assert " + ahead_clause(f, 0) + ";\n";
  out += claims;
  return out + "-- at end\n" + start + reached + held + claims;
}

}  // namespace

std::string check_contract(const DecisionFacts& f) {
  // One more motion than monitors and advanced control with company: of a robot that holds.
  const std::string last = f.has_company ? "$N + 1" : "$N";
  std::string out = "== $D_check\n" + granted(f) +
                    "requires \\valid(v) && \\valid_read(v->in) && \\valid(checks + (0 .. $L)) && "
                    "\\separated(v, checks + (0 .. $L));\n"
                    "requires \\separated(checks + (0 .. $L), &$D_motions[0 .. " +
                    last +
                    "], &$D_body);\n"
                    "requires \\separated(v, v->in) && \\separated(checks + (0 .. $L), v->in);\n"
                    "requires 0 <= v->driver <= " +
                    last + " && 0 <= v->me < $R;\n" + joined("requires", measured(f)) +
                    "assigns v->legs, v->m, v->horizon_us, v->within, checks[0 .. $L]" +
                    (f.has_company ? ", v->others[0 .. $Q]" : "") +
                    (f.runs > 0 ? ", v->runs[0 .. " + number(2 * f.runs) + " - 1]" : "") + ";\n" +
                    joined("ensures", looked(f)) + joined("ensures", checks(f));
  for (std::size_t i = 0; i < f.monitors.size(); ++i) {
    const std::string& name = f.monitors[i].name;
    out += "ensures " + name + "_now: " + now_clause(f, i) + ";\n";
    out += "ensures " + name + "_ahead: " + ahead_clause(f, i) + ";\n";
    out += "ensures " + name + "_safer: " + safer_clause(f, i) + ";\n";
  }
  return out + check_steps(f);
}

}  // namespace rtac::contract
