#include "compiler/passes/find_vacuous.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "compiler/sema/dimension.h"

namespace rtac::passes {
namespace {

using namespace ir;

// Which verdicts a condition may have at some tick, apart from unknown.
struct Verdicts {
  bool can_be_true = true, can_be_false = true;
  [[nodiscard]] bool decided() const { return !can_be_true || !can_be_false; }
};

Rational exact(std::int64_t value) {
  return Rational(static_cast<long>(value));
}

class Finder {
 public:
  explicit Finder(const Block& block) : block_(block) {}

  Verdicts result() {
    for (const Value& value : block_.values) {
      verdicts_.push_back(value.unit ? Verdicts{} : std::visit(*this, value.op));
    }
    return of(block_.result);
  }

  // The comparisons whose outcome does not depend on what is measured.
  [[nodiscard]] std::vector<const Value*> decided_comparisons() const {
    std::vector<const Value*> found;
    for (std::size_t i = 0; i < verdicts_.size(); ++i) {
      const Value& value = block_.values[i];
      const auto* compare = std::get_if<AtLeast>(&value.op);
      const bool compares = compare && !(is_fixed(compare->a) && is_fixed(compare->b));
      const bool is_new = std::none_of(found.begin(), found.end(), [&](const Value* earlier) {
        return earlier->source == value.source;
      });
      if (compares && verdicts_[i].decided() && is_new) found.push_back(&value);
    }
    return found;
  }

  Verdicts operator()(const Truth& v) const { return {v.value, !v.value}; }
  Verdicts operator()(const AtLeast& v) const {
    const Range &a = *block_[v.a].range, &b = *block_[v.b].range;
    if (!a.declared || !b.declared) return {};
    const Rational most = exact(a.hi) - exact(b.lo), least = exact(a.lo) - exact(b.hi);
    return v.strict ? Verdicts{sgn(most) > 0, sgn(least) <= 0}
                    : Verdicts{sgn(most) >= 0, sgn(least) < 0};
  }
  Verdicts operator()(const Not& v) const { return {of(v.a).can_be_false, of(v.a).can_be_true}; }
  Verdicts operator()(const And& v) const {
    return {of(v.a).can_be_true && of(v.b).can_be_true,
            of(v.a).can_be_false || of(v.b).can_be_false};
  }
  Verdicts operator()(const Or& v) const {
    return {of(v.a).can_be_true || of(v.b).can_be_true,
            of(v.a).can_be_false && of(v.b).can_be_false};
  }
  Verdicts operator()(const Elapsed& v) const { return {true, v.ticks > 0}; }
  // language rule 2: nothing was true before the first tick
  Verdicts operator()(const Previously& v) const { return {of(v.a).can_be_true, true}; }
  Verdicts operator()(const Once& v) const {
    return {of(v.a).can_be_true, of(v.a).can_be_false || v.window.from > 0};
  }
  Verdicts operator()(const Historically& v) const {
    return {of(v.a).can_be_true || v.window.from > 0, of(v.a).can_be_false};
  }
  Verdicts operator()(const Since& v) const {
    const bool now = v.window.from == 0;
    return {of(v.b).can_be_true && (now || of(v.a).can_be_true), of(v.b).can_be_false || !now};
  }
  template <class Other>
  Verdicts operator()(const Other&) const {
    return {};
  }

 private:
  [[nodiscard]] Verdicts of(ValueId id) const { return verdicts_[static_cast<std::uint32_t>(id)]; }
  // No range of an input mends a comparison of two of them.
  [[nodiscard]] bool is_fixed(ValueId id) const {
    const Op& op = block_[id].op;
    return std::holds_alternative<Const>(op) || std::holds_alternative<Between>(op);
  }

  const Block& block_;
  std::vector<Verdicts> verdicts_;
};

std::string shown(std::int64_t steps, const Unit& unit) {
  return sema::show(exact(steps) * unit.step, unit.dimension);
}

// "`speed` is from 0 m/s to 3 m/s"; empty: the operand is a constant.
std::string extent(const Value& operand) {
  if (std::holds_alternative<Const>(operand.op)) return {};
  return "`" + operand.text + "` is from " + shown(operand.range->lo, *operand.unit) + " to " +
         shown(operand.range->hi, *operand.unit);
}

diag::Note note_of(const Block& block, const Value& comparison) {
  const auto& v = std::get<AtLeast>(comparison.op);
  const std::string a = extent(block[v.a]), b = extent(block[v.b]);
  return {comparison.source, a.empty() || b.empty() ? a + b : a + ", " + b};
}

void report(const PlainMonitor& monitor, const Verdicts& verdicts, const Finder& finder,
            diag::Engine& diagnostics) {
  diag::Diagnostic found{diag::Code::monitor_vacuous, monitor.source, {}, {}, {}, {}, {}};
  const bool never_false = !verdicts.can_be_false;
  found.message = "the monitor `" + monitor.name + "` is never " +
                  (never_false ? "false" : "true") + ", whatever is measured";
  found.label = never_false ? "finds nothing" : "finds a violation at every tick";
  for (const Value* comparison : finder.decided_comparisons()) {
    found.notes.push_back(note_of(monitor.property, *comparison));
  }
  found.help = found.notes.empty() ? "a property that depends on an input works"
                                   : "a limit inside that range works, or a wider `in a .. b`";
  diagnostics.report(std::move(found));
}

}  // namespace

void find_vacuous(Module& module, diag::Engine& diagnostics) {
  if (!module.watch || diagnostics.has_errors()) return;
  for (const PlainMonitor& monitor : module.watch->monitors) {
    Finder finder(monitor.property);
    const Verdicts verdicts = finder.result();
    if (verdicts.decided()) report(monitor, verdicts, finder, diagnostics);
  }
}

}  // namespace rtac::passes
