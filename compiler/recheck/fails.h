// Whether a property can be false, from what is written.
#pragma once

#include "compiler/recheck/numbers.h"
#include "compiler/recheck/zones.h"

namespace rtac::recheck {

// That some values of its signals, each taken by itself, make it `value`.
bool can_be(const sema::Spec& spec, NamedZones& zones, const sema::Decision& decision,
            const sema::Expr& property, bool value);

}  // namespace rtac::recheck
