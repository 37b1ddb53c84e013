#include "compiler/sema/spec_printer.h"

#include "compiler/sema/dimension.h"
#include "compiler/sema/expr_printer.h"
#include "compiler/sema/openings.h"
#include "compiler/support/overloaded.h"

namespace rtac::sema {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

class SpecPrinter {
 public:
  explicit SpecPrinter(const Spec& spec) : spec_(spec), exprs_(spec) {}

  std::string print() {
    line(0, "spec " + spec_.name);
    if (spec_.utc_clock) line(0, "clock utc");
    for (std::size_t i = 1; i < spec_.frames.size(); ++i) line(0, "frame " + spec_.frames[i].name);
    if (spec_.origin) print(*spec_.origin);
    for (const Zone& zone : spec_.zones) {
      if (!zone.name.empty() && !std::holds_alternative<ZoneReceived>(zone.value->node))
        line(0, "zone " + zone.name + frame_of(zone) + " = " + exprs_.zone(*zone.value) +
                    openings_of(zone));
    }
    for (const RobotKind& kind : spec_.kinds) print(kind);
    for (const Robot& robot : spec_.robots) {
      line(0, "robot " + robot.name + " : " + spec_[robot.kind].name);
    }
    for (const Agent& agent : spec_.agents) print(agent);
    for (const Site& site : spec_.sites) print(site);
    for (const Controller& controller : spec_.controllers) print(controller);
    for (const Monitor& monitor : spec_.monitors) print(monitor);
    for (const Decision& decision : spec_.decisions) print(decision);
    if (spec_.period) line(0, "period " + si_text(*spec_.period, dims::time));
    for (const Enumeration& enumeration : spec_.enumerations) print(enumeration);
    for (const Input& input : spec_.inputs) print(input);
    for (const Param& param : spec_.params) print(param);
    for (const MarginScale& scale : spec_.scales) {
      line(0, "scale " + si_text(scale.value, scale.dimension));
    }
    for (const GridStep& grid : spec_.grids) {
      line(0, "grid " + si_text(grid.value, grid.dimension));
    }
    for (const Assumption& assumption : spec_.assumptions) print(assumption);
    for (const Watch& watch : spec_.watches) print(watch);
    return std::move(text_);
  }

 private:
  [[nodiscard]] std::string frame_of(const Zone& zone) const {
    return zone.frame == map_frame ? "" : " @ " + spec_[zone.frame].name;
  }

  static std::string openings_of(const Zone& zone) {
    std::string text;
    for (const Opening& opening : zone.openings) {
      text += (text.empty() ? " during " : " or ") + text_of(opening);
    }
    return text;
  }

  void line(int depth, const std::string& text) {
    text_.append(static_cast<std::size_t>(2 * depth), ' ');
    text_ += text + "\n";
  }

  void print(const Origin& origin) {
    line(0, "origin " + si_text(origin.latitude, dims::angle) + ", " +
                si_text(origin.longitude, dims::angle) +
                (origin.altitude ? ", " + si_text(*origin.altitude, dims::length) : ""));
  }

  void print(const RobotKind& kind) {
    line(0, "kind " + kind.name);
    line(1, "radius " + si_text(kind.radius, dims::length));
    print(kind.motion);
    print("position", kind.position, dims::length);
    print("heading", kind.heading, dims::angle);
    print("velocity", kind.velocity, dims::speed);
    print("battery", kind.battery, dims::ratio);
    if (kind.hears_max_age) {
      line(1, "hears max_age " + si_text(*kind.hears_max_age, dims::time) +
                  (kind.open_fleet ? ", present" : ""));
    }
    if (kind.plan) {
      line(1, "plan capacity " + std::to_string(kind.plan->capacity) + " tracking " +
                  si_text(kind.plan->tracking, dims::length));
    }
    line(1, "output " + kind.output_name + " : " +
                (kind.output == OutputType::twist ? "twist" : "acceleration") +
                (kind.output_error ? " error " + si_text(*kind.output_error, dims::acceleration)
                                   : ""));
    line(1, "latency " + si_text(kind.latency, dims::time));
    if (kind.energy) print(*kind.energy);
  }

  void print(const Agent& agent) {
    line(0, "agent " + agent.name + (agent.in_space ? " point3" : "") + " radius " +
                si_text(agent.radius, dims::length) + " speed " +
                si_text(agent.speed, dims::speed) + (agent.present ? ", present" : ""));
    print("position", agent.position, dims::length);
  }

