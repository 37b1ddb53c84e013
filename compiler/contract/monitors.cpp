#include "compiler/contract/monitors.h"

#include "compiler/sema/received.h"
#include "compiler/support/rational.h"

namespace rtac::contract {
namespace {

using namespace sema;

std::string text(std::int64_t value) {
  return std::to_string(value);
}
std::string number(std::size_t value) {
  return std::to_string(value);
}

const Constant* constant(const ExprPtr& e) {
  return std::get_if<Constant>(&e->node);
}

// battery >= energy_to(...) + reserve; the reserve in SI, a ratio.
const Constant* reserve_of(const Compare& compare) {
  const auto* const battery = std::get_if<SignalRef>(&compare.left->node);
  const auto* const sum = std::get_if<Arithmetic>(&compare.right->node);
  if (battery == nullptr || battery->signal != Signal::battery || sum == nullptr) return nullptr;
  if (sum->op != ArithmeticOp::add || sum->operands.size() != 2) return nullptr;
  const bool energy = std::holds_alternative<EnergyTo>(sum->operands[0]->node);
  return energy ? constant(sum->operands[1]) : nullptr;
}

bool claim_of_comparison(const Spec& spec, const Compare& compare, MonitorClaims& claims) {
  if (compare.op != CompareOp::greater_equal) return false;
  const Constant* const least = constant(compare.right);
  if (const auto* const gap = std::get_if<Clearance>(&compare.left->node); gap && least) {
    if (received_by(spec, gap->zone)) return false;
    claims.claims.push_back(
        {Claim::Kind::zone, spec[gap->zone].name, ceil_to_int(least->value * 1000)});
    return true;
  }
  if (std::holds_alternative<Distance>(compare.left->node) && least != nullptr) {
    claims.claims.push_back({Claim::Kind::company, "", ceil_to_int(least->value * 1000)});
    return true;
  }
  const Constant* const reserve = reserve_of(compare);
  if (reserve == nullptr) return false;
  claims.claims.push_back({Claim::Kind::energy, "", ceil_to_int(reserve->value * 1'000'000)});
  return true;
}

bool claim(const Spec& spec, const Expr& e, MonitorClaims& claims) {
  if (const auto* const inside = std::get_if<InsideZone>(&e.node)) {
    if (received_by(spec, inside->zone)) return false;
    claims.claims.push_back({Claim::Kind::zone, spec[inside->zone].name, 0});
    return true;
  }
  if (const auto* const compare = std::get_if<Compare>(&e.node)) {
    return claim_of_comparison(spec, *compare, claims);
  }
  if (const auto* const others = std::get_if<ForOthers>(&e.node)) {
    return others->universal && claim(spec, *others->body, claims);
  }
  return false;
}

void zones_in(const Spec& spec, const Expr& e, std::set<std::string>& zones, std::size_t& runs) {
  if (const auto* const gap = std::get_if<Clearance>(&e.node)) {
    zones.insert(spec[gap->zone].name);
  } else if (const auto* const inside = std::get_if<InsideZone>(&e.node)) {
    zones.insert(spec[inside->zone].name);
  } else if (const auto* const compare = std::get_if<Compare>(&e.node)) {
    zones_in(spec, *compare->left, zones, runs);
    zones_in(spec, *compare->right, zones, runs);
  } else if (const auto* const held = std::get_if<HeldFor>(&e.node)) {
    ++runs;
    zones_in(spec, *held->operand, zones, runs);
  }
}

}  // namespace

MonitorClaims claims_of(const Spec& spec, const Monitor& monitor) {
  MonitorClaims claims;
  claims.name = monitor.name;
  claims.has_return = monitor.return_when != nullptr;
  if (!claim(spec, *monitor.always, claims)) {
    claims.gap = "what `" + monitor.name + "` says has a form that no contract states yet";
  } else if (monitor.ahead.command || monitor.ahead.waypoints_only || monitor.ahead.points_only) {
    claims.gap = "the look-ahead of `" + monitor.name + "` has a form that no contract states yet";
  }
  return claims;
}

DecisionFacts facts_of(const Spec& spec, const Decision& decision, const std::string& prefix) {
  DecisionFacts f;
  f.spec = &spec;
  f.decision = &decision;
  f.kind = &spec[decision.kind];
  f.prefix = prefix;
  f.name = decision.name;
  for (const MonitorId id : decision.priority) {
    const Monitor& monitor = spec[id];
    f.monitors.push_back(claims_of(spec, monitor));
    zones_in(spec, *monitor.always, f.zones, f.runs);
    if (monitor.return_when) zones_in(spec, *monitor.return_when, f.zones, f.runs);
    for (const Claim& c : f.monitors.back().claims) {
      f.has_company |= c.kind == Claim::Kind::company;
      f.has_energy |= c.kind == Claim::Kind::energy;
    }
  }
  f.has_heading = f.kind->heading.has_value();
  for (const Robot& robot : spec.robots) f.robots += robot.kind == decision.kind ? 1 : 0;
  f.radius_mm = ceil_to_int(f.kind->radius.value * 1000);
  f.speed_mmps = ceil_to_int(f.kind->motion.speed.value * 1000);
  f.latency_us = ceil_to_int(f.kind->latency.value * 1'000'000);
  if (decision.period) f.period_us = ceil_to_int(decision.period->value * 1'000'000);
  if (f.kind->plan) f.tracking_mm = ceil_to_int(f.kind->plan->tracking.value * 1000);
  return f;
}

namespace {

// The property now, of the robot as it was sensed.
std::string now_text(const DecisionFacts& f, const Claim& c, const std::string& motion) {
  switch (c.kind) {
    case Claim::Kind::zone:
      return "clear_now(v->at_" + c.zone + ", v->self, " + motion + ", " + text(f.radius_mm) +
             ", " + text(f.speed_mmps) + ", " + text(c.least) + ")";
    case Claim::Kind::company:
      return "(\\forall integer j; 0 <= j < " + number(f.robots) + " && j != v->in->self ==>\n" +
             "    apart_now(v->self, v->others[j], " + f.name + "_body, " + motion + ", " + f.name +
             "_motions[0], " + text(c.least) + "))";
    case Claim::Kind::energy:
      return "v->charge.input == INPUT_NONE && v->self.p_input == INPUT_NONE";
  }
  return "";
}

// Everything within reach. Legs: bodies and room for tracking, 1 mm for rounded way-points.
std::string ahead_text(const DecisionFacts& f, const Claim& c, int waypoints, const Within& w) {
  switch (c.kind) {
    case Claim::Kind::zone: {
      const std::string zone = "&zone_" + c.zone;
      std::string out = "stays_within(" + zone + ", v->self, " + f.name + "_body, " + w.motion +
                        ", " + w.horizon_us + ", " + text(c.least) + ")";
      if (waypoints > 0) {
        out += " &&\n    (" + w.legs + " ==> legs_keep(" + zone + ", v->self, &v->in->plan, " +
               text(waypoints) + ", " + text(c.least + f.radius_mm + f.tracking_mm + 1) + "))";
      }
      return out;
    }
    case Claim::Kind::company:
      return "(\\forall integer j; 0 <= j < " + number(f.robots) + " && j != v->in->self ==>\n" +
             "    sets_apart(v->within, v->others[j], " + f.name + "_body, " + text(c.least) + "))";
    case Claim::Kind::energy:
      return "charged_now(v->charge, &cells_to_dock[v->me], v->self.p, v->within.centre_mm, " +
             text(c.least) + ")";
  }
  return "";
}

}  // namespace

std::string claimed_now(const DecisionFacts& f, std::size_t i, const std::string& motion) {
  std::string out;
  for (const Claim& c : f.monitors[i].claims) {
    out += (out.empty() ? "" : " &&\n  ") + now_text(f, c, motion);
  }
  return out.empty() ? "\\true" : out;
}

std::string claimed_ahead(const DecisionFacts& f, std::size_t i, const Within& within) {
  const int waypoints = (*f.spec)[f.decision->priority[i]].ahead.waypoints;
  std::string out = "v->self.input == INPUT_NONE";
  for (const Claim& c : f.monitors[i].claims) {
    if (c.kind != Claim::Kind::zone && !within.sets) continue;
    out += " &&\n  " + ahead_text(f, c, waypoints, within);
  }
  return out;
}

namespace {

// What is found of one of several robots, and of all of them one after the other.
std::string contracts_among(const std::string& name, const Claim& claim, const std::string& given) {
  const std::string least = text(claim.least);
  const std::string apart[] = {
      "apart_now(v->self, v->others[@], $D_body, *v->m, $D_motions[0], " + least + ")",
      "sets_apart(v->within, v->others[@], $D_body, " + least + ")"};
  std::string out;
  for (const bool ahead : {false, true}) {
    const std::string which = name + (ahead ? "_ahead" : "_now");
    const auto of = [&](const std::string& index) {
      std::string claimed = apart[ahead ? 1 : 0];
      return claimed.replace(claimed.find('@'), 1, index);
    };
    out += which + "_v0\n" + given + "requires 0 <= j < $R && j != v->in->self;\n" +
           "requires other_ok(v->others[j], $D_body, $D_motions[0], v->horizon_us);\n" +
           "assigns \\nothing;\nensures margin_ok(\\result);\nensures \\result.lo >= 0 ==> " +
           of("j") + (ahead ? " && v->self.input == INPUT_NONE" : "") + ";\n";
    out +=
        which + "\n-- loop 1\nloop invariant 0 <= j <= $R && margin_ok(v0);\n" +
        "loop invariant v0.lo >= 0 ==> \\forall integer i; 0 <= i < j && i != v->in->self ==>\n  " +
        of("i") + ";\n";
    if (ahead) {
      out +=
          "loop invariant v0.lo >= 0 && (j > 1 || (j == 1 && v->in->self != 0)) ==>\n"
          "  v->self.input == INPUT_NONE;\n";
    }
    out += "loop assigns j, v0;\nloop variant $R - j;\n";
  }
  return out;
}

// No prover sees the shape of a table of cells, which is declared alone.
bool looks_into_cells(const MonitorClaims& monitor) {
  for (const Claim& c : monitor.claims) {
    if (c.kind == Claim::Kind::energy) return true;
  }
  return false;
}

const Claim* among_robots(const MonitorClaims& monitor) {
  for (const Claim& c : monitor.claims) {
    if (c.kind == Claim::Kind::company) return &c;
  }
  return nullptr;
}

}  // namespace

std::string monitor_contracts(const DecisionFacts& f, const std::string& given) {
  static const Within seen{"*v->m", "v->horizon_us", "v->legs != 0"};
  std::string out;
  for (std::size_t i = 0; i < f.monitors.size(); ++i) {
    const std::string name = "== " + f.name + "_" + f.monitors[i].name;
    if (const Claim* const c = among_robots(f.monitors[i])) {
      out += contracts_among(name, *c, given);
    }
    const std::string is_ok = "ensures margin_ok(\\result);\n";
    const std::string held = looks_into_cells(f.monitors[i]) ? "!! tables\n" : "";
    out += name + "_now\n" + held + given + "assigns \\nothing;\n" + is_ok +
           "ensures \\result.lo >= 0 ==> " + claimed_now(f, i, "*v->m") + ";\n";
    out += name + "_ahead\n" + held + given + "assigns \\nothing;\n" + is_ok +
           "ensures \\result.lo >= 0 ==> " + claimed_ahead(f, i, seen) + ";\n";
    if (f.monitors[i].has_return) {
      const std::string runs = "v->runs[0 .. " + number(2 * f.runs) + " - 1]";
      out += name + "_return\n" + given + "assigns " + (f.runs > 0 ? runs : "\\nothing") + ";\n" +
             is_ok;
    }
  }
  return out;
}

}  // namespace rtac::contract
