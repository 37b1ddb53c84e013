// Names in an expression: inputs, parameters, values of enumerations, what `let` and functions
// bind; and components of points, vectors and arrays.
#include <algorithm>

#include "compiler/sema/inputs.h"
#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"
#include "compiler/sema/units.h"
#include "compiler/syntax/print_expr.h"

namespace rtac::sema {

const syntax::Name* name_in(const syntax::Expr& expr) {
  const auto* reference = std::get_if<syntax::NameRef>(&expr.node);
  return reference != nullptr ? &reference->name : nullptr;
}

bool PropertyChecker::speaks_of_points(const syntax::Expr& expr) const {
  if (const syntax::Name* name = name_in(expr)) {
    const Symbol* symbol = context_.symbols.find(name->text);
    return local(name->text) != nullptr || (symbol != nullptr && symbol->sort == Sort::input);
  }
  if (const auto* index = std::get_if<syntax::Index>(&expr.node)) {
    return speaks_of_points(*index->base);
  }
  const auto* sum = std::get_if<syntax::Binary>(&expr.node);
  return sum != nullptr && (speaks_of_points(*sum->left) || speaks_of_points(*sum->right));
}

const PropertyChecker::Local* PropertyChecker::local(std::string_view name) const {
  const auto found = std::find_if(locals_.rbegin(), locals_.rend(),
                                  [&](const Local& each) { return each.name == name; });
  return found == locals_.rend() ? nullptr : &*found;
}

std::vector<std::string> PropertyChecker::visible_names() const {
  std::vector<std::string> names;
  for (const Local& each : locals_) names.push_back(each.name);
  if (sees_robot()) {
    names.push_back(scope_.self.text);
    if (other_ != nullptr) names.push_back(other_->text);
  }
  const auto add = [&](Sort sort) {
    for (std::string& name : context_.symbols.names_of(sort)) names.push_back(std::move(name));
  };
  if (function_ == nullptr) {
    add(Sort::input);
    for (const auto& [variable, robot] : members_) names.push_back(variable->text);
  }
  add(Sort::parameter);
  add(Sort::enum_value);
  return names;
}

std::vector<Sort> PropertyChecker::places_of_robots() const {
  return sees_fleets() ? std::vector<Sort>{Sort::robot, Sort::fleet} : std::vector<Sort>{};
}

bool PropertyChecker::place_known(const syntax::Expr& place, const std::vector<Sort>& also) {
  const auto* index = std::get_if<syntax::Index>(&place.node);
  const syntax::Name* name = name_in(index != nullptr ? *index->base : place);
  if (name == nullptr || local(name->text) != nullptr || says_robot(place)) return true;
  if (context_.symbols.find(name->text) != nullptr) return true;
  unknown_name(*name, also);
  return false;
}

bool PropertyChecker::places_known(const std::vector<syntax::ExprPtr>& places) {
  std::vector<Sort> also = places_of_robots();
  also.push_back(Sort::zone);
  bool known = true;
  for (const syntax::ExprPtr& place : places) known = place_known(*place, also) && known;
  return known;
}

void PropertyChecker::unknown_name(const syntax::Name& name, const std::vector<Sort>& also) {
  if (!context_.first_unknown(name)) return;
  Finding finding(Code::unknown_name, name.range, "the name `" + name.text + "` is not declared");
  finding.label("not known here");
  if (!context_.may_suggest()) {
    context_.report(finding.help(Context::without_suggestion()));
    return;
  }
  std::vector<std::string> names;  // of two that are equally near the first is meant
  for (const Sort sort : also) {
    for (std::string& each : context_.symbols.names_of(sort)) names.push_back(std::move(each));
  }
  for (std::string& each : visible_names()) names.push_back(std::move(each));
  const auto likely = nearest(name.text, names);
  const Symbol* meant = likely ? context_.symbols.find(*likely) : nullptr;
  if (meant != nullptr && std::find(also.begin(), also.end(), meant->sort) != also.end()) {
    context_.unknown(name, meant->sort);
    return;
  }
  const bool signals = !context_.spec.inputs.empty() || !context_.spec.params.empty();
  const std::string what = sees_robot() && !signals ? "robots of this property"
                           : function_ != nullptr   ? "names of this function"
                           : !also.empty()          ? "names that fit here"
                                                    : "names of values";
  finding.help(did_you_mean(name.text, names, what));
  if (likely) finding.replace(name.range, *likely);
  if (!likely && parse_unit(name.text)) {
    finding.help("a unit stands behind its number: `3 " + name.text + "`");
  }
  for (const char* truth : {"true", "false"}) {
    if (edit_distance(name.text, truth) > 0) continue;  // `True`, `FALSE`
    finding.help(std::string("write `") + truth + "`").replace(name.range, truth);
  }
  context_.report(finding);
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::NameRef& reference) {
  const syntax::Name& name = reference.name;
  if (const Local* bound = local(name.text)) {
    if (!affordable(expr, size_of(bound->value))) return nullptr;
    return clone(bound->value);
  }
  if (subject(expr) || (sees_fleets() && names_robot(expr))) return robot_name(expr);
  const Symbol* symbol = context_.symbols.find(name.text);
  if (symbol != nullptr) return declared(expr, name, *symbol);
  unknown_name(name);
  return nullptr;
}

Value PropertyChecker::declared(const syntax::Expr& expr, const syntax::Name& name,
                                const Symbol& symbol) {
  switch (symbol.sort) {
    case Sort::input:
      if (names_zone(expr)) return not_a_quantity(expr, "a zone");
      return signal_allowed(expr.range, name, symbol.sort)
                 ? input_value(expr.range, InputId{symbol.index})
                 : nullptr;
    case Sort::parameter:
      return signal_allowed(expr.range, name, symbol.sort)
                 ? param_value(expr.range, ParamId{symbol.index})
                 : nullptr;
    case Sort::enum_value:
      return context_.enum_values[symbol.index];
    case Sort::robot:
      return robot_name(expr);
    case Sort::function:
      context_.report(Finding(Code::quantity_expected, expr.range,
                              "`" + name.text + "` is a function, not a value")
                          .label("a function")
                          .note(symbol.range, "declared here")
                          .help("write `" + name.text + "(...)` with its arguments"));
      return nullptr;
    case Sort::zone:
    case Sort::robot_kind:
    case Sort::fleet:
    case Sort::site:
    case Sort::controller:
    case Sort::monitor:
    case Sort::watch:
    case Sort::decision:
    case Sort::enumeration:
    case Sort::frame:
      return not_a_quantity(expr, a_name_of(symbol.sort));
    case Sort::agent:
    case Sort::agents:
      return agent_as_value(expr, name);
  }
  return nullptr;
}

bool PropertyChecker::signal_allowed(const SourceRange& range, const syntax::Name& name,
                                     Sort sort) {
  if (function_ == nullptr || sort != Sort::input) return true;
  std::string help =
      "a function depends on its arguments alone: add a parameter for `" + name.text + "`";
  const Symbol* symbol = context_.symbols.find(name.text);
  if (symbol != nullptr && context_.input_types[symbol->index].kind == TypeKind::path) {
    help = "no argument is a path: pass what is made of it, `distance(" + name.text +
           ", p)` as a length or `" + name.text +
           " inside Z` as a condition, or judge it in the "
           "monitor itself";
  }
  context_.report(Finding(Code::function_not_pure, range,
                          "the function `" + function_->node->name.text + "` uses the input `" +
                              name.text + "`")
                      .label("not an argument of the function")
                      .help(help));
  return false;
}

namespace {

// The value of one element of an input, its components beginning at `first`.
Value element_value(const SourceRange& range, const Input& declared, InputId input,
                    const ValueType& type, std::uint32_t first) {
  const auto quantity = [&](std::uint32_t component) {
    return make_quantity(range, declared.measurement(component).dimension,
                         InputRef{input, component});
  };
  switch (type.kind) {
    case TypeKind::boolean:
      return make_condition(range, InputRef{input, first});
    case TypeKind::integer:
    case TypeKind::real:
      return quantity(first);
    case TypeKind::enumeration:
      return EnumSignal{*type.enumeration, InputRef{input, first}};
    case TypeKind::point:
    case TypeKind::vector:
      return Pair{type.kind == TypeKind::point ? Pair::Kind::point : Pair::Kind::vector,
                  quantity(first), quantity(first + 1), type.space ? quantity(first + 2) : nullptr,
                  type.frame};
    case TypeKind::pose:
      return Pose{{Pair::Kind::point, quantity(first), quantity(first + 1), nullptr, type.frame},
                  quantity(first + 2),
                  type.of};
    case TypeKind::twist:
      return Twist{quantity(first), quantity(first + 1)};
    case TypeKind::path:
      return Way{{}, input, false, type.frame};
    case TypeKind::zone:  // stands for no value
      break;
  }
  return nullptr;
}

}  // namespace

Value PropertyChecker::input_value(const SourceRange& range, InputId input) {
  context_.used_inputs.insert(input);
  if (context_.faulty_inputs.count(input) > 0) return nullptr;
  const ValueType& type = context_.input_types[index_of(input)];
  const Input& declared = context_.spec[input];
  if (!type.length || type.kind == TypeKind::path) {
    return element_value(range, declared, input, type, 0);
  }
  Array array;
  for (std::uint32_t i = 0; i < *type.length; ++i) {
    array.elements.push_back(
        element_value(range, declared, input, type, i * declared.element_size));
  }
  return array;
}

Value PropertyChecker::param_value(const SourceRange& range, ParamId param) {
  context_.used_params.insert(param);
  if (context_.faulty_params.count(param) > 0) return nullptr;
  return make_quantity(range, context_.spec[param].dimension, ParamRef{param});
}

Value PropertyChecker::enum_member(const syntax::Member& member, EnumId type) {
  const Enumeration& enumeration = context_.spec[type];
  const auto found =
      std::find(enumeration.values.begin(), enumeration.values.end(), member.field.text);
  if (found != enumeration.values.end()) {
    return EnumValue{type, static_cast<std::uint32_t>(found - enumeration.values.begin())};
  }
  if (context_.damaged(enumeration.name_range) || member.field.text.empty()) return nullptr;
  context_.report(Finding(Code::member_unknown, member.field.range,
                          "`" + enumeration.name + "` has no value `" + member.field.text + "`")
                      .label("not a value")
                      .note(enumeration.name_range, "declared here")
                      .help(did_you_mean(member.field.text, enumeration.values, "values")));
  return nullptr;
}

namespace {

// Moves a component out of a value; nothing: it has none of this name.
Value component(Pair& pair, const std::string& name) {
  if (name == "x") return std::move(pair.x);
  if (name == "y") return std::move(pair.y);
  if (!pair.z) return nullptr;
  if (name == "z") return std::move(pair.z);
  if (name != "xy") return nullptr;
  return Pair{pair.kind, std::move(pair.x), std::move(pair.y), nullptr, pair.frame};
}

Value component(Value& base, const std::string& name) {
  if (auto* pair = std::get_if<Pair>(&base.node)) return component(*pair, name);
  if (auto* pose = std::get_if<Pose>(&base.node)) {
    if (name == "position") return std::move(pose->position);
    if (name == "heading") return std::move(pose->heading);
  }
  if (auto* twist = std::get_if<Twist>(&base.node)) {
    if (name == "linear") return std::move(twist->linear);
    if (name == "angular") return std::move(twist->angular);
  }
  return nullptr;
}

std::string components_of(const Value& base) {
  const auto* pair = std::get_if<Pair>(&base.node);
  if (pair != nullptr) return pair->z ? "`x`, `y`, `z`, and `xy` in the plane" : "`x` and `y`";
  if (std::holds_alternative<Pose>(base.node)) return "`position` and `heading`";
  if (std::holds_alternative<Twist>(base.node)) return "`linear` and `angular`";
  return "";
}

}  // namespace

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Member& member) {
  if (is_error(*member.base)) return nullptr;
  if (sees_fleets() && names_robot(*member.base)) return robot_signal(expr, member);
  if (is_altitude(member)) return altitude(expr);
  const syntax::Name* name = name_in(*member.base);
  const Symbol* symbol = name != nullptr ? context_.symbols.find(name->text) : nullptr;
  const bool bound = name != nullptr && local(name->text) != nullptr;
  if (!bound && symbol != nullptr && symbol->sort == Sort::enumeration) {
    return enum_member(member, EnumId{symbol->index});
  }
  const bool robot = symbol != nullptr && symbol->sort == Sort::robot;
  const bool signal = symbol != nullptr && (symbol->sort == Sort::input);
  const bool of_robot = sees_robot() && name != nullptr && !signal;
  if (!bound && (of_robot || robot)) return robot_member(expr, member);
  std::vector<Sort> also = places_of_robots();
  also.push_back(Sort::enumeration);
  if (!place_known(*member.base, also)) return nullptr;
  Value base = infer(*member.base);
  if (!base) return nullptr;
  if (Value part = component(base, member.field.text)) return part;
  if (member.field.text.empty()) return nullptr;
  const std::string& field = member.field.text;
  const bool of_place = std::holds_alternative<Pose>(base.node) && (field == "x" || field == "y");
  const std::string components =
      components_of(base) + (of_place ? "; write `.position." + field + "`" : "");
  context_.report(
      Finding(Code::member_unknown, member.field.range,
              describe(context_.spec, base) + " has no component `" + member.field.text + "`")
          .label("no such component")
          .help(components.empty() ? "only points, vectors, poses and twists have components, such "
                                     "as `p.x`; elements of an array are written `a[0]`"
                                   : "the components are " + components));
  return nullptr;
}

