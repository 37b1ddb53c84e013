// What was derived for monitors without a robot, and for the inputs and parameters of all monitors.
#include <utility>

#include "compiler/codegen/watch.h"
#include "compiler/driver/explain_line.h"
#include "compiler/driver/explain_property.h"
#include "compiler/driver/explain_text.h"
#include "compiler/ir/source_text.h"
#include "compiler/sema/dimension.h"

namespace rtac::driver {
namespace {

using namespace ir;

// Bytes in the kernel's struct of one scalar (two ends, stamp, flag), of a stamp in its state, and
// of a parameter in both.
constexpr std::size_t signal_bytes = 32;
constexpr std::size_t stamp_bytes = 8;
// Of a zone that is received, its numbers and what points to its tables.
constexpr std::size_t zone_bytes = 160;
constexpr std::size_t param_bytes = 8;

class WatchRemarks {
 public:
  // `watch`: the monitors without a robot, or the facts of a decision.
  // `place` is said of its inputs and parameters.
  WatchRemarks(const Compilation& c, const Watch& watch, std::string place = {})
      : c_(c), spec_(*c.spec), watch_(watch), place_(std::move(place)) {}

  // Of the whole specification.
  void declarations() {
    for (const sema::MarginScale& s : spec_.scales) scale(s);
    for (const sema::Enumeration& e : spec_.enumerations) enumeration(e);
    for (const sema::Assumption& a : spec_.assumptions) assumption(a);
  }
  void signals() {
    for (const ir::Channel& each : watch_.inputs) input(spec_.inputs[each.declared], each);
    for (const ir::Param& each : watch_.params) param(spec_.params[each.declared], each);
  }
  void monitors() {
    regions();
    if (spec_.period) period(*spec_.period);
    for (std::size_t k = 0; k < spec_.watches.size(); ++k) {
      monitor(spec_.watches[k], watch_.monitors[k]);
    }
  }
  std::vector<Remark> take() { return std::move(out_); }

 private:
  void add(const SourceRange& source, std::string text, std::vector<std::string> details) {
    out_.push_back({source, std::move(text), std::move(details)});
  }

  void period(const sema::Quantity& q) {
    add(q.range, "period of the monitors without a robot: " + sema::show(q.value, sema::dims::time),
        {count(watch_.monitors.size(), "monitor"),
         "state: " + std::to_string(codegen::watch_state_bytes(watch_)) + " bytes in all, " +
             std::to_string(codegen::watch_state_bytes(watch_, codegen::Telling::verdicts)) +
             " for verdicts alone" +
             (watch_.regions.empty()
                  ? ""
                  : ", tables of zones: " + std::to_string(codegen::table_bytes(watch_)))});
  }
  void regions() {
    for (const sema::Zone& z : spec_.zones) {
      for (const ir::Region& r : watch_.regions) {
        if (z.name.empty() || z.name != r.name || r.channel) continue;
        add(z.name_range, r.around ? "around zone " + r.name : "zone " + r.name,
            {count(r.edges.size(), "edge") + (r.around ? " around it" : " within it") +
                 ", snapped to the mm",
             edges_checked(r.edges.size(), r.tree),
             "tables: " + std::to_string(codegen::region_bytes(r)) + " bytes"});
      }
    }
  }
  void scale(const sema::MarginScale& s) {
    add(s.value.range, "scale of margins: " + sema::show(s.value.value, s.dimension),
        {"margins of this dimension are counted in millionths of it"});
  }
  void enumeration(const sema::Enumeration& e) {
    std::string values;
    for (std::size_t i = 0; i < e.values.size(); ++i) {
      values += (i > 0 ? ", " : "") + std::to_string(i) + " " + e.values[i];
    }
    add(e.name_range, "enum " + e.name, {"values in the kernel: " + values});
  }

