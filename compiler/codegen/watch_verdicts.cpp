#include "compiler/codegen/watch_verdicts.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/codegen/temporal.h"
#include "compiler/codegen/watch_known.h"
#include "compiler/codegen/watch_values.h"
#include "compiler/ir/operands.h"
#include "compiler/support/overloaded.h"

namespace rtac::codegen {
namespace {

using namespace ir;

// Whether a condition surely holds, or may hold.
enum class Side { surely, perhaps };
Side opposite(Side side) {
  return side == Side::surely ? Side::perhaps : Side::surely;
}

template <class T, class... Listed>
inline constexpr bool is_one_of = (std::is_same_v<T, Listed> || ...);
// Quantities; margins that have a name of their own, so that nobody asks what they are made of; and
// what speaks of robots, which monitors without one do not (verified IR). If one came, nothing
// would be known of it.
template <class T>
concept NeverAsked =
    is_one_of<T, Const, Battery, Clearance, Distance, EnergyTo, Speed, Add, Negate, Scale, Altitude,
              CountOthers, Input, Age, SensedAge, ParamValue, Multiply, Minimum, Maximum, Absolute,
              Root, PointClearance, SolidClearance, TrailClearance, TrailDistance, Norm, Between,
              Phase, Sine, Cosine, Choose, Aggregate> ||
    is_one_of<T, InputTruth, Open, InputSame, PointInside, SolidInside, TrailInside, PathGiven,
              Previously, Once, Historically, Since> ||
    is_one_of<T, PlanInZone, HeldFor, ForOthers, ZoneReach, LegsInZone, PointsInZone, PairReach,
              ZoneCourse, PairCourse, LegsApart, OnTrack, SpeedReach, AltitudeReach, ZoneThere,
              ThereThroughout, GoneThroughout, EnergyReach, ChargeReach, Fact, AgentDistance,
              AgentReach, ReceivedClearance, ReceivedReach, ReceivedCourse>;

// An operand of && and || stands in brackets when it is the other of both.
struct Text {
  std::string text;
  char joined = 0;  // '&', '|': by that; 0: a comparison
};
std::string in(const Text& t, char joined) {
  return t.joined == 0 || t.joined == joined ? t.text : "(" + t.text + ")";
}
Text joined(const Text& a, const Text& b, bool with_and) {
  const char by = with_and ? '&' : '|';
  return {in(a, by) + (with_and ? " && " : " || ") + in(b, by), by};
}
Text compared(const std::string& a, const char* relation, const std::string& b) {
  return {a + " " + relation + " " + b, 0};
}

// The root of something that is compared with constants alone is never drawn: they are squared. Of
// a norm, a = least squares, b = greatest ones, the bounds are the roots of both, rounded outward:
// the lower one is at least c when a >= c^2, the upper one when b > (c - 1)^2, for c >= 1.
constexpr std::int64_t square_root_max = std::int64_t{1} << 30;

class VerdictPrinter {
 public:
  // `given`: so many values are at hand, by their names. `repeats`: or null.
  VerdictPrinter(const WatchKernel& kernel, const WatchNames& names, const Block& block,
                 std::string verdict, std::set<std::string>& uses, std::size_t given,
                 RepeatPrinter* repeats)
      : kernel_(kernel),
        names_(names),
        block_(block),
        verdict_(std::move(verdict)),
        uses_(uses),
        count_(block.values.size(), 0),
        needs_name_(block.values.size(), false),
        needs_root_(block.values.size(), false),
        open_(block.values.size(), false),
        given_(given),
        repeats_(repeats),
        order_(written_values(block, repeats)) {
    for (const ValueId id : order_) {
      const Op& op = block[id].op;
      const std::vector<Part>* const parts = parts_of(id);
      parts ? look_at_parts(*parts) : look_at_uses(op);
      // of parts, any may be
      open_[at(id)] = parts ? block[id].unit.has_value() : may_be_open(op);
    }
    ++count_[at(block.result)];
  }

