// The step of the monitors without a robot: the tick, its inputs, one function per monitor.
#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "compiler/codegen/repeat_printer.h"
#include "compiler/codegen/repeats.h"
#include "compiler/codegen/watch.h"
#include "compiler/codegen/watch_look.h"
#include "compiler/codegen/watch_told.h"
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
        out_(out),
        told_(module, names, look_, uses, out) {}

  void print() {
    look_.view();
    for (const PlainMonitor& m : watch_.monitors) monitor(m);
    look_.channels();
    for (std::size_t k = 0; k < watch_.monitors.size(); ++k) {
      if (told_.is_told(k)) told_.print(k, function_of(watch_.monitors[k]));
    }
    if (has_past(watch_, side_.telling)) {
      look_.blind();
      catch_up();
    }
    resume();
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

  [[nodiscard]] std::string inputs() const { return "const " + p_ + "_monitors_in *in"; }

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
    const std::vector<std::string> parameters = {side_.state + " *s", "int64_t now_us"};
    look_.function("static int32_t " + side_.functions + "_resume", parameters, [&](Code& body) {
      const std::string period = num(watch_.period_us);
      if (each_tick()) body.line("const int32_t first = s->clock.started == 0;");
      if (!side_.is_full() && !keeps_due()) {
        uses_.insert("tick_passed");
        body.block("if (tick_passed(&s->clock, s->until_us, now_us, " + period + ") == 0)",
                   [](Code& none) { none.line("return 0;"); });
      }
      body.line("const int64_t elapsed = next_tick(&s->clock, now_us, " + period + ", INT64_MAX);");
      body.block("if (elapsed < 1)", [&](Code& none) { none.line("return 0;"); });
      body.line("s->until_us = tick_until(&s->clock, " + period + ");");
      if (has_past(watch_, side_.telling)) {
        body.block("if (elapsed > 1)",
                   [&](Code& gap) { gap.line(side_.functions + "_catch_up(s, elapsed - 1);"); });
      }
      if (each_tick()) {
        uses_.insert("before");
        const std::string last = keeps_due() ? "s->synced_us" : "s->judged_us";
        body.block("if (first || elapsed > 1)",
                   [&](Code& gap) { gap.line(last + " = before(now_us, " + period + ");"); });
      }
      body.line("return 1;");
    });
    out_.blank();
  }
  // The last tick is known by when the next one is due.
  [[nodiscard]] bool keeps_due() const { return keeps_due_tick(watch_, side_.telling); }
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

  void init() {
    const std::string name =
        p_ + (side_.is_full() ? "_monitors_init(" : "_monitors_verdicts_init(");
    out_.block("void " + name + side_.state + " *s)", [&](Code& body) {
      body.line("s->clock.started = 0;");
      body.line("s->clock.origin_us = 0;");
      body.line("s->clock.last_us = 0;");
      body.line("s->clock.tick = 0;");
      body.line("s->until_us = INT64_MAX;");
      if (keeps_due()) body.line("s->synced_us = INT64_MAX;").line("s->due_us = NEVER_DUE;");
      look_.start("s->", body);
    });
    out_.blank();
  }

  // Each operator that remembers is evaluated once a tick, whatever the others say. An input is
  // looked at where it is first asked for, and a monitor is called where its finding is used: so
  // little has to be kept at hand.
  void judge_all(const std::string& target, Code& body) {
    std::vector<bool> seen(watch_.inputs.size(), false);
    for (std::size_t k = 0; k < watch_.monitors.size(); ++k) {
      const PlainMonitor& m = watch_.monitors[k];
      for (const std::uint32_t c : channels_of(watch_, m)) {
        if (seen[c] || told_.is_alone(k)) continue;
        seen[c] = true;
        body.line(look_.call(c, "&v", "in"));
      }
      const std::string to = target + "[" + up_ + "_MONITORS_" + upper(names_(m.name)) + "]";
      if (told_.is_told(k)) {
        wrapped(body, told_.call(k, to));
        continue;
      }
      std::string found = function_of(m) + "(&v)";
      if (side_.is_full()) {
        uses_.insert("finding_judged");
        found = "finding_judged(" + found + ")";
      }
      wrapped(body, to + " = " + found + ";");
    }
    look_.next_tick("s->", body);
  }
  // The usual tick has the path without calls; what is unusual ends in the same one.
  void entry(const std::string& name, const std::string& result, const std::string& given,
             const std::function<void(Code&)>& none, const std::function<void(Code&)>& judged) {
    uses_.insert({"often", "seldom", "usually", "tick_follows"});
    if (side_.is_full()) uses_.insert("tick_counted");
    const std::vector<std::string> parameters = {side_.state + " *s", inputs(), "int64_t now_us",
                                                 result};
    const std::string judge = side_.functions + "_judge", late = side_.functions + "_late";
    const std::string arguments = "(s, in, now_us, " + given + ");";
    std::vector<std::string> since = parameters;
    if (keeps_due()) since.insert(since.begin() + 3, "int64_t since_us");
    out_.comment("The tick that has come.");
    look_.function("static inline void " + judge, since, [&](Code& body) {
      body.line(view() + " v;");
      if (!asks_for_inputs()) body.line("(void)in;");
      body.line("v.s = s;");
      body.line("v.now_us = now_us;");
      if (keeps_due()) {
        body.line("v.since_us = since_us;");
      } else if (each_tick()) {
        body.line("v.since_us = s->judged_us;").line("s->judged_us = now_us;");
      }
      look_.schedules("v.", body);
      look_.params("s->", "in->", body);
      judged(body);
    });
    out_.blank();
    const std::string period = num(watch_.period_us);
    const std::string follows = "tick_follows(&s->until_us, now_us, " + period + ")";
    look_.function("static SELDOM void " + late, parameters, [&](Code& body) {
      body.line("int32_t k;");
      const std::string comes = side_.functions + "_resume(s, now_us) != 0";
      if (!keeps_due()) {
        body.block("if (" + comes + ")",
                   [&](Code& resumed) { resumed.line(judge + arguments).line("return;"); });
      } else {
        late_or_early(follows, judge + "(s, in, now_us, since_us, " + given + ");", body);
      }
      body.block("for (k = 0; k < " + monitors() + "; ++k)", none);
      if (side_.is_full()) body.line("out->tick = s->clock.tick;");
    });
    out_.blank();
    look_.function("OFTEN void " + name, parameters, [&](Code& body) {
      const std::string due = "tick_due(&s->due_us, now_us, " + period + ")";
      const std::string at_due = "(s, in, now_us, now_us - " + period + ", " + given + ");";
      body.block(
          "if (" + (keeps_due() ? due : "USUALLY(" + follows + ")") + ")",
          [&](Code& usual) {
            if (side_.is_full()) usual.line("tick_counted(&s->clock, now_us);");
            usual.line(judge + (keeps_due() ? at_due : arguments));
          },
          "");
      body.block("} else", [&](Code& unusual) { unusual.line(late + arguments); });
    });
  }
  // A tick that is not due to the microsecond.
  void late_or_early(const std::string& follows, const std::string& judge, Code& body) {
    uses_.insert({"tick_due", "due_after", "tick_synced", "tick_counted"});
    const std::string period = num(watch_.period_us);
    body.line("int32_t begun = 0;");
    body.block("if (s->clock.started != 0)", [&](Code& started) {
      started.line("tick_synced(&s->clock, &s->until_us, &s->synced_us, &s->due_us, " + period +
                   ");");
      started.line("begun = " + follows + ";");
    });
    body.block(
        "if (begun != 0)", [](Code& next) { next.line("tick_counted(&s->clock, now_us);"); }, "");
    body.block("} else", [&](Code& other) {
      other.line("begun = " + side_.functions + "_resume(s, now_us);");
    });
    body.block("if (begun != 0)", [&](Code& tick) {
      tick.line("const int64_t since_us = s->synced_us;");
      tick.line("s->synced_us = now_us;");
      tick.line("s->due_us = due_after(&s->clock, now_us, " + period + ");");
      tick.line(judge).line("return;");
    });
  }
  void step() {
    uses_.insert({"finding_judged", "margin_unknown"});
    entry(
        p_ + "_monitors_step", p_ + "_monitors_out *out", "out",
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
        p_ + "_monitors_verdicts", "int32_t verdicts[" + monitors() + "]", "verdicts",
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
  WatchTold told_;
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
