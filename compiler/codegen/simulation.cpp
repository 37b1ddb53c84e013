#include "compiler/codegen/simulation.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "compiler/codegen/simulation_property.h"
#include "compiler/ir/margin_unit.h"
#include "compiler/ir/words.h"

namespace rtac::codegen {
namespace {

using Json = nlohmann::ordered_json;

double metres(std::int64_t mm) {
  return static_cast<double>(mm) / 1000;
}
std::int64_t micros(const sema::Quantity& s) {
  return floor_to_int(s.value * 1'000'000);
}

// Names of the members of rtac::RobotLimits.
Json limits(const sema::RobotKind& k) {
  Json j;
  const auto put = [&](const std::string& name, const sema::Quantity& value) {
    j[name] = nearest_double(value.value);
  };
  const auto sense = [&](const std::string& name, const std::string& unit,
                         const std::optional<sema::Sense>& s) {
    if (!s) return;
    put(name + "_error" + unit, s->error);
    j[name + "_age_us"] = micros(s->max_age);
  };
  put("radius_m", k.radius);
  j["unicycle"] = k.motion.model == sema::MotionModel::unicycle;
  put("speed_mps", k.motion.speed);
  put("accel_mps2", k.motion.accel);
  put("brake_mps2", k.motion.brake);
  if (k.motion.turn) put("turn_radps", *k.motion.turn);
  if (k.motion.turn_accel) put("turn_accel_radps2", *k.motion.turn_accel);
  sense("position", "_m", k.position);
  sense("velocity", "_mps", k.velocity);
  sense("heading", "_rad", k.heading);
  sense("battery", "", k.battery);
  if (k.hears_max_age) j["hears_age_us"] = micros(*k.hears_max_age);
  j["latency_us"] = micros(k.latency);
  if (disturbance_of(k) > 0) j["disturbance_mps2"] = nearest_double(disturbance_of(k));
  if (k.in_space) j["in_space"] = true;
  if (k.plan) put("tracking_m", k.plan->tracking);
  if (k.energy) {
    put("drive_per_m", k.energy->drive);
    put("idle_per_s", k.energy->idle);
    put("drain_per_s", k.energy->drain);
    put("charge_per_s", k.energy->charge);
  }
  return j;
}

// Of a zone with height, slabs of other zones of the list.
Json slabs(const ir::ZoneTable& z) {
  Json all = Json::array();
  for (const ir::ZoneTable::Slab& s : z.slabs) {
    all.push_back({{"base", static_cast<std::uint32_t>(s.base)},
                   {"floor_m", metres(s.floor_mm)},
                   {"ceiling_m", metres(s.ceiling_mm)}});
  }
  return {{"name", z.name}, {"slabs", std::move(all)}};
}
Json zone(const ir::ZoneTable& z) {
  if (z.has_height()) return slabs(z);
  Json edges = Json::array();
  for (const ir::Edge& e : z.edges) {
    for (const std::int32_t mm : {e.ax, e.ay, e.bx, e.by}) edges.push_back(mm);
  }
  const ir::Cells& c = z.cells;
  return {{"name", z.name},
          {"edges_mm", std::move(edges)},
          {"ring_starts", z.ring_starts},
          {"cells",
           {{"origin_x_mm", c.origin_x_mm},
            {"origin_y_mm", c.origin_y_mm},
            {"cell_mm", c.cell_mm},
            {"columns", c.columns},
            {"rows", c.rows},
            {"clearance_mm", c.clearance_mm_lo}}}};
}

Json site(const ir::SiteTable& s) {
  Json places = Json::array();
  for (const auto& p : s.places) places.push_back({metres(p.x_mm), metres(p.y_mm)});
  return {{"name", s.name},
          {"zone", static_cast<std::uint32_t>(s.zone)},
          {"places", std::move(places)}};
}

// Members of rtac::safe::Claim, but for zone and speed.
Json claim(const ir::Decision& d, const ir::Recovery& r) {
  return {{"reaction_us", ir::reaction_us(d, r)},
          {"accel_mps2", metres(d.body.accel_mmps2)},
          {"brake_lag_s", metres(d.body.brake_lag_ms)},
          {"brake_bend", metres(d.body.brake_lag_permille)},
          {"hold_m", metres(d.body.hold_mm)}};
}

Json recovery(const ir::Decision& d, const ir::Recovery& r, const sema::RobotKind& kind) {
  Json j{{"name", r.name}, {"kind", ir::word_of(r.kind)}};
  j["lasts_us"] = r.lasts_us;
  for (const ir::Recovery& step : r.steps) j["steps"].push_back(recovery(d, step, kind));
  j["pass_gap_m"] = metres(r.pass_gap_mm);
  if (r.kind == ir::RecoveryKind::land) {
    j["speed_mps"] = metres(r.speed_mmps);
    j["land_at_m"] = metres(r.land_mm);
  }
  if (r.claims) j["claim"] = claim(d, r);
  const bool external = r.kind == ir::RecoveryKind::external;
  if (!ir::moves(r.kind) && !external) return j;
  j["zone"] = static_cast<std::uint32_t>(r.zone);
  if (r.kind == ir::RecoveryKind::route) j["site"] = static_cast<std::uint32_t>(r.site);
  // who claims nothing drives as fast as the robot may
  const bool any_speed = external && !r.claims;
  j["speed_mps"] = metres(any_speed ? d.motions.front().speed_mmps : r.speed_mmps);
  if (external) return j;
  j["route_clearance_m"] = metres(r.route_clearance_mm);
  j["return_clearance_m"] = metres(r.return_clearance_mm);
  if (kind.energy) j["detour_m"] = nearest_double(kind.energy->detour.value);
  return j;
}

class Decisions {
 public:
  Decisions(const ir::Module& module, const sema::Spec& spec, const ir::TableMap& tables,
            const Mutant* mutant)
      : module_(module), spec_(spec), tables_(tables), mutant_(mutant) {}

