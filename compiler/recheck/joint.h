// That all monitors give control back at once: one place, one height and one set of inputs for all
// of them, and room for all robots.
#pragma once

#include <string>
#include <vector>

#include "compiler/recheck/written.h"

namespace rtac::recheck {

// Why the claims of a joint return do not show it; none: they do.
std::vector<std::string> doubts_of_return(const sema::Spec& spec, const sema::Decision& decision,
                                          const Entry& entry, Claims& claims);
// The same of each `return when` of all monitors, or of `only` one of them: what inputs or else
// places make true, the inputs of the claim `told` make true by themselves. null: there is none.
std::vector<std::string> torn_returns(const sema::Spec& spec, const sema::Decision& decision,
                                      Claims& claims, const std::string& only, const Claim* told);

}  // namespace rtac::recheck
