#include <string>
#include <string_view>

#include "compiler/syntax/dump_expr.h"
#include "compiler/syntax/printer.h"
#include "compiler/syntax/spelling.h"

namespace rtac::syntax {
namespace {

class Dumper {
 public:
  explicit Dumper(const SourceManager& sources) : sources_(sources), text_(sources) {}

  void add(const File& file) {
    text_.title("File " + sources_.path(file.id));
    Level level{text_};
    if (file.spec) line("Spec " + file.spec->text, file.spec->range);
    for (const Item& item : file.items) {
      std::visit([&](const auto& node) { add(node, item.range); }, item.node);
    }
  }

  std::string take() { return text_.take(); }

 private:
  using Level = TreeText::Level;
  void line(const std::string& text, const SourceRange& range) { text_.line(text, range); }
  void add(const Expr& expr) { dump_expr(expr, text_); }
  void part(const std::string& label, const ExprPtr& expr) { dump_part(label, expr, text_); }
  void part(const std::string& label, const Name& name) {
    line(label + ' ' + name.text, name.range);
  }
  void part(const std::string& label, const Text& text) {
    line(label + ' ' + spell_text(text.text), text.range);
  }
  void part(const std::string& label, const std::optional<Text>& text) {
    if (text) part(label, *text);
  }
  template <class T>
  void parts(const std::string& label, const std::vector<T>& list) {
    for (const T& element : list) part(label, element);
  }

  // ---- robots

  void add(const Bound& bound) {
    line("Bound " + bound.name.text + ' ' + std::string{spell(bound.relation)} +
             (bound.at ? " at " + bound.at->text : ""),
         bound.name.range);
    Level level{text_};
    add(*bound.value);
  }
  void add(const BodyClause& node, const SourceRange& range) {
    line("Body", range);
    Level level{text_};
    part("Radius", node.radius);
  }
  void add(const MotionClause& node, const SourceRange& range) {
    line("Motion " + node.model.text, range);
    Level level{text_};
    for (const Bound& bound : node.bounds) add(bound);
  }
  void add(const SenseClause& node, const SourceRange& range) {
    line("Sense " + node.name.text + " : " + node.type.text, range);
    Level level{text_};
    part("ErrorBound", node.error);
    part("MaxAge", node.max_age);
  }
  void add(const HearsClause& node, const SourceRange& range) {
    line("Hears", range);
    Level level{text_};
    part("MaxAge", node.max_age);
    if (node.present) line("Present", range);
  }
  void add(const InputClause& node, const SourceRange& range) {
    line("Input " + node.name.text + " : " + node.type.text, range);
    Level level{text_};
    part("Capacity", node.capacity);
    part("Tracking", node.tracking);
  }
  void add(const OutputClause& node, const SourceRange& range) {
    line("Output " + node.name.text + " : " + node.type.text, range);
    Level level{text_};
    part("Error", node.error);
  }
  void add(const LatencyClause& node, const SourceRange& range) {
    line("Latency", range);
    Level level{text_};
    add(*node.value);
  }
  void add(const EnergyClause& node, const SourceRange& range) {
    line("Energy", range);
    Level level{text_};
    for (const Bound& bound : node.bounds) add(bound);
  }

  // ---- items

