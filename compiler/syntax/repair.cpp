#include "compiler/syntax/repair.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "compiler/syntax/builder.h"
#include "compiler/syntax/describe.h"
#include "compiler/syntax/edit.h"
#include "compiler/syntax/lexer.h"
#include "compiler/syntax/signs.h"

namespace rtac::syntax {
namespace {

// Parses of one stretch. Each repairs one mistake; those that may follow from others are not
// reported, so the limit of errors alone would not end a flood of them.
constexpr int kRoundsMax = 100;

class Repairer {
 public:
  Repairer(std::vector<Token> tokens, const SourceManager& sources, diag::Engine& diagnostics)
      : tokens_(std::move(tokens)), sources_(sources), diagnostics_(diagnostics) {}

  Attempt run() {
    for (int round = 0;; ++round) {
      Attempt attempt = attempt_parse(tokens_, sources_);
      if (!attempt.error) {
        report_height(attempt);
        return finish(std::move(attempt));
      }
      const bool flooded = round >= kRoundsMax || diagnostics_.error_count() > kErrorsMax;
      if (flooded || !handle(*attempt.error)) {
        lose(0, tokens_.size());
        loss_.items = true;
        return finish(std::move(attempt));
      }
    }
  }

 private:
  Attempt finish(Attempt attempt) {
    attempt.loss = std::move(loss_);
    attempt.silent_edits = std::move(silent_edits_);
    return attempt;
  }

  // Names among the tokens in [begin, end), also what looks like a unit behind a number: `1 v :
  // bool`.
  void lose(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Word* word = find_word(tokens_[i].kind);
      const bool may_be_name = word != nullptr && word->word_kind != WordKind::item &&
                               word->word_kind != WordKind::reserved;
      const bool is_name = tokens_[i].kind == T::IDENT || tokens_[i].kind == T::UNIT;
      if (!is_name && !may_be_name) continue;
      loss_.names.emplace(sources_.text(tokens_[i].range));
    }
  }

  // False when the rest cannot be understood.
  bool handle(const SyntaxError& error) {
    const std::optional<Edit> edit = find_edit(tokens_, error, sources_);
    const bool doubtful = is_doubtful(error.index);
    const bool silent = doubtful || follows_bad_token(error.index) || is_left_over(error, edit) ||
                        is_used_as_declared(error.index, edit) || rest_is_comment_;
    rest_is_comment_ = rest_is_comment_ || is_comment_in_unit(tokens_, error.index, sources_);
    if (!silent) {
      diagnostics_.report(describe_error(
          tokens_, error, edit, edit && mends_clause(tokens_, error, *edit, sources_), sources_));
    } else {
      silent_edits_.push_back(tokens_[error.index].range);
    }
    if (follows_item(error)) silent_edits_.push_back(tokens_[error.index - 1].range);
    item_in_doubt_ = item_in_doubt_ || puts_item_in_doubt(error, edit);
    // a name that is missing may be any that is used
    const bool no_name = edit && edit->kind == EditKind::insert && edit->token == T::IDENT;
    loss_.rest = loss_.rest || no_name || lacks_declared_name(error);
    if (!edit || doubtful) return drop_clause(error.index);
    const std::size_t at = edit_index(error.index, *edit);
    if (edit->kind != EditKind::insert) lose(at, at + 1);
    // `input float x`: what looks like a type may be the name
    if (edit->kind == EditKind::insert && edit->token == T::COLON) lose(error.index, at + 2);
    tokens_ = apply_edit(std::move(tokens_), error.index, *edit);
    edited_at_ = edit_index(error.index, *edit);
    // What follows a `;` or `}` that was removed between clauses is whole, on another line.
    const bool starts_line = tokens_[error.index].first_on_line;
    if (edit->kind == EditKind::remove && error.expects(T::BAD_CLAUSE) && starts_line) {
      edited_at_.reset();
    }
    return true;
  }

  [[nodiscard]] bool follows_bad_token(std::size_t index) const {
    return tokens_[index].bad || tokens_[index].kind == T::BAD_CLAUSE ||
           (index > 0 && tokens_[index - 1].bad);
  }

