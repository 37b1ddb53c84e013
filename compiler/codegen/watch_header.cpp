// The interface of the monitors without a robot: inputs, state, findings, three functions.
#include <algorithm>

#include "compiler/codegen/temporal.h"
#include "compiler/codegen/watch.h"

namespace rtac::codegen {
namespace {

using namespace ir;

class WatchHeader {
 public:
  WatchHeader(const Module& module, const Names& names, Code& out)
      : module_(module),
        watch_(*module.watch),
        names_(names),
        members_(watch_names(watch_)),
        kernel_(kernel_of_monitors(module)),
        p_(module.name),
        out_(out) {}

  void print() {
    numbers();
    if (std::none_of(module_.decisions.begin(), module_.decisions.end(), has_signals)) {
      print_watch_types(module_, out_);
    }
    inputs();
    state();
    outputs();
    functions();
  }

 private:
  void record(const std::string& name, const std::vector<std::string>& fields) {
    out_.block(
        "typedef struct " + p_ + "_" + name,
        [&](Code& body) {
          for (const std::string& field : fields) body.line(field);
        },
        "} " + p_ + "_" + name + ";");
    out_.blank();
  }
  void enumeration(const std::vector<std::string>& entries) {
    out_.block(
        "enum",
        [&](Code& body) {
          for (std::size_t i = 0; i < entries.size(); ++i) {
            body.line(entries[i] + (i + 1 < entries.size() ? "," : ""));
          }
        },
        "};");
    out_.blank();
  }

  void numbers() {
    const std::string up = upper(p_) + "_MONITORS_";
    out_.comment("Monitors without a robot, every " + num(watch_.period_us) +
                 " us, in the order of the specification.");
    std::vector<std::string> monitors;
    for (std::size_t k = 0; k < watch_.monitors.size(); ++k) {
      monitors.push_back(up + upper(names_(watch_.monitors[k].name)) + " = " +
                         num(std::int64_t(k)));
    }
    monitors.push_back(upper(p_) + "_MONITORS = " + num(std::int64_t(watch_.monitors.size())));
    enumeration(monitors);
    std::vector<std::string> inputs;
    for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
      inputs.push_back(up + "INPUT_" + upper(members_.channels[c]) + " = " +
                       num(watch_input_number(module_, c)));
    }
    if (inputs.empty()) return;
    out_.comment("Inputs, as a finding names the one that is missing.");
    enumeration(inputs);
  }

  void inputs() { record("monitors_in", watch_input_fields(kernel_)); }

  void state() {
    out_.comment("Opaque; start with _init. What each monitor remembers, " +
                 num(watch_state_bytes(watch_)) + " bytes in all.");
    record("monitors_state", state_fields(Telling::margins));
    out_.comment("The same for verdicts alone; start with _verdicts_init.");
    record("monitors_verdicts_state", state_fields(Telling::verdicts));
  }
  [[nodiscard]] std::vector<std::string> state_fields(Telling telling) const {
    std::vector<std::string> fields = {p_ + "_clock clock;", "int64_t until_us;"};
    if (keeps_due_tick(watch_, telling)) fields.emplace_back("int64_t synced_us;");
    if (keeps_due_tick(watch_, telling)) fields.emplace_back("int64_t due_us;");
    for (std::string& field : watch_memory_fields(kernel_of_monitors(module_, telling))) {
      fields.push_back(std::move(field));
    }
    return fields;
  }

  void outputs() {
    std::string units;
    for (std::size_t k = 1; k < watch_.units.size(); ++k) {
      units += ", " + num(std::int64_t(k)) + ": " + margin_unit_text(watch_.units[k]);
    }
    out_.comment(
        "One monitor in a tick. lo, hi: the margin lies between them, in millionths of its "
        "unit; infinite, +-5 * 10^17, when only truth values decide or nothing is known. No finite "
        "end is as far from 0: a greater lo is cut to less than that, a smaller one is told as "
        "infinite; hi the other way round. unit, of a "
        "finite lo: 0: of a truth value, none" +
        units + ". input: the one that is missing.");
    record("finding_of", {"int32_t verdict, reason, input, unit;", "int64_t lo, hi;"});
    record("monitors_out",
           {"int64_t tick;", p_ + "_finding_of monitors[" + upper(p_) + "_MONITORS];"});
  }

  void functions() {
    const std::string name = p_ + "_monitors";
    out_.comment(
        "Step once a period; now_us is of the clock of all stamps" +
        std::string(watch_.in_utc ? ", microseconds since 1970-01-01T00:00Z" : "") +
        ". A tick sees the newest samples; "
        "what is missing, too old, from the future or out of range is unknown. Up to 4 missed "
        "ticks count as unknown ones, more of them forget the past. A second step within a tick, "
        "or one back in time, tells nothing and changes nothing. _verdicts is the same without "
        "margins, reasons and units, in less time and with less memory: its state is its own, and "
        "a "
        "program steps one of both.");
    out_.line("void " + name + "_init(" + name + "_state *s);");
    out_.line("void " + name + "_step(" + name + "_state *s, const " + name + "_in *in,");
    out_.line(std::string(name.size() + 11, ' ') + "int64_t now_us, " + name + "_out *out);");
    out_.line("void " + name + "_verdicts_init(" + name + "_verdicts_state *s);");
    out_.line("void " + name + "_verdicts(" + name + "_verdicts_state *s,");
    out_.line(std::string(name.size() + 15, ' ') + "const " + name + "_in *in, int64_t now_us,");
    out_.line(std::string(name.size() + 15, ' ') + "int32_t verdicts[" + upper(p_) +
              "_MONITORS]);");
    out_.blank();
  }

  const Module& module_;
  const Watch& watch_;
  const Names& names_;
  const WatchNames members_;
  const WatchKernel kernel_;
  const std::string p_;
  Code& out_;
};

}  // namespace

void print_watch_header(const Module& module, const Names& names, Code& out) {
  WatchHeader(module, names, out).print();
}

}  // namespace rtac::codegen
