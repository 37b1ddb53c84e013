#include "compiler/codegen/temporal.h"

#include <algorithm>
#include <utility>

#include "compiler/codegen/code.h"

namespace rtac::codegen {
namespace {

using namespace ir;

// A struct of kernel/temporal.c or kernel/aggregate.c; `bytes` with 8-byte alignment.
struct Type {
  const char* name;
  std::int64_t bytes;
};
constexpr Type kept{"kept", 32}, witness{"witness", 56}, bond{"bond", 72}, slide{"slide", 96},
    chain{"chain", 232}, pair{"pair", 16}, total{"total", 40}, tally{"tally", 24},
    change{"change", 16};
constexpr Type bits{"", 1};  // verdicts, two bits each
constexpr Type sight{"sight", 24}, hold{"hold", 40};
constexpr Type so_far{"", 4};  // a verdict

struct Ring {
  const char* name;
  Type type;
  std::int64_t entries;  // 0: there is none
};
// How an operator is evaluated: its members and the function that takes pointers to them.
struct Plan {
  std::string name;  // of the members
  const char* function = "";
  Type state{};
  std::vector<Ring> rings;       // in the order of the arguments
  std::optional<Window> window;  // passed on
  bool is_ever = false;          // remembers its result so far: neither window nor ticks matter
};

// One is less when the window is odd: the newest entry is at hand.
std::int64_t window_entries(std::int64_t ticks) {
  return ticks / 2 * 2;
}
Ring window_of(const Window& w) {
  return {"window", kept, w.to < 0 ? 0 : window_entries(w.to - w.from + 1)};
}
Ring delay_of(const Window& w) {
  return {"delay", kept, w.from};
}
Ring verdicts(std::int64_t ticks) {
  return {"verdicts", bits, (ticks + 3) / 4};
}

// Without a window there is no more to remember than the result so far.
bool is_ever(const Window& w) {
  return w.from == 0 && w.to < 0;
}
Plan past(const char* word, const char* verdict, const char* margin, const char* ever,
          const Window& w) {
  if (w.full && is_ever(w)) return {word, ever, kept, {}, std::nullopt, true};
  if (w.full) return {word, margin, slide, {window_of(w), delay_of(w)}, w};
  return {word, verdict, witness, {verdicts(w.from)}, w};
}

Plan bits_of(const char* word, const char* ever, const char* within, const Type& state,
             const Window& w) {
  if (is_ever(w)) return {word, ever, so_far, {}, std::nullopt, true};
  return {word, within, state, {verdicts(w.from)}, w};
}

Plan fold(const Aggregate& op) {
  const Window& w = op.window;
  switch (op.fold) {
    case Fold::minimum:
      return {"min", "least_over", slide, {window_of(w), delay_of(w)}, w};
    case Fold::maximum:
      return {"max", "greatest_over", slide, {window_of(w), delay_of(w)}, w};
    case Fold::mean:
      return {"mean", "mean_over", total, {{"ticks", pair, w.to + 1}}, w};
    case Fold::sum:
      return {"sum", "sum_over", total, {{"ticks", pair, w.to + 1}}, w};
    case Fold::count:
      return {"count", "count_over", tally, {verdicts(w.to < 0 ? w.from : w.to + 1)}, w};
    case Fold::rate:
      return {"rate", "change_over", change, {{"ticks", pair, w.to}}, w};
  }
  return {};
}

struct Planner {
  using Result = std::optional<std::pair<Plan, std::uint32_t>>;  // with the slot

