// What a monitor asks for beside its property before it lets go, as it is written: whether that
// comes about where its recovery has led, by itself or as soon as inputs say so.
#pragma once

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// `left`: how clear of the boundary of its zone the recovery has led to, in m.
bool lets_go(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
             const sema::Monitor& monitor, const Rational& left);

}  // namespace rtac::recheck
