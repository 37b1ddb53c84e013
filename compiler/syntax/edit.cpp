#include "compiler/syntax/edit.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "compiler/syntax/signs.h"

namespace rtac::syntax {
namespace {

// Every trial parses the stretch again: beyond this size a mistake drops its clause untried.
constexpr std::size_t kTrialTokensMax = 20'000;

constexpr std::array kClosers{T::RIGHT_PAREN, T::RIGHT_BRACKET, T::RIGHT_BRACE};
constexpr std::array kSeparators{T::COMMA, T::COLON, T::ASSIGN, T::LEFT_BRACE};
// Words and signs between the parts of an expression, behind a whole operand.
constexpr std::array kConnectors{T::THEN, T::ELSE, T::IN, T::OF, T::DOT_DOT};
constexpr std::array kComparisons{T::LESS,  T::LESS_EQUAL, T::GREATER, T::GREATER_EQUAL,
                                  T::EQUAL, T::NOT_EQUAL,  T::INSIDE};

// Longer than any word with a typing error.
constexpr std::size_t kWordMax = 32;

template <class Set>
bool contains(const Set& set, TokenKind kind) {
  return std::find(set.begin(), set.end(), kind) != set.end();
}

// Words in front of an operand: one with a typing error is taken for a name, and the mistake shows
// behind it only.
constexpr std::array kPrefixes{T::NOT, T::ONCE,   T::HISTORICALLY, T::PREVIOUSLY,
                               T::IF,  T::FORALL, T::EXISTS,       T::LET};

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Optimal string alignment: insertions, removals, replacements and swaps of neighbours.
std::size_t typing_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t cost = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

// The candidates in the order in which they are tried.
class EditList {
 public:
  EditList(const std::vector<Token>& tokens, const SyntaxError& error, const SourceManager& sources)
      : tokens_(tokens),
        index_(error.index),
        found_(tokens[error.index]),
        error_(error),
        sources_(sources) {}

  std::vector<Edit> make() {
    add_doubled();
    add_operators();
    add_missing_brace();
    add_missing_name();
    add_separators();
    for (const Edit& edit : find_sign_edits(tokens_, error_, sources_)) edits_.push_back(edit);
    add_spelling();
    add_earlier_spelling();
    add_missing_tokens();
    add_operands();
    if (found_.kind != T::END) {
      if (!closes_bracket()) {
        edits_.push_back({EditKind::remove, EditReason::superfluous, found_.kind});
      }
      if (expects(T::BAD_EXPR)) replace(EditReason::superfluous, T::BAD_EXPR);
    }
    return std::move(edits_);
  }

 private:
  [[nodiscard]] bool expects(TokenKind kind) const { return error_.expects(kind); }
  void insert(EditReason reason, TokenKind kind) {
    edits_.push_back({EditKind::insert, reason, kind});
  }
  void replace(EditReason reason, TokenKind kind) {
    edits_.push_back({EditKind::replace, reason, kind});
  }

  // `input x x : bool`, `in 0 .. 8 8 m`; in `error error 1 cm` the second one was taken for a name.
  void add_doubled() {
    for (std::size_t back = 0; back < 2 && back < index_; ++back) {
      const Token& one = tokens_[index_ - back - 1];
      const Token& two = tokens_[index_ - back];
      const bool says_something = two.kind == T::IDENT || two.kind == T::NUMBER ||
                                  two.kind == T::UNIT || find_word(two.kind) != nullptr;
      const bool same = says_something && sources_.text(one.range) == sources_.text(two.range);
      if (same) edits_.push_back({EditKind::remove, EditReason::doubled, two.kind, back});
    }
  }

  void add_operators() {
    if (found_.kind == T::ASSIGN && expects(T::EQUAL)) {
      replace(EditReason::foreign_operator, T::EQUAL);
    }
    if (found_.kind == T::EQUAL && expects(T::ASSIGN)) {
      replace(EditReason::foreign_operator, T::ASSIGN);
    }
    const bool after_comparison = expects(T::AND) && !expects(T::LESS);
    if (contains(kComparisons, found_.kind) && after_comparison) {
      replace(EditReason::chained_comparison, T::AND);
    }
  }

  // A clause word on a new line behind a `;` was taken for the name of a bound: the `}` of the
  // bounds is missing in front of it.
  void add_missing_brace() {
    if (index_ < 2 || !tokens_[index_ - 1].first_on_line) return;
    const TokenKind before = tokens_[index_ - 2].kind;
    if (before != T::SEMICOLON && before != T::BAD_CLAUSE) return;
    if (!find_word(tokens_[index_ - 1].kind)) return;
    edits_.push_back({EditKind::insert, EditReason::missing_earlier, T::RIGHT_BRACE, 1});
  }

