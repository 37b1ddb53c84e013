#include "compiler/codegen/manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compiler/codegen/decision_bytes.h"
#include "compiler/codegen/watch.h"
#include "compiler/ir/facts.h"
#include "compiler/ir/rounding.h"
#include "compiler/ir/weights.h"
#include "compiler/sema/dimension.h"

namespace rtac::codegen {
namespace {

using Json = nlohmann::ordered_json;
using namespace ir;

Json monitor(const Monitor& m, const Decision& d) {
  Json j;
  j["name"] = m.name;
  j["requirement"] = m.requirement_id;
  j["text"] = m.requirement_text;
  j["property"] = m.text;
  j["file"] = m.file;
  j["line"] = m.line;
  if (d.on_plan) return j;
  j["recovery"] = m.recovery.name;
  if (m.lookahead.duration) {
    j["lookahead_us"] = m.lookahead.duration_us;
    j["horizon_us"] = ir::horizon_us(d, m) + d.body.position_age_us;
  }
  if (m.lookahead.command) j["lookahead_command"] = true;
  if (m.lookahead.waypoints > 0) j["lookahead_waypoints"] = m.lookahead.waypoints;
  j["sound"] = m.lookahead.duration && !m.lookahead.too_short && !m.lookahead.points_only;
  j["return_clearance_mm"] = m.recovery.return_clearance_mm;
  if (m.recovery.leave_us > 0) j["leave_us"] = m.recovery.leave_us;
  if (m.recovery.leave_beside_mm > 0) j["leave_beside_mm"] = m.recovery.leave_beside_mm;
  if (!m.return_text.empty()) j["return_when"] = m.return_text;
  if (!m.hold_reason.empty()) j["hold_when_violated"] = m.hold_reason;
  return j;
}

bool checks_tracking(const Module& module, const std::string& kind) {
  const auto on_track = [](const Value& v) { return std::holds_alternative<OnTrack>(v.op); };
  return std::any_of(module.decisions.begin(), module.decisions.end(), [&](const Decision& d) {
    return d.kind == kind &&
           std::any_of(d.monitors.begin(), d.monitors.end(), [&](const Monitor& m) {
             return m.ahead &&
                    std::any_of(m.ahead->values.begin(), m.ahead->values.end(), on_track);
           });
  });
}

// Every declared bound is an assumption. Some are checked while the robot runs: what a measurement
// contradicts is not believed, but what nobody measures can be wrong.
Json assumptions(const Module& module, const sema::RobotKind& k) {
  Json list = Json::array();
  const auto add = [&](const std::string& what, const Rational& si, const std::string& unit,
                       const char* checked_by) {
    list.push_back({{"kind", k.name},
                    {"bound", what},
                    {"value", to_decimal(si) + " " + unit},
                    {"checked_by", checked_by}});
  };
  add("speed", k.motion.speed.value, "m/s",
      k.velocity ? "decision module: a faster measurement is unknown" : "UNCHECKED");
  add("accel", k.motion.accel.value, "m/s^2", "UNCHECKED");
  add("brake", k.motion.brake.value, "m/s^2", "UNCHECKED");
  if (k.motion.disturbance) add("disturbance", k.motion.disturbance->value, "m/s^2", "UNCHECKED");
  if (k.output_error) add("output error", k.output_error->value, "m/s^2", "UNCHECKED");
  add("latency", k.latency.value, "s", "UNCHECKED");
  const auto sense = [&](const std::string& name, const std::string& unit,
                         const std::optional<sema::Sense>& s) {
    if (!s) return;
    add(name + " error", s->error.value, unit, "UNCHECKED");
    add(name + " max_age", s->max_age.value, "s", "decision module: stale input is unknown");
  };
  sense("position", "m", k.position);
  sense("velocity", "m/s", k.velocity);
  sense("heading", "rad", k.heading);
  sense("battery", "of full", k.battery);
  for (const Decision& d : module.decisions) {
    for (const Monitor& m : d.monitors) {
      if (d.kind != k.name || !m.recovery.claims) continue;
      add(m.recovery.name + " stays inside " + module[m.recovery.zone].name + ", speed",
          Rational(static_cast<long>(m.recovery.speed_mmps), 1000), "m/s",
          "runtime: every tick under its own motion; where it fails, the robot is braked, and "
          "nothing leads it back");
    }
  }
  if (k.open_fleet) {
    add("absence of others, max_age", k.hears_max_age->value, "s",
        "UNCHECKED: who comes back moves only when the others have heard of it");
  }
  if (k.plan) {
    add("tracking", k.plan->tracking.value, "m",
        checks_tracking(module, k.name) ? "decision module: beyond it a plan is not admissible"
                                        : "UNCHECKED");
  }
  return list;
}

// What a tool needs to fill plain inputs and to read findings.
Json signals(const Module& module, const Watch& watch) {
  Json list = Json::array();
  const WatchNames names = watch_names(watch);
  for (const WatchSignal& s : names.signals) {
    const Channel& c = watch.inputs[s.channel];
    Json j;
    j["name"] = s.name;
    j["input"] = c.name;
    j["component"] = c.components[s.component];
    j["number"] = watch_input_number(module, s.channel);
    j["kind"] = word(c.kind);
    if (c.kind == ChannelKind::number) {
      const ChannelGrid& grid = c.grid(s.component);
      j["unit"] = sema::unit_of(grid.unit.dimension);
      j["step"] = grid.unit.step.get_str();
      j["least"] = grid.range.lo;
      j["most"] = grid.range.hi;
      j["declared"] = grid.range.declared;
      j["error_steps"] = grid.error_steps;
    }
    if (c.kind == ChannelKind::choice) j["values"] = c.values;
    if (c.kind == ChannelKind::zone) {
      j["tables"] = s.zone;
      j["edges_most"] = c.edges_most;
      j["table_bytes_most"] = received_bytes(c);
    }
    if (c.kind == ChannelKind::path) j["waypoints_most"] = c.places_most;
    if (c.max_age_us) j["max_age_us"] = *c.max_age_us;
    j["held"] = c.held;
    list.push_back(std::move(j));
  }
  return list;
}
// Exact margins that are further from 0 are decided; null: no bound that margins can tell.
Json rounding(const sema::Spec& spec, const Watch& w, const PlainMonitor& m) {
  const Rounding bound = rounding_of(spec, w, m.property);
  const Rational& most = bound.millionths;
  if (bound.has_crossing_legs || most > Rational(static_cast<long>(margin_max))) return nullptr;
  return ceil_to_int(most);
}
Json params(const Watch& w) {
  Json list = Json::array();
  for (const Param& p : w.params) {
    list.push_back({{"name", p.name},
                    {"unit", sema::unit_of(p.unit.dimension)},
                    {"step", p.unit.step.get_str()},
                    {"least", p.range.lo},
                    {"most", p.range.hi},
                    {"value", p.value},
                    {"tightens", p.tightens}});
  }
  return list;
}
// A monitor without a robot, or a fact of one.
Json property(const sema::Spec& spec, const Watch& w, const PlainMonitor& m) {
  return {{"name", m.name},
          {"requirement", m.requirement_id},
          {"text", m.requirement_text},
          {"property", m.text},
          {"file", m.file},
          {"line", m.line},
          {"bytes", watch_monitor_bytes(m)},
          {"operations", m.property.values.size()},
          {"rounding_millionths", speaks_of_robot(m) ? Json(nullptr) : rounding(spec, w, m)}};
}
// What is judged now of the monitors of a robot. A part of several monitors has an entry for each.
Json facts(const Module& module, const sema::Spec& spec, const Decision& d) {
  Json j;
  j["state_bytes"] = facts_state_bytes(d.facts);
  j["inputs"] = signals(module, d.facts);
  j["params"] = params(d.facts);
  j["entries"] = Json::array();
  for (const Monitor& m : d.monitors) {
    for (const std::uint32_t index : facts_of(d, m)) {
      Json entry = property(spec, d.facts, d.facts.monitors[index]);
      entry["monitor"] = m.name;
      j["entries"].push_back(std::move(entry));
    }
  }
  return j;
}
// Which monitors the recovery of each is shown to keep, whatever is measured; with `priority`, of
// those that rank higher and that it drives on for though they engage.
Json keeps(const Decision& d) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < d.keeps.size(); ++i) {
    Json kept = Json::array();
    for (std::size_t k = 0; k < d.keeps[i].size(); ++k) {
      if (d.keeps[i][k] != Kept::unproved) kept.push_back(d.monitors[k].name);
    }
    rows.push_back({{"recovery", d.monitors[i].recovery.name}, {"monitors", std::move(kept)}});
  }
  return rows;
}
Json decision(const Module& module, const sema::Spec& spec, const Decision& d) {
  Json j;
  j["name"] = d.name;
  j["kind"] = d.kind;
  j["advanced"] = d.advanced;
  if (d.on_plan) {
    j["safe"] = d.safe;
    j["on"] = "plan";
  } else {
    j["period_us"] = d.period_us;
    j["state_bytes"] = decision_state_bytes(d);
  }
  j["monitors"] = Json::array();
  for (const Monitor& m : d.monitors) j["monitors"].push_back(monitor(m, d));
  j["acknowledged"] = Json::array();
  for (const Acknowledgement& a : d.acknowledgements) {
    j["acknowledged"].push_back(
        {{"recovery", a.recovery}, {"monitor", a.monitor}, {"reason", a.reason}});
  }
  if (!d.keeps.empty()) j["keeps"] = keeps(d);
  for (const Agent& a : d.agents) {
    j["agents"].push_back({{"name", a.name},
                           {"radius_mm", a.radius_mm},
                           {"position_error_mm", a.error_mm},
                           {"speed_mmps", a.speed_mmps},
                           {"max_age_us", a.age_us}});
    if (a.in_space) j["agents"].back()["in_space"] = true;
  }
  // what is said of agents is kept while the robot is faster; slower it counts as standing
  if (!d.agents.empty()) j["rest_mmps"] = d.body.stands_mmps;
  if (ir::is_charged_swaying(d.body)) j["dock_mmps"] = ir::charged_up_to_mmps(d.body);
  if (has_signals(d)) j["facts"] = facts(module, spec, d);
  return j;
}

