#include "compiler/codegen/watch_values.h"

#include "compiler/codegen/code.h"
#include "compiler/codegen/temporal.h"
#include "compiler/ir/weights.h"

namespace rtac::codegen {

using namespace ir;

std::string value_name(ValueId id) {
  return "v" + std::to_string(static_cast<std::uint32_t>(id));
}

std::string param_value(const WatchKernel& kernel, const WatchNames& names, std::uint32_t param) {
  return kernel.at + "s->tightest_" + names.params[param];
}

std::string WatchValuePrinter::value(const Value& value, const Block& block) {
  block_ = &block;
  value_ = &value;
  return std::visit(*this, value.op);
}

bool WatchValuePrinter::is_leaf(const Op& op) {
  return std::holds_alternative<Const>(op) || std::holds_alternative<Between>(op) ||
         std::holds_alternative<Input>(op) || std::holds_alternative<InputTruth>(op) ||
         std::holds_alternative<Open>(op) || std::holds_alternative<Age>(op) ||
         std::holds_alternative<ParamValue>(op) || std::holds_alternative<Truth>(op);
}
std::string WatchValuePrinter::operand(ValueId id) {
  if (operands_) return operands_(id);
  if (static_cast<std::size_t>(id) < given_) return value_name(id);
  const Op& op = (*block_)[id].op;
  return is_leaf(op) ? std::visit(*this, op) : value_name(id);
}

std::string WatchValuePrinter::use(const std::string& function, const std::string& arguments) {
  uses_.insert(function);
  return function + "(" + arguments + ")";
}
std::string WatchValuePrinter::call(const char* function, ValueId a) {
  return use(function, operand(a));
}
std::string WatchValuePrinter::call(const char* function, ValueId a, ValueId b) {
  return use(function, operand(a) + ", " + operand(b));
}
std::string WatchValuePrinter::signal(std::uint32_t channel, std::uint32_t component) const {
  return kernel_.at + names_.signal(channel, component).seen;
}

std::string WatchValuePrinter::operator()(const Const& v) {
  return use("span_of", num(v.value) + ", " + num(v.value));
}
std::string WatchValuePrinter::operator()(const Truth& v) {
  return v.value ? use("margin_true", "") : use("margin_false", "");
}
std::string WatchValuePrinter::operator()(const Scale& v) {
  if (v.num == 1 && v.den == 1) return operand(v.a);  // the same number of steps of another grid
  return use("span_scale", operand(v.a) + ", " + num(v.num) + ", " + num(v.den));
}
std::string WatchValuePrinter::operator()(const AtLeast& v) {
  const Unit& unit = *(*block_)[v.a].unit;
  const Weight weight = weight_of(unit);
  const std::string operands = operand(v.a) + ", " + operand(v.b) + ", ";
  const std::string unit_number = num(static_cast<std::int64_t>(watch_unit(kernel_.watch, unit)));
  const std::string end = std::string(v.strict ? "1, " : "0, ") + unit_number;
  if (is_plain_margin(*block_, v)) {
    return use("at_least", operands + num(weight.num) + ", " + end);
  }
  return use("at_least_wide", operands + num(weight.num) + ", " + num(weight.den) + ", " + end);
}
std::string WatchValuePrinter::operator()(const Input& v) {
  return signal(v.channel, v.component);
}
std::string WatchValuePrinter::operator()(const InputTruth& v) {
  return signal(v.channel, v.component);
}
std::string WatchValuePrinter::operator()(const InputIs& v) {
  return use("is_value", signal(v.channel, v.component) + ", " + num(v.value));
}
std::string WatchValuePrinter::operator()(const InputSame& v) {
  return use("same_value",
             signal(v.channel, v.component) + ", " + signal(v.other_channel, v.other_component));
}
std::string WatchValuePrinter::operator()(const Open& v) {
  return kernel_.at + names_.open[static_cast<std::uint32_t>(v.schedule)];
}
std::string WatchValuePrinter::operator()(const Elapsed& v) {
  return kernel_.at + "s->ticks.now >= " + num(v.ticks) + " ? " + use("margin_true", "") + " : " +
         use("margin_false", "");
}
std::string WatchValuePrinter::operator()(const Age& v) {
  return kernel_.at + "age_of_" + names_.channels[v.channel];
}
std::string WatchValuePrinter::operator()(const ParamValue& v) {
  const std::string value = param_value(kernel_, names_, v.param);
  return use("span_of", value + ", " + value);
}
std::string WatchValuePrinter::operator()(const Multiply& v) {
  return call("product_of", v.a, v.b);
}
std::string WatchValuePrinter::regions(RegionIndex within, RegionIndex around) const {
  return "&" + region_symbol(kernel_.watch[within]) + ", &" + region_symbol(kernel_.watch[around]);
}
std::string WatchValuePrinter::received(std::uint32_t channel) const {
  return signal(channel, 0) + ", " + kernel_.numbers[channel];
}
std::string WatchValuePrinter::operator()(const PointClearance& v) {
  if (const auto& channel = kernel_.watch[v.within].channel) {
    return use("received_clearance", received(*channel) + ", " + operand(v.a) + ", " +
                                         operand(v.b) + ", " + num(value_->range->lo) + ", " +
                                         num(value_->range->hi));
  }
  return use("clearance_of", regions(v.within, v.around) + ", " + operand(v.a) + ", " +
                                 operand(v.b) + ", " + num(value_->range->lo) + ", " +
                                 num(value_->range->hi));
}
std::string WatchValuePrinter::operator()(const PointInside& v) {
  if (const auto& channel = kernel_.watch[v.within].channel) {
    return use("received_inside", operand(v.condition) + ", " + signal(*channel, 0) + ", " +
                                      operand(v.a) + ", " + operand(v.b));
  }
  return use("inside_of", operand(v.condition) + ", " + regions(v.within, v.around) + ", " +
                              operand(v.a) + ", " + operand(v.b));
}
std::string WatchValuePrinter::solids(SolidIndex within, SolidIndex around) const {
  return "&" + solid_symbol(kernel_.watch[within]) + ", &" + solid_symbol(kernel_.watch[around]);
}
std::string WatchValuePrinter::operator()(const SolidClearance& v) {
  return use("clearance_in_space", solids(v.within, v.around) + ", " + operand(v.a) + ", " +
                                       operand(v.b) + ", " + operand(v.c) + ", " +
                                       num(value_->range->lo) + ", " + num(value_->range->hi));
}
std::string WatchValuePrinter::operator()(const SolidInside& v) {
  return use("inside_in_space", operand(v.condition) + ", " + solids(v.within, v.around) + ", " +
                                    operand(v.a) + ", " + operand(v.b) + ", " + operand(v.c));
}
std::string WatchValuePrinter::trail(const Trail& t) {
  std::string places;
  for (const ValueId id : t.own) places += (places.empty() ? "" : ", ") + operand(id);
  if (!t.channel) return use(t.own.size() > 2 ? "trail_of_leg" : "trail_of_place", places);
  const std::string path = signal(*t.channel, 0), number = kernel_.numbers[*t.channel];
  if (t.own.empty()) return use("trail_of_path", path + ", " + number);
  const std::string most = t.next_only ? "1" : "INT32_MAX";
  return use("trail_ahead", places + ", " + path + ", " + most + ", " + number);
}
std::string WatchValuePrinter::operator()(const TrailClearance& v) {
  const std::string which = v.greatest ? "1" : "0";
  const std::string rest = trail(v.trail) + ", " + which + ", " + num(value_->range->hi);
  if (const auto& channel = kernel_.watch[v.within].channel) {
    return use("received_trail", received(*channel) + ", " + rest);
  }
  return use("trail_clearance", regions(v.within, v.around) + ", " + rest);
}
std::string WatchValuePrinter::operator()(const TrailInside& v) {
  if (const auto& channel = kernel_.watch[v.within].channel) {
    return use("received_trail_inside", operand(v.condition) + ", " + signal(*channel, 0) + ", " +
                                            (v.outside ? "1, " : "0, ") + trail(v.trail));
  }
  const Region& crossed = kernel_.watch[v.outside ? v.within : v.around];
  return use("trail_inside", operand(v.condition) + ", &" + region_symbol(crossed) + ", " +
                                 trail(v.trail) + (v.outside ? ", 1" : ", 0"));
}
std::string WatchValuePrinter::operator()(const TrailDistance& v) {
  return use("trails_apart", trail(v.trail) + ", " + trail(v.other));
}
std::string WatchValuePrinter::operator()(const PathGiven& v) {
  return use("path_given", signal(v.channel, 0) + ", " + kernel_.numbers[v.channel]);
}
std::string WatchValuePrinter::operator()(const Between& v) {
  return use(v.open ? "span_amid" : "span_of", num(v.lo) + ", " + num(v.hi));
}
std::string WatchValuePrinter::operator()(const Phase& v) {
  return use("phase_of", operand(v.a) + ", " + num(v.least_q16) + ", " + num(v.most_q16));
}
std::string WatchValuePrinter::operator()(const Choose& v) {
  return use("chosen", operand(v.condition) + ", " + operand(v.a) + ", " + operand(v.b));
}

std::string WatchValuePrinter::temporal(const Op& op, ValueId a, ValueId b) {
  TemporalCall with{kernel_.at + "s->", "&" + kernel_.at + "s->ticks", operand(a), operand(b),
                    std::nullopt};
  const Value& operand = (*block_)[a];
  if (operand.unit && operand.range && operand.range->declared) with.declared = operand.range;
  return temporal_call(op, with, uses_);
}

}  // namespace rtac::codegen
