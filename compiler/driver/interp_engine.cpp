#include <optional>
#include <utility>

#include "compiler/driver/engine.h"
#include "compiler/interp/interpreter.h"

namespace rtac::driver {
namespace {

std::string shown(const interp::Extended& margin) {
  if (margin.is_finite()) return text_of_margin(margin.value());
  return margin.sign() < 0 ? "-inf" : "inf";
}

// To a whole number of steps of 1/`places`.
Rational rounded_down(const Rational& value, const Rational& places) {
  const Rational scaled = value * places;
  mpz_class whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(whole) / places;
}

class InterpEngine : public Engine {
 public:
  explicit InterpEngine(const sema::Spec& spec)
      : spec_(spec), interpreter_(std::in_place, spec), inputs_(spec.inputs.size()) {}

  void step(std::int64_t now_us, const std::vector<Observed>& inputs,
            std::vector<Judgement>& judgements) override {
    std::size_t at = 0;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      const std::size_t count = spec_.inputs[i].components.size();
      inputs_[i] = sample(inputs, at, count);
      at += count;
    }
    const auto& findings = interpreter_->step(now_us, inputs_);
    findings_ = &findings;
    judgements.resize(findings.size());
    for (std::size_t i = 0; i < findings.size(); ++i) {
      judgements[i] = judgement_of(findings[i]);
    }
  }
  [[nodiscard]] MarginEnds margin(std::size_t monitor) const override {
    const interp::Finding& finding = (*findings_)[monitor];
    return {finding.lo, finding.hi};
  }
  void set_param(std::size_t param, const Rational& value) override {
    interpreter_->set_param(sema::ParamId(param), value);
  }
  void restart() override { interpreter_.emplace(spec_); }

 private:
  // The components of an input arrive together.
  static std::optional<interp::Sample> sample(const std::vector<Observed>& inputs, std::size_t at,
                                              std::size_t count) {
    if (count == 0 || !inputs[at].is_new) return std::nullopt;
    interp::Sample sample;
    sample.stamp_us = inputs[at].stamp_us;
    sample.zone = inputs[at].reading.zone;
    sample.path = inputs[at].reading.path;
    for (std::size_t c = at; c < at + count; ++c) {
      const bool known = inputs[c].reading.kind == interp::Reading::Kind::number;
      sample.values.push_back(known ? std::optional(inputs[c].reading.number.value())
                                    : std::nullopt);
    }
    return sample;
  }

  const sema::Spec& spec_;
  std::optional<interp::Interpreter> interpreter_;          // always there
  const std::vector<interp::Finding>* findings_ = nullptr;  // after the first step
  interp::Inputs inputs_;
};

}  // namespace

const char* word(interp::Verdict verdict) {
  switch (verdict) {
    case interp::Verdict::yes:
      return "true";
    case interp::Verdict::no:
      return "false";
    case interp::Verdict::unknown:
      break;
  }
  return "unknown";
}

std::string text_of_margin(const Rational& margin) {
  const Rational billion = 1'000'000'000, million = 1'000'000;
  if (Rational(margin * billion).get_den() == 1) return to_decimal(margin);
  Rational places = million;  // until six digits are in front of the point
  while (abs(Rational(margin * places)) < 100'000) places *= 10;
  return to_decimal(rounded_down(margin, places));
}

Judgement judgement_of(const interp::Finding& finding) {
  return {finding.verdict, shown(finding.lo), finding.unit};
}

std::unique_ptr<Engine> make_interpreter(const sema::Spec& spec) {
  return std::make_unique<InterpEngine>(spec);
}

}  // namespace rtac::driver