  // An error in the clause that was edited last may be a consequence of the edit.
  [[nodiscard]] bool is_doubtful(std::size_t index) const {
    if (!edited_at_ || *edited_at_ > index) return false;
    // a `{` that was missing: the `}` of it is, too
    const std::size_t edited = *edited_at_ + (tokens_[*edited_at_].kind == T::LEFT_BRACE ? 1 : 0);
    return std::none_of(tokens_.begin() + static_cast<std::ptrdiff_t>(std::min(edited, index)),
                        tokens_.begin() + static_cast<std::ptrdiff_t>(index),
                        [](const Token& token) { return ends_clause(token.kind); });
  }

  static bool is_between_items(const SyntaxError& error) {
    return error.expects(T::BAD_CLAUSE) && error.expects(T::ZONE);
  }

  // `input p : point in 0 .. 9; m error 1 cm;`, `robot R { ... } } sense ...`: the item in front of
  // the mistake may have ended too early.
  [[nodiscard]] bool follows_item(const SyntaxError& error) const {
    if (!is_between_items(error) || error.index == 0) return false;
    const Token& found = tokens_[error.index];
    const Word* word = find_word(found.kind);
    const bool is_clause = word != nullptr && word->word_kind == WordKind::clause;
    const TokenKind before = tokens_[error.index - 1].kind;
    return before == T::SEMICOLON ? !found.first_on_line : is_clause && before == T::RIGHT_BRACE;
  }

  static bool is_misspelled(const std::optional<Edit>& edit) {
    return edit && edit->reason == EditReason::misspelled;
  }

  // A word of the language that was declared as a name, and reported there.
  [[nodiscard]] bool is_used_as_declared(std::size_t index, const std::optional<Edit>& edit) const {
    if (!edit || edit->reason != EditReason::word_as_name) return false;
    const auto& all = diagnostics_.all();
    return std::any_of(all.begin(), all.end(), [&](const diag::Diagnostic& each) {
      return each.code == diag::Code::reserved_word &&
             sources_.text(*each.range) == sources_.text(tokens_[index].range);
    });
  }

  // `input ( : bool;`, `enum G { 1, b }`: the name that is declared there is something else. In
  // `fun slowv : speed)` it is less.
  [[nodiscard]] bool lacks_declared_name(const SyntaxError& error) const {
    const std::size_t i = error.index;
    if (i > 1 && tokens_[i - 2].kind == T::FUN) return true;
    if (i == 0 || !error.expects(T::IDENT) || error.expects(T::BAD_EXPR)) return false;
    const TokenKind before = tokens_[i - 1].kind;
    const Word* word = find_word(before);
    const bool starts_item =
        word != nullptr && (word->word_kind == WordKind::item || word->word_kind == WordKind::soft);
    const bool starts_enum = before == T::LEFT_BRACE && i > 2 && tokens_[i - 3].kind == T::ENUM;
    return starts_item || starts_enum || before == T::COMMA;
  }

  static bool is_brace(TokenKind kind) { return kind == T::LEFT_BRACE || kind == T::RIGHT_BRACE; }

  // May this mistake have ended its item too early?
  [[nodiscard]] bool puts_item_in_doubt(const SyntaxError& error,
                                        const std::optional<Edit>& edit) const {
    if (!edit || is_brace(edit->token) || is_brace(tokens_[error.index].kind)) return true;
    return is_between_items(error) && !is_misspelled(edit);
  }

  // What follows a dropped clause on its line, or an item that ended too early by an earlier
  // mistake, is a rest of it.
  [[nodiscard]] bool is_left_over(const SyntaxError& error, const std::optional<Edit>& edit) const {
    const bool after_drop = error.index > 0 && tokens_[error.index - 1].kind == T::BAD_CLAUSE;
    if (after_drop && !tokens_[error.index].first_on_line) return true;
    const bool outside = is_between_items(error) || in_likely_clause(error.index);
    return item_in_doubt_ && outside && !is_misspelled(edit);
  }

  // `input` and `period` are items and clauses alike: behind an item that ended too early they may
  // be its clauses.
  [[nodiscard]] bool in_likely_clause(std::size_t index) const {
    const std::size_t begin = clause_begin(index);
    const TokenKind first = tokens_[begin].kind;
    return (first == T::INPUT || first == T::PERIOD) && brace_depth(begin) == 0;
  }

