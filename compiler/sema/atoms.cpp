// What a property says about robots: signals, zones, distances, energy.
#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"
#include "compiler/sema/zones.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

std::optional<Subject> PropertyChecker::subject(const syntax::Expr& expr) const {
  const syntax::Name* name = name_in(expr);
  if (name == nullptr || !sees_robot()) return std::nullopt;
  if (name->text == scope_.self.text) return Subject::self;
  if (other_ != nullptr && name->text == other_->text) return Subject::other;
  return std::nullopt;
}

void PropertyChecker::require(Need need, const SourceRange& range, const std::string& user) {
  if (scope_.kind) context_.require(*scope_.kind, need, range, user);
}

// Look-ahead predicts where the robot can be: from its position and its velocity.
void PropertyChecker::require_motion(const SourceRange& range, const std::string& user) {
  require(Need::position, range, user);
  require(Need::velocity, range, user);
}

bool PropertyChecker::robot_allowed(const SourceRange& range, const std::string& what) {
  if (sees_robot()) return true;
  const bool inside_function = function_ != nullptr;
  context_.report(
      Finding(Code::needs_robot, range,
              what + (inside_function ? " cannot stand in a function" : " needs a robot"))
          .label(inside_function ? "speaks of a robot" : "this monitor has no robot")
          .help(inside_function ? "write it in the monitor, and pass the quantity as an argument"
                                : "write `monitor name for r : Kind { ... }`, or judge inputs"));
  return false;
}

// A zone that the monitored robot is held against: in space it may have height.
std::optional<ZoneId> PropertyChecker::zone_of_robot(const syntax::Expr& expr) {
  if (!in_space()) return zone_in_property(context_, expr, map_frame, Change::looked_ahead);
  const Change change = has_height(context_, expr) ? Change::refused : Change::timed;
  return zone_in_property(context_, expr, map_frame, change, Height::allowed);
}

bool PropertyChecker::is_self(const syntax::Expr& expr, const std::string& user) {
  const auto who = subject(expr);
  if (who == Subject::self) return true;
  if (is_error(expr)) return false;
  const syntax::Name* name = name_in(expr);
  const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
  const std::string& self = scope_.self.text;
  if (who == Subject::other || (symbol != nullptr && symbol->sort == Sort::robot)) {
    context_.report(Finding(Code::monitored_robot_required, expr.range,
                            user + " speaks of `" + name->text + "`, which is not monitored here")
                        .label("must be `" + self + "`")
                        .help("write `" + self + "`: the monitor runs on every robot of its kind"));
  } else if (name != nullptr && symbol == nullptr) {
    unknown_name(*name, {Sort::enumeration});
  } else {
    context_.report(Finding(Code::wrong_argument, expr.range, user + " takes a robot here")
                        .label("not a robot")
                        .help("write `" + self + "`"));
  }
  return false;
}

bool PropertyChecker::argument_count(const syntax::Expr& expr, const syntax::Call& call,
                                     std::size_t due, const std::string& example) {
  if (call.arguments.size() == due) return true;
  context_.report(Finding(Code::wrong_argument_count, expr.range,
                          "`" + call.callee.text + "` takes " + std::to_string(due) +
                              (due == 1 ? " argument" : " arguments") + ", not " +
                              std::to_string(call.arguments.size()))
                      .label("like `" + example + "`")
                      .help("write `" + example + "`"));
  return false;
}

Value PropertyChecker::robot_name(const syntax::Expr& expr) {
  const std::string& name = name_in(expr)->text;
  if (sees_fleets()) {
    context_.report(
        Finding(Code::quantity_expected, expr.range, "`" + name + "` is a robot, not a value")
            .label("a robot")
            .help("write a signal such as `" + name +
                  ".battery`, or a distance such as `distance(" + name + ", q)`"));
    return nullptr;
  }
  if (!robot_allowed(expr.range, "the robot `" + name + "`")) return nullptr;
  context_.report(
      Finding(Code::quantity_expected, expr.range, "`" + name + "` is a robot, not a value")
          .label("a robot")
          .help("write a signal such as `" + scope_.self.text + ".battery`, or `clearance(" +
                scope_.self.text + ", zone)`"));
  return nullptr;
}

bool PropertyChecker::in_space() const {
  return scope_.kind && context_.spec[*scope_.kind].in_space;
}

// `r.position.z`: how high the centre is. Other components of a position say where it is on a map,
// which zones do.
bool PropertyChecker::is_altitude(const syntax::Member& member) const {
  const auto* position = std::get_if<syntax::Member>(&member.base->node);
  return sees_robot() && position != nullptr && position->field.text == "position" &&
         member.field.text == "z" && subject(*position->base) == Subject::self;
}

