// How quantities are shown in explanations: as the author would write them.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/ir/module.h"
#include "compiler/support/rational.h"

namespace rtac::driver {

// "1 operation", "2 operations"
std::string count(std::size_t number, const std::string& what);
// As many decimals as are shown without rounding to the nearest: bounds are rounded outward.
Rational decimals(const Rational& value, bool up);
std::string shown(const Rational& steps, const ir::Unit& unit, bool up);
std::string shown(std::int64_t steps, const ir::Unit& unit, bool up);
std::string shown(const ir::Range& range, const ir::Unit& unit);
// "real [m/s]"
std::string real_type(const sema::Dimension& dimension);
// "grid: steps of 1 mm"
std::string grid(const ir::Unit& unit);
// Of a zone: how many edges a place is held against, and how far distances are exact.
std::string edges_checked(std::size_t edges, const ir::EdgeTree& tree);
// "error: the interval is at most 0.021 m/s wide"
std::string wide(const Rational& steps, const ir::Unit& unit);

}  // namespace rtac::driver
