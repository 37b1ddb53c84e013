// The switching protocol of a decision as a model in Promela, for `spin`: what kernel and plan
// executor do in a tick, everything that may happen to them, and what is claimed of all runs. What
// is left out, and why that is sound: compiler/docs/protocol.md.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace rtac::protocol {

// A decision, as far as the protocol goes.
struct Monitor {
  std::string name, recovery;
  std::string about;             // for people: its requirement, and where it is written
  std::int64_t ahead_ticks = 1;  // of its look-ahead, the one in which it fails included
  bool asks = false;             // it has a `return when`
};
struct Subject {
  std::string decision, robot;
  std::string advanced, safe;  // controllers; `safe`: on a plan
  bool on_plan = false;        // then what follows plays no part, but for the monitors
  std::int64_t period_us = 0, dwell_ticks = 0;
  bool promises = false;           // robots promise each other to stay
  std::int64_t surrenders_to = 1;  // who drives when control is given up: 1 + index of a monitor
  std::vector<Monitor> monitors;   // highest first
  // What the recovery of a row is shown to keep of a column; 2: its own monitor. By that it
  // coordinates, or a recovery drives on; empty: none does.
  bool coordinated = false;
  std::vector<std::vector<int>> shown;
};

// What is known of the recoveries, when nothing comes from outside. A row is the recovery of a
// monitor, a column a monitor, both by priority.
using Table = std::vector<std::vector<bool>>;
struct Arbitration {
  Table keeps;    // while recovery i drives, monitor j does not engage
  Table settles;  // where recovery i may return, the derived return condition of j holds
};
// "110 111 111", and back; of something else: no rows.
std::string text_of(const Table& table);
Table table_of(const std::string& text);

// The parts follow each other in one file.
struct Model {
  std::string decision;     // its name
  std::string rules;        // numbers, names, and what a tick does with what it finds
  std::string environment;  // what it may find
  std::string claims;       // formulas of linear temporal logic
  std::vector<std::string> claim_names;
  std::size_t monitors = 0;  // how many there are
  bool coordinated = false;  // by what recoveries keep, in the place of a priority
  [[nodiscard]] std::string text() const { return rules + environment + claims; }
};

// `source`: name of the specification's file. The decision may be one `on plan`, too; it remembers
// nothing, and `arbitration` plays no part.
Model protocol_model(const Subject& subject, const Arbitration& arbitration,
                     const std::string& source);

// What a model checker says of one claim.
struct Answer {
  enum class Kind { holds, broken, unknown } kind = Kind::unknown;
  std::string claim;
  std::string why{};  // unknown: what went wrong
  // broken: the recoveries that drive in turn for ever, by name; empty where no short run shows
  // them
  std::set<std::string> drivers{};
};
using CheckModel = std::function<std::vector<Answer>(const Model&)>;

}  // namespace rtac::protocol
