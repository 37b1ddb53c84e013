#include "compiler/codegen/watch_glance.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <variant>

#include "compiler/codegen/code.h"
#include "compiler/codegen/watch_known.h"
#include "compiler/codegen/watch_values.h"

namespace rtac::codegen {
namespace {

using namespace ir;

// Beyond this much a closer look costs less than a longer glance.
constexpr std::size_t values_max = 48, text_max = 1200;
// What is compared stays below 2^61, also as the sum of two squares; so does any part of a sum.
constexpr std::int64_t sum_max = std::int64_t{1} << 60, root_max = std::int64_t{1} << 29;

// The sum of what is read, whatever way it is added up, and how far below and above it the truth
// may lie.
struct Line {
  std::vector<std::pair<bool, std::string>> terms;  // negative?, text
  std::int64_t fixed = 0, below = 0, above = 0;
  std::int64_t size = 0;  // no part of the sum is larger
};
// Where a number lies, as far as that is known.
struct Bounds {
  std::int64_t lo = std::numeric_limits<std::int64_t>::min();
  std::int64_t hi = std::numeric_limits<std::int64_t>::max();
};
// An operand of && and || stands in brackets when it is the other of both.
struct Text {
  std::string text;
  char by = 0;                              // '&', '|': joined by that; 0: a comparison
  std::map<std::string, Bounds> implied{};  // where it holds: by what is read
  bool asks_each_alone = false;             // no sums, which numbers out of range would overflow
};
// One of which nothing is known is none.
using Condition = std::optional<Text>;

std::map<std::string, Bounds> implied_by(const Text& a, const Text& b, bool with_and) {
  std::map<std::string, Bounds> out = a.implied;
  for (const auto& [term, of_b] : b.implied) {
    Bounds& both = out[term];  // that of a, or none
    both.lo = with_and ? std::max(both.lo, of_b.lo) : std::min(both.lo, of_b.lo);
    both.hi = with_and ? std::min(both.hi, of_b.hi) : std::max(both.hi, of_b.hi);
  }
  if (!with_and)
    std::erase_if(out, [&](const auto& known) { return !b.implied.count(known.first); });
  return out;
}
Condition joined(const Condition& a, const Condition& b, bool with_and) {
  if (with_and && (!a || !b)) return std::nullopt;
  if (!a || !b) return a ? a : b;
  const char by = with_and ? '&' : '|';
  const auto in = [by](const Text& t) {
    return t.by == 0 || t.by == by ? t.text : "(" + t.text + ")";
  };
  return Text{in(*a) + (with_and ? " && " : " || ") + in(*b), by, implied_by(*a, *b, with_and),
              a->asks_each_alone && b->asks_each_alone};
}
Condition compared(const std::string& a, const char* relation, std::int64_t b) {
  return Text{a + " " + relation + " " + num(b), 0};
}

// The least r with r * r >= a.
std::int64_t root_above(std::int64_t a) {
  std::int64_t r = 0;
  while (r * r < a) ++r;
  return r;
}

class GlancePrinter {
 public:
  GlancePrinter(const WatchKernel& kernel, const WatchNames& names, const Block& block)
      : kernel_(kernel), names_(names), block_(block) {}

  std::optional<Glance> print() {
    if (block_.values.size() > values_max) return std::nullopt;
    const Condition surely = condition(block_.result, true);
    const Condition never = condition(block_.result, false);
    Glance out{components_of(block_),
               std::move(lines_),
               surely ? surely->text : "",
               never ? never->text : "",
               surely && is_inside(*surely),
               false,
               measures_always_};
    out.needs_each = needs_all_inputs(block_) || (out.needs_some && out.components.size() == 1);
    const std::size_t size = out.surely.size() + out.never.size();
    if (is_lost_ || size == 0 || size > text_max) return std::nullopt;
    return out.components.empty() ? std::nullopt : std::optional(std::move(out));
  }

