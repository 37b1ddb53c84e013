#include "compiler/analysis/at_odds.h"

#include <cstdint>
#include <map>

#include "compiler/ir/linear.h"

namespace rtac::analysis {
namespace {

// The narrowest bounds of a signal, in grid steps, and which comparisons set them.
struct Bounds {
  std::int64_t least = INT64_MIN, most = INT64_MAX;
  ir::ValueId least_at{}, most_at{};
};
using Signals = std::map<ir::Leaf, Bounds>;

void add(const ir::Block& block, ir::ValueId margin, const std::vector<ir::Param>& params,
         Signals& to) {
  const ir::Op& op = block[margin].op;
  if (const auto* both = std::get_if<ir::And>(&op)) {
    add(block, both->a, params, to);
    return add(block, both->b, params, to);
  }
  if (const auto* held = std::get_if<ir::HeldFor>(&op)) return add(block, held->a, params, to);
  const auto* compare = std::get_if<ir::AtLeast>(&op);
  if (compare == nullptr || !ir::has_form(block, *compare)) return;
  const auto low = ir::lower_bound(block, *compare, params);
  if (low && low->need.laxest > to[low->leaf].least) {
    to[low->leaf].least = low->need.laxest;
    to[low->leaf].least_at = margin;
  }
  const auto high = ir::upper_bound(block, *compare);
  if (high && high->most < to[high->leaf].most) {
    to[high->leaf].most = high->most;
    to[high->leaf].most_at = margin;
  }
}

}  // namespace

std::optional<AtOdds> at_odds(const ir::Block& block, ir::ValueId margin,
                              const std::vector<ir::Param>& params) {
  Signals all;
  add(block, margin, params, all);
  for (const auto& [leaf, bounds] : all) {
    if (bounds.least > bounds.most) return AtOdds{bounds.least_at, bounds.most_at};
  }
  return std::nullopt;
}

}  // namespace rtac::analysis
