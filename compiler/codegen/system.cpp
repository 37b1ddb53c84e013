#include "compiler/codegen/system.h"

#include <algorithm>
#include <iterator>

#include "compiler/codegen/code.h"
#include "compiler/codegen/names.h"
#include "compiler/codegen/watch.h"

namespace rtac::codegen {
namespace {

using namespace ir;

std::string real_metres(std::int64_t mm) {
  return real(Rational(static_cast<long>(mm), 1000));
}

// One kind of robot with its decisions.
struct Kind {
  const sema::RobotKind* spec = nullptr;
  const Decision* periodic = nullptr;
  const Decision* on_plan = nullptr;
  std::vector<const sema::Robot*> robots;
};

// A run of robots with one slot: an array for a numbered fleet.
struct Slot {
  std::string name;
  std::size_t first = 0, count = 1;
  bool numbered = false;
};
std::vector<Slot> slots_of(const std::vector<const sema::Robot*>& robots, const Names& names) {
  std::vector<Slot> slots;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const bool numbered = robots[i]->number.has_value();
    if (numbered && *robots[i]->number > 0) {
      ++slots.back().count;
    } else {
      slots.push_back({names(numbered ? robots[i]->fleet : robots[i]->name), i, 1, numbered});
    }
  }
  return slots;
}

class SystemPrinter {
 public:
  SystemPrinter(const Module& module, const Names& names, const Kind& kind, bool only, Code& out)
      : module_(module),
        names_(names),
        kind_(kind),
        kind_name_(names(kind.spec->name)),
        name_(only ? "System" : kind_name_ + "System"),
        output_(kind.spec->output == sema::OutputType::twist ? "rtac::Twist"
                                                             : "rtac::Acceleration"),
        robot_slots_(slots_of(kind.robots, names)),
        out_(out) {
    for (const Monitor& m : d().monitors) {
      const auto same = [&](const Recovery* r) { return r->name == m.recovery.name; };
      if (std::none_of(recoveries_.begin(), recoveries_.end(), same)) {
        recoveries_.push_back(&m.recovery);
      }
    }
  }

  void print() {
    slots();
    out_.comment("The fleet of " + kind_.spec->name +
                 ": task planner, and per robot motion "
                 "planner, plan executor, decision modules and recoveries, wired. Fill the slots, "
                 "give the robots' SDK, and run.");
    out_.block(
        "class " + name_,
        [&](Code& body) {
          body.line("public:");
          interface(body);
          body.blank().line("private:");
          members(body);
        },
        "};");
    out_.blank();
  }

 private:
  const Decision& d() const { return *kind_.periodic; }

  // Slot types in the order of the constructor. A controller may plan and drive: it fills a slot
  // for each.
  std::vector<std::pair<std::string, std::string>> slot_list() const {
    std::vector<std::pair<std::string, std::string>> slots;
    slots.push_back({"rtac::Controller<" + output_ + ">&", names_(d().advanced)});
    for (const Recovery* r : external_recoveries()) {
      slots.push_back({safe_controller() + "&", names_(r->name)});
    }
    slots.push_back({"rtac::Planner&", advanced_planner()});
    if (kind_.on_plan) slots.push_back({"rtac::Planner&", planner_slot(kind_.on_plan->safe)});
    return slots;
  }
  std::vector<const Recovery*> external_recoveries() const {
    std::vector<const Recovery*> external;
    std::copy_if(recoveries_.begin(), recoveries_.end(), std::back_inserter(external),
                 [](const Recovery* r) { return r->kind == RecoveryKind::external; });
    return external;
  }
  std::string safe_controller() const { return "rtac::SafeController<" + output_ + ">"; }
  std::string advanced_planner() const {
    return kind_.on_plan ? planner_slot(kind_.on_plan->advanced) : "planner";
  }
  std::string planner_slot(const std::string& name) const {
    const bool drives = name == d().advanced ||
                        std::any_of(recoveries_.begin(), recoveries_.end(), [&](const Recovery* r) {
                          return r->kind == RecoveryKind::external && r->name == name;
                        });
    return names_(name) + (drives ? "_as_planner" : "");
  }

