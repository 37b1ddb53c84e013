#include "compiler/syntax/token.h"

#include <algorithm>
#include <unordered_map>

namespace rtac::syntax {
namespace {

using generated::Parser;

std::vector<TokenKind> make_symbol_table() {
  std::vector<TokenKind> table(Parser::YYNTOKENS, T::YYUNDEF);
  for (int kind = T::SPEC; kind <= T::NEGATION; ++kind) {
    const auto token = static_cast<TokenKind>(kind);
    table[static_cast<std::size_t>(Parser::by_kind{token}.kind())] = token;
  }
  table[0] = T::END;
  return table;
}

}  // namespace

const std::vector<Word>& all_words() {
  static const std::vector<Word> words{
#define RTAC_WORD(token, text, kind) {T::token, text, WordKind::kind},
#include "compiler/syntax/words.def"
#undef RTAC_WORD
  };
  return words;
}

const Word* find_word(std::string_view text) {
  static const auto by_text = [] {
    std::unordered_map<std::string_view, const Word*> map;
    for (const Word& word : all_words()) map.emplace(word.text, &word);
    return map;
  }();
  const auto found = by_text.find(text);
  return found == by_text.end() ? nullptr : found->second;
}

const Word* find_word(TokenKind kind) {
  const auto& words = all_words();
  const auto found = std::find_if(words.begin(), words.end(),
                                  [kind](const Word& word) { return word.kind == kind; });
  return found == words.end() ? nullptr : &*found;
}

std::string_view token_name(TokenKind kind) {
  return Parser::symbol_name(Parser::by_kind{kind}.kind());
}

bool is_opener(TokenKind kind) {
  return kind == T::LEFT_PAREN || kind == T::LEFT_BRACKET || kind == T::LEFT_BRACE;
}

bool is_closer(TokenKind kind) {
  return kind == T::RIGHT_PAREN || kind == T::RIGHT_BRACKET || kind == T::RIGHT_BRACE;
}

TokenKind closer_of(TokenKind opener) {
  if (opener == T::LEFT_PAREN) return T::RIGHT_PAREN;
  return opener == T::LEFT_BRACKET ? T::RIGHT_BRACKET : T::RIGHT_BRACE;
}

bool is_brace(TokenKind kind) {
  return kind == T::LEFT_BRACE || kind == T::RIGHT_BRACE;
}

bool ends_clause(TokenKind kind) {
  return kind == T::SEMICOLON || is_brace(kind) || kind == T::BAD_CLAUSE;
}

bool is_file_of_items(const Token& token) {
  constexpr std::string_view ending = ".rta";
  const std::string& text = token.text;
  return token.kind == T::STRING && text.size() > ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

TokenKind token_of_symbol(int symbol) {
  static const std::vector<TokenKind> table = make_symbol_table();
  return table.at(static_cast<std::size_t>(symbol));
}

}  // namespace rtac::syntax