ExprPtr PropertyChecker::altitude(const syntax::Expr& expr) {
  require_motion(expr.range, "`position.z`");
  if (in_space()) {
    return make_quantity(expr.range, dims::length, SignalRef{Subject::self, Signal::altitude});
  }
  const std::string kind = kind_name();
  context_.report(Finding(Code::spaces_differ, expr.range, "`" + kind + "` has no height")
                      .label("robots in the plane have none")
                      .help("declare `sense position : point3 ...` and `sense velocity : vector3 "
                            "...` of `" +
                            kind + "`"));
  return nullptr;
}

Value PropertyChecker::robot_member(const syntax::Expr& expr, const syntax::Member& member) {
  if (!robot_allowed(expr.range, "`." + member.field.text + "` of a robot")) return nullptr;
  if (const auto who = subject(*member.base)) return signal(expr, member.field, *who);
  is_self(*member.base, "`." + member.field.text + "`");
  return nullptr;
}

ExprPtr PropertyChecker::signal(const syntax::Expr& expr, const syntax::Name& field, Subject who) {
  const std::string user = "`" + field.text + "`";
  if (field.text == "battery" || field.text == "speed") {
    const bool battery = field.text == "battery";
    require(battery ? Need::battery : Need::velocity, expr.range, user);
    if (who == Subject::other) require(Need::hears, expr.range, user + " of another robot");
    return make_quantity(expr.range, battery ? dims::ratio : dims::speed,
                         SignalRef{who, battery ? Signal::battery : Signal::speed});
  }
  if (field.text == "position" || field.text == "velocity" || field.text == "heading" ||
      field.text == "plan") {
    return not_scalar(expr, field);
  }
  if (!field.text.empty()) {
    context_.report(
        Finding(Code::unknown_signal, field.range, "a robot has no signal `" + field.text + "`")
            .label("not a signal")
            .help(did_you_mean(field.text, {"battery", "speed", "plan"},
                               "signals of a robot in a property")));
  }
  return nullptr;
}

ExprPtr PropertyChecker::not_scalar(const syntax::Expr& expr, const syntax::Name& field) {
  const std::string& self = scope_.self.text;
  std::string help = "write `" + self + " inside zone`, `clearance(" + self +
                     ", zone)` or `distance(" + self + ", q)`";
  std::string what = "a point";
  if (field.text == "velocity") {
    what = "a vector";
    help = "write `" + self + ".speed` for its length";
  } else if (field.text == "heading") {
    what = "a direction";
    help = "no property can speak of the heading; " + help;
  } else if (field.text == "plan") {
    what = "a path";
    help = "write `" + self + ".plan inside zone`";
  } else {
    help += "; a limit of x or y is a zone, such as a rectangle that ends there";
  }
  context_.report(Finding(Code::signal_not_scalar, expr.range,
                          "`" + field.text + "` is " + what + ", not a quantity")
                      .label("this is " + what)
                      .help(help));
  return nullptr;
}

ExprPtr PropertyChecker::inside(const syntax::Expr& expr, const syntax::Binary& binary) {
  if (!sees_robot()) return point_inside(expr, binary);
  if (says_way(*binary.left) && !ways_allowed(*binary.left)) return nullptr;
  const auto* member = std::get_if<syntax::Member>(&binary.left->node);
  if (member != nullptr) return plan_inside(expr, *member, *binary.right);
  const bool self = is_self(*binary.left, "`inside`");
  const auto zone = zone_of_robot(*binary.right);
  if (!self || !zone) return nullptr;
  require_motion(expr.range, "`inside`");
  if (!complemented(context_.spec, *zone)) {
    return inside_while_open(expr.range, *zone, make_condition(expr.range, InsideZone{*zone}));
  }
  // a complement is open
  ExprPtr gap = make_quantity(expr.range, dims::length, Clearance{*zone});
  ExprPtr none = make_quantity(expr.range, dims::length, Constant{0});
  return inside_while_open(
      expr.range, *zone,
      make_condition(expr.range, Compare{CompareOp::greater, std::move(gap), std::move(none)}));
}

ExprPtr PropertyChecker::plan_inside(const syntax::Expr& expr, const syntax::Member& member,
                                     const syntax::Expr& zone_expr) {
  const bool self = is_self(*member.base, "`inside`");
  const auto zone = zone_in_property(context_, zone_expr);
  if (!self) return nullptr;
  if (member.field.text == "position") {
    context_.report(
        Finding(Code::signal_not_scalar, expr.range, "`inside` speaks of the body, not of a point")
            .label("`position` is the centre of the body")
            .help("write `" + scope_.self.text + " inside ...`"));
    return nullptr;
  }
  if (member.field.text != "plan") {
    if (member.field.text.empty()) return nullptr;
    context_.report(Finding(Code::wrong_argument, member.field.range,
                            "`" + member.field.text + "` cannot be inside a zone")
                        .label("neither a robot nor its plan")
                        .help("write `" + scope_.self.text + " inside ...` or `" +
                              scope_.self.text + ".plan inside ...`"));
    return nullptr;
  }
  require(Need::plan, expr.range, "`plan inside`");
  return zone ? make_condition(expr.range, PlanInside{*zone}) : nullptr;
}

