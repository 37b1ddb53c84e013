#include "tighten.h"

#include <algorithm>
#include <optional>
#include <string>

#include "oracle.h"

namespace rtac::simulate {
namespace {

constexpr int halvings = 12;
// Of a large fleet, only so many batteries: the others do not matter to them.
constexpr std::size_t robots_max = 8;

bool speaks(const DecisionCase& d, sim::PropertyOp op) {
  return std::any_of(d.properties.begin(), d.properties.end(),
                     [&](const sim::Property& p) { return speaks_of(p, op); });
}

// The last of `robots` for which control is given, on the way of `change` from 0 to 1.
template <class Change>
void go_on(Oracle& oracle, std::vector<Moving>& robots, const Change& change) {
  if (!oracle.settle(robots)) return;
  const std::vector<Moving> before = robots;
  double good = 0, bad = 1;
  for (int k = 0; k < halvings; ++k) {
    const double share = (good + bad) / 2;
    std::vector<Moving> next = before;
    change(next, share);
    if (oracle.settle(next)) {
      good = share;
      robots = std::move(next);
    } else {
      bad = share;
    }
  }
}

std::vector<Moving> at_rest(const Setup& setup) {
  std::vector<Moving> robots;
  for (const RobotStart& s : setup.starts) {
    robots.push_back({{s.place.x, s.place.y, s.height_m}, {}, s.heading_rad, s.battery});
  }
  return robots;
}

// Where nothing depends on it, any.
std::optional<TimeUs> clock_of(const DecisionCase& d, const Setup& setup) {
  return d.calendar.empty() ? std::nullopt : std::optional<TimeUs>(setup.begins_us);
}

bool is_given(const Scenario& scenario, const std::string& robot) {
  return std::any_of(scenario.starts.begin(), scenario.starts.end(), [&](const auto& start) {
    return start.first == robot && start.second.battery.has_value();
  });
}

}  // namespace

void charge(const DecisionCase& d, const Kernel::Functions& kernel, const Scenario& scenario,
            Setup& setup) {
  constexpr int steps = 8;
  std::vector<Moving> robots = at_rest(setup);
  for (std::size_t m = 0; m < d.properties.size(); ++m) {
    if (!speaks_of(d.properties[m], sim::PropertyOp::energy_to)) continue;
    for (std::size_t i = 0; i < std::min(robots.size(), robots_max); ++i) {
      if (is_given(scenario, d.robots[i])) continue;
      Oracle oracle(d, kernel, static_cast<int>(i), clock_of(d, setup));
      const double drawn = robots[i].battery;
      for (int k = 0; k <= steps && !oracle.holds(robots, m); ++k) {
        robots[i].battery = drawn + (1 - drawn) * k / steps;
      }
      // no charge is enough there
      if (!oracle.holds(robots, m)) robots[i].battery = drawn;
      setup.starts[i].battery = robots[i].battery;
    }
  }
}

void tighten(const DecisionCase& d, const Kernel::Functions& kernel, const Scenario& scenario,
             Setup& setup) {
  std::vector<Moving> robots = at_rest(setup);
  if (scenario.tight && robots.size() > 1 && speaks(d, sim::PropertyOp::distance)) {
    Oracle oracle(d, kernel, 0, clock_of(d, setup));
    const Vec3 from = robots[0].position, way = robots[1].position - from;
    go_on(oracle, robots,
          [&](std::vector<Moving>& next, double share) { next[0].position = from + share * way; });
  }
  const bool charge = speaks(d, sim::PropertyOp::battery) || speaks(d, sim::PropertyOp::energy_to);
  for (std::size_t i = 0; charge && i < std::min(robots.size(), robots_max); ++i) {
    if (!scenario.is_tight(d.robots[i])) continue;
    Oracle oracle(d, kernel, static_cast<int>(i), clock_of(d, setup));
    const double full = robots[i].battery;
    go_on(oracle, robots,
          [&](std::vector<Moving>& next, double share) { next[i].battery = (1 - share) * full; });
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    setup.starts[i].place = {robots[i].position.x, robots[i].position.y};
    setup.starts[i].height_m = robots[i].position.z;
    setup.starts[i].battery = robots[i].battery;
  }
}

}  // namespace rtac::simulate
