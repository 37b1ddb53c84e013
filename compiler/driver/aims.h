// Scenarios in which an attack would show what `rtac verify` has refuted.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/sema/spec.h"
#include "compiler/verify/obligation.h"

namespace rtac::driver {

// What `rtac-sim` reads (docs/simulation.md, scenarios).
using Scenario = nlohmann::ordered_json;

// Recoveries that take over from each other do so for longer than most ways out take.
constexpr int turns_last_s = 300;

// The likeliest first. `robots`: of the decision, by name; `charge`: the monitor of it that speaks
// of charge, "" if none does.
std::vector<Scenario> aimed_at(const verify::Obligation& o, const sema::Spec& spec,
                               const std::vector<std::string>& robots, const std::string& charge);

// It is about control that is not given back, and no violation.
bool about_return(const verify::Obligation& o);

}  // namespace rtac::driver
