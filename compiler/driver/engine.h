// What judges a trace: the generated kernel, or the reference interpreter.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "compiler/interp/interpreter.h"
#include "compiler/interp/margin.h"
#include "compiler/interp/trace.h"
#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"

namespace rtac::driver {

// The newest sample of one component at a tick.
struct Observed {
  interp::Reading reading;  // kind none: never received
  std::int64_t stamp_us = 0;
  bool is_new = false;  // since the last tick that was judged
};
struct Judgement {
  interp::Verdict verdict = interp::Verdict::unknown;
  std::string margin;  // of the atom that decides, a decimal number or `inf`, `-inf`
  std::string unit;
};

// As findings show it: `true`, `false`, `unknown`.
const char* word(interp::Verdict verdict);
// The lower end of a margin, never more than it is: exact where 9 decimals hold it, else rounded
// down to a millionth, or to 6 significant digits of what is less than 1.
std::string text_of_margin(const Rational& margin);

// Both ends of the margin of a judgement, in its unit.
struct MarginEnds {
  interp::Extended lo, hi;
};

class Engine {
 public:
  virtual ~Engine() = default;
  // `inputs`: components in the order of declaration. Judgements by monitor, as declared.
  virtual void step(std::int64_t now_us, const std::vector<Observed>& inputs,
                    std::vector<Judgement>& judgements) = 0;
  // Of the last step, for those who compare engines.
  [[nodiscard]] virtual MarginEnds margin(std::size_t monitor) const = 0;
  // What an application does at run time: a value in SI, for the steps that follow.
  virtual void set_param(std::size_t param, const Rational& value) = 0;
  // As before the first step.
  virtual void restart() = 0;
};

Judgement judgement_of(const interp::Finding& finding);
std::unique_ptr<Engine> make_interpreter(const sema::Spec& spec);

}  // namespace rtac::driver