  void add(const ImportItem& node, const SourceRange& range) {
    line("Import " + spell_text(node.path.text), range);
  }
  void add(const PeriodItem& node, const SourceRange& range) {
    line("Period", range);
    Level level{text_};
    add(*node.value);
  }
  void add(const TypeRef& type) {
    line("Type " + type.name.text + (type.unit ? " [" + type.unit->text + ']' : ""), type.range);
    Level level{text_};
    parts("Length", type.length);
    if (type.of) part("Of", *type.of);
    if (type.frame) part("Frame", *type.frame);
  }
  void add(const InputItem& node, const SourceRange& range) {
    line("Input " + join(node.names, ", "), range);
    Level level{text_};
    add(node.type);
    for (const Limits& limits : node.limits) {
      part("Least", limits.least);
      part("Most", limits.most);
    }
    parts("ErrorBound", node.error);
    if (node.max_age_inf) line("MaxAge inf", range);
    part("MaxAge", node.max_age);
    parts("Resolution", node.resolution);
  }
  void add(const ParamItem& node, const SourceRange& range) {
    line("Param " + node.name.text, range);
    Level level{text_};
    add(node.type);
    part("Least", node.least);
    part("Most", node.most);
    part("Value", node.value);
  }
  void add(const EnumItem& node, const SourceRange& range) {
    line("Enum " + node.name.text, range);
    Level level{text_};
    parts("Value", node.values);
  }
  void add(const FunItem& node, const SourceRange& range) {
    line("Fun " + node.name.text, range);
    Level level{text_};
    for (const FunItem::Parameter& parameter : node.parameters) {
      part("Parameter", parameter.name);
      Level inner{text_};
      add(parameter.type);
    }
    add(node.result);
    add(*node.body);
  }
  void add(const ScaleItem& node, const SourceRange& range) {
    line("Scale", range);
    Level level{text_};
    add(*node.value);
  }
  void add(const GridItem& node, const SourceRange& range) {
    line("Grid", range);
    Level level{text_};
    for (const ExprPtr& step : node.steps) add(*step);
  }
  void add(const FrameItem& node, const SourceRange& range) {
    line("Frame " + join(node.names, ", "), range);
  }
  void add(const OriginItem& node, const SourceRange& range) {
    line("Origin", range);
    Level level{text_};
    for (const ExprPtr& value : node.values) add(*value);
  }
  void add(const AssumeItem& node, const SourceRange& range) {
    line("Assume", range);
    Level level{text_};
    add(*node.condition);
    if (node.checked_by) part("CheckedBy", *node.checked_by);
    part("Unchecked", node.unchecked);
  }
  void add(const ClockItem& node, const SourceRange& range) {
    line("Clock " + node.name.text, range);
  }
  void add(const ZoneItem& node, const SourceRange& range) {
    line("Zone " + node.name.text + (node.frame ? " @ " + node.frame->text : ""), range);
    Level level{text_};
    add(*node.value);
    if (node.around) {
      line("Around " + node.around->name.text, node.around->range);
      Level inner{text_};
      part("Number", node.around->number);
    }
    for (const Opening& opening : node.during) {
      line("During " + join(opening.days, ", ") + (opening.days.empty() ? "" : " ") +
               opening.from.text + " .. " + opening.until.text,
           opening.range);
    }
  }
  void add(const RobotItem& node, const SourceRange& range) {
    line("Robot " + node.name.text, range);
    Level level{text_};
    for (const RobotClause& clause : node.clauses) {
      std::visit([&](const auto& part) { add(part, clause.range); }, clause.node);
    }
  }
  void add(const FleetItem& node, const SourceRange& range) {
    line("Fleet " + join(node.members, ", ") + " : " + node.kind.text, range);
    Level level{text_};
    part("Count", node.count);
  }
  void add(const AgentItem& node, const SourceRange& range) {
    line("Agent " + join(node.names, ", ") + (node.type ? " : " + node.type->text : "") +
             (node.present ? " present" : ""),
         range);
    Level level{text_};
    part("Count", node.count);
    part("Radius", node.radius);
    part("Speed", node.speed);
    part("ErrorBound", node.error);
    part("MaxAge", node.max_age);
  }
  void add(const SiteItem& node, const SourceRange& range) {
    line("Site " + node.name.text + (node.robot ? '(' + node.robot->name.text + ')' : ""), range);
    Level level{text_};
    if (node.robot) part("Number", node.robot->number);
    add(*node.position);
  }
  void add(const ControllerItem& node, const SourceRange& range) {
    line("Controller " + node.name.text + " : " + std::string{spell(node.role)} + " for " +
             node.kind.text,
         range);
    Level level{text_};
    std::visit([&](const auto& part) { add(part, node.implementation_range); },
               node.implementation);
  }
  void add(const ExternTemplate& node, const SourceRange& range) {
    line(node.zone ? "Extern keeps inside " + node.zone->text : "Extern", range);
    Level level{text_};
    part("Speed", node.speed);
  }
  void add(const RetreatTemplate& node, const SourceRange& range) {
    line("Retreat within " + node.zone.text, range);
    Level level{text_};
    part("Speed", node.speed);
  }
  void add(const RouteTemplate& node, const SourceRange& range) {
    line("Route to " + node.site.text + " within " + node.zone.text, range);
    Level level{text_};
    part("Speed", node.speed);
  }
  void add(const YieldTemplate& node, const SourceRange& range) {
    line("Yield within " + node.zone.text + " order " + node.order.text, range);
    Level level{text_};
    part("Speed", node.speed);
  }
  void add(const BrakeTemplate&, const SourceRange& range) { line("BrakeAndHold", range); }
  void add(const LoiterTemplate& node, const SourceRange& range) {
    line("Loiter within " + node.zone.text, range);
    Level level{text_};
    part("Speed", node.speed);
  }
  void add(const LandTemplate& node, const SourceRange& range) {
    line("Land", range);
    Level level{text_};
    part("To", node.height);
    part("Speed", node.speed);
  }
  void add(const SequenceTemplate& node, const SourceRange& range) {
    line("Sequence", range);
    Level level{text_};
    for (const SequenceStep& step : node.steps) {
      std::visit([&](const auto& what) { add(what, step.range); }, step.what);
      part("For", step.lasts);
    }
  }

