// Functions of the author: pure, typed, put in the place of every call.
#include <algorithm>

#include "compiler/sema/frames.h"
#include "compiler/sema/inputs.h"
#include "compiler/sema/property_checker.h"
#include "compiler/sema/types.h"

namespace rtac::sema {

namespace {

std::string signature(const Function& function) {
  std::string text = function.node->name.text + "(";
  for (std::size_t i = 0; i < function.node->parameters.size(); ++i) {
    text += (i > 0 ? ", " : "") + function.node->parameters[i].name.text;
  }
  return text + ")";
}

}  // namespace

void check_functions(Context& context) {
  const PropertyScope scope;
  for (std::uint32_t i = 0; i < context.functions.size(); ++i) {
    PropertyChecker(context, scope).function(i);
  }
}

void PropertyChecker::function(std::uint32_t index) {
  if (context_.functions[index].state != FunctionState::fresh) return;
  context_.functions[index].state = FunctionState::open;
  check_signature(context_.functions[index]);
  const bool typed = context_.functions[index].state != FunctionState::faulty;
  const bool good = typed && check_body(context_.functions[index]);
  Function& function = context_.functions[index];
  const bool circular = function.state == FunctionState::faulty;
  function.state = good && !circular ? FunctionState::good : FunctionState::faulty;
}

namespace {

// `vector` alone has no unit.
std::string result_help(const ValueType& due, const Value& body) {
  const auto* pair = std::get_if<Pair>(&body.node);
  const bool lacks_unit = due.kind == TypeKind::vector && pair != nullptr && !due.length &&
                          due.dimension == Dimension{} && pair->x->dimension != Dimension{};
  if (!lacks_unit) return "change the declared type or the body";
  return "write the unit, `vector [" + unit_of(pair->x->dimension) + "]`";
}

}  // namespace

bool PropertyChecker::result_fits(const Function& function, const Value& body) {
  if (fits(context_.spec, body, function.result)) return true;
  const syntax::Expr& written = *function.node->body;
  const syntax::Expr* bare = bare_number(written);
  if (bare != nullptr && function.result.kind == TypeKind::real && !function.result.length) {
    report_unit_missing(context_, *bare, function.result.dimension,
                        "the function gives " + describe(context_.spec, function.result));
    return false;
  }
  if (frame_misfits(written, body, function.result,
                    "`" + function.node->name.text + "` gives a result")) {
    return false;
  }
  context_.report(Finding(Code::wrong_result, written.range,
                          "`" + function.node->name.text + "` gives " +
                              describe(context_.spec, function.result) + ", but this is " +
                              describe(context_.spec, body))
                      .label("must be " + describe(context_.spec, function.result))
                      .note(function.node->result.range, "the type is declared here")
                      .help(result_help(function.result, body)));
  return false;
}

void PropertyChecker::check_signature(Function& function) {
  const auto& parameters = function.node->parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto type = check_type(context_, parameters[i].type);
    function.parameters.push_back(type.value_or(ValueType{}));
    if (!type) function.state = FunctionState::faulty;
    for (std::size_t j = 0; j < i; ++j) {
      if (parameters[j].name.text != parameters[i].name.text) continue;
      context_.report(Finding(Code::duplicate_name, parameters[i].name.range,
                              "the parameter `" + parameters[i].name.text + "` stands twice")
                          .label("declared again")
                          .note(parameters[j].name.range, "the first one is here")
                          .help("give one of them another name"));
      function.state = FunctionState::faulty;
      break;
    }
  }
  const auto result = check_type(context_, function.node->result);
  function.result = result.value_or(ValueType{});
  const bool damaged = context_.damaged(function.node->name.range);
  if (!result || damaged) function.state = FunctionState::faulty;
}

// The body on its own: the parameters stand as inputs, which go away afterwards.
bool PropertyChecker::check_body(Function& function) {
  Spec& spec = context_.spec;
  const std::size_t inputs = spec.inputs.size();
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const ValueType& type = function.parameters[i];
    Input input{};
    input.name = function.node->parameters[i].name.text;
    shape(input, type);
    spec.inputs.push_back(std::move(input));
    context_.input_types.push_back(type);
    const syntax::Name& name = function.node->parameters[i].name;
    locals_.push_back(
        {name.text, name.range,
         input_value(name.range, InputId{static_cast<std::uint32_t>(spec.inputs.size() - 1)})});
  }
  function_ = &function;
  generic_ = true;
  const Value body = infer(*function.node->body);
  const bool good = body && result_fits(function, body);
  for (std::size_t i = inputs; i < spec.inputs.size(); ++i) {
    context_.used_inputs.erase(InputId{static_cast<std::uint32_t>(i)});
  }
  spec.inputs.resize(inputs);
  context_.input_types.resize(inputs);
  return good;
}

