#include "case.h"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace rtac::simulate {
namespace {

using Json = nlohmann::json;
using sim::Property;
using sim::PropertyOp;

const std::map<std::string, PropertyOp>& ops() {
  static const std::map<std::string, PropertyOp> all = {
      {"const", PropertyOp::constant},
      {"input", PropertyOp::constant},
      {"told", PropertyOp::truth},
      {"battery", PropertyOp::battery},
      {"speed", PropertyOp::speed},
      {"clearance", PropertyOp::clearance},
      {"distance", PropertyOp::distance},
      {"energy_to", PropertyOp::energy_to},
      {"agent_distance", PropertyOp::agent_distance},
      {"altitude", PropertyOp::altitude},
      {"add", PropertyOp::add},
      {"subtract", PropertyOp::subtract},
      {"multiply", PropertyOp::multiply},
      {"divide", PropertyOp::divide},
      {"negate", PropertyOp::negate},
      {"min", PropertyOp::minimum},
      {"max", PropertyOp::maximum},
      {"abs", PropertyOp::absolute},
      {"sqrt", PropertyOp::square_root},
      {"norm", PropertyOp::norm},
      {"sin", PropertyOp::sine},
      {"cos", PropertyOp::cosine},
      {"choice", PropertyOp::choice},
      {"count", PropertyOp::count},
      {"truth", PropertyOp::truth},
      {"open", PropertyOp::open},
      {"inside", PropertyOp::inside},
      {"at_least", PropertyOp::at_least},
      {"not", PropertyOp::logical_not},
      {"and", PropertyOp::logical_and},
      {"or", PropertyOp::logical_or},
      {"forall", PropertyOp::forall},
      {"exists", PropertyOp::exists}};
  return all;
}

Property property(const Json& j) {
  Property p;
  p.op = ops().at(j.at("op").get<std::string>());
  switch (p.op) {
    case PropertyOp::constant:
      p.value = j.value("value", 0.0);
      break;
    case PropertyOp::truth:
      p.value = j.value("value", false) ? 1 : 0;
      break;
    case PropertyOp::battery:
    case PropertyOp::speed:
      p.flag = j.at("other").get<bool>();
      break;
    case PropertyOp::clearance:
    case PropertyOp::inside:
      p.index = j.at("zone").get<int>();
      break;
    case PropertyOp::open:
      p.index = j.at("openings").get<int>();
      break;
    case PropertyOp::agent_distance:
      p.index = j.at("agent").get<int>();
      break;
    case PropertyOp::energy_to:
      p.index = j.at("site").get<int>();
      break;
    case PropertyOp::at_least:
      p.flag = j.at("strict").get<bool>();
      p.value = j.at("scale").get<double>();
      break;
    default:
      break;
  }
  if (j.contains("of")) {
    for (const Json& each : j.at("of")) p.of.push_back(property(each));
  }
  return p;
}

Vec2 place(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>()};
}

void read_slabs(const Json& j, const std::deque<Zone>& before, Zone& to) {
  for (const Json& s : j) {
    to.slabs.push_back({&before.at(s.at("base").get<std::size_t>()).view,
                        s.at("floor_m").get<double>(), s.at("ceiling_m").get<double>()});
  }
  to.solid = {to.name.c_str(), to.slabs.data(), to.slabs.size()};
}

void read_zone(const Json& j, const std::deque<Zone>& before, Zone& to) {
  to.name = j.at("name").get<std::string>();
  if (j.contains("slabs")) return read_slabs(j.at("slabs"), before, to);
  to.edges_mm = j.at("edges_mm").get<std::vector<std::int32_t>>();
  to.ring_starts = j.at("ring_starts").get<std::vector<std::size_t>>();
  const Json& cells = j.at("cells");
  to.clearance_mm = cells.at("clearance_mm").get<std::vector<std::int32_t>>();
  ZoneView& v = to.view;
  v.name = to.name.c_str();
  v.edges_mm = to.edges_mm.data();
  v.edge_count = to.edges_mm.size() / 4;
  v.ring_start = to.ring_starts.data();
  v.ring_count = to.ring_starts.size();
  v.origin_x_mm = cells.at("origin_x_mm").get<std::int32_t>();
  v.origin_y_mm = cells.at("origin_y_mm").get<std::int32_t>();
  v.cell_mm = cells.at("cell_mm").get<std::int32_t>();
  v.columns = cells.at("columns").get<std::int32_t>();
  v.rows = cells.at("rows").get<std::int32_t>();
  v.clearance_mm_lo = to.clearance_mm.data();
}

