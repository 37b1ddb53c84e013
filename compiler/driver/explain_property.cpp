#include "compiler/driver/explain_property.h"

#include <algorithm>

#include "compiler/codegen/temporal.h"
#include "compiler/driver/explain_margin.h"
#include "compiler/driver/explain_text.h"
#include "compiler/driver/uncertainty.h"
#include "compiler/ir/rounding.h"
#include "compiler/ir/source_text.h"
#include "compiler/ir/weights.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/visit.h"

namespace rtac::driver {

using namespace ir;

namespace {

// Of whole numbers only.
bool is_whole(const sema::Spec& spec, const sema::Expr& e) {
  if (e.boolean || !(e.dimension == sema::dims::number)) return false;
  if (const auto* constant = std::get_if<sema::Constant>(&e.node)) {
    return constant->value.get_den() == 1;
  }
  if (const auto* input = std::get_if<sema::InputRef>(&e.node)) {
    return spec[input->input].type == sema::InputType::integer;
  }
  if (const auto* aggregate = std::get_if<sema::Aggregate>(&e.node)) {
    if (aggregate->op == sema::AggregateOp::count) return true;
    if (aggregate->op == sema::AggregateOp::mean) return false;
    if (aggregate->op == sema::AggregateOp::rate) return false;
  } else if (const auto* arithmetic = std::get_if<sema::Arithmetic>(&e.node)) {
    if (arithmetic->op == sema::ArithmeticOp::divide) return false;
  } else if (const auto* math = std::get_if<sema::Math>(&e.node)) {
    const bool keeps = math->op == sema::MathOp::minimum || math->op == sema::MathOp::maximum ||
                       math->op == sema::MathOp::absolute;
    if (!keeps) return false;
  } else if (!std::holds_alternative<sema::Choice>(e.node)) {
    return false;
  }
  bool whole = true;
  sema::for_each_operand(e, [&](const sema::ExprPtr& operand) {
    whole = whole && (operand->boolean || is_whole(spec, *operand));
  });
  return whole;
}

void quantity(const Value& value, const Rational& width, const std::optional<Range>& range,
              bool is_rounded, std::vector<std::string>& to) {
  if (range) {
    to.push_back("range: " + shown(*range, *value.unit) +
                 (range->declared ? "" : ", of inputs without a declared range"));
  }
  to.push_back(grid(*value.unit));
  to.emplace_back(is_rounded ? "rounding: outward, the lower end down and the upper end up"
                             : "rounding: none");
  const bool of_legs = std::holds_alternative<ir::TrailClearance>(value.op);
  to.push_back(wide(width, *value.unit) + (of_legs ? ", of legs on one side of the boundary" : ""));
}

void margin(const Block& block, const Value& value, const Rational& width,
            std::vector<std::string>& to) {
  if (const std::string why = why_infinite(block, value); !why.empty()) {
    to.push_back("margin: infinite, " + why);
  }
  const auto* compare = std::get_if<AtLeast>(&value.op);
  if (!compare) return;
  const Unit& unit = *block[compare->a].unit;
  to.push_back("scale: margins count millionths of " + sema::show(unit.scale, unit.dimension) +
               (is_plain_margin(block, *compare) ? "" : ", rounded outward"));
  to.push_back(wide(width, unit));
}

// What the operations that stand for the expression take. Runs of `for` are two counters.
std::string cost(const sema::Expr& e, const Block& block, bool of_others) {
  constexpr std::int64_t run_bytes = 8;
  std::size_t operations = 0;
  std::int64_t bytes = 0;
  for (const Value& v : block.values) {
    if (!(v.source == e.range)) continue;
    operations += 1;
    bytes += std::holds_alternative<HeldFor>(v.op) ? run_bytes : codegen::temporal_bytes(v.op);
  }
  return count(operations, "operation") + " a tick of its own" +
         (of_others ? ", for each other robot" : "") +
         (bytes > 0 ? ", " + count(static_cast<std::size_t>(bytes), "byte") + " of state" : "");
}

// Places farther from a zone than its tables reach are not known as well.
std::string near_enough(const ir::Watch& watch, const Block& block) {
  std::optional<std::int32_t> least_mm;
  const auto look = [&](ir::RegionIndex index) {
    const auto& exact = watch.regions[static_cast<std::size_t>(index)].tree.exact_mm;
    if (exact) least_mm = std::min(least_mm.value_or(*exact), *exact);
  };
  for (const Value& v : block.values) {
    if (const auto* c = std::get_if<ir::PointClearance>(&v.op)) {
      look(c->within);
      look(c->around);
    }
    if (const auto* c = std::get_if<ir::TrailClearance>(&v.op)) {
      look(c->within);
      look(c->around);
    }
  }
  if (!least_mm) return "";
  return ", of places within " + to_decimal(Rational(*least_mm, 1000)) +
         " m of the boundary of each zone";
}

}  // namespace

std::string PropertyRemarks::rounding(const PlainMonitor& m) const {
  const Rounding bound = rounding_of(spec_, watch_, m.property);
  if (sgn(bound.millionths) == 0) return "rounding: none, verdicts and margins are exact";
  std::string text;
  for (const Unit& unit : margin_units(m.property)) {
    const Rational si = bound.millionths * unit.scale / 1'000'000;
    text += (text.empty() ? "" : ", or ") + sema::show(decimals(si, true), unit.dimension);
  }
  return "rounding: an exact margin is decided when it is more than " + text + " away from 0" +
         (bound.has_rounded_choice ? ", with both sides of a choice known" : "") +
         (bound.has_crossing_legs ? ", of legs that lie on one side of each boundary" : "") +
         near_enough(watch_, m.property);
}

void PropertyRemarks::expressions(const sema::Expr& root, const SourceRange& owner,
                                  const std::string& monitor, const Block& block) {
  owner_ = owner;
  monitor_ = monitor;
  seen_.clear();
  walk(root, {block});
}

void PropertyRemarks::walk(const sema::Expr& e, const Place& place) {
  const Block* fact = place.is_fact ? nullptr : fact_at(e, place.block);
  if (fact != nullptr) return walk(e, {*fact, place.of_others, true});
  // a function is written once, and its body stands for each of its calls
  const std::pair key{e.range, e.boolean};
  if (std::find(seen_.begin(), seen_.end(), key) == seen_.end()) {
    seen_.push_back(key);
    expression(e, place);
  }
  operands(e, place);
}

void PropertyRemarks::operands(const sema::Expr& e, const Place& place) {
  const Block* body = nullptr;
  for (const Value& v : place.block.values) {
    if (v.source == e.range && body_of(v.op) != nullptr) body = body_of(v.op);
  }
  // what is said of each other robot may have facts again
  const Place inner = body != nullptr ? Place{*body, true} : place;
  sema::for_each_operand(e, [&](const sema::ExprPtr& operand) { walk(*operand, inner); });
}

// What the expression is, once a tick, where the block only looks that up.
const Block* PropertyRemarks::fact_at(const sema::Expr& e, const Block& block) const {
  for (const Value& v : block.values) {
    const auto* fact = std::get_if<Fact>(&v.op);
    if (fact != nullptr && v.source == e.range && decision_ != nullptr) {
      return &decision_->facts.monitors[fact->index].property;
    }
  }
  return nullptr;
}

const std::vector<Rational>& PropertyRemarks::errors_of(const Block& block) {
  const auto [found, is_new] = errors_.try_emplace(&block);
  if (is_new) found->second = widths(watch_, block, decision_);
  return found->second;
}

// The value that the expression ends in: the last one that stands for it. Operands that are
// subtracted are negated afterwards.
std::optional<PropertyRemarks::Found> PropertyRemarks::find(const sema::Expr& e,
                                                            const Block& block) {
  const std::vector<Rational>& errors = errors_of(block);
  const auto* arithmetic = std::get_if<sema::Arithmetic>(&e.node);
  const bool negates = arithmetic && arithmetic->op == sema::ArithmeticOp::negate;
  const std::string text = one_line(c_.sources.text(e.range));
  std::optional<Found> found;
  bool rounded = false;
  for (std::size_t i = 0; i < block.values.size(); ++i) {
    const Value& v = block.values[i];
    const bool own = v.source == e.range;
    rounded = rounded || ((own || v.text == text) && rounds(v.op));
    if (v.unit.has_value() == e.boolean || (std::holds_alternative<Negate>(v.op) && !negates)) {
      continue;
    }
    if (own || (v.text == text && (!found || !found->own))) {
      found = Found{i, own, errors[i], v.range};
    }
  }
  if (found) found->rounded = rounded;
  return found;
}

// The body of a function stands for each of its calls.
void PropertyRemarks::widen(Found& found, const Block& block) {
  const std::vector<Rational>& errors = errors_of(block);
  const Value& last = block.values[found.value];
  for (std::size_t i = 0; i < found.value; ++i) {
    const Value& v = block.values[i];
    if (!(v.source == last.source) || v.op.index() != last.op.index() || v.unit != last.unit) {
      continue;
    }
    found.width = std::max(found.width, errors[i]);
    if (!found.range || !v.range) continue;
    found.range->lo = std::min(found.range->lo, v.range->lo);
    found.range->hi = std::max(found.range->hi, v.range->hi);
    found.range->declared = found.range->declared && v.range->declared;
  }
}

void PropertyRemarks::expression(const sema::Expr& e, const Place& place) {
  std::vector<std::string> details;
  const bool is_elsewhere =
      e.range.file != owner_.file || e.range.begin < owner_.begin || e.range.end > owner_.end;
  if (is_elsewhere) details.push_back("in monitor " + monitor_);
  details.push_back("type: " + (e.boolean            ? std::string("bool")
                                : is_whole(spec_, e) ? std::string("int")
                                                     : real_type(e.dimension)));
  const auto* constant = std::get_if<sema::Constant>(&e.node);
  if (constant) details.push_back("value: " + sema::show(constant->value, e.dimension));
  if (auto found = find(e, place.block)) {
    if (is_elsewhere) widen(*found, place.block);
    const Value& value = place.block.values[found->value];
    if (value.unit) {
      quantity(value, found->width, constant ? std::nullopt : found->range, found->rounded,
               details);
    } else {
      margin(place.block, value, found->width, details);
    }
    if (found->own) {
      details.push_back(cost(e, place.block, place.of_others));
    } else {
      elsewhere(e, value, details);
    }
    if (place.is_fact) details.emplace_back("judged now, whatever lies ahead");
  } else if (!constant) {
    details.emplace_back("part of what is around it");
  }
  out_.push_back({e.range, "`" + one_line(c_.sources.text(e.range)) + "`", std::move(details)});
}

void PropertyRemarks::elsewhere(const sema::Expr& e, const Value& value,
                                std::vector<std::string>& to) const {
  const FileId file = value.source.file;
  const auto line = c_.sources.position(file, value.source.begin).line;
  to.push_back("computed once, for line " + std::to_string(line) +
               (file == e.range.file ? "" : " of " + c_.sources.path(file)));
}

}  // namespace rtac::driver
