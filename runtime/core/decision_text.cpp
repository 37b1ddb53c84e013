#include "rtac/decision_text.h"

#include <array>

#include "text_writer.h"

namespace rtac {
namespace {

using detail::TextWriter;

constexpr double us_per_s = 1e6;  // a division rounds once: 50 ms reads 0.05 s
constexpr std::size_t field_bytes_max = 2048;

// The declared age limit and the age of the input that a reason names; -1: not known.
struct InputAge {
  TimeUs limit_us = -1, age_us = -1;
};

InputAge input_age(const DecisionRecord& record) {
  const RobotLimits* limits = record.info != nullptr ? record.info->limits : nullptr;
  switch (record.reason_input) {
    case InputField::position:
      return {limits ? limits->position_age_us : -1, record.position_age_us};
    case InputField::velocity:
      return {limits ? limits->velocity_age_us : -1, record.velocity_age_us};
    case InputField::battery:
      return {limits ? limits->battery_age_us : -1, record.battery_age_us};
    case InputField::heading:
      return {limits ? limits->heading_age_us : -1, record.heading_age_us};
    case InputField::other_robot:
    case InputField::none:
    case InputField::plan:
    case InputField::clock:
      return {};
  }
  return {};
}

// Its name in the specification, if it is a plain one.
const char* input_name(const DecisionRecord& record) {
  const int plain = static_cast<int>(record.reason_input) - first_plain_input;
  if (plain < 0) return input_text(record.reason_input);
  return record.info != nullptr && plain < record.info->input_count ? record.info->inputs[plain]
                                                                    : "?";
}

void write_input(const DecisionRecord& record, TextWriter& out) {
  out.text("input: ").text(input_name(record));
  const InputAge input = input_age(record);
  if (input.age_us < 0) return;
  if (input.limit_us >= 0 && input.age_us > input.limit_us) {
    out.text(" older than ").real(static_cast<double>(input.limit_us) / us_per_s).text(" s");
  }
}

// Its name in the specification; null when the module brings none.
const char* robot_name(const DecisionRecord& record, int robot) {
  const DecisionInfo* info = record.info;
  if (info == nullptr || info->robots == nullptr) return nullptr;
  return robot >= 0 && robot < info->robot_count ? info->robots[robot] : nullptr;
}

// By its name; by its index when it has none.
void write_robot(const DecisionRecord& record, TextWriter& out) {
  out.text(" (robot ");
  if (const char* name = robot_name(record, record.reason_other); name != nullptr) {
    out.text(name);
  } else {
    out.integer(record.reason_other);
  }
  out.put(')');
}

// A unit as the end of a name: "m", "percent", "mps".
void write_unit_word(const char* unit, TextWriter& out) {
  for (; *unit != '\0'; ++unit) {
    const char c = *unit;
    if (c == '%') out.text("percent");
    if (c == '/') out.put('p');
    if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) out.put(c);
  }
}

void write_reason(const DecisionRecord& record, TextWriter& out) {
  switch (record.reason) {
    case Reason::none:
      return;
    case Reason::margin:
      out.text("margin");
      break;
    case Reason::waypoint:
      out.text("waypoint ").integer(record.reason_index);
      break;
    case Reason::leg:
      out.text("leg ").integer(record.reason_index);
      break;
    case Reason::violated:
      out.text("violated");
      break;
    case Reason::within_error:
      out.text("within error");
      break;
    case Reason::input:
      write_input(record, out);
      break;
    case Reason::returning:
      out.text("returning");
      break;
    case Reason::starting:
      out.text("starting");
      break;
    case Reason::over_capacity:
      out.text("plan over capacity");
      break;
    case Reason::surrendered:
      out.text("surrendered");
      break;
    case Reason::tracking:
      out.text("tracking");
      break;
    case Reason::claim:
      out.text("recovery breaks its claim");
      break;
  }
  if (record.reason_other >= 0) write_robot(record, out);
}

void write_return(const DecisionRecord& record, TextWriter& out) {
  if (record.info == nullptr || record.mode == 0) return;
  if (record.info->period_us == 0) {  // nothing is handed over: the next plan is judged anew
    out.text("a plan that passes");
    return;
  }
  bool first = true;
  for (int k = 0; k < record.info->monitor_count; ++k) {
    if (!record.monitors[static_cast<std::size_t>(k)].engaged) continue;
    const MonitorInfo& monitor = record.info->monitors[k];
    if (!first) out.text("; ");
    first = false;
    out.text(monitor.name).text(": look-ahead with hysteresis holds");
    if (monitor.return_condition[0] != '\0') out.text(" and ").text(monitor.return_condition);
  }
  if (!first) return;
  if (record.reason == Reason::surrendered) {
    out.text("the advanced side goes on");
  } else if (record.lease_end_us > record.time_us) {
    out.text("its promise to stay ends");
  }
}

void comma_known(TextWriter& out, std::int64_t value, std::int64_t unknown) {
  out.put(',');
  if (value != unknown) out.integer(value);
}

const MonitorInfo* deciding(const DecisionRecord& record) {
  const int k = record.deciding_monitor;
  return k >= 0 && k < record.info->monitor_count ? &record.info->monitors[k] : nullptr;
}

bool mixes_units(const MonitorInfo& monitor) {
  return monitor.unit[0] == '\0';
}

void write_monitor(const DecisionRecord& record, int k, TextWriter& out) {
  const MonitorRecord& monitor = record.monitors[static_cast<std::size_t>(k)];
  out.put(',').text(verdict_text(monitor.now));
  out.put(',').text(verdict_text(monitor.ahead));
  out.put(',').text(verdict_text(monitor.safer));
  out.put(',').integer(monitor.engaged ? 1 : 0);
  out.put(',').real(monitor.margin);
  if (mixes_units(record.info->monitors[k])) out.put(',').text(margin_unit(record, k));
}

void write_why(const DecisionRecord& record, TextWriter& out) {
  std::array<char, field_bytes_max> field{};
  if (const MonitorInfo* monitor = deciding(record); monitor != nullptr) {
    out.put(',').csv(monitor->name).put(',').csv(monitor->requirement_id);
    out.put(',').csv(monitor->requirement_text).put(',').csv(monitor->source_file);
    out.put(',').integer(monitor->source_line);
  } else {
    out.text(",,,,,");
  }
  (void)reason_text(record, field.data(), field.size());
  out.put(',').csv(field.data());
  out.put(',').integer(static_cast<int>(record.reason)).put(',');
  if (record.reason != Reason::none) out.integer(record.reason_index);
  out.put(',').csv(record.reason_input == InputField::none ? "" : input_name(record));
  comma_known(out, record.reason_other, -1);
  out.put(',').csv(robot_name(record, record.reason_other));
  (void)return_text(record, field.data(), field.size());
  out.put(',').csv(field.data());
}

}  // namespace