  void add(const MonitorItem& node, const SourceRange& range) {
    const bool bound = node.variable && node.kind;
    line("Monitor " + node.name.text +
             (bound ? " for " + node.variable->text + " : " + node.kind->text : ""),
         range);
    Level level{text_};
    parts("Requirement", node.requirement);
    parts("Always", node.always);
    for (const AheadTerm& term : node.ahead) {
      std::visit([&](const auto& part) { add(part, term.range); }, term.node);
    }
    parts("Recover", node.recover);
    parts("ReturnWhen", node.return_when);
    for (const SourceRange& written : node.margin_full) line("MarginFull", written);
    parts("HoldWhenViolated", node.hold);
  }
  void add(const AheadDuration& node, const SourceRange& range) {
    line("AheadDuration", range);
    Level level{text_};
    add(*node.duration);
    part("Unsound", node.unsound);
  }
  void add(const AheadWaypoints& node, const SourceRange& range) {
    line("AheadWaypoints", range);
    Level level{text_};
    add(*node.count);
  }
  void add(const WaypointsOnly& node, const SourceRange& range) {
    line("WaypointsOnly", range);
    Level level{text_};
    part("Unsound", node.unsound);
  }
  void add(const PointsOnly& node, const SourceRange& range) {
    line("PointsOnly", range);
    Level level{text_};
    part("Unsound", node.unsound);
  }

  void add(const DecisionItem& node, const SourceRange& range) {
    line("Decision " + node.name.text + " for " + node.kind.text, range);
    Level level{text_};
    parts("Advanced", node.advanced);
    parts("Safe", node.safe);
    parts("On", node.on);
    parts("Period", node.period);
    parts("Jitter", node.jitter);
    for (const auto& ranking : node.priority) {
      line("Priority " + join(ranking, " > "), ranking.front().range);
    }
    for (const auto& order : node.coordinate) {
      line("Coordinate " + join(order, " > "), order.front().range);
    }
    for (const Acknowledge& entry : node.acknowledge) {
      line("Acknowledge " + entry.recovery.text + " may break " + entry.monitor.text + ' ' +
               spell_text(entry.reason.text),
           entry.range);
    }
  }

  const SourceManager& sources_;
  TreeText text_;
};

}  // namespace

std::string dump(const Program& program, const SourceManager& sources) {
  Dumper dumper{sources};
  for (const File& file : program.files) dumper.add(file);
  return dumper.take();
}

}  // namespace rtac::syntax
