// What margins of a property there are: in which units, and which are infinite.
#pragma once

#include <string>
#include <vector>

#include "compiler/ir/module.h"

namespace rtac::driver {

// Those that the margin of its result may have, one of each dimension. What a quantity is made of
// with a comparison, such as `count`, has a unit of its own.
std::vector<ir::Unit> margin_units(const ir::Block& block);

// Why what is asked of the past has no finite margin; empty: it may have one.
std::string why_infinite(const ir::Block& block, const ir::Value& value);

}  // namespace rtac::driver
