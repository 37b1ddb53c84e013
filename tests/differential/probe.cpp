#include "tests/differential/probe.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "tests/differential/generator.h"
#include "tests/differential/traces.h"

namespace rtac::differential {
namespace {

using Ends = std::vector<driver::MarginEnds>;

// In steps of a scale, such as twentieths of a metre.
std::string constant(std::int64_t steps, const Scale& scale) {
  const auto per_unit = static_cast<Micro>(scale.steps);
  constexpr Micro one = 1000000;
  const std::string number =
      per_unit == 1 ? std::to_string(steps) : decimal(steps * one / per_unit);
  return number + (scale.unit.empty() ? "" : " " + scale.unit);
}

// How often the rarest verdict on `at least limit` occurs.
std::size_t rarest(const Ends& found, const interp::Extended& limit) {
  std::size_t yes = 0, no = 0;
  for (const driver::MarginEnds& ends : found) {
    yes += ends.lo < limit ? 0 : 1;
    no += ends.hi < limit ? 1 : 0;
  }
  return std::min({yes, no, found.size() - yes - no});
}

std::pair<std::int64_t, std::size_t> best_limit(const Ends& found, const Scale& scale) {
  std::set<std::int64_t> candidates{0};
  const Rational per_unit = static_cast<long>(scale.steps);
  for (const driver::MarginEnds& ends : found) {
    if (ends.lo.is_finite()) candidates.insert(ceil_to_int(ends.lo.value() * per_unit));
  }
  std::pair<std::int64_t, std::size_t> best{0, 0};
  for (const std::int64_t candidate : candidates) {
    const Rational limit = Rational(static_cast<long>(candidate)) / per_unit;
    const std::size_t score = rarest(found, interp::Extended(limit));
    if (score > best.second) best = {candidate, score};
  }
  return best;
}

// Whole numbers are on every grid, others on most.
Probed with_limit(const Formula& f, const Ends& found) {
  constexpr std::size_t enough = 3;
  Scale scale = *scale_of(f.type);
  const std::size_t fine = std::exchange(scale.steps, 1);
  auto [limit, score] = best_limit(found, scale);
  if (score < enough && fine > 1) {
    scale.steps = fine;
    std::tie(limit, score) = best_limit(found, scale);
  }
  return {f.text + " >= " + constant(limit, scale), score};
}

}  // namespace

Formula measured(const Formula& f) {
  switch (f.type) {
    case Type::gear:
      return {f.text + " == park", Type::condition};
    case Type::vector:
    case Type::point:
    case Type::turned:
    case Type::near:
    case Type::spot:
    case Type::vector3:
    case Type::point3:
      return {f.text + ".y", Type::length};
    case Type::pose:
      return {f.text + ".heading", Type::angle};
    case Type::twist:
      return {f.text + ".linear", Type::speed};
    case Type::condition:
    case Type::whole:
    case Type::number:
    case Type::length:
    case Type::area:
    case Type::angle:
    case Type::time:
    case Type::speed:
    case Type::share:
    case Type::heat:
      return f;
  }
  return f;
}

std::string monitor_line(std::size_t k, const std::string& condition) {
  return "monitor m" + std::to_string(k) + " { \"P-1: a pair\" always " + condition + "; }\n";
}
std::string monitor_of_robots() {
  return monitor_line(0,
                      "forall any : Rover : (any.battery >= 10 % or any.speed <= 30 cm/s or "
                      "any.position.x >= 0 m)");
}

namespace {

// As if the margin of a condition were one unit in size.
driver::MarginEnds ends_of(interp::Verdict verdict) {
  const interp::Extended yes(Rational(1)), no(Rational(-1));
  return {verdict == interp::Verdict::yes ? yes : no, verdict == interp::Verdict::no ? no : yes};
}

}  // namespace

std::vector<Probed> probe(const std::vector<Formula>& formulas, const Scope& scope,
                          std::string& problem) {
  std::string text = declarations() + monitor_of_robots();
  for (std::size_t k = 0; k < formulas.size(); ++k) {
    const Scale* const scale = scale_of(formulas[k].type);
    const std::string limit = scale == nullptr ? "" : " >= " + constant(0, *scale);
    text += monitor_line(k + 1, formulas[k].text + limit);
  }
  const auto checked = check(text, Until::checked);
  problem = checked->problem;
  if (!problem.empty()) return {};
  const sema::Spec& spec = *checked->compilation.spec;
  const auto reference = driver::make_interpreter(spec);
  std::vector<Ends> found(formulas.size());
  std::vector<driver::Judgement> judgements;
  Troubles ignored;
  for (const Step& step : random_runs(scope.seed, scope.runs, scope.steps, spec, ignored)) {
    if (step.is_restart) reference->restart();
    reference->step(step.now_us, step.inputs, judgements);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const bool is_condition = formulas[k].type == Type::condition;
      found[k].push_back(is_condition ? ends_of(judgements[k + 1].verdict)
                                      : reference->margin(k + 1));
    }
  }
  std::vector<Probed> all;
  for (std::size_t k = 0; k < formulas.size(); ++k) {
    const bool is_condition = formulas[k].type == Type::condition;
    all.push_back(is_condition
                      ? Probed{formulas[k].text, rarest(found[k], interp::Extended(Rational(0)))}
                      : with_limit(formulas[k], found[k]));
  }
  return all;
}

}  // namespace rtac::differential
