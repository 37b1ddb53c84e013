#include "tests/differential/choices.h"

#include <algorithm>
#include <utility>

#include "compiler/analysis/derive.h"
#include "compiler/passes/pipeline.h"
#include "compiler/sema/value.h"
#include "compiler/sema/visit.h"

namespace rtac::differential {
namespace {

// Outermost first. They stay where they are when the expressions around them move.
void collect(sema::Expr& expr, std::vector<sema::Choice*>& all) {
  if (auto* choice = std::get_if<sema::Choice>(&expr.node)) all.push_back(choice);
  sema::for_each_operand(expr, [&](sema::ExprPtr& operand) { collect(*operand, all); });
}

sema::Watch watch_of(std::size_t number, sema::ExprPtr condition) {
  sema::Watch watch;
  watch.name = "condition" + std::to_string(number);
  watch.always = std::move(condition);
  return watch;
}

// Of every monitor without a robot, altered after it was checked.
std::vector<ir::Rounding> roundings(driver::Compilation& c) {
  std::vector<ir::Rounding> all;
  auto derived = analysis::derive(*c.spec, c.sources, c.diagnostics);
  if (!derived) return all;
  c.module = std::move(derived->module);
  if (passes::run_pipeline(*c.module, c.diagnostics, [](const passes::Pass&) {})) return all;
  for (const ir::PlainMonitor& m : c.module->watch->monitors) {
    all.push_back(ir::rounding_of(*c.spec, *c.module->watch, m.property));
  }
  return all;
}

std::vector<bool> which_are_rounded(const std::string& text) {
  const auto checked = check(text, Until::checked);
  sema::Spec& spec = *checked->compilation.spec;
  std::vector<sema::Choice*> choices;
  for (sema::Watch& watch : spec.watches) collect(*watch.always, choices);
  std::vector<bool> rounded;
  if (choices.empty()) return rounded;
  const std::size_t written = spec.watches.size();
  for (const sema::Choice* choice : choices) {
    spec.watches.push_back(watch_of(spec.watches.size(), sema::clone(*choice->condition)));
  }
  const std::vector<ir::Rounding> all = roundings(checked->compilation);
  for (std::size_t k = written; k < all.size(); ++k) rounded.push_back(!all[k].has_exact_verdict);
  return rounded;
}

// Takes the condition out of a choice, and an input in its place.
sema::ExprPtr replaced(sema::Spec& spec, sema::Choice& choice, std::size_t number) {
  sema::Input input;
  input.name = "condition_of_choice" + std::to_string(number);
  input.type = sema::InputType::boolean;
  input.components = {""};
  const sema::InputId id{static_cast<std::uint32_t>(spec.inputs.size())};
  spec.inputs.push_back(std::move(input));
  auto signal = std::make_unique<sema::Expr>(
      sema::Expr{choice.condition->range, true, {}, sema::InputRef{id, 0}});
  return std::exchange(choice.condition, std::move(signal));
}

}  // namespace

OpenedChoices::OpenedChoices(const std::string& text) {
  const std::vector<bool> rounded = which_are_rounded(text);
  checked_ = check(text, Until::checked);
  monitors_ = checked_->compilation.spec->watches.size();
  if (std::find(rounded.begin(), rounded.end(), true) != rounded.end()) open(rounded);
}

void OpenedChoices::open(const std::vector<bool>& rounded) {
  sema::Spec& spec = *checked_->compilation.spec;
  std::vector<sema::Watch> opened, conditions;
  std::size_t at = 0;
  for (std::size_t k = 0; k < monitors_; ++k) {
    std::vector<sema::Choice*> choices;
    collect(*spec.watches[k].always, choices);
    const std::size_t before = conditions.size();
    for (sema::Choice* choice : choices) {
      if (!rounded[at++]) continue;
      conditions.push_back(watch_of(conditions.size(), replaced(spec, *choice, conditions.size())));
    }
    if (conditions.size() == before) continue;
    opened_.push_back(k);
    opened.push_back(std::move(spec.watches[k]));
  }
  conditions_ = conditions.size();
  for (sema::Watch& each : conditions) opened.push_back(std::move(each));
  spec.watches = std::move(opened);
  bounds_ = roundings(checked_->compilation);
  interface_ = driver::kernel_code(checked_->compilation).interface;
}

// A second step within a tick brings nothing new.
Steps OpenedChoices::with_conditions(const Steps& run,
                                     const std::vector<std::string>& letters) const {
  Steps all = run;
  for (std::size_t i = 0; i < run.size(); ++i) {
    for (const std::string& letter : letters) {
      driver::Observed o{{}, run[i].now_us, !is_repeated(run, i)};
      o.reading.kind =
          letter[i] == '?' ? interp::Reading::Kind::unknown : interp::Reading::Kind::number;
      o.reading.number = interp::Decimal(letter[i] == '1' ? 1 : 0);
      all[i].inputs.push_back(o);
    }
  }
  return all;
}

// As a kernel has to decide it.
char OpenedChoices::decided(std::size_t condition, const Finding& opened) const {
  const ir::Rounding& bound = bounds_[opened_.size() + condition];
  const interp::Extended by(bound.millionths);
  if (bound.has_exact_verdict) return opened.verdict;
  if (by < opened.lo) return '1';
  return opened.hi < -by ? '0' : '?';
}

// Conditions may have choices themselves: until no more of them is decided.
Findings OpenedChoices::find(const Steps& run) const {
  Findings all(monitors_);
  if (opened_.empty()) return all;
  std::vector<std::string> letters(conditions_, std::string(run.size(), '?'));
  Findings found;
  for (bool is_new = true; is_new;) {
    const auto engine = driver::make_interpreter(*checked_->compilation.spec);
    found = differential::find(*engine, interface_, with_conditions(run, letters));
    is_new = false;
    for (std::size_t c = 0; c < conditions_; ++c) {
      for (std::size_t i = 0; i < run.size(); ++i) {
        const char letter = decided(c, found[opened_.size() + c][i]);
        is_new = is_new || letter != letters[c][i];
        letters[c][i] = letter;
      }
    }
  }
  for (std::size_t k = 0; k < opened_.size(); ++k) all[opened_[k]] = std::move(found[k]);
  return all;
}

const ir::Rounding& OpenedChoices::bound(std::size_t monitor) const {
  const auto at = std::find(opened_.begin(), opened_.end(), monitor);
  return bounds_[static_cast<std::size_t>(at - opened_.begin())];
}

}  // namespace rtac::differential
