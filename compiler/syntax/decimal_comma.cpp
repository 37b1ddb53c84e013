#include "compiler/syntax/decimal_comma.h"

#include <algorithm>
#include <string>

#include "compiler/syntax/signs.h"

namespace rtac::syntax {
namespace {

class Joiner {
 public:
  Joiner(std::vector<Token>& tokens, const SourceManager& sources, diag::Engine& diagnostics)
      : tokens_(tokens), sources_(sources), diagnostics_(diagnostics) {}

  void run() {
    for (std::size_t i = 0; i + 3 < tokens_.size(); ++i) {
      if (is_decimal(i) && is_mistaken(i)) join(i);
    }
  }

 private:
  [[nodiscard]] bool touches(std::size_t i) const {  // this token and the next one
    return tokens_[i].range.end == tokens_[i + 1].range.begin;
  }
  [[nodiscard]] bool is_digits(std::size_t i) const {
    const std::string_view text = sources_.text(tokens_[i].range);
    return tokens_[i].kind == T::NUMBER && !tokens_[i].bad &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  }
  // Digits on both sides of a comma without blanks, and one unit behind them.
  [[nodiscard]] bool is_decimal(std::size_t i) const {
    return is_digits(i) && tokens_[i + 1].kind == T::COMMA && is_digits(i + 2) &&
           tokens_[i + 3].kind == T::UNIT && touches(i) && touches(i + 1);
  }

  // A point keeps two coordinates, arguments of functions and the ends of intervals may be numbers.
  [[nodiscard]] bool is_mistaken(std::size_t i) const {
    std::size_t open = i;
    int depth = 0;
    while (open-- > 0) {
      if (is_closer(tokens_[open].kind)) ++depth;
      if (is_opener(tokens_[open].kind) && depth-- == 0) break;
      if (tokens_[open].kind == T::SEMICOLON) return true;
    }
    if (open >= i || tokens_[open].kind == T::LEFT_BRACE) return true;
    if (tokens_[open].kind != T::LEFT_PAREN) return false;
    const bool is_call = open > 0 && tokens_[open - 1].kind == T::IDENT;
    return !is_call && other_commas(open, i + 1) > 0;
  }

  [[nodiscard]] int other_commas(std::size_t open, std::size_t comma) const {
    int depth = 0, count = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      if (is_opener(tokens_[i].kind)) ++depth;
      if (is_closer(tokens_[i].kind) && --depth == 0) break;
      if (tokens_[i].kind == T::COMMA && depth == 1 && i != comma && !touches(i)) ++count;
    }
    return count;
  }

  [[nodiscard]] SourceRange number_range(std::size_t i) const {
    return {tokens_[i].range.file, tokens_[i].range.begin, tokens_[i + 2].range.end};
  }

  void join(std::size_t i) {
    const std::string number = tokens_[i].text + "." + tokens_[i + 2].text;
    diagnostics_.report({diag::Code::unexpected_token,
                         tokens_[i + 1].range,
                         "decimals stand behind a point: `" + number + "`",
                         "a comma separates two values",
                         {},
                         {},
                         {{number_range(i), number}}});
    tokens_[i].text = number;
    tokens_[i].range = number_range(i);
    const auto at = tokens_.begin() + static_cast<std::ptrdiff_t>(i);
    tokens_.erase(at + 1, at + 3);
  }

  std::vector<Token>& tokens_;
  const SourceManager& sources_;
  diag::Engine& diagnostics_;
};

}  // namespace

void mend_decimal_commas(std::vector<Token>& tokens, const SourceManager& sources,
                         diag::Engine& diagnostics) {
  Joiner{tokens, sources, diagnostics}.run();
}

}  // namespace rtac::syntax
