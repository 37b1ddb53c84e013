#include "tests/differential/batch.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace rtac::differential {
namespace {

using interp::Extended;

// Each end of `outer` lies at most `by` further out than that of `inner`.
bool is_near(const Finding& outer, const Finding& inner, const Rational& by) {
  const bool lo_is_near = !(outer.lo < inner.lo + Extended(Rational(-by)));
  const bool hi_is_near = !(inner.hi + Extended(by) < outer.hi);
  return lo_is_near && hi_is_near;
}

bool is_same(const Extended& a, const Extended& b) {
  return compare(a, b) == 0;
}

std::string shown(const Extended& end) {
  if (end.is_finite()) return to_decimal(end.value());
  return end.sign() < 0 ? "-inf" : "inf";
}
std::string shown(const Finding& finding) {
  return std::string(1, finding.verdict) + " [" + shown(finding.lo) + ", " + shown(finding.hi) +
         "]" + (finding.unit.empty() ? "" : " " + finding.unit);
}
std::string letters(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) text += finding.verdict;
  return text;
}

std::string written(const Step& step, const std::vector<Signal>& signals) {
  std::ostringstream text;
  text << "  at " << step.now_us << " us:";
  std::size_t at = 0;
  for (const Signal& s : signals) {
    for (std::size_t c = 0; c < s.components; ++c, ++at) {
      const driver::Observed& o = step.inputs[at];
      text << " " << s.name << "=";
      if (!o.is_new) {
        text << "-";
      } else if (o.reading.kind != interp::Reading::Kind::number) {
        text << "nan";
      } else {
        text << to_decimal(o.reading.number.value());
      }
      if (o.is_new && o.stamp_us != step.now_us) text << "@" << o.stamp_us;
    }
  }
  for (const ParamChange& change : step.params) {
    text << " param " << change.param << "=" << to_decimal(change.value);
  }
  return (step.is_restart ? "  a new run\n" : "") + text.str() + "\n";
}

}  // namespace

Batch::Batch(std::uint32_t seed, std::size_t count, std::size_t steps,
             const std::vector<std::string>& given, std::size_t runs)
    : variant_(count == 0 ? 0 : seed + 2), monitors_(given) {  // of random ones
  Generator generator(seed);
  for (std::size_t k = 0; k < count; ++k) monitors_.push_back(generator.monitor(k));
  remove_refused();
  const auto checked = check(specification(), Until::kernel);
  problem_ = checked->problem;
  if (!problem_.empty()) return;
  driver::Compilation& c = checked->compilation;
  for (const ir::PlainMonitor& m : c.module->watch->monitors) {
    bounds_.push_back(ir::rounding_of(*c.spec, *c.module->watch, m.property));
  }
  signals_ = signals_of(*c.spec);
  run_ = random_runs(seed, runs, steps, *c.spec, troubles_);
  code_ = driver::kernel_code(c);
  reference_ = find(*driver::make_interpreter(*c.spec), code_.interface, run_);
  choices_ = std::make_unique<OpenedChoices>(specification());
  opened_ = choices_->find(run_);
}

std::string Batch::verdicts(std::size_t monitor) const {
  return letters(reference_[monitor]);
}

std::string Batch::specification() const {
  std::string text = declarations(variant_);
  for (const std::string& line : monitors_) text += line;
  return text;
}

// A formula may be refused because its values leave the range of the kernel, or its constant is on
// no grid.
void Batch::remove_refused() {
  const std::string head = declarations(variant_);
  const auto before = static_cast<std::size_t>(std::count(head.begin(), head.end(), '\n'));
  constexpr int phases = 3;  // each reports its own errors
  for (int i = 0; i < phases; ++i) {
    const auto checked = check(specification(), Until::kernel);
    if (checked->problem.empty()) return;
    refused_ += checked->problem;
    std::vector<std::string> kept;
    for (std::size_t k = 0; k < monitors_.size(); ++k) {
      const auto line = static_cast<std::uint32_t>(before + k + 1);
      if (!checked->lines.contains(line)) kept.push_back(monitors_[k]);
    }
    monitors_ = std::move(kept);
  }
}

