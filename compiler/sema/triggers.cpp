// What the trigger of a decision, its period or a new plan, asks of its monitors.
#include <type_traits>

#include "compiler/sema/decisions.h"
#include "compiler/sema/property.h"
#include "compiler/sema/quantity.h"
#include "compiler/sema/ticks.h"

namespace rtac::sema {

namespace {

class TriggerChecker {
 public:
  TriggerChecker(Context& context, const Decision& decision, MonitorId monitor)
      : context_(context),
        decision_(decision),
        monitor_(context.spec[monitor]),
        written_(*context.monitors[index_of(monitor)].node) {}

  void check() {
    if (decision_.on_plan) {
      check_plan_property();
      check_no_durations();
      check_no_recovery();
    } else {
      check_state_property();
      check_recovery();
      check_multiples();
    }
  }

 private:
  static bool speaks_of_state(const Expr& expr) {
    return is_robot_state(expr) && !std::holds_alternative<PlanInside>(expr.node) &&
           !std::holds_alternative<ForOthers>(expr.node);
  }
  static bool speaks_of_signals(const Expr& expr) {
    return std::holds_alternative<InputRef>(expr.node) ||
           std::holds_alternative<AgeOf>(expr.node) ||
           std::holds_alternative<SensedAge>(expr.node) ||
           std::holds_alternative<IsValue>(expr.node) ||
           std::holds_alternative<SameValue>(expr.node) ||
           std::holds_alternative<ParamRef>(expr.node);
  }

  void check_plan_property() {
    if (!monitor_.always) return;
    for_each_expr(*monitor_.always, [&](const Expr& expr) {
      const bool signal = speaks_of_signals(expr);
      if (!signal && !speaks_of_state(expr)) return;
      context_.report(Finding(Code::property_not_on_plan, expr.range,
                              "`" + decision_.name + "` judges plans, but `" + monitor_.name +
                                  "` speaks of " + (signal ? "signals" : "the state of the robot"))
                          .label("not about the plan")
                          .note(decision_.name_range, "the decision runs on a plan")
                          .help("write `r.plan inside zone`, or use the monitor in a decision "
                                "with a period"));
    });
  }

  void check_state_property() {
    for (const ExprPtr* property : {&monitor_.always, &monitor_.return_when}) {
      if (!*property) continue;
      for_each_expr(**property, [&](const Expr& expr) {
        if (!std::holds_alternative<PlanInside>(expr.node)) return;
        context_.report(Finding(Code::plan_property_periodic, expr.range,
                                "`" + decision_.name + "` judges states, but `" + monitor_.name +
                                    "` speaks of the whole plan")
                            .label("about the whole plan")
                            .note(decision_.name_range, "the decision has a period")
                            .help("use the monitor in a decision `on plan`; way-points ahead of "
                                  "the robot are judged by `ahead 2 waypoints`"));
      });
    }
  }

  void check_no_durations() {
    for (const syntax::AheadTerm& term : written_.ahead) {
      if (std::holds_alternative<syntax::AheadDuration>(term.node)) {
        report_duration(term.range);
      } else {
        without_effect(term.range, "this look-ahead", "the whole plan is judged");
      }
    }
    if (!monitor_.return_when) return;
    for_each_expr(*monitor_.return_when, [&](const Expr& expr) {
      if (std::holds_alternative<HeldFor>(expr.node)) report_duration(expr.range);
    });
  }

  void report_duration(const SourceRange& range) {
    context_.report(Finding(Code::duration_on_plan, range,
                            "`" + decision_.name + "` runs on a plan, where durations mean nothing")
                        .label("a duration")
                        .note(decision_.name_range, "the decision runs when a plan is proposed")
                        .help("leave out the duration: the whole plan is judged"));
  }

  void check_no_recovery() {
    if (!written_.recover.empty()) {
      without_effect(written_.recover.front().range, "`recover`",
                     "the `safe` planner of the decision takes over");
    }
    if (!written_.return_when.empty()) {
      without_effect(written_.return_when.front()->range, "`return when`",
                     "every plan is judged anew");
    }
  }

  void without_effect(const SourceRange& range, const std::string& what,
                      const std::string& instead) {
    context_.report(Finding(Code::clause_without_effect, range,
                            what + " has no effect in a decision that runs on a plan")
                        .label(instead)
                        .note(decision_.name_range, "`" + decision_.name + "` runs on a plan")
                        .help("leave it out"));
  }

  void check_recovery() {
    if (!written_.recover.empty()) return;
    context_.report(Finding(Code::recovery_missing, monitor_.name_range,
                            "the monitor `" + monitor_.name + "` has no recovery")
                        .label("nothing to do when it fails")
                        .note(decision_.name_range, "`" + decision_.name + "` uses it")
                        .help("add `recover controller_name;` with a safe controller"));
  }

  void check_multiples() {
    if (!decision_.period) return;
    for (const ExprPtr* property : {&monitor_.always, &monitor_.return_when}) {
      if (!*property) continue;
      for_each_expr(**property, [&](const Expr& expr) { check_durations(expr); });
    }
  }

  void check_durations(const Expr& expr) {
    std::visit(
        [&](const auto& node) {
          using Node = std::decay_t<decltype(node)>;
          if constexpr (requires { node.duration; }) {
            const bool held = std::is_same_v<Node, HeldFor>;
            check_multiple(node.duration, held ? Limit::positive : Limit::not_negative);
          } else if constexpr (requires { node.interval; }) {
            check_multiple(node.interval.from, Limit::not_negative);
            if (node.interval.to) check_multiple(*node.interval.to, Limit::not_negative);
          }
        },
        expr.node);
  }

  void check_multiple(const Quantity& duration, Limit limit) {
    const Quantity& period = *decision_.period;
    if (whole_periods(context_, duration, period, "`" + decision_.name + "` has this period",
                      Stricter::neither, limit)) {
      window_holds(context_, duration, period);
    }
  }

  Context& context_;
  const Decision& decision_;
  const Monitor& monitor_;
  const syntax::MonitorItem& written_;
};

}  // namespace

void check_monitors_of(Context& context, const Decision& decision) {
  for (const MonitorId monitor : decision.priority) {
    TriggerChecker(context, decision, monitor).check();
  }
}

}  // namespace rtac::sema
