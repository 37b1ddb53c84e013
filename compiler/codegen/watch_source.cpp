// The step of the monitors without a robot: the tick, its inputs, one function per monitor.
#include <algorithm>
#include <functional>
#include <vector>

#include "compiler/codegen/repeat_printer.h"
#include "compiler/codegen/repeats.h"
#include "compiler/codegen/watch.h"
#include "compiler/codegen/watch_look.h"
#include "compiler/codegen/watch_values.h"
#include "compiler/codegen/watch_verdicts.h"

namespace rtac::codegen {
namespace {

using namespace ir;

std::string requirement(const PlainMonitor& m) {
  const std::string what =
      m.requirement_id.empty() ? m.requirement_text : m.requirement_id + ": " + m.requirement_text;
  return (what.empty() ? m.name : what) + " (" + m.file + ":" + num(m.line) + "). " + m.text;
}

class WatchSource {
 public:
  WatchSource(const Module& module, const Names& names, Telling telling,
              std::set<std::string>& uses, Code& out)
      : module_(module),
        watch_(*module.watch),
        names_(names),
        p_(module.name),
        up_(upper(p_)),
        look_(kernel_of_monitors(module, telling), uses, out),
        side_(look_.kernel()),
        uses_(uses),
        out_(out) {}

  void print() {
    look_.view();
    for (const PlainMonitor& m : watch_.monitors) monitor(m);
    look_.channels();
    if (has_past(watch_, side_.telling)) {
      look_.blind();
      catch_up();
    }
    resume();
    begin();
    init();
    side_.is_full() ? step() : verdicts();
  }

 private:
  [[nodiscard]] const std::string& view() const { return look_.view_type(); }
  [[nodiscard]] std::string clock() const { return up_ + "_INPUT_CLOCK"; }
  [[nodiscard]] std::string monitors() const { return up_ + "_MONITORS"; }
  [[nodiscard]] std::string function_of(const PlainMonitor& m) const {
    return names_(m.name) + (side_.is_full() ? "_now" : "_verdict");
  }

  void monitor(const PlainMonitor& m) {
    const Repeats found = find_repeats(module_, m.property);
    RepeatPrinter repeats(side_, m.property, found, names_(m.name), function_of(m), uses_);
    side_.is_full() ? margins(m, repeats) : verdicts(m, repeats);
  }
  void margins(const PlainMonitor& m, RepeatPrinter& repeats) {
    repeats.print(
        [&](const Repeated& repeated, Code& each) {
          WatchValuePrinter values(side_, look_.members(), uses_);
          values.take_as_given(repeated.arguments);
          return look_.property(repeated.block, values, each);
        },
        out_);
    out_.comment(requirement(m));
    WatchValuePrinter values(side_, look_.members(), uses_);
    Code body;
    const bool sees = look_.property(m.property, values, body, &repeats);
    judge(m, "margin", sees, std::move(body));
  }
  void verdicts(const PlainMonitor& m, RepeatPrinter& repeats) {
    repeats.print(
        [&](const Repeated& repeated, Code& each) {
          VerdictBody body = repeated_bits(side_, look_.members(), repeated, uses_);
          each.append(std::move(body.lines));
          return body.looks;
        },
        out_);
    VerdictBody body =
        verdict_body(side_, look_.members(), m.property, up_ + "_VERDICT_", uses_, &repeats);
    out_.comment(m.text);
    judge(m, "int32_t", body.looks, std::move(body.lines));
  }
  void judge(const PlainMonitor& m, const std::string& result, bool sees, Code body) {
    out_.block("static inline " + result + " " + function_of(m) + "(const " + view() + " *v)",
               [&](Code& to) {
                 if (!sees) to.line("(void)v;");
                 to.append(std::move(body));
               });
    out_.blank();
  }

