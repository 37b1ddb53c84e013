#include "compiler/syntax/describe.h"

#include <algorithm>
#include <string>
#include <utility>

#include "compiler/syntax/foreign.h"
#include "compiler/syntax/forms.h"
#include "compiler/syntax/lookalike.h"
#include "compiler/syntax/signs.h"

namespace rtac::syntax {
namespace {

using diag::Code;
using diag::Diagnostic;

bool is_operator(TokenKind kind) {
  return (kind >= T::LESS && kind <= T::SLASH) || kind == T::INSIDE ||
         (kind >= T::AND && kind <= T::XOR);
}

// Behind a name: `shrink(`, `room - pit`.
bool computes_zone(TokenKind kind) {
  return kind == T::LEFT_PAREN || kind == T::MINUS || kind == T::AMPERSAND || kind == T::PIPE;
}

std::string join_choices(const std::vector<std::string>& choices) {
  std::string result;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (i > 0) result += i + 1 == choices.size() ? " or " : ", ";
    result += choices[i];
  }
  return result;
}

class Describer {
 public:
  Describer(const std::vector<Token>& tokens, const SyntaxError& error,
            const SourceManager& sources)
      : tokens_(tokens), error_(error), sources_(sources), found_(tokens[error.index]) {}

  Diagnostic describe(const std::optional<Edit>& edit) {
    if (found_.kind == T::UNKNOWN) return unknown_character();
    if (is_comment_in_unit(tokens_, error_.index, sources_)) return comment_in_unit();
    if (is_computed_zone()) return computed_zone();
    if (!edit) return plain();
    switch (edit->reason) {
      case EditReason::missing:
        return missing(edit->token);
      case EditReason::missing_earlier:
        return Describer{tokens_, earlier(*edit), sources_}.missing(edit->token);
      case EditReason::misspelled:
        return Describer{tokens_, earlier(*edit), sources_}.misspelled(edit->token);
      case EditReason::separator:
        return separator(edit->token);
      case EditReason::foreign_operator:
        return foreign_operator(edit->token);
      case EditReason::chained_comparison:
        return chained_comparison();
      case EditReason::word_as_name:
        return word_as_name();
      case EditReason::missing_operand:
        return edit->back == 0
                   ? plain()
                   : Describer{tokens_, {error_.index - edit->back, {T::IDENT}}, sources_}.plain();
      case EditReason::superfluous:
        if (edit->back > 0) return trailing_comma();
        return superfluous(edit->kind == EditKind::remove);
      case EditReason::doubled:
        return Describer{tokens_, earlier(*edit), sources_}.doubled();
      case EditReason::other_sign:
        return Describer{tokens_, earlier(*edit), sources_}.other_sign(*edit);
      case EditReason::unit_of_name:
        return unit_of_name(*edit);
      case EditReason::missing_number:
        return missing_number();
    }
    return plain();
  }

 private:
  // The same mistake, told of the token that the edit is about.
  [[nodiscard]] SyntaxError earlier(const Edit& edit) const {
    return {error_.index - edit.back, error_.expected};
  }
  static std::string ticks(TokenKind kind) { return '`' + std::string{token_name(kind)} + '`'; }

  [[nodiscard]] Diagnostic make(Code code, std::string message, std::string label) const {
    return {code, found_.range, std::move(message), std::move(label), {}, {}, {}};
  }

  // END of a stretch carries the place of the token behind it.
  [[nodiscard]] std::string found() const {
    if (found_.range.begin == found_.range.end) return "the end of the file";
    if (found_.kind == T::STRING) return "a text";
    return quote(sources_.text(found_.range));
  }

  // " after the unit": where the author was; empty at the start of a stretch.
  [[nodiscard]] std::string after() const {
    if (error_.index == 0) return {};
    const Token& previous = tokens_[error_.index - 1];
    switch (previous.kind) {
      case T::UNIT:
        return " after the unit";
      case T::NUMBER:
        return " after the number";
      case T::STRING:
        return " after the text";
      case T::BAD_EXPR:
      case T::BAD_CLAUSE:
      case T::SEMICOLON:
      case T::LEFT_BRACE:
      case T::RIGHT_BRACE:
        return {};
      default:
        return previous.range.begin == previous.range.end
                   ? std::string{}
                   : " after " + quote(sources_.text(previous.range));
    }
  }

  [[nodiscard]] SourceRange behind_previous() const {
    if (error_.index == 0) return found_.range;
    const SourceRange& previous = tokens_[error_.index - 1].range;
    return {previous.file, previous.end, previous.end};
  }

