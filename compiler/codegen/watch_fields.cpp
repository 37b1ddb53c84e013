// The structs of a watch in the kernel: what is given to it, what it remembers.
#include <initializer_list>

#include "compiler/codegen/kernel_library.h"
#include "compiler/codegen/temporal.h"
#include "compiler/codegen/watch.h"

namespace rtac::codegen {
namespace {

using namespace ir;

std::string grid_comment(const ChannelGrid& grid) {
  const std::string steps = "steps of " + name(grid.unit);
  if (!grid.range.declared) return steps;
  return steps + ", " + num(grid.range.lo) + " to " + num(grid.range.hi);
}
std::string sample_comment(const Channel& c) {
  std::string text = "/* ";
  switch (c.kind) {
    case ChannelKind::truth:
      text += "0 or 1";
      break;
    case ChannelKind::choice:
      for (std::size_t k = 0; k < c.values.size(); ++k) {
        text += (k > 0 ? ", " : "") + num(std::int64_t(k)) + " " + c.values[k];
      }
      break;
    case ChannelKind::zone:
      text += "of its zone below";
      break;
    case ChannelKind::path:
      text += "way-points in mm, and the number of the next one";
      break;
    case ChannelKind::number:
      text += grid_comment(c);
      if (c.turning) text += "; of turning: " + grid_comment(*c.turning);
      break;
  }
  if (c.held) return text + "; the last one holds */";
  if (!c.max_age_us) return text + "; new every tick */";
  return text + "; for " + num(*c.max_age_us) + " us */";
}
// What is asked first stands first, without a gap.
void sample_fields(const WatchNames& names, const Channel& c, std::size_t channel,
                   std::vector<std::string>& to) {
  const std::size_t words = between_words(c), count = c.components.size();
  to.emplace_back("struct {");
  to.emplace_back("  int64_t stamp_us;");
  if (c.kind == ChannelKind::path) {
    const std::string most = num(std::int64_t{c.places_most});
    to.emplace_back("  int32_t valid, count, index;");
    to.push_back("  int64_t x[" + most + "], y[" + most + "];");
    to.push_back("} " + names.samples[channel] + "; " + sample_comment(c));
    return;
  }
  to.emplace_back("  int32_t valid;");
  if (c.kind == ChannelKind::zone) {
    to.push_back("} " + names.samples[channel] + "; " + sample_comment(c));
    return;
  }
  to.push_back(words > 1 ? "  uint32_t between[" + num(std::int64_t(words)) + "];"
                         : "  uint32_t between;");
  std::string members;
  if (is_array(c)) {
    members = "at[" + num(std::int64_t(count)) + "]";
  } else {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::string& path = names.signal(std::uint32_t(channel), k).name;
      members += (k > 0 ? ", " : "") + path.substr(names.samples[channel].size() + 1);
    }
  }
  to.push_back("  int64_t " + members + ";");
  to.push_back("} " + names.samples[channel] + "; " + sample_comment(c));
}

void record(Code& out, const std::string& name, const std::vector<std::string>& fields) {
  out.block(
      "typedef struct " + name,
      [&](Code& body) {
        for (const std::string& field : fields) body.line(field);
      },
      "} " + name + ";");
  out.blank();
}

void collect_types(const Watch& watch, std::initializer_list<Telling> tellings,
                   std::set<std::string>& parts) {
  for (const PlainMonitor& m : watch.monitors) {
    for (const Value& v : m.property.values) {
      if (!is_temporal(v.op)) continue;
      for (const Telling telling : tellings) collect_temporal_types(v.op, parts, telling);
    }
  }
}

// Of a zone that is received: the wrapper fills them, and checks what it fills in.
void parts_of_received(const std::string& p, Code& out) {
  out.comment(
      "One outline of a zone that was received: six numbers an edge, ax ay bx by in mm, the zone "
      "on "
      "the left, and its direction in Q30; cells that tell which edges matter where. Whoever gives "
      "them keeps them as they are until others are given.");
  record(out, p + "_outline",
         {"const int32_t *edges;", "const uint32_t *cells, *lists;",
          "int32_t edge_count, cell_count, list_count;",
          "int32_t x, y, shift, column, row, columns, rows, depth, leaves;"});
  out.comment(
      "A zone that was received: an outline that lies within it and one around it, on the grid of "
      "1 "
      "mm. Both may be the same.");
  record(out, p + "_zone",
         {"uint64_t checksum;", "uint32_t version;", p + "_outline within, around;"});
}

}  // namespace

