#include "compiler/syntax/signs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

namespace rtac::syntax {
namespace {

// What is mistaken for another sign: keys that lie side by side, and brackets of other languages.
constexpr std::array kMistaken{T::LEFT_PAREN,    T::LEFT_BRACKET, T::LEFT_BRACE, T::RIGHT_PAREN,
                               T::RIGHT_BRACKET, T::RIGHT_BRACE,  T::SEMICOLON,  T::COLON,
                               T::COMMA,         T::ASSIGN};
// What may have been meant; `:` comes before `,`, which may join what belongs to two clauses.
constexpr std::array kMeant{T::RIGHT_PAREN,  T::RIGHT_BRACKET, T::RIGHT_BRACE, T::LEFT_PAREN,
                            T::LEFT_BRACKET, T::LEFT_BRACE,    T::COLON,       T::ASSIGN,
                            T::DOT_DOT,      T::SEMICOLON,     T::COMMA};
// Between conditions and quantities: none of them stands inside of the brackets of a call below.
constexpr std::array kBehindQuantity{
    T::LESS, T::LESS_EQUAL, T::GREATER, T::GREATER_EQUAL, T::EQUAL, T::NOT_EQUAL, T::AND,
    T::OR,   T::XOR,        T::IMPLIES, T::IFF,           T::THEN,  T::ELSE};
// Functions whose arguments are no conditions, or seldom are (`count`).
constexpr std::array<std::string_view, 21> kOfQuantities{
    "abs",   "sqrt",     "min",       "max",    "clamp", "norm",      "dot",
    "cross", "distance", "clearance", "age",    "leg",   "path",      "rate",
    "mean",  "sum",      "count",     "shrink", "grow",  "energy_to", "rotate"};
// Of them those of a name, which is in no sum.
constexpr std::array<std::string_view, 2> kOfNames{"age", "energy_to"};
constexpr std::array kSums{T::PLUS, T::MINUS, T::STAR, T::SLASH};
// Of them those over a window, `max[0 s, 1 s](x)`.
constexpr std::array<std::string_view, 6> kWindowed{"min", "max", "rate", "mean", "sum", "count"};
// Functions of one place or vector, which may be written by its coordinates.
constexpr std::array<std::string_view, 2> kOfOnePoint{"norm", "energy_to"};
constexpr std::array<std::string_view, 30> kUnits{
    "m", "cm", "mm", "km", "um", "s",  "ms", "us",  "min", "h",  "rad", "mrad", "deg", "kg", "g",
    "A", "mA", "K",  "N",  "J",  "kJ", "Wh", "kWh", "W",   "kW", "V",   "mV",   "Ah",  "Hz", "kHz"};

template <class Set, class Value>
bool contains(const Set& set, const Value& value) {
  return std::find(set.begin(), set.end(), value) != set.end();
}

// The innermost bracket that is open in front of `index`.
std::optional<std::size_t> bracket_around(const std::vector<Token>& tokens, std::size_t index) {
  int depth = 0;
  for (std::size_t i = index; i-- > 0;) {
    if (is_closer(tokens[i].kind)) ++depth;
    if (is_opener(tokens[i].kind) && depth-- == 0) return i;
  }
  return std::nullopt;
}

class SignFinder {
 public:
  SignFinder(const std::vector<Token>& tokens, const SyntaxError& error,
             const SourceManager& sources)
      : tokens_(tokens), error_(error), sources_(sources) {}

  std::vector<Edit> run() {
    add_missing_number();
    add_unit_of_name();
    add_doubled_bracket();
    add_closer_further_on();
    add_opener_of_call();
    add_end_of_line();
    add_other_signs();
    return std::move(edits_);
  }

 private:
  [[nodiscard]] TokenKind kind(std::size_t i) const {
    return i < tokens_.size() ? tokens_[i].kind : T::END;
  }
  [[nodiscard]] std::string_view text(std::size_t i) const {
    return sources_.text(tokens_[i].range);
  }
  [[nodiscard]] bool touch(std::size_t i) const {  // this token and the next one
    return tokens_[i].range.end == tokens_[i + 1].range.begin;
  }
  void try_edit(const Edit& edit) {
    if (mends_clause(tokens_, error_, edit, sources_)) edits_.push_back(edit);
  }

