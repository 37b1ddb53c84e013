#include "compiler/sema/decisions.h"

#include <algorithm>
#include <set>

#include "compiler/sema/quantity.h"
#include "compiler/sema/suggest.h"

namespace rtac::sema {

namespace {

class DecisionChecker {
 public:
  DecisionChecker(Context& context, std::uint32_t index)
      : context_(context),
        decision_(context.spec.decisions[index]),
        written_(*context.decisions[index].node) {}

  void check() {
    kind_ = context_.resolve<KindId>(written_.kind, Sort::robot_kind);
    if (kind_) decision_.kind = *kind_;
    check_trigger();
    check_advanced();
    check_safe();
    check_order();
    for (const syntax::Acknowledge& written : written_.acknowledge) acknowledge(written);
    check_monitors_of(context_, decision_);
  }

 private:
  [[nodiscard]] std::string owner() const { return "the decision `" + decision_.name + "`"; }

  void check_trigger() {
    decision_.on_plan = !written_.on.empty();
    for (std::size_t i = 1; i < written_.on.size(); ++i) {
      context_.duplicate_clause(written_.on[i].range, written_.on.front().range, "`on`");
    }
    for (std::size_t i = 1; i < written_.period.size(); ++i) {
      context_.duplicate_clause(written_.period[i]->range, written_.period.front()->range,
                                "`period`");
    }
    if (decision_.on_plan && !written_.period.empty()) {
      report_trigger(written_.period.front()->range, owner() + " has a period and runs on a plan",
                     "leave out one of the two");
    } else if (!decision_.on_plan && written_.period.empty()) {
      report_trigger(decision_.name_range, owner() + " does not say when it runs",
                     "add `period 100 ms;`, or `on plan;` for a planner");
    } else if (decision_.on_plan) {
      check_on_plan();
    } else {
      check_period(*written_.period.front());
    }
    check_jitter();
  }

  void check_jitter() {
    for (std::size_t i = 1; i < written_.jitter.size(); ++i) {
      context_.duplicate_clause(written_.jitter[i]->range, written_.jitter.front()->range,
                                "`jitter`");
    }
    if (written_.jitter.empty()) return;
    const syntax::Expr& expr = *written_.jitter.front();
    if (decision_.on_plan) {
      context_.report(Finding(Code::clause_without_effect, expr.range,
                              "`jitter` has no effect on a decision on a plan")
                          .label("it has no period")
                          .help("leave it out"));
      return;
    }
    decision_.jitter = quantity(context_, expr, {dims::time, "the jitter", Limit::not_negative});
    if (!decision_.jitter || !decision_.period) return;
    if (decision_.jitter->value < decision_.period->value) return;
    const std::string most = show(decision_.period->value, dims::time);
    context_.report(Finding(Code::limit_contradictory, expr.range,
                            "a step that is late by " + show(decision_.jitter->value, dims::time) +
                                " comes after the next one")
                        .label("not below the period")
                        .note(decision_.period->range, "the period is " + most)
                        .help("less than " + most + " works, or a longer period"));
  }

  void report_trigger(const SourceRange& range, const std::string& message,
                      const std::string& help) {
    context_.report(Finding(Code::decision_trigger, range, message)
                        .label("either `period` or `on plan`")
                        .help(help));
  }

  void check_on_plan() {
    const syntax::Name& event = written_.on.front();
    if (event.text != "plan") {
      context_.unknown_word(event, "an event that a decision runs on", {"plan"});
    } else if (kind_) {
      context_.require(*kind_, Need::plan, event.range, "a decision on a plan");
    }
  }

  void check_period(const syntax::Expr& expr) {
    const auto period =
        quantity(context_, expr,
                 {dims::time, "the period", Limit::positive, "1 ms works, or a multiple of it"});
    if (!period) return;
    const Rational in_ms = period->value * 1000;
    if (in_ms.get_den() == 1) {
      decision_.period = *period;
      return;
    }
    const std::int64_t below = floor_to_int(in_ms);
    std::string works = std::to_string(below + 1) + " ms";
    if (below > 0) works = std::to_string(below) + " ms or " + works;
    context_.report(Finding(Code::quantity_out_of_range, expr.range,
                            "the period of " + show(period->value, dims::time) +
                                " is not a whole number of milliseconds")
                        .label("must be a multiple of 1 ms")
                        .help(works + " works"));
  }

