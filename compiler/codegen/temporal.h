// The operators that remember: what they need in the state of a watch, and how a tick calls them.
// Their meaning is in kernel/temporal.c and kernel/aggregate.c.
//
// The state has one `ticks` for all of them, and every step of a watch evaluates all of them:
//   init:   ticks_start(&s->ticks), temporal_starts
//   tick:   every call once, with unknown operands when the tick was missed; then s->ticks.now += 1
//   gap:    ticks_forget(&s->ticks, tick), temporal_forgets before the calls of `tick`: all that
//   was before is unknown
// Nothing else is initialised: an operator starts anew at the tick from which it remembers.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::codegen {

bool is_temporal(const ir::Op& op);

// What the operators tell, and remember: margins with what decides them, or verdicts alone, which
// take two bits a tick.
enum class Telling { margins, verdicts };

// Declarations of the members of one operator; their names end in its slot. `prefix`: of the types.
std::vector<std::string> temporal_members(const ir::Op& op, const std::string& prefix,
                                          Telling telling = Telling::margins);
std::string temporal_ticks_member(const std::string& prefix);
// The types of these members, and of `ticks`, as parts of the kernel library: for the header, where
// the state is declared.
void collect_temporal_types(const ir::Op& op, std::set<std::string>& parts,
                            Telling telling = Telling::margins);

struct TemporalCall {
  std::string state;  // what the name of a member follows: `s->`
  std::string ticks;  // pointer: `&s->ticks`
  std::string a, b;   // operands; b: of `since` only. For verdicts: bits, bounds of a quantity
  // Of the quantity a, if all inputs behind it have one: an unknown tick counts as all of it.
  std::optional<ir::Range> declared;
};
// The expression that evaluates the operator in a tick: a margin, or a span of an aggregate; for
// verdicts bits, or bounds. `uses` collects library functions. `rate` is the change over the
// window, which is not divided yet.
std::string temporal_call(const ir::Op& op, const TemporalCall& with, std::set<std::string>& uses,
                          Telling telling = Telling::margins);
// A statement that starts, or forgets, what remembers the result so far and nothing else; empty for
// all others.
std::string temporal_starts(const ir::Op& op, const std::string& state, std::set<std::string>& uses,
                            Telling telling = Telling::margins);
std::string temporal_forgets(const ir::Op& op, const std::string& state,
                             std::set<std::string>& uses, Telling telling = Telling::margins);

// Whether it asks for the ticks of the watch.
bool counts_ticks(const ir::Op& op, Telling telling);

// What its members take, without `ticks`.
std::int64_t temporal_bytes(const ir::Op& op);
// Where the members of an operator end that start at `offset` or behind it; the next multiple.
std::int64_t temporal_end(const ir::Op& op, std::int64_t offset, Telling telling);
std::int64_t aligned(std::int64_t offset, std::int64_t alignment);
inline constexpr std::int64_t temporal_ticks_bytes = 16;

}  // namespace rtac::codegen