  VerdictBody print() {
    of_known_ =
        std::none_of(order_.begin(), order_.end(), [&](ValueId id) { return parts_of(id); }) &&
        needs_all_inputs(block_);
    if (of_known_) only_when_known();
    values();
    result();
    return std::move(body_);
  }
  VerdictBody print_bits() {
    values();
    const Value& last = block_[block_.result];
    const bool is_named = last.unit || this->is_named(block_.result);
    line("return " + (is_named ? value_name(block_.result) : bits(last)) + ";");
    return std::move(body_);
  }

 private:
  static std::size_t at(ValueId id) { return static_cast<std::size_t>(id); }

  void values() {
    std::string last;
    for (const ValueId id : order_) {
      const Value& v = block_[id];
      if (is_given(id) || !is_named(id)) continue;
      if (v.text != last) body_.lines.comment(v.text);
      last = v.text;
      const std::vector<Part>* const parts = parts_of(id);
      const std::string text = parts ? all_of(v.op, *parts) : v.unit ? quantity(id) : bits(v);
      line((v.unit ? "const bounds " : "const int32_t ") + value_name(id) + " = " + text + ";");
    }
  }
  [[nodiscard]] bool is_given(ValueId id) const { return at(id) < given_; }

  // ---- what is repeated
  [[nodiscard]] const std::vector<Part>* parts_of(ValueId id) const {
    return repeats_ ? repeats_->repeats().parts_of(id) : nullptr;
  }
  void look_at_parts(const std::vector<Part>& parts) {
    const auto need = [&](ValueId id) {
      ++count_[at(id)];
      needs_name_[at(id)] = needs_root_[at(id)] = true;
    };
    for (const Part& part : parts) {
      if (part.rows == 0) {
        need(part.value);
        continue;
      }
      for (const ValueId id : repeats_->repeats().all[part.of].quantities) need(id);
      for (const ValueId id : repeats_->repeats().all[part.of].conditions) need(id);
    }
  }
  std::string all_of(const Op& join, const std::vector<Part>& parts) {
    body_.looks = true;
    const auto operand = [this](ValueId id) { return block_[id].unit ? whole(id) : kept(id); };
    repeats_->declare(parts, operand, body_.lines);
    return repeats_->joined(join, parts, operand);
  }

  // ---- what needs a name, what needs its root
  void look_at_uses(const Op& op) {
    const bool as_bits = is_temporal(op) || std::holds_alternative<Choose>(op) ||
                         std::holds_alternative<PointInside>(op) ||
                         std::holds_alternative<SolidInside>(op) ||
                         std::holds_alternative<TrailInside>(op);
    const auto* compare = std::get_if<AtLeast>(&op);
    const bool by_squares = compare && square_of(*compare);
    for_each_operand(op, [&](ValueId id) {
      ++count_[at(id)];
      if (as_bits) needs_name_[at(id)] = true;
      if (!by_squares) needs_root_[at(id)] = true;
    });
  }
  // Inputs have open bounds between two steps of the grid; products and roots are rounded to it.
  // Operands come first: each value is looked at once.
  [[nodiscard]] bool may_be_open(const Op& op) const {
    if (std::holds_alternative<Input>(op)) return true;
    if (const auto* fixed = std::get_if<Between>(&op)) return fixed->open;
    const auto* fold = std::get_if<Aggregate>(&op);
    const bool keeps = std::holds_alternative<Add>(op) || std::holds_alternative<Negate>(op) ||
                       std::holds_alternative<Scale>(op) || std::holds_alternative<Minimum>(op) ||
                       std::holds_alternative<Maximum>(op) ||
                       std::holds_alternative<Absolute>(op) || std::holds_alternative<Choose>(op) ||
                       (fold && (fold->fold == Fold::minimum || fold->fold == Fold::maximum));
    bool open = false;
    if (keeps) for_each_operand(op, [&](ValueId of) { open = open || open_[at(of)]; });
    return open;
  }
  [[nodiscard]] bool is_drawn(ValueId id) const {
    const Op& op = block_[id].op;
    return std::holds_alternative<Norm>(op) || std::holds_alternative<Root>(op);
  }
  [[nodiscard]] bool is_named(ValueId id) const {
    const Value& v = block_[id];
    if (is_given(id) || parts_of(id)) return true;
    if (WatchValuePrinter::is_leaf(v.op) || is_same(v.op)) return false;
    if (is_asked_by_ends(id)) return false;
    // squares of a root are what it is the root of
    if (std::holds_alternative<Root>(v.op) && !needs_root_[at(id)]) return false;
    if (v.unit || is_temporal(v.op) || std::holds_alternative<InputSame>(v.op) ||
        std::holds_alternative<PointInside>(v.op) || std::holds_alternative<SolidInside>(v.op) ||
        std::holds_alternative<TrailInside>(v.op) || std::holds_alternative<PathGiven>(v.op)) {
      return true;
    }
    return needs_name_[at(id)] || count_[at(id)] > 1;
  }
  // The squares of a norm are compared, and nothing else is made of them.
  [[nodiscard]] bool is_asked_by_ends(ValueId id) const {
    return of_known_ && std::holds_alternative<Norm>(block_[id].op) && !needs_root_[at(id)];
  }
  // The same number of steps of another grid.
  static bool is_same(const Op& op) {
    const auto* scale = std::get_if<Scale>(&op);
    return scale && scale->num == 1 && scale->den == 1;
  }