  // A named controller of this decision, if it has the role and the kind that are due.
  std::optional<ControllerId> controller(const syntax::Name& name, bool advanced) {
    const auto id = context_.resolve<ControllerId>(name, Sort::controller);
    if (!id) return std::nullopt;
    const Controller& found = context_.spec[*id];
    if (found.advanced != advanced) {
      const std::string due = advanced ? "advanced" : "safe";
      context_.report(Finding(Code::wrong_role, name.range,
                              "`" + found.name + "` is " + (advanced ? "a safe" : "an advanced") +
                                  " controller, but " + (advanced ? "an advanced" : "a safe") +
                                  " one is due")
                          .label("must be " + due)
                          .note(found.name_range, "declared here")
                          .help("name a controller that is declared as `" + due + "`"));
      return std::nullopt;
    }
    if (kind_ && found.kind != *kind_) {
      context_.report(
          Finding(Code::wrong_kind, name.range,
                  "`" + found.name + "` does not control a `" + context_.spec[*kind_].name + "`")
              .label("of another kind")
              .note(found.name_range, "declared here")
              .help("name a controller for `" + context_.spec[*kind_].name + "`"));
      return std::nullopt;
    }
    return decision_.on_plan && !plans(found, name) ? std::nullopt : id;
  }

  // A decision on a plan chooses between paths; a template outputs commands.
  bool plans(const Controller& found, const syntax::Name& name) {
    if (std::holds_alternative<ExternController>(found.implementation)) return true;
    if (found.advanced) return false;  // an advanced template: reported where it is declared
    context_.report(Finding(Code::outputs_differ, name.range,
                            "`" + found.name +
                                "` drives the robot, but a decision on a plan chooses between "
                                "paths")
                        .label("does not output a path")
                        .note(found.name_range, "a built-in template is declared here")
                        .help("name a planner, which is declared as `extern`"));
    return false;
  }

  void one_name(const std::vector<syntax::Name>& names, const std::string& what) {
    for (std::size_t i = 1; i < names.size(); ++i) {
      context_.duplicate_clause(names[i].range, names.front().range, what);
    }
  }

  void check_advanced() {
    if (written_.advanced.empty()) {
      context_.missing_clause(decision_.name_range, owner(), "`advanced` controller",
                              "advanced controller_name;");
      return;
    }
    one_name(written_.advanced, "`advanced`");
    const auto id = controller(written_.advanced.front(), true);
    if (id) decision_.advanced = *id;
  }

  void check_safe() {
    if (written_.safe.empty()) {
      if (decision_.on_plan) {
        context_.missing_clause(decision_.name_range, owner(), "`safe` planner",
                                "safe planner_name;");
      }
      return;
    }
    one_name(written_.safe, "`safe`");
    if (decision_.on_plan) {
      decision_.safe = controller(written_.safe.front(), false);
      return;
    }
    context_.report(
        Finding(Code::clause_without_effect, written_.safe.front().range,
                "`safe` has no effect in a periodic decision")
            .label("each monitor has its own recovery")
            .help("write `recover " + written_.safe.front().text + ";` in the monitors"));
  }

  using Orders = std::vector<std::vector<syntax::Name>>;
  void one_order(const Orders& orders, const std::string& what) {
    for (std::size_t i = 1; i < orders.size(); ++i) {
      if (orders[i].empty() || orders.front().empty()) continue;
      context_.duplicate_clause(orders[i].front().range, orders.front().front().range, what);
    }
  }

  void check_order() {
    one_order(written_.priority, "`priority`");
    one_order(written_.coordinate, "`coordinate`");
    if (written_.priority.empty() && written_.coordinate.empty()) {
      context_.missing_clause(decision_.name_range, owner(), "`priority`",
                              "priority first > second;");
      return;
    }
    decision_.coordinated = written_.priority.empty();
    const auto& order =
        decision_.coordinated ? written_.coordinate.front() : written_.priority.front();
    if (!order.empty()) decision_.order_range = order.front().range;
    for (const syntax::Name& name : order) add_monitor(name);
    if (!written_.coordinate.empty()) check_coordinate(written_.coordinate.front());
    if (decision_.priority.size() <= max_priority) return;
    const std::string most = std::to_string(max_priority);
    context_.report(
        Finding(Code::quantity_out_of_range, order[max_priority].range,
                owner() + " has " + std::to_string(decision_.priority.size()) + " monitors")
            .label("at most " + most)
            .help("up to " + most + " monitors in one decision work"));
  }

