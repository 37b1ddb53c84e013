// Plain inputs of a decision. Nobody knows what an application will say: each run draws it by its
// seed, or its scenario says it, and it stays so through the run. The look-ahead takes what is said
// now to go on (language rule 9.3): of a change nobody claims anything.
#pragma once

#include <string>
#include <vector>

#include "case.h"
#include "scenario.h"

namespace rtac::simulate {

// By component of all inputs of the decision: what is so, and what is measured of it.
struct Told {
  std::vector<double> is, measured;
};

// Such that no property is false whatever the robots do, but for those of inputs alone that the
// scenario wants to be. `draw_number`: of several draws for one
// seed.
Problem draw_inputs(const DecisionCase& decision, const Scenario& scenario, std::uint64_t seed,
                    std::uint64_t draw_number, Told& told);

// They are in range, and measured within the error.
bool can_be(const DecisionCase& decision, const Told& told);

// The same decision where that is so. A property of inputs alone that is false then is none of the
// robots': it engages its recovery, and nobody is judged by it.
DecisionCase with_inputs(const DecisionCase& decision, const Told& told);

// `open = true, limit = 0.5`
std::string text_of(const DecisionCase& decision, const Told& told);

// What a scenario says of inputs that no decision has, or of another kind.
Problem check_inputs(const Scenario& scenario, const Case& all);

}  // namespace rtac::simulate
