#include "compiler/sema/monitors.h"

#include "compiler/sema/property.h"
#include "compiler/sema/quantity.h"

namespace rtac::sema {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\n");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t\n") - begin + 1);
}

class MonitorChecker {
 public:
  MonitorChecker(Context& context, std::uint32_t index)
      : context_(context),
        monitor_(context.spec.monitors[index]),
        written_(*context.monitors[index].node) {}

  void check() {
    check_subject();
    check_requirement();
    check_always();
    monitor_.ahead = check_ahead(context_, written_, kind_);
    check_recovery();
    check_return();
  }

 private:
  [[nodiscard]] std::string owner() const { return "the monitor `" + monitor_.name + "`"; }

  void check_subject() {
    if (!written_.variable || !written_.kind) {
      context_.missing_clause(
          monitor_.name_range, owner(), "robot",
          "for r : Kind` behind the name, as in `monitor " + monitor_.name + " for r : Kind");
      return;
    }
    self_ = *written_.variable;
    kind_ = context_.resolve<KindId>(*written_.kind, Sort::robot_kind);
    if (kind_) monitor_.kind = *kind_;
    const Symbol* hidden = context_.symbols.find(self_.text);
    if (hidden == nullptr) return;
    context_.report(Finding(Code::duplicate_name, self_.range,
                            "the name `" + self_.text + "` is taken by a " + name_of(hidden->sort))
                        .label("the second meaning")
                        .note(hidden->range, "the first one is declared here")
                        .help("give the monitored robot a name of its own, such as `r`"));
    self_taken_ = true;
  }

  // "SR-3: text": an id is one word before a colon.
  void check_requirement() {
    if (written_.requirement.empty() || trimmed(written_.requirement.front().text).empty()) {
      context_.missing_clause(
          written_.requirement.empty() ? monitor_.name_range : written_.requirement.front().range,
          owner(), "requirement text", "\"SR-1: what must hold, in words\"");
      return;
    }
    only_one(written_.requirement, "the requirement text");
    const std::string text = trimmed(written_.requirement.front().text);
    const std::size_t colon = text.find(':');
    const bool has_id =
        colon != std::string::npos && colon > 0 && text.find_first_of(" \t\n") > colon;
    if (has_id) monitor_.requirement_id = text.substr(0, colon);
    monitor_.requirement_text = has_id ? trimmed(text.substr(colon + 1)) : text;
  }

  template <class Clause>
  void only_one(const std::vector<Clause>& clauses, const std::string& what) {
    for (std::size_t i = 1; i < clauses.size(); ++i) {
      context_.duplicate_clause(range_of(clauses[i]), range_of(clauses.front()), what);
    }
  }
  static const SourceRange& range_of(const syntax::ExprPtr& clause) { return clause->range; }
  template <class Clause>
  static const SourceRange& range_of(const Clause& clause) {
    return clause.range;
  }

  [[nodiscard]] PropertyScope scope(bool held_allowed) const {
    return {kind_, self_, held_allowed};
  }

  void check_always() {
    if (written_.always.empty()) {
      context_.missing_clause(monitor_.name_range, owner(), "property",
                              "always clearance(r, zone) >= 10 cm;");
      return;
    }
    only_one(written_.always, "`always`");
    monitor_.always_range = written_.always.front()->range;
    if (!written_.variable || self_taken_) return;  // its robot cannot be told
    monitor_.always = check_property(context_, *written_.always.front(), scope(false));
  }

  void check_recovery() {
    if (written_.recover.empty()) return;  // whether it is due depends on the decisions
    only_one(written_.recover, "`recover`");
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

  void check_return() {
    if (written_.return_when.empty()) return;
    only_one(written_.return_when, "`return when`");
    if (!written_.variable || self_taken_) return;
    monitor_.return_when = check_property(context_, *written_.return_when.front(), scope(true));
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
