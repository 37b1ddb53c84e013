// What reports about grids propose: resolutions and neighbours that work as they are printed.
#pragma once

#include <optional>
#include <string>

#include "compiler/ir/unit.h"
#include "compiler/support/rational.h"

namespace rtac::ir {

// "0.3 m", when that is the value to the last digit; none: it would have to be rounded.
std::optional<std::string> exact_text(const Rational& value, const sema::Dimension& dimension);

// The multiples of the step on either side, nearer to zero first; none: they cannot be printed.
std::optional<std::string> neighbours(const Rational& value, const Unit& unit);

// A resolution, `step` or finer, that the value is a multiple of, and that margins can count.
std::optional<std::string> fitting_resolution(const Rational& value, const Rational& step,
                                              const Unit& unit);

// Whether no resolution that could be declared has the value on its grid: it is no decimal of SI
// units, as 45 deg and 5 km/h are none, and the step is one.
bool is_on_no_grid(const Rational& value, const Unit& unit);

// The largest power of ten within the step, if margins can count it.
std::optional<std::string> round_resolution(const Unit& unit);

}  // namespace rtac::ir
