// What happens in a run: who attacks how, from where, for how long. All of it has a default.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "case.h"
#include "rtac/sim/hostile.h"

namespace rtac::simulate {

enum class Drive { chase, push, bang_bang, plans };

// A way to attack: who drives, and what it does to the senses.
struct Adversary {
  const char* name;
  Drive drive;
  sim::Aim aim;
  sim::Noise noise;
  sim::Ages ages;
  TimeUs fault_every_us;
  const char* about;
  bool by_name_only = false;  // it measures rather than attacks, and takes no turn
  bool aims_wind = false;     // so does what pushes the robots
};
const std::vector<Adversary>& adversaries();
const Adversary* find_adversary(const std::string& name);
struct Start {
  std::optional<Vec2> place;
  std::optional<double> heading_rad, battery;
  std::optional<double> height_m;  // of the place, in space
  bool tight = false;              // its battery is as empty as control is only just given
};
struct Scenario {
  using Value = std::variant<bool, double, std::string>;
  using Given = std::vector<Value>;  // by component
  TimeUs duration_us = 30'000'000;
  std::optional<TimeUs> begins_us;  // UTC; nothing: drawn, where zones have times
  std::uint64_t seed = 1, runs = 100;
  std::string adversary;                                          // empty: all in turn
  std::vector<std::pair<std::string, std::string>> adversary_of;  // robot, adversary
  std::vector<std::pair<std::string, Start>> starts;              // robot, start
  std::optional<sim::Noise> noise;
  std::optional<sim::Ages> ages;
  std::optional<TimeUs> fault_every_us, fault_us_max;
  TimeUs jitter_us = 0;
  std::string about;                       // the only monitor whose violation counts; empty: all
  std::string driven_by;                   // the only recovery whose violations count; empty: any
  std::vector<std::string> not_driven_by;  // and those whose violations do not
  std::string unmet;            // a monitor of inputs alone, which are such that it is false
  TimeUs return_within_us = 0;  // a robot that is kept so long is a finding; 0: none
  bool undecided = false;       // a command that acts longer than `about` looks ahead is a finding
  std::optional<TimeUs> deaf_from_us;                 // from then on no robot hears another one
  std::vector<std::pair<std::string, Given>> inputs;  // what they are; the others are drawn
  bool tight = false;  // robots start where control is only just given
  [[nodiscard]] bool is_tight(const std::string& robot) const;  // its battery
};
// Those that take turns: they have something to aim at, and stay within what is declared unless the
// scenario says for how long samples are lost.
std::vector<const Adversary*> applicable(const DecisionCase& decision, const Scenario& scenario);

// From the text of a scenario, a JSON object; numbers of the command line come afterwards.
Problem read_scenario(const std::string& text, Scenario& to);
// Names of adversaries and robots that do not exist.
Problem check_names(const Scenario& scenario, const Case& all);

std::string adversary_names();

}  // namespace rtac::simulate