  // What would fit, in a few words: an expression or a name stands for all that can start it, and
  // operators are only named when nothing else fits.
  [[nodiscard]] std::string expected() const {
    if (at_item()) return "an item such as `input`, `zone`, `robot` or `monitor`";
    std::vector<std::string> choices;
    if (error_.expects(T::BAD_EXPR)) {
      choices.emplace_back("an expression");
    } else if (error_.expects(T::IDENT)) {
      choices.emplace_back("a name");
    }
    const bool names_fit = !choices.empty();
    bool operators_fit = false;
    for (const TokenKind kind : error_.expected) {
      operators_fit = operators_fit || is_operator(kind);
      if (kind == T::BAD_CLAUSE || kind == T::BAD_EXPR || kind == T::IDENT) continue;
      const bool starts_name = names_fit && (find_word(kind) || kind == T::NUMBER);
      const bool starts_expr = error_.expects(T::BAD_EXPR) && is_expression_start(kind);
      const bool is_one_of_many = is_operator(kind) || is_postfix(kind);
      if (!starts_name && !starts_expr && !is_one_of_many) choices.push_back(describe_kind(kind));
    }
    if (choices.empty() && operators_fit) return operators();
    return join_choices(choices);
  }

  [[nodiscard]] std::string operators() const {
    std::vector<std::string> choices;
    for (const TokenKind kind : error_.expected) {
      if (is_operator(kind)) choices.push_back(ticks(kind));
    }
    return choices.size() > 4 ? "an operator" : join_choices(choices);
  }

  static bool is_expression_start(TokenKind kind) {
    return kind == T::LEFT_PAREN || kind == T::MINUS || kind == T::NUMBER || kind == T::BOX ||
           find_word(kind);
  }

  // What may follow an operand: `x.y`, `f(x)`, `a[2]`, `φ for 1 s`, `φ since ψ`.
  [[nodiscard]] bool is_postfix(TokenKind kind) const {
    if (kind == T::UNIT) return true;
    if (kind == T::LEFT_BRACKET) return error_.expected.size() > 1;
    const bool follows_operand = kind == T::DOT || kind == T::LEFT_PAREN || kind == T::FOR ||
                                 kind == T::SINCE || kind == T::WITHIN || kind == T::DURING ||
                                 kind == T::AROUND;
    return follows_operand && (error_.expects(T::PLUS) || error_.expects(T::OF));
  }

  static std::string describe_kind(TokenKind kind) {
    switch (kind) {
      case T::STRING:
        return "a text";
      case T::NUMBER:
        return "a number";
      case T::MOMENT:
        return "a moment";
      case T::END:
        return "the end of the file";
      default:
        return ticks(kind);
    }
  }

  [[nodiscard]] bool at_item() const {
    return error_.expects(T::BAD_CLAUSE) && error_.expects(T::ZONE);
  }

  // Clauses of `input` stand in one order; elsewhere an `in` is a comparison of other languages.
  [[nodiscard]] bool in_input() const { return error_.expects(T::RESOLUTION); }

  [[nodiscard]] Diagnostic plain() const {
    if (lacks_operator()) {
      return make(Code::unexpected_token, "expected an operator" + after() + ", found " + found(),
                  "an operator such as `<=` is missing");
    }
    const std::string what = expected();
    if (error_.expects(T::BAD_CLAUSE) && error_.expects(T::RIGHT_BRACE)) {
      return make(Code::unexpected_token, found() + " starts no clause here", "expected " + what);
    }
    Diagnostic result =
        make(Code::unexpected_token, "expected " + what + after() + ", found " + found(),
             "expected " + what);
    if (found_.kind == T::IN && error_.expects(T::AND) && !in_input()) {
      result.help = "compare with both ends: `x >= 0 m and x <= 3 m`";
    }
    const bool after_spec = error_.index > 0 && tokens_[error_.index - 1].kind == T::SPEC;
    if (after_spec) result.code = Code::missing_spec_name;
    return result;
  }

  [[nodiscard]] Diagnostic missing(TokenKind kind) const {
    if ((kind == T::COMMA && lacks_more()) || (kind == T::SEMICOLON && lacks_operator())) {
      return plain();
    }
    const std::string what = describe_kind(kind);
    Diagnostic result =
        make(Code::unexpected_token, "expected " + what + after() + ", found " + found(),
             what + " is missing");
    if (kind == T::SEMICOLON) result.code = Code::missing_semicolon;
    result.range = behind_previous();
    const bool is_word = find_word(kind) != nullptr;
    const bool writable =
        kind != T::STRING && kind != T::NUMBER && kind != T::MOMENT && kind != T::IDENT;
    if (writable) {
      result.fixits.push_back(
          {behind_previous(), (is_word ? " " : "") + std::string{token_name(kind)}});
    }
    if (is_closer(kind)) {
      result.code = Code::unclosed_bracket;
      add_opener(result);
    }
    return result;
  }