Value PropertyChecker::robot_call(const syntax::Expr& expr, const syntax::Call& call) {
  const std::string& name = call.callee.text;
  if (name == "clearance" && !sees_robot()) return clearance_of_place(expr, call);
  const bool known = name == "clearance" || name == "distance" || name == "energy_to";
  if (known && !robot_allowed(expr.range, "`" + name + "`")) return nullptr;
  if (name == "clearance") return clearance(expr, call);
  if (name == "distance") return distance(expr, call);
  if (name == "energy_to") return energy_to(expr, call);
  if (is_zone_function(name)) return not_a_quantity(expr, "a zone");
  return other_call(expr, call, context_.symbols.find(name));
}

bool PropertyChecker::names_zone(const syntax::Expr& expr) const {
  const syntax::Name* name = name_in(expr);
  const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
  return symbol != nullptr && (symbol->sort == Sort::zone || is_received_zone(context_, *symbol));
}

ExprPtr PropertyChecker::clearance(const syntax::Expr& expr, const syntax::Call& call) {
  const std::string example = "clearance(" + scope_.self.text + ", zone)";
  if (!argument_count(expr, call, 2, example)) return nullptr;
  const syntax::Expr& first = *call.arguments[0];
  const syntax::Expr& second = *call.arguments[1];
  if (names_zone(first) && subject(second) == Subject::self) {
    context_.report(Finding(Code::wrong_argument, expr.range, "`clearance` takes the robot first")
                        .label("the zone stands first")
                        .help("swap them: `clearance(robot, zone)`")
                        .replace(first.range, scope_.self.text)
                        .replace(second.range, name_in(first)->text));
    return nullptr;
  }
  const bool self = is_self(first, "`clearance`");
  const auto zone = zone_of_robot(second);
  if (!self || !zone) return nullptr;
  require_motion(expr.range, "`clearance`");
  return gap_while_open(expr.range, *zone, false,
                        make_quantity(expr.range, dims::length, Clearance{*zone}));
}

// The place that a robot's distance is asked from, where its numbers are written out.
static const syntax::Expr* fixed_place(const syntax::Expr& first, const syntax::Expr& second) {
  for (const syntax::Expr* each : {&second, &first}) {
    if (std::holds_alternative<syntax::PointLit>(each->node)) return each;
  }
  return nullptr;
}

ExprPtr PropertyChecker::distance(const syntax::Expr& expr, const syntax::Call& call) {
  const std::string& self = scope_.self.text;
  if (!argument_count(expr, call, 2, "distance(" + self + ", q)")) return nullptr;
  const syntax::Expr& first = *call.arguments[0];
  const syntax::Expr& second = *call.arguments[1];
  if (is_error(first) || is_error(second)) return nullptr;
  const auto one = subject(first);
  const auto two = subject(second);
  if (one && two && *one != *two) {
    require_motion(expr.range, "`distance`");
    require(Need::hears, expr.range, "`distance`");
    return make_quantity(expr.range, dims::length, Distance{});
  }
  if (one == Subject::self && names_agent(second)) return distance_from_agent(expr, second);
  if (two == Subject::self && names_agent(first)) return distance_from_agent(expr, first);
  if (says_zone(first) && says_zone(second)) return distance_of_zones(expr, first, second);
  if (one == Subject::self && says_zone(second)) return distance_from_zone(expr, second);
  if (two == Subject::self && says_zone(first)) return distance_from_zone(expr, first);
  for (const syntax::Expr* argument : {&first, &second}) {
    if (!says_zone(*argument)) continue;
    context_.report(Finding(Code::wrong_argument, argument->range,
                            "`distance` from a zone is that of `" + self + "`")
                        .label("a zone")
                        .help("write `distance(" + self + ", ...)` with the zone"));
    return nullptr;
  }
  const bool quantified = other_ != nullptr;
  if (!quantified && one == Subject::self && !is_known(second)) return nullptr;
  if (!quantified && two == Subject::self && !is_known(first)) return nullptr;
  Finding finding(Code::distance_needs_other, expr.range,
                  quantified
                      ? "`distance` is the one between `" + self + "` and `" + other_->text + "`"
                      : "`distance` needs another robot, bound by `forall` or `exists`");
  finding.label(quantified ? "not these two" : "outside `forall` and `exists`");
  if (const syntax::Expr* fixed = fixed_place(first, second)) {
    finding.label("a place that stays where it is")
        .help("declare `zone around = circle " + print_expr(*fixed) +
              " radius 50 cm;` with the radius that is due, and write `distance(" + self +
              ", around) >= 0 m` to stay outside, or `" + self + " inside around`");
  } else if (quantified) {
    finding.help("write `distance(" + self + ", " + other_->text + ")`");
  } else {
    finding.help("write `forall q : " + kind_name() + ", q != " + self + " : distance(" + self +
                 ", q) >= ...`");
  }
  context_.report(finding);
  return nullptr;
}

