// Grids of quantities: how constants, sums, products and roots come onto them.
#include <algorithm>

#include "compiler/ir/angles.h"
#include "compiler/ir/grid_help.h"
#include "compiler/ir/signals.h"
#include "compiler/ir/watch_blocks.h"
#include "compiler/ir/watch_quantities.h"
#include "compiler/sema/dimension.h"
#include "compiler/sema/value.h"

namespace rtac::ir {
namespace {

using diag::Code;

// What the kernel counts sines in, and parts of a turn by the step of an angle.
constexpr long sine_q = 1L << 30, phase_q = 1L << 16;

bool is_on_grid(const Rational& si, const Unit& unit) {
  return Rational(si / unit.step).get_den() == 1;
}

// Whether the result lies on the grid of what the operands are made of, or a finer one: roots come
// onto another, and a product of inputs has a step of its own.
bool keeps_grid(const sema::Math& v) {
  const bool is_plane = v.op == sema::MathOp::norm && v.operands.size() <= 2;
  return is_plane || v.op == sema::MathOp::minimum || v.op == sema::MathOp::maximum ||
         v.op == sema::MathOp::absolute;
}
bool is_linear(const sema::Arithmetic& v) {
  const auto varies = [](const sema::ExprPtr& operand) { return !fold_constant(*operand); };
  const bool is_sum = v.op == sema::ArithmeticOp::add || v.op == sema::ArithmeticOp::subtract;
  return is_sum || std::count_if(v.operands.begin(), v.operands.end(), varies) <= 1;
}

// An input of the expression that has a resolution of its own, which decides on which grid the
// expression is; nullptr: none.
const sema::InputRef* find_input(const sema::Expr& e) {
  if (const auto* input = std::get_if<sema::InputRef>(&e.node)) return input;
  const auto first = [](const auto& operands) -> const sema::InputRef* {
    for (const sema::ExprPtr& operand : operands) {
      if (const sema::InputRef* found = find_input(*operand)) return found;
    }
    return nullptr;
  };
  if (const auto* a = std::get_if<sema::Arithmetic>(&e.node)) {
    return is_linear(*a) ? first(a->operands) : nullptr;
  }
  if (const auto* m = std::get_if<sema::Math>(&e.node)) {
    return keeps_grid(*m) ? first(m->operands) : nullptr;
  }
  if (const auto* g = std::get_if<sema::Aggregate>(&e.node)) return find_input(*g->operand);
  return nullptr;
}

// What lies on the grid, and the resolution of an input that makes the constant do so.
std::string on_grid_help(const sema::Spec& spec, const Rational& si, const Unit& unit,
                         const sema::Expr& compared) {
  const auto beside = neighbours(si, unit);
  const std::string do_so = beside ? *beside + " do" : "";
  const sema::InputRef* ref = find_input(compared);
  const sema::Input* input = ref != nullptr ? &spec[ref->input] : nullptr;
  // what robots sense has the steps of all robots
  const bool decides = input != nullptr && !input->robot && input->type == sema::InputType::real &&
                       input->dimension == unit.dimension;
  const auto finer = decides ? fitting_resolution(si, input->resolution, unit) : std::nullopt;
  if (finer) {
    const std::string at_input = "`resolution " + *finer + "` at the input `" + input->name + "`";
    return beside ? do_so + ", or " + at_input : at_input + " works";
  }
  if (beside) return do_so;
  return "a `resolution` with a few decimals in SI units works, with constants that are multiples "
         "of it";
}

// Made of whole numbers and constants alone: no resolution says how finely it is counted.
bool counts_whole(const sema::Spec& spec, const sema::Expr& e) {
  if (std::holds_alternative<sema::Constant>(e.node) || sema::is_integer(spec, e)) return true;
  const auto all = [&](const auto& operands) {
    return std::all_of(operands.begin(), operands.end(),
                       [&](const sema::ExprPtr& operand) { return counts_whole(spec, *operand); });
  };
  if (const auto* a = std::get_if<sema::Arithmetic>(&e.node)) return all(a->operands);
  if (const auto* m = std::get_if<sema::Math>(&e.node)) return all(m->operands);
  if (const auto* g = std::get_if<sema::Aggregate>(&e.node)) return counts_whole(spec, *g->operand);
  const auto* choice = std::get_if<sema::Choice>(&e.node);
  return choice != nullptr && counts_whole(spec, *choice->then_value) &&
         counts_whole(spec, *choice->else_value);
}

// A product of the kernel takes factors within 2^62.
bool fits_factor(const Rational& k) {
  return k.get_num().fits_slong_p() && k.get_den().fits_slong_p();
}

}  // namespace

Unit QuantityBuilder::unit(const sema::Dimension& dimension, const Rational& step) const {
  return {dimension, step, scale_of(spec_, dimension)};
}
// The usual grid of a dimension: what the specification says, else a thousandth of an SI unit, a
// millionth of a ratio.
Unit QuantityBuilder::finest(const sema::Dimension& dimension) const {
  for (const sema::GridStep& grid : spec_.grids) {
    if (grid.dimension == dimension) return unit(dimension, grid.value.value);
  }
  const bool ratio = dimension == sema::dims::ratio;
  return unit(dimension, ratio ? Rational(1, 1'000'000) : Rational(1, 1000));
}

ValueId QuantityBuilder::refuse(const sema::Expr& e, const std::string& what,
                                const std::string& help) {
  diagnostics_.report({Code::expression_not_supported, e.range, what, "", {}, help, {}});
  return add(Const{0}, finest(e.dimension), e);
}

QuantityBuilder::Pair QuantityBuilder::on_one_grid(const sema::Expr& a, const sema::Expr& b) {
  const auto left = fold_constant(a), right = fold_constant(b);
  if (left && !right) {
    const ValueId other = fitted(quantity(b), *left, b);
    const Unit grid = unit_of(other);
    return {constant(*left, grid, a, b), other};
  }
  if (right && !left) {
    const ValueId other = fitted(quantity(a), *right, a);
    const Unit grid = unit_of(other);
    return {other, constant(*right, grid, b, a)};
  }
  const ValueId first = quantity(a);
  return meet(first, a, quantity(b), b);
}

// Whole numbers are counted as finely as what they meet; other quantities as their inputs say.
ValueId QuantityBuilder::fitted(ValueId a, const Rational& constant, const sema::Expr& e) {
  if (sgn(constant) == 0 || !counts_whole(spec_, e)) return a;
  Unit grid = unit_of(a);
  grid.step = common_step(grid.step, abs(constant));
  return grid.is_fine_enough() ? regrid(a, grid, e) : a;
}
// A mean of whole numbers is none: it comes onto the usual grid of bare numbers.
ValueId QuantityBuilder::averaged(ValueId a, const sema::Expr& operand) {
  if (!counts_whole(spec_, operand)) return a;
  Unit grid = unit_of(a);
  grid.step = common_step(grid.step, finest(grid.dimension).step);
  return grid.is_fine_enough() ? regrid(a, grid, operand) : a;
}

ValueId QuantityBuilder::constant(const Rational& si, const Unit& unit, const sema::Expr& e,
                                  const sema::Expr& compared) {
  const Rational steps = si / unit.step;
  if (is_on_grid(si, unit) && fits_int64(steps)) return add(Const{floor_to_int(steps)}, unit, e);
  const auto* fixed = std::get_if<sema::Constant>(&e.node);
  const bool declared = fixed && fixed->declared;
  if (!is_on_grid(si, unit) && fits_int64(steps) && (declared || is_on_no_grid(si, unit))) {
    return add(Between{floor_to_int(steps), ceil_to_int(steps), true}, unit, e);
  }
  const auto show = [&](const Rational& v) { return sema::show(v, unit.dimension); };
  if (!is_on_grid(si, unit)) {
    diagnostics_.report({Code::constant_off_grid,
                         e.range,
                         "this constant does not lie on the grid of " + show(unit.step),
                         "",
                         {},
                         on_grid_help(spec_, si, unit, compared),
                         {}});
  } else {
    diagnostics_.report({Code::value_out_of_range,
                         e.range,
                         "this constant does not fit the integer kernel",
                         "",
                         {},
                         "a constant below 2^61 grid steps of " + show(unit.step) + " works",
                         {}});
  }
  return add(Const{0}, unit, e);
}

// Without anything to be compared with, a constant gets a grid that it lies on.
ValueId QuantityBuilder::constant_alone(const Rational& si, const sema::Expr& e) {
  Unit grid = finest(e.dimension);
  if (sgn(si) != 0) grid.step = common_step(grid.step, abs(si));
  return constant(si, grid, e, e);
}

QuantityBuilder::Pair QuantityBuilder::meet(ValueId a, const sema::Expr& left, ValueId b,
                                            const sema::Expr& right) {
  Unit grid = unit_of(a);
  grid.step = common_step(grid.step, unit_of(b).step);
  if (!grid.is_fine_enough()) grid.step = grid.scale / 1'000'000;
  const ValueId first = regrid(a, grid, left);
  return {first, regrid(b, grid, right)};
}

ValueId QuantityBuilder::regrid(ValueId a, const Unit& to, const sema::Expr& e) {
  const Unit from = unit_of(a);
  return from.step == to.step ? a : factor(a, Rational(from.step / to.step), to, e);
}

// The same number of steps times `by`, in another unit.
ValueId QuantityBuilder::factor(ValueId a, const Rational& by, const Unit& to,
                                const sema::Expr& e) {
  if (!fits_factor(by)) {
    return refuse(e, "a factor does not fit the integer kernel",
                  "a `resolution` that suits the factor works");
  }
  return add(Scale{a, by.get_num().get_si(), by.get_den().get_si()}, to, e);
}

// A finer grid keeps the product with a fraction exact, as far as margins can tell.
ValueId QuantityBuilder::scaled(const sema::Expr& operand, const Rational& k, const sema::Expr& e) {
  const ValueId a = quantity(operand);
  const Rational step = unit_of(a).step;
  Unit to = unit(e.dimension, Rational(step / k.get_den()));
  if (!to.is_fine_enough()) to.step = to.scale / 1'000'000;
  return factor(a, Rational(k * step / to.step), to, e);
}

ValueId QuantityBuilder::product(ValueId a, ValueId b, const sema::Expr& e) {
  const Unit raw = unit(e.dimension, Rational(unit_of(a).step * unit_of(b).step));
  const ValueId exact = add(Multiply{a, b}, raw, e);
  return raw.is_fine_enough() ? exact : regrid(exact, unit(e.dimension, raw.scale / 1'000'000), e);
}

// The product of sizes: that of an interval with itself would be negative where it has both signs.
ValueId QuantityBuilder::square(ValueId a, const sema::Expr& e) {
  const ValueId size = add(Absolute{a}, unit_of(a), e);
  return product(size, size, e);
}

Unit QuantityBuilder::millimetres() const {
  return unit(sema::dims::length, Rational(1, 1000));
}

// Coordinates come onto the grid of zones, rounded outward.
ValueId QuantityBuilder::coordinate(const sema::Expr& e) {
  return regrid(quantity(e), millimetres(), e);
}

// Decisions carry the zones of robots alone.
ValueId QuantityBuilder::refuse_place(const sema::Expr& e) {
  return refuse(e, "a point in a zone is judged by monitors without a robot only",
                "write a monitor without `for` about the point, or pass its clearance in as an "
                "input");
}

template <class Node>
ValueId QuantityBuilder::gap(const Node& v, const sema::Expr& e) {
  if (watch_.regions.empty()) return refuse_place(e);
  const ValueId x = coordinate(*v.x), y = coordinate(*v.y);
  if (v.z) {
    const ValueId z = coordinate(*v.z);
    const TableMap::Solids& zone = tables_.solid(v.zone);
    return add(SolidClearance{x, y, z, zone.within, zone.around}, millimetres(), e);
  }
  const TableMap::Regions& zone = tables_.region(v.zone);
  return add(PointClearance{x, y, zone.within, zone.around}, millimetres(), e);
}

ValueId QuantityBuilder::quantity(const sema::PointClearance& v, const sema::Expr& e) {
  return gap(v, e);
}

ValueId QuantityBuilder::inside(const sema::PointInside& v, const sema::Expr& e) {
  const ValueId clearance = gap(v, e);
  const auto is_there = [&] {
    const ValueId boundary = add(Const{0}, millimetres(), e);
    return add(AtLeast{clearance, boundary, false}, std::nullopt, e);
  };
  const Op& made = block_.values[static_cast<std::size_t>(clearance)].op;
  if (const auto* p = std::get_if<PointClearance>(&made)) {
    const PointClearance at = *p;  // more values move the one that it is part of
    return add(PointInside{is_there(), at.a, at.b, at.within, at.around}, std::nullopt, e);
  }
  if (const auto* p = std::get_if<SolidClearance>(&made)) {
    const SolidClearance at = *p;
    return add(SolidInside{is_there(), at.a, at.b, at.c, at.within, at.around}, std::nullopt, e);
  }
  return clearance;  // refused
}

Trail QuantityBuilder::trail(const sema::Trail& v) {
  Trail trail;
  for (const sema::ExprPtr& own : v.own) trail.own.push_back(coordinate(*own));
  if (v.path) trail.channel = channel_of(watch_, spec_[*v.path].name);
  trail.next_only = v.next_only;
  return trail;
}

ValueId QuantityBuilder::quantity(const sema::TrailClearance& v, const sema::Expr& e) {
  const TableMap::Regions& zone = tables_.region(v.zone);
  return add(TrailClearance{trail(v.trail), zone.within, zone.around, v.greatest}, millimetres(),
             e);
}

ValueId QuantityBuilder::quantity(const sema::TrailDistance& v, const sema::Expr& e) {
  Trail one = trail(v.trail);
  return add(TrailDistance{std::move(one), trail(v.other)}, millimetres(), e);
}

ValueId QuantityBuilder::quantity(const sema::ZoneDistance& v, const sema::Expr& e) {
  const TableMap::Gap& gap = tables_.gaps.at(TableMap::pair(v));
  if (gap.lo_mm == gap.hi_mm) return add(Const{gap.lo_mm}, millimetres(), e);
  return add(Between{gap.lo_mm, gap.hi_mm, gap.open}, millimetres(), e);
}

// Outside: the greatest clearance is less than nothing.
ValueId QuantityBuilder::inside(const sema::TrailInside& v, const sema::Expr& e) {
  const TableMap::Regions& zone = tables_.region(v.zone);
  Trail held = trail(v.trail);
  const ValueId clearance =
      add(TrailClearance{held, zone.within, zone.around, v.outside}, millimetres(), e);
  const ValueId boundary = add(Const{0}, millimetres(), e);
  const AtLeast is =
      v.outside ? AtLeast{boundary, clearance, true} : AtLeast{clearance, boundary, false};
  const ValueId condition = add(is, std::nullopt, e);
  return add(TrailInside{condition, std::move(held), zone.within, zone.around, v.outside},
             std::nullopt, e);
}

// The operand on a grid of squares, whose root is a grid.
ValueId QuantityBuilder::root(ValueId a, const sema::Expr& e) {
  const Unit to = finest(e.dimension);
  const Unit square{unit_of(a).dimension, Rational(to.step * to.step), unit_of(a).scale};
  const ValueId squares = regrid(a, square, e);
  return add(Root{squares}, to, e);
}

// The angle in parts of a turn, and what its sine or cosine is of it.
ValueId QuantityBuilder::wave(const sema::Math& v, const sema::Expr& e) {
  const sema::Expr& angle = *v.operands[0];
  const Unit turn = unit({}, Rational(1, parts_per_turn));
  const Rational per_turn(static_cast<long>(parts_per_turn));
  const auto fixed = fold_constant(angle);
  const auto varying = fixed ? std::nullopt : std::optional(quantity(angle));
  const auto parts = fixed ? parts_of_turn(*fixed, per_turn)
                           : parts_of_turn(unit_of(*varying).step, per_turn * phase_q);
  if (!parts) {
    return refuse(e, "a turn by " + sema::show(fixed.value_or(Rational(0)), angle.dimension),
                  "angles within a million turns work");
  }
  const ValueId phase = varying ? add(Phase{*varying, parts->least, parts->most}, turn, e)
                                : add(Between{parts->least, parts->most}, turn, e);
  const Unit share = unit({}, Rational(1, sine_q));
  return v.op == sema::MathOp::sine ? add(Sine{phase}, share, e) : add(Cosine{phase}, share, e);
}

ValueId QuantityBuilder::norm(const sema::Math& v, const sema::Expr& e) {
  if (v.operands.size() == 1) {
    const ValueId a = quantity(*v.operands[0]);
    return add(Absolute{a}, unit_of(a), e);
  }
  if (v.operands.size() == 2) {
    const auto [a, b] = on_one_grid(*v.operands[0], *v.operands[1]);
    return add(Norm{a, b}, unit_of(a), e);
  }
  // more than a plane: the root of the sum of squares, on one grid
  std::optional<ValueId> sum;
  for (const sema::ExprPtr& operand : v.operands) {
    const ValueId a = quantity(*operand);
    const ValueId size = add(Absolute{a}, unit_of(a), e);
    const Unit& grid = unit_of(a);
    const sema::Dimension squared = grid.dimension * grid.dimension;
    const ValueId square =
        add(Multiply{size, size}, unit(squared, Rational(grid.step * grid.step)), e);
    if (sum) {
      const auto [x, y] = meet(*sum, e, square, e);
      sum = add(Add{x, y}, unit_of(x), e);
    } else {
      sum = square;
    }
  }
  return root(*sum, e);
}

}  // namespace rtac::ir
