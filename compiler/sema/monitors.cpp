#include "compiler/sema/monitors.h"

#include "compiler/sema/property.h"
#include "compiler/sema/requirement.h"

namespace rtac::sema {

namespace {

class MonitorChecker {
 public:
  MonitorChecker(Context& context, std::uint32_t index)
      : context_(context),
        monitor_(context.spec.monitors[index]),
        written_(*context.monitors[index].node) {}

  void check() {
    check_subject();
    check_requirement();
    // one without a robot is not told what robots of it need
    if (!written_.variable || !written_.kind) return;
    check_always();
    check_margin();
    monitor_.ahead = check_ahead(context_, written_, kind_);
    check_recovery();
    check_return();
    check_hold();
  }

 private:
  [[nodiscard]] std::string owner() const { return "the monitor `" + monitor_.name + "`"; }

  void check_subject() {
    if (!written_.variable || !written_.kind) {
      Finding finding(Code::clause_missing, monitor_.name_range, owner() + " has no robot");
      finding.label("no robot");
      if (const auto range = clause_of_robots()) {
        finding.note(*range, "only monitors of robots have this clause");
      }
      context_.report(finding.help("add `for r : Kind` behind the name, as in `monitor " +
                                   monitor_.name +
                                   " for r : Kind`; a monitor without a robot is "
                                   "judged now, by `always` alone"));
      return;
    }
    self_ = *written_.variable;
    monitor_.robot = self_.text;
    kind_ = context_.resolve<KindId>(*written_.kind, Sort::robot_kind);
    if (kind_) monitor_.kind = *kind_;
    const Symbol* hidden = context_.symbols.find(self_.text);
    if (hidden == nullptr) return;
    context_.report(Finding(Code::duplicate_name, self_.range,
                            "the name `" + self_.text + "` is taken by " + a_name_of(hidden->sort))
                        .label("the second meaning")
                        .note(hidden->range, "the first one is declared here")
                        .help("give the monitored robot a name of its own, such as `r`"));
    self_taken_ = true;
  }

  // What makes it one of robots where it names none.
  [[nodiscard]] std::optional<SourceRange> clause_of_robots() const {
    if (!written_.ahead.empty()) return written_.ahead.front().range;
    if (!written_.recover.empty()) return written_.recover.front().range;
    if (!written_.return_when.empty()) return written_.return_when.front()->range;
    if (!written_.hold.empty()) return written_.hold.front().range;
    return std::nullopt;
  }

  void check_requirement() {
    Requirement requirement = sema::check_requirement(context_, written_);
    monitor_.requirement_id = std::move(requirement.id);
    monitor_.requirement_text = std::move(requirement.text);
  }

  [[nodiscard]] PropertyScope scope(Place place) const { return {place, kind_, self_}; }

  void check_margin() {
    if (written_.margin_full.empty()) return;
    context_.report(Finding(Code::clause_without_effect, written_.margin_full.front(),
                            "`margin full` has no effect on a monitor of a robot")
                        .label("its windows above 1,024 ticks keep verdicts")
                        .help("leave it out, or judge the window in a monitor without a robot"));
  }

  void check_always() {
    if (written_.always.empty()) {
      context_.missing_clause(monitor_.name_range, owner(), "property",
                              "always clearance(r, zone) >= 10 cm;");
      return;
    }
    only_one(context_, written_.always, "`always`");
    monitor_.always_range = written_.always.front()->range;
    if (!written_.variable || self_taken_) return;  // its robot cannot be told
    monitor_.always =
        check_property(context_, *written_.always.front(), scope(Place::robot_always));
  }

  void check_recovery() {
    if (written_.recover.empty()) return;  // whether it is due depends on the decisions
    only_one(context_, written_.recover, "`recover`");
    const syntax::Name& name = written_.recover.front();
    monitor_.recover_range = name.range;
    const auto id = context_.resolve<ControllerId>(name, Sort::controller);
    if (!id) return;
    const Controller& controller = context_.spec[*id];
    if (controller.advanced) {
      context_.report(Finding(Code::wrong_role, name.range,
                              "`" + controller.name + "` is advanced, so it cannot recover")
                          .label("a safe controller is due")
                          .note(controller.name_range, "declared as advanced here")
                          .help("name a controller that is declared as `safe`"));
    } else if (kind_ && controller.kind != *kind_) {
      context_.report(Finding(Code::wrong_kind, name.range,
                              "`" + controller.name + "` does not control a `" +
                                  context_.spec[*kind_].name + "`")
                          .label("of another kind")
                          .note(controller.name_range, "declared here")
                          .help("name a safe controller for `" + context_.spec[*kind_].name + "`"));
    } else {
      monitor_.recover = *id;
    }
  }

  void check_hold() {
    if (written_.hold.empty()) return;
    if (written_.hold.size() > 1) {
      context_.duplicate_clause(written_.hold[1].range, written_.hold[0].range,
                                "`hold when violated`");
    }
    monitor_.hold_reason = written_.hold.front().text;
    monitor_.hold_range = written_.hold.front().range;
  }

  void check_return() {
    if (written_.return_when.empty()) return;
    only_one(context_, written_.return_when, "`return when`");
    if (!written_.variable || self_taken_) return;
    monitor_.return_when =
        check_property(context_, *written_.return_when.front(), scope(Place::robot_return));
  }

  Context& context_;
  Monitor& monitor_;
  const syntax::MonitorItem& written_;
  syntax::Name self_;
  std::optional<KindId> kind_;
  bool self_taken_ = false;
};

}  // namespace

void check_monitors(Context& context) {
  for (std::uint32_t i = 0; i < context.monitors.size(); ++i) MonitorChecker(context, i).check();
}

}  // namespace rtac::sema