  // `within speed 0.1 m/s`: the word was taken for the name that is missing in front of it.
  void add_missing_name() {
    if (index_ == 0 || !find_word(tokens_[index_ - 1].kind)) return;
    if (!expects(tokens_[index_ - 1].kind) || expects(T::IDENT)) return;
    edits_.push_back({EditKind::insert, EditReason::missing_operand, T::IDENT, 1});
  }

  // `enum G { a; b }`, `in 0 m to 3 m`, and the comma in `{ a, b, }`.
  void add_separators() {
    const bool in_list = expects(T::COMMA) && !expects(T::SEMICOLON);
    if (found_.kind == T::SEMICOLON && in_list && expects(T::RIGHT_BRACE)) {
      replace(EditReason::separator, list_is_closed() ? T::COMMA : T::RIGHT_BRACE);
    }
    if (found_.kind == T::TO && expects(T::DOT_DOT)) replace(EditReason::separator, T::DOT_DOT);
    if (found_.kind == T::COMMA && expects(T::GREATER) && !expects(T::PLUS)) {
      replace(EditReason::separator, T::GREATER);
    }
    add_relation();
    const bool ends_list = found_.kind == T::RIGHT_BRACE || found_.kind == T::RIGHT_BRACKET;
    const bool trailing = ends_list && index_ > 0 && tokens_[index_ - 1].kind == T::COMMA;
    if (trailing) {
      edits_.push_back({EditKind::remove, EditReason::superfluous, T::COMMA, 1});
    }
  }

  // `enum G { a; b }`, not `enum G { a, b;` with another item behind it.
  [[nodiscard]] bool list_is_closed() const {
    std::size_t i = index_ + 1;
    while (tokens_[i].kind == T::IDENT || tokens_[i].kind == T::COMMA ||
           tokens_[i].kind == T::SEMICOLON) {
      ++i;
    }
    return tokens_[i].kind == T::RIGHT_BRACE;
  }

  void add_spelling() {
    const std::string_view text = sources_.text(found_.range);
    const bool is_word = found_.kind == T::IDENT || find_word(found_.kind);
    if (!is_word || text.size() > kWordMax || expects(T::IDENT)) return;
    std::vector<std::pair<std::size_t, TokenKind>> near;
    for (const TokenKind kind : error_.expected) {
      const Word* word = find_word(kind);
      if (!word) continue;
      const std::size_t distance = typing_distance(text, word->text);
      if (distance <= std::max<std::size_t>(1, word->text.size() / 3)) {
        near.emplace_back(distance, kind);
      }
    }
    if (found_.kind == T::IN && expects(T::INSIDE) && !starts_range()) {
      near.emplace_back(0, T::INSIDE);  // other languages' word
    }
    std::sort(near.begin(), near.end());
    for (const auto& [distance, kind] : near) replace(EditReason::misspelled, kind);
  }

  // `speed = 1 m/s`, `brake > 1 m/s^2`: limits are `<=`, what a robot can do at least `>=`.
  void add_relation() {
    const bool is_bound = expects(T::LESS_EQUAL) && expects(T::GREATER_EQUAL) && !expects(T::PLUS);
    if (!is_bound || index_ == 0) return;
    const std::string_view name = sources_.text(tokens_[index_ - 1].range);
    const bool is_least = found_.kind == T::GREATER || is_least_bound(name);
    const bool is_sign = found_.kind == T::COLON || found_.kind == T::ASSIGN ||
                         found_.kind == T::COMMA || found_.kind == T::SEMICOLON ||
                         found_.kind == T::LESS || found_.kind == T::GREATER ||
                         is_opener(found_.kind) || is_closer(found_.kind);
    if (is_sign) {
      replace(EditReason::separator, is_least ? T::GREATER_EQUAL : T::LESS_EQUAL);
    }
  }

  // `NOT open`, `onec[0 s, 2 s] open`: the name, or that in front of the brackets.
  void add_earlier_spelling() {
    if (index_ == 0 || expects(T::BAD_EXPR)) return;
    std::size_t at = index_ - 1;
    while (at > 0 && tokens_[index_ - 1].kind == T::RIGHT_BRACKET &&
           tokens_[at].kind != T::LEFT_BRACKET) {
      --at;
    }
    if (tokens_[at].kind == T::LEFT_BRACKET && at > 0) --at;
    const std::string_view text = sources_.text(tokens_[at].range);
    if (tokens_[at].kind != T::IDENT || text.size() > kWordMax) return;
    for (const TokenKind kind : kPrefixes) {
      const std::string_view word = find_word(kind)->text;
      if (typing_distance(text, word) > word.size() / 4) continue;
      edits_.push_back({EditKind::replace, EditReason::misspelled, kind, index_ - at});
    }
  }

