#include "compiler/sema/expr_printer.h"

#include <algorithm>

#include "compiler/sema/dimension.h"
#include "compiler/support/overloaded.h"

namespace rtac::sema {

// SI throughout, so that equal quantities read the same however they were written.
std::string si_text(const Rational& value, const Dimension& dimension) {
  if (dimension == dims::time) return to_decimal(value) + " s";
  return show(value, dimension);
}
std::string si_text(const Quantity& quantity, const Dimension& dimension) {
  return si_text(quantity.value, dimension);
}

std::string point_text(const Point& p) {
  return "(" + to_decimal(p.x) + ", " + to_decimal(p.y) + ")";
}

namespace {

std::string ring(const ZonePolygon::Ring& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    text += (i > 0 ? ", " : "") + point_text(ring.points[i]);
  }
  return text + "]";
}

const char* symbol_of(ZoneOp op) {
  switch (op) {
    case ZoneOp::unite:
      return " | ";
    case ZoneOp::intersect:
      return " & ";
    case ZoneOp::subtract:
      return " - ";
  }
  return "";
}

const char* symbol_of(CompareOp op) {
  switch (op) {
    case CompareOp::less:
      return " < ";
    case CompareOp::less_equal:
      return " <= ";
    case CompareOp::greater:
      return " > ";
    case CompareOp::greater_equal:
      return " >= ";
  }
  return "";
}

const char* symbol_of(ArithmeticOp op) {
  switch (op) {
    case ArithmeticOp::add:
      return " + ";
    case ArithmeticOp::subtract:
      return " - ";
    case ArithmeticOp::multiply:
      return " * ";
    case ArithmeticOp::divide:
      return " / ";
    case ArithmeticOp::negate:
      return "-";
  }
  return "";
}

const char* symbol_of(LogicOp op) {
  switch (op) {
    case LogicOp::logical_not:
      return "not ";
    case LogicOp::logical_and:
      return " and ";
    case LogicOp::logical_or:
      return " or ";
    case LogicOp::implies:
      return " implies ";
    case LogicOp::iff:
      return " iff ";
    case LogicOp::logical_xor:
      return " xor ";
  }
  return "";
}

std::string name_of(MathOp op) {
  switch (op) {
    case MathOp::minimum:
      return "min";
    case MathOp::maximum:
      return "max";
    case MathOp::absolute:
      return "abs";
    case MathOp::square_root:
      return "sqrt";
    case MathOp::norm:
      return "norm";
    case MathOp::sine:
      return "sine";
    case MathOp::cosine:
      return "cosine";
  }
  return "";
}

std::string name_of(Sensed signal) {
  switch (signal) {
    case Sensed::position:
      return "position";
    case Sensed::velocity:
      return "velocity";
    case Sensed::battery:
      return "battery";
  }
  return "";
}
std::string name_of(AggregateOp op) {
  switch (op) {
    case AggregateOp::minimum:
      return "min";
    case AggregateOp::maximum:
      return "max";
    case AggregateOp::mean:
      return "mean";
    case AggregateOp::sum:
      return "sum";
    case AggregateOp::count:
      return "count";
    case AggregateOp::rate:
      return "rate";
  }
  return "";
}

std::string interval(const Interval& window) {
  return "[" + si_text(window.from, dims::time) + ", " +
         (window.to ? si_text(*window.to, dims::time) : std::string("inf")) + "]";
}

std::string text_of(const ZonePolygon& polygon) {
  std::string text = "polygon " + ring(polygon.outer);
  for (const auto& hole : polygon.holes) text += " hole " + ring(hole);
  return text;
}
std::string text_of(const ZoneCircle& circle) {
  return "circle " + point_text(circle.centre) + " radius " + to_decimal(circle.radius);
}
std::string text_of(const ZoneImport::Area& area) {
  std::string text;
  for (std::size_t i = 0; i < area.parts.size(); ++i) {
    text += text.empty() ? "" : " | ";
    text += std::visit([](const auto& shape) { return text_of(shape); }, area.parts[i]);
    if (area.bands.empty()) continue;
    const ZoneImport::Band& band = area.bands[i];
    if (band.floor) text += " from " + to_decimal(*band.floor);
    if (band.ceiling) text += " to " + to_decimal(*band.ceiling);
  }
  return area.parts.size() > 1 ? "(" + text + ")" : text;
}
std::string text_of(const std::vector<ZoneImport::Area>& areas, const char* joined) {
  std::string text;
  for (const ZoneImport::Area& area : areas) text += (text.empty() ? "" : joined) + text_of(area);
  return areas.size() > 1 ? "(" + text + ")" : text;
}
std::string text_of(const ZoneImport& imported) {
  std::string text;
  for (const auto& group : imported.inclusions) {
    text += (text.empty() ? "" : " | ") + text_of(group, " & ");
  }
  if (imported.inclusions.size() > 1) text = "(" + text + ")";
  if (!imported.exclusions.empty()) text += " - " + text_of(imported.exclusions, " | ");
  return "import \"" + imported.path + "\" error " + to_decimal(imported.error) + " [" + text + "]";
}

}  // namespace

