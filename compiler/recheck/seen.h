// Whether a property can be seen to hold at all, whatever the errors of the sensors: what has to
// hold of it at once.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "compiler/recheck/zones.h"
#include "compiler/sema/spec.h"

namespace rtac::recheck {

// Of each `or` that has a zone on every side, those zones.
std::vector<std::vector<sema::ZoneId>> sides_at_once(const sema::Expr& property);

// Whether of each such `or` one of these zones, by name, is a side.
bool is_on_each_side(const NamedZones& named, const sema::Expr& property,
                     const std::set<std::string>& zones);

// A limit of speed, height or charge that errors hide in every state; "": there is none.
std::string limit_unseen(const sema::Spec& spec, const sema::Decision& decision,
                         const sema::Expr& property);

}  // namespace rtac::recheck
