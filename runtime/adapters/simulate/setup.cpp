// Where robots start, and who attacks them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "field.h"
#include "rtac/sim/math.h"
#include "rtac/sim/random.h"
#include "run.h"

namespace rtac::simulate {
namespace {

using sim::Random;
using sim::TruthState;

constexpr std::uint64_t setup_stream = 3001, clock_stream = 3006;
constexpr int tries_max = 4000;
// Among so many admissible places the widest one is taken, unless one is wide enough before.
constexpr int tries_wide = 40;
constexpr double wide = 0.5;  // in scales of the margins
// How long samples are lost. A body whose speed is commanded stops by itself; one whose
// acceleration is commanded coasts on when it does not know how fast it is, and no look-ahead
// covers that.
constexpr TimeUs fault_us_twist = 1'000'000;
constexpr TimeUs fault_periods_acceleration = 3;
constexpr double battery_least = 0.3;  // at the start

// The least margin of all robots that have a place so far, or a negative one. Of a large fleet it
// is the one that was placed last for which there is none, mostly.
double least_margin(const DecisionCase& d, const std::vector<TruthState>& truths) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = truths.size(); i-- > 0;) {
    for (const sim::Property& p : d.properties) {
      least = std::min(least, margin_of(p, scene_of(d.surroundings, truths, static_cast<int>(i))));
      if (least < 0) return least;
    }
  }
  return least;
}

// What is left of a margin beyond the lengths that a robot at rest needs to spare, and of a
// distance between two robots beyond what both of them need; what is no length is there or not.
double spare(const sim::Property& p, const DecisionCase& d, const sim::Scene& scene) {
  constexpr double enough = std::numeric_limits<double>::infinity();
  if (p.op == sim::PropertyOp::logical_and) {
    double least = enough;
    for (const sim::Property& part : p.of) least = std::min(least, spare(part, d, scene));
    return least;
  }
  const double margin = margin_of(p, scene);
  const bool of_lengths =
      sim::steepness_per_m(p) > 0 || sim::speaks_of(p, sim::PropertyOp::agent_distance);
  if (!of_lengths) return margin >= 0 ? enough : margin;
  const int robots = sim::speaks_of(p, sim::PropertyOp::distance) ? 2 : 1;
  return margin - robots * d.standing_m;
}
double spare_of(const DecisionCase& d, const std::vector<TruthState>& truths, std::size_t robot) {
  const sim::Scene scene = scene_of(d.surroundings, truths, static_cast<int>(robot));
  double least = std::numeric_limits<double>::infinity();
  for (const sim::Property& p : d.properties) least = std::min(least, spare(p, d, scene));
  return least;
}
bool stand(const DecisionCase& d, const std::vector<TruthState>& truths) {
  for (std::size_t i = 0; i < truths.size(); ++i) {
    if (spare_of(d, truths, i) < 0) return false;
  }
  return true;
}

// A run begins somewhere around the moment at which a zone comes or goes, and lasts longer by what
// decisions look ahead at that.
void set_clock(const DecisionCase& d, const Scenario& scenario, Setup& to) {
  to.begins_us = scenario.begins_us.value_or(d.memory_us > 0 ? early_us + d.memory_us : 0);
  if (d.calendar.empty() || scenario.begins_us) return;
  Random random = Random::stream(to.seed, clock_stream, 0);
  to.begins_us = draw_begin(d.calendar, to.duration_us, random);
  to.duration_us += longest_lead_us(d.calendar);
}

// By mode, whether its recovery is called so.
std::vector<bool> modes_of(const DecisionCase& d, const std::vector<std::string>& recoveries) {
  std::vector<bool> modes{false};  // the advanced controller
  for (const MonitorCase& m : d.monitors) {
    modes.push_back(std::find(recoveries.begin(), recoveries.end(), m.recovery.name) !=
                    recoveries.end());
  }
  return modes;
}

const Start* named(const Scenario& scenario, const std::string& robot) {
  for (const auto& [name, start] : scenario.starts) {
    if (name == robot) return &start;
  }
  return nullptr;
}

