#include "compiler/driver/explain_margin.h"

#include <algorithm>
#include <set>

#include "compiler/ir/operands.h"

namespace rtac::driver {

using namespace ir;

namespace {

// Of the past, with verdicts alone.
bool keeps_verdicts(const Op& op) {
  return std::visit(
      [](const auto& node) {
        if constexpr (requires { node.window; }) {
          return !node.window.full;
        } else {
          return false;
        }
      },
      op);
}

// The comparisons below a margin, each visited once: shared values are.
class Comparisons {
 public:
  // `through_verdicts`: also those whose margins a window has lost.
  Comparisons(const Block& block, bool through_verdicts)
      : block_(block), through_verdicts_(through_verdicts) {}

  void look(ValueId id) {
    const Value& value = block_[id];
    if (value.unit || !seen_.insert(&value).second) return;
    const auto* compare = std::get_if<AtLeast>(&value.op);
    if (compare) return units_.push_back(*block_[compare->a].unit);
    if (const Block* others = body_of(value.op)) return look_in(*others);
    if (through_verdicts_ || !keeps_verdicts(value.op)) operands(value.op);
  }
  void operands(const Op& op) {
    for_each_operand(op, [this](const ValueId& id) { look(id); });
  }
  [[nodiscard]] const std::vector<Unit>& units() const { return units_; }

 private:
  void look_in(const Block& others) {
    Comparisons inner(others, through_verdicts_);
    inner.look(others.result);
    units_.insert(units_.end(), inner.units_.begin(), inner.units_.end());
  }

  const Block& block_;
  const bool through_verdicts_;
  std::set<const Value*> seen_;
  std::vector<Unit> units_;
};

bool compares(const Block& block, const Value& value, bool through_verdicts) {
  Comparisons found(block, through_verdicts);
  found.operands(value.op);
  return !found.units().empty();
}

}  // namespace

std::vector<Unit> margin_units(const Block& block) {
  Comparisons found(block, true);
  found.look(block.result);
  std::vector<Unit> result;
  for (const Unit& unit : found.units()) {
    const auto same = [&](const Unit& u) { return u.dimension == unit.dimension; };
    if (std::none_of(result.begin(), result.end(), same)) result.push_back(unit);
  }
  return result;
}

std::string why_infinite(const Block& block, const Value& value) {
  if (!keeps_verdicts(value.op)) return "";
  if (!compares(block, value, true)) return "of Booleans there are verdicts alone";
  return std::string(compares(block, value, false)
                         ? "of a window this long the verdict alone is kept"
                         : "that of the longer window in it is") +
         "; `margin full;` in the monitor keeps it";
}

}  // namespace rtac::driver