  void slots() {
    out_.comment("External controllers of one " + kind_.spec->name +
                 ". A slot that is left empty does not compile.");
    out_.block(
        "struct " + kind_name_ + "Controllers",
        [&](Code& body) {
          for (const auto& [type, name] : slot_list()) body.line(type + " " + name + ";");
        },
        "};");
    out_.blank();
  }

  void interface(Code& body) {
    const std::size_t count = kind_.robots.size();
    body.block(
        "struct Controllers",
        [&](Code& c) {
          for (const Slot& slot : robot_slots_) {
            c.line(kind_name_ + "Controllers " + slot.name +
                   (slot.numbered ? "[" + std::to_string(slot.count) + "];" : ";"));
          }
          c.line("rtac::TaskSource& tasks;");
        },
        "};");
    body.line("static constexpr int robots = " + std::to_string(count) + ";").blank();
    body.comment(
        "Clearances of the centre: where control can be given back, where a robot at "
        "full speed never fails a fence; and the distance at which robots pass.");
    std::int64_t return_mm = 0;
    for (const Monitor& m : d().monitors) {
      return_mm = std::max(return_mm, m.recovery.return_clearance_mm);
    }
    body.line("static constexpr double return_clearance_m = " + real_metres(return_mm) + ";");
    body.line("static constexpr double cruise_clearance_m = " +
              real_metres(d().cruise_clearance_mm) + ";");
    body.line("static constexpr double pass_gap_m = " +
              real_metres(d().monitors[0].recovery.pass_gap_mm) + ";")
        .blank();
    body.block("static const char* robot_name(int robot)", [&](Code& f) {
      std::string names;
      for (const sema::Robot* robot : kind_.robots) {
        names += (names.empty() ? "" : ", ") + quoted(robot->name);
      }
      f.line("static const char* const names[] = {" + names + "};");
      f.line("return names[robot];");
    });
    body.comment("The number of the robot of this name; -1: there is none.");
    body.block("static int robot_number(const char* name)", [](Code& f) {
      f.block("for (int robot = 0; robot < robots; ++robot)", [](Code& each) {
        each.line("if (std::strcmp(robot_name(robot), name) == 0) return robot;");
      });
      f.line("return -1;");
    });
    for (const SiteTable& s : module_.sites) {
      if (s.places.size() != count || s.places[0].robot != kind_.robots[0]->name) continue;
      body.block("static rtac::Vec2 " + names_(s.name) + "(int robot)", [&](Code& f) {
        std::string places;
        for (const auto& p : s.places) {
          places += (places.empty() ? "{" : ", {") + real_metres(p.x_mm) + ", " +
                    real_metres(p.y_mm) + "}";
        }
        f.line("static const rtac::Vec2 places[] = {" + places + "};");
        f.line("return places[robot];");
      });
    }
    body.block("static rtac::SystemOptions default_options()", [&](Code& f) {
      f.line("rtac::SystemOptions options;");
      f.line("options.pass_gap_m = pass_gap_m;");
      f.line("return options;");
    });
    body.blank();
    robot(body);
    body.blank();
    constructor(body);
    body.blank();
    body.comment("Until the clock of the fleet reads `until_us`, or the SDK says stop.");
    body.block("[[nodiscard]] rtac::Status run(rtac::FleetSdk<" + output_ +
                   ">& fleet, rtac::TimeUs until_us)",
               [&](Code& f) { f.line("return system_.run(fleet, until_us);"); });
    decisions(body);
  }

  // Where the application gives a robot its plain inputs and parameters.
  void decisions(Code& body) {
    if (!has_signals(d())) return;
    body.blank().comment(
        "The decision of a robot, for its plain inputs and parameters: give them when its SDK "
        "senses (rtac::RobotSdk::sense).");
    const std::string type = camel(names_(d().name));
    body.block(type + "& decision_of(int robot)", [&](Code& f) {
      f.line("return *static_cast<" + type +
             "*>(parts_[static_cast<std::size_t>(robot)].decision);");
    });
  }

