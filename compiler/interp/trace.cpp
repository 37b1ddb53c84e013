#include "compiler/interp/trace.h"

#include <algorithm>
#include <limits>

#include "compiler/sema/suggest.h"

namespace rtac::interp {
namespace {

bool same_word(std::string_view text, std::string_view small) {
  return std::equal(text.begin(), text.end(), small.begin(), small.end(),
                    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a + 32 == b); });
}

// What programs write for a number that is none.
bool is_no_number(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  return same_word(text, "nan") || same_word(text, "inf") || same_word(text, "infinity");
}

std::string quoted(std::string_view text) {
  constexpr std::size_t shown_max = 40;
  const bool whole = text.size() <= shown_max;
  return "`" + std::string(text.substr(0, shown_max)) + (whole ? "`" : "...`");
}

std::string expected(const sema::Spec& spec, const sema::Input& input) {
  switch (input.type) {
    case sema::InputType::boolean:
      return "`true`, `false`, `1` and `0` exist";
    case sema::InputType::integer:
      return "give a whole number";
    case sema::InputType::real:
      return "give a decimal number in SI units, such as `0.25` or `-3e-2`";
    case sema::InputType::zone:
      return "give a polygon in metres, `POLYGON ((0 0, 5 0, 5 4, 0 0))`, in quotes";
    case sema::InputType::path:
      return "give the number of the way-point that is next: 0 for the first one";
    case sema::InputType::enumeration:
      break;
  }
  return "the values are " + sema::listing(spec[*input.enumeration].values);
}

std::optional<Decimal> parse_truth(std::string_view text) {
  if (text == "1" || same_word(text, "true")) return Decimal(1);
  if (text == "0" || same_word(text, "false")) return Decimal(0);
  return std::nullopt;
}

std::optional<Decimal> parse_value(const sema::Spec& spec, const sema::Input& input,
                                   std::string_view text) {
  if (input.type == sema::InputType::boolean) return parse_truth(text);
  if (input.type == sema::InputType::enumeration) {
    const auto& values = spec[*input.enumeration].values;
    const auto found = std::find(values.begin(), values.end(), text);
    if (found == values.end()) return std::nullopt;
    return Decimal(found - values.begin());
  }
  auto number = Decimal::parse(text);
  const bool fits = number && (input.type == sema::InputType::real || number->is_whole());
  return fits ? number : std::nullopt;
}

// The nearest mm. What is too far for any map is cut off: kernels know it as outside.
std::int64_t to_mm(const Decimal& metres) {
  constexpr std::int64_t far_mm = std::int64_t{1} << 40;
  const auto grid = metres.on_grid(Rational(1, 1000));
  const std::int64_t below = std::clamp(grid.lo, -far_mm, far_mm);
  if (below != grid.lo || grid.hi == grid.lo) return below;
  const Rational over = metres.value() * 1000 - Rational(static_cast<long>(below));
  return below + (over * 2 >= 1 ? 1 : 0);
}

// The next word of the text, which loses it.
std::string_view take_word(std::string_view& text) {
  constexpr const char* blanks = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

// `1 2; 3.5 2`
bool read_waypoints(std::string_view text, std::vector<Waypoint>& points) {
  for (bool more = true; more;) {
    const std::size_t end = text.find(';');
    std::string_view point = text.substr(0, end);
    more = end != std::string_view::npos;
    if (more) text.remove_prefix(end + 1);
    const auto x = Decimal::parse(take_word(point));
    const auto y = Decimal::parse(take_word(point));
    if (!x || !y || !take_word(point).empty()) return false;
    points.push_back({to_mm(*x), to_mm(*y)});
  }
  return true;
}

}  // namespace

