// What a property asks for with every zone that comes and goes at its worst.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::verify {

struct Limit {
  ir::ZoneIndex zone{};
  std::int64_t mm = 0;  // beyond touching
};
struct Term {
  Limit kept;                         // whatever comes or goes
  std::vector<ir::ZoneIndex> either;  // a body is to lie in one of them, that one included
};

// Of the parts that speak of such zones. nullopt: one of them is of another kind.
std::optional<std::vector<Term>> at_worst(const ir::Decision& decision, const ir::Block& property);

}  // namespace rtac::verify