// Of a ZoneTable or a Region: how many edges a place is held against.
template <class Zone>
std::size_t edges_checked_max(const Zone& zone) {
  return zone.tree.words.empty() ? zone.edges.size()
                                 : static_cast<std::size_t>(zone.tree.edges_most);
}

Json tables(const Watch& w) {
  Json list = Json::array();
  for (const Region& r : w.regions) {
    if (r.channel) continue;
    list.push_back({{"name", r.name},
                    {"side", r.around ? "around" : "within"},
                    {"edges", r.edges.size()},
                    {"edges_checked_max", edges_checked_max(r)},
                    {"bytes", region_bytes(r)}});
    if (r.tree.exact_mm) list.back()["exact_mm"] = *r.tree.exact_mm;
    if (r.slab > 0) list.back()["slab"] = r.slab;
  }
  return list;
}
Json watch(const Module& module, const sema::Spec& spec) {
  const Watch& w = *module.watch;
  Json j;
  j["period_us"] = w.period_us;
  j["state_bytes"] = watch_state_bytes(w);
  j["verdicts_state_bytes"] = watch_state_bytes(w, Telling::verdicts);
  j["table_bytes"] = table_bytes(w);
  if (w.in_utc) j["clock"] = "utc";
  j["inputs"] = signals(module, w);
  j["params"] = params(w);
  j["units"] = Json::array();
  for (std::size_t k = 0; k < w.units.size(); ++k) {
    const bool percent = w.units[k].dimension == sema::dims::ratio;
    const Rational scale = percent ? Rational(w.units[k].scale * 100) : w.units[k].scale;
    j["units"].push_back(
        {{"unit", k == 0 ? "" : sema::unit_of(w.units[k].dimension)}, {"scale", scale.get_str()}});
  }
  j["monitors"] = Json::array();
  for (const PlainMonitor& m : w.monitors) j["monitors"].push_back(property(spec, w, m));
  j["tables"] = tables(w);
  for (const Solid& s : w.solids) {
    Json slabs = Json::array();
    for (const Slab& slab : s.slabs) {
      slabs.push_back({{"floor_mm", slab.floor_mm}, {"ceiling_mm", slab.ceiling_mm}});
    }
    j["solids"].push_back({{"name", s.name},
                           {"side", s.around ? "around" : "within"},
                           {"slabs", std::move(slabs)},
                           {"bytes", solid_bytes(s)}});
  }
  for (const Schedule& s : w.schedules) {
    j["schedules"].push_back({{"zone", s.name},
                              {"openings", s.once.size()},
                              {"weekly", s.weekly.size()},
                              {"bytes", schedule_bytes(s)}});
  }
  return j;
}

}  // namespace

