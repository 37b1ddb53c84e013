#include "compiler/syntax/lookalike.h"

#include <algorithm>

#include "compiler/diagnostics/characters.h"

namespace rtac::syntax {
namespace {

const Lookalike kSigns[] = {
    {"\u2264", "<=", T::LESS_EQUAL},     // less-than or equal
    {"\u2265", ">=", T::GREATER_EQUAL},  // greater-than or equal
    {"\u2260", "!=", T::NOT_EQUAL},      // not equal
    {"\u2212", "-", T::MINUS},           // minus sign
    {"\u2013", "-", T::MINUS},           // en dash
    {"\u2014", "-", T::MINUS},           // em dash
    {"\u2216", "-", T::MINUS},           // set minus
    {"\u00D7", "*", T::STAR},            // multiplication sign
    {"\u00B7", "*", T::STAR},            // middle dot
    {"\u00F7", "/", T::SLASH},           // division sign
    {"\u2227", "and", T::AND},           // logical and
    {"\u2228", "or", T::OR},             // logical or
    {"\u00AC", "not", T::NOT},           // not sign
    {"\u2192", "implies", T::IMPLIES},   // rightwards arrow
    {"\u21D2", "implies", T::IMPLIES},   // rightwards double arrow
    {"\u2194", "iff", T::IFF},           // left right arrow
    {"\u21D4", "iff", T::IFF},           // left right double arrow
    {"\u2200", "forall", T::FORALL},     // for all
    {"\u2203", "exists", T::EXISTS},     // there exists
    {"\u2208", "inside", T::INSIDE},     // element of
    {"\u222A", "|", T::PIPE},            // union
    {"\u2229", "&", T::AMPERSAND},       // intersection
    {"\u2026", "..", T::DOT_DOT},        // horizontal ellipsis
};

struct UnitLetter {
  std::string_view text, ascii;
};
constexpr UnitLetter kUnitLetters[] = {
    {"\u00B5", "u"},    // micro sign
    {"\u03BC", "u"},    // Greek mu
    {"\u00B2", "^2"},   // superscript two
    {"\u00B3", "^3"},   // superscript three
    {"\u00B0", "deg"},  // degree sign
    {"\u00B7", "*"},    // middle dot
    {"\u00D7", "*"},    // multiplication sign
};

}  // namespace

std::optional<Lookalike> find_lookalike(std::string_view text) {
  const auto* found =
      std::find_if(std::begin(kSigns), std::end(kSigns),
                   [&](const Lookalike& entry) { return text.starts_with(entry.text); });
  if (found != std::end(kSigns)) return *found;
  const diag::Character c = diag::read_character(text);
  if (c.bytes == 0) return std::nullopt;  // in the middle of a character
  const diag::Look look = diag::look_of(c.code);
  if (look == diag::Look::blank) return Lookalike{text.substr(0, c.bytes), " ", T::END};
  if (look == diag::Look::invisible) return Lookalike{text.substr(0, c.bytes), "", T::END};
  return std::nullopt;
}

UnitReading read_unit(std::string_view text) {
  UnitReading result;
  while (result.length < text.size()) {
    const std::string_view rest = text.substr(result.length);
    if (!is_high(rest.front())) {
      result.ascii += rest.front();
      ++result.length;
      continue;
    }
    const auto* letter =
        std::find_if(std::begin(kUnitLetters), std::end(kUnitLetters),
                     [&](const UnitLetter& entry) { return rest.starts_with(entry.text); });
    if (letter == std::end(kUnitLetters)) break;
    result.ascii += letter->ascii;
    result.length += letter->text.size();
  }
  const bool complete =
      !result.ascii.empty() &&
      std::string_view{"/*^0123456789"}.find(result.ascii.front()) == std::string_view::npos;
  if (!complete || result.ascii.back() == '/' || result.ascii.back() == '*') return {};
  return result;
}

std::string quote(std::string_view text, std::size_t bytes_max) {
  const bool cut = text.size() > bytes_max;
  if (cut) {
    std::size_t length = bytes_max;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) --length;
    text = text.substr(0, length);
  }
  return '`' + diag::printable(text) + (cut ? "...`" : "`");
}

}  // namespace rtac::syntax
