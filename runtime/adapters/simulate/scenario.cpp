#include "scenario.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "rtac/sim/math.h"

namespace rtac::simulate {
namespace {

using Json = nlohmann::json;
using sim::Ages;
using sim::Aim;
using sim::Noise;
using sim::PropertyOp;

constexpr double us_per_s = 1e6, us_per_ms = 1e3;
constexpr double duration_s_min = 0.001, duration_s_max = 86'400;

struct Unfit {
  std::string message, help;
};

template <class Value>
struct Word {
  const char* word;
  Value value;
};
constexpr Word<Noise> noises[] = {{"none", Noise::none},
                                  {"uniform", Noise::uniform},
                                  {"extreme", Noise::extreme},
                                  {"aimed", Noise::aimed},
                                  {"lasting", Noise::lasting}};
constexpr Word<Ages> all_ages[] = {{"fresh", Ages::fresh},
                                   {"oldest", Ages::oldest},
                                   {"unequal", Ages::unequal},
                                   {"wandering", Ages::wandering}};

template <class Value, std::size_t Size>
Value chosen(const Json& j, const std::string& key, const Word<Value> (&words)[Size]) {
  std::string names;
  for (const auto& each : words) {
    if (j.is_string() && j.get<std::string>() == each.word) return each.value;
    names += (names.empty() ? "`" : ", `") + std::string(each.word) + "`";
  }
  throw Unfit{"`" + key + "` of the scenario is " + j.dump(), "there are " + names};
}

double number(const Json& j, const std::string& key, double least, double most) {
  if (j.is_number() && j.get<double>() >= least && j.get<double>() <= most) return j.get<double>();
  throw Unfit{"`" + key + "` of the scenario is " + j.dump(),
              "a number from " + Json(least).dump() + " to " + Json(most).dump() + " works"};
}
std::uint64_t whole(const Json& j, const std::string& key, std::uint64_t least) {
  if (j.is_number_unsigned() && j.get<std::uint64_t>() >= least) return j.get<std::uint64_t>();
  throw Unfit{"`" + key + "` of the scenario is " + j.dump(),
              "a whole number from " + std::to_string(least) + " to " +
                  std::to_string(std::numeric_limits<std::uint64_t>::max()) + " works"};
}
std::string text(const Json& j, const std::string& key) {
  if (j.is_string()) return j.get<std::string>();
  throw Unfit{"`" + key + "` of the scenario is " + j.dump(), "a name works"};
}
TimeUs time(const Json& j, const std::string& key, double unit_us, double least = 0) {
  return std::llround(number(j, key, least, duration_s_max) * unit_us);
}

Start start(const Json& j) {
  if (!j.is_object()) {
    throw Unfit{"a start of the scenario is " + j.dump(),
                R"(`{"at": [1, 2], "heading_deg": 90, "battery": 0.8}` is one)"};
  }
  constexpr double far_m = 1e5, turn_deg = 360;
  Start s;
  for (const auto& [key, value] : j.items()) {
    if (key == "at" && value.is_array() && (value.size() == 2 || value.size() == 3)) {
      if (value.size() == 3) s.height_m = number(value[2], key, -far_m, far_m);
      s.place = Vec2{number(value[0], key, -far_m, far_m), number(value[1], key, -far_m, far_m)};
    } else if (key == "heading_deg") {
      s.heading_rad = number(value, key, -turn_deg, turn_deg) * sim::pi / (turn_deg / 2);
    } else if (key == "battery" && value == "tight") {
      s.tight = true;
    } else if (key == "battery" && value.is_string()) {
      throw Unfit{"`battery` of the scenario is " + value.dump(),
                  "a number from 0 to 1 works, or \"tight\""};
    } else if (key == "battery") {
      s.battery = number(value, key, 0, 1);
    } else {
      throw Unfit{"a start of the scenario has `" + key + "`: " + value.dump(),
                  "there are `at`, two numbers in m and in space three, `heading_deg` and "
                  "`battery`, 1 = full, or \"tight\""};
    }
  }
  return s;
}

// Of one component; in SI units.
Scenario::Value input(const Json& j, const std::string& name) {
  if (j.is_boolean()) return j.get<bool>();
  if (j.is_number()) return j.get<double>();
  if (j.is_string()) return j.get<std::string>();
  throw Unfit{"the input `" + name + "` of the scenario is " + j.dump(),
              "`true`, a number in SI units, the name of a value, or a list of these works"};
}
Scenario::Given input_values(const Json& j, const std::string& name) {
  Scenario::Given values;
  if (!j.is_array()) return {input(j, name)};
  for (const Json& each : j) values.push_back(input(each, name));
  return values;
}

// Of a key that is one, and has a value of another kind: what has the right one.
[[noreturn]] void refuse(const std::string& key, const Json& value) {
  constexpr std::pair<const char*, const char*> forms[] = {
      {"starts", R"(`"starts": {"r1": {"at": [1, 2]}}` works, or `"starts": "tight"`)"},
      {"inputs", R"(`"inputs": {"open": true}` works)"},
      {"not_driven_by", R"(`"not_driven_by": ["back"]` works)"},
      {"undecided", "`true` and `false` work"}};
  for (const auto& [of, help] : forms) {
    if (key == of) throw Unfit{"`" + key + "` of the scenario is " + value.dump(), help};
  }
  throw Unfit{
      "the scenario has `" + key + "`: " + value.dump(),
      "there are `duration_s`, `begins`, `seed`, `runs`, `adversary`, `starts`, `inputs`, `noise`, "
      "`ages`, "
      "`fault_every_s`, `fault_ms`, `jitter_ms`, `about`, "
      "`driven_by`, `not_driven_by`, `unmet`, `return_within_s`, `undecided` and `deaf_from_s`"};
}

void take(const std::string& key, const Json& value, Scenario& to) {
  if (key == "duration_s") {
    to.duration_us = time(value, key, us_per_s, duration_s_min);
  } else if (key == "begins") {
    to.begins_us = value.is_string() ? utc_of(value.get<std::string>()) : std::nullopt;
    if (!to.begins_us) {
      throw Unfit{"`begins` of the scenario is " + value.dump(),
                  "a moment works, `\"2026-05-01T08:00:00Z\"`"};
    }
  } else if (key == "seed") {
    to.seed = whole(value, key, 0);
  } else if (key == "runs") {
    to.runs = whole(value, key, 1);
  } else if (key == "adversary" && value.is_object()) {
    for (const auto& [robot, name] : value.items()) {
      to.adversary_of.emplace_back(robot, text(name, key));
    }
  } else if (key == "adversary") {
    to.adversary = text(value, key);
  } else if (key == "starts" && value == "tight") {
    to.tight = true;
  } else if (key == "starts" && value.is_object()) {
    for (const auto& [robot, each] : value.items()) to.starts.emplace_back(robot, start(each));
  } else if (key == "inputs" && value.is_object()) {
    for (const auto& [name, each] : value.items()) {
      to.inputs.emplace_back(name, input_values(each, name));
    }
  } else if (key == "noise") {
    to.noise = chosen(value, key, noises);
  } else if (key == "ages") {
    to.ages = chosen(value, key, all_ages);
  } else if (key == "fault_every_s") {
    to.fault_every_us = time(value, key, us_per_s);
  } else if (key == "fault_ms") {
    to.fault_us_max = time(value, key, us_per_ms);
  } else if (key == "jitter_ms") {
    to.jitter_us = time(value, key, us_per_ms);
  } else if (key == "about") {
    to.about = text(value, key);
  } else if (key == "driven_by") {
    to.driven_by = text(value, key);
  } else if (key == "unmet") {
    to.unmet = text(value, key);
  } else if (key == "not_driven_by" && value.is_array()) {
    for (const Json& each : value) to.not_driven_by.push_back(text(each, key));
  } else if (key == "deaf_from_s") {
    to.deaf_from_us = time(value, key, us_per_s);
  } else if (key == "undecided" && value.is_boolean()) {
    to.undecided = value.get<bool>();
  } else if (key == "return_within_s") {
    to.return_within_us = time(value, key, us_per_s, duration_s_min);
  } else {
    refuse(key, value);
  }
}

constexpr const char* an_object = R"(`{"duration_s": 60, "runs": 10}` is one)";

// Of the byte before `byte`, which is how many were read.
std::string place_of(const std::string& text, std::size_t byte) {
  const std::size_t at = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const std::size_t begin = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const auto last = text.begin() + static_cast<std::ptrdiff_t>(at);
  return "line " + std::to_string(1 + std::count(text.begin(), last, '\n')) + ", column " +
         std::to_string(begin == std::string::npos ? at + 1 : at - begin);
}

bool has(const DecisionCase& decision, PropertyOp op) {
  return std::any_of(decision.properties.begin(), decision.properties.end(),
                     [&](const sim::Property& p) { return speaks_of(p, op); });
}

}  // namespace

const std::vector<Adversary>& adversaries() {
  constexpr TimeUs often_us = 1'500'000;
  static const std::vector<Adversary> all = {
      {"bang-bang", Drive::bang_bang, Aim::anything, Noise::extreme, Ages::oldest, 0,
       "full effort in random directions, each held for a random time"},
      {"chase-fence", Drive::chase, Aim::fence, Noise::extreme, Ages::oldest, 0,
       "at the nearest boundary, with run-up, along it, or creeping up to it"},
      {"push-at-fence", Drive::push, Aim::fence, Noise::extreme, Ages::oldest, 0,
       "always at full effort at the nearest boundary; it has to be named", true},
      {"chase-robot", Drive::chase, Aim::robot, Noise::extreme, Ages::oldest, 0,
       "the same at the nearest robot"},
      {"drain", Drive::chase, Aim::charge, Noise::aimed, Ages::oldest, 0,
       "away from the site until the charge is gone"},
      {"follow-plans", Drive::plans, Aim::anything, Noise::extreme, Ages::oldest, 0,
       "honestly along plans that lead straight to places, whatever lies between"},
      {"aimed-noise", Drive::chase, Aim::anything, Noise::aimed, Ages::oldest, 0,
       "at what is nearest, which is measured farther away and slower than it is"},
      {"fresh-samples", Drive::chase, Aim::anything, Noise::aimed, Ages::fresh, 0,
       "the same with measurements of now"},
      {"unequal-samples", Drive::chase, Aim::anything, Noise::aimed, Ages::unequal, 0,
       "the same with one sense fresh and the other as old as may be"},
      {"wandering-samples", Drive::chase, Aim::anything, Noise::aimed, Ages::wandering, 0,
       "the same with any admissible ages"},
      {"drop-outs", Drive::chase, Aim::anything, Noise::aimed, Ages::oldest, often_us,
       "the same, and samples are lost or are no numbers"},
      {"lasting-errors", Drive::chase, Aim::anything, Noise::lasting, Ages::oldest, 0,
       "the same with errors and a wind that stay as they are for the whole run"},
      {"gusts", Drive::chase, Aim::anything, Noise::aimed, Ages::oldest, 0,
       "the same, and what pushes the robot drives it there, braking and at rest too", false, true},
  };
  return all;
}

const Adversary* find_adversary(const std::string& name) {
  const auto& all = adversaries();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Adversary& a) { return name == a.name; });
  return found == all.end() ? nullptr : &*found;
}

