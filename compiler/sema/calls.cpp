// Calls: built-in functions of quantities, points and vectors.
#include <algorithm>

#include "compiler/sema/property_checker.h"
#include "compiler/sema/suggest.h"
#include "compiler/syntax/habits.h"

namespace rtac::sema {

const std::vector<std::string>& functions_of_quantities() {
  static const std::vector<std::string> names{"min",       "max",   "abs",   "sqrt", "norm",
                                              "dot",       "cross", "clamp", "age",  "rotate",
                                              "transform", "leg",   "path"};
  return names;
}

namespace {

// The exact root of a square; nullopt when it is not a rational number.
std::optional<Rational> exact_root(const Rational& value) {
  if (sgn(value) < 0) return std::nullopt;
  const mpz_class above = sqrt(value.get_num());
  const mpz_class below = sqrt(value.get_den());
  if (above * above != value.get_num() || below * below != value.get_den()) return std::nullopt;
  return Rational(above, below);
}

std::optional<Rational> fold_math(MathOp op, const std::vector<ExprPtr>& operands) {
  std::vector<Rational> values;
  for (const ExprPtr& operand : operands) {
    const auto value = constant_of(*operand);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  Rational result = values.front();
  switch (op) {
    case MathOp::minimum:
      for (const Rational& each : values) result = each < result ? each : result;
      return result;
    case MathOp::maximum:
      for (const Rational& each : values) result = each > result ? each : result;
      return result;
    case MathOp::absolute:
      return Rational(abs(result));
    case MathOp::square_root:
      return exact_root(result);
    case MathOp::norm: {
      Rational squares = 0;
      for (const Rational& each : values) squares += each * each;
      return exact_root(squares);
    }
    case MathOp::sine:
    case MathOp::cosine:
      // of 0 alone it is a rational number
      if (sgn(result) == 0) return Rational(op == MathOp::sine ? 0 : 1);
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Dimension> root_of(const Dimension& dimension) {
  Dimension root;
  for (int Dimension::*base : {&Dimension::m, &Dimension::s, &Dimension::kg, &Dimension::rad,
                               &Dimension::ratio, &Dimension::A, &Dimension::K}) {
    if (dimension.*base % 2 != 0) return std::nullopt;
    root.*base = dimension.*base / 2;
  }
  return root;
}

}  // namespace

Value PropertyChecker::form(const syntax::Expr& expr, const syntax::Call& call) {
  const std::string& name = call.callee.text;
  const Symbol* symbol = context_.symbols.find(name);
  if (context_.refused_functions.count(name) > 0) return nullptr;
  if (symbol != nullptr && symbol->sort == Sort::function) {
    return call_function(expr, call, symbol->index);
  }
  if (name == "min") return minimum_or_maximum(expr, call, MathOp::minimum);
  if (name == "max") return minimum_or_maximum(expr, call, MathOp::maximum);
  if (name == "abs") return absolute(expr, call);
  if (name == "sqrt") return square_root(expr, call);
  if (name == "norm") return norm(expr, call);
  if (name == "dot") return dot(expr, call);
  if (name == "cross") return cross(expr, call);
  if (name == "rotate") return rotate(expr, call);
  if (name == "transform") return transform(expr, call);
  if (name == "clamp") return clamp(expr, call);
  if (name == "age") return age(expr, call);
  if (name == "leg" || name == "path") return way_of(expr, call);
  for (const syntax::ExprPtr& each : call.arguments) {
    const bool takes_ways = name == "distance" || name == "clearance";
    if (takes_ways && sees_robot() && says_way(*each) && !ways_allowed(*each)) return nullptr;
  }
  const bool of_points = std::any_of(
      call.arguments.begin(), call.arguments.end(),
      [&](const syntax::ExprPtr& each) { return speaks_of_points(*each) && !names_zone(*each); });
  if (name == "distance" && sees_robot() && of_points) return distance_of_points(expr, call);
  if (name == "distance" && !sees_robot()) {
    if (!places_known(call.arguments)) return nullptr;
    const auto any = [&](const auto& is) {
      return std::any_of(call.arguments.begin(), call.arguments.end(), is);
    };
    if (any([&](const syntax::ExprPtr& each) { return says_way(*each); })) {
      return distance_of_ways(expr, call);
    }
    if (any([&](const syntax::ExprPtr& each) { return says_zone(*each); })) {
      return distance_to_zone(expr, call);
    }
    const bool bodies = any([&](const syntax::ExprPtr& each) { return names_robot(*each); });
    return bodies && sees_fleets() ? distance_of_bodies(expr, call)
                                   : distance_of_points(expr, call);
  }
  for (const std::string& aggregate : aggregate_names()) {
    if (name != aggregate) continue;
    context_.report(Finding(Code::wrong_argument, expr.range, "`" + name + "` needs a window")
                        .label("over which time?")
                        .help("write `" + name +
                              "[0 s, 1 s](...)` with the times between which it "
                              "looks back"));
    return nullptr;
  }
  return robot_call(expr, call);
}

Value PropertyChecker::other_call(const syntax::Expr& expr, const syntax::Call& call,
                                  const Symbol* symbol) {
  const std::string& name = call.callee.text;
  std::vector<std::string> known{"clearance", "distance", "energy_to",
                                 "shrink",    "grow",     "complement"};
  if (!sees_robot()) known = {"clearance", "distance", "shrink", "grow", "complement"};
  for (const auto* more : {&functions_of_quantities(), &aggregate_names()}) {
    for (const std::string& each : *more) {
      if (std::find(known.begin(), known.end(), each) == known.end()) known.push_back(each);
    }
  }
  for (std::string& each : context_.symbols.names_of(Sort::function)) {
    known.push_back(std::move(each));
  }
  if (symbol != nullptr && symbol->sort == Sort::site && sees_robot()) {
    context_.report(
        Finding(Code::quantity_expected, expr.range, "`" + name + "` is a place, not a quantity")
            .label("a place")
            .help("write `energy_to(" + name + "(" + scope_.self.text + "))`"));
  } else if (symbol != nullptr) {
    context_.report(Finding(Code::wrong_sort, call.callee.range,
                            "`" + name + "` is " + a_name_of(symbol->sort) + ", not a function")
                        .label("not a function")
                        .note(symbol->range, "`" + name + "` is declared here")
                        .help("the functions are " + listing(known)));
  } else if (context_.first_unknown(call.callee)) {
    Finding finding(Code::unknown_function, call.callee.range,
                    "there is no function `" + name + "`");
    finding.label("not a function");
    if (!context_.may_suggest()) {
      finding.help(Context::without_suggestion());
    } else if (is_outside_scope(name)) {
      finding.help(
          "integers cannot compute it: compute it outside, and pass it as `input ... error e`");
    } else if (const auto habit = syntax::function_habit(name)) {
      finding.help(std::string(*habit));
    } else {
      finding.help(did_you_mean(name, known, "functions"));
      if (const auto likely = nearest(name, known)) finding.replace(call.callee.range, *likely);
    }
    context_.report(finding);
  }
  return nullptr;
}

std::optional<std::vector<ExprPtr>> PropertyChecker::quantities(
    const std::vector<syntax::ExprPtr>& arguments, const std::string& user) {
  std::vector<ExprPtr> typed;
  std::vector<const syntax::Expr*> written;
  std::vector<const Expr*> views;
  bool good = true;
  bool misfit = false;  // one report stands for all values that are no quantities
  for (const syntax::ExprPtr& argument : arguments) {
    const auto due =
        views.empty() ? std::nullopt : std::optional<Dimension>(views.front()->dimension);
    const bool is_place = says_robot(*argument) || says_zone(*argument);
    if (misfit && is_place) continue;
    Value value = infer(*argument, due);
    auto* typed_value = std::get_if<ExprPtr>(&value.node);
    const bool fits = typed_value != nullptr && !(*typed_value)->boolean;
    const bool misfits = is_place || (value && !fits);
    ExprPtr quantity = misfits && misfit ? nullptr : as_quantity(*argument, std::move(value));
    misfit = misfit || misfits;
    good = good && quantity != nullptr;
    if (!quantity) continue;
    written.push_back(argument.get());
    views.push_back(quantity.get());
    typed.push_back(std::move(quantity));
  }
  if (!good || !one_dimension(user, written, views)) return std::nullopt;
  return typed;
}

bool PropertyChecker::one_dimension(const std::string& user,
                                    const std::vector<const syntax::Expr*>& written,
                                    const std::vector<const Expr*>& typed) {
  for (std::size_t i = 1; i < typed.size(); ++i) {
    if (typed[i]->dimension == typed.front()->dimension) continue;
    const Dimension& one = typed.front()->dimension;
    const Dimension& other = typed[i]->dimension;
    const syntax::Expr* first_bare = bare_number(*written.front());
    const syntax::Expr* this_bare = bare_number(*written[i]);
    if (this_bare != nullptr && other == dims::number) {
      report_unit_missing(context_, *this_bare, one, user + " has " + describe(one) + " elsewhere");
    } else if (first_bare != nullptr && one == dims::number) {
      report_unit_missing(context_, *first_bare, other,
                          user + " has " + describe(other) + " elsewhere");
    } else {
      context_.report(Finding(Code::dimensions_differ, written[i]->range,
                              user + " joins " + describe(one) + " and " + describe(other))
                          .label("this is " + describe(other))
                          .note(written.front()->range, "this is " + describe(one))
                          .help("bring both to one dimension"));
    }
    return false;
  }
  return true;
}

Value PropertyChecker::math(const syntax::Expr& expr, MathOp op, const Dimension& dimension,
                            std::vector<ExprPtr> operands, const std::string& instead) {
  if (const auto value = fold_math(op, operands)) {
    return make_quantity(expr.range, dimension, Constant{*value});
  }
  return judged_now(make_quantity(expr.range, dimension, Math{op, std::move(operands)}),
                    "this function", instead);
}

// Of two or more quantities, or of the elements of one array.
Value PropertyChecker::minimum_or_maximum(const syntax::Expr& expr, const syntax::Call& call,
                                          MathOp op) {
  const std::string& name = call.callee.text;
  if (call.arguments.size() != 1) {
    if (call.arguments.empty()) {
      argument_count(expr, call, 2, name + "(a, b)`, or over a window `" + name + "[0 s, 1 s](x)");
      return nullptr;
    }
    auto operands = quantities(call.arguments, "`" + name + "`");
    if (!operands) return nullptr;
    const Dimension dimension = operands->front()->dimension;
    const std::string instead =
        op == MathOp::minimum
            ? "`min(a, b) >= c` is `a >= c and b >= c`, and `min(a, b) <= c` is `a <= c or b <= c`"
            : "`max(a, b) <= c` is `a <= c and b <= c`, and `max(a, b) >= c` is `a >= c or b >= c`";
    return math(expr, op, dimension, std::move(*operands), instead);
  }
  Value value = infer(*call.arguments.front());
  auto* array = std::get_if<Array>(&value.node);
  if (!value) return nullptr;
  if (array == nullptr) {
    argument_count(expr, call, 2, name + "(a, b)");
    return nullptr;
  }
  if (!affordable(expr, array->elements.size())) return nullptr;
  std::vector<ExprPtr> operands;
  for (Value& element : array->elements) {
    auto* quantity = std::get_if<ExprPtr>(&element.node);
    if (quantity == nullptr || (*quantity)->boolean) {
      return not_a_quantity(*call.arguments.front(),
                            "an array, each element " + describe(context_.spec, element));
    }
    operands.push_back(std::move(*quantity));
  }
  const Dimension dimension = operands.front()->dimension;
  if (operands.size() == 1) return std::move(operands.front());
  return math(expr, op, dimension, std::move(operands));
}

Value PropertyChecker::absolute(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 1, "abs(x)")) return nullptr;
  ExprPtr operand = quantity_of(*call.arguments.front());
  if (!operand) return nullptr;
  const Dimension dimension = operand->dimension;
  return math(expr, MathOp::absolute, dimension, operands_of(std::move(operand)));
}

Value PropertyChecker::square_root(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 1, "sqrt(x)")) return nullptr;
  const syntax::Expr& written = *call.arguments.front();
  ExprPtr operand = quantity_of(written);
  if (!operand) return nullptr;
  const auto dimension = root_of(operand->dimension);
  if (!dimension) {
    context_.report(Finding(Code::wrong_dimension, written.range,
                            "the square root of " + describe(operand->dimension) + " has no unit")
                        .label("not a square")
                        .help("take the root of a square, such as an area (m^2)"));
    return nullptr;
  }
  const auto value = constant_of(*operand);
  if (value && sgn(*value) < 0) {
    context_.report(
        Finding(Code::quantity_out_of_range, written.range,
                "the square root of " + show(*value, operand->dimension) + " does not exist")
            .label("must be 0 or more")
            .help("a value of 0 or more works"));
    return nullptr;
  }
  return math(expr, MathOp::square_root, *dimension, operands_of(std::move(operand)));
}

