// Units: from the text of one (`cm`, `m/s^2`, `%/m`) to its dimension and exact factor.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/sema/dimension.h"

namespace rtac::sema {

struct UnitMeaning {
  Dimension dimension;
  Rational factor;  // value in SI = number as written * factor
};

// Factors separated by `*` or `/`, each a symbol with an optional power; `1` stands for nothing
// (`1/s`); no blanks. nullopt: a symbol is not known, or a power is not a whole number up to 32.
std::optional<UnitMeaning> parse_unit(std::string_view text);

// The unit that `text` may have meant, of dimension `due` when that is known and possible.
std::optional<std::string> suggest_unit(std::string_view text, const std::optional<Dimension>& due);

// `degC` and the like: no unit, because it does not begin at 0.
bool is_celsius(std::string_view written);

// The unit to insert behind a bare number where `due` is expected: its SI unit, except that whole
// numbers of ten and more are taken for milliseconds when a time is due.
std::string likely_unit(const Dimension& due, const Rational& number);

}  // namespace rtac::sema
