#include "compiler/codegen/watch_look.h"

#include "compiler/codegen/temporal.h"
#include "compiler/codegen/watch_known.h"

namespace rtac::codegen {

using namespace ir;

WatchLook::WatchLook(WatchKernel kernel, std::set<std::string>& uses, Code& out)
    : kernel_(std::move(kernel)),
      watch_(kernel_.watch),
      members_(watch_names(watch_)),
      asked_(channel_uses(watch_)),
      needed_whole_(needed_whole(watch_)),
      view_(kernel_.functions + "_view"),
      clock_(upper(kernel_.prefix) + "_INPUT_CLOCK"),
      uses_(uses),
      out_(out) {}

void WatchLook::function(const std::string& start, const std::vector<std::string>& parameters,
                         const std::function<void(Code&)>& body) {
  out_.block(signature(start, parameters), body);
}

std::string WatchLook::use(const std::string& function, const std::string& arguments) {
  uses_.insert(function);
  return function + "(" + arguments + ")";
}
bool WatchLook::is_truth(std::size_t channel) const {
  return watch_.inputs[channel].kind == ChannelKind::truth;
}
bool WatchLook::is_zone(std::size_t channel) const {
  return watch_.inputs[channel].kind == ChannelKind::zone;
}
bool WatchLook::is_path(std::size_t channel) const {
  return watch_.inputs[channel].kind == ChannelKind::path;
}
std::string WatchLook::type_of(std::size_t channel) const {
  if (is_zone(channel)) return "const " + kernel_.prefix + "_zone *";
  if (is_path(channel)) return "path ";
  if (is_truth(channel)) return truth_type() + " ";
  return kernel_.is_full() ? "span " : "bounds ";
}
std::string WatchLook::unknown(bool is_truth) {
  if (kernel_.is_full()) return use(is_truth ? "margin_unknown" : "span_unknown", clock_);
  return is_truth ? "BITS_UNKNOWN" : use("bounds_nothing", "");
}
std::string WatchLook::call(std::size_t channel, const std::string& view,
                            const std::string& in) const {
  return kernel_.functions + "_look_" + members_.channels[channel] + "(" + view + ", " + in + ");";
}

void WatchLook::view() {
  out_.comment(kernel_.is_full() ? "What a tick knows of its inputs."
                                 : "What a tick knows of its inputs, for verdicts alone.");
  out_.block(
      "typedef struct " + view_,
      [&](Code& body) {
        body.line(kernel_.state + " *s;");
        body.line("int64_t now_us, since_us; /* after since_us a sample is one of this tick */");
        for (const WatchSignal& s : members_.signals) {
          if (asked_.used[s.channel]) body.line(type_of(s.channel) + s.seen + ";");
        }
        for (const std::string& open : members_.open) body.line(truth_type() + " " + open + ";");
        for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
          if (!is_seen_whole(c)) continue;
          body.line("int32_t has_" + members_.channels[c] + "; /* all of it */");
        }
        for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
          if (!is_at_a_glance(c)) continue;
          body.line("int32_t fresh_" + members_.channels[c] + "; /* whether its sample counts */");
        }
        for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
          if (!asked_.age[c]) continue;
          body.line(std::string(kernel_.is_full() ? "span" : "bounds") + " age_of_" +
                    members_.channels[c] + "; /* us */");
        }
      },
      "} " + view_ + ";");
  out_.blank();
  for (const char* part : {"span_type", "margin_type"}) uses_.insert(part);
  if (!kernel_.is_full()) uses_.insert({"bounds_type", "bits_type"});
}

