// Clauses that several contracts of a decision have in common. Where they are printed, $D stands
// for the name of the decision, $P for the prefix, $N for the number of monitors, $L for the last
// of them, $R and $Q for the robots likewise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/contract/monitors.h"

namespace rtac::contract {

using Clauses = std::vector<std::string>;

std::string number(std::int64_t value);
std::string number(std::size_t value);
std::string joined(const std::string& word, const Clauses& clauses);

// The mark of what is taken for granted of a decision that looks at other robots; see
// compiler/docs/kernel_proof.md.
std::string granted(const DecisionFacts& f);

Clauses pointers(const DecisionFacts& f);  // of a view
Clauses measured(const DecisionFacts& f);  // what `measure` leaves in a view
Clauses looked(const DecisionFacts& f);    // and `look`
Clauses state(const DecisionFacts& f);     // what every step leaves in `s`
Clauses checks(const DecisionFacts& f);    // what `check` leaves in `checks`
// That `plan` is as it was when the function began, if there is one.
Clauses plan_kept(const DecisionFacts& f, const std::string& plan);

// Look-ahead and latency of a monitor, us.
std::int64_t horizon_of(const DecisionFacts& f, std::size_t i);

std::string check_contract(const DecisionFacts& f);

// That the look-ahead of monitor `k`, or its return condition, was found true.
std::string looked_well(std::size_t k);

// Of `mode_step` for so many monitors.
std::string switching_contract(std::size_t count);

}  // namespace rtac::contract
