// What parts of the module are called in the language.
#pragma once

#include "compiler/ir/module.h"

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

}  // namespace rtac::ir
