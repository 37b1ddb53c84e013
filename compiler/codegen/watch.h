// Prints the kernel of the monitors without a robot: their part of the header, their step.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/codegen/temporal.h"
#include "compiler/ir/module.h"

namespace rtac::codegen {

// One scalar signal of the kernel: a component of an input.
struct WatchSignal {
  std::string name;     // of its member of the inputs: `open.value`, `p.x`, `temps.at[2]`
  std::string between;  // whether it lies behind that step, before the next: `p.between & 1U`
  std::string seen;     // of its member of the view of a tick, which has others beside it
  std::uint32_t channel, component;
  std::string zone{};  // of a zone: that of its member with the tables
  // `between` with `in`, what leads to the inputs: 0 or 1.
  [[nodiscard]] std::string between_in(const std::string& in) const;
};
// The members of the inputs, in declaration order, then of the parameters.
struct WatchNames {
  std::vector<WatchSignal> signals;
  std::vector<std::string> samples;  // by channel: its member of the inputs
  std::vector<std::string> channels, params;
  std::vector<std::size_t> first;  // by channel: where its signals start
  std::vector<std::string> open;   // of the schedules, in the view of a tick
  [[nodiscard]] const WatchSignal& signal(std::uint32_t channel, std::uint32_t component) const;
};
WatchNames watch_names(const ir::Watch& watch);

// What the kernel calls a watch and its parts: the monitors without a robot, or what those of the
// robots of a decision say that is judged now, its facts.
struct WatchKernel {
  const ir::Watch& watch;
  std::string prefix;     // of the module: `door`
  std::string types;      // of its structs: `door_monitors` of door_monitors_in
  std::string state;      // the type of what it remembers: `door_monitors_state`
  std::string functions;  // of its functions and its view: `door` of door_begin, door_view
  std::string at;         // what leads a function to its view: `v->`
  std::vector<std::string> numbers;  // of its inputs in findings
  Telling telling = Telling::margins;
  [[nodiscard]] bool is_full() const { return telling == Telling::margins; }
};
// What tells verdicts alone has a state, a view and functions of its own.
WatchKernel kernel_of_monitors(const ir::Module& module, Telling telling = Telling::margins);
WatchKernel kernel_of_facts(const ir::Module& module, const ir::Decision& decision,
                            const Names& names);
// Whether the decision has facts, or inputs or parameters at all.
bool has_signals(const ir::Decision& decision);

// Beyond so many missed ticks the past is forgotten (language: ticks).
inline constexpr std::int64_t missed_ticks_max = 4;
// The table of a region in the kernel.
std::string region_symbol(const ir::Region& region);
std::string solid_symbol(const ir::Solid& solid);
std::string schedule_symbol(const ir::Schedule& schedule);
// Of the module, each zone once: monitors of robots and others share them.
std::vector<const ir::Schedule*> schedules_of(const ir::Module& module);

// By channel: whether a monitor asks for the input, or for its age; an input that none asks for is
// not looked at.
struct ChannelUses {
  std::vector<bool> used, age;
};
ChannelUses channel_uses(const ir::Watch& watch);
// The inputs that a monitor asks for.
std::set<std::uint32_t> channels_of(const ir::Watch& watch, const ir::PlainMonitor& monitor);
// Whether zones are received by it, and whether a monitor asks for one.
bool receives_zones(const ir::Watch& watch);
bool asks_for_received(const ir::Watch& watch);
// Most bytes of the tables of such a zone, whoever holds them.
std::int64_t received_bytes(const ir::Channel& channel);
// Whether a monitor has an operator that remembers.
bool remembers(const ir::PlainMonitor& monitor);
// Whether an operator needs to know which tick it is.
bool counts_ticks(const ir::Watch& watch, Telling telling);
// Whether a tick that was missed matters: to what is remembered, or to the number of the tick.
bool has_past(const ir::Watch& watch, Telling telling);
// Whether the stamp of the last sample is kept. What must arrive every tick is later than the last
// tick, which no sample before was, so it cannot go back.
bool keeps_stamp(const ir::Watch& watch, const ChannelUses& uses, std::size_t channel);
// Whether some input has to arrive every tick: then it matters when the last one was.
bool arrives_each_tick(const ir::Watch& watch);

// Whether number, time and end of a tick are found from when the next one is due, which is kept.
bool keeps_due_tick(const ir::Watch& watch, Telling telling);
// Whether the time of the last tick is kept: it matters, and is not found in that way.
bool keeps_last_tick(const ir::Watch& watch, Telling telling);

// Number of an input in a finding; 0: none, and that of the clock below the first input.
std::int64_t watch_input_number(const ir::Module& module, std::size_t channel);
std::int64_t watch_clock_number(const ir::Module& module);
// The unit of a margin: its index in ir::Watch::units.
std::size_t watch_unit(const ir::Watch& watch, const ir::Unit& unit);

// "0.5 m/s", "1 %": what margins of this unit count the millionths of.
std::string margin_unit_text(const ir::Unit& unit);

// Bytes of the whole state on a machine with 8-byte alignment, and of what one monitor remembers.
std::int64_t watch_state_bytes(const ir::Watch& watch, Telling telling = Telling::margins);
std::int64_t watch_monitor_bytes(const ir::PlainMonitor& monitor);
// The same of the facts of a decision.
std::int64_t facts_state_bytes(const ir::Watch& facts);
// Of the constant tables of zones that places are held against.
std::int64_t region_bytes(const ir::Region& region);
std::int64_t solid_bytes(const ir::Solid& solid);
std::int64_t schedule_bytes(const ir::Schedule& schedule);
std::int64_t table_bytes(const ir::Watch& watch);

// Each input has a member of the inputs, a struct of its own; bits of `between` stand for
// components in order, so many a word.
inline constexpr std::size_t between_bits = 32;
std::size_t between_words(const ir::Channel& channel);
// Whether its components are numbered alone, so that they are an array of the struct.
bool is_array(const ir::Channel& channel);

// The members of the structs: what the application fills in; which tick it is, if that matters, the
// newest stamp of each input, the value of each parameter and what each operator remembers.
std::vector<std::string> watch_input_fields(const WatchKernel& kernel);
std::vector<std::string> watch_memory_fields(const WatchKernel& kernel);
// The types of inputs and of what is remembered.
void print_watch_types(const ir::Module& module, Code& out);

void print_watch_header(const ir::Module& module, const Names& names, Code& out);
void print_watch_source(const ir::Module& module, const Names& names, std::set<std::string>& uses,
                        Code& out);

}  // namespace rtac::codegen
