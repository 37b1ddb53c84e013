// What of zones is approximated from one side.
#pragma once

#include <optional>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::analysis {

// Curves, offsets, and places of files are. All else is the same as a keep-in and as a keep-out,
// and evaluated once.
class OneSided {
 public:
  explicit OneSided(const sema::Spec& spec) : spec_(spec), known_(spec.zones.size()) {}

  // Nothing of the zone is.
  bool none(sema::ZoneId id);

 private:
  bool none_in(const sema::ZoneExpr& e);
  bool none(const sema::ZoneRef& ref) { return none(ref.zone); }
  bool none(const sema::ZoneComplement& complement) { return none(complement.zone); }
  bool none(const sema::ZoneBinary& node) { return none_in(*node.left) && none_in(*node.right); }
  static bool none(const sema::ZonePolygon&) { return true; }
  static bool none(const sema::ZoneCircle&) { return false; }
  static bool none(const sema::ZoneOffset&) { return false; }
  static bool none(const sema::ZonePrism&) { return false; }
  static bool none(const sema::ZoneReceived&) { return false; }
  static bool none(const sema::ZoneImport& import);

  const sema::Spec& spec_;
  std::vector<std::optional<bool>> known_;  // by zone
};

}  // namespace rtac::analysis
