#include "compiler/syntax/foreign.h"

#include <algorithm>
#include <optional>

#include "compiler/syntax/habits.h"

namespace rtac::syntax {
namespace {

using diag::Code;

class Explainer {
 public:
  Explainer(const std::vector<Token>& tokens, const SyntaxError& error,
            const SourceManager& sources, diag::Diagnostic& report)
      : tokens_(tokens), error_(error), sources_(sources), report_(report) {}

  void run() {
    if (report_.code != Code::unexpected_token && report_.code != Code::reserved_word) return;
    if (error_.expects(T::BAD_CLAUSE)) return at_start();
    if (explain_import() || explain_inside() || explain_not() || explain_duration()) return;
    if (explain_rectangle() || explain_since() || explain_brackets() || explain_signs() ||
        explain_name())
      return;
    if (explain_unit() || explain_input()) return;
    if (explain_word(error_.index) || is_clause_start(error_.index)) return;
    if (!explain_word(error_.index - 1) && !explain_word(window_owner())) explain_argument();
  }

 private:
  [[nodiscard]] std::string_view text(std::size_t index) const {
    return sources_.text(tokens_[index].range);
  }
  [[nodiscard]] TokenKind kind(std::size_t index) const { return tokens_[index].kind; }
  [[nodiscard]] bool touches(std::size_t index) const {  // the token before it
    return index > 0 && tokens_[index - 1].range.end == tokens_[index].range.begin;
  }

  void at_start() {
    const bool items = error_.expects(T::ZONE);
    const bool dashes = kind(error_.index) == T::MINUS && error_.index + 1 < tokens_.size() &&
                        kind(error_.index + 1) == T::MINUS && touches(error_.index + 1);
    if (dashes)
      return give("comments start with `//`", {{span(error_.index, error_.index + 1), "//"}});
    if (items && is_file_of_items(tokens_[error_.index])) {
      const std::string import = "import " + std::string{text(error_.index)};
      return give("a file is imported by `" + import + ";`",
                  {{tokens_[error_.index].range, import}});
    }
    const auto help = items                        ? item_habit(text(error_.index))
                      : error_.expects(T::RECOVER) ? clause_habit(text(error_.index))
                                                   : std::nullopt;
    if (help) give(*help);
  }

  void give(std::string_view help, std::vector<diag::FixIt> fixits = {}) {
    report_.help = std::string{help};
    report_.fixits = std::move(fixits);
  }
  [[nodiscard]] SourceRange span(std::size_t first, std::size_t last) const {
    return {tokens_[first].range.file, tokens_[first].range.begin, tokens_[last].range.end};
  }
  // Kind of the token at `index`, END beyond both ends.
  [[nodiscard]] TokenKind kind_at(std::size_t index) const {
    return index < tokens_.size() ? kind(index) : T::END;
  }

  [[nodiscard]] bool is_clause_start(std::size_t index) const {
    if (index == 0) return true;
    const TokenKind before = kind(index - 1);
    return before == T::SEMICOLON || before == T::LEFT_BRACE || before == T::RIGHT_BRACE ||
           before == T::STRING || before == T::BAD_CLAUSE;
  }

  // `always always x`: only the second one is out of place.
  bool explain_word(std::size_t index) {
    const bool is_name = kind(index) == T::IDENT || kind(index) == T::ALWAYS;
    if (!is_name || is_clause_start(index) || kind(index - 1) == T::ENUM) return false;
    const auto help = operator_habit(text(index));
    if (!help) return false;
    report_.range = tokens_[index].range;
    report_.message = "`" + std::string{text(index)} + "` is no operator here";
    report_.label = "not a word that fits here";
    give(*help);
    return true;
  }

  // The word in front of the `[...]` that has just been closed; else the place of the error.
  [[nodiscard]] std::size_t window_owner() const {
    std::size_t index = error_.index - 1;
    if (kind(index) != T::RIGHT_BRACKET) return error_.index;
    while (index > 0 && kind(index) != T::LEFT_BRACKET) --index;
    return index > 0 ? index - 1 : error_.index;
  }

