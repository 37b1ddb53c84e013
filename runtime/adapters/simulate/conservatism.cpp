#include "conservatism.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "oracle.h"
#include "rtac/sim/math.h"
#include "run.h"
#include "track.h"
#include "worst_path.h"

namespace rtac::simulate {
namespace {

using sim::Property;
using sim::TruthState;
using State = Tightness::State;

constexpr double us_per_s = 1e6;
// Speeds from rest to the greatest one that is certainly within the limits.
constexpr std::array speeds = {0.0, 0.5, 0.999};
constexpr std::array angles_rad = {0.0, sim::pi / 3};
constexpr int directions = 8;
constexpr int walls_max = 3;  // of those that are found
constexpr double farthest_m = 1000;

// Where a property fails for the first robot.
struct Wall {
  Vec3 at;      // its centre there
  Vec3 normal;  // unit vector, to where it is false
};

const Property* first_of(const Property& p, sim::PropertyOp op) {
  if (p.op == op) return &p;
  for (const Property& each : p.of) {
    if (const Property* const found = first_of(each, op)) return found;
  }
  return nullptr;
}

// The gap to an agent changes with a way as that to a robot does.
Property agents_as_robots(Property p) {
  if (p.op == sim::PropertyOp::agent_distance) p.op = sim::PropertyOp::distance;
  for (Property& each : p.of) each = agents_as_robots(each);
  return p;
}

class Search {
 public:
  Search(const DecisionCase& decision, const Kernel::Functions& kernel, std::size_t monitor,
         double until_s)
      : d_(decision),
        monitor_(monitor),
        property_(decision.properties[monitor]),
        oracle_(decision, kernel, 0),
        until_s_(until_s),
        metres_(1 / sim::steepness_per_m(agents_as_robots(property_))),
        agents_(decision.agents.size(), far_away),
        surroundings_(decision.surroundings) {
    surroundings_.agents = &agents_;
    for (const sim::AgentSetup& agent : decision.agents) {
      surroundings_.agent_radius_m.push_back(agent.radius_m);
      surroundings_.agent_in_space.push_back(agent.in_space);
    }
    out_.monitor = decision.monitors[monitor].name;
    out_.ahead_s = static_cast<double>(oracle_.position_age_us() + horizon_us()) / us_per_s;
  }

  Tightness run() {
    out_.why_not = unfit();
    if (out_.why_not.empty() && !find_base()) {
      out_.why_not = "no place was found where the advanced controller drives";
    }
    if (out_.why_not.empty() && !place_agent()) {
      out_.why_not = "no place was found where the agent leaves the advanced controller in charge";
    }
    if (!out_.why_not.empty()) return out_;
    const std::vector<Wall> walls = find_walls();
    for (const Wall& wall : walls) {
      for (const double speed : speeds) {
        for (const double angle : angles_rad) {
          if (speed > 0 || angle == 0) look(wall, speed, angle);
        }
      }
    }
    if (out_.states.empty()) {
      out_.why_not = out_.complete ? "no state was found that just passes" : "the time was up";
    }
    return out_;
  }

 private:
  [[nodiscard]] const MonitorCase& case_of() const { return d_.monitors[monitor_]; }
  // Under any control, or under the command that is judged.
  [[nodiscard]] TimeUs horizon_us() const {
    return commanded() ? case_of().command_us : case_of().horizon_us;
  }
  [[nodiscard]] bool commanded() const { return case_of().command_us > 0; }
  [[nodiscard]] std::string unfit() const {
    if (horizon_us() == 0) return "it does not look ahead by a duration alone";
    const auto speaks = [&](const Mention& m) { return m.monitor == monitor_; };
    if (std::any_of(d_.mentions.begin(), d_.mentions.end(), speaks)) {
      return "it depends on what inputs say";
    }
    if (!std::isfinite(metres_)) return "it speaks of more than lengths";
    if (sim::speaks_of(property_, sim::PropertyOp::count)) return "it counts robots";
    if (sim::speaks_of(property_, sim::PropertyOp::open)) return "it speaks of a zone with times";
    return not_searched(d_.limits);
  }
  [[nodiscard]] bool of_others() const {
    return sim::speaks_of(property_, sim::PropertyOp::distance);
  }