  // The order of both is the same kind of list: what differs is who drives of several recoveries.
  void check_coordinate(const std::vector<syntax::Name>& order) {
    if (order.empty()) return;
    const SourceRange& at = order.front().range;
    if (!written_.priority.empty() && !written_.priority.front().empty()) {
      context_.report(Finding(Code::two_orders, at,
                              owner() + " has an order to `coordinate` by and a `priority`")
                          .label("the second order")
                          .note(written_.priority.front().front().range, "the first order is here")
                          .help("leave out one of the two"));
    } else if (decision_.on_plan) {
      context_.report(Finding(Code::clause_without_effect, at,
                              "`coordinate` has no effect on a decision on a plan")
                          .label("no recovery drives there")
                          .help("write `priority`"));
    } else if (order.size() == 1) {
      context_.report(Finding(Code::coordinate_of_one, at,
                              owner() + " has one monitor, whose recovery always drives")
                          .label("nothing to coordinate")
                          .help("`priority " + order.front().text + ";` says the same"));
    }
  }

  void add_monitor(const syntax::Name& name) {
    const auto id = context_.resolve<MonitorId>(name, Sort::monitor);
    if (!id) {
      priority_complete_ = false;
      return;
    }
    const Monitor& monitor = context_.spec[*id];
    const auto& so_far = decision_.priority;
    if (std::find(so_far.begin(), so_far.end(), *id) != so_far.end()) {
      context_.report(Finding(Code::priority_incomplete, name.range,
                              "`" + name.text + "` stands twice in the priority")
                          .label("the second time")
                          .help("list every monitor once, the most important first"));
      return;
    }
    // The kind of a monitor without one is unknown; that was reported.
    const auto& written_kind = context_.monitors[index_of(*id)].node->kind;
    if (kind_ && written_kind && written_kind->text != written_.kind.text &&
        context_.symbols.find(written_kind->text) != nullptr) {
      context_.report(Finding(Code::wrong_kind, name.range,
                              "`" + name.text + "` monitors a `" + written_kind->text +
                                  "`, the decision is for `" + written_.kind.text + "`")
                          .label("of another kind")
                          .note(monitor.name_range, "declared here")
                          .help("list monitors for `" + written_.kind.text + "`"));
      priority_complete_ = false;
      return;
    }
    decision_.priority.push_back(*id);
  }

  void acknowledge(const syntax::Acknowledge& written) {
    const auto recovery = context_.resolve<ControllerId>(written.recovery, Sort::controller);
    const auto monitor = context_.resolve<MonitorId>(written.monitor, Sort::monitor);
    if (!recovery || !monitor || !priority_complete_) return;
    std::vector<std::string> recoveries;
    bool known = false;
    for (const MonitorId each : decision_.priority) {
      const auto& own = context_.spec[each].recover;
      if (!own) {  // a faulty or missing recovery, which is reported, may be the one that is named
        known =
            known || !decision_.on_plan || !context_.monitors[index_of(each)].node->recover.empty();
        continue;
      }
      const std::string& name = context_.spec[*own].name;
      if (std::find(recoveries.begin(), recoveries.end(), name) == recoveries.end()) {
        recoveries.push_back(name);
      }
      known = known || *own == *recovery;
    }
    std::vector<std::string> monitors;
    for (const MonitorId each : decision_.priority) monitors.push_back(context_.spec[each].name);
    const bool listed = std::find(decision_.priority.begin(), decision_.priority.end(), *monitor) !=
                        decision_.priority.end();
    if (!known) report_acknowledge(written.recovery, "recovery", recoveries);
    if (!listed) report_acknowledge(written.monitor, "monitor", monitors);
    if (!known || !listed || !new_pair(written, *recovery, *monitor)) return;
    if (written.reason.text.find_first_not_of(" \t") == std::string::npos) {
      context_.missing_clause(written.reason.range, "the acknowledgement", "reason",
                              "\"why this is acceptable\"");
    }
    decision_.acknowledgements.push_back({*recovery, *monitor, written.reason.text, written.range});
  }

