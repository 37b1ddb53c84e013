// What a property asks for with every zone that comes and goes at its worst.
#pragma once

#include <optional>
#include <vector>

#include "compiler/sema/spec.h"

namespace rtac::recheck {

// Whether an expression speaks of such a zone.
bool speaks_of_windows(const sema::Expr& e);

struct Limit {
  sema::ZoneId zone;
  Rational gap;  // beyond touching
};
// `fails`: whether it is there or not; `limit`: wherever that is kept; `other`: it depends.
struct AtWorst {
  enum class Kind { holds, fails, limit, other } kind = Kind::other;
  std::optional<Limit> limit;
};

AtWorst at_worst(const sema::Spec& spec, const sema::Expr& e);

// The parts of a property that all have to hold, and that speak of such zones.
std::vector<const sema::Expr*> parts_of(const sema::Expr& property);
// That a zone is there is asked for somewhere, and not only what holds meanwhile.
bool waits_for_gates(const sema::Expr& e);
// The zones of which a body is to be in one, with nothing else asked, some of them while they are
// there. nullopt: it is more than that.
std::optional<std::vector<sema::ZoneId>> gates_of(const sema::Spec& spec, const sema::Expr& e);

}  // namespace rtac::recheck