RobotLimits limits(const Json& j) {
  RobotLimits l;
  const std::pair<const char*, double*> numbers[] = {{"radius_m", &l.radius_m},
                                                     {"speed_mps", &l.speed_mps},
                                                     {"accel_mps2", &l.accel_mps2},
                                                     {"brake_mps2", &l.brake_mps2},
                                                     {"turn_radps", &l.turn_radps},
                                                     {"turn_accel_radps2", &l.turn_accel_radps2},
                                                     {"position_error_m", &l.position_error_m},
                                                     {"velocity_error_mps", &l.velocity_error_mps},
                                                     {"heading_error_rad", &l.heading_error_rad},
                                                     {"battery_error", &l.battery_error},
                                                     {"tracking_m", &l.tracking_m},
                                                     {"disturbance_mps2", &l.disturbance_mps2},
                                                     {"drive_per_m", &l.drive_per_m},
                                                     {"idle_per_s", &l.idle_per_s},
                                                     {"drain_per_s", &l.drain_per_s},
                                                     {"charge_per_s", &l.charge_per_s}};
  for (const auto& [name, number] : numbers) *number = j.value(name, 0.0);
  const std::pair<const char*, TimeUs*> times[] = {
      {"position_age_us", &l.position_age_us}, {"velocity_age_us", &l.velocity_age_us},
      {"heading_age_us", &l.heading_age_us},   {"battery_age_us", &l.battery_age_us},
      {"hears_age_us", &l.hears_age_us},       {"latency_us", &l.latency_us}};
  for (const auto& [name, time] : times) *time = j.value(name, TimeUs{0});
  l.unicycle = j.at("unicycle").get<bool>();
  l.in_space = j.value("in_space", false);
  return l;
}

Recovery recovery(const Json& j) {
  Recovery r;
  r.name = j.at("name").get<std::string>();
  r.kind = j.at("kind").get<std::string>();
  r.zone = j.value("zone", 0);
  r.site = j.value("site", 0);
  r.speed_mps = j.value("speed_mps", 0.0);
  r.route_clearance_m = j.value("route_clearance_m", 0.0);
  r.return_clearance_m = j.value("return_clearance_m", 0.0);
  r.pass_gap_m = j.value("pass_gap_m", 0.0);
  r.has_detour = j.contains("detour_m");
  r.detour_m = j.value("detour_m", 0.0);
  r.land_at_m = j.value("land_at_m", 0.0);
  r.lasts_us = j.value("lasts_us", TimeUs{0});
  if (j.contains("claim")) {
    const Json& c = j.at("claim");
    r.claim.emplace();
    r.claim->reaction_us = c.at("reaction_us").get<TimeUs>();
    r.claim->accel_mps2 = c.at("accel_mps2").get<double>();
    r.claim->brake_lag_s = c.at("brake_lag_s").get<double>();
    r.claim->brake_bend = c.at("brake_bend").get<double>();
    r.claim->hold_m = c.at("hold_m").get<double>();
  }
  if (j.contains("steps")) {
    for (const Json& step : j.at("steps")) r.steps.push_back(recovery(step));
  }
  return r;
}

Input input(const Json& j) {
  static const std::map<std::string, Input::Kind> kinds = {{"truth", Input::Kind::truth},
                                                           {"whole", Input::Kind::whole},
                                                           {"number", Input::Kind::number},
                                                           {"choice", Input::Kind::choice}};
  Input i;
  i.name = j.at("name").get<std::string>();
  i.kind = kinds.at(j.at("kind").get<std::string>());
  if (j.contains("values")) i.values = j.at("values").get<std::vector<std::string>>();
  for (const Json& c : j.at("components")) {
    i.components.push_back({c.at("least").get<double>(), c.at("most").get<double>(),
                            c.at("error").get<double>(), c.at("steps_per_unit").get<double>(),
                            c.at("drawn_least").get<double>(), c.at("drawn_most").get<double>()});
  }
  return i;
}

// Where the property of a monitor speaks of inputs.
void read_mentions(const Json& j, Mention at, DecisionCase& to) {
  if (j.contains("input")) {
    std::size_t before = 0;
    const auto name = j.at("input").get<std::string>();
    auto i = to.inputs.begin();
    for (; i != to.inputs.end() && i->name != name; ++i) before += i->components.size();
    if (i == to.inputs.end()) throw std::out_of_range("input " + name);
    at.component = before + j.at("component").get<std::size_t>();
    if (j.contains("is")) at.wanted = j.at("is").get<double>();
    to.mentions.push_back(at);
  }
  if (!j.contains("of")) return;
  at.path.push_back(0);
  for (const Json& each : j.at("of")) {
    read_mentions(each, at, to);
    ++at.path.back();
  }
}