// Where the scenario says, else anywhere.
void draw(const DecisionCase& d, const Field& field, const Start* fixed, Random& random,
          TruthState& truth) {
  truth.position = field.draw(random);
  truth.heading_rad = random.uniform(-sim::pi, sim::pi);
  truth.battery = random.uniform(battery_least, 1);
  if (d.limits.in_space) truth.height_m = field.draw_height(random);
  if (fixed == nullptr) return;
  truth.position = fixed->place.value_or(truth.position);
  if (fixed->place) truth.height_m = fixed->height_m.value_or(0);
  truth.heading_rad = fixed->heading_rad.value_or(truth.heading_rad);
  truth.battery = fixed->battery.value_or(truth.battery);
}

bool place(const DecisionCase& d, const Field& field, const Start* fixed, Random& random,
           std::vector<TruthState>& truths) {
  TruthState best;
  double best_margin = -1;
  int admissible = 0;
  truths.emplace_back();
  for (int k = 0; k < tries_max; ++k) {
    TruthState& truth = truths.back();
    draw(d, field, fixed, random, truth);
    if (fixed != nullptr && fixed->place) return true;  // as the author of the scenario wants it
    const double margin = least_margin(d, truths);
    if (margin < 0) continue;
    if (margin > best_margin && stand(d, truths)) {
      best_margin = margin;
      best = truth;
    }
    ++admissible;
    if (best_margin >= wide) break;
    if (admissible >= tries_wide && best_margin >= 0) break;
  }
  truths.back() = best;
  return best_margin >= 0;
}

// All at once, for properties that hold of nobody who is alone: somebody is near. The first places
// with enough to spare.
bool place_together(const DecisionCase& d, const Field& field, const Scenario& scenario,
                    Random& random, std::vector<TruthState>& truths) {
  // of a large fleet a look takes longer, and hardly ever finds anything
  constexpr int tries_together = 50'000, looks_most = 200'000;
  const int robots = static_cast<int>(d.robots.size());
  for (int n = 0; n < std::min(tries_together, looks_most / robots); ++n) {
    truths.assign(d.robots.size(), {});
    for (std::size_t i = 0; i < truths.size(); ++i) {
      draw(d, field, named(scenario, d.robots[i]), random, truths[i]);
    }
    if (least_margin(d, truths) >= 0 && stand(d, truths)) return true;
  }
  return false;
}

// One after the other; anew where one of them has taken the only room for two.
bool place_in_turn(const DecisionCase& d, const Field& field, const Scenario& scenario,
                   Random& random, std::vector<TruthState>& truths) {
  const int turns = d.robots.size() > 1 ? 8 : 1;
  for (int n = 0; n < turns; ++n) {
    truths.clear();
    const bool apart = std::all_of(d.robots.begin(), d.robots.end(), [&](const std::string& robot) {
      return place(d, field, named(scenario, robot), random, truths);
    });
    if (apart) return true;
  }
  return false;
}

// Where there is hardly room for all of them: one after the other goes where it has most to spare,
// some way to any place, and rather not far.
bool place_apart(const DecisionCase& d, const Field& field, const Scenario& scenario,
                 Random& random, std::vector<TruthState>& truths) {
  constexpr int rounds = 20, draws = 200;
  truths.assign(d.robots.size(), {});
  for (std::size_t i = 0; i < truths.size(); ++i) {
    draw(d, field, named(scenario, d.robots[i]), random, truths[i]);
  }
  for (int n = 0; n < rounds; ++n) {
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const Start* const fixed = named(scenario, d.robots[i]);
      if (fixed != nullptr && fixed->place) continue;
      double most = spare_of(d, truths, i);
      for (int k = 0; k < draws; ++k) {
        const TruthState before = truths[i];
        draw(d, field, fixed, random, truths[i]);
        const double share = std::pow(random.uniform(0, 1), 3);
        Vec2& at = truths[i].position;
        double& height_m = truths[i].height_m;
        at = before.position + share * (at - before.position);
        height_m = before.height_m + share * (height_m - before.height_m);
        const double left = spare_of(d, truths, i);
        if (left < most) truths[i] = before;
        most = std::max(most, left);
      }
    }
    if (stand(d, truths)) return true;
  }
  return false;
}