// The place in an array that the index names.
std::optional<std::size_t> PropertyChecker::place_in(const syntax::Index& index,
                                                     std::size_t length) {
  if (is_error(*index.index)) return std::nullopt;
  if (name_in(*index.index) != nullptr) {
    context_.report(
        Finding(Code::not_constant, index.index->range,
                "the index of an array must be known at compile time")
            .label("not a constant")
            .help("a whole number from 0 to " + std::to_string(length - 1) +
                  " works; to choose at run time, write `if n == 0 then a[0] else ...`"));
    return std::nullopt;
  }
  const auto place =
      count(context_, *index.index, "the index of an array", 0, static_cast<int>(length) - 1);
  return place ? std::optional(static_cast<std::size_t>(*place)) : std::nullopt;
}

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Index& index) {
  // One element is taken out of a bound array without a copy of the others.
  const syntax::Name* name = name_in(*index.base);
  const Local* bound = name != nullptr ? local(name->text) : nullptr;
  const auto* held = bound != nullptr ? std::get_if<Array>(&bound->value.node) : nullptr;
  if (held != nullptr) {
    const auto place = place_in(index, held->elements.size());
    return place ? clone(held->elements[*place]) : Value();
  }
  if (unit_in_brackets(expr, index)) return nullptr;
  Value base = infer(*index.base);
  auto* array = std::get_if<Array>(&base.node);
  if (std::holds_alternative<Way>(base.node)) {
    return wrong_operand(expr.range, "the way-points of a path are not judged one by one",
                         "judge all of it, `" + print_expr(*index.base) +
                             " inside Z`, or `leg(p, plan)`, the way to the next way-point; a "
                             "place of its own is an `input next : point max_age 1 s;`");
  }
  if (base && array == nullptr) {
    return wrong_operand(expr.range,
                         describe(context_.spec, base) + " has no elements to choose from",
                         "only an array has: declare it as `input ... : real[4]`");
  }
  if (!base) return nullptr;
  const auto place = place_in(index, array->elements.size());
  return place ? std::move(array->elements[*place]) : Value();
}