  // `since[0 s, 1 s](a, b)`: operators of two conditions are not called.
  bool explain_since() {
    const TokenKind found = kind(error_.index);
    if (found != T::SINCE || !error_.expects(T::BAD_EXPR)) return false;
    report_.code = Code::unexpected_token;
    report_.message = "`since` stands between two conditions";
    report_.label = "nothing is in front of it";
    give("write `moving since[0 s, 2 s] started`");
    return true;
  }

  // `inside(p, room)`: it is not called either.
  bool explain_inside() {
    if (kind(error_.index) != T::INSIDE || !error_.expects(T::BAD_EXPR)) return false;
    report_.code = Code::unexpected_token;
    report_.message = "`inside` stands between a place and a zone";
    report_.label = "nothing is in front of it";
    give("write `p inside room`");
    return true;
  }

  // `p not inside room`, `x not >= 1 m`
  bool explain_not() {
    const std::size_t at = error_.index;
    if (kind(at) != T::NOT || is_clause_start(at)) return false;
    const TokenKind next = kind_at(at + 1);
    const bool of_place = next == T::INSIDE || next == T::IN;
    const bool of_quantity =
        next == T::LESS || next == T::LESS_EQUAL || next == T::GREATER || next == T::GREATER_EQUAL;
    if (!of_place && !of_quantity) return false;
    report_.message = "`not` stands in front of the whole comparison";
    report_.label = "not between its sides";
    give(of_place ? "write `not p inside room`" : "write `not x >= 1 m`, or `x < 1 m`");
    return true;
  }

  // `import robots.rta;`, `import <robots.rta>;`, `import "a.rta", "b.rta";`
  bool explain_import_of_items() {
    const std::size_t at = error_.index;
    if (kind(at) == T::SEMICOLON || kind(at) == T::END) return false;
    if (at > 1 && kind(at - 2) == T::IMPORT && kind(at) == T::COMMA) {
      give("each file has its own `import`", {{tokens_[at].range, "; import"}});
      return true;
    }
    std::size_t last = at;
    while (kind_at(last + 1) != T::END && kind(last + 1) != T::SEMICOLON &&
           !tokens_[last + 1].first_on_line) {
      ++last;
    }
    constexpr std::string_view around = "<>()'\"";
    std::string path{sources_.text(span(at, last))};
    path.erase(0, path.find_first_not_of(around));
    path.erase(path.find_last_not_of(around) + 1);
    if (is_name(path)) path += ".rta";
    if (path.find_first_of(":,{") != std::string::npos) return false;
    give("the path stands in quotes: `import \"" + path + "\";`",
         {{span(at, last), '"' + path + '"'}});
    return true;
  }

  // `zone a = import(a.geojson)`, `zone a = "a.geojson"`
  bool explain_import() {
    const std::size_t at = error_.index;
    const bool of_items = at > 0 && kind(at - 1) == T::IMPORT && is_clause_start(at - 1);
    const bool of_more =
        at > 1 && kind(at - 2) == T::IMPORT && is_clause_start(at - 2) && kind(at) == T::COMMA;
    if (of_items || of_more) return explain_import_of_items();
    if (at > 0 && kind(at - 1) == T::IMPORT && !is_clause_start(at - 1)) {
      give("the path stands in quotes, without brackets: `import \"field.geojson\"`");
      return true;
    }
    const bool of_zone = at > 2 && kind(at) == T::STRING && kind(at - 1) == T::ASSIGN &&
                         kind(at - 3) == T::ZONE && error_.expects(T::BAD_EXPR);
    if (!of_zone) return false;
    const std::string path{text(at)};
    give("a file of zones is read by `import " + path + "`",
         {{tokens_[at].range, "import " + path}});
    return true;
  }

