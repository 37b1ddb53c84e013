#include "compiler/syntax/dump_expr.h"

#include <variant>

#include "compiler/syntax/spelling.h"

namespace rtac::syntax {
namespace {

class ExprDumper {
 public:
  explicit ExprDumper(TreeText& text) : text_(text) {}

  void add(const Expr& expr) {
    std::visit([&](const auto& node) { add(node, expr.range); }, expr.node);
  }
  void part(const std::string& label, const ExprPtr& expr) {
    if (!expr) return;
    line(label, expr->range);
    Level level{text_};
    add(*expr);
  }

 private:
  using Level = TreeText::Level;
  void line(const std::string& text, const SourceRange& range) { text_.line(text, range); }
  void add_all(const std::vector<ExprPtr>& list) {
    for (const ExprPtr& expr : list) add(*expr);
  }

  void add(const NumberLit& node, const SourceRange& range) {
    line("Number " + node.text + (node.unit ? ' ' + node.unit->text : ""), range);
  }
  void add(const BoolLit& node, const SourceRange& range) {
    line(node.value ? "Bool true" : "Bool false", range);
  }
  void add(const NameRef& node, const SourceRange& range) { line("Name " + node.name.text, range); }
  void add(const Member& node, const SourceRange& range) {
    line("Member " + node.field.text, range);
    Level level{text_};
    add(*node.base);
  }
  void add(const Call& node, const SourceRange& range) {
    line("Call " + node.callee.text, range);
    Level level{text_};
    add_all(node.arguments);
  }
  void add(const Unary& node, const SourceRange& range) {
    line("Unary " + std::string{spell(node.op)}, range);
    Level level{text_};
    add(*node.operand);
  }
  void add(const Binary& node, const SourceRange& range) {
    line("Binary " + std::string{spell(node.op)}, range);
    Level level{text_};
    add(*node.left);
    add(*node.right);
  }
  void add(const Held& node, const SourceRange& range) {
    line("Held", range);
    Level level{text_};
    add(*node.operand);
    part("Duration", node.duration);
  }
  void add(const Interval& interval) {
    line(interval.to ? "Interval" : "Interval to inf", interval.range);
    Level level{text_};
    add(*interval.from);
    if (interval.to) add(*interval.to);
  }
  void add(const Previously& node, const SourceRange& range) {
    line("Previously", range);
    Level level{text_};
    add(*node.operand);
  }
  void add(const Past& node, const SourceRange& range) {
    line("Past " + std::string{spell(node.op)}, range);
    Level level{text_};
    if (node.interval) add(*node.interval);
    add(*node.operand);
  }
  void add(const Since& node, const SourceRange& range) {
    line("Since", range);
    Level level{text_};
    if (node.interval) add(*node.interval);
    add(*node.left);
    add(*node.right);
  }
  void add(const WithinOf& node, const SourceRange& range) {
    line("WithinOf", range);
    Level level{text_};
    add(*node.operand);
    part("Duration", node.duration);
    part("Trigger", node.trigger);
  }
  void add(const Aggregate& node, const SourceRange& range) {
    line("Aggregate " + node.name.text, range);
    Level level{text_};
    add(node.interval);
    add(*node.operand);
  }
  void add(const Conditional& node, const SourceRange& range) {
    line("If", range);
    Level level{text_};
    add(*node.condition);
    part("Then", node.then_value);
    part("Else", node.else_value);
  }
  void add(const Let& node, const SourceRange& range) {
    line("Let " + node.name.text, range);
    Level level{text_};
    add(*node.value);
    part("In", node.body);
  }
  void add(const Index& node, const SourceRange& range) {
    line("Index", range);
    Level level{text_};
    add(*node.base);
    add(*node.index);
  }
  void add(const Quantified& node, const SourceRange& range) {
    line("Quantified " + std::string{spell(node.quantifier)} + ' ' + node.variable.text + " : " +
             node.kind.text,
         range);
    Level level{text_};
    part("Guard", node.guard);
    add(*node.body);
  }
  void add(const OverFleet& node, const SourceRange& range) {
    line("OverFleet " + node.name.text + ' ' + node.variable.text + " : " + node.kind.text, range);
    Level level{text_};
    part("Guard", node.guard);
    add(*node.body);
  }
  void add(const PointLit& node, const SourceRange& range) {
    line("Point", range);
    Level level{text_};
    add_all(node.coordinates);
  }
  void add(const RectangleLit& node, const SourceRange& range) {
    line(node.says_box ? "Box" : "Rectangle", range);
    Level level{text_};
    add(*node.from);
    add(*node.to);
  }
  void add(const CircleLit& node, const SourceRange& range) {
    line("Circle", range);
    Level level{text_};
    add(*node.centre);
    part("Radius", node.radius);
  }
  void add(const PolygonLit& node, const SourceRange& range) {
    line("Polygon", range);
    Level level{text_};
    add("Ring", node.outer);
    for (const PolygonLit::Ring& hole : node.holes) add("Hole", hole);
  }
  void add(const std::string& label, const PolygonLit::Ring& ring) {
    line(label, ring.range);
    Level level{text_};
    add_all(ring.points);
  }
  void add(const PrismLit& node, const SourceRange& range) {
    line("Prism", range);
    Level level{text_};
    add(*node.base);
    part("From", node.floor);
    part("To", node.ceiling);
  }
  void add(const ImportLit& node, const SourceRange& range) {
    line("Import " + spell_text(node.path.text), range);
    Level level{text_};
    for (const ImportOption& option : node.options) {
      std::string text{spell(option.word)};
      if (option.text) text += ' ' + spell_text(option.text->text);
      for (const Name& name : option.names) text += ' ' + name.text;
      line(text, option.range);
      if (!option.level) continue;
      Level at{text_};
      add(*option.level);
    }
  }
  void add(const ErrorExpr&, const SourceRange& range) { line("Error", range); }

  TreeText& text_;
};

}  // namespace

void TreeText::line(const std::string& text, const SourceRange& range) {
  const LineColumn place = sources_.position(range.file, range.begin);
  out_ += std::string(2 * depth_, ' ') + text + " @" + std::to_string(place.line) + ':' +
          std::to_string(place.column) + '\n';
}

void dump_expr(const Expr& expr, TreeText& text) {
  ExprDumper{text}.add(expr);
}

void dump_part(const std::string& label, const ExprPtr& expr, TreeText& text) {
  ExprDumper{text}.part(label, expr);
}

}  // namespace rtac::syntax
