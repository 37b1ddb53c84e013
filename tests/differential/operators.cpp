#include "tests/differential/operators.h"

#include <algorithm>
#include <map>

namespace rtac::differential {
namespace {

using List = std::vector<Operator>;
constexpr Type condition = Type::condition;

void add_connectives(List& all) {
  const auto unary = [&](const char* name, const char* text) {
    all.push_back({name, text, condition, {condition}});
  };
  const auto binary = [&](const char* name, const char* text) {
    all.push_back({name, text, condition, {condition, condition}});
  };
  unary("not", "not $1");
  binary("and", "$1 and $2");
  binary("or", "$1 or $2");
  binary("implies", "$1 implies $2");
  binary("iff", "$1 iff $2");
  binary("xor", "$1 xor $2");
  binary("==", "$1 == $2");
  binary("!=", "$1 != $2");
  unary("let", "let $v = $1 in ($v iff previously $v)");
  binary("call", "unless($1, $2)");
  unary("forall", "forall $v : Rover : ($v.battery >= 20 % or $1)");
  unary("exists", "exists $v : Rover, $v != one : ($v.battery >= 50 % and $1)");
  all.push_back({"if", "if $1 then $2 else $3", condition, {condition, condition, condition}});
  all.push_back({"count of a fleet",
                 "count($v : Rover : ($v.battery >= 30 % or $1))",
                 Type::whole,
                 {condition}});
}

void add_past(List& all) {
  const auto past = [&](const std::string& name, const std::string& text) {
    std::vector<Type> operands{condition};
    if (text.find("$2") != std::string::npos) operands.push_back(condition);
    all.push_back({name, text, condition, std::move(operands)});
  };
  past("previously", "previously $1");
  for (const std::string window : {"[1 s, 2 s]", "[1 s, inf]", "[0 s, 0 s]"}) {
    past("once" + window, "once" + window + " $1");
    past("historically" + window, "historically" + window + " $1");
    past("since" + window, "$1 since" + window + " $2");
  }
  past("for", "$1 for 1 s");
  past("within", "$1 within 1 s of $2");
  all.push_back({"count over time", "count[0 s, 2 s]($1)", Type::whole, {condition}});
}

std::string with(std::string text, const std::string& unit) {
  const std::string blank = unit.empty() ? "" : " " + unit;
  for (std::size_t at; (at = text.find(" U")) != std::string::npos;) text.replace(at, 2, blank);
  return text;
}

// What every quantity has.
void add_quantity(List& all, Type type) {
  const std::string unit = scale_of(type)->unit;
  for (const std::string op : {"<", "<=", ">", ">="}) {
    all.push_back({op, "$1 " + op + " $2", condition, {type, type}});
  }
  const auto add = [&](const char* name, const char* text) {
    std::vector<Type> operands{type};
    if (std::string(text).find("$2") != std::string::npos) operands.push_back(type);
    all.push_back({name, with(text, unit), type, std::move(operands)});
  };
  add("+", "($1 + $2)");
  add("-", "($1 - $2)");
  add("sign", "(-$1)");
  add("abs", "abs($1)");
  add("min", "min($1, $2)");
  add("max", "max($1, $2)");
  add("clamp", type == Type::heat ? "clamp($1, $2, 310 U)" : "clamp($1, $2, 2 U)");
  add("min over time", "min[1 s, 2 s]($1)");
  add("max over time", "max[0 s, 2 s]($1)");
  add("sum over time", "sum[0 s, 2 s]($1)");
  add("let", "(let $v = $1 in ($v + min[1 s, 1 s]($v)))");
  all.push_back({"if", "(if $1 then $2 else $3)", type, {condition, type, type}});
  if (type == Type::whole) return;
  add("mean over time", "mean[0 s, 2 s]($1)");
  add("rate", "(rate[0 s, 2 s]($1) * 1 s)");
  add("/", type == Type::number ? "($1 / 4)" : "($1 / 3)");
  all.push_back({"*", "($1 * $2)", type, {Type::number, type}});
}

void add_quantities(List& all) {
  for (const Type type : {Type::whole, Type::number, Type::length, Type::area, Type::angle,
                          Type::time, Type::speed, Type::share, Type::heat}) {
    add_quantity(all, type);
  }
  const auto equal = [&](Type type) {
    all.push_back({"==", "$1 == $2", condition, {type, type}});
    all.push_back({"!=", "$1 != $2", condition, {type, type}});
  };
  equal(Type::whole);
  equal(Type::gear);
  all.push_back({"if", "(if $1 then $2 else $3)", Type::gear, {condition, Type::gear, Type::gear}});
  all.push_back({"*", "($1 * $2)", Type::whole, {Type::whole, Type::whole}});
  all.push_back({"mean over time", "mean[0 s, 2 s]($1)", Type::number, {Type::whole}});
  all.push_back({"rate", "(rate[0 s, 2 s]($1) * 1 s)", Type::number, {Type::whole}});
  all.push_back({"*", "($1 * $2)", Type::area, {Type::length, Type::length}});
  all.push_back({"/", "($1 / 2 m)", Type::number, {Type::length}});
  all.push_back({"/", "($1 / 2 m)", Type::length, {Type::area}});
  all.push_back({"sqrt", "sqrt(max($1, 0))", Type::number, {Type::number}});
  all.push_back({"sqrt", "sqrt(abs($1))", Type::length, {Type::area}});
  all.push_back({"call", "twice($1)", Type::number, {Type::number}});
  all.push_back({"call", "far($1, $2)", condition, {Type::length, Type::length}});
  all.push_back({"age", "min(age(c), 9 s)", Type::time, {}});
  all.push_back({"element", "t[1]", Type::heat, {}});
  all.push_back({"min of an array", "min(t)", Type::heat, {}});
  all.push_back({"max of an array", "max(t)", Type::heat, {}});
}

void add_places(List& all) {
  const Type length = Type::length, vector = Type::vector, point = Type::point;
  const std::vector<Operator> more = {
      {"+", "($1 + $2)", vector, {vector, vector}},
      {"-", "($1 - $2)", vector, {vector, vector}},
      {"-", "($1 - $2)", vector, {point, point}},
      {"+", "($1 + $2)", point, {point, vector}},
      {"sign", "(-$1)", vector, {vector}},
      {"*", "($1 * $2)", vector, {Type::number, vector}},
      {"/", "($1 / 3)", vector, {vector}},
      {"if", "(if $1 then $2 else $3)", vector, {condition, vector, vector}},
      {"if", "(if $1 then $2 else $3)", point, {condition, point, point}},
      {"if", "(if $1 then $2 else $3)", Type::spot, {condition, Type::spot, Type::spot}},
      {"if", "(if $1 then $2 else $3)", Type::pose, {condition, Type::pose, Type::pose}},
      {"if", "(if $1 then $2 else $3)", Type::twist, {condition, Type::twist, Type::twist}},
      {"let", "(let $v = $1 in ($v + 2 * $v))", vector, {vector}},
      {"call", "mirrored($1)", vector, {vector}},
      {"component", "$1.x", length, {vector}},
      {"component", "$1.y", length, {point}},
      {"component", "$1.x", length, {Type::spot}},
      {"component", "$1.linear", Type::speed, {Type::twist}},
      {"component", "$1.heading", Type::angle, {Type::pose}},
      {"component", "$1.position", point, {Type::pose}},
      {"norm", "norm($1)", length, {vector}},
      {"dot", "dot($1, $2)", Type::area, {vector, vector}},
      {"cross", "cross($1, $2)", Type::area, {vector, vector}},
      {"distance", "distance($1, $2)", length, {point, point}},
      {"distance", "distance($1, $2)", length, {Type::spot, Type::spot}},
      {"distance to a zone", "distance($1, pond)", length, {point}},
      {"clearance", "clearance($1, yard)", length, {point}},
      {"inside", "$1 inside bend", condition, {point}},
      {"rotate", "rotate($1, $2)", vector, {vector, Type::angle}},
      {"transform", "transform($1, $2)", Type::turned, {Type::pose, Type::spot}},
      {"transform", "transform(j, $1)", Type::spot, {point}},
  };
  all.insert(all.end(), more.begin(), more.end());
}

void add_space(List& all) {
  const Type vector = Type::vector3, point = Type::point3;
  const std::vector<Operator> more = {
      {"+", "($1 + $2)", vector, {vector, vector}},
      {"-", "($1 - $2)", vector, {point, point}},
      {"*", "($1 * $2)", vector, {Type::number, vector}},
      {"cross", "(cross($1, $2) / 1 m)", vector, {vector, vector}},
      {"dot", "dot($1, $2)", Type::area, {vector, vector}},
      {"norm", "norm($1)", Type::length, {vector}},
      {"distance", "distance($1, $2)", Type::length, {point, point}},
      {"if", "(if $1 then $2 else $3)", point, {condition, point, point}},
      {"distance to a zone", "distance($1, shaft)", Type::length, {point}},
      {"clearance", "clearance($1, loft)", Type::length, {point}},
      {"inside", "$1 inside loft", condition, {point}},
      {"component", "$1.z", Type::length, {point}},
      {"component", "$1.xy", Type::point, {point}},
  };
  all.insert(all.end(), more.begin(), more.end());
}

void add_robots(List& all) {
  const std::vector<Operator> more = {
      {"signal of a robot", "one.battery", Type::share, {}},
      {"signal of a robot", "bots[1].speed", Type::speed, {}},
      {"signal of a robot", "two.position.x", Type::length, {}},
      {"distance of robots", "distance(one, two)", Type::length, {}},
      {"distance of a robot", "distance(bots[0], $1)", Type::length, {Type::near}},
      {"min of a fleet", "min($v : Rover : $v.speed + $1)", Type::speed, {Type::speed}},
      {"max of a fleet", "max($v : Rover : $v.battery - $1)", Type::share, {Type::share}},
      {"min of a fleet",
       "min($v : Rover, $v != one : distance(one, $v) + $1)",
       Type::length,
       {Type::length}},
  };
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

const List& operators() {
  static const List made = [] {
    List all;
    add_connectives(all);
    add_past(all);
    add_quantities(all);
    add_places(all);
    add_space(all);
    add_robots(all);
    return all;
  }();
  return made;
}

bool fits(Type given, Type due) {
  const bool is_point = given == Type::point || given == Type::turned;
  return given == due || (given == Type::whole && due == Type::number) ||
         (is_point && due == Type::point) || (given == Type::point && due == Type::near);
}

const std::string& leaf(Type type, std::size_t k) {
  static const std::map<Type, std::vector<std::string>> all = {
      {Type::condition, {"a", "b", "c"}},
      {Type::gear, {"g", "w", "drive"}},
      {Type::whole, {"n", "k", "(2 - k)"}},
      {Type::number, {"x", "y", "z"}},
      {Type::length, {"d", "p.x", "q.y"}},
      {Type::area, {"(d * p.y)", "(q.x * q.x)", "(q.y * s.z)"}},
      {Type::angle, {"o", "i.heading", "j.heading"}},
      {Type::time, {"min(age(y), 9 s)", "min(age(a), 9 s)", "min(age(q), 9 s)"}},
      {Type::speed, {"v", "e.linear", "f.linear"}},
      {Type::share, {"r", "two.battery", "bots[0].battery"}},
      {Type::heat, {"t[0]", "(600 K - t[2])", "t[1]"}},
      {Type::vector, {"(p - q)", "(q - (1 m, 0 m))", "(s.xy - p)"}},
      {Type::point, {"p", "q", "s.xy"}},
      {Type::near, {"p", "q", "s.xy"}},
      {Type::spot, {"l", "transform(j, p)"}},
      {Type::vector3, {"(s - (1 m, 0 m, 0 m))", "((0 m, 1 m, 0 m) - s)", "(s - (0 m, 0 m, 1 m))"}},
      {Type::point3, {"s", "(s + (s - (1 m, 0 m, 0 m)))"}},
      {Type::pose, {"i", "m"}},
      {Type::twist, {"e", "f"}},
  };
  const auto& some = all.at(type);
  return some[k % some.size()];
}

std::string applied(const Operator& op, const std::vector<std::string>& operands, int depth) {
  std::string text;
  for (std::size_t i = 0; i < op.text.size(); ++i) {
    if (op.text[i] != '$') {
      text += op.text[i];
      continue;
    }
    const char which = op.text[++i];
    if (which == 'v') {
      text += "v" + std::to_string(depth);
      continue;
    }
    const auto at = static_cast<std::size_t>(which - '1');
    text += op.operands[at] == Type::condition ? "(" + operands[at] + ")" : operands[at];
  }
  return text;
}

const Scale* scale_of(Type type) {
  static const std::map<Type, Scale> all = {
      {Type::whole, {"", 1}},     {Type::number, {"", 20}},   {Type::length, {"m", 20}},
      {Type::area, {"m^2", 20}},  {Type::angle, {"rad", 20}}, {Type::time, {"s", 4}},
      {Type::speed, {"m/s", 20}}, {Type::share, {"%", 2}},    {Type::heat, {"K", 2}},
  };
  const auto found = all.find(type);
  return found == all.end() ? nullptr : &found->second;
}

}  // namespace rtac::differential
