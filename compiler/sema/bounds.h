// A block of limits, `{ speed <= 1 m/s; brake >= 1 m/s^2; }`: each known, once, from its side.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "compiler/sema/context.h"
#include "compiler/sema/quantity.h"

namespace rtac::sema {

struct BoundRule {
  std::string name;
  syntax::Relation relation;
  Dimension dimension;
  Limit limit;
  bool required;
  std::string example;  // "speed <= 0.22 m/s"
  std::string works{};  // instead of a value out of range
};

// The limits by name. A limit with a mistake is there with the value 0: it was reported, and
// `good` says so.
struct BoundValue {
  Quantity quantity;
  bool good = false;
  const syntax::Bound* written = nullptr;
};
using BoundValues = std::map<std::string, BoundValue>;

// `block` names the block in messages ("the motion of `Drone`"), `block_range` is its place.
BoundValues check_bounds(Context& context, const std::vector<const syntax::Bound*>& bounds,
                         const std::vector<BoundRule>& rules, const std::string& block,
                         const SourceRange& block_range);

}  // namespace rtac::sema