  // ---- what needs all of its inputs is unknown when one of them is missing; behind that question
  // all of its quantities are known
  void only_when_known() {
    std::string missing;
    for (const auto& [channel, components] : components_of(block_)) {
      if (asks_for_whole(kernel_.watch.inputs[channel], components)) {
        missing += " || " + view("has_" + names_.channels[channel]) + " == 0";
        continue;
      }
      for (const std::uint32_t k : components) {
        missing += " || " + use("bounds_known", signal(channel, k)) + " == 0";
      }
    }
    if (missing.empty()) return;  // nothing is measured
    line("if (" + missing.substr(4) + ") {");
    body_.lines.line("  return " + verdict_ + "UNKNOWN;").line("}");
  }

  // ---- quantities
  std::string use(const std::string& function, const std::string& arguments) {
    uses_.insert(function);
    return function + "(" + arguments + ")";
  }
  std::string view(const std::string& member) {
    body_.looks = true;
    return "v->" + member;
  }
  [[nodiscard]] std::string signal(std::uint32_t channel, std::uint32_t component) {
    return view(names_.signal(channel, component).seen);
  }
  [[nodiscard]] std::string open(const Open& v) {
    return view(names_.open[static_cast<std::uint32_t>(v.schedule)]);
  }
  // An operand as bounds.
  std::string whole(ValueId id) {
    const Op& op = block_[id].op;
    if (is_given(id)) return value_name(id);
    if (const auto* c = std::get_if<Const>(&op)) return fixed(num(c->value));
    if (const auto* c = std::get_if<Between>(&op)) return fixed(*c);
    if (const auto* p = std::get_if<ParamValue>(&op)) return fixed(param(*p));
    if (const auto* i = std::get_if<Input>(&op)) return signal(i->channel, i->component);
    if (const auto* a = std::get_if<Age>(&op)) return view("age_of_" + names_.channels[a->channel]);
    if (is_same(op)) return whole(std::get<Scale>(op).a);
    if (is_drawn(id) && !is_named(id)) return whole(std::get<Root>(op).a);
    return is_named(id) ? value_name(id) : as_full(block_[id]);
  }
  // As for margins, of operands as spans.
  std::string as_full(const Value& value) {
    WatchValuePrinter full(kernel_, names_, uses_, nullptr,
                           [this](ValueId id) { return span(id); });
    const std::string text = full.value(value, block_);
    body_.looks = body_.looks || text.find("v->") != std::string::npos;
    return use("bounds_span", text);
  }
  std::string span(ValueId id) { return use("span_bounds", whole(id)); }
  std::string fixed(const std::string& value) { return use("bounds_of", value + ", " + value); }
  std::string fixed(const Between& v) {
    return use(v.open ? "bounds_amid" : "bounds_of", num(v.lo) + ", " + num(v.hi));
  }
  std::string param(const ParamValue& p) { return view("s->tightest_" + names_.params[p.param]); }
  // One of its ends.
  std::string end(ValueId id, Side side, bool lower_is_sure) {
    const Op& op = block_[id].op;
    if (const auto* c = std::get_if<Const>(&op)) return num(c->value);
    if (const auto* p = std::get_if<ParamValue>(&op)) return param(*p);
    return whole(id) + ((side == Side::surely) == lower_is_sure ? ".lo" : ".hi");
  }
  std::string quantity(ValueId id) {
    const Op& op = block_[id].op;
    if (is_temporal(op)) return temporal(op);
    if (const auto* v = std::get_if<Add>(&op)) return call(made("sum"), v->a, v->b);
    if (const auto* v = std::get_if<Negate>(&op)) return call("bounds_negative", v->a);
    if (const auto* v = std::get_if<Scale>(&op)) {
      return use(made("scaled"), whole(v->a) + ", " + num(v->num) + ", " + num(v->den));
    }
    if (const auto* v = std::get_if<Multiply>(&op)) {
      return v->a == v->b ? call(made("square"), v->a) : call(made("product"), v->a, v->b);
    }
    if (const auto* v = std::get_if<Minimum>(&op)) return call(made("least"), v->a, v->b);
    if (const auto* v = std::get_if<Maximum>(&op)) return call(made("greatest"), v->a, v->b);
    if (const auto* v = std::get_if<Absolute>(&op)) return call(made("size"), v->a);
    if (const auto* v = std::get_if<Root>(&op)) return call(made("root"), v->a);
    if (const auto* v = std::get_if<Norm>(&op)) {
      const std::string squares = call(made("squares"), v->a, v->b);
      return needs_root_[at(id)] ? use(made("root"), squares) : squares;
    }
    if (const auto* v = std::get_if<Choose>(&op)) {
      return use("bounds_chosen", kept(v->condition) + ", " + whole(v->a) + ", " + whole(v->b));
    }
    return as_full(block_[id]);
  }
  [[nodiscard]] std::string made(const std::string& how) const {
    return (of_known_ ? "known_" : "bounds_") + how;
  }
  std::string call(const std::string& function, ValueId a) { return use(function, whole(a)); }
  std::string call(const std::string& function, ValueId a, ValueId b) {
    return use(function, whole(a) + ", " + whole(b));
  }
  std::string temporal(const Op& op) {
    std::vector<ValueId> operands;
    for_each_operand(op, [&](ValueId id) { operands.push_back(id); });
    const Value& first = block_[operands.front()];
    TemporalCall with{view("s->"), "&v->s->ticks", "", "", std::nullopt};
    with.a = first.unit ? whole(operands.front()) : kept(operands.front());
    if (operands.size() > 1) with.b = kept(operands.back());
    if (first.unit && first.range && first.range->declared) with.declared = first.range;
    return temporal_call(op, with, uses_, Telling::verdicts);
  }