namespace {

// Some property speaks of what it aims at; else the robot would stand. And something pushes a robot
// that wind is aimed at.
bool finds_its_aim(const DecisionCase& decision, const Adversary& a) {
  const auto speaks_of = [&](PropertyOp one, PropertyOp other) {
    return has(decision, one) || has(decision, other);
  };
  if (a.aims_wind && decision.limits.disturbance_mps2 <= 0) return false;
  if (a.aim == Aim::fence) return speaks_of(PropertyOp::inside, PropertyOp::clearance);
  if (a.aim == Aim::charge) return speaks_of(PropertyOp::battery, PropertyOp::energy_to);
  if (a.aim == Aim::robot) return speaks_of(PropertyOp::distance, PropertyOp::agent_distance);
  return true;
}

}  // namespace

std::vector<const Adversary*> applicable(const DecisionCase& decision, const Scenario& scenario) {
  std::vector<const Adversary*> fit;
  for (const Adversary& a : adversaries()) {
    if (a.by_name_only || !finds_its_aim(decision, a)) continue;
    // nothing stops a robot that coasts and does not see it: no look-ahead covers that
    const bool stops_blind = decision.twist || scenario.fault_us_max;
    if (a.fault_every_us > 0 && !stops_blind) continue;
    if (a.drive == Drive::plans && decision.limits.in_space)
      continue;  // way-points are of the plane
    fit.push_back(&a);
  }
  return fit;
}

namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "`" : ", `") + name + "`";
  return list;
}

}  // namespace

std::string adversary_names() {
  std::vector<std::string> names;
  for (const Adversary& a : adversaries()) names.emplace_back(a.name);
  return listed(names);
}

bool Scenario::is_tight(const std::string& robot) const {
  return tight || std::any_of(starts.begin(), starts.end(), [&](const auto& start) {
           return start.first == robot && start.second.tight;
         });
}

Problem read_scenario(const std::string& text, Scenario& to) {
  try {
    std::vector<std::set<std::string>> keys;  // of the objects that are open
    const auto look = [&](int /*depth*/, Json::parse_event_t event, Json& parsed) {
      if (event == Json::parse_event_t::object_start) keys.emplace_back();
      if (event == Json::parse_event_t::object_end) keys.pop_back();
      if (event == Json::parse_event_t::key &&
          !keys.back().insert(parsed.get<std::string>()).second) {
        throw Unfit{"the scenario has " + parsed.dump() + " twice", "leave one of them out"};
      }
      return true;
    };
    const Json j = Json::parse(text, look);
    if (!j.is_object()) throw Unfit{"the scenario is no JSON object", an_object};
    for (const auto& [key, value] : j.items()) take(key, value, to);
  } catch (const Unfit& unfit) {
    return {unfit.message, unfit.help};
  } catch (const Json::parse_error& error) {
    return {"the scenario is no JSON: " + place_of(text, error.byte), an_object};
  } catch (const Json::exception&) {
    return {"the scenario has a number that is none", "numbers up to 1e308 work"};
  }
  return {};
}