// Verdicts first: they are what is acted upon. The margins of the kernel contain the exact ones,
// and are no wider than the compiler promises.
std::string Batch::fault(std::size_t k, std::size_t step, const Finding& found) const {
  const ir::Rounding& bound = bounds_[k];
  const Finding& exact = reference_[k][step];
  if (found.verdict != '?' && found.verdict != exact.verdict) return "not conservative";
  if (bound.has_exact_verdict && found.verdict != exact.verdict) return "another verdict";
  if (!bound.has_verdicts_only && (exact.lo < found.lo || found.hi < exact.hi)) {
    return "the margin leaves out the exact one";
  }
  // of what is rounded, another atom may decide
  const bool is_exact = bound.millionths == 0 || !exact.lo.is_finite();
  if (is_exact && is_same(found.lo, exact.lo) && found.unit != exact.unit) return "another unit";
  return looseness(k, step, found);
}

// A choice may be left open where its condition is within the bound, and what it gives is rounded.
std::string Batch::looseness(std::size_t k, std::size_t step, const Finding& found) const {
  const bool has_open = !opened_[k].empty();
  const Finding& allowed = has_open ? opened_[k][step] : reference_[k][step];
  const ir::Rounding& bound = has_open ? choices_->bound(k) : bounds_[k];
  const Extended by(bound.millionths);
  if (by < allowed.lo && found.verdict != '1') {
    return "not tight: it is true by more than the bound";
  }
  if (allowed.hi < -by && found.verdict != '0') {
    return "not tight: it is false by more than the bound";
  }
  if (bound.has_verdicts_only) return "";
  if (!is_near(found, allowed, bound.millionths)) return "the margin is wider than the bound";
  // What is promised of the whole is as wide as the ranges of the sides.
  const bool has_sides = found.lo.is_finite() && found.hi.is_finite();
  return !has_open || !has_sides || is_near(found, reference_[k][step], bounds_[k].millionths)
             ? ""
             : "the margin is wider than what is promised of choices";
}

void Batch::count(std::size_t k, const Finding& exact, const Finding& found, Result& result,
                  bool& is_sharp) const {
  ++(found.verdict == '1' ? result.yes : found.verdict == '0' ? result.no : result.unknown);
  if (!exact.lo.is_finite() || !found.lo.is_finite()) return;
  ++result.margins;
  const Rational off = exact.lo.value() - found.lo.value();
  result.rounded += sgn(off) != 0 ? 1 : 0;
  if (sgn(off) != 0 && off * 2 >= bounds_[k].millionths) is_sharp = true;
}

Batch::Result Batch::compare(driver::Engine& kernel) const {
  kernel.restart();
  const Findings found = find(kernel, code_.interface, run_);
  Result result;
  for (std::size_t k = 0; k < monitors_.size(); ++k) {
    bool differs = false, is_sharp = false;
    for (std::size_t i = 0; i < run_.size(); ++i) {
      if (is_repeated(run_, i)) continue;
      count(k, reference_[k][i], found[k][i], result, is_sharp);
      const std::string what = fault(k, i, found[k][i]);
      if (what.empty()) continue;
      if (!differs && result.different == 0) result.first = described(k, i, what, found[k]);
      differs = true;
    }
    result.different += differs ? 1 : 0;
    result.sharp += is_sharp ? 1 : 0;
  }
  return result;
}

std::string Batch::disagreement(driver::Engine& one, driver::Engine& other) const {
  one.restart();
  other.restart();
  const std::vector<std::string> first = judge(one, run_), second = judge(other, run_);
  for (std::size_t k = 0; k < monitors_.size(); ++k) {
    if (first[k] == second[k]) continue;
    return monitors_[k] + "  one   " + first[k] + "\n  other " + second[k] + "\n";
  }
  return "";
}

std::string Batch::described(std::size_t k, std::size_t step, const std::string& fault,
                             const std::vector<Finding>& found) const {
  constexpr std::size_t shown_steps = 12;
  std::string text = monitors_[k];
  for (std::size_t i = step < shown_steps ? 0 : step - shown_steps; i <= step; ++i) {
    text += written(run_[i], signals_);
  }
  if (!opened_[k].empty()) text += "  open   " + shown(opened_[k][step]) + "\n";
  return text + "  " + fault + "\n  exact  " + shown(reference_[k][step]) + "\n  kernel " +
         shown(found[step]) + "\n  bound  " + to_decimal(bounds_[k].millionths) + "\n  reference " +
         letters(reference_[k]) + "\n  kernel    " + letters(found) + "\n";
}

}  // namespace rtac::differential