bool WatchLook::property(const Block& block, WatchValuePrinter& values, Code& body,
                         RepeatPrinter* repeats) {
  std::string last, all;
  const auto operand = [&](ValueId id) { return values.named(id, block); };
  for (const ValueId id : written_values(block, repeats)) {
    const Value& v = block[id];
    const bool is_result = id == block.result;
    const bool is_given = static_cast<std::size_t>(id) < values.given();
    if (is_given || (!is_result && WatchValuePrinter::is_leaf(v.op))) continue;
    const std::vector<Part>* const parts = repeats ? repeats->repeats().parts_of(id) : nullptr;
    if (v.text != last && (!is_result || parts)) body.comment(v.text);
    if (parts) repeats->declare(*parts, operand, body);
    const std::string text =
        parts ? repeats->joined(v.op, *parts, operand) : values.value(v, block);
    all += parts ? "v->" : text;  // what is joined comes from there
    last = v.text;
    const std::string target =
        std::string("const ") + (v.unit ? "span " : "margin ") + value_name(id) + " = ";
    wrapped(body, (is_result ? "return " : target) + text + ";");
  }
  return all.find("v->") != std::string::npos;
}

void WatchLook::blind() {
  out_.comment("A tick that sees nothing: it was missed.");
  function("static void " + kernel_.functions + "_blind", {view_ + " *v", kernel_.state + " *s"},
           [&](Code& body) {
             body.line("v->s = s;");
             for (const WatchSignal& s : members_.signals) {
               if (!asked_.used[s.channel]) continue;
               const std::string none = is_zone(s.channel)   ? "0"
                                        : is_path(s.channel) ? use("path_seen", "0, 0, 0, 0, 0, 0")
                                                             : unknown(is_truth(s.channel));
               body.line("v->" + s.seen + " = " + none + ";");
             }
             for (const std::string& open : members_.open) {
               body.line("v->" + open + " = " + unknown(true) + ";");
             }
             for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
               if (!is_seen_whole(c)) continue;
               body.line("v->has_" + members_.channels[c] + " = 0;");
             }
             for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
               if (!asked_.age[c]) continue;
               body.line("v->age_of_" + members_.channels[c] + " = " + unknown(false) + ";");
             }
           });
  out_.blank();
}

std::string WatchLook::see(std::size_t channel, const std::string& view, const std::string& in,
                           const std::string& fresh) const {
  return kernel_.functions + "_see_" + members_.channels[channel] + "(" + view + ", " + in + ", " +
         fresh + ");";
}