  // `within room - grow(pit, 10 cm) speed 0.1 m/s`: recoveries know zones by their names.
  [[nodiscard]] bool is_computed_zone() const {
    const std::size_t at = error_.index;
    if (!error_.expects(T::SPEED) || !computes_zone(found_.kind) || at < 2) return false;
    return tokens_[at - 1].kind == T::IDENT && tokens_[at - 2].kind == T::WITHIN;
  }
  [[nodiscard]] Diagnostic computed_zone() const {
    const SourceRange& first = tokens_[error_.index - 1].range;
    const auto ends = [](TokenKind kind) {
      return kind == T::SPEED || kind == T::ORDER || kind == T::END || ends_clause(kind);
    };
    std::size_t last = error_.index - 1;
    int open = 0;
    while (!ends(tokens_[last + 1].kind)) {
      ++last;
      open += tokens_[last].kind == T::LEFT_PAREN ? 1 : 0;
      open -= tokens_[last].kind == T::RIGHT_PAREN ? 1 : 0;
    }
    std::string zone{sources_.text({first.file, first.begin, tokens_[last].range.end})};
    const bool is_whole = open == 0 && zone.find_first_of("\n;") == std::string::npos;
    if (!is_whole) zone = "shrink(yard, 10 cm)";
    Diagnostic result =
        make(Code::unexpected_token, "expected `speed`" + after() + ", found " + found(),
             "the name of a zone is due");
    result.help = "recoveries move within a zone that has a name: `zone inner = " + zone +
                  ";`, `within inner`";
    return result;
  }

  // `speed 2 m/s` where a comparison is due: a number starts no clause and ends none. Other clauses
  // of an input may be what is missing in front of it.
  [[nodiscard]] bool lacks_operator() const {
    const bool has_clauses = error_.expects(T::MAX_AGE) || error_.expects(T::RESOLUTION) ||
                             error_.expects(T::WAYPOINTS) || error_.expects(T::AT);
    return found_.kind == T::NUMBER && !found_.first_on_line && error_.expects(T::PLUS) &&
           !has_clauses;
  }

  // `100 ms` alone behind the error of an input lacks a word, `(a b)` an operator: a `,` would be
  // read, and be wrong.
  [[nodiscard]] bool lacks_more() const {
    return error_.expects(T::MAX_AGE) || error_.expects(T::RESOLUTION) ||
           groups_conditions(tokens_, error_.index);
  }

  // `3 m//s`
  [[nodiscard]] Diagnostic comment_in_unit() const {
    const SourceRange& unit = tokens_[error_.index - 1].range;
    Diagnostic result = make(Code::unexpected_token, "`//` starts a comment, also behind a unit",
                             "the rest of the line is not read");
    result.range = {unit.file, unit.end, unit.end + 2};
    result.help = "a unit has one `/` at a time: `m/s`";
    result.fixits.push_back({*result.range, "/"});
    return result;
  }

  // Points at the bracket that is still open.
  void add_opener(Diagnostic& result) const {
    int depth = 0;
    for (std::size_t i = error_.index; i-- > 0;) {
      const TokenKind kind = tokens_[i].kind;
      if (is_closer(kind)) ++depth;
      if (!is_opener(kind) || depth-- > 0) continue;
      result.notes.push_back({tokens_[i].range, ticks(kind) + " is opened here"});
      return;
    }
  }

  [[nodiscard]] Diagnostic unknown_character() const {
    const std::string_view text = sources_.text(found_.range);
    Diagnostic result =
        make(Code::unknown_character, quote(text) + " has no meaning outside comments and texts",
             "not expected here");
    if (text.front() == '%') {
      result.label = "`%` is a unit: it stands behind a number";
      result.help = "write the number in front of it: `5 %`, `0.4 %/m`; there are no remainders";
    } else if (text.front() == '?') {
      result.help = "a choice is written `if c then a else b`";
    } else if (text.front() == '^') {
      result.label = "`^` belongs to a unit, without blanks: `m/s^2`";
      result.help = "multiply values by `*`: `x * x`; of two conditions one alone: `xor`";
    } else {
      result.help = "remove it, or write what it stands for in words of the language";
    }
    return result;
  }

