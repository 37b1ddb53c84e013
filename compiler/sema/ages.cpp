// `age(signal)`: of an input, and of what a robot senses.
#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"

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
  std::vector<std::string> names;
  for (const SensedName& each : sensed_names) {
    names.emplace_back(each.name);
    if (field.text != each.name) continue;
    require(each.need, expr.range, "`age`");
    return make_quantity(expr.range, dims::time, SensedAge{each.signal});
  }
  context_.report(
      Finding(Code::unknown_signal, field.range, "`" + field.text + "` of a robot has no age here")
          .label("not a measurement with an age")
          .help(did_you_mean(field.text, names, "measurements of a robot")));
  return nullptr;
}

Value PropertyChecker::age(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 1, "age(signal)")) return nullptr;
  const syntax::Expr& argument = *call.arguments.front();
  if (is_error(argument)) return nullptr;
  const auto* member = std::get_if<syntax::Member>(&argument.node);
  if (member != nullptr && sees_fleets() && names_robot(*member->base)) {
    const auto robot = robot_named(*member->base);
    const auto input =
        robot ? robot_input(*robot, member->field.text, argument.range) : std::nullopt;
    return input ? make_quantity(expr.range, dims::time, AgeOf{*input}) : nullptr;
  }
  const auto who = member != nullptr ? subject(*member->base) : std::nullopt;
  if (who) return age_of_sense(expr, member->field, *who);
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
  return make_quantity(expr.range, dims::time, AgeOf{input});
}

}  // namespace rtac::sema