void WatchLook::channels() {
  for (std::size_t c = 0; c < watch_.inputs.size(); ++c) {
    if (!asked_.used[c]) continue;
    if (is_at_a_glance(c)) {
      function("static inline void " + kernel_.functions + "_see_" + members_.channels[c],
               {view_ + " *v", "const " + kernel_.types + "_in *in",
                "int32_t fresh_" + members_.channels[c]},
               [&](Code& body) { numbers(c, body); });
      out_.blank();
    }
    function("static inline void " + kernel_.functions + "_look_" + members_.channels[c],
             {view_ + " *v", "const " + kernel_.types + "_in *in"},
             [&](Code& body) { channel(c, body); });
    out_.blank();
  }
}
void WatchLook::channel(std::size_t index, Code& out) {
  const std::string& name = members_.channels[index];
  const std::string of = "in->" + sample(index);
  const std::string counts = fresh(index, of, out) + " && " + valid(index) + " != 0;";
  if (is_at_a_glance(index)) {
    wrapped(out, "v->fresh_" + name + " = " + counts);
    if (always_[index]) out.line(see(index, "v", "in", "v->fresh_" + name));
  } else {
    wrapped(out, "const int32_t fresh_" + name + " = " + counts);
    numbers(index, out);
  }
  if (!asked_.age[index]) return;
  const std::string arguments = of + ".stamp_us, " + whole_sample(index, out) + ", v->now_us";
  const std::string age = kernel_.is_full()
                              ? use("age_span", arguments + ", " + kernel_.numbers[index])
                              : use("bounds_age", arguments);
  wrapped(out, "v->age_of_" + name + " = " + age + ";");
}
void WatchLook::numbers(std::size_t index, Code& out) {
  if (is_seen_whole(index)) {
    whole(index, out);
    return;
  }
  const std::size_t count = watch_.inputs[index].components.size();
  for (std::uint32_t k = 0; k < count; ++k) component(index, k, out);
}
bool WatchLook::is_plain(std::size_t channel) const {
  return !keeps_stamp(watch_, asked_, channel) && !asked_.age[channel] && !is_zone(channel) &&
         !is_path(channel);
}
std::string WatchLook::arrived(std::size_t channel) {
  return use("sample_arrived", "in->" + sample(channel) + ".stamp_us, v->since_us, v->now_us");
}
// Whether the newest sample counts now, if there is one.
std::string WatchLook::fresh(std::size_t index, const std::string& of, Code& out) {
  const Channel& c = watch_.inputs[index];
  if (!keeps_stamp(watch_, asked_, index)) {
    return arrived(index);
  }
  const std::string& name = members_.channels[index];
  const std::string good = "good_" + name;
  wrapped(out, "const int32_t " + good + " = " +
                   use("sample_good", of + ".stamp_us, &v->s->last_" + name + "_us, v->now_us") +
                   ";");
  if (c.max_age_us) {
    return good + " && " + use("sample_young", of + ".stamp_us, v->now_us, " + num(*c.max_age_us));
  }
  return c.held ? good : good + " && " + of + ".stamp_us > v->since_us";
}
// A sample has an age when all of it has a value.
std::string WatchLook::whole_sample(std::size_t index, Code& out) {
  const std::string& name = members_.channels[index];
  const std::string whole = "whole_" + name;
  const std::string valid = "good_" + name + " && in->" + sample(index) + ".valid != 0";
  if (is_zone(index) || is_path(index)) return valid;
  out.line("int32_t " + whole + " = " + valid + ";");
  for (std::uint32_t k = 0; k < watch_.inputs[index].components.size(); ++k) {
    const std::string& component = members_.signal(std::uint32_t(index), k).name;
    out.line(whole + " = " + whole + " && in->" + component + " != INT64_MIN;");
  }
  return whole;
}
bool WatchLook::is_seen_whole(std::size_t channel) const {
  return !kernel_.is_full() && needed_whole_[channel];
}
// The step, and whether the number lies behind it.
std::string WatchLook::number(std::size_t channel, std::uint32_t k) const {
  const WatchSignal& signal = members_.signal(std::uint32_t(channel), k);
  return "in->" + signal.name + ", " + signal.between_in("in->");
}
// Usually all components have a value, and nobody asks again which of them do.
void WatchLook::whole(std::size_t index, Code& out) {
  const Channel& c = watch_.inputs[index];
  const std::string has = "v->has_" + members_.channels[index];
  std::string ranges;
  Code all;
  for (std::uint32_t k = 0; k < c.components.size(); ++k) {
    const ChannelGrid& grid = c.grid(k);
    const std::string range = num(grid.range.lo) + ", " + num(grid.range.hi);
    ranges += " &&\n      " + use("number_within", number(index, k) + ", " + range);
    wrapped(all, "v->" + members_.signal(std::uint32_t(index), k).seen + " = " +
                     use("bounds_measured", number(index, k) + ", " + num(grid.error_steps)) + ";");
  }
  Code parts;
  for (std::uint32_t k = 0; k < c.components.size(); ++k) component(index, k, parts);
  parts.line(has + " = 0;");
  all.line(has + " = 1;");
  out.block(
      "if (fresh_" + members_.channels[index] + ranges + ")",
      [&](Code& usual) { usual.append(std::move(all)); }, "");
  out.block("} else", [&](Code& some) { some.append(std::move(parts)); });
}
void WatchLook::component(std::size_t index, std::uint32_t k, Code& body) {
  const Channel& c = watch_.inputs[index];
  if (c.kind == ChannelKind::zone) {
    const WatchSignal& signal = members_.signal(std::uint32_t(index), k);
    wrapped(body, "v->" + signal.seen + " = fresh_" + members_.channels[index] + " ? &in->" +
                      signal.zone + " : 0;");
    return;
  }
  if (c.kind == ChannelKind::path) {
    const std::string of = "in->" + sample(index);
    wrapped(body, "v->" + members_.signal(std::uint32_t(index), k).seen + " = " +
                      use("path_seen", "fresh_" + members_.channels[index] + ", " + of + ".x, " +
                                           of + ".y, " + of + ".count, " + of + ".index, " +
                                           num(std::int64_t{c.places_most})) +
                      ";");
    return;
  }
  std::string arguments = number(index, k) + ", fresh_" + members_.channels[index];
  const bool truth = c.kind == ChannelKind::truth;
  if (!truth) {
    const ChannelGrid& grid = c.grid(k);
    arguments +=
        ", " + num(grid.range.lo) + ", " + num(grid.range.hi) + ", " + num(grid.error_steps);
  }
  const char* const full = truth ? "truth_of" : "number_of";
  const char* const alone = truth ? "bits_truth" : "bounds_number";
  const std::string value = kernel_.is_full() ? use(full, arguments + ", " + kernel_.numbers[index])
                                              : use(alone, arguments);
  wrapped(body, "v->" + members_.signal(std::uint32_t(index), k).seen + " = " + value + ";");
}
void WatchLook::schedules(const std::string& view, Code& body) const {
  for (std::size_t k = 0; k < watch_.schedules.size(); ++k) {
    uses_.insert("is_open");
    if (kernel_.is_full()) uses_.insert({"margin_true", "margin_false"});
    const std::string now =
        "is_open(&" + schedule_symbol(watch_.schedules[k]) + ", " + view + "now_us)";
    const char* const found =
        kernel_.is_full() ? " ? margin_true() : margin_false();" : " ? BITS_TRUE : BITS_FALSE;";
    wrapped(body, view + members_.open[k] + " = " + now + found);
  }
}
void WatchLook::params(const std::string& state, const std::string& in, Code& body) const {
  for (std::size_t k = 0; k < watch_.params.size(); ++k) {
    const Param& param = watch_.params[k];
    if (param.tightens == 0) continue;
    uses_.insert("tighter");
    const std::string value = state + "tightest_" + members_.params[k];
    body.line(value + " = tighter(" + value + ", " + in + members_.params[k] + ", " +
              num(param.range.lo) + ", " + num(param.range.hi) + ", " +
              (param.tightens > 0 ? "1" : "0") + ");");
  }
}