  void catch_up() {
    const std::string most = num(missed_ticks_max);
    out_.comment("Ticks that were missed saw nothing. Beyond " + most +
                 " of them the past is forgotten.");
    look_.function("static void " + side_.functions + "_catch_up",
                   {side_.state + " *s", "int64_t missed"}, [&](Code& body) {
                     body.line(view() + " v;").line("int64_t k;");
                     body.block("if (missed > " + most + ")", [&](Code& gap) {
                       look_.forget("s->", "s->clock.tick", gap);
                       gap.line("return;");
                     });
                     body.line(side_.functions + "_blind(&v, s);");
                     body.block("for (k = 0; k < missed; ++k)", [&](Code& each) {
                       for (const PlainMonitor& m : watch_.monitors) {
                         if (remembers(m)) each.line("(void)" + function_of(m) + "(&v);");
                       }
                       look_.next_tick("s->", each);
                     });
                   });
    out_.blank();
  }

  // What happens at the first tick, and at all that do not follow the one before.
  void resume() {
    uses_.insert({"next_tick", "tick_until"});
    out_.comment("A tick that does not follow the last one; 0: there is none since then.");
    std::vector<std::string> parameters = {side_.state + " *s", "int64_t now_us"};
    if (each_tick()) parameters.emplace_back("int64_t *since_us");
    look_.function("static int32_t " + side_.functions + "_resume", parameters, [&](Code& body) {
      const std::string period = num(watch_.period_us);
      if (each_tick()) body.line("const int32_t first = s->clock.started == 0;");
      body.line("const int64_t elapsed = next_tick(&s->clock, now_us, " + period + ", INT64_MAX);");
      body.block("if (elapsed < 1)", [&](Code& none) { none.line("return 0;"); });
      body.line("s->until_us = tick_until(&s->clock, " + period + ");");
      if (has_past(watch_, side_.telling)) {
        body.block("if (elapsed > 1)",
                   [&](Code& gap) { gap.line(side_.functions + "_catch_up(s, elapsed - 1);"); });
      }
      if (each_tick()) {
        uses_.insert("before");
        body.line("*since_us = first || elapsed > 1 ? before(now_us, " + period +
                  ") : s->judged_us;");
      }
      body.line("return 1;");
    });
    out_.blank();
  }
  [[nodiscard]] bool each_tick() const { return arrives_each_tick(watch_); }
  [[nodiscard]] bool asks_for_inputs() const {
    return params_move() ||
           std::any_of(watch_.monitors.begin(), watch_.monitors.end(),
                       [&](const PlainMonitor& m) { return !channels_of(watch_, m).empty(); });
  }
  [[nodiscard]] bool params_move() const {
    return std::any_of(watch_.params.begin(), watch_.params.end(),
                       [](const Param& param) { return param.tightens != 0; });
  }

  void begin() {
    uses_.insert("tick_follows");
    out_.comment("Which tick has come; 0: there is none since the last step.");
    std::vector<std::string> parameters = {view() + " *v", side_.state + " *s"};
    if (params_move()) parameters.push_back("const " + p_ + "_monitors_in *in");
    parameters.emplace_back("int64_t now_us");
    look_.function("static inline int32_t " + side_.functions + "_begin", parameters,
                   [&](Code& body) {
                     if (each_tick()) body.line("int64_t since_us = s->judged_us;");
                     body.line("int32_t begun = tick_follows(&s->clock, &s->until_us, now_us, " +
                               num(watch_.period_us) + ");");
                     body.block("if (begun == 0)", [&](Code& late) {
                       late.line("begun = " + side_.functions + "_resume(s, now_us" +
                                 (each_tick() ? ", &since_us" : "") + ");");
                     });
                     body.block("if (begun == 0)", [](Code& none) { none.line("return 0;"); });
                     body.line("v->s = s;");
                     body.line("v->now_us = now_us;");
                     look_.schedules(body);
                     if (each_tick()) {
                       body.line("v->since_us = since_us;");
                       body.line("s->judged_us = now_us;");
                     }
                     look_.params("v->s->", "in->", body);
                     body.line("return 1;");
                   });
    out_.blank();
  }

