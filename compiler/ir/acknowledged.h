// What the author of a specification has accepted, with a reason.
#pragma once

#include <algorithm>
#include <string>

#include "compiler/ir/module.h"

namespace rtac::ir {

// `acknowledge RECOVERY may break MONITOR "why"`
inline bool acknowledged(const Decision& decision, const std::string& recovery,
                         const std::string& monitor) {
  const auto& all = decision.acknowledgements;
  return std::any_of(all.begin(), all.end(), [&](const Acknowledgement& a) {
    return a.recovery == recovery && a.monitor == monitor;
  });
}

}  // namespace rtac::ir
