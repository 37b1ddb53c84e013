#include "compiler/syntax/lexer_sink.h"

#include <algorithm>
#include <utility>

#include "compiler/diagnostics/characters.h"
#include "compiler/syntax/lookalike.h"
#include "compiler/syntax/signs.h"

namespace rtac::syntax {
namespace {

using diag::Code;

// First byte from `from` on that starts a look-alike of an operator.
std::size_t find_operator(std::string_view text, std::size_t from) {
  while (from < text.size() && !(is_high(text[from]) && find_lookalike(text.substr(from)))) ++from;
  return from;
}

// Types of quantities: a unit behind one that has its own is for the checker to report.
bool may_have_unit(std::string_view type) {
  for (const char* quantity : {"real", "vector", "vector3", "int", "point", "length", "time",
                               "speed", "acceleration", "angle", "ratio"}) {
    if (type == quantity) return true;
  }
  return false;
}

bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '%' || c == '"';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Beyond this many lines a quote is not taken for the end of a text.
constexpr int kTextLinesMax = 5;

}  // namespace

LexerSink::LexerSink(FileId file, std::string_view text, std::size_t offset,
                     diag::Engine& diagnostics)
    : file_(file), text_(text), diagnostics_(diagnostics), begin_(offset), end_(offset) {}

void LexerSink::advance(std::size_t length) {
  begin_ = end_;
  end_ += length;
}

SourceRange LexerSink::range(std::size_t begin, std::size_t end) const {
  return {file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

void LexerSink::report(Mistake mistake, SourceRange range) {
  if (diagnostics_.error_count() > kErrorsMax) return;
  diag::Diagnostic diagnostic{mistake.code,
                              range,
                              std::move(mistake.message),
                              std::move(mistake.label),
                              {},
                              std::move(mistake.help),
                              {}};
  if (mistake.replacement) diagnostic.fixits.push_back({range, std::move(*mistake.replacement)});
  diagnostics_.report(std::move(diagnostic));
}

void LexerSink::push(TokenKind kind, std::string text, bool bad) {
  tokens_.push_back({kind, range(), std::move(text), bad || next_is_bad_, at_line_start_});
  at_line_start_ = false;
  next_is_bad_ = false;
  track_depth(kind);
}

void LexerSink::track_depth(TokenKind kind) {
  if (is_closer(kind) && !opened_at_.empty()) {
    closed_at_ = opened_at_.back();
    opened_at_.pop_back();
  }
  if (!is_opener(kind)) return;
  opened_at_.push_back(tokens_.size() - 1);
  if (opened_at_.size() <= kBracketDepthMax) return;
  const std::string limit = std::to_string(kBracketDepthMax);
  report({Code::nesting_too_deep, "brackets are nested more than " + limit + " deep",
          "the file is not read beyond this bracket",
          "give parts of the expression a name of their own"});
  stopped_ = true;
}

// `fun f(x : bool) -> bool`: in front of the result of a function.
bool LexerSink::before_result() const {
  if (tokens_.empty() || tokens_.back().kind != T::RIGHT_PAREN) return false;
  for (auto token = tokens_.rbegin(); token != tokens_.rend(); ++token) {
    if (token->kind == T::FUN) return true;
    if (token->kind == T::ASSIGN || token->kind == T::SEMICOLON) return false;
  }
  return false;
}

// `x => 3 m` compares: nothing follows from a number.
bool LexerSink::before_number() const {
  const std::size_t at = text_.find_first_not_of(" \t-", end_);
  return at != std::string_view::npos && is_digit(text_[at]);
}

// A word needs blanks where a sign needs none: `!open`, `a&&b`.
std::string LexerSink::set_apart(std::string word) const {
  if (!is_word_character(word.front())) return word;
  if (begin_ > 0 && is_word_character(text_[begin_ - 1])) word.insert(0, " ");
  if (end_ < text_.size() && is_word_character(text_[end_])) word += ' ';
  return word;
}

// `{ speed => 1 m/s;`: the name of a bound tells which of both is due, whatever sign is written.
TokenKind LexerSink::relation_of_bound(TokenKind kind) const {
  const std::size_t size = tokens_.size();
  if ((kind != T::LESS_EQUAL && kind != T::GREATER_EQUAL) || size < 2) return kind;
  const TokenKind before = tokens_[size - 2].kind;
  const bool is_name = tokens_[size - 1].kind == T::IDENT || find_word(tokens_[size - 1].kind);
  if (!is_name || (before != T::LEFT_BRACE && before != T::SEMICOLON)) return kind;
  return is_least_bound(text_of(tokens_.back())) ? T::GREATER_EQUAL : T::LESS_EQUAL;
}

// What is written bounds it from the other side.
std::string LexerSink::other_bound(TokenKind kind) const {
  return quote(text_of(tokens_.back())) + " is bounded from " +
         (kind == T::LESS_EQUAL ? "above: `<=`" : "below: `>=`");
}

void LexerSink::foreign_operator(TokenKind kind, std::string_view text) {
  if (text == "->" && before_result()) kind = T::COLON;
  std::string help;
  if (text == "=>" && before_number()) {
    kind = T::GREATER_EQUAL;
  } else if (text == "=>") {
    help = "for a comparison, write `>=`";
  }
  const TokenKind bound = std::exchange(kind, relation_of_bound(kind));
  const std::string ours{token_name(kind)};
  report({Code::wrong_operator, quote(text) + " is not an operator of this language",
          bound == kind ? "`" + ours + "` is meant?" : other_bound(kind), std::move(help),
          set_apart(ours)});
  push(kind, {}, true);
}

void LexerSink::word(std::string_view text) {
  const Word* word = find_word(text);
  const bool is_type = !tokens_.empty() && tokens_.back().kind == T::COLON;
  if (is_type && may_have_unit(text)) real_at_ = tokens_.size();
  if (text == "to") name_box();
  push(word ? word->kind : T::IDENT);
}

// `box (...) to`: the shape. Everywhere else `box` is a name, of a function as well.
void LexerSink::name_box() {
  if (tokens_.empty() || tokens_.back().kind != T::RIGHT_PAREN || closed_at_ == 0) return;
  Token& before = tokens_[closed_at_ - 1];
  if (before.kind == T::IDENT && text_of(before) == "box") before.kind = T::BOX;
}

bool LexerSink::in_type() const {
  return tokens_.size() >= 2 && real_at_ == tokens_.size() - 2;
}

void LexerSink::number(std::string_view text) {
  const bool fits = parse_decimal(text).has_value();
  if (!fits) {
    report({Code::number_too_large, "the number " + quote(text) + " is too long or too large",
            "beyond what a quantity needs",
            "at most 64 digits and an exponent of at most 64 work"});
  }
  push(T::NUMBER, std::string{text}, !fits);
}

void LexerSink::malformed_number(std::string_view text) {
  Mistake mistake{Code::number_malformed, quote(text) + " is not a number", {}};
  std::string repaired{text};
  if (text.front() == '.') {
    mistake.label = "a digit is missing in front of the point";
    repaired.insert(0, "0");
  } else if (text.find('_') != std::string_view::npos) {
    mistake.label = "digits are written without `_`";
    std::erase(repaired, '_');
  } else if (text.size() > 1 && (text[1] == 'x' || text[1] == 'X')) {
    mistake.label = "numbers are written in decimal";
    constexpr std::size_t digits_max = 15;  // 60 bits
    const std::string digits{text.substr(2)};
    repaired = digits.size() > digits_max ? "" : std::to_string(std::stoull(digits, nullptr, 16));
    if (repaired.empty()) mistake.help = "write its decimal digits";
  } else if (text.find('.') == text.size() - 1) {
    mistake.label = "a digit is missing behind the point";
    repaired.pop_back();
  } else {
    mistake.label = "a number has at most one point, between digits";
    mistake.help = "write digits with one point between them, such as `1.5` or `2e-3`";
    repaired.clear();
  }
  if (!repaired.empty()) mistake.replacement = std::move(repaired);
  report(std::move(mistake));
  push(T::NUMBER, "0", true);
}

bool LexerSink::unit(std::string_view text) {
  const std::string_view first = text.substr(0, text.find_first_of("/*^"));
  if (find_word(first)) return false;
  push(T::UNIT, std::string{text});
  return true;
}

std::size_t LexerSink::foreign_unit(std::string_view text) {
  UnitReading reading = read_unit(text);
  if (reading.length == 0) return 0;
  keep(reading.length);
  const std::string_view used = text.substr(0, reading.length);
  if (reading.ascii == used) return unit(used) ? reading.length : 0;
  // degrees Celsius are no unit however they are written, which later phases say
  if (reading.ascii == "degC") return unit(reading.ascii) ? reading.length : 0;
  report({Code::unknown_character,
          "the unit " + quote(used) + " is not written in ASCII",
          "units are made of ASCII letters, `%`, `/`, `*` and `^`",
          {},
          reading.ascii});
  push(T::UNIT, std::move(reading.ascii), true);
  return reading.length;
}

void LexerSink::report_name(std::string_view text) {
  const auto begin =
      static_cast<std::size_t>(std::find_if(text.begin(), text.end(), is_high) - text.begin());
  if (begin > 0 || text.size() > 4) {
    report({Code::unknown_character, quote(text) + " is not a name",
            "names are made of ASCII letters, digits and `_`",
            "other letters may stand in comments and texts"});
  } else {
    report({Code::unknown_character, quote(text) + " has no meaning outside comments and texts",
            "not expected here",
            text == "\u00B1" ? "the error of a measurement is a clause of its input: `error 1 cm`"
                             : "remove it; it may stand in comments and texts"});
  }
}

std::size_t LexerSink::foreign_run(std::string_view text) {
  const std::size_t end = find_operator(text, 0);
  if (end > 0) {
    const std::string_view used = text.substr(0, end);
    keep(end);
    if (std::none_of(used.begin(), used.end(), is_high)) {
      word(used);
    } else {
      report_name(used);
      push(T::IDENT, {}, true);
    }
    return end;
  }
  const Lookalike found = *find_lookalike(text);
  keep(found.text.size());
  if (found.kind == T::END) {
    report({Code::unknown_character,
            diag::code_point(diag::read_character(text).code) +
                " has no meaning outside comments and texts",
            found.ascii.empty() ? "an invisible character stands here" : "a special blank",
            {},
            std::string{found.ascii}});
    next_is_bad_ = true;
  } else {
    const TokenKind kind = relation_of_bound(found.kind);
    report({Code::unknown_character,
            quote(found.text) + " is not an operator of this language",
            kind == found.kind ? "operators are written in ASCII" : other_bound(kind),
            {},
            set_apart(std::string{kind == found.kind ? found.ascii : token_name(kind)})});
    push(kind, {}, true);
  }
  return found.text.size();
}

std::string LexerSink::resolve_escapes(std::string_view inner) {
  std::string result;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != '\\' || i + 1 == inner.size()) {
      result += inner[i];
      continue;
    }
    const char escaped = inner[++i];
    if (escaped == 'n') {
      result += '\n';
    } else if (escaped == 't') {
      result += '\t';
    } else {
      result += escaped;
      if (escaped == '"' || escaped == '\\') continue;
      const std::size_t at = begin_ + 1 + i;  // behind the opening quote
      report({Code::unknown_escape, quote(inner.substr(i - 1, 2)) + " is not an escape",
              "a text knows `\\\"`, `\\\\`, `\\n` and `\\t`", "write `\\\\` for a backslash"},
             range(at - 1, at + 1));
    }
  }
  return result;
}

void LexerSink::string(std::string_view text) {
  push(T::STRING, resolve_escapes(text.substr(1, text.size() - 2)));
}

// Where the closing quote most likely belongs: in front of the next clause of a monitor, else of a
// final `;`, `,` or `{`.
std::size_t LexerSink::text_length(std::string_view text) {
  for (const char* clause : {" always ", " ahead ", " recover ", " return when "}) {
    const std::size_t at = text.find(clause);
    if (at != std::string_view::npos && at > 1) return at;
  }
  const std::size_t last = text.find_last_not_of(" \t\r;,{}");
  return last == std::string_view::npos ? 1 : last + 1;
}

std::size_t LexerSink::unterminated_string(std::string_view text) {
  const std::size_t length = text_length(text);
  const std::size_t close = begin_ + length;
  if (text.back() == '\r') text.remove_suffix(1);
  report_text({range(begin_, begin_ + text.size()),
               "a text does not end on its line",
               "the closing `\"` is missing",
               {{range(close, close), "\""}}});
  keep(length);
  push(T::STRING, std::string{text.substr(1, length - 1)}, true);
  return length;
}

// A quote on one of the next lines that does not itself open a text.
bool LexerSink::continues(std::size_t line_end) const {
  for (int line = 0; line < kTextLinesMax && line_end < text_.size(); ++line) {
    const std::size_t begin = line_end + 1;
    line_end = std::min(text_.find('\n', begin), text_.size());
    const std::string_view text = text_.substr(begin, line_end - begin);
    const auto quotes = std::count(text.begin(), text.end(), '"');
    if (quotes > 0) return quotes % 2 == 1;
    if (text.find_first_of(";{}") != std::string_view::npos) return false;
  }
  return false;
}

void LexerSink::long_string_end() {
  const SourceRange whole = range(string_begin_, end_);
  std::vector<diag::FixIt> fixits;
  std::string joined;
  for (std::size_t at = string_begin_ + 1; at + 1 < end_; ++at) {
    if (text_[at] != '\n') {
      joined += text_[at];
      continue;
    }
    const std::size_t next = std::min(text_.find_first_not_of(" \t\r\n", at), end_ - 1);
    std::size_t last = at;
    while (last > string_begin_ + 1 && (text_[last - 1] == ' ' || text_[last - 1] == '\r')) --last;
    fixits.push_back({range(last, next), " "});
    joined += ' ';
    at = next - 1;
  }
  report_text(
      {whole, "a text does not end on its line", "a text stands on one line", std::move(fixits)});
  begin_ = string_begin_;
  push(T::STRING, std::move(joined), true);
}

void LexerSink::report_text(TextMistake mistake) {
  if (diagnostics_.error_count() > kErrorsMax) return;
  diagnostics_.report({Code::unterminated_string,
                       mistake.range,
                       std::move(mistake.message),
                       std::move(mistake.label),
                       {},
                       {},
                       std::move(mistake.fixits)});
}

void LexerSink::foreign_quotes(std::string_view text, std::size_t quote_length) {
  const std::string inner{text.substr(quote_length, text.size() - 2 * quote_length)};
  report({Code::unknown_character,
          "texts are written in double quotes",
          "these quotes have no meaning",
          {},
          '"' + inner + '"'});
  push(T::STRING, inner, true);
}

// `#include "robots.rta"`: names may be declared there, as behind `include "robots.rta";`.
bool LexerSink::foreign_include() {
  constexpr std::string_view word = "#include", around = " \t\r<>\"";
  std::string_view path = text_.substr(begin_, end_ - begin_);
  if (path.substr(0, word.size()) != word) return false;
  path.remove_prefix(std::min(path.find_first_not_of(around, word.size()), path.size()));
  path = path.substr(0, path.find_last_not_of(around) + 1);
  if (path.empty()) return false;
  const std::string import = "import \"" + std::string{path} + "\";";
  report({Code::unknown_character, "`#` has no meaning outside comments and texts",
          "an include of another language", "a file is imported by `" + import + "`", import});
  // no token stands where another one does
  const std::size_t line_end = end_;
  end_ = begin_ + word.size();
  push(T::IDENT, {}, true);
  begin_ = end_;
  end_ = line_end;
  push(T::STRING, std::string{path}, true);
  begin_ = end_;
  push(T::SEMICOLON, {}, true);
  return true;
}

void LexerSink::hash_comment() {
  if (foreign_include()) return;
  report({Code::unknown_character,
          "`#` does not start a comment",
          "comments start with `//`",
          {},
          "//"},
         range(begin_, begin_ + 1));
  next_is_bad_ = true;
}

void LexerSink::unknown() {
  const bool continues =
      !tokens_.empty() && tokens_.back().kind == T::UNKNOWN && tokens_.back().range.end == begin_;
  if (continues) {
    tokens_.back().range.end = static_cast<std::uint32_t>(end_);
  } else {
    push(T::UNKNOWN);
  }
}

void LexerSink::unterminated_comment() {
  report({Code::unterminated_comment, "a comment does not end", "`*/` is missing behind this",
          "write `*/` where the comment ends, or `//` in front of each of its lines"},
         range(comment_begin_, comment_begin_ + 2));
  next_is_bad_ = true;
}

void LexerSink::end_of_file() {
  begin_ = end_;
  push(T::END);
}

}  // namespace rtac::syntax
