// `age(signal)`: of an input, and of what a robot senses.
#include <algorithm>

#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"
#include "compiler/sema/zones.h"

namespace rtac::sema {

namespace {

struct SensedName {
  const char* name;
  Sensed signal;
  Need need;
};
constexpr SensedName sensed_names[] = {
    {"position", Sensed::position, Need::position},
    {"velocity", Sensed::velocity, Need::velocity},
    {"battery", Sensed::battery, Need::battery},
};

const SensedName* sensed_named(const std::string& name) {
  const auto* found = std::find_if(std::begin(sensed_names), std::end(sensed_names),
                                   [&](const SensedName& each) { return name == each.name; });
  return found == std::end(sensed_names) ? nullptr : found;
}

// Reports that a robot measures nothing of this name that has an age.
void report_ageless(Context& context, const syntax::Name& field,
                    const std::vector<std::string>& names) {
  Finding finding(Code::unknown_signal, field.range,
                  "`" + field.text + "` of a robot has no age here");
  finding.label("only " + listing(names) + " have one");
  finding.help(did_you_mean(field.text, names, "measurements with an age"));
  if (const auto likely = nearest(field.text, names)) finding.replace(field.range, *likely);
  context.report(finding);
}

}  // namespace

// Of the monitored robot. That of another one is how old its message may be, which `hears` says.
ExprPtr PropertyChecker::age_of_sense(const syntax::Expr& expr, const syntax::Name& field,
                                      Subject who) {
  if (field.text.empty()) return nullptr;
  if (who == Subject::other) {
    context_.report(Finding(Code::monitored_robot_required, expr.range,
                            "`age` speaks of another robot, which is not monitored here")
                        .label("must be of `" + scope_.self.text + "`")
                        .help("`hears other robots max_age ...` says how old its samples may be; "
                              "a monitor without a robot may ask for the age of any"));
    return nullptr;
  }
  const SensedName* sensed = sensed_named(field.text);
  if (sensed == nullptr) {
    std::vector<std::string> names;
    for (const SensedName& each : sensed_names) names.emplace_back(each.name);
    report_ageless(context_, field, names);
    return nullptr;
  }
  require(sensed->need, expr.range, "`age`");
  return make_quantity(expr.range, dims::time, SensedAge{sensed->signal});
}

// Of any robot, in a monitor without one.
ExprPtr PropertyChecker::age_of_member(const syntax::Expr& expr, const syntax::Member& member) {
  const auto robot = robot_named(*member.base);
  if (!robot || member.field.text.empty()) return nullptr;
  if (member.field.text == "plan") {
    const auto plan = robot_plan(*robot, expr.range);
    return plan ? make_quantity(expr.range, dims::time, AgeOf{*plan}) : nullptr;
  }
  static const std::vector<std::string> names{"position", "velocity", "heading", "battery", "plan"};
  if (std::find(names.begin(), names.end(), member.field.text) == names.end()) {
    report_ageless(context_, member.field, names);
    return nullptr;
  }
  const auto input = robot_input(*robot, member.field.text, expr.range);
  return input ? make_quantity(expr.range, dims::time, AgeOf{*input}) : nullptr;
}

// Reports a robot, or a name that is none, where `age` is due a measurement.
bool PropertyChecker::ageless_robot(const syntax::Expr& argument) {
  if (says_robot(argument)) {
    const auto* index = std::get_if<syntax::Index>(&argument.node);
    const std::string robot =
        name_in(index != nullptr ? *index->base : argument)->text + (index != nullptr ? "[0]" : "");
    context_.report(
        Finding(Code::wrong_argument, argument.range, "`age` takes a measurement, this is a robot")
            .label("a robot")
            .help("write what it measures, such as `age(" + robot + ".position)`"));
    return true;
  }
  const auto* member = std::get_if<syntax::Member>(&argument.node);
  const syntax::Name* base = member != nullptr ? name_in(*member->base) : nullptr;
  if (base == nullptr || local(base->text) != nullptr) return false;
  const Symbol* symbol = context_.symbols.find(base->text);
  if (symbol == nullptr) {
    unknown_name(*base, places_of_robots());
    return true;
  }
  if (symbol->sort != Sort::robot) return false;
  if (robot_allowed(argument.range, "`age` of a robot")) is_self(*member->base, "`age`");
  return true;
}

Value PropertyChecker::age(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 1, "age(signal)")) return nullptr;
  const syntax::Expr& argument = *call.arguments.front();
  if (is_error(argument)) return nullptr;
  const auto* member = std::get_if<syntax::Member>(&argument.node);
  if (member != nullptr && sees_fleets() && names_robot(*member->base)) {
    return age_of_member(expr, *member);
  }
  const auto who = member != nullptr ? subject(*member->base) : std::nullopt;
  if (who) return age_of_sense(expr, member->field, *who);
  if (ageless_robot(argument)) return nullptr;
  const syntax::Name* name = name_in(argument);
  const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
  const bool bound = name != nullptr && local(name->text) != nullptr;
  if (name != nullptr && symbol == nullptr && !bound) {
    unknown_name(*name);
    return nullptr;
  }
  if (symbol == nullptr || symbol->sort != Sort::input || bound) {
    context_.report(
        Finding(Code::wrong_argument, argument.range, "`age` takes the name of an input")
            .label("not an input")
            .help("write `age(signal)`: all components of an input arrive together"));
    return nullptr;
  }
  if (!signal_allowed(argument.range, *name, Sort::input)) return nullptr;
  const InputId input{symbol->index};
  context_.used_inputs.insert(input);
  if (scope_.of_robot() && context_.input_types[symbol->index].kind == TypeKind::path) {
    context_.report(Finding(Code::wrong_argument, argument.range,
                            "the path `" + name->text + "` is judged by monitors without a robot")
                        .label("in the monitor of a robot")
                        .help("write a monitor without `for` about its age"));
    return nullptr;
  }
  if (scope_.of_robot() && is_received_zone(context_, *symbol)) {
    context_.report(Finding(Code::zone_not_fixed, argument.range,
                            "the zone `" + name->text + "` is received while the monitors run")
                        .label("not known to monitors of robots")
                        .help("write a monitor without `for` about its age"));
    return nullptr;
  }
  return make_quantity(expr.range, dims::time, AgeOf{input});
}

}  // namespace rtac::sema