void WatchLook::start(const std::string& state, Code& body) const {
  if (keeps_last_tick(watch_, kernel_.telling)) {
    body.line(state + "judged_us = 0;");
  }
  if (counts_ticks(watch_, kernel_.telling)) {
    uses_.insert("ticks_start");
    body.line("ticks_start(&" + state + "ticks);");
  }
  for (std::size_t c = 0; c < members_.channels.size(); ++c) {
    if (keeps_stamp(watch_, asked_, c)) {
      body.line(state + "last_" + members_.channels[c] + "_us = INT64_MIN;");
    }
  }
  for (std::size_t k = 0; k < watch_.params.size(); ++k) {
    body.line(state + "tightest_" + members_.params[k] + " = " + num(watch_.params[k].value) + ";");
  }
  for (const PlainMonitor& m : watch_.monitors) {
    for (const Value& v : m.property.values) {
      const std::string text = temporal_starts(v.op, state, uses_, kernel_.telling);
      if (!text.empty()) body.line(text);
    }
  }
}
void WatchLook::forget(const std::string& state, const std::string& tick, Code& body) const {
  if (counts_ticks(watch_, kernel_.telling)) {
    uses_.insert("ticks_forget");
    body.line("ticks_forget(&" + state + "ticks, " + tick + ");");
  }
  for (const PlainMonitor& m : watch_.monitors) {
    for (const Value& v : m.property.values) {
      const std::string text = temporal_forgets(v.op, state, uses_, kernel_.telling);
      if (!text.empty()) body.line(text);
    }
  }
}
void WatchLook::next_tick(const std::string& state, Code& body) const {
  if (counts_ticks(watch_, kernel_.telling)) body.line(state + "ticks.now += 1;");
}

}  // namespace rtac::codegen
