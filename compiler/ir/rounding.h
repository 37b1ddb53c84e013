// How far the integers of a kernel may be from exact numbers.
#pragma once

#include "compiler/ir/module.h"
#include "compiler/sema/spec.h"
#include "compiler/support/rational.h"

namespace rtac::ir {

// Of the margin of one monitor without a robot. Every operation rounds outward, so the interval of
// the kernel contains the exact one; by this much its ends may lie further out. So the kernel finds
// true what has an exact margin above the bound, and false what has one below minus the bound.
// Exact is what the declared errors leave: they are part of both intervals.
struct Rounding {
  // Millionths of the scale: what connectives compare. 0: margins are exact.
  Rational millionths;
  bool has_exact_verdict = true;  // whatever the margin
  // A choice between quantities hangs on a comparison that is itself rounded: the bound holds while
  // both sides of it are known, and may be as wide as their ranges.
  bool has_rounded_choice = false;
  // A window is too long for margins: finite ones become infinite, the verdict stays as above.
  bool has_verdicts_only = false;
  // It asks how far legs are within a zone, or outside: the bound is that of legs on one side of
  // the boundary, and others may be unknown where they lead beyond by more.
  bool has_crossing_legs = false;
};

// The block has its ranges (passes: analyse_watch_ranges). What is more than `margin_max`
// (weights.h) is left out: such margins are cut off.
Rounding rounding_of(const sema::Spec& spec, const Watch& watch, const Block& block);

}  // namespace rtac::ir
