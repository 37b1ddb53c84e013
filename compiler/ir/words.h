// What parts of the module are called in the language.
#pragma once

#include <string>

#include "compiler/ir/module.h"
#include "compiler/support/words.h"

namespace rtac::ir {

inline const char* word_of(RecoveryKind kind) {
  switch (kind) {
    case RecoveryKind::external:
      return "extern";
    case RecoveryKind::retreat:
      return "retreat";
    case RecoveryKind::route:
      return "route";
    case RecoveryKind::yield:
      return "yield";
    case RecoveryKind::brake:
      return "brake_and_hold";
    case RecoveryKind::loiter:
      return "loiter";
    case RecoveryKind::sequence:
      return "sequence";
    case RecoveryKind::land:
      return "land";
  }
  return "";
}

// Where a zone is farthest from its boundary: `(1 m, 2 m)`, of one with height with a third one.
inline std::string widest_place(const ZoneTable& zone) {
  return "(" + metres(zone.widest_x_mm) + ", " + metres(zone.widest_y_mm) +
         (zone.has_height() ? ", " + metres(zone.widest_z_mm) : "") + ")";
}

}  // namespace rtac::ir
