// The parts of a model that do not depend on the specification: `*.pml` of this folder.
#pragma once

namespace rtac::protocol {

extern const char* const rules_text;        // what a tick of decision and plan executor does
extern const char* const environment_text;  // what may happen
extern const char* const story_text;        // what a run is told as
extern const char* const claims_text;       // what is claimed
// Of decisions with recoveries that drive on: what comes in addition.
extern const char* const drives_on_text;
// Of decisions that coordinate: the same.
extern const char* const coordinate_text;
extern const char* const coordinate_environment_text;
// Of decisions on a plan.
extern const char* const plan_text;
extern const char* const plan_claims_text;

}  // namespace rtac::protocol