  void init() {
    const std::string name =
        p_ + (side_.is_full() ? "_monitors_init(" : "_monitors_verdicts_init(");
    out_.block("void " + name + side_.state + " *s)", [&](Code& body) {
      body.line("s->clock.started = 0;");
      body.line("s->clock.origin_us = 0;");
      body.line("s->clock.last_us = 0;");
      body.line("s->clock.tick = 0;");
      body.line("s->until_us = INT64_MAX;");
      look_.start("s->", body);
    });
    out_.blank();
  }

  // Each operator that remembers is evaluated once a tick, whatever the others say. An input is
  // looked at where it is first asked for, and a monitor is called where its finding is used: so
  // little has to be kept at hand.
  void judge_all(const std::string& target, Code& body) {
    std::vector<bool> seen(watch_.inputs.size(), false);
    for (const PlainMonitor& m : watch_.monitors) {
      for (const std::uint32_t c : channels_of(watch_, m)) {
        if (seen[c]) continue;
        seen[c] = true;
        body.line(look_.call(c, "&v", "in"));
      }
      std::string found = function_of(m) + "(&v)";
      if (side_.is_full()) {
        uses_.insert("finding_judged");
        found = "finding_judged(" + found + ")";
      }
      const std::string to = target + "[" + up_ + "_MONITORS_" + upper(names_(m.name)) + "]";
      wrapped(body, to + " = " + found + ";");
    }
    look_.next_tick("s->", body);
  }
  void entry(const std::string& name, const std::string& result,
             const std::function<void(Code&)>& none, const std::function<void(Code&)>& judged) {
    look_.function(
        "void " + name,
        {side_.state + " *s", "const " + p_ + "_monitors_in *in", "int64_t now_us", result},
        [&](Code& body) {
          body.line(view() + " v;");
          body.line("int32_t k;");
          if (!asks_for_inputs()) body.line("(void)in;");
          const std::string given = params_move() ? "in, " : "";
          body.block("if (" + side_.functions + "_begin(&v, s, " + given + "now_us) == 0)",
                     [&](Code& unknown) {
                       unknown.block("for (k = 0; k < " + monitors() + "; ++k)", none);
                       if (side_.is_full()) unknown.line("out->tick = s->clock.tick;");
                       unknown.line("return;");
                     });
          judged(body);
        });
  }
  void step() {
    uses_.insert({"finding_judged", "margin_unknown"});
    entry(
        p_ + "_monitors_step", p_ + "_monitors_out *out",
        [&](Code& each) {
          each.line("out->monitors[k] = finding_judged(margin_unknown(" + clock() + "));");
        },
        [&](Code& body) {
          body.line("out->tick = s->clock.tick;");
          judge_all("out->monitors", body);
        });
    out_.blank();
  }
  void verdicts() {
    entry(
        p_ + "_monitors_verdicts", "int32_t verdicts[" + monitors() + "]",
        [&](Code& each) { each.line("verdicts[k] = " + up_ + "_VERDICT_UNKNOWN;"); },
        [&](Code& body) { judge_all("verdicts", body); });
  }

  const Module& module_;
  const Watch& watch_;
  const Names& names_;
  const std::string p_, up_;
  WatchLook look_;
  const WatchKernel& side_;
  std::set<std::string>& uses_;
  Code& out_;
};

}  // namespace

void print_watch_source(const Module& module, const Names& names, std::set<std::string>& uses,
                        Code& out) {
  out.comment("---- monitors without a robot ----");
  WatchSource(module, names, Telling::margins, uses, out).print();
  out.comment("---- verdicts without margins ----");
  WatchSource(module, names, Telling::verdicts, uses, out).print();
}

}  // namespace rtac::codegen