  // The agent that it speaks of first, beside the robot, and not so near that a recovery drives,
  // whose motion the look-ahead would then be of; all others stay far away.
  bool place_agent() {
    const Property* const distance = first_of(property_, sim::PropertyOp::agent_distance);
    if (distance == nullptr) return true;
    agent_ = distance->index;
    Vec3& place = agents_[static_cast<std::size_t>(agent_)];
    for (double away_m = 1; away_m < farthest_m / 2; away_m *= 1.2) {
      place = base_.front().position + Vec3{away_m, 0, 0};
      if (!agent().in_space) place.z = 0;
      oracle_.place_agents(agents_);
      if (margin_m(base_.front().position) > 0 && oracle_.settle(base_)) return true;
    }
    return false;
  }
  [[nodiscard]] const sim::AgentSetup& agent() const {
    return d_.agents[static_cast<std::size_t>(agent_)];
  }
  [[nodiscard]] double agent_age_s() const {
    return static_cast<double>(agent().age_us) / us_per_s;
  }

  // ---- the property, on true places

  [[nodiscard]] double margin_m(const std::vector<Vec3>& places) const {
    std::vector<TruthState> truths(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      truths[i].position = {places[i].x, places[i].y};
      truths[i].height_m = places[i].z;
    }
    return metres_ * margin_of(property_, scene_of(surroundings_, truths, 0));
  }
  // The first robot elsewhere, the others where they are.
  [[nodiscard]] double margin_m(Vec3 place) const {
    std::vector<Vec3> places;
    for (const Moving& robot : base_) places.push_back(robot.position);
    places.front() = place;
    return margin_m(places);
  }

  // ---- states to ask about

  // The widest of places that are drawn, among those where the advanced controller drives.
  bool find_base() {
    constexpr std::uint64_t draws = 120;
    std::vector<std::pair<double, std::vector<Moving>>> found;
    Scenario anywhere;
    for (std::uint64_t seed = 1; seed <= draws; ++seed) {
      Setup setup;
      if (make_setup(d_, anywhere, seed, setup)) return false;
      base_.clear();
      for (const RobotStart& s : setup.starts) {
        base_.push_back({{s.place.x, s.place.y, s.height_m}, {}, s.heading_rad});
      }
      found.emplace_back(least_margin(), base_);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [margin, robots] : found) {
      base_ = robots;
      if (oracle_.settle(base_)) return true;
    }
    return false;
  }
  // Of all properties.
  [[nodiscard]] double least_margin() const {
    std::vector<TruthState> truths(base_.size());
    for (std::size_t i = 0; i < base_.size(); ++i) {
      truths[i].position = {base_[i].position.x, base_[i].position.y};
      truths[i].height_m = base_[i].position.z;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Property& p : d_.properties) {
      least = std::min(least, margin_of(p, scene_of(surroundings_, truths, 0)));
    }
    return least;
  }

  [[nodiscard]] std::vector<Vec3> ways() const {
    std::vector<Vec3> all;
    for (int k = 0; k < directions; ++k) {
      const sim::SinCos turn = sim::sin_cos(2 * sim::pi * k / directions);
      all.push_back({turn.cos, turn.sin, 0});
    }
    if (d_.limits.in_space) all.insert(all.begin(), {{0, 0, 1}, {0, 0, -1}});
    if (!of_others()) return all;
    for (std::size_t j = 1; j < base_.size(); ++j) {
      const Vec3 there = base_[j].position - base_.front().position;
      if (norm(there) > 0) all.insert(all.begin(), (1 / norm(there)) * there);
    }
    return all;
  }
  // Where the property fails on the way there, and which way it falls fastest.
  [[nodiscard]] std::optional<Wall> wall(Vec3 way) const {
    const Vec3 here = base_.front().position;
    double inside = 0, outside = 0.05;
    while (margin_m(here + outside * way) >= 0) {
      inside = outside;
      outside *= 1.1;
      if (outside > farthest_m) return std::nullopt;
    }
    constexpr double near_m = 1e-7;
    while (outside - inside > near_m) {
      const double middle = (inside + outside) / 2;
      (margin_m(here + middle * way) >= 0 ? inside : outside) = middle;
    }
    const Vec3 at = here + inside * way;
    constexpr double step_m = 1e-4;
    const auto slope = [&](Vec3 axis) {
      return margin_m(at + step_m * axis) - margin_m(at - step_m * axis);
    };
    const Vec3 rise{slope({1, 0, 0}), slope({0, 1, 0}), d_.limits.in_space ? slope({0, 0, 1}) : 0};
    const double size = norm(rise);
    if (!(size > step_m / 2)) return std::nullopt;
    return Wall{at, (-1 / size) * rise};
  }
  [[nodiscard]] std::vector<Wall> find_walls() const {
    std::vector<Wall> walls;
    for (const Vec3& way : ways()) {
      const auto found = wall(way);
      constexpr double same = 1e-3;
      const bool known = std::any_of(walls.begin(), walls.end(), [&](const Wall& w) {
        return !found || norm(w.normal - found->normal) < same;
      });
      if (found && !known && walls.size() < walls_max) walls.push_back(*found);
    }
    return walls;
  }