  // `in 0 .. 3` of a signal, at a wrong place.
  [[nodiscard]] bool starts_range() const {
    for (std::size_t i = index_; i < tokens_.size() && tokens_[i].kind != T::SEMICOLON; ++i) {
      if (tokens_[i].kind == T::DOT_DOT) return true;
    }
    return false;
  }

  // A `)` or `]` whose opening bracket stands in front of it is not one too many.
  [[nodiscard]] bool closes_bracket() const {
    if (found_.kind != T::RIGHT_PAREN && found_.kind != T::RIGHT_BRACKET) return false;
    int depth = 0;
    for (std::size_t i = index_; i-- > 0 && tokens_[i].kind != T::SEMICOLON;) {
      const TokenKind kind = tokens_[i].kind;
      if (kind == T::RIGHT_PAREN || kind == T::RIGHT_BRACKET) ++depth;
      const bool opens = kind == T::LEFT_PAREN || kind == T::LEFT_BRACKET;
      if (opens && depth-- == 0) return true;
    }
    return false;
  }

  void add_missing_tokens() {
    if (expects(T::SEMICOLON)) insert(EditReason::missing, T::SEMICOLON);
    for (const TokenKind kind : kClosers) {
      if (expects(kind)) insert(EditReason::missing, kind);
    }
    for (const TokenKind kind : kSeparators) {
      if (expects(kind)) insert(EditReason::missing, kind);
    }
    for (const TokenKind kind : kConnectors) {
      if (expects(kind) && (expects(T::PLUS) || expects(T::DOT))) {
        insert(EditReason::missing, kind);
      }
    }
    if (error_.expected.size() == 1 && !expects(T::IDENT)) {
      insert(EditReason::missing, error_.expected.front());
    }
  }

  void add_operands() {
    const Word* word = find_word(found_.kind);
    const bool reserved =
        word && (word->word_kind == WordKind::item || word->word_kind == WordKind::reserved);
    if (reserved && expects(T::IDENT)) {
      replace(EditReason::word_as_name, T::IDENT);
    }
    if (expects(T::BAD_EXPR)) {
      insert(EditReason::missing_operand, T::BAD_EXPR);
    } else if (expects(T::IDENT)) {
      insert(EditReason::missing_operand, T::IDENT);
    }
  }

  const std::vector<Token>& tokens_;
  const std::size_t index_;
  const Token& found_;
  const SyntaxError& error_;
  const SourceManager& sources_;
  std::vector<Edit> edits_;
};

// The edited place must be read, and at least one more token of the author's than before.
bool reads_on(const std::vector<Token>& tokens, const SyntaxError& error, const Edit& edit,
              const SourceManager& sources) {
  // Between clauses nothing can depend on a stray `;` or `}`.
  const TokenKind found = tokens[error.index].kind;
  const bool is_stray = found == T::SEMICOLON || found == T::RIGHT_BRACE;
  if (edit.kind == EditKind::remove && is_stray && error.expects(T::BAD_CLAUSE)) return true;
  const Attempt attempt = attempt_parse(apply_edit(tokens, error.index, edit), sources);
  if (!attempt.error) return true;
  const std::size_t needed = edit.kind == EditKind::insert ? 3 : 2;
  return attempt.error->index >= error.index + needed;
}

}  // namespace

std::vector<Token> apply_edit(std::vector<Token> tokens, std::size_t index, const Edit& edit) {
  index = edit_index(index, edit);
  const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(index);
  switch (edit.kind) {
    case EditKind::insert: {
      const std::uint32_t place = index > 0 ? tokens[index - 1].range.end : at->range.begin;
      tokens.insert(at, Token{edit.token, {at->range.file, place, place}});
      break;
    }
    case EditKind::replace:
      at->kind = edit.token;
      at->text.clear();
      if (edit.partner > 0) {
        (at + static_cast<std::ptrdiff_t>(edit.partner))->kind = closer_of(edit.token);
      }
      tokens.erase(at + 1, at + 1 + static_cast<std::ptrdiff_t>(edit.swallows));
      break;
    case EditKind::remove:
      tokens.erase(at, at + 1 + static_cast<std::ptrdiff_t>(edit.swallows));
      break;
  }
  return tokens;
}

std::optional<Edit> find_edit(const std::vector<Token>& tokens, const SyntaxError& error,
                              const SourceManager& sources) {
  if (tokens.size() > kTrialTokensMax) return std::nullopt;
  for (const Edit& edit : EditList{tokens, error, sources}.make()) {
    if (reads_on(tokens, error, edit, sources)) return edit;
  }
  return std::nullopt;
}

}  // namespace rtac::syntax