  // `rect (0 m, 0 m) to (5 m, 5 m)`
  bool explain_rectangle() {
    const std::size_t at = error_.index;
    if (kind(at) != T::TO || at == 0 || kind(at - 1) != T::RIGHT_PAREN) return false;
    std::size_t open = at - 1;
    while (open > 0 && kind(open) != T::LEFT_PAREN) --open;
    if (open == 0 || kind(open - 1) != T::IDENT || kind_at(at + 1) != T::LEFT_PAREN) return false;
    report_.range = tokens_[open - 1].range;
    report_.message = "`" + std::string{text(open - 1)} + "` is no zone";
    report_.label = "not a word that fits here";
    give(
        "from one corner to the other it is a `rectangle`; of space, where corners have three "
        "lengths, a `box`",
        {{tokens_[open - 1].range, "rectangle"}});
    return true;
  }

  // `p within 1 s + 1 s of q`
  bool explain_duration() {
    const TokenKind found = kind(error_.index);
    const bool computed =
        found == T::PLUS || found == T::MINUS || found == T::STAR || found == T::SLASH;
    // `of` may be a name, too, where an operand is due
    if (!computed || !error_.expects(T::OF) || error_.expects(T::BAD_EXPR)) return false;
    give("a duration that is computed stands in brackets: `p within (1 s + 1 s) of q`");
    return true;
  }

  // `mean[2 s](x)` was taken for an element of an array.
  bool explain_interval() {
    const std::size_t at = error_.index, owner = window_owner();
    if (kind(at) != T::LEFT_PAREN || kind(at - 1) != T::RIGHT_BRACKET || owner + 4 > at)
      return false;
    if (kind(owner) != T::IDENT || kind(owner + 2) != T::NUMBER) return false;
    report_.range = span(owner + 1, at - 1);
    report_.message = "an interval has two ends";
    report_.label = "one end";
    const std::string end{sources_.text(span(owner + 2, at - 2))};
    give("write `" + std::string{text(owner)} + "[0 s, " + end + "](x)`",
         {{tokens_[owner + 2].range, "0 s, " + std::string{text(owner + 2)}}});
    return true;
  }

  // `mean[0 s, 2 s] x`
  void explain_argument() {
    const std::size_t at = error_.index, owner = window_owner();
    const bool lacks_bracket = error_.expected.size() == 1 && error_.expects(T::LEFT_PAREN);
    const bool is_operand = kind(at) == T::IDENT || kind(at) == T::NUMBER || kind(at) == T::MINUS;
    if (!lacks_bracket || !is_operand || owner == at || !is_aggregate(text(owner))) return;
    report_.range = span(owner, at - 1);
    const std::string window{sources_.text(*report_.range)};
    report_.message = "`" + window + "` takes its operand in brackets";
    report_.label = "`(` is missing behind it";
    const TokenKind next = kind_at(at + 1);
    const bool goes_on = next == T::DOT || next == T::LEFT_PAREN || next == T::LEFT_BRACKET;
    if (kind(at) != T::IDENT || goes_on) return give("write `" + window + "(x)`");
    const std::string whole = window + "(" + std::string{text(at)} + ")";
    give("write `" + whole + "`", {{span(owner, next == T::RIGHT_PAREN ? at + 1 : at), whole}});
  }
  static bool is_aggregate(std::string_view name) {
    return name == "min" || name == "max" || name == "mean" || name == "sum" || name == "count" ||
           name == "rate";
  }

