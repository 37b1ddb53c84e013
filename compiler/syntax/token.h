// Tokens between the lexer, the repair of mistakes and the parser. Internal to the folder.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/support/source.h"
#include "parser.h"  // generated from parser.yy

namespace rtac::syntax {

using TokenKind = generated::Parser::token_kind_type;
using T = generated::Parser::token;

struct Token {
  TokenKind kind{};
  SourceRange range;
  std::string text = {};       // of a number, moment, unit or string, normalised; else empty
  bool bad = false;            // a mistake here is reported: what follows from it is not
  bool first_on_line = false;  // no other token before it on its line
};

enum class WordKind { item, reserved, soft, clause };  // words.def

struct Word {
  TokenKind kind;
  std::string_view text;
  WordKind word_kind;
};
const std::vector<Word>& all_words();
const Word* find_word(std::string_view text);  // nullptr: not a word of the language
const Word* find_word(TokenKind kind);

// As written in a specification for words and punctuation, else "name", "number", ...
std::string_view token_name(TokenKind kind);

// Brackets of all three kinds, and the one that `opener` waits for.
bool is_opener(TokenKind kind);
bool is_closer(TokenKind kind);
TokenKind closer_of(TokenKind opener);
bool is_brace(TokenKind kind);
// In front of the next clause stands one of these.
bool ends_clause(TokenKind kind);

// A text that names one: `"robots.rta"`.
bool is_file_of_items(const Token& token);

// The kind that the parser numbers as `symbol`.
TokenKind token_of_symbol(int symbol);

}  // namespace rtac::syntax