  // Which of two numbers is meant is the author's to say.
  [[nodiscard]] Diagnostic doubled() const {
    Diagnostic result = make(Code::unexpected_token, found() + " stands twice", "the second one");
    if (found_.kind == T::NUMBER) {
      result.help = "leave one of them out, or write what is missing between them";
    } else {
      const SourceRange& first = tokens_[error_.index - 1].range;
      result.fixits.push_back({{first.file, first.end, found_.range.end}, ""});
    }
    return result;
  }

  [[nodiscard]] Diagnostic misspelled(TokenKind kind) const {
    Diagnostic result = make(Code::unexpected_token, found() + " is not a word that fits here",
                             "did you mean " + ticks(kind) + "?");
    result.fixits.push_back({found_.range, std::string{token_name(kind)}});
    return result;
  }

  [[nodiscard]] Diagnostic separator(TokenKind kind) const {
    Diagnostic result =
        make(Code::unexpected_token, "expected " + ticks(kind) + after() + ", found " + found(),
             ticks(kind) + " is due");
    // all of a list at once
    for (std::size_t i = error_.index; i < tokens_.size(); ++i) {
      const bool ends = ends_clause(tokens_[i].kind) || kind != T::GREATER;
      if (ends && i > error_.index) break;
      if (tokens_[i].kind != found_.kind) continue;
      const bool touches = i > 0 && tokens_[i - 1].range.end == tokens_[i].range.begin;
      const bool is_relation = kind != T::COMMA && kind != T::DOT_DOT;
      result.fixits.push_back(
          {tokens_[i].range, (touches && is_relation ? " " : "") + std::string{token_name(kind)}});
    }
    return result;
  }

  // Of a pair of brackets both.
  [[nodiscard]] Diagnostic other_sign(const Edit& edit) const {
    Diagnostic result = make(Code::unexpected_token,
                             "expected " + ticks(edit.token) + after() + ", found " + found(),
                             ticks(edit.token) + " is due");
    result.fixits.push_back({found_.range, std::string{token_name(edit.token)}});
    if (edit.partner > 0) {
      result.fixits.push_back({tokens_[error_.index + edit.partner].range,
                               std::string{token_name(closer_of(edit.token))}});
    }
    if (is_closer(edit.token)) add_opener(result);
    return result;
  }

  [[nodiscard]] Diagnostic unit_of_name(const Edit& edit) const {
    const SourceRange& before = tokens_[error_.index - 1].range;
    const SourceRange& last = tokens_[error_.index + edit.swallows].range;
    Diagnostic result = make(Code::unexpected_token, "a unit stands behind a number, not" + after(),
                             "what is in front of it has its unit already");
    result.range = {found_.range.file, found_.range.begin, last.end};
    result.fixits.push_back({{before.file, before.end, last.end}, ""});
    return result;
  }

  [[nodiscard]] Diagnostic missing_number() const {
    const SourceRange& next = tokens_[error_.index + 1].range;
    const std::string unit{unit_at(sources_.text(next.file).substr(next.begin))};
    Diagnostic result =
        make(Code::unexpected_token,
             "expected a number in front of `" + unit + "`, found " + found(), "a number is due");
    result.help = "write the number that is meant, such as `3 " + unit + '`';
    return result;
  }

  [[nodiscard]] Diagnostic trailing_comma() const {
    const SourceRange& comma = tokens_[error_.index - 1].range;
    Diagnostic result = make(Code::unexpected_token, "nothing follows the `,` of a list",
                             "not needed in front of " + found());
    result.range = comma;
    result.fixits.push_back({comma, ""});
    return result;
  }

  [[nodiscard]] Diagnostic foreign_operator(TokenKind kind) const {
    if (kind == T::EQUAL && in_input()) return input_value();
    Diagnostic result =
        kind == T::EQUAL
            ? make(Code::wrong_operator, "`=` defines and does not compare", "a comparison is due")
            : make(Code::wrong_operator, "`==` compares and does not define",
                   "write `=` to define");
    if (kind == T::EQUAL) {
      // not `==` alone: whatever is measured never equals a number exactly
      result.help = "write `<=` or `>=`; `==` compares whole numbers, conditions and enumerations";
    } else {
      result.fixits.push_back({found_.range, std::string{token_name(kind)}});
    }
    return result;
  }

  [[nodiscard]] Diagnostic input_value() const {
    Diagnostic result = make(Code::unexpected_token, "an input has no value of its own",
                             "what is measured comes at run time");
    result.help =
        "leave it out, or declare a `param`: `param gap : length in 0.1 m .. 0.5 m = 0.2 m;`";
    return result;
  }