  void constructor(Code& body) {
    body.line("explicit " + name_ + "(const Controllers& controllers,");
    const std::string pad(name_.size() + 10, ' ');
    body.line(pad + "const rtac::SystemOptions& options = default_options(),");
    body.line(pad + "rtac::SystemObserver* observer = nullptr)");
    std::string robots, parts;
    for (const Slot& slot : robot_slots_) {
      robots += (robots.empty() ? "" : ", ") + slot.name + "_" + started(slot);
      for (std::size_t k = 0; k < slot.count; ++k) {
        const std::string at = slot.numbered ? "[" + std::to_string(k) + "]" : "";
        parts += (parts.empty() ? "" : ", ") +
                 ("parts(" + quoted(kind_.robots[slot.first + k]->name)) + ", " + slot.name + "_" +
                 at + ", controllers." + slot.name + at + ")";
      }
    }
    body.line("    : " + robots + ",");
    body.line("      parts_{{" + parts + "}},");
    body.line("      system_(controllers.tasks, parts_.data(), robots, options, observer) {}");
    body.line(name_ + "(const " + name_ + "&) = delete;");
    body.line(name_ + "& operator=(const " + name_ + "&) = delete;");
  }

  // What starts the robots of a slot.
  std::string started(const Slot& slot) const {
    const auto arguments = [&](std::size_t k) {
      const std::string at = slot.numbered ? "[" + std::to_string(k) + "]" : "";
      std::string text = "(" + std::to_string(slot.first + k);
      for (const Recovery* r : external_recoveries()) {
        text += ", controllers." + slot.name + at + "." + names_(r->name);
      }
      return text + ")";
    };
    if (!slot.numbered) return arguments(0);
    std::string all;
    for (std::size_t k = 0; k < slot.count; ++k) {
      all += (k > 0 ? ", Robot" : "{Robot") + arguments(k);
    }
    return all + "}";
  }

