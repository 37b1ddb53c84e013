// What the grammar's actions call: places become names, parts become nodes. Internal to the folder.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/syntax/ast.h"

namespace rtac::syntax {

struct Token;

// An expression on its way into a node. The height is carried along because trees are walked and
// freed recursively: one that is too high is replaced by ErrorExpr.
struct Operand {
  ExprPtr expr;
  int height = 0;
};
struct Operands {
  std::vector<ExprPtr> list;
  int height = 0;
};
struct PolygonParts {
  PolygonLit node;
  int height = 0;
};
struct IntervalParts {
  Interval node;
  int height = 0;
};
struct NumberValue {
  Rational value;
  std::string text;
  bool bad = false;  // malformed: reported by the lexer
};

// Highest tree: a chain of `|` over this many zones is better cut into named zones.
constexpr int kTreeHeightMax = 400;

inline SourceRange join_ranges(const SourceRange& first, const SourceRange& last,
                               bool empty = false) {
  return {first.file, empty ? first.end : first.begin, empty ? first.end : last.end};
}

inline ExprPtr take(Operand operand) {
  return std::move(operand.expr);
}
inline std::vector<ExprPtr> take(Operands operands) {
  return std::move(operands.list);
}
void push(Operands& list, Operand operand);
PolygonParts ring_of(Operands points, const SourceRange& range);
PolygonParts with_hole(PolygonParts polygon, PolygonParts hole);

template <class T>
void append(std::vector<T>& to, std::vector<T> from) {
  for (T& element : from) to.push_back(std::move(element));
}

// An upper end `inf` becomes null.
IntervalParts interval_of(Operand from, Operand to, const SourceRange& range);

// `max_age inf` is no expression, but a promise of its own.
InputItem input_of(std::vector<Name> names, TypeRef type, std::vector<Limits> limits,
                   Operands error, ExprPtr max_age, Operands resolution);
ParamItem param_of(Name name, TypeRef type, Limits limits, Operand value);
RobotItem with_name(RobotItem robot, Name name);
ControllerItem with_header(ControllerItem controller, Name name, Role role, Name kind);
MonitorItem with_header(MonitorItem monitor, Name name, MonitorItem subject);
DecisionItem with_header(DecisionItem decision, Name name, Name kind);

template <class Template>
ControllerItem implemented(Template implementation, const SourceRange& first,
                           const SourceRange& last) {
  ControllerItem controller{};
  controller.implementation = std::move(implementation);
  controller.implementation_range = join_ranges(first, last);
  return controller;
}
template <class Template>
ControllerItem implemented(Template implementation, const SourceRange& range) {
  return implemented(std::move(implementation), range, range);
}

SequenceTemplate with_step(SequenceTemplate sequence, SequenceStep step);
ControllerItem implemented_by(SafeTemplate implementation, const SourceRange& range);

// One run of the parser over one list of tokens, the last of which is END.
class Builder {
 public:
  Builder(const SourceManager& sources, const std::vector<Token>& tokens)
      : sources_(sources), tokens_(tokens) {}

  // For the parser.
  const Token& next_token();
  void fail(std::vector<int> expected_symbols);

  // For the actions.
  [[nodiscard]] Name name(const SourceRange& range) const;
  void add_spec(Name name) { specs_.push_back(std::move(name)); }
  template <class Node>
  void add(const SourceRange& range, Node node) {
    items_.push_back({range, std::move(node)});
  }
  template <class Node>
  static Operand leaf(const SourceRange& range, Node node) {
    return {std::make_unique<Expr>(Expr{range, std::move(node)}), 1};
  }
  Operand number(const SourceRange& range, NumberValue value, std::optional<Unit> unit);
  Operand unary(const SourceRange& range, UnaryOp op, Operand operand);
  Operand binary(const SourceRange& range, BinaryOp op, Operand left, Operand right,
                 const SourceRange& op_range);
  Operand held(const SourceRange& range, Operand operand, Operand duration);
  Operand previously(const SourceRange& range, Operand operand);
  Operand past(const SourceRange& range, PastOp op, std::optional<IntervalParts> interval,
               Operand operand);
  Operand since(const SourceRange& range, std::optional<IntervalParts> interval, Operand left,
                Operand right);
  Operand within_of(const SourceRange& range, Operand operand, Operand duration, Operand trigger);
  Operand aggregate(const SourceRange& range, Name name, IntervalParts interval, Operand operand);
  Operand conditional(const SourceRange& range, Operand condition, Operand then_value,
                      Operand else_value);
  Operand let(const SourceRange& range, Name name, Operand value, Operand body);
  Operand index(const SourceRange& range, Operand base, Operand index);
  Operand quantified(const SourceRange& range, Quantified head, Operand guard, Operand body);
  Operand over_fleet(const SourceRange& range, OverFleet head, Operand guard, Operand body);
  Operand call(const SourceRange& range, Name callee, Operands arguments);
  Operand member(const SourceRange& range, Operand base, Name field);
  Operand point(const SourceRange& range, Operand first, Operands rest);
  Operand rectangle(const SourceRange& range, Operand from, Operand to);
  Operand box(const SourceRange& range, Operand from, Operand to);
  Operand circle(const SourceRange& range, Operand centre, Operand radius);
  Operand prism(const SourceRange& range, Operand base, Operand floor, Operand ceiling);
  Operand polygon(const SourceRange& range, PolygonParts parts);
  ImportLit zone_file(Text path);

  // The result.
  [[nodiscard]] bool failed() const { return failed_; }
  [[nodiscard]] std::size_t error_index() const { return next_ - 1; }
  [[nodiscard]] const std::vector<int>& expected_symbols() const { return expected_symbols_; }
  [[nodiscard]] const std::optional<SourceRange>& too_high() const { return too_high_; }
  std::vector<Item> take_items() { return std::move(items_); }
  std::vector<Name> take_specs() { return std::move(specs_); }
  std::vector<Text> take_zone_files() { return std::move(zone_files_); }

 private:
  // Wraps a node over parts of at most `height` levels.
  template <class Node>
  Operand grow(const SourceRange& range, int height, Node node) {
    if (height < kTreeHeightMax) {
      return {std::make_unique<Expr>(Expr{range, std::move(node)}), height + 1};
    }
    if (!too_high_) too_high_ = range;
    return leaf(range, ErrorExpr{});
  }

  const SourceManager& sources_;
  const std::vector<Token>& tokens_;
  std::size_t next_ = 0;
  bool failed_ = false;
  std::vector<int> expected_symbols_;
  std::optional<SourceRange> too_high_;
  std::vector<Item> items_;
  std::vector<Name> specs_;
  std::vector<Text> zone_files_;
};

}  // namespace rtac::syntax
