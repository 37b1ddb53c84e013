// Whether a property of robots can be false: which states of the world would show it, from what
// each signal can be by itself.
#pragma once

#include <string>
#include <vector>

#include "compiler/analysis/told.h"
#include "compiler/ir/module.h"

namespace rtac::analysis {

enum class CanFail { yes, no, open };
struct Vacuity {
  CanFail can_fail = CanFail::open;
  // What makes it false; or, of what is never false, what its signals can be at all.
  std::vector<std::string> because;
  bool alone = false;  // of what is never false, it is about other robots, and there is none
};
// Never false is a property that finds nothing, whatever the robots do.
// `told`: whether inputs can make it false, as far as it is up to them.
Vacuity vacuity_of(const ir::Module& module, const ir::Decision& decision,
                   const ir::Block& property, CanBeTold told);

}  // namespace rtac::analysis