bool place_all(const DecisionCase& d, const Scenario& scenario, Random& random,
               std::vector<TruthState>& truths) {
  constexpr int widenings_max = 6;
  Field field(d);
  for (int n = 0; n <= widenings_max; ++n) {
    if (place_in_turn(d, field, scenario, random, truths) ||
        place_together(d, field, scenario, random, truths)) {
      return true;
    }
    if (!field.widen()) break;
  }
  constexpr std::size_t robots_most = 12;
  constexpr int turns = 8;
  const bool may_be_apart = d.robots.size() > 1 && d.robots.size() <= robots_most;
  for (int n = 0; may_be_apart && n < turns; ++n) {
    if (place_apart(d, field, scenario, random, truths)) return true;
  }
  return false;
}

}  // namespace

DecisionCase at_its_worst(const DecisionCase& decision, const Setup& setup) {
  DecisionCase d = decision;
  for (sim::Property& p : d.properties) {
    p = at_its_worst(p, d.calendar, setup.begins_us, setup.begins_us + setup.duration_us);
  }
  return d;
}

Vec2 draw_place(const DecisionCase& d, const std::vector<TruthState>& truths, int robot,
                Random& random) {
  const Field field(d);
  for (int k = 0; k < tries_max; ++k) {
    const Vec2 at = field.draw(random);
    const bool holds =
        std::all_of(d.properties.begin(), d.properties.end(), [&](const sim::Property& p) {
          return margin_of(p, {d.surroundings, truths, robot, at}) >= 0;
        });
    if (holds) return at;
  }
  return truths[static_cast<std::size_t>(robot)].position;
}

Problem make_setup(const DecisionCase& d, const Scenario& scenario, std::uint64_t seed, Setup& to) {
  const std::vector<const Adversary*> fit = applicable(d, scenario);
  to.seed = seed;
  to.duration_us = scenario.duration_us;
  set_clock(d, scenario, to);
  to.return_within_us = scenario.return_within_us;
  to.undecided = scenario.undecided;
  to.about = -1;
  for (std::size_t m = 0; m < d.monitors.size(); ++m) {
    if (d.monitors[m].name == scenario.about) to.about = static_cast<int>(m);
  }
  to.asked = {};
  if (!scenario.driven_by.empty()) to.asked.driven_by = modes_of(d, {scenario.driven_by});
  to.asked.not_driven_by = modes_of(d, scenario.not_driven_by);
  to.adversary =
      scenario.adversary.empty() ? fit[seed % fit.size()] : find_adversary(scenario.adversary);
  to.of_robot.assign(d.robots.size(), to.adversary);
  for (std::size_t i = 0; i < d.robots.size(); ++i) {
    for (const auto& [robot, name] : scenario.adversary_of) {
      if (robot == d.robots[i]) to.of_robot[i] = find_adversary(name);
    }
  }
  to.hostility = {seed,
                  to.adversary->aim,
                  scenario.noise.value_or(to.adversary->noise),
                  scenario.ages.value_or(to.adversary->ages),
                  scenario.fault_every_us.value_or(to.adversary->fault_every_us),
                  scenario.jitter_us,
                  scenario.fault_us_max.value_or(
                      d.twist ? fault_us_twist : fault_periods_acceleration * d.period_us),
                  scenario.deaf_from_us.value_or(never_us),
                  d.period_us};
  Random random = Random::stream(seed, setup_stream, 0);
  std::vector<TruthState> truths;
  if (!place_all(at_its_worst(d, to), scenario, random, truths)) {
    return {"no places were found where every property of `" + d.name +
                "` holds with what robots at rest need to spare",
            R"(say where robots start: `"starts": {")" + d.robots.front() + R"(": {"at": [1, 2)" +
                (d.limits.in_space ? ", 3" : "") + "]}}`",
            true};
  }
  for (const TruthState& t : truths) {
    to.starts.push_back({t.position, t.heading_rad, t.battery, t.height_m});
  }
  return {};
}

}  // namespace rtac::simulate
