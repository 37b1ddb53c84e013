// How the obligations of one decision are shown. Each function returns one of them, with the claims
// that it rests on.
#pragma once

#include "compiler/analysis/arbitration.h"
#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"
#include "compiler/verify/obligation.h"

namespace rtac::verify {

// What all proofs of a decision speak of.
struct Subject {
  const sema::Spec& spec;
  const ir::Module& module;
  const sema::Decision& written;
  const ir::Decision& decision;
  const analysis::ExactZone& exact;
  const sema::RobotKind& kind;
  [[nodiscard]] const sema::Monitor& monitor(std::size_t k) const {
    return spec[written.priority[k]];
  }
};

// ---- the rules of switching
Obligation decided_in_time(const Subject& s, std::size_t k);
Obligation same_output(const Subject& s);
Obligation drives_until_next(const Subject& s, std::size_t k);
Obligation starts_well(const Subject& s);

// ---- the recoveries
Obligation recovery_keeps(const Subject& s, std::size_t k);
Obligation control_returns(const Subject& s, std::size_t k);
Obligation keeps_others(const Subject& s, const analysis::Entry& entry, std::size_t driving,
                        std::size_t judged);

// ---- the places
Obligation can_hold(const Subject& s, std::size_t k);
Obligation can_fail(const Subject& s, std::size_t k);
Obligation returns_together(const Subject& s);

// Of a decision on a plan.
std::vector<Obligation> plan_obligations(const Subject& s);

// The integers that the kernel counts with, for a program that has its own idea of them.
Claim limits_claim(const Subject& s);
Claim lemma_claim(const std::string& lemma);

}  // namespace rtac::verify
