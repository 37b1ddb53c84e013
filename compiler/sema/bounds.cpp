#include "compiler/sema/bounds.h"

#include <algorithm>

#include "compiler/sema/suggest.h"

namespace rtac::sema {

namespace {

const char* text_of(syntax::Relation relation) {
  return relation == syntax::Relation::at_most ? "<=" : ">=";
}

// Returns the name that was probably meant.
std::optional<std::string> report_unknown(Context& context, const syntax::Bound& bound,
                                          const std::vector<BoundRule>& rules,
                                          const std::string& block) {
  std::vector<std::string> names;
  for (const BoundRule& rule : rules) names.push_back(rule.name);
  const auto likely = nearest(bound.name.text, names);
  Finding finding(Code::unknown_bound, bound.name.range,
                  block + " has no limit `" + bound.name.text + "`");
  finding.label("not a limit of this block");
  finding.help(did_you_mean(bound.name.text, names, "limits of this block"));
  if (likely) finding.replace(bound.name.range, *likely);
  context.report(finding);
  return likely;
}

bool relation_fits(Context& context, const syntax::Bound& bound, const BoundRule& rule) {
  if (bound.relation == rule.relation) return true;
  const SourceRange& name = bound.name.range;
  const bool from_above = rule.relation == syntax::Relation::at_most;
  const SourceRange between{name.file, name.end, std::max(name.end, bound.value->range.begin)};
  context.report(Finding(Code::wrong_relation, {name.file, name.begin, bound.value->range.end},
                         "`" + rule.name + "` is a limit from " + (from_above ? "above" : "below"))
                     .label(std::string("must be `") + text_of(rule.relation) + "`")
                     .help("write `" + rule.name + " " + text_of(rule.relation) + " ...`")
                     .replace(between, std::string(" ") + text_of(rule.relation) + " "));
  return false;
}

BoundValue check_bound(Context& context, const syntax::Bound& bound, const BoundRule& rule) {
  BoundValue value{{0, bound.name.range}, false, &bound};
  const bool fits = relation_fits(context, bound, rule);
  const auto number = quantity(context, *bound.value,
                               {rule.dimension, "`" + rule.name + "`", rule.limit, rule.works});
  if (number) value.quantity = *number;
  value.good = fits && number.has_value();
  return value;
}

}  // namespace

BoundValues check_bounds(Context& context, const std::vector<const syntax::Bound*>& bounds,
                         const std::vector<BoundRule>& rules, const std::string& block,
                         const SourceRange& block_range) {
  BoundValues values;
  for (const syntax::Bound* each : bounds) {
    const syntax::Bound& bound = *each;
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const BoundRule& candidate) {
      return candidate.name == bound.name.text;
    });
    if (rule == rules.end()) {
      // A misspelt limit is not missing as well.
      if (const auto meant = report_unknown(context, bound, rules, block)) {
        values.try_emplace(*meant);
      }
      continue;
    }
    const auto earlier = values.find(rule->name);
    if (earlier != values.end() && earlier->second.written != nullptr) {
      context.duplicate_clause(bound.name.range, earlier->second.written->name.range,
                               "`" + rule->name + "`");
      continue;
    }
    values[rule->name] = check_bound(context, bound, *rule);
  }
  for (const BoundRule& rule : rules) {
    if (!rule.required || values.count(rule.name) > 0) continue;
    context.report(
        Finding(Code::limit_missing, block_range, block + " has no limit `" + rule.name + "`")
            .label("no `" + rule.name + "`")
            .help("add `" + rule.example + ";` with the robot's own value"));
  }
  return values;
}

}  // namespace rtac::sema