std::optional<Pair> PropertyChecker::pair_of(const syntax::Expr& expr, Pair::Kind due,
                                             const std::string& user) {
  return as_pair(expr, infer(expr), due, user);
}

std::optional<Pair> PropertyChecker::as_pair(const syntax::Expr& expr, Value value, Pair::Kind due,
                                             const std::string& user) {
  if (!value) return std::nullopt;
  auto* pair = std::get_if<Pair>(&value.node);
  if (pair != nullptr && (pair->kind == due || pair->kind == Pair::Kind::literal)) {
    return std::move(*pair);
  }
  const bool point = due == Pair::Kind::point;
  const bool other_pair = pair != nullptr;
  context_.report(Finding(Code::wrong_argument, expr.range,
                          "`" + user + "` takes " + (point ? "points" : "vectors") + ", this is " +
                              describe(context_.spec, value))
                      .label(std::string("not a ") + (point ? "point" : "vector"))
                      .help(point ? (other_pair ? "write `norm(v)` for the length of a vector"
                                                : "write an input of type `point`, or `(1 m, 2 m)`")
                                  : (other_pair ? "the difference of two points is a vector: write "
                                                  "`p - (0 m, 0 m)`"
                                                : "write an input of type `vector`, or the "
                                                  "difference of two points")));
  return std::nullopt;
}