TraceReader::TraceReader(std::istream& in, const sema::Spec& spec)
    : csv_(in), spec_(spec), robots_(spec.robots.size()) {
  for (const sema::Input& input : spec.inputs) {
    for (const std::string& component : input.components) {
      const std::string name = component.empty() ? input.name : input.name + "." + component;
      const bool is_path = input.type == sema::InputType::path && component.empty();
      const Form form = is_path ? Form::path : Form::input;
      declared_.push_back({name, form, &input, std::nullopt, readings_++});
    }
  }
  for (std::size_t r = 0; r < spec.robots.size(); ++r) declare_robot(r);
}

// What a monitor without a robot asks of a robot is an input already: both read one column.
std::size_t TraceReader::declare(std::string name, Form form, std::size_t robot) {
  for (Column& column : declared_) {
    if (column.input == nullptr || column.name != name) continue;
    column.robot = robot;
    return column.reading;
  }
  const std::size_t at = form == Form::plan ? robot : readings_++;
  declared_.push_back({std::move(name), form, nullptr, robot, at});
  return at;
}

void TraceReader::declare_robot(std::size_t robot) {
  const sema::RobotKind& kind = spec_[spec_.robots[robot].kind];
  const std::string prefix = spec_.robots[robot].name + ".";
  RobotColumns& to = robots_[robot];
  to.in_space = kind.in_space;
  const auto pair = [&](const std::string& name) {
    const std::size_t x = declare(prefix + name + ".x", Form::quantity, robot);
    declare(prefix + name + ".y", Form::quantity, robot);
    if (kind.in_space) declare(prefix + name + ".z", Form::quantity, robot);
    return x;
  };
  if (kind.position) to.position = pair("position");
  if (kind.velocity) to.velocity = pair("velocity");
  if (kind.heading) to.heading = declare(prefix + "heading", Form::quantity, robot);
  if (kind.battery) to.battery = declare(prefix + "battery", Form::quantity, robot);
  if (kind.open_fleet) to.present = declare(prefix + "present", Form::truth, robot);
  if (!kind.plan) return;
  declare(prefix + "plan", Form::plan, robot);
  to.plan_index = declare(prefix + "plan.index", Form::index, robot);
}

// A cell in quotes may hold line breaks: what stands behind them is on a later line.
bool TraceReader::fail(const CsvCell& at, std::string message, std::string help) {
  const std::size_t begin = at.column - 1;
  const std::string_view before = record_.text.substr(0, begin);
  const auto breaks = static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t line_begin = before.rfind('\n') + 1;  // 0 without one
  error_ = TraceError{record_.line + breaks,
                      begin - line_begin + 1,
                      std::move(message),
                      std::move(help),
                      {std::string(record_.text), record_.line, record_.offset},
                      begin,
                      begin + at.length};
  return false;
}

TraceError TraceReader::error_of_all(std::string message, std::string help) const {
  return {header_.line, 1, std::move(message), std::move(help), header_};
}

bool TraceReader::fault(CsvReader::Result result) {
  const CsvCell& at = record_.cells.front();
  switch (result) {
    case CsvReader::Result::unclosed_quote:
      return fail(at, "a quoted cell of this row is not closed",
                  "end it with `\"`; a quote inside of it is doubled");
    case CsvReader::Result::too_long:
      return fail(at, "the row is longer than 1 MiB", "a row is a line: end it with a line break");
    case CsvReader::Result::text_behind_quote:
      return fail(at, "text follows a quoted cell",
                  "put a comma behind the closing quote; a quote inside of a cell is doubled");
    case CsvReader::Result::unreadable:
      return fail(at, "the trace cannot be read any further", "check the medium that it is on");
    case CsvReader::Result::record:
    case CsvReader::Result::end:
      break;
  }
  return false;
}