  // The module of a decision; a member must not have the name of its type.
  std::string member_of(const Decision& decision) const {
    const std::string id = names_(decision.name);
    return camel(id) == id ? id + "_module" : id;
  }
  // One robot, for the system and for programs that run it alone.
  void robot(Code& body) {
    body.comment(
        "One robot by its number: its decision modules and its recoveries, each once and under the "
        "name that it has in the specification. A program that runs this robot alone, as a node of "
        "its own, makes one of these and no " +
        name_ + ".");
    body.block(
        "struct Robot",
        [&](Code& r) {
          robot_constructor(r);
          r.line(camel(names_(d().name)) + " " + member_of(d()) + ";");
          if (kind_.on_plan) {
            r.line(camel(names_(kind_.on_plan->name)) + " " + member_of(*kind_.on_plan) + ";");
          }
          for (const Recovery* recovery : recoveries_) {
            r.line(type_of(*recovery) + " " + names_(recovery->name) + ";");
          }
          recovery_of_mode(r);
        },
        "};");
  }
  void robot_constructor(Code& r) {
    std::string inits, takes;
    std::vector<std::string> attached;
    const auto init = [&](const std::string& member, const std::string& arguments) {
      inits += (inits.empty() ? "" : ", ") + member + "(" + arguments + ")";
    };
    init(member_of(d()), "self");
    if (kind_.on_plan) init(member_of(*kind_.on_plan), "self");
    for (const Recovery* recovery : recoveries_) {
      init(names_(recovery->name), arguments_of(*recovery));
    }
    for (const Recovery* recovery : external_recoveries()) {
      const std::string id = names_(recovery->name);
      takes += ", " + safe_controller() + "& external_" + id;
      attached.push_back(id + ".attach(external_" + id + ");");
    }
    r.line("explicit Robot(int self" + takes + ")");
    r.line("    : " + inits + (attached.empty() ? " {}" : " {"));
    for (const std::string& each : attached) r.line("  " + each);
    if (!attached.empty()) r.line("}");
  }
  void recovery_of_mode(Code& r) {
    const auto name_of = [&](const Monitor& m) { return names_(m.recovery.name); };
    const std::vector<Monitor>& monitors = d().monitors;
    const std::string first = name_of(monitors[0]);
    const bool differ = std::any_of(monitors.begin(), monitors.end(),
                                    [&](const Monitor& m) { return name_of(m) != first; });
    r.comment("The one that drives in a mode of the record, 1 and more: that of monitor mode - 1.");
    r.block(safe_controller() + "& recovery(int" + (differ ? " mode)" : ")"), [&](Code& f) {
      for (std::size_t k = 1; k < monitors.size(); ++k) {
        const std::string name = name_of(monitors[k]);
        if (name != first)
          f.line("if (mode == " + std::to_string(k + 1) + ") return " + name + ";");
      }
      f.line("return " + first + ";");
    });
  }
  void members(Code& body) {
    setting(body);
    parts(body);
    body.blank();
    for (const Slot& slot : robot_slots_) {
      body.line("Robot " + slot.name +
                (slot.numbered ? "_[" + std::to_string(slot.count) + "];" : "_;"));
    }
    body.line("std::array<rtac::RobotParts<" + output_ + ">, robots> parts_;");
    body.line("rtac::System<" + output_ + "> system_;");
  }
  // It moves up and down as well: recoveries that move are others than those of the plane.
  static bool flies(const Recovery& r, const Body& b) {
    return b.in_space && (moves(r.kind) || r.kind == RecoveryKind::land);
  }
  std::string type_of(const Recovery& r) const {
    if (flies(r, d().body)) {
      const std::string flight = r.kind == RecoveryKind::land ? "" : "InSpace";
      return "rtac::safe::" + std::string(class_of(r.kind)) + flight;
    }
    return "rtac::safe::" + std::string(class_of(r.kind)) + "<" + output_ + ">";
  }
  static const char* class_of(RecoveryKind kind) {
    switch (kind) {
      case RecoveryKind::brake:
        return "BrakeAndHold";
      case RecoveryKind::loiter:
        return "Loiter";
      case RecoveryKind::sequence:
        return "Sequence";
      case RecoveryKind::retreat:
        return "Retreat";
      case RecoveryKind::route:
        return "Route";
      case RecoveryKind::yield:
        return "Yield";
      case RecoveryKind::land:
        return "Land";
      case RecoveryKind::external:
        return "Claimed";
    }
    return "";
  }
  std::string arguments_of(const Recovery& r) const {
    if (r.kind == RecoveryKind::brake) return "standing()";
    if (r.kind == RecoveryKind::land) {
      return "landing(" + real_metres(r.speed_mmps) + ", " + real_metres(r.land_mm) + ")";
    }
    if (r.kind == RecoveryKind::external) return "standing(), " + claim_of(r);
    if (r.kind == RecoveryKind::sequence) {
      std::string steps;
      for (const Recovery& step : r.steps) {
        steps += (steps.empty() ? "\n            " : ",\n            ") + step_of(step);
      }
      return steps;
    }
    std::string text = "setting(" + real_metres(r.speed_mmps) + ", " +
                       names_(module_[r.zone].name) + "_zone(), " +
                       real_metres(r.route_clearance_mm) + ", " +
                       real_metres(r.return_clearance_mm) + ", " + real_metres(r.pass_gap_mm) + ")";
    if (r.kind == RecoveryKind::route) text += ", " + names_(module_[r.site].name) + "(self)";
    return text;
  }
  std::string step_of(const Recovery& r) const {
    const std::string lasts = std::to_string(r.lasts_us);
    if (flies(r, d().body)) {
      return "rtac::safe::Step<" + output_ + ">{std::make_unique<" + type_of(r) + ">(" +
             arguments_of(r) + "), " + lasts + "}";
    }
    return std::string("rtac::safe::step<rtac::safe::") + class_of(r.kind) + ", " + output_ + ">(" +
           lasts + ", " + arguments_of(r) + ")";
  }
  // rtac::safe::Claim: zone, speed, time until the next command acts, and what braking takes.
  std::string claim_of(const Recovery& r) const {
    const Body& b = d().body;
    const auto part = [](std::int64_t thousandths) { return real_metres(thousandths); };
    const bool has_height = module_[r.zone].has_height();
    const std::string zone = "&" + names_(module_[r.zone].name) + "_zone()";
    return "{" + (has_height ? "nullptr" : zone) + ", " + real_metres(r.speed_mmps) + ", " +
           std::to_string(reaction_us(d(), r)) + ", " + part(b.accel_mmps2) + ", " +
           part(b.brake_lag_ms) + ", " + part(b.brake_lag_permille) + ", " +
           real_metres(b.hold_mm) + (has_height ? ", " + zone : "") + "}";
  }
  // The setting of whoever does not move: it needs no zone.
  void standing(Code& body) {
    body.block("static rtac::safe::Setting standing()", [&](Code& f) {
      f.line("rtac::safe::Setting s;");
      f.line("s.limits = " + kind_name_ + "_limits();");
      f.line("s.period_us = " + std::to_string(d().period_us) + ";");
      f.line("return s;");
    });
  }
  bool any_stands() const {
    return any_step(
        [](const Recovery& step) { return step.kind == RecoveryKind::brake || step.claims; });
  }
  template <class Is>
  bool any_step(const Is& is) const {
    return std::any_of(recoveries_.begin(), recoveries_.end(), [&](const Recovery* r) {
      const auto steps = steps_of(*r);
      return std::any_of(steps.begin(), steps.end(),
                         [&](const Recovery* step) { return is(*step); });
    });
  }
  // In a zone with height; and down to a height.
  void settings_in_space(Code& body) {
    const auto is = [&](RecoveryKind kind, bool high) {
      return any_step([&](const Recovery& step) {
        return step.kind == kind && (!high || module_[step.zone].has_height());
      });
    };
    if (is(RecoveryKind::retreat, true) || is(RecoveryKind::loiter, true)) {
      body.line(
          "static rtac::safe::Setting setting(double speed_mps, const rtac::SolidView& zone,");
      body.line("                                   double route_clearance_m, double give_back_m,");
      body.block("                                   double /*pass_m*/)", [&](Code& f) {
        f.line("rtac::safe::Setting s;");
        f.line("s.limits = " + kind_name_ + "_limits();");
        f.line("s.period_us = " + std::to_string(d().period_us) + ";");
        f.line("s.speed_mps = speed_mps;");
        f.line("s.solid = &zone;");
        f.line("s.route_clearance_m = route_clearance_m;");
        f.line("s.return_clearance_m = give_back_m;");
        f.line("return s;");
      });
    }
    if (!is(RecoveryKind::land, false)) return;
    body.block("static rtac::safe::Setting landing(double speed_mps, double land_at_m)",
               [&](Code& f) {
                 f.line("rtac::safe::Setting s;");
                 f.line("s.limits = " + kind_name_ + "_limits();");
                 f.line("s.period_us = " + std::to_string(d().period_us) + ";");
                 f.line("s.speed_mps = speed_mps;");
                 f.line("s.land_at_m = land_at_m;");
                 f.line("return s;");
               });
  }
  void setting(Code& body) {
    if (any_stands()) standing(body);
    settings_in_space(body);
    body.line("static rtac::safe::Setting setting(double speed_mps, const rtac::ZoneView& zone,");
    body.line("                                   double route_clearance_m, double give_back_m,");
    body.block("                                   double pass_m)", [&](Code& f) {
      f.line("rtac::safe::Setting s;");
      f.line("s.limits = " + kind_name_ + "_limits();");
      f.line("s.period_us = " + std::to_string(d().period_us) + ";");
      f.line("s.speed_mps = speed_mps;");
      f.line("s.zone = &zone;");
      f.line("s.route_clearance_m = route_clearance_m;");
      f.line("s.return_clearance_m = give_back_m;");
      f.line("s.pass_gap_m = pass_m;");
      if (kind_.spec->energy) {
        f.line("s.detour_m = " + real(kind_.spec->energy->detour.value) + ";");
      }
      f.line("return s;");
    });
  }
  void parts(Code& body) {
    body.block(
        "static rtac::RobotParts<" + output_ + "> parts(const char* name, Robot& robot, " +
            "const " + kind_name_ + "Controllers& controllers)",
        [&](Code& f) {
          f.line("rtac::RobotParts<" + output_ + "> p;");
          f.line("p.name = name;");
          f.line("p.decision = &robot." + member_of(d()) + ";");
          f.block("for (int mode = 1; mode <= " + std::to_string(d().monitors.size()) + "; ++mode)",
                  [](Code& each) { each.line("(void)p.recoveries.push(&robot.recovery(mode));"); });
          f.line("p.advanced = &controllers." + names_(d().advanced) + ";");
          if (kind_.on_plan) {
            f.line("p.plan_decision = &robot." + member_of(*kind_.on_plan) + ";");
            f.line("p.advanced_planner = &controllers." + advanced_planner() + ";");
            f.line("p.safe_planner = &controllers." + planner_slot(kind_.on_plan->safe) + ";");
          } else {
            f.line("p.advanced_planner = &controllers.planner;");
          }
          f.line("p.period_us = " + std::to_string(d().period_us) + ";");
          f.line("p.limits = " + kind_name_ + "_limits();");
          f.line("return p;");
        });
  }