  // ---- conditions
  // Two bits that are at hand.
  std::string kept(ValueId id) {
    const Op& op = block_[id].op;
    if (is_given(id)) return value_name(id);
    if (const auto* i = std::get_if<InputTruth>(&op)) return signal(i->channel, i->component);
    if (const auto* o = std::get_if<Open>(&op)) return open(*o);
    if (const auto* t = std::get_if<Truth>(&op)) return t->value ? "BITS_TRUE" : "BITS_FALSE";
    return value_name(id);
  }
  std::string bits(const Value& v) {
    if (is_temporal(v.op)) return temporal(v.op);
    if (const auto* s = std::get_if<InputSame>(&v.op)) {
      return use("bits_same", signal(s->channel, s->component) + ", " +
                                  signal(s->other_channel, s->other_component));
    }
    if (const auto* p = std::get_if<PointInside>(&v.op)) return inside(*p);
    if (const auto* p = std::get_if<SolidInside>(&v.op)) return inside(*p);
    if (const auto* t = std::get_if<TrailInside>(&v.op)) return inside(*t);
    if (const auto* p = std::get_if<PathGiven>(&v.op)) {
      return use("bits_given", signal(p->channel, 0));
    }
    uses_.insert("bits_type");
    const std::string sure = in(operation(v.op, Side::surely, true), 0);
    const std::string may = in(operation(v.op, Side::perhaps, true), 0);
    if (sure == may) return sure + " ? BITS_TRUE : BITS_FALSE";
    return sure + " ? BITS_TRUE : " + clearly_not(v.op) + may + " ? BITS_UNKNOWN : BITS_FALSE";
  }
  // Whether a bound is open is asked only when the comparison is as near as that.
  std::string clearly_not(const Op& op) {
    const auto* v = std::get_if<AtLeast>(&op);
    if (!v || v->strict || square_of(*v) || opened(*v, false).empty()) return "";
    if (open_constant(v->a) || open_constant(v->b)) return "";
    return comparison(*v, Side::perhaps, false, "").text + " ? BITS_FALSE : ";
  }
  std::string inside(const PointInside& v) {
    if (const auto& channel = kernel_.watch[v.within].channel) {
      return use("bits_received", kept(v.condition) + ", " + signal(*channel, 0) + ", " +
                                      whole(v.a) + ", " + whole(v.b));
    }
    return use("bits_inside", kept(v.condition) + ", &" + region_symbol(kernel_.watch[v.within]) +
                                  ", &" + region_symbol(kernel_.watch[v.around]) + ", " +
                                  whole(v.a) + ", " + whole(v.b));
  }
  std::string inside(const SolidInside& v) {
    return use("bits_in_space", kept(v.condition) + ", &" + solid_symbol(kernel_.watch[v.within]) +
                                    ", &" + solid_symbol(kernel_.watch[v.around]) + ", " +
                                    whole(v.a) + ", " + whole(v.b) + ", " + whole(v.c));
  }
  std::string inside(const TrailInside& v) {
    WatchValuePrinter full(kernel_, names_, uses_, nullptr,
                           [this](ValueId id) { return span(id); });
    const std::string trail = full.trail(v.trail);
    body_.looks = body_.looks || v.trail.channel.has_value();
    if (const auto& channel = kernel_.watch[v.within].channel) {
      return use("bits_received_trail", kept(v.condition) + ", " + signal(*channel, 0) + ", " +
                                            (v.outside ? "1, " : "0, ") + trail);
    }
    const Region& crossed = kernel_.watch[v.outside ? v.within : v.around];
    return use("bits_trail", kept(v.condition) + ", &" + region_symbol(crossed) + ", " + trail +
                                 (v.outside ? ", 1" : ", 0"));
  }
  // That it surely (perhaps) holds, or that it does not.
  Text condition(ValueId id, Side side, bool wanted) {
    const Op& op = block_[id].op;
    if (is_named(id) || std::holds_alternative<InputTruth>(op) ||
        std::holds_alternative<Open>(op)) {
      const std::string mask = side == Side::surely ? "1" : "2";
      return compared("(" + kept(id) + " & " + mask + ")", wanted ? "!=" : "==", "0");
    }
    return operation(op, side, wanted);
  }
  // A new operation does not compile before it stands here.
  Text operation(const Op& op, Side side, bool wanted) {
    return std::visit(
        Overloaded{[&](const Not& v) { return condition(v.a, opposite(side), !wanted); },
                   [&](const And& v) { return both(v.a, v.b, side, wanted, wanted); },
                   [&](const Or& v) { return both(v.a, v.b, side, wanted, !wanted); },
                   [&](const AtLeast& v) { return at_least(v, side, wanted); },
                   [&](const InputIs& v) { return is_value(v, side, wanted); },
                   [&](const Elapsed& v) {
                     return compared(view("s->ticks.now"), wanted ? ">=" : "<", num(v.ticks));
                   },
                   [&](const Truth& v) {
                     return Text{v.value == wanted ? "1" : "0", 0};
                   },
                   [&](const NeverAsked auto&) {
                     return Text{side == Side::surely ? "0" : "1", 0};
                   }},
        op);
  }
  Text both(ValueId a, ValueId b, Side side, bool wanted, bool with_and) {
    const Text first = condition(a, side, wanted);
    return joined(first, condition(b, side, wanted), with_and);
  }
  Text is_value(const InputIs& v, Side side, bool wanted) {
    const std::string s = signal(v.channel, v.component), value = num(v.value);
    const char* const lower = side == Side::surely ? (wanted ? "==" : "!=") : wanted ? "<=" : ">";
    const char* const upper = side == Side::surely ? (wanted ? "==" : "!=") : wanted ? ">=" : "<";
    return joined(compared(s + ".lo", lower, value), compared(s + ".hi", upper, value), wanted);
  }