  void report_acknowledge(const syntax::Name& name, const std::string& sort,
                          const std::vector<std::string>& possible) {
    if (context_.broken_tree()) return;  // its monitor or recovery may be what is lost
    const std::string help =
        possible.empty() ? owner() + " has none" : "possible are " + listing(possible);
    context_.report(Finding(Code::acknowledge_unknown, name.range,
                            "`" + name.text + "` is not a " + sort + " of " + owner())
                        .label("not a " + sort + " of this decision")
                        .help(help));
  }

  bool new_pair(const syntax::Acknowledge& written, ControllerId recovery, MonitorId monitor) {
    for (const Acknowledgement& earlier : decision_.acknowledgements) {
      if (earlier.recovery != recovery || earlier.monitor != monitor) continue;
      context_.duplicate_clause(written.range, earlier.range, "this acknowledgement");
      return false;
    }
    return true;
  }

  Context& context_;
  Decision& decision_;
  const syntax::DecisionItem& written_;
  std::optional<KindId> kind_;
  bool priority_complete_ = true;
};

// Two decisions of one sort would write one output of the same robot.
void check_outputs(Context& context) {
  const auto& decisions = context.spec.decisions;
  for (std::size_t i = 0; i < decisions.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool same_kind =
          context.decisions[i].node->kind.text == context.decisions[j].node->kind.text;
      if (!same_kind || decisions[i].on_plan != decisions[j].on_plan) continue;
      const bool plan = decisions[i].on_plan;
      context.report(Finding(Code::outputs_differ, decisions[i].name_range,
                             "`" + decisions[i].name + "` and `" + decisions[j].name +
                                 "` both write the " + (plan ? "plan" : "output") + " of `" +
                                 context.decisions[i].node->kind.text + "`")
                         .label("the second decision")
                         .note(decisions[j].name_range, "the first decision is here")
                         .help("put the monitors of both into one decision"));
      break;
    }
  }
}

void warn_unused(Context& context) {
  std::set<std::uint32_t> used;
  bool incomplete = false;  // a priority is missing or names nothing: it may mean any monitor
  for (const auto& decision : context.decisions) {
    auto lists = decision.node->priority;
    for (const auto& list : decision.node->coordinate) lists.push_back(list);
    incomplete = incomplete || lists.empty();
    for (const auto& list : lists) {
      for (const syntax::Name& name : list) {
        const Symbol* listed = context.symbols.find(name.text);
        if (listed == nullptr) {
          // A misspelt monitor is used, too: its name was reported.
          const auto meant = nearest(name.text, context.symbols.names_of(Sort::monitor));
          if (meant) listed = context.symbols.find(*meant);
          incomplete = incomplete || !meant;
        }
        if (listed != nullptr && listed->sort == Sort::monitor) used.insert(listed->index);
      }
    }
  }
  if (incomplete) return;
  for (std::uint32_t i = 0; i < context.spec.monitors.size(); ++i) {
    const bool of_no_robot = !context.monitors[i].node->kind;  // reported as such
    if (used.count(i) > 0 || of_no_robot || context.broken_tree()) continue;
    const Monitor& monitor = context.spec.monitors[i];
    context.report(Finding(Code::monitor_unused, monitor.name_range,
                           "no decision uses the monitor `" + monitor.name + "`")
                       .label("watches nothing")
                       .help("add it to the `priority` of a decision"));
  }
}

}  // namespace

void check_decisions(Context& context) {
  for (std::uint32_t i = 0; i < context.decisions.size(); ++i) {
    DecisionChecker(context, i).check();
  }
  check_outputs(context);
  warn_unused(context);
}

void warn_without_robots(Context& context) {
  const Spec& spec = context.spec;
  for (const Decision& decision : spec.decisions) {
    const bool imported = decision.name_range.file != spec.name_range.file;
    const bool has_robot = std::ranges::any_of(
        spec.robots, [&](const Robot& robot) { return robot.kind == decision.kind; });
    if (imported || has_robot) continue;
    const std::string& kind = spec[decision.kind].name;
    context.report(
        Finding(Code::robot_missing, decision.name_range,
                "no fleet has a `" + kind + "`, which `" + decision.name + "` decides for")
            .label("no robot has this decision")
            .help("`fleet one : " + kind + ";` works, with a name for each robot"));
  }
}

}  // namespace rtac::sema