bool TraceReader::read_header() {
  const auto result = csv_.next(record_);
  if (result == CsvReader::Result::end) {
    return fail(record_.cells.front(), "the trace is empty",
                "its first line names the columns: `time,...`");
  }
  if (result != CsvReader::Result::record) return fault(result);
  header_ = {std::string(record_.text), record_.line, record_.offset};
  for (const CsvCell& cell : record_.cells) {
    const std::size_t at = cell.text.find('\r');
    if (at == std::string_view::npos) continue;
    return fail({{}, cell.column + at}, "a carriage return does not end a line",
                "end lines with LF or CR LF");
  }
  const CsvCell& first = record_.cells.front();
  if (first.text.starts_with("time;") || first.text.starts_with("time\t")) {
    return fail({{}, first.column + 4}, "cells are separated by commas",
                "write `,` between them, and decimals with a point");
  }
  if (first.text != "time") {
    return fail(first, "the first column is " + quoted(first.text) + ", not `time`",
                "the first line names the columns: `time`, in seconds, then the inputs");
  }
  std::vector<bool> seen(declared_.size(), false);
  for (std::size_t i = 1; i < record_.cells.size(); ++i) {
    if (!assign(record_.cells[i], seen)) return false;
  }
  return check_missing(seen);
}

// Whether a decision on plans, or one with a period, is about the robot.
bool TraceReader::takes(std::size_t robot, bool plans) const {
  return std::any_of(spec_.decisions.begin(), spec_.decisions.end(), [&](const sema::Decision& d) {
    return d.on_plan == plans && d.kind == spec_.robots[robot].kind;
  });
}

bool TraceReader::is_decided(std::size_t robot) const {
  return takes(robot, false) || takes(robot, true);
}

// Which robots the columns are about. Of one without a decision all but inputs is ignored.
void TraceReader::find_robots(const std::vector<bool>& seen) {
  std::vector<bool> lacks(robots_.size(), false);
  for (std::size_t i = 0; i < declared_.size(); ++i) {
    const Column& column = declared_[i];
    if (!column.robot || !is_decided(*column.robot)) continue;
    const std::size_t robot = *column.robot;
    if (!seen[i]) lacks[robot] = true;
    const bool proposes = column.form == Form::path && takes(robot, true);
    if (!seen[i] || (column.input != nullptr && !proposes)) continue;
    const bool of_plan = proposes || column.form == Form::plan || column.form == Form::index;
    if (of_plan && takes(robot, true)) {
      robots_[robot].proposes = true;
    } else {
      robots_[robot].given = true;
    }
  }
  for (std::size_t r = 0; r < robots_.size(); ++r) {
    robots_[r].given = robots_[r].given || (is_decided(r) && !lacks[r]);
  }
}

// A robot of which there is no column, or only those of inputs, is not looked at, unless nothing
// else is; without a decision it never is.
bool TraceReader::is_due(const Column& column, bool needs_a_robot) const {
  const bool is_index = column.input != nullptr && column.form == Form::input &&
                        column.input->type == sema::InputType::path;
  if (column.input != nullptr && !is_index) return true;
  if (!column.robot || !is_decided(*column.robot)) return false;
  const RobotColumns& robot = robots_[*column.robot];
  const bool plan = column.form == Form::plan;
  if (robot.given || (plan && robot.proposes)) return true;
  const bool plans_alone = takes(*column.robot, true) && !takes(*column.robot, false);
  return needs_a_robot && (plan || !plans_alone);
}

bool TraceReader::check_missing(const std::vector<bool>& seen) {
  find_robots(seen);
  const bool needs_a_robot = spec_.watches.empty() && std::none_of(robots_.begin(), robots_.end(),
                                                                   [](const RobotColumns& r) {
                                                                     return r.given || r.proposes;
                                                                   });
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < declared_.size(); ++i) {
    if (!seen[i] && is_due(declared_[i], needs_a_robot)) missing.push_back(declared_[i].name);
  }
  if (missing.empty()) return true;
  return fail(record_.cells.back(),
              (missing.size() == 1 ? "the column " : "the columns ") + sema::listing(missing) +
                  (missing.size() == 1 ? " is missing" : " are missing"),
              "every declared input has its column; the cells of one that never arrives are empty");
}