  static Result of(Plan plan, std::uint32_t slot) {
    return std::pair<Plan, std::uint32_t>(std::move(plan), slot);
  }
  Result operator()(const Previously& v) const {
    return of({"previously", "previously_margin", kept, {}, std::nullopt}, v.slot);
  }
  Result operator()(const Once& v) const {
    return of(past("once", "once_verdict", "once_margin", "once_margin_ever", v.window), v.slot);
  }
  Result operator()(const Historically& v) const {
    return of(past("historically", "historically_verdict", "historically_margin",
                   "historically_margin_ever", v.window),
              v.slot);
  }
  Result operator()(const Since& v) const {
    const Window& w = v.window;
    if (!w.full) return of({"since", "since_verdict", bond, {verdicts(w.from)}, w}, v.slot);
    if (is_ever(w)) {
      return of({"since", "since_margin_ever", kept, {}, std::nullopt, true}, v.slot);
    }
    const Ring holds{"hold", kept, window_entries(w.from)};
    return of({"since", "since_margin", chain, {holds, window_of(w), delay_of(w)}, w}, v.slot);
  }
  Result operator()(const Aggregate& v) const { return of(fold(v), v.slot); }
  template <class Other>
  Result operator()(const Other&) const {
    return std::nullopt;
  }
};

struct VerdictPlanner : Planner {
  using Planner::operator();
  Result operator()(const Previously& v) const {
    return of({"previously", "previously_bits", so_far, {}, std::nullopt, true}, v.slot);
  }
  Result operator()(const Once& v) const {
    return of(bits_of("once", "once_ever", "once_within", sight, v.window), v.slot);
  }
  Result operator()(const Historically& v) const {
    return of(bits_of("historically", "historically_ever", "historically_within", sight, v.window),
              v.slot);
  }
  Result operator()(const Since& v) const {
    return of(bits_of("since", "since_ever", "since_within", hold, v.window), v.slot);
  }
};

// none: the operator does not remember.
std::optional<Plan> plan_of(const Op& op, Telling telling) {
  auto found =
      telling == Telling::margins ? std::visit(Planner{}, op) : std::visit(VerdictPlanner{}, op);
  if (!found) return std::nullopt;
  found->first.name += "_" + std::to_string(found->second);
  return std::move(found->first);
}

std::string use(std::set<std::string>& uses, const std::string& function,
                const std::string& arguments) {
  uses.insert(function);
  return function + "(" + arguments + ")";
}

// The operands; of the fold of a quantity, also what a tick counts as that is not remembered.
std::string operands(const Op& op, const TemporalCall& with, std::set<std::string>& uses,
                     Telling telling) {
  if (std::holds_alternative<Since>(op)) return with.a + ", " + with.b;
  const auto* aggregate = std::get_if<Aggregate>(&op);
  if (!aggregate || aggregate->fold == Fold::count) return with.a;
  const std::string a = telling == Telling::verdicts ? use(uses, "span_bounds", with.a) : with.a;
  if (!with.declared) return a + ", " + use(uses, "span_forgotten", "");
  const std::string range = num(with.declared->lo) + ", " + num(with.declared->hi);
  return use(uses, "span_fill", a + ", " + range) + ", " + use(uses, "span_of", range);
}
// What is counted for verdicts comes as bits.
std::string function_of(const Op& op, const Plan& plan, Telling telling) {
  const auto* aggregate = std::get_if<Aggregate>(&op);
  const bool counts = aggregate && aggregate->fold == Fold::count;
  return counts && telling == Telling::verdicts ? "count_bits" : plan.function;
}

// Sets the result so far, when that is all that there is.
std::string set_so_far(const Op& op, const std::string& state, const std::string& plain,
                       const std::string& margin, std::set<std::string>& uses, Telling telling) {
  const std::optional<Plan> plan = plan_of(op, telling);
  if (!plan || !plan->is_ever) return "";
  const bool full = telling == Telling::margins;
  return state + plan->name + " = " + (full ? use(uses, margin, "") : plain) + ";";
}

}  // namespace

bool is_temporal(const Op& op) {
  return plan_of(op, Telling::margins).has_value();
}

bool counts_ticks(const Op& op, Telling telling) {
  const std::optional<Plan> plan = plan_of(op, telling);
  return std::holds_alternative<Elapsed>(op) || (plan && !plan->is_ever);
}

std::vector<std::string> temporal_members(const Op& op, const std::string& prefix,
                                          Telling telling) {
  std::vector<std::string> members;
  const std::optional<Plan> plan = plan_of(op, telling);
  if (!plan) return members;
  const std::string state = plan->state.name;
  members.push_back((state.empty() ? "int32_t" : prefix + "_" + state) + " " + plan->name + ";");
  for (const Ring& ring : plan->rings) {
    if (ring.entries == 0) continue;
    const std::string type = *ring.type.name ? prefix + "_" + ring.type.name : "uint8_t";
    members.push_back(type + " " + plan->name + "_" + ring.name + "[" +
                      std::to_string(ring.entries) + "];");
  }
  return members;
}

std::string temporal_ticks_member(const std::string& prefix) {
  return prefix + "_ticks ticks;";
}

void collect_temporal_types(const Op& op, std::set<std::string>& parts, Telling telling) {
  parts.insert("ticks_state");
  const std::optional<Plan> plan = plan_of(op, telling);
  if (!plan) return;
  if (*plan->state.name) parts.insert(std::string(plan->state.name) + "_state");
  for (const Ring& ring : plan->rings) {
    if (ring.entries > 0 && *ring.type.name) {
      parts.insert(std::string(ring.type.name) + "_state");
    }
  }
}

std::string temporal_call(const Op& op, const TemporalCall& with, std::set<std::string>& uses,
                          Telling telling) {
  const std::optional<Plan> plan = plan_of(op, telling);
  if (!plan) return "";
  std::string arguments = operands(op, with, uses, telling) + ", &" + with.state + plan->name;
  if (plan->is_ever) return use(uses, plan->function, arguments);
  for (const Ring& ring : plan->rings) {
    arguments += ring.entries == 0 ? ", 0" : ", " + with.state + plan->name + "_" + ring.name;
  }
  if (plan->window) arguments += ", " + num(plan->window->from) + ", " + num(plan->window->to);
  const std::string call =
      use(uses, function_of(op, *plan, telling), arguments + ", " + with.ticks);
  const bool is_quantity = telling == Telling::verdicts && std::holds_alternative<Aggregate>(op);
  return is_quantity ? use(uses, "bounds_span", call) : call;
}

std::string temporal_starts(const Op& op, const std::string& state, std::set<std::string>& uses,
                            Telling telling) {
  const bool holds = std::holds_alternative<Historically>(op);
  return set_so_far(op, state, holds ? "BITS_TRUE" : "BITS_FALSE",
                    holds ? "kept_true" : "kept_false", uses, telling);
}
std::string temporal_forgets(const Op& op, const std::string& state, std::set<std::string>& uses,
                             Telling telling) {
  return set_so_far(op, state, "BITS_UNKNOWN", "kept_forgotten", uses, telling);
}

std::int64_t temporal_end(const Op& op, std::int64_t offset, Telling telling) {
  const std::optional<Plan> plan = plan_of(op, telling);
  if (!plan) return offset;
  const auto add = [&offset](const Type& type, std::int64_t count) {
    const std::int64_t alignment = std::min<std::int64_t>(type.bytes, 8);
    if (count > 0) offset = aligned(offset, alignment) + count * type.bytes;
  };
  add(plan->state, 1);
  for (const Ring& ring : plan->rings) add(ring.type, ring.entries);
  return offset;
}
std::int64_t temporal_bytes(const Op& op) {
  return aligned(temporal_end(op, 0, Telling::margins), 8);
}
std::int64_t aligned(std::int64_t offset, std::int64_t alignment) {
  return (offset + alignment - 1) / alignment * alignment;
}

}  // namespace rtac::codegen