  std::vector<std::string> problems;

  Json all() {
    Json list = Json::array();
    std::size_t number = 0;
    for (const ir::Decision& d : module_.decisions) {
      std::vector<std::string> robots;
      for (const sema::Robot& r : spec_.robots) {
        if (spec_[r.kind].name == d.kind) robots.push_back(r.name);
      }
      if (robots.empty()) continue;
      if (!d.on_plan) list.push_back(decision(d, number, robots));
      ++number;
    }
    return list;
  }

 private:
  Json decision(const ir::Decision& d, std::size_t number, const std::vector<std::string>& robots) {
    const auto at = std::find_if(spec_.kinds.begin(), spec_.kinds.end(),
                                 [&](const sema::RobotKind& k) { return k.name == d.kind; });
    const auto kind = static_cast<sema::KindId>(at - spec_.kinds.begin());
    Json j{{"name", d.name}, {"number", number}, {"kind", d.kind}, {"advanced", d.advanced}};
    j["output"] = at->output == sema::OutputType::twist ? "twist" : "acceleration";
    j["period_us"] = d.period_us;
    j["standing_m"] = metres(d.standing_mm);
    j["plan_capacity"] = d.plan_capacity;
    j["open_fleet"] = d.open_fleet;
    j["surrender_mode"] = ir::surrender_mode(d);
    if (ir::judges_commands(d)) j["judges_commands"] = true;
    j["limits"] = limits(*at);
    j["robots"] = robots;
    if (at->energy) {
      j["dock"] = dock(kind, *at->energy);
      j["dock_mps"] = metres(ir::charged_up_to_mmps(d.body));
    }
    facts_ = {};
    for (const ir::Channel* c : plain_inputs(d)) {
      if (c->kind == ir::ChannelKind::zone) {
        problem(d.name, "asks for the zone `" + c->name + "`, which is received while it runs");
      }
      if (c->kind == ir::ChannelKind::path) {
        problem(d.name, "asks for the path `" + c->name + "`, which is received while it runs");
      }
      j["inputs"].push_back(input(*c));
      facts_.inputs.insert(c->name);
    }
    if (!d.agents.empty()) {
      j["rest_mps"] = metres(d.body.stands_mmps);
      for (const sema::Agent& a : spec_.agents) j["agents"].push_back(agent(a));
    }
    j["monitors"] = Json::array();
    for (const ir::Monitor& m : d.monitors) j["monitors"].push_back(monitor(d, m, kind, *at));
    for (const sema::ZoneId zone : facts_.timed) j["openings"].push_back(openings(d, spec_[zone]));
    if (const std::int64_t us = memory(d, kind); us > 0) j["memory_us"] = us;
    return j;
  }
  // As long as its monitors look back, and until control is given back then.
  std::int64_t memory(const ir::Decision& d, sema::KindId kind) {
    // a step takes a microsecond and more, in each run
    constexpr std::int64_t ticks_most = 200'000;
    std::int64_t most_us = 0;
    for (const ir::Monitor& m : d.monitors) {
      const sema::Monitor& from = written(m, kind);
      most_us = std::max(most_us, memory_us(*from.always, d.period_us));
      if (from.return_when) most_us = std::max(most_us, memory_us(*from.return_when, d.period_us));
    }
    if (most_us == 0) return 0;
    if (most_us / d.period_us * d.robots > ticks_most) {
      problem(d.name, "looks back over " + std::to_string(most_us / d.period_us) +
                          " ticks of each of its robots, and " + std::to_string(ticks_most) +
                          " in all can be played before a run");
    }
    return most_us + (d.dwell_ticks + 1) * d.period_us;
  }
  const sema::Monitor& written(const ir::Monitor& m, sema::KindId kind) const {
    return *std::find_if(
        spec_.monitors.begin(), spec_.monitors.end(),
        [&](const sema::Monitor& each) { return each.name == m.name && each.kind == kind; });
  }
  // As they are written; those of the week since its Monday.
  static Json openings(const ir::Decision& d, const sema::Zone& zone) {
    constexpr std::int64_t us_per_s = 1'000'000, s_per_day = 86'400;
    Json once = Json::array(), weekly = Json::array();
    for (const sema::Opening& o : zone.openings) {
      if (o.days == 0) once.push_back({o.from_s * us_per_s, o.until_s * us_per_s});
      for (std::int64_t day = 0; day < 7; ++day) {
        if ((o.days >> day & 1) == 0) continue;
        const std::int64_t midnight_s = day * s_per_day;
        weekly.push_back({(midnight_s + o.from_s) * us_per_s, (midnight_s + o.until_s) * us_per_s});
      }
    }
    std::int64_t lead_us = 0;
    for (const ir::Monitor& m : d.monitors) {
      lead_us = std::max(lead_us, ir::horizon_us(d, m) + m.recovery.leave_us);
    }
    return {{"zone", zone.name},
            {"once", std::move(once)},
            {"weekly", std::move(weekly)},
            {"lead_us", lead_us}};
  }
  // Those that are not what is seen of agents.
  static std::vector<const ir::Channel*> plain_inputs(const ir::Decision& d) {
    std::vector<const ir::Channel*> plain;
    for (std::uint32_t c = 0; c < d.facts.inputs.size(); ++c) {
      const bool of_agent = std::any_of(d.agents.begin(), d.agents.end(), [&](const ir::Agent& a) {
        return a.seen == c || a.present == c;
      });
      if (!of_agent) plain.push_back(&d.facts.inputs[c]);
    }
    return plain;
  }
  // SI.
  Json input(const ir::Channel& c) const {
    const bool whole = spec_.inputs[c.declared].type == sema::InputType::integer;
    Json j{{"name", c.name}, {"kind", whole ? "whole" : ir::word(c.kind)}};
    if (c.kind == ir::ChannelKind::choice) j["values"] = c.values;
    j["components"] = Json::array();
    for (std::uint32_t k = 0; k < c.components.size(); ++k) {
      j["components"].push_back(
          c.kind == ir::ChannelKind::number
              ? number(c.grid(k))
              : named(c.kind == ir::ChannelKind::choice ? c.values.size() : 2));
    }
    return j;
  }
  static Json component(double least, double most, double error, double steps_per_unit) {
    return {{"least", least},       {"most", most},
            {"error", error},       {"steps_per_unit", steps_per_unit},
            {"drawn_least", least}, {"drawn_most", most}};
  }
  static Json named(std::size_t count) {
    return component(0, static_cast<double>(count) - 1, 0, 1);
  }
  // Without a range it may be whatever the grid of the kernel has, and is drawn around 0.
  static Json number(const ir::ChannelGrid& g) {
    constexpr double around = 100;
    const auto si = [&](std::int64_t steps) {
      return nearest_double(Rational(g.unit.step * static_cast<long>(steps)));
    };
    Json j = component(si(g.range.lo), si(g.range.hi), si(g.error_steps),
                       nearest_double(Rational(1 / g.unit.step)));
    if (g.range.declared) return j;
    j["drawn_least"] = std::max(-around, si(g.range.lo));
    j["drawn_most"] = std::min(around, si(g.range.hi));
    return j;
  }
  static Json agent(const sema::Agent& a) {
    Json j = {{"name", a.name},
              {"radius_m", nearest_double(a.radius.value)},
              {"speed_mps", nearest_double(a.speed.value)},
              {"error_m", nearest_double(a.position.error.value)},
              {"age_us", micros(a.position.max_age)}};
    if (a.in_space) j["in_space"] = true;
    return j;
  }
  // Where robots charge, by fleet index.
  Json dock(sema::KindId kind, const sema::Energy& energy) const {
    Json places = Json::array();
    for (std::uint32_t r = 0; r < spec_.robots.size(); ++r) {
      if (spec_.robots[r].kind != kind) continue;
      for (const sema::Site::Place& p : spec_[energy.charge_at].places) {
        if (p.robot && *p.robot != sema::RobotId{r}) continue;
        places.push_back({nearest_double(p.position.x), nearest_double(p.position.y)});
        break;
      }
    }
    return places;
  }
  void problem(const std::string& decision, const std::string& what) {
    problems.push_back("decision `" + decision + "` " + what);
  }
  Json monitor(const ir::Decision& d, const ir::Monitor& m, sema::KindId kind,
               const sema::RobotKind& robot) {
    Json j{{"name", m.name}, {"requirement", m.requirement_id}, {"text", m.text}};
    j["unit"] = ir::mixes_units(m) ? "" : ir::decision_unit_text(m);
    ir::Recovery drives = m.recovery;
    if (mutant_ != nullptr) mutate(*mutant_, drives);
    j["recovery"] = recovery(d, drives, robot);
    if (m.lookahead.duration) {
      j[m.lookahead.command ? "command_us" : "horizon_us"] = ir::horizon_us(d, m);
    }
    std::string why;
    auto tree = property_tree(spec_, kind, tables_, *written(m, kind).always, facts_, why);
    if (!tree) problem(d.name, "has a monitor `" + m.name + "` that speaks of " + why);
    if (tree) j["property"] = std::move(*tree);
    return j;
  }

  const ir::Module& module_;
  const sema::Spec& spec_;
  const ir::TableMap& tables_;
  const Mutant* mutant_;
  Facts facts_;  // of the decision that is told of
};

}  // namespace

Simulation simulation(const ir::Module& module, const sema::Spec& spec, const ir::TableMap& tables,
                      const std::string& source, const Mutant* mutant) {
  Json j{{"generator", "rtac " RTAC_VERSION}, {"abi", RTAC_ABI}, {"specification", spec.name}};
  j["source"] = source;
  j["zones"] = Json::array();
  for (const ir::ZoneTable& z : module.zones) j["zones"].push_back(zone(z));
  j["sites"] = Json::array();
  for (const ir::SiteTable& s : module.sites) j["sites"].push_back(site(s));
  Decisions decisions(module, spec, tables, mutant);
  j["decisions"] = decisions.all();
  Simulation result{j.dump() + "\n", std::move(decisions.problems)};
  if (j["decisions"].empty()) {
    result.problems.push_back("no robot of a fleet has a decision with a period");
  }
  return result;
}

}  // namespace rtac::codegen