  const Module& module_;
  const Names& names_;
  const Kind& kind_;
  const std::string kind_name_, name_, output_;
  const std::vector<Slot> robot_slots_;
  std::vector<const Recovery*> recoveries_;  // each once, by priority
  Code& out_;
};

bool any_claims(const Module& module) {
  for (const Decision& d : module.decisions) {
    for (const Monitor& m : d.monitors) {
      if (m.recovery.claims) return true;
    }
  }
  return false;
}

// Whether ways of the plane are driven in space.
bool any_level(const Module& module) {
  const auto drives = [](const Recovery* step) {
    return step->kind == RecoveryKind::route || step->kind == RecoveryKind::yield;
  };
  for (const Decision& d : module.decisions) {
    for (const Monitor& m : d.monitors) {
      if (d.body.in_space && std::ranges::any_of(steps_of(m.recovery), drives)) return true;
    }
  }
  return false;
}

std::vector<Kind> kinds_of(const Module& module, const sema::Spec& spec) {
  std::vector<Kind> kinds;
  for (const sema::RobotKind& k : spec.kinds) {
    Kind kind;
    kind.spec = &k;
    for (const Decision& d : module.decisions) {
      if (d.kind == k.name) (d.on_plan ? kind.on_plan : kind.periodic) = &d;
    }
    for (const sema::Robot& r : spec.robots) {
      if (spec[r.kind].name == k.name) kind.robots.push_back(&r);
    }
    if (kind.periodic && !kind.robots.empty()) kinds.push_back(std::move(kind));
  }
  return kinds;
}

}  // namespace

std::string system_header(const Module& module, const sema::Spec& spec, const Names& names,
                          const Naming& naming) {
  Code out;
  out.comment("Generated by rtac " RTAC_VERSION " from " + naming.source + ". Do not edit.");
  out.line("#pragma once").blank();
  out.line("#include <array>").line("#include <cstring>").blank();
  if (any_claims(module)) out.line("#include \"rtac/safe/claim.h\"");
  out.line("#include \"rtac/safe/controllers.h\"");
  if (any_level(module)) out.line("#include \"rtac/safe/level.h\"");
  if (in_space(module)) out.line("#include \"rtac/safe/space.h\"");
  out.line("#include \"rtac/stack/system.h\"");
  out.line("#include \"" + naming.stem + ".h\"").blank();
  out.line("namespace " + naming.space + " {").blank();
  const std::vector<Kind> kinds = kinds_of(module, spec);
  for (const Kind& kind : kinds) {
    SystemPrinter(module, names, kind, kinds.size() == 1, out).print();
  }
  out.line("}  // namespace " + naming.space);
  return out.print(Code::Style::cpp);
}

}  // namespace rtac::codegen