  // ---- comparisons: surely, the lower end of a is not below the upper end of b
  Text at_least(const AtLeast& v, Side side, bool wanted) {
    if (const auto square = square_of(v)) return by_squares(*square, side, wanted);
    if (const auto* most = open_constant(v.a)) {
      return compared(end(v.b, side, false), wanted ? "<=" : ">", num(most->lo));
    }
    if (const auto* least = open_constant(v.b)) {
      return compared(end(v.a, side, true), wanted ? ">=" : "<", num(least->hi));
    }
    // What a bound excludes: a > b surely, unless the lower bound of a is one of its values.
    const bool is_sure = side == Side::surely;
    return comparison(v, side, wanted, is_sure == v.strict ? opened(v, is_sure) : "");
  }
  // Strictly between two steps: no bound is met by accident, whether it is open or not.
  [[nodiscard]] const Between* open_constant(ValueId id) const {
    const auto* constant = std::get_if<Between>(&block_[id].op);
    return constant && constant->open ? constant : nullptr;
  }
  // `open`: 1 when a bound that decides is open.
  Text comparison(const AtLeast& v, Side side, bool wanted, const std::string& open) {
    const bool is_sure = side == Side::surely;
    const std::string left = end(v.a, side, true), right = end(v.b, side, false);
    if (is_fixed(v.a)) {  // what is fixed stands behind
      const std::string moved = open.empty() ? right : right + (is_sure ? " - " : " + ") + open;
      return compared(moved, wanted ? (v.strict ? "<" : "<=") : v.strict ? ">=" : ">", left);
    }
    const std::string moved = open.empty() ? left : left + (is_sure ? " + " : " - ") + open;
    return compared(moved, wanted ? (v.strict ? ">" : ">=") : v.strict ? "<=" : "<", right);
  }
  // 1 when one of the bounds that meet is open: lower a and upper b, or upper a and lower b.
  std::string opened(const AtLeast& v, bool lower_of_a) {
    if (!open_[at(v.a)] && !open_[at(v.b)]) return "";
    if (!open_[at(v.a)]) return open_end(v.b, !lower_of_a);
    if (!open_[at(v.b)]) return open_end(v.a, lower_of_a);
    return "(" + open_end(v.a, lower_of_a) + " | " + open_end(v.b, !lower_of_a) + ")";
  }
  // Both bounds of an input are open or none. It is found anew where it is asked: a tick seldom
  // asks.
  std::string open_end(ValueId id, bool lower) {
    const Op& op = block_[id].op;
    if (is_given(id)) return whole(id) + (lower ? ".lo_open" : ".hi_open");
    if (is_same(op)) return open_end(std::get<Scale>(op).a, lower);
    const auto* i = std::get_if<Input>(&op);
    if (!i) return whole(id) + (lower ? ".lo_open" : ".hi_open");
    const std::int64_t error = kernel_.watch.inputs[i->channel].grid(i->component).error_steps;
    return use("bounds_between_steps", whole(id) + ", " + num(error));
  }
  [[nodiscard]] bool is_fixed(ValueId id) const {
    const Op& op = block_[id].op;
    return std::holds_alternative<Const>(op) || std::holds_alternative<ParamValue>(op);
  }
  struct Square {
    ValueId root;
    bool below;          // root <= limit, else root >= limit
    std::int64_t limit;  // strictness included: both are whole numbers
  };
  [[nodiscard]] std::optional<Square> square_of(const AtLeast& v) const {
    const auto* most = std::get_if<Const>(&block_[v.a].op);
    const auto* least = std::get_if<Const>(&block_[v.b].op);
    if (least && is_drawn(v.a)) {
      const Square s{v.a, false, least->value + (v.strict ? 1 : 0)};
      if (s.limit >= 1 && s.limit <= square_root_max) return s;
    }
    if (most && is_drawn(v.b)) {
      const Square s{v.b, true, most->value - (v.strict ? 1 : 0)};
      if (s.limit >= 0 && s.limit < square_root_max) return s;
    }
    return std::nullopt;
  }
  Text by_squares(const Square& s, Side side, bool wanted) {
    if (needs_root_[at(s.root)]) {
      const char* const relation = s.below == wanted ? "<=" : ">=";
      const std::int64_t limit = wanted ? s.limit : s.limit + (s.below ? 1 : -1);
      return compared(end(s.root, side, !s.below), relation, num(limit));
    }
    const auto square = [](std::int64_t a) { return num(a * a); };
    if (s.below) {
      return side == Side::surely
                 ? compared(squares(s.root, false), wanted ? "<=" : ">", square(s.limit))
                 : compared(squares(s.root, true), wanted ? "<" : ">=", square(s.limit + 1));
    }
    return side == Side::surely
               ? compared(squares(s.root, true), wanted ? ">=" : "<", square(s.limit))
               : compared(squares(s.root, false), wanted ? ">" : "<=", square(s.limit - 1));
  }
  // One end of what it is the root of.
  std::string squares(ValueId root, bool lower) {
    if (!is_asked_by_ends(root)) return whole(root) + (lower ? ".lo" : ".hi");
    const auto& norm = std::get<Norm>(block_[root].op);
    return call(lower ? "known_squares_least" : "known_squares_most", norm.a, norm.b);
  }

