#include "tests/differential/generator.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

namespace rtac::differential {
namespace {

using Kind = Signal::Kind;

std::string call(const std::string& function, const std::string& a) {
  return function + "(" + a + ")";
}
std::string call(const std::string& function, const std::string& a, const std::string& b) {
  return function + "(" + a + ", " + b + ")";
}
std::string joined(const std::string& a, const std::string& op, const std::string& b) {
  return "(" + a + " " + op + " " + b + ")";
}

}  // namespace

std::string decimal(Micro value) {
  constexpr Micro one = 1000000;
  const Micro size = value < 0 ? -value : value;
  std::string fraction = std::to_string(one + size % one).substr(1);
  return (value < 0 ? "-" : "") + std::to_string(size / one) + "." + fraction;
}

// Some limits lie between two steps of their grids.
const std::vector<Signal>& signals() {
  constexpr Micro one = 1000000, milli = 1000, micro = 1;
  static const std::vector<Signal> all = {
      {"a", "bool", Kind::truth, 1, 0, 1, false, "", one, 0, ""},
      {"b", "bool", Kind::truth, 1, 0, 1, false, "", one, 0, "max_age inf"},
      {"c", "bool", Kind::truth, 1, 0, 1, false, "", one, 0, "max_age 2 s"},
      {"g", "Gear", Kind::choice, 1, 0, 2, false, "", one, 0, ""},
      {"w", "Gear", Kind::choice, 1, 0, 2, false, "", one, 0, "max_age 1 s"},
      {"n", "int", Kind::whole, 1, -5, 5, true, "", one, 0, ""},
      {"k", "int", Kind::whole, 1, 0, 10, true, "", one, 0, "max_age inf"},
      {"x", "real", Kind::quantity, 1, -3 * one, 3 * one, true, "", micro, 0, ""},
      {"y", "real", Kind::quantity, 1, -3 * one, 3 * one, true, "", micro, 10 * milli,
       "max_age 2 s"},
      {"z", "real", Kind::quantity, 1, 0, 2 * one, true, "", 10 * milli, 20 * milli, "max_age inf"},
      {"u", "real", Kind::quantity, 1, -9 * one, 9 * one, false, "", micro, 0, ""},
      {"d", "real [m]", Kind::quantity, 1, -8 * one - 400, 8 * one - 400, true, "m", milli,
       10 * milli, "max_age 1 s"},
      {"p", "point", Kind::quantity, 2, -2 * one, 2 * one, true, "m", milli, 0, ""},
      {"q", "point", Kind::quantity, 2, -2 * one, 2 * one, true, "m", milli, 5 * milli,
       "max_age inf"},
      {"v", "real [m/s]", Kind::quantity, 1, 300, 3 * one + 700, true, "m/s", milli, 0,
       "max_age 1 s"},
      {"r", "ratio", Kind::quantity, 1, 0, one, true, "", micro, 5 * milli, "max_age 2 s"},
      {"t", "real [K][3]", Kind::quantity, 3, 200 * one, 400 * one, true, "K", milli, 500 * milli,
       ""},
      {"o", "real [rad]", Kind::quantity, 1, -3141593, 3141593, true, "rad", milli, 2 * milli,
       "max_age 1 s"},
      {"j", "pose of map @ base", Kind::quantity, 3, -4 * one, 4 * one, true, "m", milli, milli,
       "max_age 2 s", "rad"},
      {"s", "point3", Kind::quantity, 3, -2 * one, 2 * one, true, "m", milli, 0, "max_age 1 s"},
      {"l", "point @ base", Kind::quantity, 2, -2 * one + 1, 2 * one - 1, true, "m", milli, 0,
       "max_age 2 s"},
      {"i", "pose of base @ map", Kind::quantity, 3, -3 * one, 3 * one, true, "m", milli, 0,
       "max_age inf", "rad"},
      {"m", "pose of base", Kind::quantity, 3, -2 * one, 2 * one, true, "m", milli, milli, "",
       "rad"},
      {"e", "twist", Kind::quantity, 2, -2 * one, 2 * one, true, "m/s", milli, 5 * milli,
       "max_age 1 s", "rad/s"},
      {"f", "twist", Kind::quantity, 2, -1 * one, 1 * one, true, "m/s", milli, 0, "", "rad/s"},
  };
  return all;
}

std::vector<Signal> signals_of(const sema::Spec& spec) {
  std::vector<Signal> all = signals();
  for (std::size_t i = all.size(); i < spec.inputs.size(); ++i) {
    const sema::Input& input = spec.inputs[i];
    const auto micro = [](const Rational& si) { return floor_to_int(si * 1000000); };
    // places near each other, though they may be far away
    constexpr Micro near = 3000000;
    const bool is_far = near < micro(input.most->value);
    all.push_back({input.name, "", Kind::quantity, input.components.size(),
                   is_far ? -near : micro(input.least->value),
                   is_far ? near : micro(input.most->value), !is_far, "", micro(input.resolution),
                   micro(input.error->value), ""});
  }
  return all;
}

std::string declarations(std::uint32_t variant) {
  const char* const variants[] = {"scale 0.5 m;\ngrid 1 mm, 1 mm/s;\n",
                                  "scale 0.2 m/s;\ngrid 0.1 mrad, 0.01 K;\n",
                                  "scale 2 m;\ngrid 1 mm, 10 mrad, 0.1 K;\n"};
  std::string text =
      "spec random;\n"
      "period 1 s;\n" +
      std::string(variants[variant % std::size(variants)]) +
      "frame base;\n"
      "enum Gear { park, drive, reverse }\n"
      "zone yard = rectangle (-1.5 m, -1.5 m) to (1.5 m, 1.5 m) - rectangle (0 m, 0 m) to (1 m, 1 "
      "m);\n"
      "zone bend = polygon [(-1 m, -1 m), (1.2 m, -0.7005 m), (0.3 m, 1.4 m), (0 m, 0 m)];\n"
      "zone pond = circle (0.5 m, -0.5 m) radius 0.8 m;\n"
      "zone loft = prism (yard) from -0.5 m to 1 m | prism (bend) from 1 m to 1.8 m;\n"
      "zone shaft = prism (pond) from -1.2 m to 1.3 m - rectangle (0 m, -1 m, 0 m) to (1 m, 1 m, "
      "0.7003 m);\n"
      "robot Rover {\n"
      "  body radius 10 cm;\n"
      "  motion point { speed <= 0.5 m/s; accel <= 1 m/s^2; brake >= 1 m/s^2; }\n"
      "  sense position : point error 1 cm max_age 2 s;\n"
      "  sense velocity : vector error 1 cm/s max_age 1 s;\n"
      "  sense battery : ratio error 1 % max_age 3 s;\n"
      "  hears other robots max_age 2 s, present;\n"
      "  output push : acceleration;\n"
      "  latency 20 ms;\n"
      "  energy { drive <= 0.5 %/m; idle <= 0.01 %/s; drain <= 0.2 %/s; charge >= 1 %/s at home; "
      "held <= 30 s; detour <= 1 m; }\n"
      "}\n"
      "fleet one, two : Rover;\n"
      "fleet bots : Rover[2];\n"
      "site home = (0 m, 0 m);\n"
      "fun far(l : length, m : length) : bool = l >= m;\n"
      "fun twice(v : real) : real = 2 * v;\n"
      "fun unless(p : bool, q : bool) : bool = p and not q;\n"
      "fun mirrored(v : vector [m]) : vector [m] = -v;\n";
  for (const Signal& s : signals()) {
    // a ratio of 1 is 100 %
    const bool is_share = s.type == "ratio";
    const std::string unit = is_share ? " %" : s.unit.empty() ? "" : " " + s.unit;
    const Micro factor = is_share ? 100 : 1;
    text += "input " + s.name + " : " + s.type;
    if (s.kind == Kind::whole) {
      text += " in " + std::to_string(s.least) + " .. " + std::to_string(s.most);
    } else if (s.has_range) {
      text += " in " + decimal(s.least * factor) + unit + " .. " + decimal(s.most * factor) + unit;
    }
    if (!s.turning.empty()) {
      text += ", " + decimal(s.least) + " .. " + decimal(s.most) + " " + s.turning;
    }
    if (s.error > 0) text += " error " + decimal(s.error * factor) + unit;
    if (s.error > 0 && !s.turning.empty()) text += ", " + decimal(s.error) + " " + s.turning;
    if (!s.age.empty()) text += " " + s.age;
    if (s.name == "z") text += " resolution " + decimal(s.resolution);
    text += ";\n";
  }
  return text;
}

std::string Generator::monitor(std::size_t k) {
  k_ = k;
  has_param_ = false;
  const std::string formula = condition(static_cast<int>(below(4)) + 1);
  const std::string name = std::to_string(k);
  const std::string param =
      has_param_ ? "param h" + name + " : length in 0.1 m .. 2 m = 0.5 m; " : "";
  const std::string full = below(4) == 0 ? " margin full;" : "";
  return param + "monitor m" + name + " { \"D-" + name + ": random\" always " + formula + ";" +
         full + " }\n";
}

// Windows that are short, long, longer than margins are kept, delayed and endless.
std::string Generator::window(bool may_be_endless) {
  if (below(24) == 0) return "[" + std::to_string(below(3)) + " s, 1100 s]";
  const std::size_t sizes[] = {1, 2, 4, 9};
  const std::size_t from = below(sizes[below(4)]);
  const std::string to = may_be_endless && below(4) == 0
                             ? std::string("inf")
                             : std::to_string(from + below(sizes[below(4)])) + " s";
  return "[" + std::to_string(from) + " s, " + to + "]";
}
std::string Generator::duration() {
  return std::to_string(1 + below(4)) + " s";
}

std::string Generator::constant(Sort sort) {
  using List = std::vector<std::string>;
  switch (sort) {
    case Sort::number:
      return one_of(List{"-2", "-1", "-0.5", "0", "0.25", "0.5", "1", "1.5", "2", "3"});
    case Sort::whole:
      return one_of(List{"-3", "-1", "0", "1", "2", "4", "5"});
    case Sort::length:
      return one_of(List{"-1 m", "0 m", "5 cm", "0.5 m", "1 m", "2 m", "3.5 m"});
    case Sort::heat:
      return one_of(List{"250 K", "290 K", "300 K", "310.5 K"});
    case Sort::share:
      return one_of(List{"0 %", "20 %", "50 %", "99.5 %"});
    case Sort::speed:
      return one_of(List{"0 m/s", "0.3 m/s", "1 m/s", "2.5 m/s"});
    case Sort::time:
      return one_of(List{"0 s", "500 ms", "1 s", "2 s", "3 s"});
  }
  return "0";
}

std::string Generator::atom() {
  const std::initializer_list<const char*> whole = {
      "a",
      "b",
      "c",
      "g == park",
      "g != drive",
      "w == reverse",
      "g == w",
      "n == 2",
      "k != 5",
      "n == k",
      "far(d, 1 m)",
      "p inside yard",
      "q inside bend",
      "(p + 0.5 * (q - p)) inside pond",
      "p inside bend",
      "q inside shrink(yard, 20 cm)",
      "q inside complement(pond)",
      "clearance(p, complement(yard | pond)) > 30 cm",
      "p inside grow(complement(bend), 10 cm) & yard",
      "s inside loft",
      "s inside shaft",
      "s inside complement(shaft | loft)",
      "s inside shrink(loft, 10 cm)",
      "clearance(s, loft) >= 30 cm",
      "distance(s, shaft) <= 20 cm",
      "distance(s, grow(prism (yard) from 0 m to 1 m, 20 cm)) >= 30 cm",
      "g == (if b then w else drive)",
      "(if a then g else park) != (if c then reverse else w)"};
  return *(whole.begin() + below(whole.size()));
}

std::string Generator::condition(int depth) {
  if (depth <= 0) return below(2) == 0 ? atom() : comparison(1);
  const auto sub = [&] { return "(" + condition(depth - 1) + ")"; };
  switch (below(19)) {
    case 0:
      return "not " + sub();
    case 1:
      return sub() + " and " + sub();
    case 2:
      return sub() + " or " + sub();
    case 3:
      return sub() + " implies " + sub();
    case 4:
      return sub() + " iff " + sub();
    case 5:
      return sub() + " xor " + sub();
    case 6:
      return "previously " + sub();
    case 7:
      return "once" + window(true) + " " + sub();
    case 8:
      return "historically" + window(true) + " " + sub();
    case 9:
      return sub() + " since" + window(true) + " " + sub();
    case 10:
      return sub() + " for " + duration();
    case 11:
      return sub() + " within " + duration() + " of " + sub();
    case 12:
      return "if " + sub() + " then " + sub() + " else " + sub();
    case 13: {
      const std::string name = "f" + std::to_string(names_++);
      return "let " + name + " = " + sub() + " in " + name + " or " + sub();
    }
    case 14: {
      const std::string word = below(2) == 0 ? "forall" : "exists";
      if (!bound_.empty()) return comparison(depth);
      return over_fleet("(" + word + " ", " : ", [&] { return condition(std::min(depth - 1, 2)); });
    }
    default:
      return comparison(depth);
  }
}

std::string Generator::robot() {
  if (!bound_.empty() && below(4) != 0) return bound_;
  return one_of(std::vector<std::string>{"one", "two", "bots[0]", "bots[1]"});
}

template <class Body>
std::string Generator::over_fleet(const std::string& head, const std::string& separator,
                                  const Body& body) {
  bound_ = "bot" + std::to_string(names_++);
  const std::string guard = below(2) == 0 ? "" : ", " + bound_ + " != two";
  std::string text = head + bound_ + " : Rover" + guard + separator;
  text += body() + ")";
  bound_.clear();
  return text;
}

std::string Generator::comparison(int depth) {
  const Sort sorts[] = {Sort::number, Sort::number, Sort::length, Sort::length, Sort::whole,
                        Sort::heat,   Sort::share,  Sort::speed,  Sort::time};
  const Sort sort = sorts[below(9)];
  // seldom of constants alone: they have a margin as well
  const std::string left = below(16) == 0 ? constant(sort) : quantity(sort, depth);
  const std::string right = below(2) == 0 ? constant(sort) : quantity(sort, depth - 1);
  return left + " " + one_of(std::vector<std::string>{"<", "<=", ">", ">="}) + " " + right;
}

std::string Generator::leaf(Sort sort) {
  using List = std::vector<std::string>;
  switch (sort) {
    case Sort::number:
      return one_of(List{"x", "y", "z", "x", "y", "clamp(u, -4, 4)", "twice(x)"});
    case Sort::whole:
      return one_of(List{"n", "k"});
    case Sort::length:
      if (!has_param_ && below(5) == 0) {
        has_param_ = true;
        return "h" + std::to_string(k_);
      }
      return below(2) == 0 ? place() : one_of(List{"d", "p.x", "(q.y - p.y)"});
    case Sort::heat:
      return one_of(List{"t[0]", "t[1]", "t[2]", "max(t)", "min(t)"});
    case Sort::share:
      return below(2) == 0 ? "r" : robot() + ".battery";
    case Sort::speed:
      return below(2) == 0 ? one_of(List{"v", "e.linear", "(if b then e else f).linear"})
                           : robot() + ".speed";
    case Sort::time:
      return one_of(List{"age(b)", "age(y)", "age(q)", "age(x)"});
  }
  return "x";
}

std::string Generator::place() {
  using List = std::vector<std::string>;
  if (below(3) == 0) {
    return one_of(List{robot() + ".position.x", "distance(" + robot() + ", q)",
                       "norm(" + robot() + ".position - p)", "distance(one, bots[1])",
                       "clearance(" + robot() + ".position, yard)"});
  }
  return one_of(List{"distance(p, q)",
                     "norm(p - q)",
                     "distance(q, p)",
                     "clearance(p, yard)",
                     "clearance(q, bend)",
                     "distance(q, pond)",
                     "rotate(p - q, o).x",
                     "norm(rotate(q - p, o))",
                     "transform(j, p).y",
                     "distance(transform(j, q), (1 m, 1 m))",
                     "distance(s, (0 m, 1 m, 0 m))",
                     "norm((if a then p else s.xy) - q)",
                     "(cross(p - q, s.xy - p) / 1 m)",
                     "norm(cross(s - (1 m, 0 m, 0 m), (0 m, 1 m, 0 m)) / 1 m)",
                     "distance(l, transform(j, p))",
                     "transform(i, l).x",
                     "rotate(l - transform(j, q), o).y",
                     "(if c then i else m).position.x",
                     "clearance(transform(i, l), bend)",
                     "norm(mirrored(p - q))"});
}

// What every sort has.
std::string Generator::common(Sort sort, int depth) {
  const auto sub = [&] { return quantity(sort, depth - 1); };
  switch (below(11)) {
    case 0:
      return joined(sub(), "+", sub());
    case 1:
      return joined(sub(), "-", sub());
    case 2:
      return call("min", sub(), sub());
    case 3:
      return call("max", sub(), sub());
    case 4:
      return call("abs", sub());
    case 5:
      return "(if " + condition(depth - 2) + " then " + sub() + " else " + sub() + ")";
    case 6:
      return joined(one_of(std::vector<std::string>{"2", "-3"}), "*", sub());
    case 7:
      return one_of(std::vector<std::string>{"min", "max"}) + window(true) + call("", sub());
    case 8:
      return "sum" + window(false) + call("", sub());
    case 9: {
      const std::string name = "e" + std::to_string(names_++);
      return "(let " + name + " = " + sub() + " in " + joined(name, "-", sub()) + ")";
    }
    default:
      return "clamp(" + sub() + ", " + constant(sort) + ", " + constant(sort) + ")";
  }
}

std::string Generator::number(int depth) {
  const auto sub = [&] { return quantity(Sort::number, depth - 1); };
  switch (below(9)) {
    case 0:
      return joined(sub(), "*", sub());
    case 1:
      return joined(sub(), "/", one_of(std::vector<std::string>{"3", "0.7", "-4"}));
    case 2:
      return "sqrt(max(" + sub() + ", 0))";
    case 3:
      return "(rate[1 s, " + std::to_string(2 + below(4)) + " s]" + call("", sub()) + " * 1 s)";
    case 4:
      return "mean" + window(false) + call("", sub());
    case 5:
      return joined(sub(), "+", quantity(Sort::whole, depth - 1));
    default:
      return common(Sort::number, depth);
  }
}

std::string Generator::length(int depth) {
  const auto sub = [&] { return quantity(Sort::length, depth - 1); };
  switch (below(9)) {
    case 0:
      return joined(quantity(Sort::number, depth - 1), "*", sub());
    case 1:
      return joined(sub(), "/", "3");
    case 2:
      return "sqrt(abs(" + sub() + " * " + sub() + "))";
    case 3:
      return joined("v", "*", "1.5 s");
    case 4:
      return "mean" + window(false) + call("", sub());
    case 5:
      return "sqrt(max(dot(p - q, q - p), 0 m^2))";
    default:
      return common(Sort::length, depth);
  }
}

std::string Generator::quantity(Sort sort, int depth) {
  if (depth <= 0 || below(4) == 0) return leaf(sort);
  switch (sort) {
    case Sort::number:
      return number(depth);
    case Sort::length:
      return length(depth);
    case Sort::whole:
      if (below(3) == 0) return "count" + window(false) + call("", condition(depth - 1));
      if (bound_.empty() && below(3) == 0) {
        return over_fleet("count(", " : ", [&] { return condition(std::min(depth - 1, 1)); });
      }
      return common(sort, depth);
    case Sort::share:
    case Sort::speed:
      if (bound_.empty() && below(3) == 0) {
        const std::string word = below(2) == 0 ? "min(" : "max(";
        return over_fleet(word, " : ", [&] { return quantity(sort, std::min(depth - 1, 1)); });
      }
      return common(sort, depth);
    case Sort::heat:
    case Sort::time:
      return common(sort, depth);
  }
  return leaf(sort);
}

}  // namespace rtac::differential