  // The robot so far from the wall, with that speed at that angle from the normal; the one that is
  // the wall, if one is, comes to meet it.
  [[nodiscard]] std::vector<Moving> asked(const Wall& wall, double away_m, double speed_mps,
                                          double angle) const {
    std::vector<Moving> robots = base_;
    const Frame frame = frame_of(wall.at, wall.normal, {});
    const sim::SinCos turn = sim::sin_cos(angle);
    const Vec3 way = turn.cos * wall.normal + turn.sin * frame.aside;
    robots.front() = driving(robots.front(), wall.at - away_m * wall.normal, way, speed_mps);
    if (const std::size_t other = met(); other != 0) {
      robots[other] = driving(robots[other], robots[other].position, -1 * wall.normal, speed_mps);
    }
    return robots;
  }
  [[nodiscard]] static Moving driving(Moving robot, Vec3 place, Vec3 way, double speed_mps) {
    robot.position = place;
    robot.velocity = speed_mps * way;
    robot.heading_rad = sim::angle_of({way.x, way.y});
    return robot;
  }
  // The robot that the property keeps it away from: the nearest one; 0: none.
  [[nodiscard]] std::size_t met() const {
    std::size_t nearest = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t j = 1; of_others() && j < base_.size(); ++j) {
      const double m = norm(base_[j].position - base_.front().position);
      if (m >= least_m) continue;
      least_m = m;
      nearest = j;
    }
    return nearest;
  }
  // The nearest state to the wall, of those that are looked at, that passes; none: nothing does.
  std::optional<std::vector<Moving>> just_passing(const Wall& wall, double speed, double angle) {
    const double speed_mps = speed * d_.limits.speed_mps;
    oracle_.propose(proposed(wall));
    const auto passes = [&](double away_m) {
      return oracle_.passes(asked(wall, away_m, speed_mps, angle), monitor_);
    };
    constexpr int steps = 48;
    const double step_m = 2 * generous_m() / steps;
    int k = 1;
    while (k <= steps && !passes(k * step_m)) ++k;
    if (k > steps) return std::nullopt;
    double bad = (k - 1) * step_m, good = k * step_m;
    constexpr double near_m = 1e-5;  // the kernel counts in mm
    while (good - bad > near_m) {
      const double middle = (good + bad) / 2;
      (passes(middle) ? good : bad) = middle;
    }
    return asked(wall, good, speed_mps, angle);
  }
  // As hard towards the wall as it follows; a little less, for the grid.
  [[nodiscard]] Vec3 proposed(const Wall& wall) const {
    return (1 - 1e-3) * d_.limits.accel_mps2 * wall.normal;
  }
  // What no look-ahead asks for more than.
  [[nodiscard]] double generous_m() const {
    const RobotLimits& l = d_.limits;
    const double fastest = l.speed_mps + l.velocity_error_mps;
    const double brake = l.brake_mps2 - l.disturbance_mps2;
    const double one_m =
        l.position_error_m + fastest * (out_.ahead_s + fastest / (2 * brake)) * 1.5 + 0.5;
    const double heard_s = static_cast<double>(l.hears_age_us) / us_per_s;
    if (agent_ >= 0) {
      const double still_s = agent_age_s() + out_.ahead_s + fastest / brake;
      return one_m + agent().error_m + agent().radius_m + 1.5 * agent().speed_mps * still_s;
    }
    return of_others() ? 2 * (one_m + 1.5 * fastest * heard_s) : one_m;
  }

  // ---- the worst from there