  // ---- the result: not before it is known that it is not sure, it is asked whether it may be
  void result() {
    const Text sure = condition(block_.result, Side::surely, true);
    const Text may = condition(block_.result, Side::perhaps, true);
    if (!is_named(block_.result)) body_.lines.comment(block_[block_.result].text);
    if (sure.text == may.text) {
      line("return " + in(sure, 0) + " ? " + verdict_ + "TRUE : " + verdict_ + "FALSE;");
      return;
    }
    line("if (" + sure.text + ") {");
    body_.lines.line("  return " + verdict_ + "TRUE;").line("}");
    line("return " + in(may, 0) + " ? " + verdict_ + "UNKNOWN : " + verdict_ + "FALSE;");
  }
  void line(const std::string& text) { wrapped(body_.lines, text); }

  const WatchKernel& kernel_;
  const WatchNames& names_;
  const Block& block_;
  const std::string verdict_;
  std::set<std::string>& uses_;
  bool of_known_ = false;  // all of its inputs are needed, and known where they are asked for
  std::vector<int> count_;
  std::vector<bool> needs_name_, needs_root_;
  std::vector<bool> open_;  // whether a bound may be open
  const std::size_t given_;
  RepeatPrinter* const repeats_;
  const std::vector<ValueId> order_;
  VerdictBody body_;
};

}  // namespace

VerdictBody verdict_body(const WatchKernel& kernel, const WatchNames& names, const Block& block,
                         const std::string& verdict, std::set<std::string>& uses,
                         RepeatPrinter* repeats) {
  return VerdictPrinter(kernel, names, block, verdict, uses, 0, repeats).print();
}
VerdictBody repeated_bits(const WatchKernel& kernel, const WatchNames& names,
                          const Repeated& repeated, std::set<std::string>& uses) {
  return VerdictPrinter(kernel, names, repeated.block, "", uses, repeated.arguments, nullptr)
      .print_bits();
}

}  // namespace rtac::codegen
