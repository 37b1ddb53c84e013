#include "compiler/codegen/watch_known.h"

#include <type_traits>
#include <variant>

namespace rtac::codegen {
namespace {

using namespace ir;

template <class T, class... Listed>
inline constexpr bool is_one_of = (std::is_same_v<T, Listed> || ...);

// Nothing is known of the result when nothing is known of an operand.
bool keeps_unknown(const Op& op) {
  return std::visit(
      [](const auto& v) {
        return is_one_of<std::decay_t<decltype(v)>, Add, Negate, Scale, Multiply, Minimum, Maximum,
                         Absolute, Root, Norm>;
      },
      op);
}
bool is_operand(const Op& op) {
  return std::holds_alternative<Const>(op) || std::holds_alternative<Between>(op) ||
         std::holds_alternative<ParamValue>(op) || std::holds_alternative<Input>(op) ||
         std::holds_alternative<Not>(op);
}

}  // namespace

bool needs_all_inputs(const Block& property) {
  const Op* result = &property[property.result].op;
  while (const auto* v = std::get_if<Not>(result)) result = &property[v->a].op;
  if (!std::holds_alternative<AtLeast>(*result)) return false;
  bool computes = false;
  for (const Value& value : property.values) {
    if (&value.op == result || is_operand(value.op)) continue;
    if (!keeps_unknown(value.op)) return false;
    computes = true;
  }
  return computes;
}

std::map<std::uint32_t, std::set<std::uint32_t>> components_of(const Block& property) {
  std::map<std::uint32_t, std::set<std::uint32_t>> out;
  for (const Value& value : property.values) {
    if (const auto* i = std::get_if<Input>(&value.op)) out[i->channel].insert(i->component);
  }
  return out;
}

bool asks_for_whole(const Channel& channel, const std::set<std::uint32_t>& components) {
  constexpr std::size_t parts_max = 3;  // more of them are an array
  const std::size_t parts = channel.components.size();
  return parts > 1 && parts <= parts_max && components.size() == parts;
}

std::vector<bool> needed_whole(const Watch& watch) {
  std::vector<bool> out(watch.inputs.size(), false);
  for (const PlainMonitor& m : watch.monitors) {
    if (!needs_all_inputs(m.property)) continue;
    for (const auto& [channel, components] : components_of(m.property)) {
      if (asks_for_whole(watch.inputs[channel], components)) out[channel] = true;
    }
  }
  return out;
}

}  // namespace rtac::codegen