  void print(const Motion& motion) {
    std::string text = motion.model == MotionModel::point ? "motion point" : "motion unicycle";
    text += " speed " + si_text(motion.speed, dims::speed);
    text += " accel " + si_text(motion.accel, dims::acceleration);
    text += " brake " + si_text(motion.brake, dims::acceleration);
    if (motion.turn) text += " turn " + si_text(*motion.turn, dims::turn_rate);
    if (motion.turn_accel)
      text += " turn_accel " + si_text(*motion.turn_accel, dims::turn_acceleration);
    if (motion.disturbance)
      text += " disturbance " + si_text(*motion.disturbance, dims::acceleration);
    line(1, text);
  }

  void print(const char* name, const std::optional<Sense>& sense, const Dimension& dimension) {
    if (!sense) return;
    line(1, std::string("sense ") + name + " error " + si_text(sense->error, dimension) +
                " max_age " + si_text(sense->max_age, dims::time));
  }

  void print(const Energy& energy) {
    line(1, "energy drive " + si_text(energy.drive, dims::ratio_per_length) + " idle " +
                si_text(energy.idle, dims::ratio_per_time) + " drain " +
                si_text(energy.drain, dims::ratio_per_time) + " charge " +
                si_text(energy.charge, dims::ratio_per_time) + " at " +
                spec_[energy.charge_at].name + " held " + si_text(energy.held, dims::time) +
                " detour " + si_text(energy.detour, dims::length));
  }

  void print(const Site& site) {
    for (const Site::Place& place : site.places) {
      line(0, "site " + site.name + (place.robot ? "(" + spec_[*place.robot].name + ")" : "") +
                  " = " + point_text(place.position));
    }
  }

  void print(const Controller& controller) {
    const auto within = [&](ZoneId zone, const Quantity& speed) {
      return " within " + exprs_.zone(zone) + " speed " + si_text(speed, dims::speed);
    };
    const auto text = Overloaded{
        [&](const ExternController& node) {
          return std::string("extern") +
                 (node.claim ? " keeps" + within(node.claim->zone, node.claim->speed) : "");
        },
        [&](const Retreat& retreat) { return "retreat" + within(retreat.zone, retreat.speed); },
        [&](const Route& route) {
          return "route to " + spec_[route.site].name + within(route.zone, route.speed);
        },
        [&](const Yield& yield) { return "yield" + within(yield.zone, yield.speed) + " order id"; },
        [](const BrakeAndHold&) { return std::string("brake_and_hold"); },
        [&](const Land& land) {
          return "land to " + show(land.height.value, dims::length) + " speed " +
                 show(land.speed.value, dims::speed);
        },
        [&](const Loiter& loiter) { return "loiter" + within(loiter.zone, loiter.speed); },
    };
    const auto sequence = [&](const Sequence& all) {
      std::string steps = "sequence";
      for (const Sequence::Step& step : all.steps) {
        steps += " " + std::visit(text, step.what);
        if (step.lasts) steps += " for " + si_text(*step.lasts, dims::time) + " then";
      }
      return steps;
    };
    const std::string implementation = std::visit(
        [&](const auto& node) {
          if constexpr (std::is_same_v<std::decay_t<decltype(node)>, Sequence>) {
            return sequence(node);
          } else {
            return text(node);
          }
        },
        controller.implementation);
    line(0, "controller " + controller.name + " : " + (controller.advanced ? "advanced" : "safe") +
                " for " + spec_[controller.kind].name + " = " + implementation);
  }

  void print(const Monitor& monitor) {
    line(0, "monitor " + monitor.name + " for " + spec_[monitor.kind].name);
    line(1,
         "requirement " + quoted(monitor.requirement_id) + " " + quoted(monitor.requirement_text));
    line(1, "always " + exprs_.expr(*monitor.always));
    print(monitor.ahead);
    if (monitor.recover) line(1, "recover " + spec_[*monitor.recover].name);
    if (monitor.return_when) line(1, "return when " + exprs_.expr(*monitor.return_when));
    if (monitor.hold_reason) line(1, "hold when violated " + quoted(*monitor.hold_reason));
  }

