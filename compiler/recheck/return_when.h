// What a monitor asks for beside its property before it lets go, as it is written: whether that
// comes about where its recovery has led, by itself or as soon as inputs say so.
#pragma once

#include "compiler/recheck/claims.h"

namespace rtac::recheck {

// How fast a robot that has come to rest may be seen to be, driven by the recovery of a monitor, in
// m/s: it may have gained speed since its position was measured.
Rational shown_at_rest(const sema::Spec& spec, const Numbers& numbers,
                       const sema::Monitor& monitor);
// The charge that every sample of a full battery shows, of 1: its error counts twice, once for what
// is measured and once for what that may mean, and the charge falls as it ages. 0: it has none.
Rational shown_full(const sema::RobotKind& kind);

// `left`: how clear of the boundary of its zone the recovery has led to, in m.
bool lets_go(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
             const sema::Monitor& monitor, const Rational& left);

// The same at a place, where others are far, batteries full, and inputs as they should be. `z`: in
// space.
bool lets_go_at(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                const sema::Monitor& monitor, const geometry::Point& at,
                const std::optional<Rational>& z);

// Whether this is a limit of its own speed that whoever has come to rest is seen to keep, driven by
// the recovery of the monitor.
bool is_limit_kept_at_rest(const sema::Spec& spec, const sema::Decision& decision, Claims& claims,
                           const sema::Monitor& monitor, const sema::Expr& e);

}  // namespace rtac::recheck