  // `once(0 s, 2 s) open`, `always[0 s, 2 s] open`.
  bool explain_brackets() {
    const std::size_t at = error_.index;
    if (explain_interval()) return true;
    if (at > 0 && kind(at) == T::LEFT_BRACKET && kind(at - 1) == T::ALWAYS) {
      give(*operator_habit("always"));
      return true;
    }
    if (at == 0 || kind(at - 1) != T::RIGHT_PAREN) return false;
    std::size_t open = at - 1;
    while (open > 0 && kind(open) != T::LEFT_PAREN) --open;
    const TokenKind owner = open > 0 ? kind(open - 1) : T::END;
    if (owner != T::ONCE && owner != T::HISTORICALLY && owner != T::SINCE) return false;
    report_.range = span(open, at - 1);
    report_.message = "the interval of `" + std::string{text(open - 1)} + "` stands in brackets";
    report_.label = "not an operand";
    const std::string inner{sources_.text(
        {tokens_[open].range.file, tokens_[open].range.end, tokens_[at - 1].range.begin})};
    give("write `" + std::string{text(open - 1)} + "[" + inner + "]`",
         {{tokens_[open].range, "["}, {tokens_[at - 1].range, "]"}});
    return true;
  }

  bool explain_signs() {
    const std::size_t at = error_.index;
    if (kind(at) == T::STRING && error_.expects(T::BAD_EXPR)) {
      std::vector<diag::FixIt> fixits;
      const std::string& inner = tokens_[at].text;
      if (is_name(inner)) fixits.push_back({tokens_[at].range, inner});
      give(
          "texts are requirements and reasons; a value of an enumeration is written without "
          "quotes",
          std::move(fixits));
      return true;
    }
    const bool comma = kind(at) == T::COMMA && touches(at) && touches_next(at) &&
                       kind(at - 1) == T::NUMBER && kind_at(at + 1) == T::NUMBER;
    if (comma) {
      give("decimals stand behind a point: `" + std::string{text(at - 1)} + "." +
               std::string{text(at + 1)} + "`",
           {{tokens_[at].range, "."}});
      return true;
    }
    if (kind(at) == T::PIPE && error_.expects(T::BAD_EXPR)) {
      give("the absolute value is `abs(x)`");
      return true;
    }
    if (kind(at) == T::STAR && touches(at) && kind(at - 1) == T::STAR) {
      give("multiply by `*`: `x * x`");
      return true;
    }
    const bool colons = kind(at) == T::COLON && at + 1 < tokens_.size() && touches(at + 1) &&
                        kind(at + 1) == T::COLON;
    if (colons) give("write the name of the value alone, such as `park`, or `Gear.park`");
    return colons;
  }