  std::string type_of(const sema::Input& input) const {
    switch (input.type) {
      case sema::InputType::boolean:
        return "bool";
      case sema::InputType::integer:
        return "int";
      case sema::InputType::enumeration:
        return spec_[*input.enumeration].name;
      case sema::InputType::zone:
        return "zone[" + std::to_string(input.edges_most) + "]";
      case sema::InputType::path:
        return "path[" + std::to_string(input.places_most) + "]";
      case sema::InputType::real:
        break;
    }
    return real_type(input.dimension);
  }
  static std::string arrival(const Channel& c) {
    if (c.held) return "assumed: the last value holds for ever";
    if (!c.max_age_us) return "a tick without a new sample is unknown";
    return "a sample counts for " +
           sema::show(Rational(static_cast<long>(*c.max_age_us), 1'000'000), sema::dims::time);
  }
  static std::size_t input_bytes(const Channel& c, std::size_t parts) {
    if (c.kind == ChannelKind::path) return signal_bytes + 16 * std::size_t{c.places_most};
    return signal_bytes * parts + (c.kind == ChannelKind::zone ? zone_bytes : 0);
  }
  void input(const sema::Input& from, const Channel& to) {
    std::vector<std::string> details;
    if (to.kind == ChannelKind::number) {
      numbers("", to, details);
      if (to.turning) numbers(from.components.back() + " ", *to.turning, details);
    }
    if (to.kind == ChannelKind::zone) {
      details.push_back("tables: at most " + std::to_string(codegen::received_bytes(to)) +
                        " bytes, which the application keeps while they are checked");
    }
    details.push_back(arrival(to));
    const bool is_path = to.kind == ChannelKind::path;
    const std::size_t parts = is_path ? 1 : from.components.size();
    details.push_back("bytes: " + std::to_string(input_bytes(to, parts)) + " of input, " +
                      std::to_string(stamp_bytes) + " of state");
    add(from.name_range,
        "input " + from.name + " : " + type_of(from) +
            (parts > 1 ? ", " + count(parts, "component") : "") + place_,
        std::move(details));
  }
  static void numbers(const std::string& part, const ChannelGrid& of,
                      std::vector<std::string>& to) {
    to.push_back(part + "range: " + shown(of.range, of.unit) +
                 (of.range.declared ? "" : ", by default") + "; outside is unknown");
    to.push_back(part + grid(of.unit));
    to.push_back(part + "rounding: outward, to the steps below and above the measurement");
    to.push_back(part + wide(exact_width(of), of.unit));
  }
  static Rational exact_width(const ChannelGrid& c) {
    return Rational(static_cast<long>(2 * c.error_steps + 1));
  }
  void param(const sema::Param& from, const Param& to) {
    const char* const moves = to.tightens > 0   ? "may only grow at run time"
                              : to.tightens < 0 ? "may only shrink at run time"
                                                : "stays as it is";
    add(from.name_range, "param " + from.name + " : " + real_type(from.dimension) + place_,
        {"range: " + shown(to.range, to.unit),
         "at first " + shown(to.value, to.unit, true) + ", " + moves, grid(to.unit),
         "bytes: " + std::to_string(param_bytes) + " of input, " + std::to_string(param_bytes) +
             " of state"});
  }
  void assumption(const sema::Assumption& a) {
    add(a.range, "assumed: " + ir::one_line(a.text),
        {a.checked_by.empty() ? "unchecked: " + a.reason : "checked by monitor " + a.checked_by});
  }

  // ---- monitors

  void monitor(const sema::Watch& from, const PlainMonitor& to) {
    const std::string id = to.requirement_id.empty() ? "" : to.requirement_id + ": ";
    add(from.range, "monitor " + to.name,
        {id + to.requirement_text, properties_.rounding(to),
         count(to.property.values.size(), "operation") + " a tick",
         "remembers " + count(static_cast<std::size_t>(codegen::watch_monitor_bytes(to)), "byte")});
    properties_.expressions(*from.always, from.range, to.name, to.property);
  }

  const Compilation& c_;
  const sema::Spec& spec_;
  const Watch& watch_;
  const std::string place_;
  std::vector<Remark> out_;
  PropertyRemarks properties_{c_, watch_, nullptr, out_};
};

}  // namespace

std::vector<Remark> watch_remarks(const Compilation& c) {
  std::vector<Remark> all;
  const auto append = [&](std::vector<Remark> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  };
  const Watch none;
  WatchRemarks declared(c, none);
  declared.declarations();
  append(declared.take());
  if (c.module->watch) {
    WatchRemarks plain(c, *c.module->watch);
    plain.signals();
    plain.monitors();
    append(plain.take());
  }
  for (const Decision& d : c.module->decisions) {
    WatchRemarks facts(c, d.facts, ", of decision " + d.name);
    facts.signals();
    append(facts.take());
  }
  return all;
}

}  // namespace rtac::driver