  // How many tokens the unit is that begins at `first`.
  [[nodiscard]] std::size_t tokens_of_unit(std::size_t first) const {
    const SourceRange& begin = tokens_[first].range;
    const std::size_t end =
        begin.begin + unit_at(sources_.text(begin.file).substr(begin.begin)).size();
    std::size_t count = 0;
    while (kind(first + count) != T::END && tokens_[first + count].range.begin < end) ++count;
    return count;
  }

  // `speed <= limit m/s`
  void add_unit_of_name() {
    const std::size_t at = error_.index;
    if (at == 0 || kind(at) != T::IDENT || !error_.expects(T::PLUS)) return;
    const bool is_value = kind(at - 1) == T::IDENT || kind(at - 1) == T::RIGHT_PAREN;
    if (!is_value || tokens_[at].first_on_line || !is_unit_word(text(at))) return;
    Edit edit{EditKind::remove, EditReason::unit_of_name, kind(at)};
    edit.swallows = tokens_of_unit(at) - 1;
    try_edit(edit);
  }

  // `speed <= ; m/s`: another sign stands where the number is due.
  void add_missing_number() {
    const std::size_t at = error_.index;
    if (!error_.expects(T::BAD_EXPR) || !contains(kMistaken, kind(at))) return;
    if (kind(at + 1) != T::IDENT || tokens_[at + 1].first_on_line) return;
    if (!is_unit_word(text(at + 1))) return;
    Edit edit{EditKind::replace, EditReason::missing_number, T::BAD_EXPR};
    edit.swallows = tokens_of_unit(at + 1);
    try_edit(edit);
  }

  [[nodiscard]] std::size_t clause_begin() const {
    std::size_t i = error_.index;
    while (i > 0 && !ends_clause(kind(i - 1))) --i;
    return i;
  }

  // The bracket that closes the one at `open`; 0 when none does in front of the mistake.
  [[nodiscard]] std::size_t closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t i = open; i < error_.index; ++i) {
      if (is_opener(kind(i))) ++depth;
      if (is_closer(kind(i)) && --depth == 0) return i;
    }
    return 0;
  }

  // The name in front of `(` or of `[a, b](`.
  [[nodiscard]] std::string_view callee(std::size_t open) const {
    if (open == 0) return {};
    std::size_t i = open - 1;
    if (kind(i) == T::RIGHT_BRACKET) {
      while (i > 0 && kind(i) != T::LEFT_BRACKET) --i;
      if (i == 0) return {};
      --i;
    }
    return kind(i) == T::IDENT ? text(i) : std::string_view{};
  }

  // `distance((p, q) <= 2 m`, `rectangle ((0 m, 0 m) to (5 m, 5 m)`
  void add_doubled_bracket() {
    const std::size_t begin = clause_begin();
    int tries = 4;  // each parses the file once more
    for (std::size_t i = error_.index; i-- > begin + 1 && tries > 0;) {
      const bool twice = kind(i) == T::LEFT_PAREN && kind(i - 1) == T::LEFT_PAREN && touch(i - 1);
      if (!twice) continue;
      --tries;
      if (!(starts_point(i - 1) || holds_arguments(i))) continue;
      try_edit({EditKind::remove, EditReason::doubled, T::LEFT_PAREN, error_.index - i});
    }
  }

  [[nodiscard]] bool starts_point(std::size_t open) const {
    const TokenKind before = open > 0 ? kind(open - 1) : T::END;
    return before == T::RECTANGLE || before == T::CIRCLE || before == T::TO;
  }

  // Is what stands in the inner brackets no point, but all the arguments of the call? Coordinates
  // are numbers as a rule, and arguments are not all of them.
  [[nodiscard]] bool holds_arguments(std::size_t inner) const {
    const std::string_view name = callee(inner - 1);
    const std::size_t close = closing(inner);
    if (name.empty() || contains(kOfOnePoint, name) || close == 0) return false;
    if (kind(close + 1) == T::COMMA) return false;
    int depth = 0;
    bool has_comma = false, has_other = kind(inner + 1) != T::NUMBER && kind(inner + 1) != T::MINUS;
    for (std::size_t i = inner; i < close; ++i) {
      if (is_opener(kind(i))) ++depth;
      if (is_closer(kind(i))) --depth;
      if (kind(i) != T::COMMA || depth != 1) continue;
      has_comma = true;
      has_other = has_other || (kind(i + 1) != T::NUMBER && kind(i + 1) != T::MINUS);
    }
    return has_comma && has_other;
  }