  [[nodiscard]] Diagnostic chained_comparison() const {
    Diagnostic result = make(Code::chained_comparison, "comparisons cannot be chained",
                             "a second comparison of the same expression");
    result.help = "write two comparisons joined by `and`: `a <= x and x <= b`";
    return result;
  }

  [[nodiscard]] Diagnostic word_as_name() const {
    Diagnostic result =
        make(Code::reserved_word, found() + " is a word of the language and cannot be a name",
             "expected " + expected());
    const std::string word{sources_.text(found_.range)};
    result.help = "choose another name, such as `my_" + word + '`';
    return result;
  }

  [[nodiscard]] Diagnostic superfluous(bool removed) const {
    if (found_.kind == T::RIGHT_BRACE && error_.expects(T::END)) {
      Diagnostic result = make(Code::unexpected_token, "`}` closes nothing", "no `{` is open here");
      result.fixits.push_back({found_.range, ""});
      return result;
    }
    if (found_.kind == T::SEMICOLON && error_.expects(T::BAD_CLAUSE) && may_be_removed()) {
      Diagnostic result =
          make(Code::unexpected_token, "a `;` that ends nothing", "not needed here");
      result.fixits.push_back({found_.range, ""});
      return result;
    }
    Diagnostic result = plain();
    if (removed && may_be_removed()) result.fixits.push_back({found_.range, joint()});
    return result;
  }

  // A word or a number means something: leaving it out is no repair. Neither is it of a sign that
  // may stand for something: `10 )` for a unit, the first one of a monitor for its text.
  [[nodiscard]] bool may_be_removed() const {
    const std::size_t at = error_.index;
    const bool is_sign = found_.kind != T::IDENT && found_.kind != T::NUMBER &&
                         found_.kind != T::UNIT && found_.kind != T::STRING &&
                         find_word(found_.kind) == nullptr;
    if (!is_sign || at == 0) return is_sign;
    const TokenKind before = tokens_[at - 1].kind;
    const bool touches = tokens_[at - 1].range.end == found_.range.begin;
    const bool ends_unit = before == T::UNIT && (found_.kind == T::SLASH || found_.kind == T::STAR);
    if ((before == T::NUMBER && !touches) || ends_unit) return false;
    return before != T::LEFT_BRACE || !error_.expects(T::ALWAYS) ||
           tokens_[at + 1].kind == T::STRING;
  }

  // What keeps the words on both sides of a sign that goes apart.
  [[nodiscard]] std::string joint() const {
    const auto is_word = [&](std::size_t i) {
      const TokenKind kind = tokens_[i].kind;
      return kind == T::IDENT || kind == T::NUMBER || kind == T::UNIT || find_word(kind) != nullptr;
    };
    const std::size_t at = error_.index;
    const bool joins = at > 0 && at + 1 < tokens_.size() && is_word(at - 1) && is_word(at + 1) &&
                       tokens_[at - 1].range.end == found_.range.begin &&
                       tokens_[at + 1].range.begin == found_.range.end;
    return joins ? " " : "";
  }

  const std::vector<Token>& tokens_;
  const SyntaxError& error_;
  const SourceManager& sources_;
  const Token& found_;
};

}  // namespace

// A sign that is not all that is missing may be another one than that which is due, and one that is
// not all that is too much may stand for what is missing.
static bool may_mislead(const Edit& edit, TokenKind found) {
  if (edit.kind == EditKind::remove) {
    return edit.reason == EditReason::superfluous && found != T::RIGHT_BRACE && edit.back == 0;
  }
  return edit.kind == EditKind::insert && edit.reason == EditReason::missing &&
         edit.token != T::COLON && edit.token != T::SEMICOLON &&
         (!find_word(edit.token) || edit.token == T::THEN || edit.token == T::ELSE);
}

Diagnostic describe_error(const std::vector<Token>& tokens, const SyntaxError& error,
                          const std::optional<Edit>& edit, bool mends,
                          const SourceManager& sources) {
  const bool misleads = edit && !mends && may_mislead(*edit, tokens[error.index].kind);
  const bool closes = edit && edit->kind == EditKind::insert &&
                      is_closer(edit->token);  // what is open is told all the same
  Describer describer{tokens, error, sources};
  Diagnostic result = describer.describe(misleads && !closes ? std::nullopt : edit);
  if (misleads) result.fixits.clear();
  if (edit && edit->reason == EditReason::doubled) return result;
  explain_foreign(tokens, error, sources, result);
  if (result.help.empty() && result.fixits.empty()) result.help = form_help(tokens, error);
  return result;
}

}  // namespace rtac::syntax