const char* verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::is_false:
      return "false";
    case Verdict::is_unknown:
      return "unknown";
    case Verdict::is_true:
      return "true";
  }
  return "?";
}

const char* gate_text(Gate gate) {
  switch (gate) {
    case Gate::free:
      return "free";
    case Gate::away_only:
      return "away only";
    case Gate::hold:
      return "hold";
  }
  return "?";
}

const char* input_text(InputField field) {
  switch (field) {
    case InputField::none:
      return "none";
    case InputField::position:
      return "position";
    case InputField::velocity:
      return "velocity";
    case InputField::heading:
      return "heading";
    case InputField::battery:
      return "battery";
    case InputField::plan:
      return "plan";
    case InputField::other_robot:
      return "other robot";
    case InputField::clock:
      return "clock";
  }
  return "?";
}

const char* margin_unit(const DecisionRecord& record, int k) {
  if (record.info == nullptr || k < 0 || k >= record.info->monitor_count) return "";
  const MonitorInfo& monitor = record.info->monitors[k];
  if (!mixes_units(monitor)) return monitor.unit;
  const MarginUnit unit = record.monitors[static_cast<std::size_t>(k)].unit;
  const int number = static_cast<int>(unit);
  if (number > static_cast<int>(MarginUnit::count)) {
    return number < record.info->unit_count ? record.info->units[number].name : "";
  }
  switch (unit) {
    case MarginUnit::none:
    case MarginUnit::count:
      return "";
    case MarginUnit::metre:
      return "m";
    case MarginUnit::percent:
      return "%";
  }
  return "";
}

const char* mode_name(const DecisionRecord& record, int mode) {
  if (record.info == nullptr) return "?";
  const DecisionInfo& info = *record.info;
  if (mode == 0) return info.advanced;
  const bool on_plan = info.period_us == 0;
  if (on_plan) return mode == 1 ? info.safe : "?";
  if (mode < 0 || mode > info.monitor_count) return "?";
  return info.monitors[mode - 1].recovery;
}

std::size_t reason_text(const DecisionRecord& record, char* out, std::size_t capacity) {
  TextWriter writer(out, capacity);
  write_reason(record, writer);
  return writer.length();
}

std::size_t return_text(const DecisionRecord& record, char* out, std::size_t capacity) {
  TextWriter writer(out, capacity);
  write_return(record, writer);
  return writer.length();
}

std::size_t csv_header(const DecisionInfo& info, char* out, std::size_t capacity) {
  TextWriter writer(out, capacity);
  writer.text(
      "tick,time_us,robot,robot_name,decision,mode,mode_name,previous_mode,previous_mode_name,"
      "deciding_monitor,requirement,requirement_text,file,line,reason,reason_code,reason_index,"
      "reason_input,reason_other,reason_other_name,returns_when,gate,lease_end_us,time_to_"
      "violation_us,"
      "position_age_us,velocity_age_us,heading_age_us,battery_age_us,decision_ns");
  for (int k = 0; k < info.monitor_count; ++k) {
    const char* const name = info.monitors[k].name;
    for (const char* part : {"_now", "_ahead", "_safer", "_engaged", "_margin"}) {
      writer.put(',').text(name).text(part);
    }
    if (mixes_units(info.monitors[k])) {
      writer.put(',').text(name).text("_unit");
    } else {
      writer.put('_');
      write_unit_word(info.monitors[k].unit, writer);
    }
  }
  writer.put('\n');
  return writer.length();
}

std::size_t csv_row(const DecisionRecord& record, char* out, std::size_t capacity) {
  TextWriter writer(out, capacity);
  if (record.info == nullptr) return 0;
  writer.natural(record.tick).put(',').integer(record.time_us).put(',').integer(record.robot);
  writer.put(',').csv(robot_name(record, record.robot));
  writer.put(',').csv(record.info->decision);
  writer.put(',').integer(record.mode).put(',').csv(mode_name(record, record.mode));
  writer.put(',').integer(record.previous_mode);
  writer.put(',').csv(mode_name(record, record.previous_mode));
  write_why(record, writer);
  writer.put(',').text(gate_text(record.gate));
  comma_known(writer, record.lease_end_us, never_us);
  comma_known(writer, record.time_to_violation_us, -1);
  comma_known(writer, record.position_age_us, -1);
  comma_known(writer, record.velocity_age_us, -1);
  comma_known(writer, record.heading_age_us, -1);
  comma_known(writer, record.battery_age_us, -1);
  comma_known(writer, record.decision_ns, 0);
  for (int k = 0; k < record.info->monitor_count; ++k) write_monitor(record, k, writer);
  writer.put('\n');
  return writer.length();
}

}  // namespace rtac