Value PropertyChecker::clamp(const syntax::Expr& expr, const syntax::Call& call) {
  if (!argument_count(expr, call, 3, "clamp(x, low, high)")) return nullptr;
  auto operands = quantities(call.arguments, "`clamp`");
  if (!operands) return nullptr;
  const auto low = constant_of(*(*operands)[1]);
  const auto high = constant_of(*(*operands)[2]);
  const Dimension dimension = operands->front()->dimension;
  if (low && high && *low > *high) {
    SourceRange both = call.arguments[1]->range;
    both.end = call.arguments[2]->range.end;
    context_.report(Finding(Code::range_empty, both,
                            "`clamp` between " + show(*low, dimension) + " and " +
                                show(*high, dimension) + " leaves nothing")
                        .label("the lower bound is above the upper one")
                        .help("write `clamp(x, low, high)`"));
    return nullptr;
  }
  Value raised = math(expr, MathOp::maximum, dimension,
                      operands_of(std::move((*operands)[0]), std::move((*operands)[1])));
  auto* inner = std::get_if<ExprPtr>(&raised.node);
  if (inner == nullptr) return nullptr;
  return math(expr, MathOp::minimum, dimension,
              operands_of(std::move(*inner), std::move((*operands)[2])));
}

}  // namespace rtac::sema