bool PropertyChecker::check_function(const syntax::Call& call, std::uint32_t index) {
  Function& function = context_.functions[index];
  if (function.state == FunctionState::fresh) {
    const PropertyScope anywhere;
    PropertyChecker checker(context_, anywhere);
    checker.depth_ = depth_;  // functions that call functions are nested, too
    checker.function(index);
  }
  if (function.state == FunctionState::good) return true;
  if (function.state == FunctionState::faulty) return false;
  context_.report(
      Finding(Code::function_recursive, call.callee.range,
              "`" + call.callee.text + "` calls itself")
          .label("the circle closes here")
          .note(function.node->name.range, "`" + call.callee.text + "` is declared here")
          .help("a function is put in the place of its call, so that it must come to "
                "an end: write it without itself"));
  function.state = FunctionState::faulty;
  return false;
}

// Reports a value that would fit but for its frame.
bool PropertyChecker::frame_misfits(const syntax::Expr& written, const Value& value,
                                    const ValueType& type, const std::string& user) {
  const auto* pair = std::get_if<Pair>(&value.node);
  if (pair == nullptr || !pair->frame || *pair->frame == type.frame) return false;
  ValueType there = type;
  there.frame = *pair->frame;
  if (!fits(context_.spec, value, there)) return false;
  report_frames(context_, written.range,
                user + " in `" + context_.spec[type.frame].name + "`, this is in `" +
                    context_.spec[*pair->frame].name + "`",
                *pair->frame, type.frame);
  return true;
}

bool PropertyChecker::argument_fits(const syntax::Expr& written, const Value& value,
                                    const ValueType& type, const std::string& function,
                                    const std::string& parameter) {
  if (fits(context_.spec, value, type)) {
    if (depth_of(value) <= static_cast<std::size_t>(max_depth)) return true;
    report_limit(written.range, "this argument is nested too deeply",
                 std::to_string(max_depth) + " levels");
    return false;
  }
  if (frame_misfits(written, value, type, "`" + function + "` takes `" + parameter + "`")) {
    return false;
  }
  const std::string due = describe(context_.spec, type);
  const syntax::Expr* bare = bare_number(written);
  if (bare != nullptr && type.kind == TypeKind::real && !type.length &&
      type.dimension != dims::number) {
    report_unit_missing(context_, *bare, type.dimension, "`" + parameter + "` is " + due);
    return false;
  }
  const auto* scalar = std::get_if<ExprPtr>(&value.node);
  const bool whole = type.kind == TypeKind::integer && scalar != nullptr && !(*scalar)->boolean &&
                     (*scalar)->dimension == dims::number;
  context_.report(
      Finding(Code::wrong_argument, written.range,
              "`" + function + "` takes " + due + " for `" + parameter + "`, this is " +
                  (whole ? "a number that may be none" : describe(context_.spec, value)))
          .label("must be " + due)
          .help("pass " + due));
  return false;
}

Value PropertyChecker::call_function(const syntax::Expr& expr, const syntax::Call& call,
                                     std::uint32_t index) {
  if (!check_function(call, index)) return nullptr;
  const syntax::FunItem& written = *context_.functions[index].node;
  if (!argument_count(expr, call, written.parameters.size(),
                      signature(context_.functions[index]))) {
    return nullptr;
  }
  const int outer_polarity = polarity_;
  polarity_ = 0;
  std::vector<Local> arguments;
  bool good = true;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const ValueType& type = context_.functions[index].parameters[i];
    Value value = infer(*call.arguments[i], type.kind == TypeKind::real
                                                ? std::optional<Dimension>(type.dimension)
                                                : std::nullopt);
    const syntax::Name& name = written.parameters[i].name;
    good = value && argument_fits(*call.arguments[i], value, type, call.callee.text, name.text) &&
           good;
    arguments.push_back({name.text, name.range, std::move(value)});
  }
  polarity_ = outer_polarity;
  if (!good) return nullptr;
  std::swap(locals_, arguments);
  if (function_ == nullptr) call_ = expr.range;
  const Function* caller = std::exchange(function_, &context_.functions[index]);
  Value body = infer(*written.body);
  function_ = caller;
  std::swap(locals_, arguments);
  return body;
}

}  // namespace rtac::sema
