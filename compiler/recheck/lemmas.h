// The lemmas that the look-ahead of a property rests on (docs/lemmas.md), from what it is written
// with.
#pragma once

#include <set>
#include <string>

#include "compiler/sema/spec.h"

namespace rtac::recheck {

std::set<std::string> lemmas_for(const sema::Spec& spec, const sema::Decision& decision,
                                 const sema::Monitor& monitor);

}  // namespace rtac::recheck
