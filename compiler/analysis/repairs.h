// Which one number of a robot, or of its decision, would have to be another one: the help of errors
// that many numbers are the cause of together.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "compiler/analysis/trials.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"

namespace rtac::analysis {

// What a number changes: the period, the limits of the body and of any control, the time that the
// return condition looks further ahead. Nothing else of the decision is filled in.
struct Trial {
  sema::RobotKind kind;
  ir::Decision decision;
  std::int64_t lookahead_us = 0;  // the longest of its monitors
};
using Fits = std::function<bool(const Trial&)>;
// The longest look-ahead, or one that is as long as commands take to act.
inline std::int64_t covering_us(const Trial& t) {
  return std::max(t.lookahead_us, t.decision.body.latency_us);
}

// The decision as it is written, or with another look-ahead of all monitors that declare a longer
// one.
Trial trial_of(const sema::Spec& spec, const sema::Decision& decision);
Trial with_lookahead(const sema::Spec& spec, const sema::Decision& decision, std::int64_t most_us);

// Texts like "a `latency` of at most 120 ms", the least change first, three at most. With each of
// them alone the whole specification has been tried (Trials::nearest): `fits`, which holds of
// numbers with which `fault` may be gone, only says where to begin. Numbers that other checks would
// refuse are left out. Without `trials` none.
std::vector<std::string> repairs(const sema::Decision& decision, Trials* trials, const Fault& fault,
                                 const Fits& fits);
// The same, and where no number is enough alone, both errors of a place and of a speed.
std::vector<std::string> repairs_or_both_errors(const sema::Decision& decision, Trials* trials,
                                                const Fault& fault, const Fits& fits);

// `a; b; or c`, each after `before`: "" without any.
std::string joined(const std::vector<std::string>& texts);

}  // namespace rtac::analysis
