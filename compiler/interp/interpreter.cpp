#include "compiler/interp/interpreter.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "compiler/sema/dimension.h"

namespace rtac::interp {
namespace {

// Rule 1: longer gaps make the past unknown.
constexpr Tick missed_ticks_max = 4;

Rational floor(const Rational& value) {
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), value.get_num().get_mpz_t(), value.get_den().get_mpz_t());
  return Rational(whole);
}
Rational ceiling(const Rational& value) {
  return -floor(Rational(-value));
}

std::vector<Rational> initial(const std::vector<sema::Param>& params) {
  std::vector<Rational> values;
  for (const sema::Param& param : params) values.push_back(param.value.value);
  return values;
}

// Decisions on plans have none, and nothing in them lasts.
Rational period_of(const sema::Decision& decision) {
  return decision.period ? decision.period->value : Rational(1);
}

}  // namespace

std::vector<Interpreter::Conditions> Interpreter::conditions(const sema::Spec& spec) {
  std::vector<Conditions> all;
  for (const sema::Watch& watch : spec.watches) all.push_back({watch.always.get(), nullptr});
  return all;
}
std::vector<Interpreter::Conditions> Interpreter::conditions(const sema::Spec& spec,
                                                             const sema::Decision& decision) {
  std::vector<Conditions> all;
  for (const sema::MonitorId id : decision.priority) {
    all.push_back({spec[id].always.get(), spec[id].return_when.get()});
  }
  return all;
}

Interpreter::Interpreter(const sema::Spec& spec)
    : Interpreter(spec, spec.period->value, conditions(spec), nullptr,
                  std::make_shared<Zones>(spec)) {}

Interpreter::Interpreter(const sema::Spec& spec, const sema::Decision& decision, sema::RobotId self,
                         std::shared_ptr<Zones> zones)
    : Interpreter(spec, period_of(decision), conditions(spec, decision),
                  std::make_unique<Robots>(spec, self), std::move(zones)) {}

Interpreter::Interpreter(const sema::Spec& spec, const Rational& period,
                         std::vector<Conditions> monitors, std::unique_ptr<Robots> robots,
                         std::shared_ptr<Zones> zones)
    : spec_(spec),
      period_(period),
      monitors_(std::move(monitors)),
      params_(initial(spec.params)),
      wanted_params_(params_),
      signals_(spec.inputs),
      robots_(std::move(robots)),
      zones_(std::move(zones)),
      evaluator_({spec, signals_, params_, *zones_, robots_.get()}, period),
      findings_(monitors_.size()),
      returns_(monitors_.size(), Verdict::yes),
      clock_(period) {}

void Interpreter::miss() {
  signals_.miss();
  if (robots_) robots_->miss();
}

// Rule 1: a missed tick is all-unknown, at most 4; beyond that the past resets to unknown.
const std::vector<Finding>& Interpreter::step(std::int64_t now_us, const Inputs& inputs,
                                              const FleetSamples& robots) {
  const Tick tick = clock_.at(now_us);
  if (tick <= tick_) return findings_;
  if (tick_ >= 0 && tick - tick_ - 1 > missed_ticks_max) {
    evaluator_.forget(tick - 1);
  } else {
    miss();
    for (Tick missed = tick_ + 1; missed < tick; ++missed) {
      evaluator_.start(missed);
      judge();
    }
  }
  const bool follows = tick_ >= 0 && tick == tick_ + 1;
  signals_.arrive(now_us, follows ? before_us_ : one_period_before(now_us), inputs);
  if (robots_) robots_->arrive(now_us, robots);
  params_ = wanted_params_;
  tick_ = tick;
  before_us_ = now_us;
  evaluator_.start(tick_, now_us);
  judge();
  return findings_;
}

// Rule 8: every plan is judged anew, whenever it comes.
const std::vector<Finding>& Interpreter::judge_plan(const std::optional<Plan>& plan) {
  robots_->propose(plan);
  evaluator_.start(++tick_);
  judge();
  return findings_;
}

// The time of a tick before this one that no step belongs to.
std::int64_t Interpreter::one_period_before(std::int64_t now_us) const {
  const std::int64_t period_us = floor_to_int(period_ * 1000000);
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();
  return now_us < least + period_us ? least : now_us - period_us;
}

// Robots that share the zones have inputs of their own.
void Interpreter::receive_zones() {
  for (std::uint32_t i = 0; i < spec_.zones.size(); ++i) {
    const auto* received = std::get_if<sema::ZoneReceived>(&spec_.zones[i].value->node);
    if (received != nullptr) zones_->receive(sema::ZoneId{i}, signals_.zone(received->input));
  }
}

void Interpreter::judge() {
  receive_zones();
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    findings_[i] = report(evaluator_.condition(*monitors_[i].always));
    if (monitors_[i].return_when == nullptr) continue;
    returns_[i] = verdict(evaluator_.condition(*monitors_[i].return_when));
  }
}

void Interpreter::set_param(sema::ParamId id, const Rational& value) {
  const sema::Param& param = spec_[id];
  Rational& present = wanted_params_[static_cast<std::size_t>(id)];
  const Rational steps = value / param.resolution;
  const Rational wanted = param.resolution * (param.tightens > 0 ? ceiling(steps) : floor(steps));
  if (wanted < param.least.value || wanted > param.most.value) return;
  const bool tightens = param.tightens > 0 ? wanted > present : wanted < present;
  if (param.tightens != 0 && tightens) present = wanted;
}

const Interpreter::Shown& Interpreter::shown(const sema::Dimension& dimension) {
  const auto found = shown_.find(&dimension);
  if (found != shown_.end()) return found->second;
  Rational factor = evaluator_.scale(dimension);
  // Every power of a ratio is shown in per cent.
  for (int i = 0; i < dimension.ratio; ++i) factor *= 100;
  for (int i = 0; i > dimension.ratio; --i) factor /= 100;
  return shown_.emplace(&dimension, Shown{sema::unit_of(dimension), factor}).first->second;
}

// Rule 4.4: the margin that is reported is that of the atom that decides, in its own unit; where it
// is infinite there is none.
Finding Interpreter::report(const Margin& margin) {
  Finding finding;
  finding.verdict = verdict(margin);
  finding.lo = margin.lo.value;
  finding.hi = margin.hi.value;
  const sema::Dimension* dimension = margin.lo.origin.dimension;
  if (dimension != nullptr && finding.lo.is_finite()) {
    const Shown& unit = shown(*dimension);
    finding.unit = unit.unit;
    finding.lo = finding.lo * Extended(unit.factor);
    finding.hi = finding.hi * Extended(unit.factor);
  }
  const Missing& lo = margin.lo.origin.missing;
  const Missing& missing = lo.missing ? lo : margin.hi.origin.missing;
  switch (finding.verdict) {
    case Verdict::yes:
      finding.reason = Reason::none;
      break;
    case Verdict::no:
      finding.reason = Reason::margin;
      break;
    case Verdict::unknown:
      finding.reason = missing.missing ? Reason::input : Reason::within_error;
      finding.input = missing.input;
      break;
  }
  return finding;
}

}  // namespace rtac::interp
