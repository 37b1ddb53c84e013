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
      const std::size_t end = number_end(i);
      if (end == i || !is_mistaken(i)) continue;
      join(i, end);
      i = end;
    }
    if (is_joined_.empty()) return;
    std::size_t at = 0;
    std::erase_if(tokens_, [&](const Token&) { return is_joined_[at++]; });
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
  // The last digits of a number with commas and without blanks, in front of a unit; i: there is
  // none.
  [[nodiscard]] std::size_t number_end(std::size_t i) const {
    std::size_t end = i;
    if (!is_digits(i)) return i;
    while (end + 3 < tokens_.size() && tokens_[end + 1].kind == T::COMMA && is_digits(end + 2) &&
           touches(end) && touches(end + 1)) {
      end += 2;
    }
    return tokens_[end + 1].kind == T::UNIT ? end : i;
  }
  // `1,000 m`: of thousands, or between one and two?
  [[nodiscard]] bool is_of_thousands(std::size_t i, std::size_t end) const {
    return end > i + 2 || (tokens_[i + 2].text.size() == 3 && tokens_[i].text != "0");
  }

  // A point keeps two coordinates, arguments of functions and the ends of intervals may be numbers.
  [[nodiscard]] bool is_mistaken(std::size_t i) const {
    // far more than a point or a clause has
    const std::size_t first = i > 400 ? i - 400 : 0;
    std::size_t open = i;
    int depth = 0;
    while (open-- > first) {
      if (is_closer(tokens_[open].kind)) ++depth;
      if (is_opener(tokens_[open].kind) && depth-- == 0) break;
      if (tokens_[open].kind == T::SEMICOLON) return true;
    }
    if (open < first || open >= i) return first == 0;
    if (tokens_[open].kind == T::LEFT_BRACE) return true;
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

  void join(std::size_t i, std::size_t end) {
    Token& number = tokens_[i];
    const SourceRange whole{number.range.file, number.range.begin, tokens_[end].range.end};
    std::string digits = number.text;
    for (std::size_t k = i + 2; k <= end; k += 2) digits += tokens_[k].text;
    const std::string decimal = number.text + "." + tokens_[i + 2].text;
    diag::Diagnostic mistake{diag::Code::unexpected_token,
                             tokens_[i + 1].range,
                             {},
                             "a comma separates two values",
                             {},
                             {},
                             {}};
    if (is_of_thousands(i, end)) {
      mistake.message = "thousands have no sign between them: `" + digits + "`";
      if (end == i + 2) {
        mistake.help = "decimals stand behind a point: `" + decimal + "`";
      } else {
        mistake.fixits.push_back({whole, digits});
      }
    } else {
      mistake.message = "decimals stand behind a point: `" + decimal + "`";
      mistake.fixits.push_back({whole, decimal});
    }
    diagnostics_.report(std::move(mistake));
    number.text = is_of_thousands(i, end) ? digits : decimal;
    number.range = whole;
    is_joined_.resize(tokens_.size());
    for (std::size_t k = i + 1; k <= end; ++k) is_joined_[k] = true;
  }

  std::vector<Token>& tokens_;
  const SourceManager& sources_;
  diag::Engine& diagnostics_;
  std::vector<bool> is_joined_;  // tokens that are part of a number in front of them
};

}  // namespace

void mend_decimal_commas(std::vector<Token>& tokens, const SourceManager& sources,
                         diag::Engine& diagnostics) {
  Joiner{tokens, sources, diagnostics}.run();
}

}  // namespace rtac::syntax