 private:
  // Whether every number is in its range, and not its last step, where the condition holds.
  [[nodiscard]] bool is_inside(const Text& condition) const {
    if (!condition.asks_each_alone) return false;
    for (const auto& [channel, components] : components_of(block_)) {
      for (const std::uint32_t k : components) {
        const auto at = condition.implied.find("in->" + names_.signal(channel, k).name);
        if (at == condition.implied.end()) return false;
        const Range& range = kernel_.watch.inputs[channel].grid(k).range;
        if (at->second.lo < range.lo || at->second.hi >= range.hi) return false;
      }
    }
    return true;
  }
  // That it surely holds, or surely does not.
  Condition condition(ValueId id, bool wanted) {
    const Op& op = block_[id].op;
    if (const auto* v = std::get_if<Not>(&op)) return condition(v->a, !wanted);
    if (const auto* v = std::get_if<And>(&op)) return both(v->a, v->b, wanted, wanted);
    if (const auto* v = std::get_if<Or>(&op)) return both(v->a, v->b, wanted, !wanted);
    if (const auto* v = std::get_if<AtLeast>(&op)) return at_least(*v, wanted);
    is_lost_ = true;
    return std::nullopt;
  }
  Condition both(ValueId a, ValueId b, bool wanted, bool with_and) {
    if (is_lost_ || ++joins_ > values_max) {  // what is used again is written again
      is_lost_ = true;
      return std::nullopt;
    }
    const Condition first = condition(a, wanted);
    return joined(first, condition(b, wanted), with_and);
  }
  Condition at_least(const AtLeast& v, bool wanted) {
    const ValueId a = same(v.a), b = same(v.b);
    const auto* most = std::get_if<Const>(&block_[a].op);
    const auto* least = std::get_if<Const>(&block_[b].op);
    if (const auto* n = std::get_if<Norm>(&block_[a].op); n && least) {
      return length(*n, a, least->value + (v.strict ? 1 : 0), wanted);
    }
    if (const auto* n = std::get_if<Norm>(&block_[b].op); n && most) {  // not longer than that
      return length(*n, b, most->value + (v.strict ? 0 : 1), !wanted);
    }
    Line difference = line(a);
    add(difference, line(b), true);
    measures_always_ = measures_always_ && difference.below + difference.above > 0;
    return is_lost_ ? std::nullopt : linear(difference, v.strict, wanted);
  }
  // difference >= 0, or > 0
  static Condition linear(const Line& d, bool strict, bool wanted) {
    const std::int64_t least = d.below - d.fixed + (strict ? 1 : 0);  // surely
    const std::int64_t most = -d.above - d.fixed - (strict ? 0 : 1);  // never
    if (d.terms.empty()) return std::nullopt;
    Line sum = d;
    sum.fixed = 0;
    const bool is_turned = d.terms.front().first;
    if (is_turned) {
      for (auto& [negative, term] : sum.terms) negative = !negative;
    }
    const std::int64_t limit = (wanted ? least : most) * (is_turned ? -1 : 1);
    const bool is_lower = wanted != is_turned;
    Condition out = compared(sum_of(sum), is_lower ? ">=" : "<=", limit);
    out->asks_each_alone = sum.terms.size() == 1;
    if (out->asks_each_alone) {
      Bounds& where = out->implied[sum.terms.front().second];
      (is_lower ? where.lo : where.hi) = limit;
    }
    return out;
  }
  // The length of (a, b) is at least so many steps, which is asked of their squares.
  Condition length(const Norm& v, ValueId id, std::int64_t least, bool wanted) {
    const Line a = line(v.a), b = line(v.b);
    const std::int64_t off_a = std::max(a.below, a.above), off_b = std::max(b.below, b.above);
    constexpr std::int64_t off_max = 1 << 20;
    is_lost_ = is_lost_ || a.terms.empty() || b.terms.empty() || a.size > root_max ||
               b.size > root_max || off_a > off_max || off_b > off_max || least < 1 ||
               least > root_max;
    if (is_lost_) return std::nullopt;
    const std::int64_t off = root_above(off_a * off_a + off_b * off_b);
    const std::string square = square_of(a, b, id);
    if (wanted) return compared(square, ">=", (least + off) * (least + off));
    const std::int64_t below = least - 1 - off;
    return below < 0 ? std::nullopt : compared(square, "<=", below * below);
  }
  std::string square_of(const Line& a, const Line& b, ValueId id) {
    const std::string name = "square_" + num(static_cast<std::int64_t>(id));
    if (!named_.insert(id).second) return name;
    const std::string x = name + "_x", y = name + "_y";
    lines_.push_back("const int64_t " + x + " = " + sum_of(a) + ";");
    lines_.push_back("const int64_t " + y + " = " + sum_of(b) + ";");
    lines_.push_back("const int64_t " + name + " = " + x + " * " + x + " + " + y + " * " + y + ";");
    return name;
  }
  static std::string sum_of(const Line& line) {
    std::string text;
    for (const auto& [negative, term] : line.terms) {
      const char* const sign = text.empty() ? (negative ? "-" : "") : negative ? " - " : " + ";
      text += sign + term;
    }
    if (line.fixed == 0) return text;
    return text + (line.fixed > 0 ? " + " : " - ") + num(std::abs(line.fixed));
  }

