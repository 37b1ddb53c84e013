// What the kernel of the monitors without a robot calls things, and how it numbers and sizes them.
#include <algorithm>
#include <cctype>

#include "compiler/codegen/kernel_library.h"
#include "compiler/codegen/temporal.h"
#include "compiler/codegen/watch.h"
#include "compiler/sema/dimension.h"
#include "compiler/support/rational.h"

namespace rtac::codegen {
namespace {

using namespace ir;

// Members of structs collide with keywords and macros only; macros here have no lower-case letter.
std::string member(std::string name, std::set<std::string>& taken) {
  const bool like_macro = std::none_of(name.begin(), name.end(), [](char c) {
    return std::islower(static_cast<unsigned char>(c)) != 0;
  });
  name = legal(name);
  if (like_macro) name += "_";
  while (!taken.insert(name).second) name += "_";
  return name;
}

// Components in the struct of their input.
std::string component_member(const Channel& channel, std::uint32_t component) {
  const std::string& name = channel.components[component];
  if (name.empty()) return "value";
  if (is_array(channel)) return "at[" + name + "]";
  const std::string word = signal_word(name);
  return std::isdigit(static_cast<unsigned char>(word[0])) != 0 ? "at_" + word : word;
}
std::string between_member(const Channel& channel, std::uint32_t component) {
  const std::size_t word = component / between_bits, bit = component % between_bits;
  std::string text = "between";
  if (between_words(channel) > 1) text += "[" + std::to_string(word) + "]";
  if (bit > 0) text += " >> " + std::to_string(bit);
  return text + " & 1U";
}

// The numbers of inputs are named in capitals, and stand beside those of the monitors.
std::string numbered(const std::string& name, std::set<std::string>& taken) {
  std::string id = legal(name);
  while (!taken.insert("INPUT_" + upper(id)).second) id += "_";
  return id;
}

}  // namespace

std::size_t between_words(const Channel& channel) {
  return (channel.components.size() + between_bits - 1) / between_bits;
}
bool is_array(const Channel& channel) {
  const std::string& last = channel.components.back();
  return !last.empty() && std::all_of(last.begin(), last.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

std::string WatchSignal::between_in(const std::string& in) const {
  return "(" + in + between + ")";
}
const WatchSignal& WatchNames::signal(std::uint32_t channel, std::uint32_t component) const {
  return signals[first[channel] + component];
}

WatchNames watch_names(const Watch& watch) {
  WatchNames out;
  std::set<std::string> members, numbers;
  std::set<std::string> seen = {"s", "now_us", "since_us"};  // the state, the tick
  for (const Schedule& schedule : watch.schedules) {
    out.open.push_back("open_" + schedule.name);
    seen.insert(out.open.back());
  }
  for (const PlainMonitor& monitor : watch.monitors) numbers.insert(upper(legal(monitor.name)));
  for (const Channel& channel : watch.inputs) {
    out.channels.push_back(numbered(signal_word(channel.name), numbers));
    seen.insert({"age_of_" + out.channels.back(), "has_" + out.channels.back(),
                 "fresh_" + out.channels.back()});
  }
  for (std::uint32_t c = 0; c < watch.inputs.size(); ++c) {
    const Channel& channel = watch.inputs[c];
    out.first.push_back(out.signals.size());
    const std::string sample = member(signal_word(channel.name), members);
    out.samples.push_back(sample);
    for (std::uint32_t k = 0; k < channel.components.size(); ++k) {
      std::string name = channel.name;
      if (!channel.components[k].empty()) name += "_" + channel.components[k];
      name = signal_word(name);
      WatchSignal signal{sample, "", member(std::move(name), seen), c, k};
      if (channel.kind == ChannelKind::zone) {
        signal.zone = member(signal_word(channel.name) + "_zone", members);
      } else if (channel.kind != ChannelKind::path) {
        signal.name += "." + component_member(channel, k);
        signal.between = sample + "." + between_member(channel, k);
      }
      out.signals.push_back(std::move(signal));
    }
  }
  for (const Param& param : watch.params) out.params.push_back(member(param.name, members));
  return out;
}

WatchKernel kernel_of_monitors(const Module& module, Telling telling) {
  const std::string& p = module.name;
  const std::string types = p + "_monitors";
  WatchKernel kernel{*module.watch, p, types, types + "_state", p, "v->", {}, telling};
  if (telling == Telling::verdicts) {
    kernel.state = types + "_verdicts_state";
    kernel.functions = p + "_verdicts";
  }
  for (const std::string& channel : watch_names(*module.watch).channels) {
    kernel.numbers.push_back(upper(p) + "_MONITORS_INPUT_" + upper(channel));
  }
  return kernel;
}
WatchKernel kernel_of_facts(const Module& module, const Decision& decision, const Names& names) {
  const std::string id = names(decision.name) + "_facts";
  const std::string types = module.name + "_" + id;
  WatchKernel kernel{decision.facts, module.name, types,           types + "_state", id,
                     "v->facts.",    {},          Telling::margins};
  for (std::size_t c = 0; c < decision.facts.inputs.size(); ++c) {
    kernel.numbers.push_back(std::to_string(watch_input_number(module, c)));
  }
  return kernel;
}
bool has_signals(const Decision& decision) {
  const Watch& facts = decision.facts;
  return !facts.inputs.empty() || !facts.params.empty() || !facts.monitors.empty();
}

std::string region_symbol(const Region& region) {
  const std::string side = (region.around ? "_around_" : "_within_") + region.name;
  return (region.slab > 0 ? "slab_" + std::to_string(region.slab) : "region") + side;
}

std::string solid_symbol(const Solid& solid) {
  return (solid.around ? "solid_around_" : "solid_within_") + solid.name;
}

std::vector<const Schedule*> schedules_of(const Module& module) {
  std::vector<const Schedule*> all;
  const auto add = [&](const Watch& watch) {
    for (const Schedule& each : watch.schedules) {
      const bool known = std::any_of(
          all.begin(), all.end(), [&](const Schedule* other) { return other->name == each.name; });
      if (!known) all.push_back(&each);
    }
  };
  for (const Decision& d : module.decisions) add(d.facts);
  if (module.watch) add(*module.watch);
  return all;
}

std::string schedule_symbol(const Schedule& schedule) {
  return "schedule_" + schedule.name;
}

bool receives_zones(const Watch& watch) {
  return std::any_of(watch.inputs.begin(), watch.inputs.end(),
                     [](const Channel& c) { return c.kind == ChannelKind::zone; });
}
bool asks_for_received(const Watch& watch) {
  return !watch.received.empty() ||
         std::any_of(watch.regions.begin(), watch.regions.end(),
                     [](const Region& r) { return r.channel.has_value(); });
}
std::int64_t received_bytes(const Channel& channel) {
  // two outlines, each of 64 bytes an edge and 64 KiB (geometry/receive)
  return 2 * (64 * std::int64_t{channel.edges_most} + 65536);
}

std::set<std::uint32_t> channels_of(const Watch& watch, const PlainMonitor& monitor) {
  std::set<std::uint32_t> out;
  for (const Value& value : monitor.property.values) {
    std::visit(
        [&](const auto& op) {
          if constexpr (requires { op.channel; }) out.insert(op.channel);
          if constexpr (requires { op.other_channel; }) out.insert(op.other_channel);
          if constexpr (requires { op.trail; }) {
            if (op.trail.channel) out.insert(*op.trail.channel);
          }
          if constexpr (requires { op.other.own; }) {
            if (op.other.channel) out.insert(*op.other.channel);
          }
          if constexpr (requires { watch[op.within].channel; }) {
            if (watch[op.within].channel) out.insert(*watch[op.within].channel);
          }
        },
        value.op);
  }
  return out;
}
ChannelUses channel_uses(const Watch& watch) {
  ChannelUses out{std::vector<bool>(watch.inputs.size(), false),
                  std::vector<bool>(watch.inputs.size(), false)};
  for (const Received& zone : watch.received) out.used[zone.channel] = true;
  for (const PlainMonitor& m : watch.monitors) {
    for (const std::uint32_t channel : channels_of(watch, m)) out.used[channel] = true;
    for (const Value& v : m.property.values) {
      if (const auto* age = std::get_if<Age>(&v.op)) out.age[age->channel] = true;
    }
  }
  return out;
}
bool remembers(const PlainMonitor& monitor) {
  return std::any_of(monitor.property.values.begin(), monitor.property.values.end(),
                     [](const Value& v) { return is_temporal(v.op); });
}
bool counts_ticks(const Watch& watch, Telling telling) {
  for (const PlainMonitor& m : watch.monitors) {
    for (const Value& v : m.property.values) {
      if (counts_ticks(v.op, telling)) return true;
    }
  }
  return false;
}
bool has_past(const Watch& watch, Telling telling) {
  return counts_ticks(watch, telling) ||
         std::any_of(watch.monitors.begin(), watch.monitors.end(), remembers);
}
static bool arrives_each_tick(const Channel& c) {
  return !c.held && !c.max_age_us;
}
bool keeps_stamp(const Watch& watch, const ChannelUses& uses, std::size_t channel) {
  return !arrives_each_tick(watch.inputs[channel]) || uses.age[channel];
}
bool arrives_each_tick(const Watch& watch) {
  return std::any_of(watch.inputs.begin(), watch.inputs.end(),
                     [](const Channel& c) { return arrives_each_tick(c); });
}

bool keeps_due_tick(const Watch& watch, Telling telling) {
  return telling == Telling::verdicts && arrives_each_tick(watch);
}
bool keeps_last_tick(const Watch& watch, Telling telling) {
  return telling == Telling::margins && arrives_each_tick(watch);
}

std::int64_t watch_clock_number(const Module& module) {
  // after the inputs of robots, if there are any (kernel_header.cpp)
  return module.decisions.empty() ? 1 : 7;
}
std::int64_t watch_input_number(const Module& module, std::size_t channel) {
  return watch_clock_number(module) + 1 + static_cast<std::int64_t>(channel);
}

std::size_t watch_unit(const Watch& watch, const Unit& unit) {
  for (std::size_t i = 1; i < watch.units.size(); ++i) {
    const Unit& other = watch.units[i];
    if (other.dimension == unit.dimension && other.scale == unit.scale) return i;
  }
  return 0;
}

std::string margin_unit_text(const Unit& unit) {
  const std::string si = sema::unit_of(unit.dimension);
  const bool percent = unit.dimension == sema::dims::ratio;
  return to_decimal(percent ? Rational(unit.scale * 100) : unit.scale) + (si.empty() ? "" : " ") +
         si;
}

std::int64_t watch_monitor_bytes(const PlainMonitor& monitor) {
  std::int64_t bytes = 0;
  for (const Value& value : monitor.property.values) bytes += temporal_bytes(value.op);
  return bytes;
}

static std::int64_t kept_stamps(const Watch& watch) {
  const ChannelUses uses = channel_uses(watch);
  std::int64_t count = 0;
  for (std::size_t c = 0; c < watch.inputs.size(); ++c) {
    count += keeps_stamp(watch, uses, c) ? 1 : 0;
  }
  return count;
}

std::int64_t watch_state_bytes(const Watch& watch, Telling telling) {
  // clock, end of the present tick, time of the last one, and of that with this end, then the
  // newest stamp of each input and the value of each parameter
  constexpr std::int64_t clock_bytes = 32, word_bytes = 8;
  std::int64_t bytes = clock_bytes + word_bytes;
  if (counts_ticks(watch, telling)) bytes += temporal_ticks_bytes;
  if (keeps_last_tick(watch, telling)) bytes += word_bytes;
  if (keeps_due_tick(watch, telling)) bytes += 2 * word_bytes;
  bytes += word_bytes * (kept_stamps(watch) + static_cast<std::int64_t>(watch.params.size()));
  for (const PlainMonitor& monitor : watch.monitors) {
    for (const Value& value : monitor.property.values) {
      bytes = temporal_end(value.op, bytes, telling);
    }
  }
  return aligned(bytes, word_bytes);
}

std::int64_t region_bytes(const Region& region) {
  return static_cast<std::int64_t>(region.edges.size() * sizeof(Edge) + region.tree.bytes());
}
std::int64_t solid_bytes(const Solid& solid) {
  constexpr std::size_t slab_bytes = 16;  // of 64-bit pointers
  return static_cast<std::int64_t>(solid.slabs.size() * slab_bytes);
}
std::int64_t schedule_bytes(const Schedule& schedule) {
  return static_cast<std::int64_t>((schedule.once.size() + schedule.weekly.size()) *
                                   sizeof(Opening));
}
std::int64_t table_bytes(const Watch& watch) {
  std::int64_t bytes = 0;
  for (const Schedule& schedule : watch.schedules) bytes += schedule_bytes(schedule);
  for (const Region& region : watch.regions) bytes += region_bytes(region);
  for (const Solid& solid : watch.solids) bytes += solid_bytes(solid);
  return bytes;
}

std::int64_t facts_state_bytes(const Watch& facts) {
  // what each found in this tick, then the newest stamp of each input and the value of each
  // parameter
  constexpr std::int64_t found_bytes = 32, word_bytes = 8;
  std::int64_t bytes = found_bytes * static_cast<std::int64_t>(facts.monitors.size());
  bytes += word_bytes * (kept_stamps(facts) + static_cast<std::int64_t>(facts.params.size()));
  if (arrives_each_tick(facts)) bytes += word_bytes;  // time of the last tick
  if (counts_ticks(facts, Telling::margins)) bytes += temporal_ticks_bytes;
  for (const PlainMonitor& fact : facts.monitors) bytes += watch_monitor_bytes(fact);
  return bytes;
}

}  // namespace rtac::codegen
