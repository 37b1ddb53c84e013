#include "compiler/codegen/watch_wrapper.h"

#include "compiler/codegen/signal_setters.h"
#include "compiler/codegen/watch.h"
#include "compiler/sema/dimension.h"

namespace rtac::codegen {
namespace {

using namespace ir;

class WatchWrapper {
 public:
  WatchWrapper(const Module& module, const Names& names, Code& out)
      : module_(module),
        watch_(*module.watch),
        names_(names),
        kernel_(module.name + "_monitors"),
        setters_(watch_, names, {"Monitors", "in_.", "state_."},
                 {"Monitors", "Index", "count", "step", "verdicts", "reset", "info", "state_",
                  "in_", "findings_", "verdicts_", "verdicts_state_"}),
        out_(out) {}

  void print_class() {
    out_.comment("The monitors without a robot: give what is measured, then step once a period.");
    out_.block(
        "class Monitors",
        [&](Code& body) {
          body.line("public:");
          body.block(
              "enum Index : std::size_t",
              [&](Code& list) {
                for (const PlainMonitor& m : watch_.monitors) list.line(index(m) + ",");
                list.line("count");
              },
              "};");
          body.line("Monitors();").blank();
          setters_.declare(body);
          body.blank();
          body.comment("One finding per monitor, by Index.");
          body.line("const std::array<rtac::Finding, count>& step(rtac::TimeUs now_us);");
          body.comment(
              "The same without margins and reasons, faster and with a memory of its own: call one "
              "of both.");
          body.line("const std::array<rtac::Verdict, count>& verdicts(rtac::TimeUs now_us);");
          body.comment("Starts anew; parameters keep the tightest values that they were given.");
          body.line("void reset();");
          body.line(
              "[[nodiscard]] static const std::array<rtac::PlainMonitorInfo, count>& info();");
          body.blank().line("private:");
          body.line(kernel_ + "_state state_;");
          body.line(kernel_ + "_verdicts_state verdicts_state_;");
          body.line(kernel_ + "_in in_;");
          body.line("std::array<rtac::Finding, count> findings_;");
          body.line("std::array<rtac::Verdict, count> verdicts_;");
        },
        "};");
    out_.blank();
  }

  void print_methods() {
    tables();
    out_.line("Monitors::Monitors()");
    out_.block("    : state_(), verdicts_state_(), in_(), findings_(), verdicts_()",
               [&](Code& body) {
                 setters_.first_values(body);
                 start(body);
               });
    out_.blank();
    setters_.define(out_);
    define_steps();
  }

 private:
  [[nodiscard]] std::string index(const PlainMonitor& m) const { return names_(m.name) + "_index"; }

  void tables() {
    out_.line("namespace {").blank();
    out_.block(
        "constexpr rtac::bridge::MarginUnit margin_units[] =",
        [&](Code& body) {
          body.line("{\"\", 1.0},");
          for (std::size_t k = 1; k < watch_.units.size(); ++k) {
            const Unit& u = watch_.units[k];
            const bool percent = u.dimension == sema::dims::ratio;
            body.line("{" + quoted(sema::unit_of(u.dimension)) + ", " +
                      real(percent ? Rational(u.scale * 100) : u.scale) + "},");
          }
        },
        "};");
    out_.block(
        "constexpr const char* input_names[] =",
        [&](Code& body) {
          for (std::int64_t k = 0; k < watch_clock_number(module_); ++k) body.line("\"\",");
          body.line("\"clock\",");
          for (const Channel& c : watch_.inputs) body.line(quoted(c.name) + ",");
        },
        "};");
    out_.blank().line("}  // namespace").blank();
  }

  void define_steps() {
    out_.block(
        "const std::array<rtac::Finding, Monitors::count>& Monitors::step(rtac::TimeUs "
        "now_us)",
        [&](Code& body) {
          body.line(kernel_ + "_out out;");
          body.line(kernel_ + "_step(&state_, &in_, now_us, &out);");
          body.block("for (std::size_t k = 0; k < count; ++k)", [&](Code& each) {
            each.line(
                "findings_[k] = rtac::bridge::finding_of(out.monitors[k], "
                "margin_units, input_names);");
            each.line("if (std::isinf(findings_[k].margin)) {");
            each.line("  findings_[k].unit = \"\";");
            each.line("}");
          });
          body.line("return findings_;");
        });
    out_.blank();
    out_.block(
        "const std::array<rtac::Verdict, Monitors::count>& Monitors::verdicts(rtac::TimeUs "
        "now_us)",
        [&](Code& body) {
          body.line("std::int32_t verdicts[count];");
          body.line(kernel_ + "_verdicts(&verdicts_state_, &in_, now_us, verdicts);");
          body.block("for (std::size_t k = 0; k < count; ++k)", [&](Code& each) {
            each.line("verdicts_[k] = static_cast<rtac::Verdict>(verdicts[k]);");
          });
          body.line("return verdicts_;");
        });
    out_.blank();
    define_reset();
    out_.block("const std::array<rtac::PlainMonitorInfo, Monitors::count>& Monitors::info()",
               [&](Code& body) {
                 body.block(
                     "static const std::array<rtac::PlainMonitorInfo, count> all = {",
                     [&](Code& rows) {
                       for (const PlainMonitor& m : watch_.monitors) {
                         rows.line("{" + quoted(m.name) + ", " + quoted(m.requirement_id) + ",");
                         rows.line(" " + quoted(m.requirement_text) + ",");
                         rows.line(" " + quoted(m.file) + ", " + num(m.line) + "},");
                       }
                     },
                     "}};");
                 body.line("return all;");
               });
    out_.blank();
  }
  void start(Code& body) const {
    body.line(kernel_ + "_init(&state_);");
    body.line(kernel_ + "_verdicts_init(&verdicts_state_);");
  }
  // The inputs stay, and with them the tightest values of parameters.
  void define_reset() {
    out_.block("void Monitors::reset()", [&](Code& body) { start(body); });
    out_.blank();
  }

  const Module& module_;
  const Watch& watch_;
  const Names& names_;
  const std::string kernel_;
  const SignalSetters setters_;
  Code& out_;
};

}  // namespace

void print_watch_class(const Module& module, const Names& names, Code& out) {
  WatchWrapper(module, names, out).print_class();
}
void print_watch_methods(const Module& module, const Names& names, Code& out) {
  WatchWrapper(module, names, out).print_methods();
}

}  // namespace rtac::codegen