  // `distance(p, q <= 2 m`: the parser misses the `)` at the end only.
  void add_closer_further_on() {
    if (!error_.expects(T::RIGHT_PAREN)) return;
    const std::size_t open = open_bracket();
    if (kind(open) != T::LEFT_PAREN || !contains(kOfQuantities, callee(open))) return;
    const std::size_t end = end_of_quantity(open);
    if (end == error_.index) return;
    try_edit({EditKind::insert, EditReason::missing_earlier, T::RIGHT_PAREN, error_.index - end});
  }

  // The innermost bracket that is open at the mistake; the mistake itself where none is.
  [[nodiscard]] std::size_t open_bracket() const {
    return bracket_around(tokens_, error_.index).value_or(error_.index);
  }

  // What follows the arguments of the call: a comparison, `and`; the mistake where nothing does.
  [[nodiscard]] std::size_t end_of_quantity(std::size_t open) const {
    int depth = 0;
    std::size_t end = error_.index;
    const bool is_single = contains(kOfNames, callee(open));
    for (std::size_t i = open + 1; i < error_.index; ++i) {
      if (is_opener(kind(i))) ++depth;
      if (is_closer(kind(i))) --depth;
      if (depth != 0) continue;
      const bool ends =
          contains(kBehindQuantity, kind(i)) || (is_single && contains(kSums, kind(i)));
      if (end == error_.index && ends) end = i;
      if (kind(i) == T::COLON) end = error_.index;  // `min(q : Cart, q != r : ...`
    }
    return end;
  }

  // `input f ; zone[8]`, `enum G { a, b (`, `path(16)`
  void add_other_signs() {
    const std::size_t at = error_.index;
    if (!contains(kMistaken, kind(at))) return;
    for (const TokenKind meant : kMeant) {
      if (meant == kind(at) || !error_.expects(meant)) continue;
      if (meant == T::COMMA && groups_conditions(tokens_, at)) continue;
      try_sign({EditKind::replace, EditReason::other_sign, meant});
    }
  }

  // With the other bracket of its pair, and alone.
  void try_sign(Edit edit) {
    const std::size_t at = edit_index(error_.index, edit);
    edit.partner = is_opener(kind(at)) && is_opener(edit.token) ? partner(at) : 0;
    if (edit.partner > 0) try_edit(edit);
    edit.partner = 0;
    try_edit(edit);
  }

  // `age[speed)`, `distance[p, q] <= 2 m`: only aggregates have windows.
  void add_opener_of_call() {
    const bool lacks_operand = error_.expects(T::LEFT_PAREN) && error_.expected.size() == 1 &&
                               error_.index > 0 && kind(error_.index - 1) == T::RIGHT_BRACKET;
    if (kind(error_.index) != T::RIGHT_PAREN && !lacks_operand) return;
    const std::size_t open = lacks_operand ? opening(error_.index - 1) : open_bracket();
    const std::string_view name = callee(open);
    if (kind(open) != T::LEFT_BRACKET || contains(kWindowed, name)) return;
    if (!contains(kOfQuantities, name)) return;
    try_sign({EditKind::replace, EditReason::other_sign, T::LEFT_PAREN, error_.index - open});
  }

  // The bracket that the one at `close` closes.
  [[nodiscard]] std::size_t opening(std::size_t close) const {
    int depth = 0;
    for (std::size_t i = close + 1; i-- > 0;) {
      if (is_closer(kind(i))) ++depth;
      if (is_opener(kind(i)) && --depth == 0) return i;
    }
    return close;
  }

  // `ahead 200 ms,` in front of a line with another clause, whose word was taken for a name.
  void add_end_of_line() {
    const std::size_t at = error_.index;
    if (at < 2 || kind(at - 2) != T::COMMA || !tokens_[at - 1].first_on_line) return;
    if (find_word(kind(at - 1)) == nullptr) return;
    try_edit({EditKind::replace, EditReason::other_sign, T::SEMICOLON, 2});
  }

