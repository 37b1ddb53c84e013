#include "compiler/sema/watches.h"

#include "compiler/sema/property.h"
#include "compiler/sema/requirement.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

namespace {

void check_watch(Context& context, Watch& watch, const syntax::MonitorItem& written) {
  Requirement requirement = check_requirement(context, written);
  watch.requirement_id = std::move(requirement.id);
  watch.requirement_text = std::move(requirement.text);
  if (written.always.empty()) {
    context.missing_clause(watch.name_range, "the monitor `" + watch.name + "`", "property",
                           "always speed <= 1 m/s;");
    return;
  }
  only_one(context, written.always, "`always`");
  watch.margin_full = !written.margin_full.empty();
  if (written.margin_full.size() > 1) {
    context.duplicate_clause(written.margin_full[1], written.margin_full[0], "`margin full`");
  }
  watch.always_range = written.always.front()->range;
  watch.always = check_property(context, *written.always.front(), PropertyScope{});
}

void check_assumption(Context& context, const syntax::Item& item,
                      const syntax::AssumeItem& written) {
  const ExprPtr condition = check_property(context, *written.condition, PropertyScope{});
  Assumption assumption{"", item.range, "", ""};
  if (written.checked_by) {
    const syntax::Name& name = *written.checked_by;
    const Symbol* symbol = context.symbols.find(name.text);
    const bool of_robot = symbol != nullptr && symbol->sort == Sort::monitor;
    if (!of_robot && !context.resolve(name, Sort::watch)) return;
    assumption.checked_by = name.text;
  } else if (written.unchecked) {
    assumption.reason = written.unchecked->text;
    if (assumption.reason.find_first_not_of(" \t") == std::string::npos) {
      context.missing_clause(written.unchecked->range, "the assumption", "reason",
                             "\"why it holds\"");
      return;
    }
  } else {
    context.missing_clause(item.range, "the assumption", "word on who checks it",
                           "checked by monitor_name` or `unchecked \"why it holds\"");
    return;
  }
  if (!condition) return;
  assumption.text = syntax::print_expr(*written.condition);
  context.spec.assumptions.push_back(std::move(assumption));
}

}  // namespace

void check_watches(Context& context) {
  for (std::size_t i = 0; i < context.watches.size(); ++i) {
    check_watch(context, context.spec.watches[i], *context.watches[i].node);
  }
  // a period may be what the parser has lost
  if (context.watches.empty() || context.period_written || context.broken_tree()) return;
  const Watch& first = context.spec.watches.front();
  context.missing_clause(first.name_range, "the monitor `" + first.name + "`", "period",
                         "period 10 ms;` at the top: monitors without a robot run once every "
                         "period, and monitors of robots are written `monitor " +
                             first.name + " for r : Kind");
}

void check_assumptions(Context& context, const syntax::Program& program) {
  for (const syntax::File& file : program.files) {
    for (const syntax::Item& item : file.items) {
      const auto* assume = std::get_if<syntax::AssumeItem>(&item.node);
      if (assume != nullptr) check_assumption(context, item, *assume);
    }
  }
}

void warn_unused_signals(Context& context) {
  if (context.broken_tree()) return;
  const auto warn = [&](const std::string& what, const std::string& name,
                        const SourceRange& range) {
    // an imported file declares what several specifications share
    if (range.file != context.spec.name_range.file) return;
    context.report(
        Finding(Code::declaration_unused, range, "no monitor uses the " + what + " `" + name + "`")
            .label("unused")
            .help("leave it out, or write a monitor that speaks of it"));
  };
  for (std::uint32_t i = 0; i < context.spec.inputs.size(); ++i) {
    const Input& input = context.spec.inputs[i];
    if (context.used_inputs.count(InputId{i}) > 0) continue;
    if (!input.agent) {
      warn("input", input.name, input.name_range);
    } else if (const Agent& agent = context.spec[*input.agent]; agent.seen == InputId{i}) {
      warn("agent", agent.name, agent.name_range);
    }
  }
  for (std::uint32_t i = 0; i < context.spec.params.size(); ++i) {
    const Param& param = context.spec.params[i];
    if (context.used_params.count(ParamId{i}) == 0) {
      warn("parameter", param.name, param.name_range);
    }
  }
  if (!context.spec.period || !context.watches.empty()) return;
  context.report(Finding(Code::period_unused, context.spec.period->range,
                         "no monitor uses this period: there is none without a robot")
                     .label("has no effect")
                     .help("leave it out; decisions have a period of their own"));
}

}  // namespace rtac::sema
