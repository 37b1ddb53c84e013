// An edit of the tokens that stands for what the author meant. Internal to the folder.
#pragma once

#include <optional>
#include <vector>

#include "compiler/syntax/parse_attempt.h"

namespace rtac::syntax {

enum class EditKind { insert, replace, remove };

// Why an edit was tried: it decides the wording.
enum class EditReason {
  missing,             // a token is missing in front of the error
  missing_earlier,     // or in front of the token before it, which was taken for a name
  misspelled,          // a word with a typing error
  separator,           // another sign between the parts of a list or range
  foreign_operator,    // `=` for `==` and the reverse
  chained_comparison,  // a < b < c
  word_as_name,        // a reserved word where a name is expected
  missing_operand,     // an expression or name is missing
  superfluous,         // the token does not belong here
  doubled,             // a word, a number or a bracket that stands twice
  other_sign,          // one sign for another: `;` for `:`, `(` for `{`
  unit_of_name,        // a unit behind something else than a number
  missing_number,      // a sign in front of a unit, where the number is due
};

struct Edit {
  EditKind kind;
  EditReason reason;
  TokenKind token;       // what is inserted or written instead
  std::size_t back = 0;  // so many tokens in front of the error
  // So many tokens behind the edited one stands the other bracket of a pair, which changes with it.
  std::size_t partner = 0;
  std::size_t swallows = 0;  // so many tokens behind it go with what is replaced
};

// Where the edit applies when the error is at `index`.
inline std::size_t edit_index(std::size_t index, const Edit& edit) {
  return index - edit.back;
}

// `index` is that of the error.
std::vector<Token> apply_edit(std::vector<Token> tokens, std::size_t index, const Edit& edit);

// The first edit at the error that lets the parser read on; nullopt when none does.
std::optional<Edit> find_edit(const std::vector<Token>& tokens, const SyntaxError& error,
                              const SourceManager& sources);

}  // namespace rtac::syntax