bool TraceReader::assign(const CsvCell& cell, std::vector<bool>& seen) {
  for (std::size_t i = 0; i < declared_.size(); ++i) {
    const Column& column = declared_[i];
    if (column.name != cell.text) continue;
    if (seen[i]) {
      return fail(cell, "the column " + quoted(cell.text) + " is there twice",
                  "leave one of them out");
    }
    seen[i] = true;
    columns_.push_back(&column);
    return true;
  }
  if (cell.text == "time") {
    return fail(cell, "the column `time` is there twice", "leave one of them out");
  }
  std::vector<std::string> names;
  for (const Column& column : declared_) names.push_back(column.name);
  std::string help = sema::did_you_mean(cell.text, names, "inputs");
  if (help.back() != '?') help += "; leave out the column of anything else";
  return fail(cell, "no input is called " + quoted(cell.text), std::move(help));
}

bool TraceReader::read_row(TraceRow& row) {
  if (error_) return false;
  const auto result = csv_.next(record_);
  if (result == CsvReader::Result::end) {
    // Findings without a row look like those of a run in which nothing went wrong.
    return !before_us_ &&
           fail(record_.cells.front(), "the trace ends without a row",
                "behind the names of the columns there is a row for each time at which samples "
                "arrived; without one nothing can be judged");
  }
  if (result != CsvReader::Result::record) return fault(result);
  const std::size_t due = columns_.size() + 1;
  if (record_.cells.size() != due) {
    const bool more = record_.cells.size() > due;
    const CsvCell& at = more ? record_.cells[due] : record_.cells.back();
    return fail(at,
                "the row has " + std::to_string(record_.cells.size()) +
                    (record_.cells.size() == 1 ? " cell" : " cells") + ", the first line " +
                    std::to_string(due),
                "every row has one cell for each column; without a new sample it is empty");
  }
  if (!read_time(record_.cells.front(), row)) return false;
  row.readings.resize(readings_);
  row.plans.resize(robots_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!read_cell(record_.cells[i + 1], *columns_[i], row)) return false;
  }
  return true;
}

bool TraceReader::read_time(const CsvCell& cell, TraceRow& row) {
  static const Rational microsecond(1, 1000000);
  // Half of what the clock can count: differences of two times fit as well.
  constexpr std::int64_t far_us = std::numeric_limits<std::int64_t>::max() / 2;
  const auto time = Decimal::parse(cell.text);
  if (!time) {
    return fail(cell, quoted(cell.text) + " is no time",
                "give the time in seconds, such as `0.25`");
  }
  row.time_us = time->on_grid(microsecond).lo;
  row.time.assign(cell.text);
  if (row.time_us > far_us || row.time_us < -far_us) {
    return fail(cell, "the time " + quoted(cell.text) + " is out of range",
                "times are at most " + std::to_string(far_us / 1000000) + " seconds");
  }
  if (before_us_ && row.time_us <= *before_us_) {
    return fail(cell, "the time " + quoted(cell.text) + " is not after that of the row before",
                "sort the rows by time; two rows are at least 1 us apart");
  }
  before_us_ = row.time_us;
  return true;
}

std::optional<Decimal> TraceReader::parse(const Column& column, std::string_view text) const {
  if (column.input != nullptr) return parse_value(spec_, *column.input, text);
  if (column.form == Form::truth) return parse_truth(text);
  auto number = Decimal::parse(text);
  const bool fits = number && (column.form != Form::index || number->is_whole());
  return fits ? number : std::nullopt;
}

std::string TraceReader::expected(const Column& column) const {
  switch (column.form) {
    case Form::input:
      return interp::expected(spec_, *column.input);
    case Form::quantity:
      return "give a decimal number in SI units, such as `0.25` or `-3e-2`";
    case Form::truth:
      return "`true`, `false`, `1` and `0` exist";
    case Form::index:
      return "give the number of the way-point that is next: 0 for the first one";
    case Form::path:
    case Form::plan:
      break;
  }
  return "give way-points in metres, `1 2; 3.5 2`, or `none`";
}