  // Of the robot that asks; of another one, whose message is as old as it may be.
  [[nodiscard]] WorstPaths paths_of(const Moving& robot, Vec3 normal, bool heard) const {
    const double ahead_s = static_cast<double>(horizon_us()) / us_per_s;
    const TimeUs age_us = heard ? d_.limits.hears_age_us : oracle_.position_age_us();
    const TimeUs apart_us = heard ? 0 : oracle_.velocity_age_us() - oracle_.position_age_us();
    const double age_s = static_cast<double>(age_us) / us_per_s;
    return worst_paths(d_.limits, {robot, normal, -age_s, age_s + ahead_s,
                                   static_cast<double>(apart_us) / us_per_s, d_.period_us});
  }
  // Nothing was sent before, and the proposal acts from the decision on.
  [[nodiscard]] WorstPaths told(const Moving& robot, const Wall& wall) const {
    const auto seconds = [](TimeUs us) { return static_cast<double>(us) / us_per_s; };
    const double age_s = seconds(oracle_.position_age_us());
    return worst_paths_told(
        d_.limits,
        {robot, wall.normal, -age_s, age_s + seconds(horizon_us()),
         seconds(oracle_.velocity_age_us() - oracle_.position_age_us()), d_.period_us},
        proposed(wall));
  }
  // The least margin along a motion of the first robot, and of the one that it meets. An agent
  // comes against the normal, from as near as it may have been, until the robot stands.
  [[nodiscard]] double least_along(const std::vector<Moving>& robots, Vec3 normal,
                                   const WorstPath& path, const WorstPath* others) {
    constexpr int looks = 96;
    std::vector<Vec3> places;
    for (const Moving& robot : robots) places.push_back(robot.position);
    const double begin_s = -static_cast<double>(oracle_.position_age_us()) / us_per_s;
    const double end_s = others == nullptr ? path.end_s : std::max(path.end_s, others->end_s);
    const std::vector<Vec3> seen = agents_;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= looks; ++k) {
      const double time_s = begin_s + (end_s - begin_s) * k / looks;
      places.front() = path.at(time_s);
      if (others != nullptr) places[met()] = others->at(time_s);
      if (agent_ >= 0) come(seen, normal, std::min(time_s, path.still_s));
      least = std::min(least, margin_m(places));
    }
    agents_ = seen;
    return least;
  }
  void come(const std::vector<Vec3>& seen, Vec3 normal, double time_s) {
    const auto k = static_cast<std::size_t>(agent_);
    const double far_m = agent().error_m + agent().speed_mps * (agent_age_s() + time_s);
    agents_[k] = seen[k] - std::max(0.0, far_m) * normal;
  }
  void look(const Wall& wall, double speed, double angle) {
    if (core_seconds() > until_s_) {
      out_.complete = false;
      return;
    }
    const auto robots = just_passing(wall, speed, angle);
    if (!robots) return;
    State state;
    state.speed_mps = norm(robots->front().velocity);
    state.angle_rad = angle;
    std::vector<Vec3> seen;
    for (const Moving& robot : *robots) seen.push_back(robot.position);
    state.bound_m = margin_m(seen);
    if (!(state.bound_m > 0)) return;
    state.found_m = -std::numeric_limits<double>::infinity();
    const WorstPaths own =
        commanded() ? told(robots->front(), wall) : paths_of(robots->front(), wall.normal, false);
    WorstPaths other;
    if (met() != 0) other = paths_of((*robots)[met()], -1 * wall.normal, true);
    out_.searches += own.searches + other.searches;
    out_.failures += own.failures + other.failures;
    const auto take = [&](const WorstPath& path, const WorstPath* others) {
      const double used = state.bound_m - least_along(*robots, wall.normal, path, others);
      if (!(used > state.found_m)) return;
      state.found_m = used;
      state.by = path.by;
    };
    for (const WorstPath& path : own.paths) {
      if (met() == 0) take(path, nullptr);
      for (const WorstPath& others : other.paths) take(path, &others);
    }
    if (*state.by != '\0') out_.states.push_back(state);
  }

  const DecisionCase& d_;
  std::size_t monitor_;
  const Property& property_;
  Oracle oracle_;
  double until_s_, metres_;
  std::vector<Vec3> agents_;  // where they are seen, or are
  sim::Surroundings surroundings_;
  int agent_ = -1;  // that the property speaks of
  std::vector<Moving> base_;
  Tightness out_;
};

}  // namespace

std::vector<Tightness> measure_tightness(const DecisionCase& decision,
                                         const Kernel::Functions& kernel, double core_s) {
  std::vector<Tightness> all;
  const double begin_s = core_seconds();
  const auto count = static_cast<double>(decision.monitors.size());
  for (std::size_t m = 0; m < decision.monitors.size(); ++m) {
    const double until_s = begin_s + core_s * static_cast<double>(m + 1) / count;
    all.push_back(Search(decision, kernel, m, until_s).run());
  }
  return all;
}

std::string tightness_json(const DecisionCase& decision, const std::vector<Tightness>& all) {
  using Json = nlohmann::ordered_json;
  Json j{{"decision", decision.name}, {"monitors", Json::array()}};
  for (const Tightness& t : all) {
    Json m{{"monitor", t.monitor}};
    if (!t.why_not.empty()) m["why_not"] = t.why_not;
    m["searches"] = t.searches;
    m["failures"] = t.failures;
    m["ahead_s"] = t.ahead_s;
    m["complete"] = t.complete;
    m["states"] = Json::array();
    for (const State& s : t.states) {
      m["states"].push_back({{"speed_mps", s.speed_mps},
                             {"angle_deg", s.angle_rad * 180 / sim::pi},
                             {"bound_m", s.bound_m},
                             {"found_m", s.found_m},
                             {"by", s.by}});
    }
    j["monitors"].push_back(std::move(m));
  }
  return j.dump() + "\n";
}

}  // namespace rtac::simulate
