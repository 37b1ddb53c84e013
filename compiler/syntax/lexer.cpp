#include "compiler/syntax/lexer.h"

#include <string_view>
#include <utility>

#include "compiler/diagnostics/characters.h"
#include "compiler/syntax/lexer_sink.h"

namespace rtac::syntax {

void scan(std::string_view text, LexerSink& sink);  // lexer.ll

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::size_t find_malformed(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const diag::Character c = diag::read_character(text.substr(at));
    if (c.bytes == 0 || c.code == 0) return at;
    at += c.bytes;
  }
  return std::string_view::npos;
}

// A line ends with LF or CR LF. An editor that takes a lone CR, or a separator, for the end of a
// line shows a clause where the compiler reads the rest of a comment.
bool is_line_end(std::string_view text) {
  return text.starts_with("\n") || text.starts_with("\r\n") || text.starts_with("\t");
}

// Characters that mislead a reader are refused in comments and texts too: a safety engineer who
// reads the page must read what is compiled. True when there is none.
bool report_hidden(FileId file, std::string_view text, diag::Engine& diagnostics) {
  bool clean = true, ends_lines = false;
  for (std::size_t at = 0; at < text.size() && diagnostics.error_count() <= kErrorsMax;) {
    const diag::Character c = diag::read_character(text.substr(at));
    const diag::Look look = diag::look_of(c.code);
    const bool reorders = look == diag::Look::reorder;
    if (reorders || (look == diag::Look::control && !is_line_end(text.substr(at)))) {
      const auto begin = static_cast<std::uint32_t>(at);
      const SourceRange range{file, begin, static_cast<std::uint32_t>(at + c.bytes)};
      diag::Diagnostic found{diag::Code::hidden_character, range, {}, {}, {}, {}, {}};
      found.message = reorders ? diag::code_point(c.code) +
                                     " makes the text appear in another order than it has"
                               : "the control character " + diag::code_point(c.code) +
                                     " is not allowed in a specification";
      found.label = "not to be seen in an editor";
      if (c.code == '\r') {
        found.help = "end lines with LF or CR LF";
      } else {
        found.fixits.push_back({range, ""});
      }
      // a file that ends its lines with CR has one mistake, not one a line
      if (c.code != '\r' || !std::exchange(ends_lines, true)) diagnostics.report(std::move(found));
      clean = false;
    }
    at += c.bytes;
  }
  return clean;
}

void report_not_text(FileId file, std::size_t at, bool is_nul, diag::Engine& diagnostics) {
  const auto offset = static_cast<std::uint32_t>(at);
  diagnostics.report({diag::Code::file_not_text,
                      SourceRange{file, offset, offset + 1},
                      "the file is not UTF-8 text",
                      is_nul ? "a zero byte" : "this byte is no part of a UTF-8 character",
                      {},
                      "save the file as UTF-8 text",
                      {}});
}

}  // namespace

std::vector<Token> tokenize(FileId file, const SourceManager& sources, diag::Engine& diagnostics) {
  const std::string_view text = sources.text(file);
  const auto end = static_cast<std::uint32_t>(text.size());
  const Token bad_end{T::END, {file, end, end}, {}, true, true};
  const std::size_t malformed = find_malformed(text);
  if (malformed != std::string_view::npos) {
    report_not_text(file, malformed, text[malformed] == '\0', diagnostics);
    return {bad_end};
  }
  if (!report_hidden(file, text, diagnostics)) return {bad_end};
  const std::size_t skipped = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  LexerSink sink{file, text, skipped, diagnostics};
  scan(text.substr(skipped), sink);
  std::vector<Token> tokens = sink.take();
  if (tokens.empty() || tokens.back().kind != T::END) tokens.push_back(bad_end);
  return tokens;
}

}  // namespace rtac::syntax
