// Which recoveries a decision might have instead of its own, so that what is open may be shown.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "compiler/verify/proofs.h"

namespace rtac::verify {

// Of recoveries that take turns, by name: that one of their monitors has that of another,
// that one moves where it keeps what another one says, or that it is so slow that it keeps a limit.
std::vector<Mend> other_recoveries(const Subject& s, const analysis::Arbitration& matrix,
                                   const std::set<std::string>& in_turns);

// Of a monitor whose recovery leads to where its `return when` does not hold: that it has another
// one of the decision, or that its own moves within a zone that is asked for there.
std::vector<Mend> recoveries_to_its_condition(const Subject& s, std::size_t k);

}  // namespace rtac::verify
