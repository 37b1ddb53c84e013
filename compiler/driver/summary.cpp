#include "compiler/driver/summary.h"

#include "compiler/analysis/derive.h"
#include "compiler/codegen/watch.h"
#include "compiler/driver/explain_text.h"
#include "compiler/support/rational.h"
#include "compiler/support/words.h"

namespace rtac::driver {
namespace {

std::string bytes(std::int64_t n) {
  return std::to_string(n) + (n == 1 ? " byte" : " bytes");
}

std::string received(const ir::Channel& c) {
  return "  zone " + c.name + " is received: at most " + std::to_string(c.edges_most) + " edges, " +
         bytes(codegen::received_bytes(c)) + " of tables while it is checked\n";
}

std::string holds(const ir::Channel& c) {
  return "  assumed: the last value of " + c.name + " holds for ever\n";
}

// What a tick of the monitors without a robot costs, and what they remember.
std::string summary(const ir::Watch& watch) {
  std::string out = "\nmonitors without a robot, every " + millis(watch.period_us) + ", " +
                    bytes(codegen::watch_state_bytes(watch)) + " of state" +
                    (codegen::table_bytes(watch) == 0
                         ? ""
                         : ", " + bytes(codegen::table_bytes(watch)) + " of tables of zones") +
                    "\n";
  for (const ir::PlainMonitor& m : watch.monitors) {
    out += "  monitor " + m.name + ": " + count(m.property.values.size(), "operation") +
           " a tick, remembers " + bytes(codegen::watch_monitor_bytes(m)) + "\n";
  }
  for (const ir::Channel& c : watch.inputs) {
    if (c.kind == ir::ChannelKind::zone) out += received(c);
    if (c.held) out += holds(c);
  }
  return out;
}

}  // namespace

std::string summary(const ir::Module& module) {
  std::string out = "specification " + module.name + "\n";
  for (const ir::Decision& d : module.decisions) {
    out += "\ndecision " + d.name + " for " + d.kind +
           (d.on_plan ? ", on a plan" : ", every " + millis(d.period_us)) + "\n";
    for (const auto& s : analysis::summarise(module, d)) {
      out += "  monitor " + s.monitor;
      if (s.horizon_us == 0) {
        out += d.on_plan ? ": every leg of the plan\n" : ": way-points only, no duration\n";
        continue;
      }
      out += ": looks " + millis(s.lookahead_us) + " ahead, " + millis(s.horizon_us) +
             " with sample age, latency and jitter\n";
      out += "    full speed needs a clearance of " + metres(s.stopping_mm) +
             ", control returns at " + metres(s.return_clearance_mm) + "\n";
      if (!s.zone.empty()) {
        out += "    predicted share of the advanced controller: any speed in " +
               std::to_string(s.share.any_speed) + " % of " + s.zone + ", control back in " +
               std::to_string(s.share.returns) + " %\n";
      }
      if (s.lookahead_max_us > 0) {
        out += "    the zone allows a look-ahead of up to " + millis(s.lookahead_max_us) + "\n";
      }
      if (s.leave_us > 0) {
        out +=
            "    to lead out of zones that come and go takes " + millis(s.leave_us) + " at most\n";
      }
    }
    if (codegen::has_signals(d)) {
      out += "  inputs and the past, judged now: " + bytes(codegen::facts_state_bytes(d.facts)) +
             " of state for each robot\n";
    }
    for (const ir::Channel& c : d.facts.inputs) {
      if (c.held) out += holds(c);
      if (c.kind != ir::ChannelKind::zone) continue;
      out += received(c);
      out += "  assumed: " + c.name + " does not change before a robot that looks at it stands\n";
    }
    if (!d.agents.empty()) {
      std::string names;
      for (const ir::Agent& a : d.agents) names += (names.empty() ? "" : ", ") + a.name;
      out += "  assumed: nobody keeps " + names + " from a robot that stands (up to " +
             to_decimal(Rational(d.body.stands_mmps, 1000)) + " m/s)\n";
    }
    if (ir::is_charged_swaying(d.body)) {
      out += "  assumed: a dock charges who holds its place there (up to " +
             to_decimal(Rational(ir::charged_up_to_mmps(d.body), 1000)) + " m/s)\n";
    }
    if (d.coordinated) {
      out += "  coordinated: of several recoveries the one drives that keeps most of the order\n";
    }
    for (const ir::Monitor& m : d.monitors) {
      if (m.hold_reason.empty()) continue;
      out += "  accepted: where " + m.name + " is false, " + m.recovery.name + " holds (" +
             m.hold_reason + ")\n";
    }
    for (const auto& a : d.acknowledgements) {
      out += "  acknowledged: " + a.recovery + " may break " + a.monitor + " (" + a.reason + ")\n";
    }
  }
  if (module.watch) out += summary(*module.watch);
  return out;
}

}  // namespace rtac::driver