// A name that nobody has declared, and that is nearly the one of a zone or an agent, is reported as
// that; so is any where a declaration may be lost. Others are robots that no quantifier binds.
bool PropertyChecker::is_known(const syntax::Expr& expr) {
  const auto* index = std::get_if<syntax::Index>(&expr.node);
  const syntax::Name* name = name_in(index != nullptr ? *index->base : expr);
  if (name == nullptr || name->text == scope_.self.text) return true;
  if (context_.symbols.find(name->text) != nullptr) return true;
  for (const Sort sort : {Sort::zone, Sort::agent, Sort::agents}) {
    if (!nearest(name->text, context_.symbols.names_of(sort))) continue;
    (void)context_.resolve(*name, sort);
    return false;
  }
  if (!context_.broken_tree()) return true;
  (void)context_.resolve(*name, Sort::zone);
  return false;
}

// The gap between the body and a zone to keep out of, negative on overlap.
ExprPtr PropertyChecker::distance_from_zone(const syntax::Expr& expr, const syntax::Expr& written) {
  const auto zone = zone_of_robot(written);
  if (!zone) return nullptr;
  require_motion(expr.range, "`distance`");
  const ZoneId outside = complement_of(context_, *zone, written.range);
  return gap_while_open(expr.range, *zone, true,
                        make_quantity(expr.range, dims::length, Clearance{outside}));
}

ExprPtr PropertyChecker::energy_to(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 1, "energy_to(dock(" + scope_.self.text + "))")) return nullptr;
  const auto site = place_of_self(*call.arguments[0]);
  if (!site) return nullptr;
  require_motion(expr.range, "`energy_to`");
  require(Need::battery, expr.range, "`energy_to`");
  require(Need::energy, expr.range, "`energy_to`");
  return make_quantity(expr.range, dims::ratio, EnergyTo{*site});
}

// `dock(r)`; `home` alone when the site is one place for all robots.
std::optional<SiteId> PropertyChecker::place_of_self(const syntax::Expr& place) {
  if (is_error(place)) return std::nullopt;
  const std::string& self = scope_.self.text;
  const auto* call = std::get_if<syntax::Call>(&place.node);
  const syntax::Name* name = call != nullptr ? &call->callee : name_in(place);
  if (name == nullptr) {
    context_.report(
        Finding(Code::wrong_argument, place.range, "`energy_to` takes a site")
            .label("not a site")
            .help("declare `site dock = (x, y);` and write `energy_to(dock(" + self + "))`"));
    return std::nullopt;
  }
  const auto site = context_.resolve<SiteId>(*name, Sort::site);
  if (!site) return std::nullopt;
  if (call == nullptr) {
    const auto& places = context_.spec[*site].places;
    if (!places.empty() && !places.front().robot) return site;
    context_.report(Finding(Code::wrong_argument, place.range,
                            "`" + name->text + "` has a place for each robot")
                        .label("whose place?")
                        .help("write `" + name->text + "(" + self + ")`")
                        .insert_after(name->range, "(" + self + ")"));
    return std::nullopt;
  }
  if (!argument_count(place, *call, 1, name->text + "(" + self + ")")) return std::nullopt;
  if (!place_belongs_to_self(*call->arguments[0], name->text)) return std::nullopt;
  if (scope_.kind) context_.require_places(*site, *scope_.kind, place.range);
  return site;
}

// The name of a robot may stand for the variable when the robot is the only one of its kind.
bool PropertyChecker::place_belongs_to_self(const syntax::Expr& robot, const std::string& site) {
  const syntax::Name* name = name_in(robot);
  const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
  if (symbol != nullptr && symbol->sort == Sort::robot && scope_.kind) {
    int robots = 0;
    for (const Robot& each : context_.spec.robots) robots += each.kind == *scope_.kind ? 1 : 0;
    if (robots == 1 && context_.spec.robots[symbol->index].kind == *scope_.kind) return true;
  }
  return is_self(robot, "`" + site + "`");
}

}  // namespace rtac::sema