std::string ExprPrinter::zone(ZoneId id) const {
  const Zone& found = spec_[id];
  return found.name.empty() ? zone(*found.value) : found.name;
}

std::string ExprPrinter::zone(const ZoneExpr& expr) const {
  return std::visit(
      Overloaded{
          [](const ZonePolygon& polygon) { return text_of(polygon); },
          [](const ZoneCircle& circle) { return text_of(circle); },
          [&](const ZoneRef& reference) { return zone(reference.zone); },
          [&](const ZoneBinary& binary) {
            return "(" + zone(*binary.left) + symbol_of(binary.op) + zone(*binary.right) + ")";
          },
          [](const ZoneImport& imported) { return text_of(imported); },
          [&](const ZoneReceived& received) { return spec_[received.input].name; },
          [&](const ZonePrism& prism) {
            return "prism (" + zone(*prism.base) + ") from " + to_decimal(prism.floor) + " to " +
                   to_decimal(prism.ceiling);
          },
          [&](const ZoneComplement& of) { return "complement(" + zone(of.zone) + ")"; },
          [&](const ZoneOffset& offset) {
            return std::string(offset.distance < 0 ? "shrink(" : "grow(") + zone(*offset.operand) +
                   ", " + to_decimal(Rational(abs(offset.distance))) + ")";
          },
      },
      expr.node);
}

// One line per node; splitting it would hide that none is missing.
// NOLINTNEXTLINE(readability-function-size)
std::string ExprPrinter::expr(const Expr& expr) const {
  return std::visit(
      Overloaded{
          [&](const Constant& constant) { return si_text(constant.value, expr.dimension); },
          [](const Truth& truth) { return std::string(truth.value ? "true" : "false"); },
          [](const SignalRef& reference) {
            const std::string who = reference.subject == Subject::self ? "self" : "other";
            if (reference.signal == Signal::altitude) return who + ".position.z";
            return who + (reference.signal == Signal::battery ? ".battery" : ".speed");
          },
          [&](const Clearance& atom) { return "clearance(self, " + zone(atom.zone) + ")"; },
          [](const Distance&) { return std::string("distance(self, other)"); },
          [&](const AgentDistance& atom) {
            return "distance(self, " + spec_[atom.agent].name + ")";
          },
          [&](const EnergyTo& atom) { return "energy_to(" + spec_[atom.site].name + "(self))"; },
          [&](const InsideZone& atom) { return "(self inside " + zone(atom.zone) + ")"; },
          [&](const PlanInside& atom) { return "(self.plan inside " + zone(atom.zone) + ")"; },
          [&](const Arithmetic& node) { return joined(node.operands, symbol_of(node.op)); },
          [&](const Compare& compare) {
            return "(" + this->expr(*compare.left) + symbol_of(compare.op) +
                   this->expr(*compare.right) + ")";
          },
          [&](const Logic& node) { return joined(node.operands, symbol_of(node.op)); },
          [&](const HeldFor& held) {
            return "(" + this->expr(*held.operand) + " for " + si_text(held.duration, dims::time) +
                   ")";
          },
          [&](const ForOthers& others) {
            return std::string(others.universal ? "(forall" : "(exists") +
                   " other : " + this->expr(*others.body) + ")";
          },
          [&](const CountOthers& others) {
            return "count(other : " + this->expr(*others.body) + ")";
          },
          [&](const OverMembers& members) {
            return (members.maximum ? "max" : "min") + listed(members.operands);
          },
          [&](const InputRef& reference) { return input(reference); },
          [&](const AgeOf& age) { return "age(" + spec_[age.input].name + ")"; },
          [](const SensedAge& age) { return "age(self." + name_of(age.signal) + ")"; },
          [&](const ParamRef& reference) { return spec_[reference.param].name; },
          [&](const PointInside& atom) {
            return "(" + point(*atom.x, *atom.y, atom.z.get()) + " inside " + zone(atom.zone) + ")";
          },
          [&](const PointClearance& atom) {
            return "clearance(" + point(*atom.x, *atom.y, atom.z.get()) + ", " + zone(atom.zone) +
                   ")";
          },
          [&](const TrailInside& atom) {
            return "(" + trail(atom.trail) + (atom.outside ? " outside " : " inside ") +
                   zone(atom.zone) + ")";
          },
          [&](const TrailClearance& atom) {
            return std::string(atom.greatest ? "greatest" : "least") + " clearance(" +
                   trail(atom.trail) + ", " + zone(atom.zone) + ")";
          },
          [&](const TrailDistance& atom) {
            return "distance(" + trail(atom.trail) + ", " + trail(atom.other) + ")";
          },
          [&](const ZoneDistance& atom) {
            return "distance(" + zone(atom.zone) + ", " + zone(atom.other) + ")";
          },
          [&](const PathGiven& atom) { return "given(" + spec_[atom.input].name + ")"; },
          [&](const ZoneOpen& open) { return "open(" + zone(open.zone) + ")"; },
          [&](const WhileOpen& open) { return this->expr(*open.operand); },
          [&](const IsValue& is) {
            const Input& signal = spec_[is.input];
            return "(" + input({is.input, is.component}) +
                   " == " + spec_[*signal.enumeration].values[is.value] + ")";
          },
          [&](const SameValue& same) {
            return "(" + input(same.left) + " == " + input(same.right) + ")";
          },
          [&](const Math& node) { return name_of(node.op) + listed(node.operands); },
          [&](const Choice& choice) {
            return "(if " + this->expr(*choice.condition) + " then " +
                   this->expr(*choice.then_value) + " else " + this->expr(*choice.else_value) + ")";
          },
          [&](const Previously& previously) {
            return "(previously " + this->expr(*previously.operand) + ")";
          },
          [&](const Past& past) {
            return (past.op == PastOp::once ? "(once" : "(historically") + interval(past.interval) +
                   " " + this->expr(*past.operand) + ")";
          },
          [&](const Since& since) {
            return "(" + this->expr(*since.left) + " since" + interval(since.interval) + " " +
                   this->expr(*since.right) + ")";
          },
          [&](const WithinOf& within) {
            return "(" + this->expr(*within.operand) + " within " +
                   si_text(within.duration, dims::time) + " of " + this->expr(*within.trigger) +
                   ")";
          },
          [&](const Aggregate& aggregate) {
            return name_of(aggregate.op) + interval(aggregate.interval) + "(" +
                   this->expr(*aggregate.operand) + ")";
          },
      },
      expr.node);
}