  [[nodiscard]] int brace_depth(std::size_t index) const {
    int depth = 0;
    for (std::size_t i = 0; i < index; ++i) {
      if (tokens_[i].kind == T::LEFT_BRACE) ++depth;
      if (tokens_[i].kind == T::RIGHT_BRACE && depth > 0) --depth;
    }
    return depth;
  }

  [[nodiscard]] std::size_t clause_begin(std::size_t index) const {
    std::size_t begin = index;
    while (begin > 0 && !ends_clause(tokens_[begin - 1].kind)) --begin;
    // the requirement text of a monitor ends without a `;`
    return begin < index && tokens_[begin].kind == T::STRING ? begin + 1 : begin;
  }

  // Replaces the clause around `index`, or the item whose head it is, by BAD_CLAUSE. False when
  // nothing is gained by it.
  bool drop_clause(std::size_t index) {
    const std::size_t begin = clause_begin(index);
    const TokenKind first = tokens_[begin].kind;
    const bool is_head = first == T::ROBOT || first == T::MONITOR || first == T::DECISION;
    const std::size_t end = clause_end(index, is_head);
    if (end == begin || (end == begin + 1 && first == T::BAD_CLAUSE)) return false;
    lose(begin, end);
    const bool is_item = brace_depth(begin) == 0;
    loss_.items = loss_.items || is_item;
    loss_.rest = loss_.rest || (is_item && names_file(begin, end));
    const SourceRange range = join_ranges(tokens_[begin].range, tokens_[end - 1].range);
    const Token bad{T::BAD_CLAUSE, range};
    const auto at = [&](std::size_t i) { return tokens_.begin() + static_cast<std::ptrdiff_t>(i); };
    tokens_.erase(at(begin), at(end));
    tokens_.insert(at(begin), bad);
    edited_at_.reset();
    return true;
  }

  // An import, what is one in other languages, `include "robots.rta";`, or what another sign stands
  // in front of.
  [[nodiscard]] bool names_file(std::size_t begin, std::size_t end) const {
    const TokenKind first = tokens_[begin].kind;
    const bool has_next = begin + 1 < end;
    return first == T::IMPORT || is_file_of_items(tokens_[begin]) ||
           (has_next && tokens_[begin + 1].kind == T::STRING);
  }

  // Behind the `;` or the block that ends the clause, in front of a `}` that closes a block around
  // it.
  [[nodiscard]] std::size_t clause_end(std::size_t index, bool is_head) const {
    int depth = 0;
    for (std::size_t i = index; i < tokens_.size(); ++i) {
      const TokenKind kind = tokens_[i].kind;
      if (kind == T::END) return i;
      if (kind == T::LEFT_BRACE) ++depth;
      if (kind == T::RIGHT_BRACE) {
        if (depth == 0) return is_head ? i + 1 : i;
        if (--depth == 0) return i + 1;
      }
      if (kind == T::SEMICOLON && depth == 0 && !is_head) return i + 1;
    }
    return tokens_.size() - 1;
  }

  void report_height(const Attempt& attempt) {
    if (!attempt.too_high) return;
    const std::string limit = std::to_string(kTreeHeightMax);
    diagnostics_.report(
        {diag::Code::nesting_too_deep,
         attempt.too_high,
         "an expression has more than " + limit + " levels of operators",
         "this part is too long",
         {},
         "put groups of a chain in brackets: `(a or b) or (c or d)` has two levels, "
         "`a or b or c or d` three; or give parts of it a name (`let`, `fun`, a "
         "zone)",
         {}});
  }

  std::vector<Token> tokens_;
  const SourceManager& sources_;
  diag::Engine& diagnostics_;
  std::optional<std::size_t> edited_at_;
  bool item_in_doubt_ = false;    // an earlier mistake may have ended its item too early
  bool rest_is_comment_ = false;  // what is missing may stand in a comment that was none
  Loss loss_;
  std::vector<SourceRange> silent_edits_;
};

}  // namespace

Attempt parse_with_repair(std::vector<Token> tokens, const SourceManager& sources,
                          diag::Engine& diagnostics) {
  return Repairer{std::move(tokens), sources, diagnostics}.run();
}

}  // namespace rtac::syntax
