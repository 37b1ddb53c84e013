// Characters beyond ASCII that authors write for something that the language spells in ASCII.
// Internal to the folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "compiler/syntax/token.h"

namespace rtac::syntax {

// Part of a character beyond ASCII.
inline bool is_high(char c) {
  return static_cast<unsigned char>(c) >= 0x80U;
}

struct Lookalike {
  std::string_view text;  // UTF-8
  std::string_view ascii;
  TokenKind kind;  // END: a blank
};
// The look-alike at the start of `text`, which is not empty.
std::optional<Lookalike> find_lookalike(std::string_view text);

// The unit that is meant at the start of `text` (`m/s²` is `m/s^2`), and how many bytes it takes.
struct UnitReading {
  std::string ascii;
  std::size_t length = 0;
};
UnitReading read_unit(std::string_view text);

// Source text for a message: in back-ticks, hidden characters spelled out, cut when long.
std::string quote(std::string_view text, std::size_t bytes_max = 40);

}  // namespace rtac::syntax
