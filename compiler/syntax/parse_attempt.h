// One run of the generated parser, which stops at the first mistake. Internal to the folder.
#pragma once

#include <optional>
#include <vector>

#include "compiler/syntax/ast.h"
#include "compiler/syntax/token.h"

namespace rtac::syntax {

struct SyntaxError {
  std::size_t index;                // of the token that does not fit
  std::vector<TokenKind> expected;  // what would fit instead
  [[nodiscard]] bool expects(TokenKind kind) const;
};

struct Attempt {
  std::optional<SyntaxError> error;
  std::optional<SourceRange> too_high;  // an expression that became ErrorExpr for its height
  std::vector<Item> items;
  std::vector<Name> specs;  // names of `spec` lines
  std::vector<Text> zone_files;
  // Of the repair: what it has taken away, and the places of edits that nobody is told of.
  Loss loss;
  std::vector<SourceRange> silent_edits;
};

// `tokens` ends with END.
Attempt attempt_parse(const std::vector<Token>& tokens, const SourceManager& sources);

}  // namespace rtac::syntax
