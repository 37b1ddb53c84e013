#include "compiler/syntax/printer.h"

#include <string_view>

#include "compiler/syntax/print_expr.h"
#include "compiler/syntax/spelling.h"

namespace rtac::syntax {
namespace {

std::string optional_part(std::string_view word, const ExprPtr& expr) {
  return expr ? ' ' + std::string{word} + ' ' + print_expr(*expr) : std::string{};
}

std::string print_unsound(const std::optional<Text>& reason) {
  return reason ? " unsound " + spell_text(reason->text) : std::string{};
}

std::string print_bounds(const std::vector<Bound>& bounds) {
  std::string result = "{";
  for (const Bound& bound : bounds) {
    result += ' ' + bound.name.text + ' ' + std::string{spell(bound.relation)} + ' ' +
              print_expr(*bound.value) + (bound.at ? " at " + bound.at->text : "") + ';';
  }
  return result + " }";
}

// ---- robots

std::string print_node(const BodyClause& node) {
  return "body radius " + print_expr(*node.radius) + ';';
}
std::string print_node(const MotionClause& node) {
  return "motion " + node.model.text + ' ' + print_bounds(node.bounds);
}
std::string print_node(const SenseClause& node) {
  return "sense " + node.name.text + " : " + node.type.text + optional_part("error", node.error) +
         optional_part("max_age", node.max_age) + ';';
}
std::string print_node(const HearsClause& node) {
  return "hears other robots" + optional_part("max_age", node.max_age) +
         (node.present ? ", present;" : ";");
}
std::string print_node(const InputClause& node) {
  return "input " + node.name.text + " : " + node.type.text +
         (node.capacity ? '[' + print_expr(*node.capacity) + ']' : "") +
         optional_part("tracking <=", node.tracking) + ';';
}
std::string print_node(const OutputClause& node) {
  return "output " + node.name.text + " : " + node.type.text + optional_part("error", node.error) +
         ';';
}
std::string print_node(const LatencyClause& node) {
  return "latency " + print_expr(*node.value) + ';';
}
std::string print_node(const EnergyClause& node) {
  return "energy " + print_bounds(node.bounds);
}

// ---- controllers

std::string print_node(const ExternTemplate& node) {
  if (!node.zone) return "extern";
  return "extern keeps inside " + node.zone->text + optional_part("speed <=", node.speed);
}
std::string print_node(const RetreatTemplate& node) {
  return "= retreat within " + node.zone.text + optional_part("speed", node.speed);
}
std::string print_node(const RouteTemplate& node) {
  return "= route to " + node.site.text + " within " + node.zone.text +
         optional_part("speed", node.speed);
}
std::string print_node(const YieldTemplate& node) {
  return "= yield within " + node.zone.text + optional_part("speed", node.speed) + " order " +
         node.order.text;
}
std::string print_node(const BrakeTemplate&) {
  return "= brake_and_hold";
}
std::string print_node(const LoiterTemplate& node) {
  return "= loiter within " + node.zone.text + optional_part("speed", node.speed);
}
std::string print_node(const LandTemplate& node) {
  return "= land" + optional_part("to", node.height) + optional_part("speed", node.speed);
}
std::string print_node(const SequenceTemplate& node) {
  std::string text = "= sequence";
  for (const SequenceStep& step : node.steps) {
    constexpr std::size_t sign = 1;  // without the `=` that each has by itself
    text += std::visit([](const auto& what) { return print_node(what).substr(sign); }, step.what);
    if (step.lasts) text += " for " + print_expr(*step.lasts) + " then";
  }
  return text;
}

// ---- monitors

std::string print_node(const AheadDuration& node) {
  return print_expr(*node.duration) + print_unsound(node.unsound);
}
std::string print_node(const AheadWaypoints& node) {
  const auto* number = std::get_if<NumberLit>(&node.count->node);
  const bool is_one = number && !number->unit && number->value == 1;
  return print_expr(*node.count) + (is_one ? " waypoint" : " waypoints");
}
std::string print_node(const WaypointsOnly& node) {
  return "waypoints only" + print_unsound(node.unsound);
}
std::string print_node(const PointsOnly& node) {
  return "points only" + print_unsound(node.unsound);
}

// ---- items

std::string print_node(const ImportItem& node) {
  return "import " + spell_text(node.path.text) + ";\n";
}
std::string print_node(const PeriodItem& node) {
  return "period " + print_expr(*node.value) + ";\n";
}
std::string print_frame(const std::optional<Name>& frame) {
  return frame ? " @ " + frame->text : std::string{};
}
std::string print_type(const TypeRef& type) {
  std::string lengths;
  for (const ExprPtr& length : type.length) lengths += '[' + print_expr(*length) + ']';
  return type.name.text + (type.unit ? " [" + type.unit->text + ']' : "") + lengths +
         (type.of ? " of " + type.of->text : "") + print_frame(type.frame);
}
std::string print_limits(const ExprPtr& least, const ExprPtr& most) {
  return least && most ? print_expr(*least) + " .. " + print_expr(*most) : std::string{};
}
std::string print_list(std::string_view word, const std::vector<ExprPtr>& exprs) {
  std::string result;
  for (const ExprPtr& expr : exprs) result += (result.empty() ? "" : ", ") + print_expr(*expr);
  return result.empty() ? result : ' ' + std::string{word} + ' ' + result;
}
std::string print_node(const InputItem& node) {
  std::string limits;
  for (const Limits& each : node.limits) {
    limits += (limits.empty() ? " in " : ", ") + print_limits(each.least, each.most);
  }
  return "input " + join(node.names, ", ") + " : " + print_type(node.type) + limits +
         print_list("error", node.error) +
         (node.max_age_inf ? " max_age inf" : optional_part("max_age", node.max_age)) +
         print_list("resolution", node.resolution) + ";\n";
}
std::string print_node(const ParamItem& node) {
  return "param " + node.name.text + " : " + print_type(node.type) +
         (node.least && node.most ? " in " + print_limits(node.least, node.most) : "") +
         optional_part("=", node.value) + ";\n";
}
std::string print_node(const EnumItem& node) {
  return "enum " + node.name.text + " { " + join(node.values, ", ") + " }\n";
}
std::string print_node(const FunItem& node) {
  std::string parameters;
  for (const FunItem::Parameter& parameter : node.parameters) {
    if (!parameters.empty()) parameters += ", ";
    parameters += parameter.name.text + " : " + print_type(parameter.type);
  }
  return "fun " + node.name.text + '(' + parameters + ") : " + print_type(node.result) +
         optional_part("=", node.body) + ";\n";
}
std::string print_node(const ScaleItem& node) {
  return "scale " + print_expr(*node.value) + ";\n";
}
std::string print_node(const GridItem& node) {
  return print_list("grid", node.steps).substr(1) + ";\n";
}
std::string print_node(const FrameItem& node) {
  return "frame " + join(node.names, ", ") + ";\n";
}
std::string print_node(const OriginItem& node) {
  return print_list("origin", node.values).substr(1) + ";\n";
}
std::string print_node(const AssumeItem& node) {
  return "assume " + print_expr(*node.condition) +
         (node.checked_by ? " checked by " + node.checked_by->text : "") +
         (node.unchecked ? " unchecked " + spell_text(node.unchecked->text) : "") + ";\n";
}
std::string print_node(const ClockItem& node) {
  return "clock " + node.name.text + ";\n";
}
std::string print_robot(const RobotRef& robot) {
  return robot.name.text + (robot.number ? '[' + print_expr(*robot.number) + ']' : "");
}
std::string print_node(const ZoneItem& node) {
  std::string during;
  for (const Opening& opening : node.during) {
    during += (during.empty() ? " during " : " or ") + join(opening.days, ", ");
    if (!opening.days.empty()) during += ' ';
    during += opening.from.text + " .. " + opening.until.text;
  }
  return "zone " + node.name.text + print_frame(node.frame) + " = " + print_expr(*node.value) +
         (node.around ? " around " + print_robot(*node.around) : "") + during + ";\n";
}
std::string print_node(const RobotItem& node) {
  std::string result = "robot " + node.name.text + " {\n";
  for (const RobotClause& clause : node.clauses) {
    result += "  ";
    result += std::visit([](const auto& part) { return print_node(part); }, clause.node);
    result += '\n';
  }
  return result + "}\n";
}
std::string print_node(const FleetItem& node) {
  return "fleet " + join(node.members, ", ") + " : " + node.kind.text +
         (node.count ? '[' + print_expr(*node.count) + ']' : "") + ";\n";
}
std::string print_node(const AgentItem& node) {
  return "agent " + join(node.names, ", ") +
         (node.count ? '[' + print_expr(*node.count) + ']' : "") + " : " +
         (node.type ? node.type->text + ", " : "") + "radius " + print_expr(*node.radius) +
         ", speed" + optional_part("<=", node.speed) + optional_part("error", node.error) +
         optional_part("max_age", node.max_age) + (node.present ? ", present" : "") + ";\n";
}
std::string print_node(const SiteItem& node) {
  return "site " + node.name.text + (node.robot ? '(' + print_robot(*node.robot) + ')' : "") +
         " = " + print_expr(*node.position) + ";\n";
}
std::string print_node(const ControllerItem& node) {
  return "controller " + node.name.text + " : " + std::string{spell(node.role)} + " for " +
         node.kind.text + ' ' +
         std::visit([](const auto& part) { return print_node(part); }, node.implementation) + ";\n";
}
std::string print_node(const MonitorItem& node) {
  std::string result = "monitor " + node.name.text;
  if (node.variable && node.kind) {
    result += " for " + node.variable->text + " : " + node.kind->text;
  }
  result += " {\n";
  for (const Text& text : node.requirement) result += "  " + spell_text(text.text) + '\n';
  for (const ExprPtr& expr : node.always) result += "  always " + print_expr(*expr) + ";\n";
  std::string ahead;
  for (const AheadTerm& term : node.ahead) {
    if (!ahead.empty()) ahead += ", ";
    ahead += std::visit([](const auto& part) { return print_node(part); }, term.node);
  }
  if (!ahead.empty()) result += "  ahead " + ahead + ";\n";
  for (const Name& name : node.recover) result += "  recover " + name.text + ";\n";
  for (const ExprPtr& expr : node.return_when) {
    result += "  return when " + print_expr(*expr) + ";\n";
  }
  for (std::size_t i = 0; i < node.margin_full.size(); ++i) result += "  margin full;\n";
  for (const Text& reason : node.hold) {
    result += "  hold when violated " + spell_text(reason.text) + ";\n";
  }
  return result + "}\n";
}
std::string print_node(const DecisionItem& node) {
  std::string result = "decision " + node.name.text + " for " + node.kind.text + " {\n";
  for (const Name& name : node.advanced) result += "  advanced " + name.text + ";\n";
  for (const Name& name : node.safe) result += "  safe " + name.text + ";\n";
  for (const Name& name : node.on) result += "  on " + name.text + ";\n";
  for (const ExprPtr& expr : node.period) result += "  period " + print_expr(*expr) + ";\n";
  for (const ExprPtr& expr : node.jitter) result += "  jitter " + print_expr(*expr) + ";\n";
  for (const auto& ranking : node.priority) result += "  priority " + join(ranking, " > ") + ";\n";
  for (const auto& order : node.coordinate) result += "  coordinate " + join(order, " > ") + ";\n";
  for (const Acknowledge& entry : node.acknowledge) {
    result += "  acknowledge " + entry.recovery.text + " may break " + entry.monitor.text + ' ' +
              spell_text(entry.reason.text) + ";\n";
  }
  return result + "}\n";
}

}  // namespace

std::string print(const File& file) {
  std::string result;
  if (file.spec) result += "spec " + file.spec->text + ";\n";
  for (const Item& item : file.items) {
    if (!result.empty()) result += '\n';
    result += std::visit([](const auto& node) { return print_node(node); }, item.node);
  }
  return result;
}

}  // namespace rtac::syntax