  static bool is_name(std::string_view text) {
    const auto is_letter = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !text.empty() && is_letter(text.front()) &&
           std::all_of(text.begin(), text.end(),
                       [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
  }
  [[nodiscard]] bool touches_next(std::size_t index) const {
    return index + 1 < tokens_.size() && touches(index + 1);
  }

  // `5 (m)`, `real m`, `real(m)`, `real<m>`.
  bool explain_unit() {
    const std::size_t at = error_.index;
    if (at == 0) return false;
    if (kind(at - 1) == T::NUMBER && kind(at) == T::LEFT_PAREN &&
        kind_at(at + 2) == T::RIGHT_PAREN) {
      const std::string unit{text(at + 1)};
      give("a unit stands behind its number, without brackets: `" + std::string{text(at - 1)} +
               " " + unit + "`",
           {{span(at, at + 2), unit}});
      return true;
    }
    const bool of_type =
        at > 1 && kind(at - 2) == T::COLON && (text(at - 1) == "real" || text(at - 1) == "vector");
    if (!of_type) return false;
    if (kind(at) == T::IDENT || kind(at) == T::UNIT) {
      std::size_t last = at;  // `m/s^2` without blanks
      while (touches_next(last) && kind(last + 1) != T::RIGHT_BRACKET &&
             kind(last + 1) != T::SEMICOLON) {
        ++last;
      }
      const std::string unit = "[" + std::string{sources_.text(span(at, last))} + "]";
      const bool is_closed = kind_at(last + 1) == T::RIGHT_BRACKET;
      give(
          "the unit of a type stands in brackets: `" + std::string{text(at - 1)} + " " + unit + "`",
          {{span(at, is_closed ? last + 1 : last), unit}});
      return true;
    }
    if (kind(at) != T::LEFT_PAREN && kind(at) != T::LESS) return false;
    give("the unit of a type stands in brackets: `real [m/s]`");
    return true;
  }

  // Inside of `input ... ;`: the type in front of the name, clauses in another order.
  bool explain_input() {
    const std::size_t at = error_.index;
    if (at == 0 || clause_word(at) != T::INPUT) return false;
    const bool type_first = kind(at) == T::IDENT && kind(at - 1) == T::IDENT &&
                            kind(at - 2) == T::INPUT && item_habit(text(at - 1));
    if (type_first) {
      const std::string type{text(at - 1)}, name{text(at)};
      give("the name comes first: `input " + name + " : " + type + ";`",
           {{span(at - 1, at), name + " : " + type}});
      return true;
    }
    if (explain_unit_first()) return true;
    const bool late = kind(at) == T::IN || kind(at) == T::ERROR || kind(at) == T::MAX_AGE;
    if (!late || !error_.expects(T::SEMICOLON)) return false;
    give(
        "the clauses of an input stand in this order: `in 0 .. 3 m/s error 1 cm/s max_age 100 ms "
        "resolution 1 mm/s`");
    return true;
  }
  // `input real [m/s] speed`
  bool explain_unit_first() {
    const std::size_t at = error_.index;
    if (at < 2 || kind(at) != T::LEFT_BRACKET || kind(at - 2) != T::INPUT) return false;
    if (!item_habit(text(at - 1))) return false;
    std::string type = std::string{text(at - 1)} + " ";
    std::size_t next = at;
    for (; next < tokens_.size() && kind(next) != T::SEMICOLON; ++next) {
      type += text(next);
      if (kind(next) == T::RIGHT_BRACKET) break;
    }
    if (kind_at(next) != T::RIGHT_BRACKET || kind_at(next + 1) != T::IDENT) return false;
    const std::string name{text(next + 1)};
    give("the name comes first: `input " + name + " : " + type + ";`",
         {{span(at - 1, next + 1), name + " : " + type}});
    return true;
  }
  [[nodiscard]] TokenKind clause_word(std::size_t index) const {
    while (index > 0 && !is_clause_start(index)) --index;
    return kind(index);
  }

  // `door-open` where a name is declared; `max-age`.
  bool explain_name() {
    const std::size_t at = error_.index;
    if (kind(at) == T::IDENT && kind_at(at + 1) == T::MINUS && touches_next(at)) {
      const std::string joined = std::string{text(at)} + "_" + std::string{text_at(at + 2)};
      const Word* word = find_word(joined);
      if (word == nullptr || !error_.expects(word->kind)) return false;
      give("words consist of letters and `_`: `" + joined + "`", {{span(at, at + 2), joined}});
      report_.range = tokens_[at].range;  // nothing is missing in front of it
      report_.label = "no word of the language";
      return true;
    }
    const bool hyphen = kind(at) == T::MINUS && touches(at) && at + 1 < tokens_.size() &&
                        touches(at + 1) && !error_.expects(T::PLUS);
    const TokenKind after = hyphen ? kind(at + 1) : T::END;
    if (after != T::IDENT) return false;
    const std::string joined = std::string{text(at - 1)} + "_" + std::string{text(at + 1)};
    give("names consist of letters, digits and `_`: `" + joined + "`",
         {{span(at - 1, at + 1), joined}});
    return true;
  }
  [[nodiscard]] std::string_view text_at(std::size_t index) const {
    return index < tokens_.size() ? text(index) : std::string_view{};
  }

  const std::vector<Token>& tokens_;
  const SyntaxError& error_;
  const SourceManager& sources_;
  diag::Diagnostic& report_;
};

}  // namespace

void explain_foreign(const std::vector<Token>& tokens, const SyntaxError& error,
                     const SourceManager& sources, diag::Diagnostic& report) {
  Explainer{tokens, error, sources, report}.run();
}

}  // namespace rtac::syntax
