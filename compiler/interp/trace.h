// Traces: recorded inputs as comma-separated values.
//
//   time,open,speed,p.x,p.y,temps.0,gear      seconds; SI, a ratio of 1 is 100 %
//   0.00,true,0.5,1.0,2.0,293.5,park
//   0.01,,0.6,nan,2.0,,drive                  empty: no new sample; nan, inf: a sample of no value
//
// A path, `plan`, and the index of its next way-point, `plan.index`, which may be left out: as the
// plans of robots below.
//
// Of a robot that a decision is about there are the columns of all that its kind senses, or those
// of inputs alone. Of any other robot only the inputs count: what else is known of it is ignored.
//
//   r1.position.x,r1.position.y,r1.velocity.x,r1.velocity.y,r1.battery,r1.plan,r1.plan.index
//   1.0,2.0,0.2,0,0.95,2 2; 3 2.5,1
//
// and `r1.heading`, and `r1.present` (1 or 0) of an open fleet. A plan is its way-points in m, or
// `none`; its index is the next of them, from 0. Of a robot whose plans a decision judges the
// column of its plan may stand alone, or with its index.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/interp/csv.h"
#include "compiler/interp/decimal.h"
#include "compiler/interp/received.h"
#include "compiler/interp/trail.h"
#include "compiler/sema/spec.h"

namespace rtac::interp {

// A row of the trace, or its header, as it stands there.
struct TraceText {
  std::string text;
  std::uint64_t line = 1, offset = 0;  // where it starts
};
struct TraceError {
  std::uint64_t line = 0, column = 0;
  std::string message, help;
  TraceText row{};
  std::size_t begin = 0, end = 0;  // of what is wrong in it
};

// What a row says about one component of an input. Conditions are 0 or 1, values of an enumeration
// their index.
struct Reading {
  enum class Kind { none, unknown, number };
  Kind kind = Kind::none;  // none: no new sample
  Decimal number;
  std::shared_ptr<const ReceivedZone> zone = nullptr;           // of a zone; else null
  std::shared_ptr<const std::vector<Waypoint>> path = nullptr;  // of a path; else null
};
// What a row says about the plan of a robot.
struct PlanReading {
  Reading::Kind kind = Reading::Kind::none;  // `number`: there are way-points, or there is no plan
  std::vector<Waypoint> points;
};
// Where the readings of a robot are in those of a row; absent: its kind does not sense it.
struct RobotColumns {
  std::optional<std::size_t> position, velocity;  // of x; y follows, then z in space
  std::optional<std::size_t> heading, battery, plan_index, present;
  bool given = false;     // a decision is about it, and the trace has its columns
  bool proposes = false;  // it has that of its plan, and a decision judges plans
  bool in_space = false;
};
struct TraceRow {
  std::int64_t time_us = 0;
  std::string time;  // as written
  // Inputs and their components in the order of declaration, then what robots sense.
  std::vector<Reading> readings;
  std::vector<PlanReading> plans;  // by robot
};

class TraceReader {
 public:
  // Both outlive the reader.
  TraceReader(std::istream& in, const sema::Spec& spec);
  // The names of the columns; false: error().
  bool read_header();
  // false: the end, or error().
  bool read_row(TraceRow& row);
  [[nodiscard]] const std::optional<TraceError>& error() const { return error_; }
  // About the trace as a whole; after the header has been read.
  [[nodiscard]] TraceError error_of_all(std::string message, std::string help) const;
  // By robot; after the header has been read.
  [[nodiscard]] const std::vector<RobotColumns>& robots() const { return robots_; }

 private:
  enum class Form { input, path, quantity, truth, index, plan };
  struct Column {
    std::string name;
    Form form;
    const sema::Input* input;          // of an input
    std::optional<std::size_t> robot;  // none: an input
    std::size_t reading;               // index; of a plan that of the robot
  };
  bool fail(const CsvCell& at, std::string message, std::string help);
  bool fault(CsvReader::Result result);
  void declare_robot(std::size_t robot);
  [[nodiscard]] bool takes(std::size_t robot, bool plans) const;
  [[nodiscard]] bool is_decided(std::size_t robot) const;
  void find_robots(const std::vector<bool>& seen);
  [[nodiscard]] bool is_due(const Column& column, bool needs_a_robot) const;
  std::size_t declare(std::string name, Form form, std::size_t robot);
  bool assign(const CsvCell& cell, std::vector<bool>& seen);
  bool check_missing(const std::vector<bool>& seen);
  bool read_time(const CsvCell& cell, TraceRow& row);
  bool read_cell(const CsvCell& cell, const Column& column, TraceRow& row);
  bool read_zone(const CsvCell& cell, const Column& column, Reading& reading);
  bool read_path(const CsvCell& cell, const Column& column, TraceRow& row);
  bool read_plan(const CsvCell& cell, const Column& column, PlanReading& plan);
  [[nodiscard]] std::optional<Decimal> parse(const Column& column, std::string_view text) const;
  [[nodiscard]] std::string expected(const Column& column) const;

  CsvReader csv_;
  const sema::Spec& spec_;
  CsvRecord record_;
  std::vector<Column> declared_;
  std::size_t readings_ = 0;
  std::vector<RobotColumns> robots_;
  std::vector<const Column*> columns_;  // behind `time`
  TraceText header_;
  std::optional<std::int64_t> before_us_;
  std::optional<TraceError> error_;
};

}  // namespace rtac::interp
