// Signs that were written for others, and brackets that are missing or too many elsewhere than
// where the parser stops. Internal to the folder.
#pragma once

#include <vector>

#include "compiler/syntax/edit.h"

namespace rtac::syntax {

// Edits after which all of the clause is read; the likeliest first.
std::vector<Edit> find_sign_edits(const std::vector<Token>& tokens, const SyntaxError& error,
                                  const SourceManager& sources);

// Is there no further mistake in the clause once `edit` is made?
bool mends_clause(const std::vector<Token>& tokens, const SyntaxError& error, const Edit& edit,
                  const SourceManager& sources);

// Is `index` inside of brackets around conditions, which are no point: `always (open and moving)`?
bool groups_conditions(const std::vector<Token>& tokens, std::size_t index);

// `brake >= 1 m/s^2`: is the bound of this name one from below?
bool is_least_bound(std::string_view name);

// Does a word look like a unit, and not like a value: `m/s`, `kg`?
bool is_unit_word(std::string_view text);

// `3 m//s`: does a comment stand where a unit goes on, in front of the token at `index`?
bool is_comment_in_unit(const std::vector<Token>& tokens, std::size_t index,
                        const SourceManager& sources);

// What may be a unit at the start of `text`.
std::string_view unit_at(std::string_view text);

}  // namespace rtac::syntax
