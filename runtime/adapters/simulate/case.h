// What is simulated: the robots of one decision, as the manifest of `rtac sim` tells of them.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "calendar.h"
#include "rtac/decision.h"
#include "rtac/safe/claim.h"
#include "rtac/sim/crowd.h"
#include "rtac/sim/property.h"
#include "rtac/types.h"
#include "rtac/zone.h"

namespace rtac::simulate {

// What cannot be understood or done, for a person: what is wrong, and what would work.
struct Problem {
  std::string message, help;
  bool inconclusive = false;  // it is understood, and cannot be simulated
  int code = 0;               // of the diagnostic, where it is neither of the two usual ones
  explicit operator bool() const { return !message.empty(); }
};

struct Zone {
  std::string name;
  std::vector<std::int32_t> edges_mm, clearance_mm;
  std::vector<std::size_t> ring_starts;
  ZoneView view;  // of the above: a zone stays where it is
  // Of a zone with height instead: slabs over other zones.
  std::vector<SlabView> slabs;
  SolidView solid;
};

struct Recovery {
  std::string name, kind;  // a template, as the language calls it
  int zone = 0, site = 0;
  double speed_mps = 0, route_clearance_m = 0, return_clearance_m = 0, pass_gap_m = 0;
  double detour_m = 0;
  bool has_detour = false;
  TimeUs lasts_us = 0;  // as a step
  std::vector<Recovery> steps;
  double land_at_m = 0;  // of "land"
  // Of "extern", but for zone and speed; nothing: it is not checked.
  std::optional<safe::Claim> claim;
};

struct MonitorCase {
  std::string name, requirement, text, unit;
  Recovery recovery;
  // From a decision until the brake acts that the look-ahead covers, under any control; 0: it does
  // not look ahead so.
  TimeUs horizon_us = 0;
  TimeUs command_us = 0;  // the same under the commanded input (`ahead command`)
};

// A plain input that its monitors speak of.
struct Input {
  enum class Kind { truth, whole, number, choice };
  struct Component {  // SI; of a truth 0 or 1, of a choice its number
    double least = 0, most = 1, error = 0;
    double steps_per_unit = 1;               // of the grid of the kernel
    double drawn_least = 0, drawn_most = 1;  // where a seed draws it
  };
  std::string name;
  Kind kind = Kind::truth;
  std::vector<Component> components;
  std::vector<std::string> values;  // of a choice
};
// Where a property speaks of an input: a constant there is what it is, or whether it is `wanted`.
struct Mention {
  std::size_t monitor = 0;
  std::vector<std::size_t> path;  // from the root of its property
  std::size_t component = 0;      // among those of all inputs
  std::optional<double> wanted;
};

struct DecisionCase {
  std::string name, kind, advanced;
  int number = 0;  // of the kernel's functions
  bool twist = false;
  TimeUs period_us = 0;
  double standing_m = 0;  // that a robot at rest needs to spare to be kept where it is
  std::size_t plan_capacity = 0;
  int surrender_mode = 1;
  bool judges_commands = false;  // what is proposed is judged before it is sent
  RobotLimits limits;
  std::vector<std::string> robots;
  std::vector<Vec2> docks;  // by robot; empty: none
  double dock_mps = 0;      // of whom they charge, at most
  std::vector<MonitorCase> monitors;
  std::vector<sim::Property> properties;  // by monitor
  sim::Surroundings surroundings;
  std::vector<sim::AgentSetup> agents;
  std::vector<Openings> calendar;  // of the zones with times that they speak of
  // What properties say of the past of inputs is as they are for ever once so much time has passed
  // with them.
  TimeUs memory_us = 0;
  std::vector<Input> inputs;
  std::vector<Mention> mentions;
  std::vector<double> measured;  // of inputs, by component; empty: nothing is
};

struct Case {
  std::string specification, source;
  std::uint64_t hash = 0;  // of the manifest
  std::deque<Zone> zones;
  std::vector<std::vector<Vec2>> sites;
  std::vector<DecisionCase> decisions;
};

// Reads the text of a manifest; `to` is complete when there is no problem.
Problem read_manifest(const std::string& text, Case& to);

std::uint64_t hash_of(const std::string& text);

}  // namespace rtac::simulate