Value PropertyChecker::form(const syntax::Expr&, const syntax::Let& let) {
  const int outer = polarity_;
  polarity_ = 0;
  Value value = infer(*let.value);
  polarity_ = outer;
  const syntax::Name& name = let.name;
  const Symbol* hidden = context_.symbols.find(name.text);
  const Local* bound = local(name.text);
  const bool robot = sees_robot() && (name.text == scope_.self.text ||
                                      (other_ != nullptr && name.text == other_->text));
  if (hidden != nullptr || bound != nullptr || robot) {
    Finding finding(Code::duplicate_name, name.range, "the name `" + name.text + "` is taken");
    finding.label("the second meaning").help("give the value a name of its own");
    if (hidden != nullptr || bound != nullptr) {
      finding.note(hidden != nullptr ? hidden->range : bound->range,
                   "`" + name.text + "` is declared here");
    }
    context_.report(finding);
    return nullptr;
  }
  if (value && depth_of(value) > static_cast<std::size_t>(max_depth)) {
    report_limit(let.value->range, "the value of `" + name.text + "` is nested too deeply",
                 std::to_string(max_depth) + " levels");
    return nullptr;
  }
  locals_.push_back({name.text, name.range, std::move(value)});
  Value body = infer(*let.body);
  locals_.pop_back();
  return body;
}

}  // namespace rtac::sema