  // How far behind a bracket stands the other one of its pair; 0: nowhere.
  [[nodiscard]] std::size_t partner(std::size_t open) const {
    const TokenKind opener = kind(open), closer = closer_of(opener);
    int depth = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      if (kind(i) == opener) ++depth;
      if (kind(i) == closer && --depth == 0) return i - open;
    }
    return 0;
  }

  const std::vector<Token>& tokens_;
  const SyntaxError& error_;
  const SourceManager& sources_;
  std::vector<Edit> edits_;
};

}  // namespace

bool groups_conditions(const std::vector<Token>& tokens, std::size_t index) {
  const auto open = bracket_around(tokens, index);
  if (!open || *open == 0 || tokens[*open].kind != T::LEFT_PAREN) return false;
  constexpr std::array before{T::ALWAYS,  T::WHEN,          T::AND,   T::OR,        T::XOR,
                              T::IMPLIES, T::IFF,           T::NOT,   T::IF,        T::THEN,
                              T::ELSE,    T::RIGHT_BRACKET, T::COLON, T::PREVIOUSLY};
  return contains(before, tokens[*open - 1].kind);
}

bool is_least_bound(std::string_view name) {
  return name == "brake" || name == "charge";
}

bool is_unit_word(std::string_view text) {
  return contains(kUnits, text);
}

namespace {

std::size_t letters_at(std::string_view text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(), [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
  });
  return static_cast<std::size_t>(end - text.begin());
}
std::size_t power_at(std::string_view text) {
  if (text.empty() || text.front() != '^') return 0;
  const std::size_t end = text.find_first_not_of("0123456789", text.substr(0, 2) == "^-" ? 2 : 1);
  return end == std::string_view::npos ? text.size() : end;
}

}  // namespace

// Behind a `/` or a `*` it goes on with a unit alone: in `m*factor` it ends.
std::string_view unit_at(std::string_view text) {
  std::size_t end = letters_at(text);
  end += power_at(text.substr(end));
  while (end > 0 && end < text.size() && (text[end] == '/' || text[end] == '*')) {
    const std::size_t letters = letters_at(text.substr(end + 1));
    if (!is_unit_word(text.substr(end + 1, letters))) break;
    end += 1 + letters;
    end += power_at(text.substr(end));
  }
  return text.substr(0, end);
}

bool is_comment_in_unit(const std::vector<Token>& tokens, std::size_t index,
                        const SourceManager& sources) {
  if (index == 0 || tokens[index - 1].kind != T::UNIT) return false;
  const SourceRange& unit = tokens[index - 1].range;
  const std::string_view behind = sources.text(unit.file).substr(unit.end);
  if (behind.substr(0, 2) != "//") return false;
  const std::string_view rest = behind.substr(2);
  if (!is_unit_word(rest.substr(0, letters_at(rest)))) return false;
  // the clause goes on: words behind a blank are those of a comment
  const std::size_t next = rest.find_first_not_of(" \t", unit_at(rest).size());
  return next == std::string_view::npos ||
         std::string_view(";,)]\r\n").find(rest[next]) != std::string_view::npos;
}

bool mends_clause(const std::vector<Token>& tokens, const SyntaxError& error, const Edit& edit,
                  const SourceManager& sources) {
  const std::vector<Token> edited = apply_edit(tokens, error.index, edit);
  const Attempt attempt = attempt_parse(edited, sources);
  if (!attempt.error) return true;
  // A brace that is wrong shifts all that follows: half of it says nothing.
  const bool shifts = edit.reason == EditReason::other_sign &&
                      (is_brace(edit.token) || is_brace(tokens[error.index].kind));
  if (shifts) return false;
  const std::size_t removed = edit.kind == EditKind::remove ? 1 : 0;
  const std::size_t from =
      edit.reason == EditReason::other_sign ? error.index + 1 : edit_index(error.index, edit);
  const std::size_t begin = std::max(from, edit.back > 0 ? error.index - removed : from);
  if (begin >= attempt.error->index) return false;
  const auto at = [&](std::size_t i) { return edited.begin() + static_cast<std::ptrdiff_t>(i); };
  return std::any_of(at(begin), at(attempt.error->index),
                     [](const Token& token) { return ends_clause(token.kind); });
}

std::vector<Edit> find_sign_edits(const std::vector<Token>& tokens, const SyntaxError& error,
                                  const SourceManager& sources) {
  return SignFinder{tokens, error, sources}.run();
}

}  // namespace rtac::syntax