std::string manifest(const Module& module, const sema::Spec& spec, const Naming& naming) {
  Json j;
  j["generator"] = "rtac " RTAC_VERSION;
  j["abi"] = RTAC_ABI;
  j["specification"] = spec.name;
  j["source"] = naming.source;
  j["namespace"] = naming.space;
  j["files"] = {naming.stem + "_kernel.h", naming.stem + "_kernel.c", naming.stem + ".h",
                naming.stem + ".cpp", naming.stem + "_system.h"};
  j["decisions"] = Json::array();
  for (const Decision& d : module.decisions) j["decisions"].push_back(decision(module, spec, d));
  if (!naming.mutant.empty()) {
    j["mutant"] = naming.mutant;
    for (Json& d : j["decisions"]) {
      for (Json& m : d["monitors"]) m["sound"] = false;
    }
  }
  if (module.watch) j["monitors"] = watch(module, spec);
  j["zones"] = Json::array();
  for (const ZoneTable& z : module.zones) {
    j["zones"].push_back({{"name", z.name},
                          {"edges", z.edges.size()},
                          {"edges_checked_max", edges_checked_max(z)},
                          {"bytes", z.edges.size() * sizeof(Edge) + z.tree.bytes()}});
    if (z.tree.exact_mm) j["zones"].back()["exact_mm"] = *z.tree.exact_mm;
  }
  j["assumptions"] = Json::array();
  for (const sema::RobotKind& k : spec.kinds) {
    for (auto& a : assumptions(module, k)) j["assumptions"].push_back(std::move(a));
  }
  const auto held = [&](const Channel& c, const std::string& kind) {
    if (!c.held) return;
    j["assumptions"].push_back({{"kind", kind},
                                {"bound", c.name + " max_age"},
                                {"value", "inf"},
                                {"checked_by", "UNCHECKED"}});
  };
  for (const Channel& c : module.watch ? module.watch->inputs : std::vector<Channel>{}) {
    held(c, "input");
  }
  for (const Decision& d : module.decisions) {
    for (const Channel& c : d.facts.inputs) {
      held(c, d.kind);
      if (c.kind != ChannelKind::zone) continue;
      j["assumptions"].push_back({{"kind", d.kind},
                                  {"bound", c.name + " stays as it is"},
                                  {"value", "until a robot that looks ahead at it stands"},
                                  {"checked_by", "UNCHECKED"}});
    }
  }
  for (const sema::Assumption& a : spec.assumptions) {
    j["assumptions"].push_back({{"kind", "assume"},
                                {"bound", a.text},
                                {"value", a.checked_by.empty() ? a.reason : ""},
                                {"checked_by", a.checked_by.empty() ? "UNCHECKED" : a.checked_by}});
  }
  return j.dump(2) + "\n";
}

}  // namespace rtac::codegen