  void print(const Ahead& ahead) {
    std::string text = "ahead ";
    if (ahead.waypoints_only) {
      text += "no duration";
    } else {
      text += ahead.duration ? si_text(*ahead.duration, dims::time) : "derived duration";
    }
    if (ahead.duration_unsound) text += " unsound " + quoted(*ahead.duration_unsound);
    if (ahead.waypoints > 0) text += ", " + std::to_string(ahead.waypoints) + " waypoints";
    if (ahead.points_only) text += ", no legs";
    if (!ahead.unsound_reason.empty()) text += ", unsound " + quoted(ahead.unsound_reason);
    line(1, text);
  }

  void print(const Decision& decision) {
    line(0, "decision " + decision.name + " for " + spec_[decision.kind].name);
    line(1, "advanced " + spec_[decision.advanced].name);
    if (decision.safe) line(1, "safe " + spec_[*decision.safe].name);
    line(1, decision.period ? "period " + si_text(*decision.period, dims::time) : "on plan");
    std::string order;
    for (const MonitorId monitor : decision.priority) {
      order += (order.empty() ? "" : " > ") + spec_[monitor].name;
    }
    line(1, (decision.coordinated ? "coordinate " : "priority ") + order);
    for (const Acknowledgement& each : decision.acknowledgements) {
      line(1, "acknowledge " + spec_[each.recovery].name + " may break " +
                  spec_[each.monitor].name + " " + quoted(each.reason));
    }
  }

  void print(const Enumeration& enumeration) {
    std::string values;
    for (const std::string& value : enumeration.values) {
      values += (values.empty() ? "" : ", ") + value;
    }
    line(0, "enum " + enumeration.name + " { " + values + " }");
  }

  void print(const Input& input) {
    line(0, "input " + input.name + " : " + type_of(input));
    if (input.components != std::vector<std::string>{""}) {
      std::string components;
      for (const std::string& component : input.components) components += " " + component;
      line(1, "components" + components);
    }
    const bool number = input.type == InputType::real || input.type == InputType::integer;
    if (number) print_measurement("", input);
    if (input.turning) print_measurement(input.components.back() + " ", *input.turning);
    if (input.held) line(1, "max_age inf");
    if (input.max_age) line(1, "max_age " + si_text(*input.max_age, dims::time));
  }

  void print_measurement(const std::string& part, const Measurement& from) {
    if (from.least && from.most) line(1, part + "in " + range(*from.least, *from.most, from));
    line(1, part + "resolution " + si_text(from.resolution, from.dimension));
    if (from.error) line(1, part + "error " + si_text(*from.error, from.dimension));
  }

  std::string type_of(const Input& input) const {
    switch (input.type) {
      case InputType::boolean:
        return "bool";
      case InputType::integer:
        return "int";
      case InputType::enumeration:
        return spec_[*input.enumeration].name;
      case InputType::zone:
        return "zone[" + std::to_string(input.edges_most) + "]";
      case InputType::path:
        return "path[" + std::to_string(input.places_most) + "]";
      case InputType::real:
        break;
    }
    const std::string unit = unit_of(input.dimension);
    return unit.empty() ? "real" : "real [" + unit + "]";
  }

  template <class Signal>
  static std::string range(const Quantity& least, const Quantity& most, const Signal& signal) {
    return si_text(least, signal.dimension) + " .. " + si_text(most, signal.dimension);
  }

  void print(const Param& param) {
    const char* direction = param.tightens > 0 ? "up" : (param.tightens < 0 ? "down" : "not");
    line(0, "param " + param.name + " in " + range(param.least, param.most, param) + " = " +
                si_text(param.value, param.dimension) + " resolution " +
                si_text(param.resolution, param.dimension) + " moves " + direction);
  }

  void print(const Assumption& assumption) {
    line(0, "assume " + assumption.text +
                (assumption.checked_by.empty() ? " unchecked " + quoted(assumption.reason)
                                               : " checked by " + assumption.checked_by));
  }

  void print(const Watch& watch) {
    line(0, "monitor " + watch.name);
    line(1, "requirement " + quoted(watch.requirement_id) + " " + quoted(watch.requirement_text));
    line(1, "always " + exprs_.expr(*watch.always));
    if (watch.margin_full) line(1, "margin full");
  }

  const Spec& spec_;
  ExprPrinter exprs_;
  std::string text_;
};

}  // namespace

std::string dump(const Spec& spec) {
  return SpecPrinter(spec).print();
}

std::string dump(const Spec& spec, const Expr& expr) {
  return ExprPrinter(spec).expr(expr);
}

std::string dump(const Spec& spec, const ZoneExpr& expr) {
  return ExprPrinter(spec).zone(expr);
}

}  // namespace rtac::sema