bool TraceReader::read_cell(const CsvCell& cell, const Column& column, TraceRow& row) {
  if (column.form == Form::plan) return read_plan(cell, column, row.plans[column.reading]);
  Reading& reading = row.readings[column.reading];
  reading.kind = Reading::Kind::none;
  reading.zone = nullptr;
  reading.path = nullptr;
  if (column.form == Form::path) return read_path(cell, column, row);
  if (cell.text.empty()) return true;
  if (column.input != nullptr && column.input->type == sema::InputType::zone) {
    return read_zone(cell, column, reading);
  }
  if (auto number = parse(column, cell.text)) {
    reading.kind = Reading::Kind::number;
    reading.number = std::move(*number);
    return true;
  }
  if (is_no_number(cell.text)) {
    reading.kind = Reading::Kind::unknown;
    return true;
  }
  // `NULL`, `N/A`, `-`: how others write that there is nothing
  const bool is_word = cell.text.find_first_of("0123456789") == std::string_view::npos;
  return fail(cell, quoted(cell.text) + " is no value of `" + column.name + "`",
              expected(column) + (is_word ? "; an empty cell is no new sample, `nan` is one that "
                                            "has no value"
                                          : ""));
}

// What a robot would refuse is no trace of it.
bool TraceReader::read_zone(const CsvCell& cell, const Column& column, Reading& reading) {
  const auto refused = [&](const geometry::RefusedZone& why) {
    return fail(cell, "`" + column.name + "` is refused: " + why.where + ": " + why.message,
                why.help);
  };
  const std::size_t edges_most = column.input->edges_most;
  auto received = geometry::receive_wkt(std::string(cell.text), edges_most);
  if (const auto* why = std::get_if<geometry::RefusedZone>(&received)) return refused(*why);
  auto& regions = std::get<geometry::ReceivedRegions>(received);
  auto made = geometry::make_zone_tables(regions, edges_most);
  if (const auto* why = std::get_if<geometry::RefusedZone>(&made)) return refused(*why);
  reading.kind = Reading::Kind::number;
  reading.number = Decimal(1);
  reading.zone = std::make_shared<const ReceivedZone>(
      ReceivedZone{std::move(regions), std::move(std::get<geometry::ZoneTables>(made))});
  return true;
}

// An input, and perhaps the plan of a robot as well. With more way-points than are declared it has
// no value.
bool TraceReader::read_path(const CsvCell& cell, const Column& column, TraceRow& row) {
  PlanReading plan;
  if (!read_plan(cell, column, plan)) return false;
  if (column.robot) row.plans[*column.robot] = plan;
  Reading& reading = row.readings[column.reading];
  const bool fits = plan.points.size() <= column.input->places_most;
  reading.kind = fits ? plan.kind : Reading::Kind::unknown;
  reading.number = Decimal(1);
  if (reading.kind != Reading::Kind::number) return true;
  reading.path = std::make_shared<const std::vector<Waypoint>>(std::move(plan.points));
  return true;
}

bool TraceReader::read_plan(const CsvCell& cell, const Column& column, PlanReading& plan) {
  plan.points.clear();
  plan.kind = Reading::Kind::none;
  if (cell.text.empty()) return true;
  plan.kind = Reading::Kind::number;
  if (same_word(cell.text, "none")) return true;
  if (is_no_number(cell.text)) {
    plan.kind = Reading::Kind::unknown;
    return true;
  }
  if (read_waypoints(cell.text, plan.points)) return true;
  // `NULL`, `N/A`, `-`: how others write that there is nothing
  const bool is_word = cell.text.find_first_of("0123456789") == std::string_view::npos;
  return fail(cell, quoted(cell.text) + " is no value of `" + column.name + "`",
              expected(column) + (is_word ? "; an empty cell is no new sample, `nan` is one that "
                                            "has no value"
                                          : ""));
}

}  // namespace rtac::interp