std::vector<Openings::Span> spans(const Json& j) {
  std::vector<Openings::Span> all;
  for (const Json& each : j) {
    all.push_back({each.at(0).get<TimeUs>(), each.at(1).get<TimeUs>()});
  }
  return all;
}

DecisionCase decision(const Json& j, const Case& all) {
  DecisionCase d;
  d.name = j.at("name").get<std::string>();
  d.kind = j.at("kind").get<std::string>();
  d.advanced = j.at("advanced").get<std::string>();
  d.number = j.at("number").get<int>();
  d.twist = j.at("output").get<std::string>() == "twist";
  d.period_us = j.at("period_us").get<TimeUs>();
  d.standing_m = j.at("standing_m").get<double>();
  d.plan_capacity = j.at("plan_capacity").get<std::size_t>();
  d.surrender_mode = j.at("surrender_mode").get<int>();
  d.judges_commands = j.value("judges_commands", false);
  d.limits = limits(j.at("limits"));
  d.robots = j.at("robots").get<std::vector<std::string>>();
  if (j.contains("dock")) {
    for (const Json& at : j.at("dock")) d.docks.push_back(place(at));
    d.dock_mps = j.at("dock_mps");
  }
  if (j.contains("agents")) {
    for (const Json& a : j.at("agents")) {
      d.agents.push_back({a.at("name").get<std::string>(), a.at("radius_m").get<double>(),
                          a.at("speed_mps").get<double>(), a.at("error_m").get<double>(),
                          a.at("age_us").get<TimeUs>(), a.value("in_space", false)});
    }
  }
  if (j.contains("openings")) {
    for (const Json& z : j.at("openings")) {
      d.calendar.push_back({z.at("zone").get<std::string>(), spans(z.at("once")),
                            spans(z.at("weekly")), z.at("lead_us").get<TimeUs>()});
    }
  }
  d.memory_us = j.value("memory_us", TimeUs{0});
  if (j.contains("inputs")) {
    for (const Json& i : j.at("inputs")) d.inputs.push_back(input(i));
  }
  for (const Json& m : j.at("monitors")) {
    d.monitors.push_back({m.at("name").get<std::string>(), m.at("requirement").get<std::string>(),
                          m.at("text").get<std::string>(), m.at("unit").get<std::string>(),
                          recovery(m.at("recovery")), m.value("horizon_us", TimeUs{0}),
                          m.value("command_us", TimeUs{0})});
    Mention at;
    at.monitor = d.properties.size();
    read_mentions(m.at("property"), at, d);
    d.properties.push_back(property(m.at("property")));
  }
  for (const Zone& zone : all.zones) {
    // Every edge is looked at: a mistake in the tables of the kernel must not judge itself.
    d.surroundings.zones.push_back(zone.view);
    d.surroundings.solids.push_back(zone.solid);
  }
  d.surroundings.sites = all.sites;
  d.surroundings.radius_m = d.limits.radius_m;
  d.surroundings.drive_per_m = d.limits.drive_per_m;
  d.surroundings.rest_mps = j.value("rest_mps", 0.0);
  return d;
}

}  // namespace

std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = UINT64_C(0xcbf29ce484222325);  // FNV-1a
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * UINT64_C(0x100000001b3);
  }
  return hash;
}

Problem read_manifest(const std::string& text, Case& to) {
  const Json j = Json::parse(text, nullptr, false);
  if (j.is_discarded() || j.value("abi", 0) != RTAC_ABI) {
    return {"the manifest is not one of this version of rtac",
            "install `rtac` and `rtac-sim` of "
            "the same version"};
  }
  try {
    to.specification = j.at("specification").get<std::string>();
    to.source = j.at("source").get<std::string>();
    to.hash = hash_of(text);
    for (const Json& z : j.at("zones")) read_zone(z, to.zones, to.zones.emplace_back());
    for (const Json& s : j.at("sites")) {
      to.sites.emplace_back();
      for (const Json& p : s.at("places")) to.sites.back().push_back(place(p));
    }
    for (const Json& d : j.at("decisions")) to.decisions.push_back(decision(d, to));
  } catch (const std::exception& error) {
    return {std::string("the manifest is not complete: ") + error.what(),
            "install `rtac` and `rtac-sim` of the same version"};
  }
  return {};
}

}  // namespace rtac::simulate
