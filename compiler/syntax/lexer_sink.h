// What the rules of lexer.ll call. Internal to the folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/diagnostics/engine.h"
#include "compiler/syntax/lexer.h"

namespace rtac::syntax {

class LexerSink {
 public:
  // `text`: of the whole file, which is read from `offset` on.
  LexerSink(FileId file, std::string_view text, std::size_t offset, diag::Engine& diagnostics);

  // Positions: every match first advances; `keep` gives all but its first bytes back.
  void advance(std::size_t length);
  void keep(std::size_t length) { end_ = begin_ + length; }
  void line_break() { at_line_start_ = true; }

  void punctuation(TokenKind kind) { push(kind); }
  [[nodiscard]] TokenKind relation_of_bound(TokenKind kind) const;
  void foreign_operator(TokenKind kind, std::string_view text);
  void word(std::string_view text);
  void number(std::string_view text);
  void moment(std::string_view text) { push(T::MOMENT, std::string{text}); }
  void malformed_number(std::string_view text);
  // False when the text is no unit: it starts with a word of the language.
  bool unit(std::string_view text);
  // A run with bytes beyond ASCII behind a number; returns how many bytes of it are a unit.
  std::size_t foreign_unit(std::string_view text);
  // A run with bytes beyond ASCII; returns how many bytes of it are used up.
  std::size_t foreign_run(std::string_view text);
  void string(std::string_view text);  // with its quotes
  // The rest of the line from a quote on; returns how many bytes of it are the text.
  std::size_t unterminated_string(std::string_view text);
  // Does a text that is open at the end of the match end on one of the next lines?
  [[nodiscard]] bool continues() const { return continues(end_); }
  void long_string_start() { string_begin_ = begin_; }
  void long_string_end();
  void foreign_quotes(std::string_view text, std::size_t quote_length);
  void hash_comment();
  void unknown();  // a run of them is one token; the parser reports it
  void comment_start() { comment_begin_ = begin_; }
  void unterminated_comment();
  void end_of_file();

  [[nodiscard]] bool stopped() const { return stopped_; }
  // Is the last token, a `[`, that of `: real [`, behind a type of quantities? What follows may be
  // a unit.
  [[nodiscard]] bool in_type() const;
  [[nodiscard]] bool before_result() const;
  std::vector<Token> take() { return std::move(tokens_); }

 private:
  void push(TokenKind kind, std::string text = {}, bool bad = false);
  void track_depth(TokenKind kind);
  void name_box();
  [[nodiscard]] std::string_view text_of(const Token& token) const {
    return text_.substr(token.range.begin, token.range.end - token.range.begin);
  }
  [[nodiscard]] SourceRange range() const { return range(begin_, end_); }
  [[nodiscard]] SourceRange range(std::size_t begin, std::size_t end) const;
  struct Mistake {
    diag::Code code;
    std::string message, label;
    std::string help = {};
    std::optional<std::string> replacement = std::nullopt;
  };
  void report(Mistake mistake) { report(std::move(mistake), range()); }
  void report(Mistake mistake, SourceRange range);
  void report_name(std::string_view text);
  bool foreign_include();
  struct TextMistake {
    SourceRange range;
    std::string message, label;
    std::vector<diag::FixIt> fixits;
  };
  void report_text(TextMistake mistake);
  static std::size_t text_length(std::string_view text);
  [[nodiscard]] bool continues(std::size_t line_end) const;
  [[nodiscard]] std::string other_bound(TokenKind kind) const;
  [[nodiscard]] bool before_number() const;
  [[nodiscard]] std::string set_apart(std::string word) const;
  std::string resolve_escapes(std::string_view inner);

  FileId file_;
  std::string_view text_;
  diag::Engine& diagnostics_;
  std::vector<Token> tokens_;
  std::size_t begin_ = 0, end_ = 0, comment_begin_ = 0, string_begin_ = 0;
  std::vector<std::size_t> opened_at_;                  // brackets that are open, by index
  std::size_t closed_at_ = 0;                           // the one that was closed last
  std::size_t real_at_ = static_cast<std::size_t>(-1);  // index of the last such word behind a `:`
  bool at_line_start_ = true;
  bool next_is_bad_ = false;  // a character before the next token was skipped
  bool stopped_ = false;
};

}  // namespace rtac::syntax
