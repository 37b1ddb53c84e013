// Quantities of a monitor without a robot: constants, grids, arithmetic.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/ir/module.h"
#include "compiler/ir/table_map.h"
#include "compiler/sema/spec.h"
#include "compiler/support/source.h"

namespace rtac::ir {

// Of a fact that may speak of the monitored robot: its tables, its kind, and how what is said of
// the other robots becomes a block.
struct RobotSignals {
  const TableMap& tables;
  sema::KindId kind;
  std::function<Block(const sema::Expr&)> others;
  std::function<AgentIndex(const sema::AgentDistance&)> agent;
};

// Value in SI of an expression without inputs; nullopt otherwise.
std::optional<Rational> fold_constant(const sema::Expr& e);

// Adds values to one block. What conditions inside a quantity become, the caller says.
class QuantityBuilder {
 public:
  using Condition = std::function<ValueId(const sema::Expr&)>;
  using Pair = std::pair<ValueId, ValueId>;

  // `robot`: null when there is none. `margin_full`: margins are remembered however long a window
  // is.
  QuantityBuilder(const sema::Spec& spec, const SourceManager& sources, const TableMap& tables,
                  Watch& watch, diag::Engine& diagnostics, const RobotSignals* robot,
                  bool margin_full, Condition condition)
      : margin_full_(margin_full),
        spec_(spec),
        sources_(sources),
        tables_(tables),
        watch_(watch),
        diagnostics_(diagnostics),
        robot_(robot),
        condition_(std::move(condition)) {}

  ValueId quantity(const sema::Expr& e);
  ValueId clearance(sema::ZoneId zone, const sema::Expr& e);
  ValueId zero(ValueId like, const sema::Expr& e);
  // The margin of a place in a zone.
  ValueId inside(const sema::PointInside& v, const sema::Expr& e);
  // The margin of a trail in a zone.
  ValueId inside(const sema::TrailInside& v, const sema::Expr& e);
  // The grid of places, and of their distances.
  [[nodiscard]] Unit millimetres() const;
  // Two quantities on one grid; a constant takes the grid of the other one.
  Pair on_one_grid(const sema::Expr& a, const sema::Expr& b);
  // `a`, which is what `e` says, on a grid that the constant may lie on.
  ValueId fitted(ValueId a, const Rational& constant, const sema::Expr& e);
  // The operand of a mean on the grid of the mean.
  ValueId averaged(ValueId a, const sema::Expr& operand);
  ValueId add(Op op, std::optional<Unit> unit, const sema::Expr& e);
  [[nodiscard]] Window window(const sema::Interval& interval) const;
  [[nodiscard]] std::int64_t ticks(const Rational& seconds) const;
  [[nodiscard]] const Unit& unit_of(ValueId id) const { return *block_[id].unit; }
  // The text of a value that is the negation of what is written.
  void say_negated(ValueId id) {
    std::string& text = block_.values[static_cast<std::uint32_t>(id)].text;
    text = "not (" + text + ")";
  }
  // Whether a margin can be finite: some comparison is behind it.
  [[nodiscard]] bool is_measured(ValueId id) const {
    return measured_[static_cast<std::uint32_t>(id)];
  }
  Block take(ValueId result);

 private:
  ValueId wave(const sema::Math& v, const sema::Expr& e);
  ValueId quantity(const sema::Arithmetic& v, const sema::Expr& e);
  ValueId quantity(const sema::Math& v, const sema::Expr& e);
  ValueId quantity(const sema::Choice& v, const sema::Expr& e);
  ValueId quantity(const sema::Aggregate& v, const sema::Expr& e);
  ValueId quantity(const sema::InputRef& v, const sema::Expr& e);
  ValueId quantity(const sema::ParamRef& v, const sema::Expr& e);
  ValueId quantity(const sema::AgeOf& v, const sema::Expr& e);
  ValueId quantity(const sema::SensedAge& v, const sema::Expr& e);
  ValueId quantity(const sema::SignalRef& v, const sema::Expr& e);
  ValueId quantity(const sema::Clearance& v, const sema::Expr& e);
  ValueId quantity(const sema::EnergyTo& v, const sema::Expr& e);
  ValueId quantity(const sema::AgentDistance& v, const sema::Expr& e);
  ValueId quantity(const sema::CountOthers& v, const sema::Expr& e);
  ValueId quantity(const sema::PointClearance& v, const sema::Expr& e);
  ValueId quantity(const sema::TrailClearance& v, const sema::Expr& e);
  ValueId quantity(const sema::TrailDistance& v, const sema::Expr& e);
  ValueId quantity(const sema::ZoneDistance& v, const sema::Expr& e);
  template <class Node>
  ValueId quantity(const Node&, const sema::Expr& e);

  Unit unit(const sema::Dimension& dimension, const Rational& step) const;
  Unit finest(const sema::Dimension& dimension) const;
  ValueId constant(const Rational& si, const Unit& unit, const sema::Expr& e,
                   const sema::Expr& compared);
  ValueId constant_alone(const Rational& si, const sema::Expr& e);
  // Two values on one grid; what they stand for in the text.
  Pair meet(ValueId a, const sema::Expr& left, ValueId b, const sema::Expr& right);
  template <class Node>
  ValueId gap(const Node& v, const sema::Expr& e);
  ValueId coordinate(const sema::Expr& e);
  Trail trail(const sema::Trail& v);
  ValueId regrid(ValueId a, const Unit& to, const sema::Expr& e);
  ValueId scaled(const sema::Expr& operand, const Rational& factor, const sema::Expr& e);
  ValueId product(ValueId a, ValueId b, const sema::Expr& e);
  ValueId square(ValueId a, const sema::Expr& e);
  ValueId root(ValueId a, const sema::Expr& e);
  ValueId norm(const sema::Math& v, const sema::Expr& e);
  ValueId rate(const sema::Aggregate& v, const sema::Expr& e);
  ValueId factor(ValueId a, const Rational& by, const Unit& to, const sema::Expr& e);
  ValueId refuse(const sema::Expr& e, const std::string& what, const std::string& help);
  ValueId refuse_place(const sema::Expr& e);

  const bool margin_full_;
  const sema::Spec& spec_;
  const SourceManager& sources_;
  const TableMap& tables_;
  Watch& watch_;
  diag::Engine& diagnostics_;
  const RobotSignals* robot_;
  Condition condition_;
  Block block_;
  std::vector<bool> measured_;  // by value
};

}  // namespace rtac::ir