namespace {

bool is_in(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_battery(const RobotLimits& l) {
  const double most[] = {l.battery_error, l.drive_per_m, l.idle_per_s, l.drain_per_s};
  return l.battery_age_us > 0 ||
         std::any_of(std::begin(most), std::end(most), [](double value) { return value > 0; });
}

// A place in space has three numbers, and one of the plane two; not every robot has a battery.
Problem check_starts(const Scenario& scenario, const Case& all) {
  for (const DecisionCase& d : all.decisions) {
    for (const auto& [robot, start] : scenario.starts) {
      if (std::find(d.robots.begin(), d.robots.end(), robot) == d.robots.end()) continue;
      if ((start.battery || start.tight) && !has_battery(d.limits)) {
        return {"the scenario says how full the battery of `" + robot + "` is, and `" + d.kind +
                    "` declares none",
                "leave it out, or declare `sense battery` or `energy` in the robot"};
      }
      if (!start.place || start.height_m.has_value() == d.limits.in_space) continue;
      return {"the scenario says where `" + robot + "` starts by " +
                  (d.limits.in_space ? "two numbers, and it is in space"
                                     : "three numbers, and it is in the plane"),
              d.limits.in_space ? "`\"at\": [1, 2, 3]` has its height as well"
                                : "`\"at\": [1, 2]` works"};
    }
  }
  return {};
}

// Of monitors and of recoveries.
Problem check_about(const Scenario& scenario, const Case& all) {
  std::vector<std::string> monitors, recoveries;
  for (const DecisionCase& d : all.decisions) {
    for (const MonitorCase& m : d.monitors) {
      monitors.push_back(m.name);
      if (!is_in(recoveries, m.recovery.name)) recoveries.push_back(m.recovery.name);
    }
  }
  for (const std::string& name : {scenario.about, scenario.unmet}) {
    if (name.empty() || is_in(monitors, name)) continue;
    return {"the scenario is about a monitor `" + name + "`, which does not exist",
            "there are " + listed(monitors)};
  }
  std::vector<std::string> named = scenario.not_driven_by;
  if (!scenario.driven_by.empty()) named.push_back(scenario.driven_by);
  for (const std::string& name : named) {
    if (is_in(recoveries, name)) continue;
    return {"the scenario names a recovery `" + name + "`, which no monitor has",
            "there are " + listed(recoveries)};
  }
  return {};
}

Problem check_aims(const Scenario& scenario, const Case& all) {
  const auto aimless = [&](const std::string& name, const std::string& robot) {
    return std::none_of(all.decisions.begin(), all.decisions.end(), [&](const DecisionCase& d) {
      const bool of_it =
          robot.empty() || std::find(d.robots.begin(), d.robots.end(), robot) != d.robots.end();
      return of_it && finds_its_aim(d, *find_adversary(name));
    });
  };
  auto named = scenario.adversary_of;
  if (!scenario.adversary.empty()) named.emplace_back("", scenario.adversary);
  for (const auto& [robot, name] : named) {
    // what takes no turn measures, whatever there is
    if (find_adversary(name)->by_name_only || !aimless(name, robot)) continue;
    std::vector<std::string> fit;
    for (const Adversary& a : adversaries()) {
      if (!aimless(a.name, robot)) fit.emplace_back(a.name);
    }
    const std::string of = robot.empty() ? "" : "of `" + robot + "` ";
    return {find_adversary(name)->aims_wind
                ? "`" + name + "` has nothing to push: no motion " + of + "has a `disturbance`"
                : "`" + name + "` has nothing to aim at: no property " + of + "speaks of that",
            "there are " + listed(fit)};
  }
  return {};
}

}  // namespace

Problem check_names(const Scenario& scenario, const Case& all) {
  std::vector<std::string> names;
  if (!scenario.adversary.empty()) names.push_back(scenario.adversary);
  for (const auto& [robot, name] : scenario.adversary_of) names.push_back(name);
  for (const std::string& name : names) {
    if (find_adversary(name) == nullptr) {
      return {"no adversary is called `" + name + "`", "there are " + adversary_names()};
    }
  }
  const bool no_clock = std::all_of(all.decisions.begin(), all.decisions.end(),
                                    [](const DecisionCase& d) { return d.calendar.empty(); });
  if (scenario.begins_us && no_clock) {
    return {"the scenario says when it begins, and no monitor speaks of a zone with times",
            "leave `begins` out"};
  }
  std::vector<std::string> robots;
  for (const auto& [robot, name] : scenario.adversary_of) robots.push_back(robot);
  for (const auto& [robot, start] : scenario.starts) robots.push_back(robot);
  if (Problem problem = check_about(scenario, all)) return problem;
  for (const std::string& robot : robots) {
    const bool there =
        std::any_of(all.decisions.begin(), all.decisions.end(), [&](const DecisionCase& d) {
          return std::find(d.robots.begin(), d.robots.end(), robot) != d.robots.end();
        });
    if (there) continue;
    std::vector<std::string> others;
    for (const DecisionCase& d : all.decisions) {
      others.insert(others.end(), d.robots.begin(), d.robots.end());
    }
    return {"the scenario names a robot `" + robot + "`, which does not exist",
            "there are " + listed(others)};
  }
  if (Problem problem = check_aims(scenario, all)) return problem;
  return check_starts(scenario, all);
}

}  // namespace rtac::simulate