// A component stands behind its input: `p.x`, `temps[2]`, `corners[0].x`.
std::string ExprPrinter::input(const InputRef& reference) const {
  const Input& signal = spec_[reference.input];
  const std::string& component = signal.components[reference.component];
  if (component.empty()) return signal.name;
  if (component[0] < '0' || component[0] > '9') return signal.name + "." + component;
  const std::size_t dot = std::min(component.find('.'), component.size());
  return signal.name + "[" + component.substr(0, dot) + "]" + component.substr(dot);
}

std::string ExprPrinter::point(const Expr& x, const Expr& y, const Expr* z) const {
  return "(" + expr(x) + ", " + expr(y) + (z != nullptr ? ", " + expr(*z) : "") + ")";
}

std::string ExprPrinter::trail(const Trail& trail) const {
  std::string places;
  for (std::size_t i = 0; i + 1 < trail.own.size(); i += 2) {
    places += (i > 0 ? ", " : "") + point(*trail.own[i], *trail.own[i + 1], nullptr);
  }
  if (!trail.path) return trail.own.size() > 2 ? "leg(" + places + ")" : places;
  const std::string& name = spec_[*trail.path].name;
  if (trail.own.empty()) return name;
  return std::string(trail.next_only ? "leg(" : "path(") + places + ", " + name + ")";
}

std::string ExprPrinter::listed(const std::vector<ExprPtr>& operands) const {
  std::string text = "(";
  for (const ExprPtr& operand : operands) text += (text == "(" ? "" : ", ") + expr(*operand);
  return text + ")";
}

// A single operand stands behind its operator.
std::string ExprPrinter::joined(const std::vector<ExprPtr>& operands, const char* symbol) const {
  std::string text = operands.size() == 1 ? std::string("(") + symbol : "(";
  for (std::size_t i = 0; i < operands.size(); ++i) {
    text += (i > 0 ? symbol : "") + expr(*operands[i]);
  }
  return text + ")";
}

}  // namespace rtac::sema
