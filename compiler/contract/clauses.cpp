#include "compiler/contract/clauses.h"

#include "compiler/support/rational.h"

namespace rtac::contract {

using namespace sema;

std::string number(std::int64_t value) {
  return std::to_string(value);
}
std::string number(std::size_t value) {
  return std::to_string(value);
}

std::string granted(const DecisionFacts& f) {
  return f.has_company ? "!! fleet\n" : "";
}

std::string joined(const std::string& word, const Clauses& clauses) {
  std::string out;
  for (const std::string& clause : clauses) out += word + " " + clause + ";\n";
  return out;
}

// Clauses are about single members, so that provers need not look into predicates of pointers.
Clauses pointers(const DecisionFacts& f) {
  Clauses all = {"\\valid_read(v) && \\valid_read(v->in) && \\valid_read(v->m)", "0 <= v->me < $R"};
  if (f.runs > 0) {
    const std::string runs = "v->runs + (0 .. " + number(2 * f.runs) + " - 1)";
    all.push_back("\\valid(" + runs + ") && \\separated(v, " + runs + ")");
  }
  return all;
}

Clauses measured(const DecisionFacts& f) {
  Clauses all = {"estimate_ok(v->self)"};
  for (const std::string& zone : f.zones) {
    all.push_back("seen_at(&zone_" + zone + ", v->at_" + zone + ", v->self)");
  }
  if (f.has_energy) all.push_back("span_ok(v->charge)");
  for (std::size_t j = 0; f.has_company && j < f.robots; ++j) {
    all.push_back("estimate_ok(v->others[" + number(j) + "].s)");
  }
  return all;
}

Clauses looked(const DecisionFacts& f) {
  Clauses all = measured(f);
  all.insert(all.end(),
             {"motion_ok(*v->m)", "0 <= v->horizon_us <= 100000000", "reach_ok(v->within)",
              "reach_is(v->within, v->self, $D_body, *v->m, v->horizon_us)"});
  for (std::size_t j = 0; f.has_company && j < f.robots; ++j) {
    all.push_back("v->in->self != " + number(j) + " ==> other_ok(v->others[" + number(j) +
                  "], $D_body, $D_motions[0], v->horizon_us)");
  }
  return all;
}

Clauses state(const DecisionFacts& f) {
  Clauses all = {"clock_ok(s->clock)", "0 <= s->mode <= $N",
                 std::string("0 <= s->takeover.before <= ") + (f.has_company ? "$N + 1" : "$N")};
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    const std::string at = "s->monitors[" + number(k) + "]";
    all.push_back("monitor_ok(" + at + ".engaged, " + at + ".dwell, 1)");
  }
  return all;
}

Clauses checks(const DecisionFacts& f) {
  Clauses all;
  for (std::size_t k = 0; k < f.monitors.size(); ++k) {
    all.push_back("check_ok(checks[" + number(k) + "])");
  }
  return all;
}

Clauses plan_kept(const DecisionFacts& f, const std::string& plan) {
  if (!f.kind->plan) return {};
  Clauses all;
  for (const char* member : {".valid", ".count", ".index"}) {
    all.push_back(plan + member + " == \\at(" + plan + member + ", Pre)");
  }
  for (const char* member : {".x[j]", ".y[j]"}) {
    all.push_back("\\forall integer j; 0 <= j < PLAN_CAPACITY ==> " + plan + member + " == \\at(" +
                  plan + member + ", Pre)");
  }
  all.push_back("same_plan{Pre, Here}(&" + plan + ")");
  return all;
}

std::int64_t horizon_of(const DecisionFacts& f, std::size_t i) {
  const Ahead& ahead = (*f.spec)[f.decision->priority[i]].ahead;
  const std::int64_t us =
      ahead.duration ? ceil_to_int(ahead.duration->value * 1'000'000) : f.period_us;
  return us + f.latency_us;
}

}  // namespace rtac::contract