  // ---- quantities
  // The same number of steps of another grid.
  [[nodiscard]] ValueId same(ValueId id) const {
    const auto* scale = std::get_if<Scale>(&block_[id].op);
    return scale && scale->num == 1 && scale->den == 1 ? same(scale->a) : id;
  }
  Line line(ValueId id) {
    const Op& op = block_[same(id)].op;
    Line out;
    if (const auto* c = std::get_if<Const>(&op)) {
      out.fixed = c->value;
      widen(out, c->value, c->value);
    } else if (const auto* between = std::get_if<Between>(&op)) {
      out.fixed = between->lo;
      out.above = between->hi - between->lo;
      widen(out, between->lo, between->hi);
    } else if (const auto* p = std::get_if<ParamValue>(&op)) {
      out.terms.emplace_back(false, param_value(kernel_, names_, p->param));
      widen(out, kernel_.watch.params[p->param].range.lo, kernel_.watch.params[p->param].range.hi);
    } else if (const auto* i = std::get_if<Input>(&op)) {
      const ChannelGrid& grid = kernel_.watch.inputs[i->channel].grid(i->component);
      out.terms.emplace_back(false, "in->" + names_.signal(i->channel, i->component).name);
      out.below = grid.error_steps;
      out.above = grid.error_steps + 1;
      widen(out, grid.range.lo, grid.range.hi);
      widen(out, grid.error_steps, grid.error_steps);
    } else if (const auto* v = std::get_if<Negate>(&op)) {
      add(out, line(v->a), true);
    } else if (const auto* sum = std::get_if<Add>(&op)) {
      out = line(sum->a);
      add(out, line(sum->b), false);
    } else {
      is_lost_ = true;
    }
    return out;
  }
  void widen(Line& line, std::int64_t lo, std::int64_t hi) {
    is_lost_ = is_lost_ || lo < -sum_max || hi > sum_max;
    if (!is_lost_) grow(line, std::max(std::abs(lo), std::abs(hi)));
  }
  void grow(Line& line, std::int64_t by) {
    line.size += by;
    is_lost_ = is_lost_ || line.size > sum_max;
  }
  void add(Line& to, const Line& of, bool negated) {
    if (is_lost_) return;
    for (const auto& [negative, term] : of.terms) to.terms.emplace_back(negative != negated, term);
    to.fixed += negated ? -of.fixed : of.fixed;
    to.below += negated ? of.above : of.below;
    to.above += negated ? of.below : of.above;
    grow(to, of.size);
  }

  const WatchKernel& kernel_;
  const WatchNames& names_;
  const Block& block_;
  std::vector<std::string> lines_;
  std::set<ValueId> named_;
  std::size_t joins_ = 0;
  bool is_lost_ = false, measures_always_ = true;
};

}  // namespace

std::optional<Glance> glance_at(const WatchKernel& kernel, const WatchNames& names,
                                const Block& property) {
  return GlancePrinter(kernel, names, property).print();
}

}  // namespace rtac::codegen