std::vector<std::string> watch_input_fields(const WatchKernel& kernel) {
  const Watch& watch = kernel.watch;
  const WatchNames members = watch_names(watch);
  std::vector<std::string> fields;
  for (std::size_t c = 0; c < watch.inputs.size(); ++c) {
    sample_fields(members, watch.inputs[c], c, fields);
  }
  for (std::size_t k = 0; k < watch.params.size(); ++k) {
    const Param& param = watch.params[k];
    const char* const moves = param.tightens > 0   ? ", only ever grows"
                              : param.tightens < 0 ? ", only ever shrinks"
                                                   : ", stays as it is";
    fields.push_back("int64_t " + members.params[k] + "; /* parameter in steps of " +
                     name(param.unit) + ", " + num(param.range.lo) + " to " + num(param.range.hi) +
                     ", at first " + num(param.value) + moves + " */");
  }
  for (const WatchSignal& s : members.signals) {
    const Channel& c = watch.inputs[s.channel];
    if (c.kind != ChannelKind::zone) continue;
    fields.push_back(kernel.prefix + "_zone " + s.zone + "; /* at most " +
                     num(std::int64_t{c.edges_most}) + " edges a side */");
  }
  if (fields.empty()) fields.push_back("int32_t none; /* there are no inputs */");
  return fields;
}

std::vector<std::string> watch_memory_fields(const WatchKernel& kernel) {
  const WatchNames members = watch_names(kernel.watch);
  std::vector<std::string> fields;
  if (counts_ticks(kernel.watch, kernel.telling)) {
    fields.push_back(temporal_ticks_member(kernel.prefix));
  }
  if (keeps_last_tick(kernel.watch, kernel.telling)) fields.emplace_back("int64_t judged_us;");
  const ChannelUses uses = channel_uses(kernel.watch);
  for (std::size_t c = 0; c < members.channels.size(); ++c) {
    if (keeps_stamp(kernel.watch, uses, c)) {
      fields.push_back("int64_t last_" + members.channels[c] + "_us;");
    }
  }
  for (const std::string& param : members.params) {
    fields.push_back("int64_t tightest_" + param + ";");
  }
  for (const PlainMonitor& m : kernel.watch.monitors) {
    bool first = true;
    for (const Value& v : m.property.values) {
      if (is_temporal(v.op) && first) fields.push_back("/* " + m.name + " */");
      first = first && !is_temporal(v.op);
      for (std::string& field : temporal_members(v.op, kernel.prefix, kernel.telling)) {
        fields.push_back(std::move(field));
      }
    }
  }
  return fields;
}

void print_watch_types(const Module& module, Code& out) {
  const std::string& p = module.name;
  out.comment(
      "An input has its newest sample. stamp_us: when it was measured; valid 0: never received. "
      "Its numbers are steps of their grid: the last one that is not above what was measured. A "
      "bit of between, the lowest one for the first number: it lies strictly between that step and "
      "the next, so that it is never rounded the wrong way. INT64_MIN is not finite, INT64_MAX "
      "finite and off every grid. 0 or 1 of a condition, the index of a value of a choice.");
  out.blank();
  bool receives = module.watch && receives_zones(*module.watch);
  for (const Decision& d : module.decisions) receives = receives || receives_zones(d.facts);
  if (receives) parts_of_received(p, out);
  std::set<std::string> parts{"ticks_state"};
  if (module.watch) {
    collect_types(*module.watch, {Telling::margins, Telling::verdicts}, parts);
  }
  for (const Decision& d : module.decisions) {
    collect_types(d.facts, {Telling::margins}, parts);
    if (!d.facts.monitors.empty()) parts.insert("kept_state");
  }
  out.text(kernel_types(parts, p));
  if (module.decisions.empty()) {
    record(out, p + "_clock", {"int32_t started;", "int64_t origin_us, last_us, tick;"});
  }
}

}  // namespace rtac::codegen
