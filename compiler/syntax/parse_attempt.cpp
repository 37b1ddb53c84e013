#include "compiler/syntax/parse_attempt.h"

#include <algorithm>
#include <string>
#include <utility>

namespace rtac::syntax {
namespace generated {

Parser::symbol_type yylex(Builder& build) {
  const Token& token = build.next_token();
  switch (token.kind) {
    case T::NUMBER: {
      std::optional<Rational> value = parse_decimal(token.text);
      const bool bad = token.bad || !value;
      return Parser::make_NUMBER({value.value_or(Rational{0}), token.text, bad}, token.range);
    }
    case T::UNIT:
      return Parser::make_UNIT({token.text, token.range}, token.range);
    case T::MOMENT:
      return Parser::make_MOMENT({token.text, token.range}, token.range);
    case T::STRING:
      return Parser::make_STRING({token.text, token.range}, token.range);
    default:
      return {token.kind, token.range};
  }
}

}  // namespace generated

bool SyntaxError::expects(TokenKind kind) const {
  return std::find(expected.begin(), expected.end(), kind) != expected.end();
}

Attempt attempt_parse(const std::vector<Token>& tokens, const SourceManager& sources) {
  Builder builder{sources, tokens};
  generated::Parser parser{builder};
  Attempt attempt;
  const bool accepted = parser.parse() == 0;
  if (!accepted || builder.failed()) {
    std::vector<TokenKind> expected;
    for (const int symbol : builder.expected_symbols()) expected.push_back(token_of_symbol(symbol));
    attempt.error = SyntaxError{builder.error_index(), std::move(expected)};
  }
  attempt.too_high = builder.too_high();
  attempt.items = builder.take_items();
  attempt.specs = builder.take_specs();
  attempt.zone_files = builder.take_zone_files();
  return attempt;
}

}  // namespace rtac::syntax
